//! The dialog that opens calibration files.

use super::found::{FileUnit, Shown};
use super::{Import, State};
use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::dialog::{DialogFrame, close_button_ui};
use crate::app::rigs::{MOST, Rig, number};
use crate::app::theme;
use crate::app::widgets::field::Field;
use crate::app::widgets::menu::List;
use crate::app::widgets::table::{self, Cell};
use crate::app::widgets::{main_button, scroll, text, text_menu};
use depth_text::field::Key;
use depth_text::fields;
use depth_text::names::Named as _;
use depth_text::note::Severity;
use depth_text::reading;
use egui::accesskit::Role;
use egui::text::LayoutJob;
use egui::{Button, Id, Response, RichText, TextEdit, Ui, vec2};

const TITLE: &str = "Calibration files";
const LEAD: &str = "What a calibration wrote: of OpenCV, ROS, Kalibr, KITTI, Middlebury, EuRoC, COLMAP, ORB-SLAM, ZED, RealSense and others; \
                    or a photograph (JPEG), whose EXIF says the lens. They are recognized by what is in them, whatever they are called, and stay on \
                    this computer.";

/// Draws it over the screen.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, import: &mut Import) {
    let frame = DialogFrame {
        id: "import",
        title: TITLE,
        max_width: theme::IMPORT_WIDTH,
    };
    let close = Command::CloseImport;
    let response = frame.ui(ui, |ui| {
        ui.spacing_mut().interact_size.y = cx.layout.control_height();
        ui.add_space(theme::STEP);
        let height = ui.ctx().content_rect().height() - theme::IMPORT_FRAME_HEIGHT;
        let names = import.names();
        scroll::up_to_ui(ui, height, |ui| {
            if let Some(why) = &import.obstacle {
                error_ui(ui, why);
            }
            let first = match &mut import.state {
                State::Asking => Some(asking_ui(ui, cx, &mut import.text)),
                State::Reading(_) => reading_ui(ui, &names),
                State::Failed(why) => Some(failed_ui(ui, cx, &names, why)),
                State::Found(shown) => Some(found_ui(ui, cx, &names, shown)),
            };
            // As if another dialog had opened.
            if let Some(first) = first.filter(|_| std::mem::take(&mut import.is_new)) {
                first.request_focus();
            }
        });
        ui.add_space(2.0 * theme::STEP);
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(2.0 * theme::STEP, 2.0 * theme::STEP);
            if matches!(import.state, State::Found(_)) {
                take_ui(ui, cx, import.rig());
            }
            close_button_ui(ui, "Cancel", cx.layout)
        })
        .inner
    });
    if response.inner || response.should_close() {
        cx.commands.push(close);
    }
}

fn button_ui(ui: &mut Ui, cx: &mut AppContext<'_>, (command, words): (Command, &str)) -> Response {
    let button = Button::new(words).min_size(vec2(0.0, cx.layout.control_height()));
    let response = ui.add(button);
    if response.clicked() {
        cx.commands.push(command);
    }
    response
}

/// Returns the first control, as its siblings do.
fn asking_ui(ui: &mut Ui, cx: &mut AppContext<'_>, typed: &mut String) -> Response {
    text::paragraph_ui(ui, LEAD);
    ui.add_space(theme::STEP);
    let first = button_ui(ui, cx, (Command::OpenFiles, Command::OpenFiles.text()));
    text::caption_ui(ui, "Or drop them anywhere on this window.");
    ui.add_space(2.0 * theme::STEP);
    let palette = theme::palette(ui);
    let label = ui.label(
        RichText::new("Or paste the text of one")
            .font(theme::strong(theme::BODY_SIZE))
            .color(palette.text),
    );
    let pasted = ui.add(
        TextEdit::multiline(typed)
            .id(Id::unique("text of a calibration file"))
            .desired_rows(4)
            .desired_width(ui.available_width())
            .hint_text(RichText::new("%YAML:1.0\n---\nM1: !!opencv-matrix …").color(palette.muted)),
    );
    let pasted = pasted.labelled_by(label.id);
    text_menu::ui(&pasted, typed, cx.commands);
    ui.add_space(theme::STEP);
    let button = Button::new("Read the text").min_size(vec2(0.0, cx.layout.control_height()));
    if ui.add_enabled(!typed.trim().is_empty(), button).clicked() {
        cx.commands.push(Command::ReadText(typed.clone()));
    }
    first
}

fn reading_ui(ui: &mut Ui, names: &[String]) -> Option<Response> {
    let said = ui.label(format!("Reading {}…", names.join(", ")));
    text::announce(ui, &said);
    None
}

fn error_ui(ui: &mut Ui, why: &str) {
    let said = ui.label(RichText::new(text::note(why)).color(text::note_color(ui, Severity::Error)));
    text::announce(ui, &said);
    ui.add_space(theme::STEP);
}

fn failed_ui(ui: &mut Ui, cx: &mut AppContext<'_>, names: &[String], why: &str) -> Response {
    let palette = theme::palette(ui);
    if !names.is_empty() {
        ui.label(
            RichText::new(names.join(", "))
                .font(theme::strong(theme::BODY_SIZE))
                .color(palette.text),
        );
    }
    error_ui(ui, why);
    text::caption_ui(ui, "Nothing was changed.");
    ui.add_space(theme::STEP);
    let row = ui.horizontal_wrapped(|ui| {
        let first = button_ui(ui, cx, (Command::OpenFiles, "Open other files…"));
        if !names.is_empty() {
            button_ui(ui, cx, (Command::AddFiles, Command::AddFiles.text()));
        }
        button_ui(ui, cx, (Command::ShowImport, "Start over"));
        first
    });
    row.inner
}

fn found_ui(ui: &mut Ui, cx: &mut AppContext<'_>, names: &[String], shown: &mut Shown) -> Response {
    let palette = theme::palette(ui);
    let said = ui.label(
        RichText::new(format!("{}: {}", names.join(", "), shown.found.format))
            .font(theme::strong(theme::BODY_SIZE))
            .color(palette.text),
    );
    text::announce(ui, &said);
    for warning in shown.chosen().map(|choice| choice.warnings.as_slice()).unwrap_or_default() {
        let color = text::note_color(ui, Severity::Warning);
        let said = ui.label(RichText::new(text::note(warning)).size(theme::SMALL_SIZE).color(color));
        text::announce(ui, &said);
    }
    ui.add_space(theme::STEP);
    let cameras = choices_ui(ui, shown);
    numbers_ui(ui, shown);
    let unit = unit_ui(ui, cx, shown);
    changes_ui(ui, cx, shown.rig(names));
    let more = ui.horizontal_wrapped(|ui| button_ui(ui, cx, (Command::AddFiles, Command::AddFiles.text())));
    if !shown.found.ignored.is_empty() {
        ui.add_space(theme::STEP);
        text::caption_ui(ui, format!("Not read: {}", shown.found.ignored.join("; ")));
    }
    cameras.or(unit).unwrap_or(more.inner)
}

/// The choice among several cameras and pairs.
fn choices_ui(ui: &mut Ui, shown: &mut Shown) -> Option<Response> {
    if shown.found.choices.len() < 2 {
        return None;
    }
    let name = |choice: &depth_jobs::Choice| {
        let size = choice.camera.size;
        let size = size.map_or_else(String::new, |[width, height]| format!(", {width} × {height} px"));
        format!("{}{size}", choice.name)
    };
    let names: Vec<String> = shown.found.choices.iter().map(name).collect();
    let list = List {
        name: "Camera or pair",
        shown: names.get(shown.choice).map_or("", String::as_str),
        width: ui.available_width(),
        names: &names,
        chosen: Some(shown.choice),
    };
    let (response, now) = list.ui(ui, "camera or pair of the file");
    if let Some(now) = now.filter(|now| *now != shown.choice) {
        shown.choose(now);
    }
    ui.add_space(theme::STEP);
    Some(response)
}

/// What the files say: each number with where it stands.
fn numbers_ui(ui: &mut Ui, shown: &Shown) {
    let Some(choice) = shown.chosen() else { return };
    let camera = &choice.camera;
    let mut rows: Vec<(&str, String, &str)> = Vec::new();
    if let Some([width, height]) = camera.size {
        rows.push(("Images", format!("{width} × {height} px"), camera.origin.as_str()));
    }
    let of = if camera.is_rectified {
        "of rectified images"
    } else {
        "of raw images"
    };
    let [fx, fy, cx, cy] = camera.intrinsics_px.map(number);
    let sigma = camera
        .sigma_px
        .map(|sigma| sigma.map(|one| format!(" ± {}", number(one))))
        .unwrap_or_default();
    rows.push((
        "Focal length fx, fy",
        format!("{fx}{}, {fy}{} px, {of}", sigma[0], sigma[1]),
        camera.origin.as_str(),
    ));
    rows.push((
        "Principal point cx, cy",
        format!("{cx}{}, {cy}{} px", sigma[2], sigma[3]),
        camera.origin.as_str(),
    ));
    if !camera.distortion.is_empty() || camera.model.is_some() {
        let numbers: Vec<String> = camera.distortion.iter().map(|one| number(*one)).collect();
        rows.push((
            "Distortion",
            [camera.model.clone().unwrap_or_default(), numbers.join(", ")]
                .join(" ")
                .trim()
                .to_owned(),
            "",
        ));
    }
    match shown.baseline() {
        Some(depth_jobs::Baseline::Meters(m)) => {
            rows.push(("Baseline", format!("{} mm", number(m * 1000.0)), choice.baseline_origin.as_str()))
        }
        Some(depth_jobs::Baseline::InFileUnits { value, .. }) => {
            rows.push((
                "Baseline",
                format!("{}, in a unit that the file does not say", number(value)),
                choice.baseline_origin.as_str(),
            ));
        }
        None => rows.push(("Baseline", "none".to_owned(), "")),
    }
    if let Some(doffs) = choice.doffs_px {
        rows.push(("doffs", format!("{} px", number(doffs)), choice.doffs_origin.as_str()));
    }
    rows_ui(ui, "What the file says", ["Quantity", "Value", "Where it stands"], &rows);
}

fn rows_ui(ui: &mut Ui, name: &str, headers: [&str; 3], rows: &[(&str, String, &str)]) {
    let palette = theme::palette(ui);
    let shares = theme::IMPORT_SHARES;
    let cell = |words: &str, role: Role| {
        let (font, color) = match role {
            Role::Cell => (theme::regular(theme::SMALL_SIZE), palette.text),
            _ => (theme::strong(theme::SMALL_SIZE), palette.muted),
        };
        Cell {
            text: LayoutJob::simple(words.to_owned(), font, color, 0.0),
            role,
            align_right: false,
        }
    };
    table::table_ui(ui, name, |ui| {
        table::row_ui(ui, headers.iter().map(|words| cell(words, Role::ColumnHeader)).collect(), &shares);
        for (name, value, origin) in rows {
            let cells = vec![cell(name, Role::RowHeader), cell(value, Role::Cell), cell(origin, Role::Cell)];
            table::row_ui(ui, cells, &shares);
        }
    });
    ui.add_space(theme::STEP);
}

/// Asks for the unit of the baseline, where the file does not say it.
fn unit_ui(ui: &mut Ui, cx: &mut AppContext<'_>, shown: &mut Shown) -> Option<Response> {
    let value = number(shown.asks_unit_of()?);
    let names: Vec<String> = shown.units().into_iter().map(|unit| unit.offer(&value)).collect();
    text::caption_ui(
        ui,
        "The file does not say the unit of the baseline: it is the one in which the squares of the board were measured, or that of whoever wrote the file. Which is it?",
    );
    let list = List {
        name: "The baseline is",
        shown: shown.unit.and_then(|at| names.get(at)).map_or("Choose the unit…", String::as_str),
        width: ui.available_width(),
        names: &names,
        chosen: shown.unit,
    };
    let (response, now) = list.ui(ui, "unit of the file");
    shown.unit = now.or(shown.unit);
    ui.add_space(theme::STEP);
    if shown.chosen_unit() == Some(FileUnit::Squares) {
        let key = fields::SQUARE_SIZE;
        let read = reading::read(key, &shown.square);
        Field {
            key,
            reading: read.as_ref().ok().and_then(Option::as_ref),
            notes: read.as_ref().err().into_iter().collect(),
            entry: &mut shown.square,
            with_sigma: false,
            helper: None,
            id: Id::unique("square of the board of a file"),
            submits: false,
            following: None,
        }
        .ui(ui, cx.commands);
    }
    Some(response)
}

/// What would become of the fields of the calculator.
fn changes_ui(ui: &mut Ui, cx: &AppContext<'_>, rig: Option<Rig>) {
    let Some(rig) = rig else { return };
    let before = &cx.session.inputs;
    let after = rig.used_in(before);
    let written = |key: Key, inputs: &depth_text::form::Inputs| {
        let entry = inputs.entry(key);
        if entry.is_blank() {
            return "nothing".to_owned();
        }
        let chosen = entry.unit.map(crate::core::quantity::LengthUnit::symbol);
        // Squares of a board stand in the text, with the unit of their size.
        let unit = if entry.text.contains(char::is_alphabetic) {
            ""
        } else {
            chosen.unwrap_or_else(|| key.unit_symbol())
        };
        let sigma = if entry.sigma.is_empty() {
            String::new()
        } else {
            format!(" ± {}", entry.sigma)
        };
        format!("{}{sigma} {unit}", entry.text).trim_end().to_owned()
    };
    let mut changes: Vec<String> = Rig::shared()
        .map(|key| (key, written(key, before), written(key, &after)))
        .filter(|(_, before, after)| before != after)
        .map(|(key, before, after)| format!("{}: {before} → {after}", key.symbol))
        .collect();
    if before.pair != after.pair {
        changes.push(format!("cameras: {}", after.pair.name().to_ascii_lowercase()));
    }
    let words = if changes.is_empty() {
        "In the calculator nothing would change.".to_owned()
    } else {
        format!("In the calculator would change: {}.", changes.join("; "))
    };
    text::caption_ui(ui, words);
    ui.add_space(theme::STEP);
}

/// The buttons that take what was found.
fn take_ui(ui: &mut Ui, cx: &mut AppContext<'_>, rig: Option<Rig>) {
    let has_room = cx.settings.rigs.has_room();
    let is_known = rig.is_some();
    let rig = rig.unwrap_or_default();
    let use_it = Command::UseCalibration(Box::new(rig.clone()));
    if main_button::ui(ui, use_it.text(), is_known) {
        cx.commands.push(use_it);
    }
    let keep = Command::AddRig(Box::new(rig));
    let button = Button::new("Add to rigs").min_size(vec2(0.0, cx.layout.control_height()));
    if ui.add_enabled(is_known && has_room, button).clicked() {
        cx.commands.push(keep);
    }
    if !has_room {
        text::caption_ui(ui, format!("There are {MOST} rigs already: it can be used, but not kept."));
    }
}
