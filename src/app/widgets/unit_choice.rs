//! A choice among the units of length.

use crate::core::quantity::LengthUnit;
use depth_text::names::Named as _;
use egui::{ComboBox, Response, Ui};

/// A choice among the units of length, named `name`.
pub fn length_unit_choice_ui(
    ui: &mut Ui,
    id: impl std::hash::Hash + std::fmt::Debug,
    name: &str,
    unit: &mut LengthUnit,
    width: f32,
) -> Response {
    ComboBox::from_id_salt(id)
        .width(width)
        .selected_text(unit.symbol())
        .show_ui(ui, |ui| {
            for choice in LengthUnit::ALL {
                let name = format!("{}  ({})", choice.symbol(), choice.name());
                // Closed explicitly: egui does so only for a click of the pointer.
                if ui.selectable_value(unit, choice, name).clicked() {
                    ui.close();
                }
            }
        })
        .response
        .accessible_name(name)
}
