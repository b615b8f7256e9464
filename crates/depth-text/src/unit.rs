//! The units that can be typed behind a number.

use crate::number;
use depth_core::angle::Angle;
use depth_core::judge;
use depth_core::quantity::{Length, LengthUnit};
use std::fmt::{self, Display, Formatter};

/// A unit that can be typed behind a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unit {
    /// px
    Pixel,
    /// A unit of length that results can be shown in as well.
    Length(LengthUnit),
    /// µm, the unit of pixel pitches.
    Micrometer,
    /// The side of a square of a calibration board, as long as this: what OpenCV computes in where the size of the squares was
    /// not told.
    Square(Length),
    /// °
    Degree,
    /// rad
    Radian,
}

impl Unit {
    /// The unit that `word` names: symbols, English names in singular and plural, and the primes of inch and foot. Squares, which
    /// need their size, are read with the number.
    pub fn named(word: &str) -> Option<Self> {
        Some(match word.to_lowercase().as_str() {
            "px" | "pixel" | "pixels" => Self::Pixel,
            "mm" | "millimetre" | "millimetres" | "millimeter" | "millimeters" => Self::Length(LengthUnit::Millimeter),
            "cm" | "centimetre" | "centimetres" | "centimeter" | "centimeters" => Self::Length(LengthUnit::Centimeter),
            "m" | "metre" | "metres" | "meter" | "meters" => Self::Length(LengthUnit::Meter),
            "in" | "inch" | "inches" | "\"" | "″" => Self::Length(LengthUnit::Inch),
            "ft" | "foot" | "feet" | "'" | "′" => Self::Length(LengthUnit::Foot),
            // With the micro sign, which lower case leaves as it is, and with the Greek letter.
            "µm" | "μm" | "um" | "micrometre" | "micrometres" | "micrometer" | "micrometers" | "micron" | "microns" => Self::Micrometer,
            "°" | "deg" | "degree" | "degrees" => Self::Degree,
            "rad" | "radian" | "radians" => Self::Radian,
            _ => return None,
        })
    }

    /// Squares of this size, which is above zero.
    pub fn square(size: Length) -> Option<Self> {
        judge::positive(size.m()).is_ok().then_some(Self::Square(size))
    }

    /// The symbol written behind a number; of squares without their size, which [`Display`] has.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Pixel => "px",
            Self::Length(unit) => unit.symbol(),
            Self::Micrometer => "µm",
            Self::Square(_) => "squares",
            Self::Degree => "°",
            Self::Radian => "rad",
        }
    }

    /// `number` of this unit in the base unit of its kind: pixels, meters or radians.
    pub fn to_base(self, number: f64) -> f64 {
        match self {
            Self::Pixel | Self::Radian => number,
            Self::Length(unit) => Length::new(number, unit).m(),
            // In two steps, each of which rounds as it does for somebody who types millimeters.
            Self::Micrometer => Length::new(number / 1000.0, LengthUnit::Millimeter).m(),
            Self::Square(size) => number * size.m(),
            Self::Degree => Angle::from_degrees(number).radians(),
        }
    }

    /// `base` pixels, meters or radians as a number of this unit.
    pub fn from_base(self, base: f64) -> f64 {
        match self {
            Self::Pixel | Self::Radian => base,
            Self::Length(unit) => Length::from_m(base).in_unit(unit),
            Self::Micrometer => Length::from_m(base).in_unit(LengthUnit::Millimeter) * 1000.0,
            Self::Square(size) => base / size.m(),
            Self::Degree => Angle::from_radians(base).degrees(),
        }
    }

    /// The unit of length, for one in which results can be shown.
    pub const fn length(self) -> Option<LengthUnit> {
        match self {
            Self::Length(unit) => Some(unit),
            _ => None,
        }
    }
}

impl From<LengthUnit> for Unit {
    fn from(unit: LengthUnit) -> Self {
        Self::Length(unit)
    }
}

/// The unit as it is typed behind a number: "squares of 23.6 mm".
impl Display for Unit {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Square(size) => write!(f, "squares of {} mm", number::plain(size.in_unit(LengthUnit::Millimeter))),
            _ => f.write_str(self.symbol()),
        }
    }
}
