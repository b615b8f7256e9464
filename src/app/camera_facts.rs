//! What a data sheet, a photographer or a simulator states of a camera, and everything that follows from it.

use super::command::Command;
use super::context::AppContext;
use super::dialog::{Destination, DialogFrame, close_button_ui};
use super::rigs::{Rig, number};
use super::theme;
use super::widgets::field::Field;
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

/// What was typed, and what it means.
#[derive(Debug, Default)]
pub struct CameraFacts {
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
        let solved = self.refresh(&cx.settings.sheet);
        let response = frame.ui(ui, |ui| {
            ui.spacing_mut().interact_size.y = cx.layout.control_height();
            let said = said(ui, solved);
            let height = ui.ctx().content_rect().height() - theme::CAMERA_FRAME_HEIGHT - said.iter().map(|one| one.size().y).sum::<f32>();
            scroll::up_to_ui(ui, height, |ui| {
                text::paragraph_ui(ui, LEAD);
                sheet_ui(ui, cx, solved);
            });
            ui.add_space(2.0 * theme::STEP);
            // In sight whatever is scrolled.
            for one in said {
                let said = ui.label(one);
                text::announce(ui, &said);
            }
            ui.horizontal_wrapped(|ui| {
                ui.spacing_mut().item_spacing = vec2(2.0 * theme::STEP, 2.0 * theme::STEP);
                use_ui(ui, cx, solved, destination);
                let clear = Button::new("Clear").min_size(vec2(0.0, cx.layout.control_height()));
                if ui.add(clear).clicked() {
                    cx.settings.sheet = CameraSheet::default();
                }
                close_button_ui(ui, "Close", cx.layout)
            })
            .inner
        });
        if response.inner || response.should_close() {
            cx.commands.push(close);
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

/// The fields, and how the lens sees.
fn sheet_ui(ui: &mut Ui, cx: &mut AppContext<'_>, solved: &SolvedSheet) {
    let mut commands = Vec::new();
    let sheet = &mut cx.settings.sheet;
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
    let list = List {
        name: "How the lens projects",
        shown: names.get(sheet.projection).map_or("", String::as_str),
        width: ui.available_width(),
        names: &names,
        chosen: Some(sheet.projection),
    };
    let (_, now) = list.ui(ui, "how the lens projects");
    sheet.projection = now.unwrap_or(sheet.projection);
    let height = ui.spacing().interact_size.y.max(theme::CHOICE_HEIGHT);
    let (line, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let mut medium = if sheet.is_under_water { Medium::Water } else { Medium::Air };
    if choice::ui(ui, line, "Where the camera is", &[Medium::Air, Medium::Water], &mut medium) {
        sheet.is_under_water = medium == Medium::Water;
    }
    for command in commands {
        match command {
            // What a note offers is of this sheet.
            Command::Fix(key, entry) => sheet.entries.fill(key, entry),
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
        id: Id::unique(("camera fact", key.as_str())),
        submits: false,
        following: Some(&following),
        entry: sheet.entries.entry_mut(key),
    };
    let builder = UiBuilder::new().scope_id(Id::unique(("part of a camera", key.as_str())));
    ui.scope_builder(builder, |ui| field.ui(ui, commands));
}

/// The button that takes the focal length.
fn use_ui(ui: &mut Ui, cx: &mut AppContext<'_>, solved: &SolvedSheet, destination: Destination) {
    let label = solved.answer.as_ref().map_or_else(
        || "Use as fx".to_owned(),
        |answer| format!("Use fx = {} px", depth_text::number::significant(answer.fx.px(), 6)),
    );
    if !main_button::ui(ui, &label, solved.answer.is_some()) {
        return;
    }
    let filled = filled(solved);
    match destination {
        Destination::Calculator => cx.commands.push(Command::FillIn(filled)),
        Destination::Rig => {
            let sheet = &cx.settings.sheet;
            let size = [fields::FRAME_WIDTH, fields::FRAME_HEIGHT].map(|key| (key, sheet.entries.entry(key).clone()));
            let source = capital(&solved.stated());
            if let Some(rig) = cx.settings.rigs.shown_mut() {
                take(rig, size.into_iter().chain(filled), &source);
            }
        }
    }
    cx.commands.push(Command::ShowDialog(None));
}

/// What goes into the form: fx, fy where it is another, and the lens where nothing else said fx.
fn filled(solved: &SolvedSheet) -> Vec<(Key, Entry)> {
    let Some(answer) = &solved.answer else { return Vec::new() };
    let px = |key: Key, value: f64| (key, Entry::new(number(value), None));
    let mut filled = vec![px(fields::FOCAL_LENGTH, answer.fx.px())];
    if number(answer.fy.px()) != number(answer.fx.px()) {
        filled.push(px(fields::FY, answer.fy.px()));
    }
    if let Some(lens) = answer.lens.filter(|_| solved.is_of_lens()) {
        filled.push((fields::FX_LENS, Entry::new(number(lens.m() * 1000.0), Some(LengthUnit::Millimeter))));
    }
    filled
}

/// Fills `filled` into `rig`, with where it is from.
fn take(rig: &mut Rig, filled: impl Iterator<Item = (Key, Entry)>, source: &str) {
    rig.inputs.entries.remove(fields::FY);
    for (key, entry) in filled.filter(|(key, _)| Rig::KEYS.contains(key)) {
        rig.inputs.fill(key, entry);
    }
    if rig.source.trim().is_empty() {
        source.clone_into(&mut rig.source);
    }
}

/// The sheet that the dialog opens with: of the rig that is shown, or what was typed last.
pub fn opened(destination: Destination, sheet: &CameraSheet, inputs: Option<&Inputs>) -> CameraSheet {
    let mut opened = match destination {
        Destination::Rig => CameraSheet::default(),
        Destination::Calculator => sheet.clone(),
    };
    let of_rig = [
        (fields::FRAME_WIDTH, fields::FRAME_WIDTH),
        (fields::FRAME_HEIGHT, fields::FRAME_HEIGHT),
        (fields::FOCAL_LENGTH, fields::CAMERA_FX),
        (fields::FY, fields::CAMERA_FY),
    ];
    if let (Destination::Rig, Some(inputs)) = (destination, inputs) {
        for (from, to) in of_rig {
            opened.entries.fill(to, inputs.entry(from).clone());
        }
    }
    opened
}
