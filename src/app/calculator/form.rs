//! The form: five fields, the buttons, the examples.

use crate::app::command::Command;
use crate::app::theme::{self, Layout};
use crate::app::widgets::{quantity_field, text};
use crate::core::problem::Field;
use crate::formats::inputs::{Assessment, Example, Inputs, Note};
use egui::accesskit::Role;
use egui::{Button, RichText, Stroke, Ui, UiBuilder, vec2};

const SECTIONS: [(&str, &[Field]); 3] = [
    ("Camera", &[Field::FocalLength]),
    ("Stereo", &[Field::Baseline, Field::Disparity]),
    ("Monocular", &[Field::ImageWidth, Field::RealWidth]),
];

/// Draws the form. With `marked`, what is missing is said at the fields too.
pub fn show(ui: &mut Ui, layout: Layout, inputs: &mut Inputs, assessment: &Assessment, marked: bool, commands: &mut Vec<Command>) {
    let height = layout.control_height();
    let missing = if marked { inputs.missing() } else { Vec::new() };
    let note = |field: Field| -> Option<&Note> { assessment.note(field).or_else(|| missing.iter().find(|note| note.field == field)) };
    let builder = UiBuilder::new().accessibility_role(Role::Form).accessibility_label("Inputs");
    ui.scope_builder(builder, |ui| {
        theme::card(theme::palette(ui)).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.spacing_mut().item_spacing.y = theme::STEP;
            for (section, fields) in SECTIONS {
                text::card_heading(ui, section);
                ui.add_space(2.0);
                for &field in fields {
                    quantity_field::show(ui, inputs, field, note(field), height, commands);
                    ui.add_space(2.0 * theme::STEP);
                }
            }
            buttons(ui, height, commands);
            ui.add_space(theme::STEP);
            examples(ui, layout, commands);
        });
    });
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
            if ui.add_sized(vec2(width, height), Button::new(name)).clicked() {
                commands.push(wanted);
            }
        }
    });
}

fn examples(ui: &mut Ui, layout: Layout, commands: &mut Vec<Command>) {
    let palette = theme::palette(ui);
    ui.horizontal_wrapped(|ui| {
        text::caption(ui, "Examples:");
        for example in Example::ALL {
            let link = Button::new(
                RichText::new(example.name())
                    .size(theme::SMALL_SIZE)
                    .underline()
                    .color(palette.blue),
            )
            .frame(false)
            .min_size(vec2(
                0.0,
                if layout == Layout::Phone {
                    theme::CONTROL_HEIGHT_TOUCH
                } else {
                    28.0
                },
            ));
            if ui.add(link).clicked() {
                commands.push(Command::Open(example.inputs()));
            }
        }
    });
}
