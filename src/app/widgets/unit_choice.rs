//! A choice among the units of length.

use crate::app::theme;
use crate::core::quantity::LengthUnit;
use depth_text::field::Kind;
use depth_text::names::Named as _;
use depth_text::unit::Unit;
use egui::{ComboBox, Response, Ui};

/// What can be chosen beside a number that is typed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TypedUnit {
    /// A unit.
    Unit(Unit),
    /// Squares of a calibration board, whose size is part of the text.
    Squares,
}

impl TypedUnit {
    /// What stands in the closed list.
    const fn symbol(self) -> &'static str {
        match self {
            Self::Unit(unit) => unit.symbol(),
            Self::Squares => "sq",
        }
    }

    fn name(self) -> String {
        match self {
            Self::Unit(unit) => format!("{}  ({})", unit.symbol(), unit.name()),
            Self::Squares => "sq  (squares of a calibration board)".to_owned(),
        }
    }
}

/// A choice among the units of results, named `name`.
pub fn length_unit_choice_ui(ui: &mut Ui, id: impl std::hash::Hash + std::fmt::Debug, name: &str, unit: &mut LengthUnit, width: f32) {
    let mut chosen = TypedUnit::Unit(Unit::Length(*unit));
    let lengths = Kind::Length(*unit).choices().iter().map(|&choice| TypedUnit::Unit(choice));
    let combo = ComboBox::from_id_salt(id).width(width);
    choice_ui(ui, combo, name, &mut chosen, lengths);
    if let TypedUnit::Unit(Unit::Length(length)) = chosen {
        *unit = length;
    }
}

/// A choice among the units that are usual for a number of this `kind`, named `name`.
pub fn typed_unit_choice_ui(
    ui: &mut Ui,
    id: impl std::hash::Hash + std::fmt::Debug,
    name: &str,
    kind: Kind,
    unit: &mut TypedUnit,
) -> Response {
    let squares = matches!(kind, Kind::Length(_)).then_some(TypedUnit::Squares);
    let units = kind.choices().iter().map(|&choice| TypedUnit::Unit(choice));
    let combo = ComboBox::from_id_salt(id).width(theme::UNIT_WIDTH);
    choice_ui(ui, combo, name, unit, units.chain(squares))
}

fn choice_ui(ui: &mut Ui, combo: ComboBox, name: &str, unit: &mut TypedUnit, choices: impl Iterator<Item = TypedUnit>) -> Response {
    combo
        .selected_text(unit.symbol())
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
