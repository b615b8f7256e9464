//! A choice among the units of length.

use crate::core::quantity::LengthUnit;
use depth_text::names::Named as _;
use egui::{ComboBox, Response, Ui};

/// What can be chosen beside a length that is typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TypedUnit {
    /// A unit of length.
    Length(LengthUnit),
    /// Squares of a calibration board, whose size is part of the text.
    Squares,
}

/// The units that are offered; the smaller ones can be typed.
const OFFERED: [LengthUnit; 8] = [
    LengthUnit::Millimeter,
    LengthUnit::Centimeter,
    LengthUnit::Meter,
    LengthUnit::Kilometer,
    LengthUnit::Inch,
    LengthUnit::Foot,
    LengthUnit::Yard,
    LengthUnit::Mile,
];

impl TypedUnit {
    /// What stands in the closed list.
    const fn symbol(self) -> &'static str {
        match self {
            Self::Length(unit) => unit.symbol(),
            Self::Squares => "sq",
        }
    }

    fn name(self) -> String {
        match self {
            Self::Length(unit) => format!("{}  ({})", unit.symbol(), unit.name()),
            Self::Squares => "sq  (squares of a calibration board)".to_owned(),
        }
    }
}

/// A choice among the units of results, named `name`.
pub fn length_unit_choice_ui(ui: &mut Ui, id: impl std::hash::Hash + std::fmt::Debug, name: &str, unit: &mut LengthUnit, width: f32) {
    let mut chosen = TypedUnit::Length(*unit);
    let combo = ComboBox::from_id_salt(id)
        .width(width)
        .selected_text(format!("in {}", unit.symbol()));
    choice_ui(ui, combo, name, &mut chosen, OFFERED.into_iter().map(TypedUnit::Length));
    if let TypedUnit::Length(length) = chosen {
        *unit = length;
    }
}

/// A choice among the units of a typed length, named `name`.
pub fn typed_unit_choice_ui(
    ui: &mut Ui,
    id: impl std::hash::Hash + std::fmt::Debug,
    name: &str,
    unit: &mut TypedUnit,
    width: f32,
) -> Response {
    let combo = ComboBox::from_id_salt(id).width(width).selected_text(unit.symbol());
    let units = OFFERED.into_iter().map(TypedUnit::Length);
    choice_ui(ui, combo, name, unit, units.chain([TypedUnit::Squares]))
}

fn choice_ui(ui: &mut Ui, combo: ComboBox, name: &str, unit: &mut TypedUnit, choices: impl Iterator<Item = TypedUnit>) -> Response {
    combo
        .wrap_mode(egui::TextWrapMode::Extend)
        .show_ui(ui, |ui| {
            for choice in choices {
                // Closed explicitly: egui does so only for a click of the pointer.
                if ui.selectable_value(unit, choice, choice.name()).clicked() {
                    ui.close();
                }
            }
        })
        .response
        .accessible_name(name)
}
