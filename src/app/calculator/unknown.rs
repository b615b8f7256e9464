//! Solving for another quantity than the distance: which one, and the distance as an input.

use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::theme;
use crate::app::widgets::number_field::{self, NumberField};
use crate::app::widgets::text;
use crate::core::problem::{Field, Method};
use crate::core::quantity::LengthUnit;
use crate::formats::fields;
use egui::{ComboBox, Ui};

/// What is offered first.
pub const FIRST: (Method, Field) = (Method::Stereo, Field::Disparity);

const CHOICES: [(Method, Field); 7] = [
    (Method::Stereo, Field::FocalLength),
    (Method::Stereo, Field::Baseline),
    FIRST,
    (Method::Stereo, Field::Doffs),
    (Method::Monocular, Field::FocalLength),
    (Method::Monocular, Field::ImageWidth),
    (Method::Monocular, Field::RealWidth),
];

fn name((method, field): (Method, Field)) -> String {
    format!("{}: {}", method.name(), field.name())
}

/// Draws the choice and the distance, where something else than the distance is solved for.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let (inputs, assessment) = cx.session.parts();
    let Some(before) = inputs.unknown else { return };
    let mut chosen = Some(before);
    text::card_heading(ui, "Solve for");
    ComboBox::from_id_salt("solve for")
        .width(ui.available_width())
        .selected_text(name(before))
        .show_ui(ui, |ui| {
            let choices = CHOICES.map(|choice| (Some(choice), name(choice)));
            for (choice, name) in std::iter::once((None, "Distance (D)".to_owned())).chain(choices) {
                if ui.selectable_value(&mut chosen, choice, name).clicked() {
                    ui.close();
                }
            }
        })
        .response
        .accessible_name("Solve for");
    if chosen != inputs.unknown {
        inputs.unknown = chosen;
        cx.commands.push(Command::Settle);
    }
    ui.add_space(theme::STEP);
    let with_uncertainty = inputs.with_uncertainty;
    let distance = inputs.entry_mut(fields::DISTANCE);
    let unit = distance.unit.get_or_insert(LengthUnit::Meter);
    let left = NumberField {
        name: "Distance (D)",
        hint: "The distance along the optical axis, now an input.",
        example: "1.4",
        unit: number_field::Unit::Choice(unit),
        signed: false,
        sigma: with_uncertainty.then_some(&mut distance.sigma),
    }
    .ui(ui, &mut distance.text);
    if left {
        cx.commands.push(Command::Settle);
    }
    if let Some(Err(reason)) = assessment.unknown.as_ref().map(|unknown| &unknown.outcome) {
        text::caption(ui, reason.to_string());
    }
    ui.add_space(2.0 * theme::STEP);
}
