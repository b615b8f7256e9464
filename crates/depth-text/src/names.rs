//! What the methods and the units are called.

use crate::unit::Unit;
use depth_core::problem::Method;
use depth_core::quantity::LengthUnit;

/// Something with a name for people.
pub trait Named {
    /// The name: of a method with a capital letter, of a unit in the plural.
    fn name(self) -> &'static str;
}

impl Named for Method {
    fn name(self) -> &'static str {
        match self {
            Self::Stereo => "Stereo",
            Self::Monocular => "Monocular",
        }
    }
}

impl Named for LengthUnit {
    fn name(self) -> &'static str {
        match self {
            Self::Millimeter => "millimeters",
            Self::Centimeter => "centimeters",
            Self::Meter => "meters",
            Self::Inch => "inches",
            Self::Foot => "feet",
        }
    }
}

impl Named for Unit {
    fn name(self) -> &'static str {
        match self {
            Self::Pixel => "pixels",
            Self::Length(unit) => unit.name(),
            Self::Micrometer => "micrometers",
            Self::Square(_) => "squares",
            Self::Degree => "degrees",
            Self::Radian => "radians",
        }
    }
}

/// The formula of `method` with the symbols of the fields, with or without its [optional one](Method::optional_field).
pub const fn formula(method: Method, with_optional: bool) -> &'static str {
    match (method, with_optional) {
        (Method::Stereo, false) => "D = fx · b / d",
        (Method::Stereo, true) => "D = fx · b / (d + doffs)",
        (Method::Monocular, false) => "D = w_real · fx / w_img",
        (Method::Monocular, true) => "D = w_real · cos φ · fx / w_img",
    }
}
