//! The facts that `camera` is told, each as a focal length in pixels.

use crate::core::angle::{Angle, AngleUnit};
use crate::core::camera::{Fact, FilmExtent};
use crate::core::quantity::{Length, LengthUnit, Pixels};
use depth_text::choices::sensor_of_type;
use depth_text::number::{self, Notation, Primes};
use depth_text::unit::Unit;

/// More digits no data sheet has.
const DIGITS: usize = 6;

/// As a data sheet would have it.
pub(super) fn number(value: f64) -> String {
    Notation::LONG.plain(value, DIGITS)
}

/// What can be stated of a camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum FactKind {
    Fx,
    Fy,
    HorizontalView,
    VerticalView,
    DiagonalView,
    Lens,
    Film,
    P00,
    P11,
}

/// What a number is of, and in which unit where it says none.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Quantity {
    Pixels,
    Degrees,
    Meters,
    Millimeters,
    Micrometers,
    Plain,
}

impl FactKind {
    pub(super) const ALL: [Self; 9] = [
        Self::Fx,
        Self::Fy,
        Self::HorizontalView,
        Self::VerticalView,
        Self::DiagonalView,
        Self::Lens,
        Self::Film,
        Self::P00,
        Self::P11,
    ];

    /// Its option, value and help.
    const fn words(self) -> [&'static str; 3] {
        match self {
            Self::Fx => ["fx", "PX", "Focal length along the rows, K[0][0]"],
            Self::Fy => ["fy", "PX", "Focal length along the columns, K[1][1]"],
            Self::HorizontalView => [
                "hfov",
                "ANGLE",
                "Horizontal field of view: 90, 90deg, 1.57rad (Gazebo; Unreal, AirSim, CARLA)",
            ],
            Self::VerticalView => ["vfov", "ANGLE", "Vertical field of view (Unity)"],
            Self::DiagonalView => ["dfov", "ANGLE", "Diagonal field of view (webcams)"],
            Self::Lens => [
                "lens",
                "LENGTH",
                "Focal length of the lens, such as 4mm, with the sensor or its pixels",
            ],
            Self::Film => [
                "f35",
                "LENGTH",
                "The lens that would be equivalent on 35 mm film, such as 26mm, by the diagonal",
            ],
            Self::P00 => ["p00", "NUMBER", "P[0][0] of an OpenGL projection matrix: 2 fx/W"],
            Self::P11 => ["p11", "NUMBER", "P[1][1] of an OpenGL projection matrix: 2 fy/H"],
        }
    }

    pub(super) const fn option(self) -> &'static str {
        let [option, _, _] = self.words();
        option
    }

    pub(super) const fn value_name(self) -> &'static str {
        let [_, value, _] = self.words();
        value
    }

    pub(super) const fn help(self) -> &'static str {
        let [_, _, help] = self.words();
        help
    }

    const fn quantity(self) -> Quantity {
        match self {
            Self::Fx | Self::Fy => Quantity::Pixels,
            Self::HorizontalView | Self::VerticalView | Self::DiagonalView => Quantity::Degrees,
            Self::Lens | Self::Film => Quantity::Millimeters,
            Self::P00 | Self::P11 => Quantity::Plain,
        }
    }

    /// The fact that `text` states. Err: a sentence.
    pub(super) fn read(self, text: &str) -> Result<Fact, String> {
        let value = read(self.option(), text, self.quantity())?;
        let (pixels, angle, length) = (Pixels::new(value), Angle::from_radians(value), Length::from_m(value));
        Ok(match self {
            Self::Fx => Fact::Fx(pixels),
            Self::Fy => Fact::Fy(pixels),
            Self::HorizontalView => Fact::HorizontalView(angle),
            Self::VerticalView => Fact::VerticalView(angle),
            Self::DiagonalView => Fact::DiagonalView(angle),
            Self::Lens => Fact::Lens(length),
            Self::Film => Fact::Film(FilmExtent::Diagonal, length),
            Self::P00 => Fact::P00(value),
            Self::P11 => Fact::P11(value),
        })
    }

    /// That a view may be in radians, of which a number without a unit is none.
    pub(super) fn radians(self, text: &str) -> Option<String> {
        let degrees: f64 = text.trim().parse().ok()?;
        (self.quantity() == Quantity::Degrees && degrees < std::f64::consts::PI).then(|| {
            format!(
                "--{} {text} is in degrees, a very narrow view. Did you mean {text}rad?",
                self.option()
            )
        })
    }
}

/// [`read`] of what may not be given.
pub(super) fn optional(option: &str, text: Option<&str>, quantity: Quantity) -> Result<Option<f64>, String> {
    text.map(|text| read(option, text, quantity)).transpose()
}

/// The number in `text`, above 0, in the base unit of its quantity: pixels, radians, meters. Err: a sentence.
pub(super) fn read(option: &str, text: &str, quantity: Quantity) -> Result<f64, String> {
    let example = match quantity {
        Quantity::Pixels => "1280",
        Quantity::Degrees => "90, 90deg or 1.57rad",
        Quantity::Meters => "0.3m",
        Quantity::Millimeters => "4mm",
        Quantity::Micrometers => "3um",
        Quantity::Plain => "1.7",
    };
    if let Some((diagonal, _)) = sensor_of_type(text).filter(|_| option.starts_with("sensor-")) {
        return Err(format!(
            "--{option} {text} is the type of a sensor and no length: its diagonal is about {} mm. Give --sensor-diagonal {}mm, or better its width.",
            number((diagonal * 100.0).round() / 100.0),
            number((diagonal * 100.0).round() / 100.0)
        ));
    }
    let wrong = || format!("--{option} {text} cannot be used: give a number above 0, such as {example}.");
    let typed = number::read(text, Primes::Arcminutes).map_err(|_| wrong())?;
    let bare = match quantity {
        Quantity::Pixels | Quantity::Plain => Unit::Pixel,
        Quantity::Degrees => Unit::Angle(AngleUnit::Degree),
        Quantity::Meters => Unit::Length(LengthUnit::Meter),
        Quantity::Millimeters => Unit::Length(LengthUnit::Millimeter),
        Quantity::Micrometers => Unit::Length(LengthUnit::Micrometer),
    };
    let unit = typed.unit.unwrap_or(bare);
    let fits = std::mem::discriminant(&unit) == std::mem::discriminant(&bare) && (quantity != Quantity::Plain || typed.unit.is_none());
    let value = unit.to_base(typed.number);
    if fits && value > 0.0 && value.is_finite() {
        Ok(value)
    } else {
        Err(wrong())
    }
}
