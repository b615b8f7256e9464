//! The form: five fields, the buttons, the examples, and the ways to ask for more.

use super::unknown;
use crate::app::command::{Command, Helper};
use crate::app::platform::COPY_RESULTS;
use crate::app::theme::{self, Layout};
use crate::app::widgets::quantity_field::{self, Around};
use crate::app::widgets::text;
use crate::core::problem::Field;
use crate::formats::inputs::{Assessment, Example, Inputs};
use egui::accesskit::Role;
use egui::{Button, RichText, Stroke, Ui, UiBuilder, vec2};

const SECTIONS: [(&str, &[Field]); 3] = [
    ("Camera", &[Field::FocalLength]),
    ("Stereo", &[Field::Baseline, Field::Disparity, Field::Doffs]),
    ("Monocular", &[Field::ImageWidth, Field::RealWidth]),
];

/// Draws the form. With `marked`, what is missing is said at the fields too.
pub fn show(
    ui: &mut Ui,
    layout: Layout,
    inputs: &mut Inputs,
    assessment: &Assessment,
    marked: bool,
    shows_geometry: bool,
    commands: &mut Vec<Command>,
) {
    let height = layout.control_height();
    let missing = if marked { inputs.missing() } else { Vec::new() };
    let around = |field: Field| Around {
        value_note: assessment.note(field).or_else(|| missing.iter().find(|note| note.field == field)),
        sigma_note: assessment.sigma_note(field),
        helper: Helper::at(field),
        computed: assessment.unknown.as_ref().filter(|unknown| unknown.field == field),
    };
    let builder = UiBuilder::new().accessibility_role(Role::Form).accessibility_label("Inputs");
    ui.scope_builder(builder, |ui| {
        theme::card(theme::palette(ui)).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.spacing_mut().item_spacing.y = theme::STEP;
            unknown::show(ui, inputs, assessment, height, commands);
            for (section, fields) in SECTIONS {
                apart(ui, section, |ui| {
                    text::card_heading(ui, section);
                    let mut space = 2.0;
                    for &field in fields {
                        // Most rigs have no offset, and who has none should not have to wonder what it is.
                        if field == Field::Doffs && !inputs.shows_doffs() {
                            continue;
                        }
                        ui.add_space(space);
                        apart(ui, field, |ui| {
                            quantity_field::show(ui, inputs, field, around(field), height, commands)
                        });
                        space = 2.0 * theme::STEP;
                    }
                });
                ui.add_space(2.0 * theme::STEP);
            }
            apart(ui, "buttons", |ui| {
                buttons(ui, height, commands);
                ui.add_space(theme::STEP);
                examples(ui, layout, commands);
                more(ui, layout, inputs, shows_geometry, commands);
            });
        });
    });
}

/// Draws a part of the form with a name of its own: else everything after an error that appears would be another thing to
/// egui, and to a screen reader.
fn apart(ui: &mut Ui, name: impl std::hash::Hash + std::fmt::Debug, add_contents: impl FnOnce(&mut Ui)) {
    let builder = UiBuilder::new().scope_id(egui::Id::unique(("part of the form", name)));
    ui.scope_builder(builder, add_contents);
}

fn buttons(ui: &mut Ui, height: f32, commands: &mut Vec<Command>) {
    let palette = theme::palette(ui);
    let calculate = Button::new(
        RichText::new("Calculate Distance")
            .font(theme::strong(theme::BODY_SIZE))
            .color(palette.on_blue),
    )
    .fill(palette.blue)
    .stroke(Stroke::new(1.0, palette.blue));
    if ui.add_sized(vec2(ui.available_width(), height), calculate).clicked() {
        commands.push(Command::Calculate);
    }
    ui.add_space(theme::STEP);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0 * theme::STEP;
        let width = (ui.available_width() - 2.0 * theme::STEP) / 2.0;
        for (name, wanted) in [("Reset", Command::Reset), ("Copy Results", Command::CopyResults)] {
            let button = ui.add_sized(vec2(width, height), Button::new(name));
            if wanted == Command::CopyResults {
                ui.accesskit_node_builder(button.id, |node| node.set_author_id(COPY_RESULTS));
            }
            if button.clicked() {
                commands.push(wanted);
            }
        }
    });
}

fn examples(ui: &mut Ui, layout: Layout, commands: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        text::caption(ui, "Examples:");
        for example in Example::ALL {
            if text::link_button(ui, example.name(), layout).clicked() {
                commands.push(Command::Open(Box::new(example.inputs()), "The example is filled in."));
            }
        }
    });
}

/// What is not shown until it is asked for.
fn more(ui: &mut Ui, layout: Layout, inputs: &mut Inputs, shows_geometry: bool, commands: &mut Vec<Command>) {
    ui.horizontal_wrapped(|ui| {
        text::caption(ui, "More:");
        let name = if inputs.with_uncertainty {
            "Hide uncertainty"
        } else {
            "Add uncertainty"
        };
        if text::link_button(ui, name, layout).clicked() {
            inputs.with_uncertainty = !inputs.with_uncertainty;
            commands.push(Command::Settle);
        }
        if inputs.unknown.is_none() && text::link_button(ui, "Solve for another quantity", layout).clicked() {
            inputs.unknown = Some(unknown::FIRST);
            commands.push(Command::Settle);
        }
        let name = if shows_geometry {
            "Hide range, tilt and ground plane"
        } else {
            "Range, tilt, ground plane"
        };
        if text::link_button(ui, name, layout).clicked() {
            commands.push(Command::ShowGeometry(!shows_geometry));
        }
    });
}
