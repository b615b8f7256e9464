//! A choice among the units of length.

use super::menu::List;
use crate::core::quantity::LengthUnit;
use depth_text::names::Named as _;
use egui::{AsIdSalt, Response, Ui};

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
pub fn length_unit_choice_ui(ui: &mut Ui, id: impl AsIdSalt, name: &str, unit: &mut LengthUnit, width: f32) {
    let mut chosen = TypedUnit::Length(*unit);
    let shown = format!("in {}", unit.symbol());
    let units = OFFERED.map(TypedUnit::Length);
    choice_ui(ui, id, (name, &shown, width), &mut chosen, &units);
    if let TypedUnit::Length(length) = chosen {
        *unit = length;
    }
}

/// A choice among the units of a typed length, named `name`.
pub fn typed_unit_choice_ui(ui: &mut Ui, id: impl AsIdSalt, name: &str, unit: &mut TypedUnit, width: f32) -> Response {
    let shown = unit.symbol();
    let mut units = OFFERED.map(TypedUnit::Length).to_vec();
    units.push(TypedUnit::Squares);
    choice_ui(ui, id, (name, shown, width), unit, &units)
}

fn choice_ui(
    ui: &mut Ui,
    id: impl AsIdSalt,
    (name, shown, width): (&str, &str, f32),
    unit: &mut TypedUnit,
    choices: &[TypedUnit],
) -> Response {
    let names: Vec<String> = choices.iter().map(|choice| choice.name()).collect();
    let list = List {
        name,
        shown,
        width,
        names: &names,
        chosen: choices.iter().position(|choice| choice == unit),
    };
    let (response, now) = list.ui(ui, id);
    if let Some(&choice) = now.and_then(|at| choices.get(at)) {
        *unit = choice;
    }
    response
}
