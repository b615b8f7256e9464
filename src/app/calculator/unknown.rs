//! Solving for another quantity than the distance: which one, and the distance as an input.

use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::sentences::Hint;
use crate::app::theme;
use crate::app::widgets::field::{self, Field as FieldWidget};
use crate::app::widgets::text;
use crate::core::problem::{Field, Method};
use crate::core::quantity::LengthUnit;
use depth_text::assess::Unknown;
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::names::Named as _;
use depth_text::number::NO_NUMBER;
use depth_text::report;
use depth_text::style::Style;
use egui::{ComboBox, RichText, Sense, Ui, vec2};

/// What is offered first.
pub const FIRST: (Method, Field) = (Method::Stereo, Field::Disparity);

fn name(inputs: &Inputs, (method, field): (Method, Field)) -> String {
    format!("{}: {}", method.name(), inputs.worded(field).name)
}

/// Draws the choice and the distance, where something else than the distance is solved for. With `marked`, that it is missing is said
/// there too.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, marked: bool) {
    let (inputs, assessment) = cx.session.parts();
    let Some(before) = inputs.unknown else { return };
    let mut chosen = Some(before);
    text::card_heading_ui(ui, "Solve for");
    ComboBox::from_id_salt("solve for")
        .width(ui.available_width())
        .selected_text(name(inputs, before))
        .show_ui(ui, |ui| {
            let all = Method::ALL
                .into_iter()
                .flat_map(|method| method.unknowns().map(move |field| (method, field)));
            let choices = all.map(|choice| (Some(choice), name(inputs, choice)));
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
    let with_sigma = inputs.with_uncertainty;
    let key = fields::DISTANCE;
    let missing = assessment.missing.iter().find(|note| marked && note.key == key);
    let value_note = assessment.note(key).or(missing);
    let field = FieldWidget {
        key,
        reading: assessment.reading(key),
        notes: value_note.into_iter().chain(assessment.sigma_note(key)).collect(),
        with_sigma,
        helper: None,
        id: field::id(key),
        submits: true,
        entry: inputs.entry_mut(key),
    };
    let sigma_before = field.entry.sigma.clone();
    field.ui(ui, cx.commands);
    // As in the other fields of the form.
    inputs.with_uncertainty |= inputs.sigma(key) != sigma_before;
    ui.add_space(2.0 * theme::STEP);
}

/// What was solved for, in place of its field; a dash where something is lacking.
pub fn solution_ui(ui: &mut Ui, unknown: &Unknown, unit: LengthUnit) {
    let height = ui.spacing().interact_size.y;
    let palette = theme::palette(ui);
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    ui.painter().rect_filled(rect, theme::CONTROL_RADIUS, palette.highlight);
    let words = report::unknown(Style::WINDOW, unknown, unit).unwrap_or_else(|| NO_NUMBER.to_owned());
    // Not a live region: the result card says the same.
    ui.put(
        rect.shrink2(vec2(theme::SOLVED_INDENT, 0.0)),
        egui::Label::new(RichText::new(words).font(theme::strong(theme::BODY_SIZE))),
    );
    text::caption_ui(ui, Hint::Solved.to_string());
}
