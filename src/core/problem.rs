//! [`Problem`] (what is known) to [`Solution`] (everything that follows from it). Every screen, the command line, links and
//! reports go through this one step, so that they cannot disagree.

use super::quantity::{Length, LengthUnit, Pixels};
use super::{monocular, stereo};
use serde::{Deserialize, Serialize};

/// One of the five inputs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Field {
    /// fx, px
    FocalLength,
    /// b, a length
    Baseline,
    /// d, px
    Disparity,
    /// w_img, px
    ImageWidth,
    /// w_real, a length
    RealWidth,
}

impl Field {
    /// Every field, in reading order.
    pub const ALL: [Self; 5] = [
        Self::FocalLength,
        Self::Baseline,
        Self::Disparity,
        Self::ImageWidth,
        Self::RealWidth,
    ];

    /// The name people and tests look for.
    pub const fn name(self) -> &'static str {
        match self {
            Self::FocalLength => "Focal length (fx)",
            Self::Baseline => "Camera baseline (b)",
            Self::Disparity => "Disparity (d)",
            Self::ImageWidth => "Object width in image (w_img)",
            Self::RealWidth => "Object real width (w_real)",
        }
    }

    /// The symbol in the formulas.
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::FocalLength => "fx",
            Self::Baseline => "b",
            Self::Disparity => "d",
            Self::ImageWidth => "w_img",
            Self::RealWidth => "w_real",
        }
    }

    /// Whether the field is a length (with a choice of unit) rather than a number of pixels.
    pub const fn is_length(self) -> bool {
        matches!(self, Self::Baseline | Self::RealWidth)
    }

    /// The range outside which a value deserves a warning, in px or metres.
    ///
    /// Wide on purpose: the presets of real cameras lie far inside; a value outside is nearly always a slip of the unit.
    pub const fn usual_range(self) -> (f64, f64) {
        match self {
            Self::FocalLength => (50.0, 20_000.0),
            Self::Baseline => (0.005, 5.0),
            Self::Disparity => (0.5, 1000.0),
            Self::ImageWidth => (5.0, 5000.0),
            Self::RealWidth => (0.005, 50.0),
        }
    }

    /// Whether `value` (px or metres) lies in the [usual range](Self::usual_range), its ends included.
    pub fn is_usual(self, value: f64) -> bool {
        let (low, high) = self.usual_range();
        (low..=high).contains(&value)
    }

    /// Checks that `value` (px or metres) can be used at all: positive, finite and normal.
    pub fn check(self, value: f64) -> Result<(), Refusal> {
        if value.is_nan() {
            Err(Refusal::NotANumber)
        } else if value == 0.0 {
            Err(Refusal::Zero)
        } else if value < 0.0 {
            Err(Refusal::Negative)
        } else if !value.is_normal() {
            Err(Refusal::TooExtreme)
        } else {
            Ok(())
        }
    }
}

/// The two ways to a distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Method {
    /// Two cameras: D = fx·b/d.
    Stereo,
    /// One camera and an object of known width: D = w_real·fx/w_img.
    Monocular,
}

impl Method {
    /// Both, stereo first.
    pub const ALL: [Self; 2] = [Self::Stereo, Self::Monocular];

    /// The inputs of the method, in reading order.
    pub const fn fields(self) -> [Field; 3] {
        match self {
            Self::Stereo => [Field::FocalLength, Field::Baseline, Field::Disparity],
            Self::Monocular => [Field::FocalLength, Field::ImageWidth, Field::RealWidth],
        }
    }

    /// The inputs that only this method uses: filling one of them means that the person wants this method.
    pub const fn own_fields(self) -> [Field; 2] {
        match self {
            Self::Stereo => [Field::Baseline, Field::Disparity],
            Self::Monocular => [Field::ImageWidth, Field::RealWidth],
        }
    }

    /// "Stereo" or "Monocular".
    pub const fn name(self) -> &'static str {
        match self {
            Self::Stereo => "Stereo",
            Self::Monocular => "Monocular",
        }
    }

    /// The formula with its symbols.
    pub const fn formula(self) -> &'static str {
        match self {
            Self::Stereo => "D = fx · b / d",
            Self::Monocular => "D = w_real · fx / w_img",
        }
    }
}

/// Why a value cannot be used.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Refusal {
    /// NaN.
    NotANumber,
    /// Zero. For a disparity: the object is infinitely far away.
    Zero,
    /// Below zero. For a disparity: left and right may be swapped.
    Negative,
    /// Infinite or subnormal, by itself or in the distance that would follow.
    TooExtreme,
}

/// What is known: the inputs, checked one by one where they were read.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Problem {
    /// fx: focal length in pixels of the image that d and w_img are measured in.
    pub focal_length: Option<Pixels>,
    /// b: distance between the optical centres of the two cameras.
    pub baseline: Option<Length>,
    /// d: horizontal shift of the object between the rectified images.
    pub disparity: Option<Pixels>,
    /// w_img: width of the object in the image.
    pub image_width: Option<Pixels>,
    /// w_real: width of the object itself.
    pub real_width: Option<Length>,
}

impl Problem {
    /// The value of `field` in its base unit (px or metres).
    pub fn get(&self, field: Field) -> Option<f64> {
        match field {
            Field::FocalLength => self.focal_length.map(Pixels::px),
            Field::Baseline => self.baseline.map(Length::m),
            Field::Disparity => self.disparity.map(Pixels::px),
            Field::ImageWidth => self.image_width.map(Pixels::px),
            Field::RealWidth => self.real_width.map(Length::m),
        }
    }

    /// Sets `field` to `value` in its base unit (px or metres).
    pub fn set(&mut self, field: Field, value: Option<f64>) {
        match field {
            Field::FocalLength => self.focal_length = value.map(Pixels::new),
            Field::Baseline => self.baseline = value.map(Length::from_m),
            Field::Disparity => self.disparity = value.map(Pixels::new),
            Field::ImageWidth => self.image_width = value.map(Pixels::new),
            Field::RealWidth => self.real_width = value.map(Length::from_m),
        }
    }

    /// Everything that follows from what is known.
    ///
    /// Never fails and never holds a NaN or an infinity: what cannot be had is absent, and where the inputs of a method are
    /// complete but useless the method says [why](Outcome::Refused).
    pub fn solve(&self) -> Solution {
        let stereo = self.solve_method(Method::Stereo);
        let monocular = self.solve_method(Method::Monocular);
        // With the monocular distance the two widths would only repeat the input.
        let reference = stereo.distance().or(monocular.distance());
        let estimated_width_px = match (self.focal_length, self.real_width, reference) {
            (Some(f), Some(w), Some(z)) => finite_px(monocular::width_in_image(f, w, z)),
            _ => None,
        };
        let estimated_width = match (self.focal_length, self.image_width, reference) {
            (Some(f), Some(w), Some(z)) => finite_length(monocular::real_width(f, w, z)),
            _ => None,
        };
        Solution {
            problem: *self,
            stereo,
            monocular,
            estimated_width_px,
            estimated_width,
        }
    }

    /// The stereo distance had the disparity been `shift` px larger (nearer) or smaller (farther); `None` where the object
    /// would be infinitely far away or the inputs are incomplete.
    pub fn stereo_distance_if(&self, shift: f64) -> Option<Length> {
        let disparity = self.disparity?.px() + shift;
        if disparity <= 0.0 {
            return None;
        }
        finite_length(stereo::depth(self.focal_length?, self.baseline?, Pixels::new(disparity)))
    }

    fn solve_method(&self, method: Method) -> Outcome {
        let distance = match method {
            Method::Stereo => match (self.focal_length, self.baseline, self.disparity) {
                (Some(f), Some(b), Some(d)) => stereo::depth(f, b, d),
                _ => return Outcome::Incomplete,
            },
            Method::Monocular => match (self.focal_length, self.real_width, self.image_width) {
                (Some(f), Some(w), Some(p)) => monocular::depth(f, w, p),
                _ => return Outcome::Incomplete,
            },
        };
        for field in method.fields() {
            if let Some(Err(refusal)) = self.get(field).map(|value| field.check(value)) {
                return Outcome::Refused { field, refusal };
            }
        }
        match finite_length(distance) {
            Some(distance) => Outcome::Distance(distance),
            None => Outcome::Refused {
                field: self.least_usual(method),
                refusal: Refusal::TooExtreme,
            },
        }
    }

    /// The input of `method` that lies furthest, in orders of magnitude, outside its usual range.
    fn least_usual(&self, method: Method) -> Field {
        let strangeness = |field: Field| {
            let (low, high) = field.usual_range();
            self.get(field)
                .map_or(0.0, |v| (low.ln() - v.ln()).max(v.ln() - high.ln()).max(0.0))
        };
        let [first, second, third] = method.fields();
        [second, third].into_iter().fold(
            first,
            |worst, field| {
                if strangeness(field) > strangeness(worst) { field } else { worst }
            },
        )
    }
}

/// What came of one method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Outcome {
    /// An input is missing or was not readable.
    Incomplete,
    /// The distance: finite, normal and positive.
    Distance(Length),
    /// Complete, but no distance can be given; `field` is the input to look at.
    Refused {
        /// The input to blame.
        field: Field,
        /// Why.
        refusal: Refusal,
    },
}

impl Outcome {
    /// The distance, where there is one.
    pub const fn distance(self) -> Option<Length> {
        match self {
            Self::Distance(distance) => Some(distance),
            Self::Incomplete | Self::Refused { .. } => None,
        }
    }
}

/// Everything computed from a [`Problem`]; made once when the inputs change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    /// What it was computed from.
    pub problem: Problem,
    /// D = fx·b/d.
    pub stereo: Outcome,
    /// D = w_real·fx/w_img.
    pub monocular: Outcome,
    /// w_real·fx/D, with the stereo distance whenever there is one.
    pub estimated_width_px: Option<Pixels>,
    /// w_img·D/fx, with the stereo distance whenever there is one.
    pub estimated_width: Option<Length>,
}

impl Solution {
    /// The outcome of `method`.
    pub const fn outcome(&self, method: Method) -> Outcome {
        match method {
            Method::Stereo => self.stereo,
            Method::Monocular => self.monocular,
        }
    }

    /// The stereo distances with the disparity one pixel larger (nearer) and one smaller; the second is `None` where the
    /// object would be infinitely far away. `None` as a whole without a stereo distance.
    pub fn one_pixel_around(&self) -> Option<(Length, Option<Length>)> {
        self.stereo.distance()?;
        Some((self.problem.stereo_distance_if(1.0)?, self.problem.stereo_distance_if(-1.0)))
    }

    /// How far the entered image width is off what the stereo distance and the real width predict, as a fraction of the
    /// prediction: w_img / (w_real·fx/D) − 1. `None` unless both methods have a distance; the same figure holds for the
    /// real width.
    ///
    /// With both distances known it equals D_stereo/D_monocular − 1.
    pub fn width_discrepancy(&self) -> Option<f64> {
        let ratio = self.stereo.distance()?.m() / self.monocular.distance()?.m();
        Some(ratio - 1.0).filter(|r| r.is_finite())
    }
}

/// The first unit in which `typed` would be a usual value of `field`, if it is not one in the unit it was typed in.
pub fn better_unit(field: Field, typed: f64, unit: LengthUnit) -> Option<LengthUnit> {
    const LIKELIEST_FIRST: [LengthUnit; 5] = [
        LengthUnit::Metre,
        LengthUnit::Millimetre,
        LengthUnit::Centimetre,
        LengthUnit::Inch,
        LengthUnit::Foot,
    ];
    let usual = |unit| field.is_usual(Length::new(typed, unit).m());
    if !field.is_length() || usual(unit) {
        return None;
    }
    LIKELIEST_FIRST.into_iter().find(|&candidate| usual(candidate))
}

fn finite_length(length: Length) -> Option<Length> {
    length.m().is_normal().then_some(length)
}

fn finite_px(pixels: Pixels) -> Option<Pixels> {
    pixels.px().is_normal().then_some(pixels)
}
