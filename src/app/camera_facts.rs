//! What a data sheet, a photographer or a simulator states of a camera, and everything that follows from it.

use super::command::Command;
use super::context::AppContext;
use super::dialog::{Destination, DialogFrame, close_button_ui};
use super::rigs::{Rig, number};
use super::theme;
use super::widgets::field::{self, Field};
use super::widgets::menu::List;
use super::widgets::{choice, common, main_button, pairs, scroll, text};
use crate::core::camera::Projection;
use crate::core::quantity::LengthUnit;
use depth_text::camera_sheet::{CameraSheet, SolvedSheet};
use depth_text::entry::Entry;
use depth_text::field::Key;
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::names::Named;
use depth_text::note::Severity;
use depth_text::number::plain;
use depth_text::sentences::capital;
use egui::{Button, Galley, Id, Sense, Ui, UiBuilder, vec2};
use std::sync::Arc;

const LEAD: &str = "Type what is known: what follows stands in gray. Unity states the vertical view; Unreal, CARLA and AirSim the horizontal one; \
                    Gazebo too, as 1.047 rad. Of Blender and Isaac Sim take the lens and the width of the sensor, which is the aperture.";

/// The dialog between frames.
#[derive(Debug, Default)]
pub struct CameraFacts {
    /// What is stated of the camera of a rig; that of the calculator is among the settings.
    of_rig: CameraSheet,
    /// What was typed, and what it means.
    solved: Option<(CameraSheet, SolvedSheet)>,
}

/// Where the camera is.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Medium {
    Air,
    Water,
}

impl Named for Medium {
    fn name(self) -> &'static str {
        match self {
            Self::Air => "In air",
            Self::Water => "Under water",
        }
    }
}

impl CameraFacts {
    /// Draws the dialog. What follows goes to `destination`.
    pub fn ui(&mut self, ui: &mut Ui, cx: &mut AppContext<'_>, destination: Destination) {
        let frame = DialogFrame {
            id: "camera facts",
            title: "Camera facts",
            max_width: theme::CAMERA_WIDTH,
        };
        let close = Command::ShowDialog(None);
        // Lent to the dialog while it is drawn.
        let mut sheet = std::mem::take(match destination {
            Destination::Calculator => &mut cx.settings.sheet,
            Destination::Rig => &mut self.of_rig,
        });
        let solved = self.refresh(&sheet).clone();
        let solved = &solved;
        let response = frame.ui(ui, |ui| {
            ui.spacing_mut().interact_size.y = cx.layout.control_height();
            let said = said(ui, solved);
            let room = ui.ctx().content_rect().height() - theme::CAMERA_FRAME_HEIGHT;
            let said_height = said.iter().map(|one| one.size().y).sum::<f32>();
            // In sight whatever is scrolled, where that leaves room for the fields.
            let is_fixed = said_height < room / 3.0;
            let height = if is_fixed { room - said_height } else { room };
            scroll::up_to_ui(ui, height, |ui| {
                text::paragraph_ui(ui, LEAD);
                sheet_ui(ui, cx, &mut sheet, solved);
                if !is_fixed {
                    said_ui(ui, &said);
                }
            });
            ui.add_space(2.0 * theme::STEP);
            if is_fixed {
                said_ui(ui, &said);
            }
            ui.horizontal_wrapped(|ui| {
                ui.spacing_mut().item_spacing = vec2(2.0 * theme::STEP, 2.0 * theme::STEP);
                use_ui(ui, cx, (&sheet, solved), destination);
                let clear = Button::new("Clear").min_size(vec2(0.0, cx.layout.control_height()));
                if ui.add(clear).clicked() {
                    sheet = CameraSheet::default();
                }
                close_button_ui(ui, "Close", cx.layout)
            })
            .inner
        });
        if response.inner || response.should_close() {
            cx.commands.push(close);
        }
        match destination {
            Destination::Calculator => cx.settings.sheet = sheet,
            Destination::Rig => self.of_rig = sheet,
        }
    }

    /// Opens it for the rig with these inputs, or without one.
    pub fn open_for_rig(&mut self, inputs: Option<&Inputs>) {
        self.of_rig = CameraSheet::default();
        let Some(inputs) = inputs else { return };
        for (from, to) in [
            (fields::FRAME_WIDTH, fields::FRAME_WIDTH),
            (fields::FRAME_HEIGHT, fields::FRAME_HEIGHT),
            (fields::FOCAL_LENGTH, fields::CAMERA_FX),
            (fields::FY, fields::CAMERA_FY),
        ] {
            self.of_rig.entries.fill(to, inputs.entry(from).clone());
        }
    }

    fn refresh(&mut self, sheet: &CameraSheet) -> &SolvedSheet {
        if self.solved.as_ref().is_some_and(|(known, _)| known != sheet) {
            self.solved = None;
        }
        let (_, solved) = self.solved.get_or_insert_with(|| (sheet.clone(), sheet.solve()));
        solved
    }
}

/// What is to be said of the facts together, laid out over the width of the dialog.
fn said(ui: &Ui, solved: &SolvedSheet) -> Vec<Arc<Galley>> {
    let lay_out = |(severity, sentence): &(Severity, String)| {
        let (font, color) = (theme::regular(theme::SMALL_SIZE), text::note_color(ui, *severity));
        ui.painter().layout(text::note(sentence), font, color, ui.available_width())
    };
    solved.said.iter().map(lay_out).collect()
}

fn said_ui(ui: &mut Ui, said: &[Arc<Galley>]) {
    for one in said {
        let said = ui.label(one.clone());
        text::announce(ui, &said);
    }
}

/// The fields, and how the lens sees.
fn sheet_ui(ui: &mut Ui, cx: &mut AppContext<'_>, sheet: &mut CameraSheet, solved: &SolvedSheet) {
    let mut commands = Vec::new();
    for (heading, keys) in CameraSheet::GROUPS {
        ui.add_space(2.0 * theme::STEP);
        let color = theme::palette(ui).muted;
        text::heading_ui(ui, heading, 3, theme::strong(theme::SMALL_SIZE), color);
        pairs::ui(ui, keys, |ui, key| field_ui(ui, sheet, solved, (key, &mut commands)));
        if keys.contains(&fields::SENSOR_WIDTH)
            && let Some(format) = common::sensor_formats_ui(ui)
        {
            for (key, side) in [(fields::SENSOR_WIDTH, format.width_mm), (fields::SENSOR_HEIGHT, format.height_mm)] {
                sheet.entries.fill(key, Entry::new(plain(side), Some(LengthUnit::Millimeter)));
            }
        }
    }
    ui.add_space(theme::STEP);
    let names = Projection::ALL.map(|projection| match projection {
        Projection::Pinhole => "Pinhole, as most lenses".to_owned(),
        fisheye => format!("Fisheye, {}", fisheye.name()),
    });
    let chosen = Projection::ALL.iter().position(|one| *one == sheet.projection());
    let list = List {
        name: "How the lens projects",
        shown: chosen.and_then(|at| names.get(at)).map_or("", String::as_str),
        width: ui.available_width(),
        names: &names,
        chosen,
    };
    let (_, now) = list.ui(ui, "how the lens projects");
    if let Some(projection) = now.and_then(|at| Projection::ALL.get(at)) {
        projection.name().clone_into(&mut sheet.projection);
    }
    let height = ui.spacing().interact_size.y.max(theme::CHOICE_HEIGHT);
    let (line, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let mut medium = if sheet.is_under_water { Medium::Water } else { Medium::Air };
    if choice::ui(ui, line, "Where the camera is", &[Medium::Air, Medium::Water], &mut medium) {
        sheet.is_under_water = medium == Medium::Water;
    }
    for command in commands {
        match command {
            // What a note offers is of this sheet.
            Command::Fix(key, entry) => {
                sheet.entries.fill(key, entry);
                sheet.entries.entry_mut(key).tidy(key);
                ui.memory_mut(|memory| memory.request_focus(field::id(key)));
            }
            Command::Calculate | Command::Settle => {}
            other => cx.commands.push(other),
        }
    }
}

fn field_ui(ui: &mut Ui, sheet: &mut CameraSheet, solved: &SolvedSheet, (key, commands): (Key, &mut Vec<Command>)) {
    let following = solved.following(key).unwrap_or_default();
    let field = Field {
        key,
        reading: solved.reading(key),
        notes: solved.notes.iter().filter(|note| note.key == key).collect(),
        with_sigma: false,
        helper: None,
        id: field::id(key),
        submits: false,
        following: Some(&following),
        entry: sheet.entries.entry_mut(key),
    };
    let builder = UiBuilder::new().scope_id(Id::unique(("part of a camera", key.as_str())));
    ui.scope_builder(builder, |ui| field.ui(ui, commands));
}

/// The button that takes the focal length.
fn use_ui(ui: &mut Ui, cx: &mut AppContext<'_>, (sheet, solved): (&CameraSheet, &SolvedSheet), destination: Destination) {
    let label = solved.answer.as_ref().map_or_else(
        || "Use as fx".to_owned(),
        |answer| format!("Use fx = {} px", depth_text::number::significant(answer.fx.px(), 6)),
    );
    if !main_button::ui(ui, &label, solved.answer.is_some()) {
        return;
    }
    let filled = filled(solved);
    // Before what opens a notice.
    cx.commands.push(Command::ShowDialog(None));
    match destination {
        Destination::Calculator => cx.commands.push(Command::FillIn(filled)),
        Destination::Rig => {
            let size = [fields::FRAME_WIDTH, fields::FRAME_HEIGHT].map(|key| (key, sheet.entries.entry(key).clone()));
            let rig = cx
                .settings
                .rigs
                .shown()
                .map(|rig| changed(rig, size.into_iter().chain(filled), &solved.stated()));
            let at = cx.settings.rigs.shown;
            cx.commands.extend(rig.map(|rig| Command::ChangeRig(at, Box::new(rig))));
        }
    }
}

/// What goes into the form: fx, fy where it is another, and the lens where nothing else said fx.
fn filled(solved: &SolvedSheet) -> Vec<(Key, Entry)> {
    let Some(answer) = &solved.answer else { return Vec::new() };
    let px = |value: f64| Entry::new(number(value), None);
    let is_square = number(answer.fy.px()) == number(answer.fx.px());
    let fy = if is_square { Entry::default() } else { px(answer.fy.px()) };
    let lens = answer.lens.filter(|_| solved.is_of_lens());
    let lens = lens.map(|lens| Entry::new(number(lens.m() * 1000.0), Some(LengthUnit::Millimeter)));
    let filled = [(fields::FOCAL_LENGTH, px(answer.fx.px())), (fields::FY, fy)];
    filled.into_iter().chain(lens.map(|lens| (fields::FX_LENS, lens))).collect()
}

/// `rig` with what was `filled` in place of what it had, and with where that is from.
fn changed(rig: &Rig, filled: impl Iterator<Item = (Key, Entry)>, stated: &str) -> Rig {
    let mut rig = rig.clone();
    for (key, entry) in filled.filter(|(key, _)| Rig::KEYS.contains(key)) {
        *rig.inputs.entry_mut(key) = entry;
    }
    rig.source = if rig.source.trim().is_empty() {
        capital(stated)
    } else {
        format!("{}; fx from: {stated}", rig.source.trim())
    };
    rig
}
