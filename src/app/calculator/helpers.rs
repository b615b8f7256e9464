//! Where numbers come from: a focal length from a lens, a field of view or a photograph; a disparity from what a program
//! stored; everything from a Q matrix.
//!
//! What the ways ask for and compute is the table in [`ways`].

use crate::app::command::Command;
use crate::app::saved::{Settings, Ways};
use crate::app::theme::{self, Layout};
use crate::app::widgets::number_field::{NumberField, Unit};
use crate::app::widgets::{scroll, text};
use crate::core::camera::SENSOR_FORMATS;
use crate::core::problem::Field;
use crate::core::quantity::LengthUnit;
use crate::formats::entry::Entries;
use crate::formats::fields;
use crate::formats::inputs::{Entry, Inputs, Severity};
use crate::formats::note::Issue;
use crate::formats::number::{self, plain, significant};
use crate::formats::q_matrix;
use crate::formats::ways::{self, Way};
use egui::{Button, ComboBox, Modal, RichText, Stroke, TextEdit, Ui, vec2};

/// A helper.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Helper {
    /// Where a focal length comes from.
    FocalLength,
    /// What a program calls a disparity, and doffs.
    Disparity,
}

impl Helper {
    /// The helper that is offered at `field`, and what its link says.
    pub const fn at(field: Field) -> Option<(Self, &'static str)> {
        match field {
            Field::FocalLength => Some((Self::FocalLength, "from lens, FOV or Q…")),
            Field::Disparity => Some((Self::Disparity, "OpenCV ×16, doffs…")),
            _ => None,
        }
    }

    const fn title(self) -> &'static str {
        match self {
            Self::FocalLength => "Where does the focal length come from?",
            Self::Disparity => "What is known of the disparity?",
        }
    }

    /// Its name in what is stored.
    const fn key(self) -> &'static str {
        match self {
            Self::FocalLength => "fx",
            Self::Disparity => "d",
        }
    }

    const fn ways(self) -> &'static [Way] {
        match self {
            Self::FocalLength => ways::FOCAL_LENGTHS,
            Self::Disparity => ways::DISPARITIES,
        }
    }
}

/// The choice of Q matrix stands beside the ways to a focal length.
const Q_MATRIX: &str = "A Q matrix of stereoRectify";

/// Draws the helper over the screen.
pub fn show(ui: &Ui, layout: Layout, helper: Helper, inputs: &Inputs, settings: &mut Settings, commands: &mut Vec<Command>) {
    let palette = theme::palette(ui);
    let height = layout.control_height();
    let response = Modal::new(egui::Id::unique("helper"))
        .frame(theme::card(palette))
        .show(ui.ctx(), |ui| {
            ui.set_width((ui.ctx().content_rect().width() - 72.0).min(440.0));
            ui.spacing_mut().interact_size.y = height;
            text::heading(ui, helper.title(), 2, theme::strong(17.0), palette.text);
            ui.add_space(2.0 * theme::STEP);
            scroll::up_to(ui, ui.ctx().content_rect().height() - 180.0, |ui| {
                let way = choose_way(ui, helper, &mut settings.ways);
                match way {
                    Some(way) => ask_way(ui, way, &mut settings.entries, height, commands),
                    None => ask_q_matrix(ui, inputs, &mut settings.entries, height, commands),
                }
            });
            ui.add_space(theme::STEP);
            ui.add_sized(vec2(96.0, height), Button::new("Cancel")).clicked()
        });
    if response.inner || response.should_close() {
        commands.push(Command::Help(None));
    }
}

/// The way chosen among those of `helper`; `None` is the Q matrix.
fn choose_way(ui: &mut Ui, helper: Helper, ways: &mut Ways) -> Option<&'static Way> {
    let named = |way: &'static Way| (way.key, way.name);
    let q_matrix = (helper == Helper::FocalLength).then_some((fields::Q_MATRIX.as_str(), Q_MATRIX));
    let choices: Vec<(&'static str, &'static str)> = helper.ways().iter().map(named).chain(q_matrix).collect();
    let stored = ways.get(helper.key());
    let mut chosen = choices
        .iter()
        .find(|(key, _)| stored.is_some_and(|stored| stored == key))
        .or(choices.first())
        .copied()
        .unwrap_or_default();
    let before = chosen;
    ComboBox::from_id_salt(("way", helper.key()))
        .width(ui.available_width())
        .selected_text(chosen.1)
        .show_ui(ui, |ui| {
            for &choice in &choices {
                if ui.selectable_value(&mut chosen, choice, choice.1).clicked() {
                    ui.close();
                }
            }
        })
        .response
        .accessible_name("What is known");
    if chosen != before {
        ways.insert(helper.key().to_owned(), chosen.0.to_owned());
    }
    ui.add_space(2.0 * theme::STEP);
    Way::named(helper.ways(), chosen.0)
}

fn ask_way(ui: &mut Ui, way: &Way, entries: &mut Entries, height: f32, commands: &mut Vec<Command>) {
    for &key in way.asks {
        let typed = &mut entries.entry_mut(key).text;
        NumberField {
            name: key.spec().name,
            hint: "",
            example: key.spec().example(),
            unit: Unit::Fixed(key.spec().unit_symbol()),
            signed: way.target == Field::Disparity,
            sigma: None,
        }
        .show(ui, typed, height);
        if key == fields::SENSOR_WIDTH {
            sensor_formats(ui, typed);
        }
    }
    text::caption(ui, way.remark);
    ui.add_space(theme::STEP);
    let symbol = way.target.symbol;
    let result = way.compute(entries);
    let usable = result.as_ref().ok().copied().flatten();
    let label = usable.map_or_else(
        || format!("Use as {symbol}"),
        |value| format!("Use {symbol} = {} px", significant(value, 6)),
    );
    // What is not one number is said at its field.
    if let Err(note) = &result
        && number::read(&entries.entry(note.key).text).is_ok()
    {
        text::note(ui, Severity::Error, &note.message(), None);
    }
    if use_button(ui, &label, usable.is_some(), height)
        && let Some(value) = usable
    {
        commands.push(Command::Fix(way.target, way.entry(value)));
    }
}

fn sensor_formats(ui: &mut Ui, typed: &mut String) {
    ComboBox::from_id_salt("sensor formats")
        .selected_text("Common formats…")
        .width(200.0)
        .show_ui(ui, |ui| {
            for format in &SENSOR_FORMATS {
                let name = format!("{}: {} × {} mm", format.name, plain(format.width_mm), plain(format.height_mm));
                if ui.selectable_label(false, name).clicked() {
                    *typed = plain(format.width_mm);
                    ui.close();
                }
            }
        })
        .response
        .accessible_name("Common sensor formats");
    ui.add_space(2.0 * theme::STEP);
}

fn ask_q_matrix(ui: &mut Ui, inputs: &Inputs, entries: &mut Entries, height: f32, commands: &mut Vec<Command>) {
    let palette = theme::palette(ui);
    let name = ui.label(RichText::new("Q matrix").font(theme::strong(theme::BODY_SIZE)).color(palette.text));
    let typed = &mut entries.entry_mut(fields::Q_MATRIX).text;
    let field = ui
        .add(
            TextEdit::multiline(typed)
                .desired_rows(5)
                .desired_width(ui.available_width())
                .hint_text(RichText::new("[[1. 0. 0. −610.] [0. 1. 0. −350.] [0. 0. 0. 700.] [0. 0. 0.01 0.4]]").color(palette.muted)),
        )
        .labelled_by(name.id);
    text::caption(ui, "As numpy prints it, as OpenCV's YAML or XML has it, or as sixteen numbers.");
    ui.add_space(theme::STEP);
    if typed.trim().is_empty() {
        return;
    }
    let geometry = match q_matrix::read(typed) {
        Ok(geometry) => geometry,
        Err(reason) => {
            text::note(ui, Severity::Error, &reason.to_string(), Some(field.id));
            return;
        }
    };
    ui.label(format!(
        "fx {} px, baseline {}, doffs {} px, principal point ({}, {}) px",
        significant(geometry.focal_length.px(), 7),
        significant(geometry.baseline, 6),
        plain(geometry.doffs.px()),
        significant(geometry.cx.px(), 6),
        significant(geometry.cy.px(), 6)
    ));
    if geometry.swapped {
        text::note(ui, Severity::Warning, &Issue::QMatrixSwapped.to_string(), Some(field.id));
    }
    ui.add_space(theme::STEP);
    ui.label(format!(
        "A Q matrix carries no unit. In which unit is the baseline {}?",
        significant(geometry.baseline, 6)
    ));
    ui.horizontal_wrapped(|ui| {
        for unit in LengthUnit::ALL {
            let label = format!("{} {}", significant(geometry.baseline, 6), unit.symbol());
            if ui.add(Button::new(label).min_size(vec2(0.0, height))).clicked() {
                let mut filled = inputs.clone();
                filled.fill(Field::FocalLength, Entry::new(plain(geometry.focal_length.px()), None));
                filled.fill(Field::Baseline, Entry::new(plain(geometry.baseline), Some(unit)));
                let doffs = geometry.doffs.px();
                filled.fill(
                    Field::Doffs,
                    Entry::new(if doffs == 0.0 { String::new() } else { plain(doffs) }, None),
                );
                commands.push(Command::PrincipalPoint(geometry.cx, geometry.cy));
                commands.push(Command::Open(
                    Box::new(filled),
                    "The Q matrix filled in focal length, baseline and doffs.",
                ));
            }
        }
    });
}

fn use_button(ui: &mut Ui, label: &str, enabled: bool, height: f32) -> bool {
    let palette = theme::palette(ui);
    let button = Button::new(RichText::new(label).font(theme::strong(theme::BODY_SIZE)).color(palette.on_blue))
        .fill(palette.blue)
        .stroke(Stroke::NONE)
        .min_size(vec2(0.0, height));
    ui.add_enabled(enabled, button).clicked()
}

/// The matching errors that people state, with where they state them, to choose a σ of the disparity from.
pub const MATCHING_ERRORS: [(&str, &str); 7] = [
    ("0.08", "RealSense on good texture (librealsense #3904)"),
    ("0.15", "Point Grey, by mask size 0.10 to 0.18"),
    ("0.2", "Point Grey (knowledge base 10102)"),
    ("0.25", "common (Carnegie Robotics)"),
    ("0.4", "mrcal, 0.3 to 0.5"),
    ("0.5", "limit (Carnegie Robotics)"),
    ("1.3", "mrcal with a poor lens model"),
];
