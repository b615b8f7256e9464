//! [`Problem`] (what is known) to [`Solution`] (everything that follows from it). Every screen, the command line, links and
//! reports go through this one step, so that they cannot disagree.

pub use crate::field::{Field, better_unit};
pub use crate::judge::Refusal;
use crate::judge::Unsolvable;
use crate::measured::Measured;
use crate::quantity::{Length, Pixels, Quantity};
use crate::uncertainty::{Budget, Interval, Model, Share};
use crate::{agreement, judge, monocular, stereo};

/// The two ways to a distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
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

/// What is known: the inputs with their σ (0 where none was given).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Problem {
    /// fx: focal length in pixels of the image that d and w_img are measured in.
    pub focal_length: Option<Measured<Pixels>>,
    /// b: distance between the optical centres of the two cameras.
    pub baseline: Option<Measured<Length>>,
    /// d: horizontal shift of the object between the rectified images.
    pub disparity: Option<Measured<Pixels>>,
    /// δ = cx_right − cx_left; `None` is 0.
    pub doffs: Option<Measured<Pixels>>,
    /// σ of the offset of 0 where [`doffs`](Self::doffs) is `None`: how well the principal points are known to coincide.
    pub coincidence_sigma: Pixels,
    /// w_img: width of the object in the image.
    pub image_width: Option<Measured<Pixels>>,
    /// w_real: width of the object itself.
    pub real_width: Option<Measured<Length>>,
}

impl Default for Problem {
    /// Nothing is known.
    fn default() -> Self {
        Self {
            focal_length: None,
            baseline: None,
            disparity: None,
            doffs: None,
            coincidence_sigma: Pixels::ZERO,
            image_width: None,
            real_width: None,
        }
    }
}

impl Problem {
    /// The value of `field` in its base unit (px or metres).
    pub fn get(&self, field: Field) -> Option<f64> {
        self.measured(field).map(|input| input.value)
    }

    /// Sets `field` to `value` in its base unit (px or metres). Its σ stays; without a value there is none, but that of doffs.
    pub fn set(&mut self, field: Field, value: Option<f64>) {
        let sigma = self.sigma(field);
        match field {
            Field::FocalLength => self.focal_length = value.map(|value| Measured::from_base(value, sigma)),
            Field::Baseline => self.baseline = value.map(|value| Measured::from_base(value, sigma)),
            Field::Disparity => self.disparity = value.map(|value| Measured::from_base(value, sigma)),
            Field::Doffs => {
                self.doffs = value.map(|value| Measured::from_base(value, sigma));
                self.coincidence_sigma = if value.is_none() { Pixels::new(sigma) } else { Pixels::ZERO };
            }
            Field::ImageWidth => self.image_width = value.map(|value| Measured::from_base(value, sigma)),
            Field::RealWidth => self.real_width = value.map(|value| Measured::from_base(value, sigma)),
        }
    }

    /// σ of `field` in its base unit (px or metres): 0 where none was given. That of doffs without a value belongs to an
    /// offset of 0.
    pub fn sigma(&self, field: Field) -> f64 {
        match (field, self.measured(field)) {
            (_, Some(input)) => input.sigma,
            (Field::Doffs, None) => self.coincidence_sigma.px(),
            (_, None) => 0.0,
        }
    }

    /// Sets σ of `field` in its base unit (px or metres), 0 for none. Without a value only doffs can have one.
    pub fn set_sigma(&mut self, field: Field, sigma: f64) {
        fn give<Q: Quantity>(input: &mut Option<Measured<Q>>, sigma: f64) {
            if let Some(input) = input {
                input.sigma = Q::from_base(sigma);
            }
        }
        match field {
            Field::FocalLength => give(&mut self.focal_length, sigma),
            Field::Baseline => give(&mut self.baseline, sigma),
            Field::Disparity => give(&mut self.disparity, sigma),
            Field::Doffs if self.doffs.is_none() => self.coincidence_sigma = Pixels::new(sigma),
            Field::Doffs => give(&mut self.doffs, sigma),
            Field::ImageWidth => give(&mut self.image_width, sigma),
            Field::RealWidth => give(&mut self.real_width, sigma),
        }
    }

    /// The same inputs, taken to be exact.
    #[must_use]
    pub fn without_sigmas(mut self) -> Self {
        for field in Field::ALL {
            self.set_sigma(field, 0.0);
        }
        self
    }

    /// The value of `field` with its σ, in its base unit (px or metres).
    pub fn measured(&self, field: Field) -> Option<Measured<f64>> {
        match field {
            Field::FocalLength => self.focal_length.map(Measured::to_base),
            Field::Baseline => self.baseline.map(Measured::to_base),
            Field::Disparity => self.disparity.map(Measured::to_base),
            Field::Doffs => self.doffs.map(Measured::to_base),
            Field::ImageWidth => self.image_width.map(Measured::to_base),
            Field::RealWidth => self.real_width.map(Measured::to_base),
        }
    }

    /// δ with its σ, as it enters the formula: 0 where none was given.
    pub fn offset(&self) -> Measured<Pixels> {
        self.doffs.unwrap_or(Measured::new(Pixels::ZERO, self.coincidence_sigma))
    }

    /// d + δ: the disparity as it enters the formula. Its sign decides whether the object is in front of the cameras.
    pub fn effective_disparity(&self) -> Option<Pixels> {
        Some(Pixels::new(self.disparity?.value.px() + self.offset().value.px()))
    }

    /// Checks that the value of `field`, if it has one, can be used: positive, finite and normal. A disparity is judged
    /// together with doffs, which itself may be any finite number.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn check(&self, field: Field) -> Result<(), Refusal> {
        let value = match field {
            Field::Disparity => self.effective_disparity().map(Pixels::px),
            _ => self.get(field),
        };
        match (field, value) {
            (_, None) => Ok(()),
            (Field::Doffs, Some(value)) => judge::finite(value).map(|_| ()),
            (_, Some(value)) => judge::positive(value).map(|_| ()),
        }
    }

    /// Whether the value of `field` lies in its [usual range](Field::usual_range); true where there is none.
    pub fn is_usual(&self, field: Field) -> bool {
        let value = match field {
            Field::Disparity => self.effective_disparity().map(Pixels::px),
            _ => self.get(field),
        };
        value.is_none_or(|value| field.is_usual(value))
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
            (Some(f), Some(w), Some(z)) => finite_px(monocular::width_in_image(f.value, w.value, z)),
            _ => None,
        };
        let estimated_width = match (self.focal_length, self.image_width, reference) {
            (Some(f), Some(w), Some(z)) => finite_length(monocular::real_width(f.value, w.value, z)),
            _ => None,
        };
        let uncertainty = |method, outcome: Outcome| outcome.distance().and_then(|_| self.uncertainty(method));
        let (stereo_uncertainty, unusable) = split(uncertainty(Method::Stereo, stereo));
        let (monocular_uncertainty, also_unusable) = split(uncertainty(Method::Monocular, monocular));
        let comparison = match (&stereo_uncertainty, &monocular_uncertainty) {
            (Some(stereo), Some(monocular)) => Some(Comparison {
                combined: agreement::combine(&stereo.model, &monocular.model),
                agreement: agreement::compare(&stereo.model, &monocular.model),
            }),
            _ => None,
        };
        Solution {
            problem: *self,
            stereo,
            monocular,
            estimated_width_px,
            estimated_width,
            stereo_uncertainty,
            monocular_uncertainty,
            comparison,
            unusable_sigma: unusable.or(also_unusable),
        }
    }

    /// The stereo distance had the disparity been `shift` px larger (nearer) or smaller (farther); `None` where the object
    /// would be infinitely far away or the inputs are incomplete.
    pub fn stereo_distance_if(&self, shift: f64) -> Option<Length> {
        let disparity = self.effective_disparity()?.px() + shift;
        if disparity <= 0.0 {
            return None;
        }
        finite_length(stereo::depth(
            self.focal_length?.value,
            self.baseline?.value,
            Pixels::new(disparity),
        ))
    }

    /// The inputs of `method` with their σ, as one model.
    fn model(&self, method: Method) -> Option<Result<Model, Unsolvable>> {
        let focal_length = self.focal_length?;
        Some(match method {
            Method::Stereo => Model::stereo(focal_length, self.baseline?, self.disparity?, self.offset()),
            Method::Monocular => Model::monocular(focal_length, self.real_width?, self.image_width?),
        })
    }

    /// How sure one can be of the distance of `method`; `None` where no input has a σ. The error names the input whose σ is
    /// out of all proportion.
    fn uncertainty(&self, method: Method) -> Option<Result<Uncertainty, Field>> {
        match self.model(method)? {
            Ok(model) if model.relative_sigma() == 0.0 => None,
            Ok(model) => Some(Ok(Uncertainty::new(model))),
            Err(unsolvable) => Some(Err(unsolvable.field().unwrap_or_else(|| self.least_certain(method)))),
        }
    }

    /// The input of `method` with the largest σ for its value.
    fn least_certain(&self, method: Method) -> Field {
        let relative = |field: Field| self.measured(field).map_or(0.0, Measured::relative);
        let [first, others @ ..] = method.fields();
        others
            .into_iter()
            .fold(first, |worst, field| if relative(field) > relative(worst) { field } else { worst })
    }

    fn solve_method(&self, method: Method) -> Outcome {
        for field in method.fields() {
            if let Err(refusal) = self.check(field) {
                return Outcome::Refused { field, refusal };
            }
        }
        let distance = match method {
            Method::Stereo => match (self.focal_length, self.baseline, self.effective_disparity()) {
                (Some(f), Some(b), Some(d)) => stereo::depth(f.value, b.value, d),
                _ => return Outcome::Incomplete,
            },
            Method::Monocular => match (self.focal_length, self.real_width, self.image_width) {
                (Some(f), Some(w), Some(p)) => monocular::depth(f.value, w.value, p.value),
                _ => return Outcome::Incomplete,
            },
        };
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

/// How sure one can be of a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uncertainty {
    /// The inputs with their σ.
    pub model: Model,
    /// σ of the distance to first order.
    pub sigma: Length,
    /// The 1 σ interval without linearisation.
    pub interval: Interval,
    /// Which input causes which part of the variance; adds to 1.
    pub budget: Budget,
    /// How much too far the average of many such distances comes out; `None` where that cannot be said.
    pub bias: Option<Length>,
}

impl Uncertainty {
    fn new(model: Model) -> Self {
        Self {
            sigma: model.depth_with_sigma().sigma,
            interval: model.interval(),
            budget: model.variance_budget(),
            bias: model.bias(),
            model,
        }
    }

    /// The input that causes the largest part of the variance.
    pub fn main_cause(&self) -> Option<Share> {
        self.budget.iter().copied().max_by(|a, b| a.share.total_cmp(&b.share))
    }
}

/// What two distances with σ say together.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// Both combined; `None` where only the shared focal length has a σ, so that nothing weighs them.
    pub combined: Option<Measured<Length>>,
    /// Whether they agree; if not, [`Solution::suspects`] says what to look at.
    pub agreement: agreement::Agreement,
}

fn split(uncertainty: Option<Result<Uncertainty, Field>>) -> (Option<Uncertainty>, Option<Field>) {
    match uncertainty {
        Some(Ok(uncertainty)) => (Some(uncertainty), None),
        Some(Err(field)) => (None, Some(field)),
        None => (None, None),
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
    /// How sure one can be of the stereo distance; `None` where no input has a σ.
    pub stereo_uncertainty: Option<Uncertainty>,
    /// How sure one can be of the monocular distance; `None` where no input has a σ.
    pub monocular_uncertainty: Option<Uncertainty>,
    /// What both say together; `None` unless both are known with σ.
    pub comparison: Option<Comparison>,
    /// An input whose σ is out of all proportion to its value, so that nothing can be said.
    pub unusable_sigma: Option<Field>,
}

impl Solution {
    /// The outcome of `method`.
    pub const fn outcome(&self, method: Method) -> Outcome {
        match method {
            Method::Stereo => self.stereo,
            Method::Monocular => self.monocular,
        }
    }

    /// How sure one can be of the distance of `method`.
    pub const fn uncertainty(&self, method: Method) -> Option<&Uncertainty> {
        match method {
            Method::Stereo => self.stereo_uncertainty.as_ref(),
            Method::Monocular => self.monocular_uncertainty.as_ref(),
        }
    }

    /// What to look at where both distances disagree, likeliest first; empty where they agree. Worked out on demand, because
    /// few want it: [`agreement::suspects`].
    pub fn suspects(&self) -> Vec<agreement::Suspect> {
        match (&self.stereo_uncertainty, &self.monocular_uncertainty) {
            (Some(stereo), Some(monocular)) => agreement::suspects(&stereo.model, &monocular.model),
            _ => Vec::new(),
        }
    }

    /// The stereo distances with the disparity one pixel larger (nearer) and one smaller; the second is `None` where the
    /// object would be infinitely far away. `None` as a whole without a stereo distance.
    pub fn one_pixel_range(&self) -> Option<(Length, Option<Length>)> {
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

fn finite_length(length: Length) -> Option<Length> {
    length.m().is_normal().then_some(length)
}

fn finite_px(pixels: Pixels) -> Option<Pixels> {
    pixels.px().is_normal().then_some(pixels)
}
