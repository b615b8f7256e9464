//! The units that can be typed behind a number.

use crate::number;
use depth_core::angle::{Angle, AngleUnit};
use depth_core::judge;
use depth_core::quantity::{Length, LengthUnit};
use std::fmt::{self, Display, Formatter};

/// A unit that can be typed behind a number.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Unit {
    /// px
    Pixel,
    /// A unit of length.
    Length(LengthUnit),
    /// A unit of angle.
    Angle(AngleUnit),
    /// The side of a square of a calibration board, as long as this: what OpenCV computes in where the size of the squares was
    /// not told.
    Square(Length),
}

impl Unit {
    /// °
    pub const DEGREE: Self = Self::Angle(AngleUnit::Degree);

    /// The unit that `word` names: symbols, English names in singular and plural, and primes, which are minutes and seconds where
    /// `primes_are_angles`, else feet and inches. Squares, which need their size, are read with the number.
    pub fn named(word: &str, primes_are_angles: bool) -> Option<Self> {
        use AngleUnit::{Arcminute, Arcsecond, Degree, Milliradian, MinuteOfAngle, NatoMil, Radian};
        use LengthUnit::{Centimeter, Foot, Inch, Kilometer, Meter, Micrometer, Mile, Millimeter, Nanometer, Yard};
        let word = word.to_ascii_lowercase();
        let either = |angle, length| {
            if primes_are_angles {
                Self::Angle(angle)
            } else {
                Self::Length(length)
            }
        };
        Some(match word.as_str() {
            "px" | "pix" | "pixel" | "pixels" => Self::Pixel,
            "\"" | "″" | "”" | "''" | "′′" => either(Arcsecond, Inch),
            "'" | "′" | "’" => either(Arcminute, Foot),
            "nm" | "nanometre" | "nanometres" | "nanometer" | "nanometers" => Self::Length(Nanometer),
            // With the micro sign, which lower case leaves as it is, and with the Greek letter.
            "µm" | "μm" | "um" | "micrometre" | "micrometres" | "micrometer" | "micrometers" | "micron" | "microns" => {
                Self::Length(Micrometer)
            }
            "mm" | "millimetre" | "millimetres" | "millimeter" | "millimeters" => Self::Length(Millimeter),
            "cm" | "centimetre" | "centimetres" | "centimeter" | "centimeters" => Self::Length(Centimeter),
            "m" | "metre" | "metres" | "meter" | "meters" => Self::Length(Meter),
            "km" | "kilometre" | "kilometres" | "kilometer" | "kilometers" => Self::Length(Kilometer),
            "in" | "inch" | "inches" => Self::Length(Inch),
            "ft" | "foot" | "feet" => Self::Length(Foot),
            "yd" | "yds" | "yard" | "yards" => Self::Length(Yard),
            "mi" | "mile" | "miles" => Self::Length(Mile),
            "°" | "deg" | "degs" | "degree" | "degrees" => Self::Angle(Degree),
            "arcmin" | "arcminute" | "arcminutes" => Self::Angle(Arcminute),
            "arcsec" | "arcsecond" | "arcseconds" => Self::Angle(Arcsecond),
            "rad" | "radian" | "radians" => Self::Angle(Radian),
            "mrad" | "mrads" | "milliradian" | "milliradians" => Self::Angle(Milliradian),
            "moa" | "minute of angle" | "minutes of angle" => Self::Angle(MinuteOfAngle),
            "mil" | "mils" | "nato mil" | "nato mils" => Self::Angle(NatoMil),
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
            Self::Angle(unit) => unit.symbol(),
            Self::Square(_) => "squares",
        }
    }

    /// `number` with this unit: "10 cm", "20°".
    pub fn behind(self, number: &str) -> String {
        match self {
            Self::Angle(AngleUnit::Degree | AngleUnit::Arcminute | AngleUnit::Arcsecond) => format!("{number}{self}"),
            _ => format!("{number} {self}"),
        }
    }

    /// `number` of this unit in the [base unit](Self::base) of its kind.
    pub fn to_base(self, number: f64) -> f64 {
        match self {
            Self::Pixel => number,
            Self::Length(unit) => Length::new(number, unit).m(),
            Self::Angle(unit) => Angle::new(number, unit).radians(),
            Self::Square(size) => number * size.m(),
        }
    }

    /// `base` pixels, meters or radians as a number of this unit.
    pub fn from_base(self, base: f64) -> f64 {
        match self {
            Self::Pixel => base,
            Self::Length(unit) => Length::from_m(base).in_unit(unit),
            Self::Angle(unit) => Angle::from_radians(base).in_unit(unit),
            Self::Square(size) => base / size.m(),
        }
    }

    /// The unit in which values of its kind are computed: pixels, meters or radians.
    pub const fn base(self) -> Self {
        match self {
            Self::Pixel => Self::Pixel,
            Self::Length(_) | Self::Square(_) => Self::Length(LengthUnit::Meter),
            Self::Angle(_) => Self::Angle(AngleUnit::Radian),
        }
    }

    /// The unit of length, for one in which results can be shown.
    pub const fn length(self) -> Option<LengthUnit> {
        match self {
            Self::Length(unit) => Some(unit),
            _ => None,
        }
    }

    /// Whether it is a length, squares of a board included.
    pub const fn is_length(self) -> bool {
        matches!(self, Self::Length(_) | Self::Square(_))
    }
}

impl From<LengthUnit> for Unit {
    fn from(unit: LengthUnit) -> Self {
        Self::Length(unit)
    }
}

impl From<AngleUnit> for Unit {
    fn from(unit: AngleUnit) -> Self {
        Self::Angle(unit)
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
