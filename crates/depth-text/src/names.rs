//! What the methods and the units are called.

use crate::unit::Unit;
use depth_core::angle::AngleUnit;
use depth_core::in_image::InImage;
use depth_core::problem::{Field, Method, Problem};
use depth_core::quantity::LengthUnit;
use depth_core::setup::{Object, Pair};

/// Something with a name for people.
pub trait Named {
    /// The name: of a method and of a choice with a capital letter, of a unit in the plural.
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
            Self::Nanometer => "nanometers",
            Self::Micrometer => "micrometers",
            Self::Millimeter => "millimeters",
            Self::Centimeter => "centimeters",
            Self::Meter => "meters",
            Self::Kilometer => "kilometers",
            Self::Inch => "inches",
            Self::Foot => "feet",
            Self::Yard => "yards",
            Self::Mile => "miles",
        }
    }
}

impl Named for AngleUnit {
    fn name(self) -> &'static str {
        match self {
            Self::Degree => "degrees",
            Self::Arcminute => "arcminutes",
            Self::Arcsecond => "arcseconds",
            Self::Radian => "radians",
            Self::Milliradian => "milliradians",
            Self::MinuteOfAngle => "minutes of angle",
            Self::NatoMil => "NATO mils, 6400 to the circle",
        }
    }
}

impl Named for Unit {
    fn name(self) -> &'static str {
        match self {
            Self::Pixel => "pixels",
            Self::Length(unit) => unit.name(),
            Self::Angle(unit) => unit.name(),
            Self::Square(_) => "squares",
        }
    }
}

impl Named for Object {
    fn name(self) -> &'static str {
        match self {
            Self::Width => "Width",
            Self::Height => "Height",
            Self::Ball => "Diameter of ball",
        }
    }
}

impl Named for Pair {
    fn name(self) -> &'static str {
        match self {
            Self::Horizontal => "Side by side",
            Self::Vertical => "One above the other",
        }
    }
}

/// The formula of `method` with the symbols of the fields, as `problem` has them: which of the inputs that may be left out there are,
/// in which unit the image is measured, and what of the object.
pub fn formula(problem: &Problem, method: Method) -> String {
    let has = |field| problem.get(field).is_some();
    let f = if problem.needs_fy(method) && has(Field::Fy) { "fy" } else { "fx" };
    let is_angle = |extent: Option<InImage>| matches!(extent, Some(InImage::Angle(_)));
    let in_pixels = |extent: Option<InImage>| extent.is_none_or(|extent| extent.px().is_some());
    let (mut formula, extent) = match method {
        Method::Stereo if is_angle(problem.disparity) => ("D = b / (2 · tan(d / 2))".to_owned(), problem.disparity),
        Method::Stereo if has(Field::Doffs) => (format!("D = {f} · b / (d + doffs)"), problem.disparity),
        Method::Stereo => (format!("D = {f} · b / d"), problem.disparity),
        Method::Monocular => {
            let is_ball = problem.object == Object::Ball;
            let w = if has(Field::Tilt) && !is_ball {
                "w_real · cos φ"
            } else {
                "w_real"
            };
            let formula = match (is_ball, is_angle(problem.image_width)) {
                (true, true) => "D = ½ · w_real / sin(w_img / 2)".to_owned(),
                (true, false) => format!("D = ½ · w_real · √(1 + (2 · {f} / w_img)²)"),
                (false, true) => format!("D = {w} / (2 · tan(w_img / 2))"),
                (false, false) => format!("D = {w} · {f} / w_img"),
            };
            (formula, problem.image_width)
        }
    };
    if has(Field::Lens) && in_pixels(extent) {
        formula.push_str(" + f_lens");
    }
    if has(Field::Zero) {
        formula.push_str(" − zero");
    }
    formula
}
