//! How far the cameras of a file are apart, in a unit that it says or not.

use depth_core::quantity::{Length, LengthUnit};

/// How far the lenses are apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Baseline {
    /// In a unit that the file or its format says.
    Known(Length),
    /// In the unit in which somebody measured the board.
    InFileUnits {
        /// How many.
        value: f64,
        /// What the unit may be.
        guess: Guess,
    },
}

/// What the unit of a file may be that does not say it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Guess {
    /// One of these, by the number.
    Unit(LengthUnit),
    /// Squares of the board, whose size stands beside it in an unknown unit.
    Squares {
        /// That size.
        size: f64,
    },
}

impl Baseline {
    /// The length, where its unit is known or one unit of the file is `file_unit`.
    pub fn length(self, file_unit: Option<Length>) -> Option<Length> {
        match self {
            Self::Known(length) => Some(length),
            Self::InFileUnits { value, .. } => file_unit.map(|unit| Length::from_m(unit.m() * value)),
        }
    }
}
