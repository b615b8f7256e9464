//! What the unit of a baseline may be that a file does not say.

use crate::baseline::{Baseline, Guess};
use depth_core::quantity::{Length, LengthUnit};
use std::ops::RangeInclusive;

/// The distance of two lenses above which a number is hardly one of meters.
const MOST_METERS: f64 = 1.5;
/// The distance of two lenses above which a number is hardly one of squares of a board.
const MOST_SQUARES: f64 = 15.0;
/// Baselines lie between these, where they were measured in squares.
const BASELINES_M: RangeInclusive<f64> = 0.005..=5.0;
/// Two lenses for stereo stand hardly nearer to each other, nor farther apart.
const LIKELY_M: RangeInclusive<f64> = 0.02..=5.0;

/// A baseline of `value` in a unit that the file does not say; `square` is the size of the squares of the board, in a unit that it does not say.
pub(crate) fn in_file_units(value: f64, square: Option<f64>) -> Baseline {
    let guess = square.and_then(|size| beside_squares(value, size)).unwrap_or(match value {
        ..=MOST_METERS => Guess::Unit(LengthUnit::Meter),
        // So few millimeters are no distance of two lenses; whoever says no size of the squares counts in them.
        ..MOST_SQUARES if square.is_none() => Guess::Squares { size: 1.0 },
        _ => Guess::Unit(LengthUnit::Millimeter),
    });
    Baseline::InFileUnits { value, guess }
}

/// The unit in which the size of the squares was measured, or the squares themselves, by which of them is a distance of two lenses.
fn beside_squares(value: f64, size: f64) -> Option<Guess> {
    // Of squares with the size 1, that is their unit, and nothing is said of how large they are.
    if (size - 1.0).abs() < f64::EPSILON {
        return (value < MOST_SQUARES).then_some(Guess::Squares { size });
    }
    let unit = match size {
        ..0.3 => LengthUnit::Meter,
        ..6.0 => LengthUnit::Centimeter,
        _ => LengthUnit::Millimeter,
    };
    let meters = |number: f64| Length::new(number, unit).m();
    if LIKELY_M.contains(&meters(value)) {
        return Some(Guess::Unit(unit));
    }
    (value < MOST_SQUARES && BASELINES_M.contains(&meters(value * size))).then_some(Guess::Squares { size })
}
