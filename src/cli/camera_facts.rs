//! The facts that `camera` is told, each as a focal length in pixels.

use crate::core::angle::{Angle, AngleUnit};
use crate::core::camera::{
    FilmExtent, Projection, diagonal, focal_length_from_multiple, focal_length_from_pixel_pitch, focused_image_distance,
};
use crate::core::quantity::{Length, LengthUnit, Pixels};
use depth_text::number::{self, Notation, Primes};
use depth_text::unit::Unit;

/// So much may two sides of a sensor, or two facts, differ: data sheets round.
pub(super) const TOLERANCE: f64 = 0.02;
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

    /// What of the image a view is over; `None` of what is no view.
    pub(super) fn extent(self, [width, height]: [Pixels; 2]) -> Option<Pixels> {
        match self {
            Self::HorizontalView => Some(width),
            Self::VerticalView => Some(height),
            Self::DiagonalView => Some(diagonal(width, height)),
            _ => None,
        }
    }
}

/// A fact that was read.
pub(super) struct Fact {
    kind: FactKind,
    text: String,
    value: f64,
    projection: Projection,
}

/// A fact as a focal length.
pub(super) struct Known {
    kind: FactKind,
    text: String,
    focal_length: Pixels,
    /// The view that was stated, if it was one.
    pub(super) view: Option<Angle>,
}

impl Fact {
    pub(super) fn read(kind: FactKind, text: &str, projection: Projection) -> Result<Self, String> {
        Ok(Self {
            kind,
            text: text.to_owned(),
            value: read(kind.option(), text, kind.quantity())?,
            projection,
        })
    }

    /// As a focal length in an image of `size`. Err: a sentence.
    pub(super) fn focal_length(self, size: [Pixels; 2], (pitch, focused_at): (Option<Length>, Option<Length>)) -> Result<Known, String> {
        let [width, height] = size;
        let option = self.kind.option();
        let view = self.kind.extent(size).map(|_| Angle::from_radians(self.value));
        let focal_length = match self.kind {
            FactKind::Fx | FactKind::Fy => Some(Pixels::new(self.value)),
            FactKind::P00 => focal_length_from_multiple(self.value / 2.0, width),
            FactKind::P11 => focal_length_from_multiple(self.value / 2.0, height),
            FactKind::Film => FilmExtent::Diagonal.focal_length(Length::from_m(self.value), size),
            FactKind::Lens => {
                let pitch = pitch.ok_or(
                    "--lens needs the size of the pixels: add --pixel-pitch, or --sensor-width, --sensor-height or --sensor-diagonal.",
                )?;
                let lens = Length::from_m(self.value);
                let image = match focused_at {
                    None => Some(lens),
                    Some(distance) => focused_image_distance(lens, distance),
                };
                let image =
                    image.ok_or("--focused-at has to be farther away than the focal length of the lens: nearer nothing is sharp.")?;
                focal_length_from_pixel_pitch(image, pitch)
            }
            FactKind::HorizontalView | FactKind::VerticalView | FactKind::DiagonalView => self
                .kind
                .extent(size)
                .zip(view)
                .and_then(|(extent, view)| self.projection.focal_length(view, extent)),
        };
        let focal_length = focal_length.ok_or_else(|| match view {
            Some(_) => format!("--{option} {}: no {} lens has such a view.", self.text, self.projection.name()),
            None => format!("--{option} {} gives no focal length.", self.text),
        })?;
        Ok(Known {
            kind: self.kind,
            text: self.text,
            focal_length,
            view,
        })
    }

    /// fx and fy, and what is to be said of facts that exclude one another: then the first that was stated is followed. Of others the one
    /// that says it most directly is.
    pub(super) fn focal_lengths(facts: &[Known]) -> Option<([Pixels; 2], Vec<String>)> {
        let is_of_fy = |fact: &&Known| matches!(fact.kind, FactKind::Fy | FactKind::P11);
        let has_own = facts.iter().any(|fact| is_of_fy(&fact));
        let has_others = facts.iter().any(|fact| !is_of_fy(&fact) && fact.kind != FactKind::VerticalView);
        // With square pixels a vertical view says fx too.
        let is_of_rows = |fact: &&Known| is_of_fy(fact) || has_own && fact.kind == FactKind::VerticalView;
        let (of_fy, of_fx): (Vec<&Known>, Vec<&Known>) = facts.iter().partition(is_of_rows);
        let mut said = Vec::new();
        let mut follow = |name: &str, facts: &[&Known], exact: &[FactKind]| -> Option<Pixels> {
            let contradiction = Known::contradiction(name, facts);
            let is_exact = |fact: &&&Known| contradiction.is_none() && exact.contains(&fact.kind);
            let chosen = facts.iter().find(is_exact).or_else(|| facts.first())?;
            said.extend(contradiction);
            Some(chosen.focal_length)
        };
        let fy = follow("fy", &of_fy, &[FactKind::Fy, FactKind::P11]);
        let fx = follow("fx", &of_fx, &[FactKind::Fx, FactKind::P00]);
        let fx = fx.or(fy)?;
        let view = facts
            .iter()
            .find(|fact| fact.kind == FactKind::VerticalView)
            .map(|fact| fact.focal_length);
        // A vertical view beside other facts that it agrees with is fy.
        let fy = fy.or_else(|| view.filter(|view| has_others && is_near(*view, fx))).unwrap_or(fx);
        if !is_within(fy, fx, SQUARE) {
            said.push(format!(
                "fx {} px and fy {} px differ by {} %: pixels are rarely so far from square.",
                number(fx.px()),
                number(fy.px()),
                number(((fy.px() / fx.px() - 1.0).abs() * 100.0).round())
            ));
        }
        Some(([fx, fy], said))
    }

    /// That a view may be in radians, of which a number without a unit is none.
    pub(super) fn radians(&self) -> Option<String> {
        let degrees = Angle::from_radians(self.value).degrees();
        let is_bare = self.text.trim().chars().all(|one| one.is_ascii_digit() || one == '.');
        (self.kind.quantity() == Quantity::Degrees && is_bare && degrees < std::f64::consts::PI).then(|| {
            format!(
                "--{} {} is in degrees, a very narrow view. Did you mean {}rad?",
                self.kind.option(),
                self.text,
                self.text
            )
        })
    }
}

/// So far from square may pixels be: anamorphic images are farther.
const SQUARE: f64 = 0.1;

fn is_near(one: Pixels, other: Pixels) -> bool {
    is_within(one, other, TOLERANCE)
}

fn is_within(one: Pixels, other: Pixels, tolerance: f64) -> bool {
    (one.px() / other.px() - 1.0).abs() <= tolerance
}

impl Known {
    fn contradiction(name: &str, facts: &[&Self]) -> Option<String> {
        let (first, rest) = facts.split_first()?;
        let differs = |fact: &&Self| !is_near(fact.focal_length, first.focal_length);
        if !rest.iter().any(differs) {
            return None;
        }
        let say = |fact: &&Self| format!("--{} {} is {} px", fact.kind.option(), fact.text, number(fact.focal_length.px()));
        let all: Vec<String> = facts.iter().map(say).collect();
        Some(format!(
            "These exclude one another: {}. Perhaps rows or columns of the sensor were cut, or a view is that of the image before it was \
             rectified. {name} follows --{}.",
            all.join(", "),
            first.kind.option()
        ))
    }
}

/// [`read`] of what may not be given.
pub(super) fn optional(option: &str, text: Option<&str>, quantity: Quantity) -> Result<Option<f64>, String> {
    text.map(|text| read(option, text, quantity)).transpose()
}

/// The diagonal of a sensor whose type `text` is, such as 1/2.3in, in millimeters: 18 mm/N where N is above 2, else 16 mm/N.
///
/// Source: vendors' tables; an inch of these types is that of the tube of a vidicon.
fn of_type(text: &str) -> Option<f64> {
    let rest = text.trim().strip_prefix("1/")?;
    let number: String = rest.chars().take_while(|one| one.is_ascii_digit() || *one == '.').collect();
    let part: f64 = number.parse().ok().filter(|part| *part > 0.0)?;
    Some(if part > 2.0 { 18.0 / part } else { 16.0 / part })
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
    if let Some(diagonal) = of_type(text).filter(|_| option.starts_with("sensor-")) {
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
