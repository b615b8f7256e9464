//! [`Problem`] to [`Solution`], the one step.

use super::inputs::Problem;
use super::solution::{Outcome, Solution};
use crate::agreement::{self, Comparison};
use crate::field::Field;
use crate::judge::{Refusal, Unsolvable};
use crate::measured::Measured;
use crate::method::Method;
use crate::model::Model;
use crate::quantity::{Length, Pixels};
use crate::uncertainty::Uncertainty;
use crate::{monocular, stereo};

impl Problem {
    /// Everything that follows from what is known.
    ///
    /// Never fails and never holds a NaN or an infinity: what cannot be had is absent, and where the inputs of a method are
    /// complete but useless the method says [why](Outcome::Refused).
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// assert_eq!(mug.solve().stereo.distance().unwrap().m(), 1.4);
    /// ```
    pub fn solve(&self) -> Solution {
        let stereo = self.solve_method(Method::Stereo);
        let monocular = self.solve_method(Method::Monocular);
        // With the monocular distance the two widths would only repeat the input.
        let reference = stereo.distance().or(monocular.distance());
        let usable = |field| self.check(field).is_ok();
        let real_width = self.real_width.filter(|_| usable(Field::RealWidth) && usable(Field::Tilt));
        let real_width = real_width.and_then(|_| self.foreshortened_width());
        let image_width = self.image_width.filter(|_| usable(Field::ImageWidth) && usable(Field::Tilt));
        let estimated_width_px = match (self.focal_length, real_width, reference) {
            (Some(f), Some(w), Some(z)) => finite_px(monocular::width_in_image(f.value, w.value, z)),
            _ => None,
        };
        let estimated_width = match (self.focal_length, image_width, reference) {
            (Some(f), Some(w), Some(z)) => {
                finite_length(self.turned_away(Measured::exact(monocular::real_width(f.value, w.value, z))).value)
            }
            _ => None,
        };
        let uncertainty = |method, outcome: Outcome| outcome.distance().and_then(|_| self.uncertainty(method));
        let (stereo_uncertainty, unusable) = split(uncertainty(Method::Stereo, stereo));
        let (monocular_uncertainty, also_unusable) = split(uncertainty(Method::Monocular, monocular));
        let model = |method, outcome: Outcome| outcome.distance().and_then(|_| self.model(method)?.ok());
        let models = model(Method::Stereo, stereo).zip(model(Method::Monocular, monocular));
        Solution {
            problem: *self,
            stereo,
            monocular,
            estimated_width_px,
            estimated_width,
            stereo_uncertainty,
            monocular_uncertainty,
            comparison: models.map(|(stereo, monocular)| Comparison::of(&stereo, &monocular)),
            combined: models.and_then(|(stereo, monocular)| agreement::combine(&stereo, &monocular)),
            unusable_sigma: unusable.or(also_unusable),
        }
    }

    /// The stereo distance had the disparity been `shift` px larger (nearer) or smaller (farther); `None` where the object
    /// would be infinitely far away or the inputs are incomplete.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// // 70/(50 + 20).
    /// assert_eq!(mug.stereo_distance_if(20.0).unwrap().m(), 1.0);
    /// assert_eq!(mug.stereo_distance_if(-50.0), None);
    /// ```
    pub fn stereo_distance_if(&self, shift: f64) -> Option<Length> {
        self.depth_at(Pixels::new(self.effective_disparity()?.px() + shift))
    }

    /// The depth f·b/d that this pair of cameras gives at another [effective disparity](Self::effective_disparity), d + δ, in pixels;
    /// `None` unless that is positive, focal length and baseline are known, and the depth is a finite, normal number.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// use depth_core::quantity::Pixels;
    ///
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// // 700 px · 0.1 m / 1 px.
    /// assert_eq!(mug.depth_at(Pixels::new(1.0)).unwrap().m(), 70.0);
    /// assert_eq!(mug.depth_at(Pixels::new(0.0)), None);
    /// ```
    ///
    /// Source: [`stereo::depth`].
    pub fn depth_at(&self, disparity: Pixels) -> Option<Length> {
        if disparity.px() <= 0.0 {
            return None;
        }
        finite_length(stereo::depth(self.focal_length?.value, self.baseline?.value, disparity))
    }

    /// The monocular distance if the target faced the camera, w_real·fx/w_img; `None` where it does, or where that has no distance.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut door = Problem::default();
    /// door.set(Field::FocalLength, Some(1000.0));
    /// door.set(Field::RealWidth, Some(0.9));
    /// door.set(Field::ImageWidth, Some(100.0));
    /// assert_eq!(door.distance_if_facing(), None);
    /// door.set(Field::Tilt, Some(60_f64.to_radians()));
    /// // 4.5 m with the tilt.
    /// assert_eq!(door.distance_if_facing().unwrap().m(), 9.0);
    /// ```
    ///
    /// Source: [`monocular::depth`].
    pub fn distance_if_facing(&self) -> Option<Length> {
        let tilt = self.tilt?;
        let facing = Self { tilt: None, ..*self };
        facing.solve_method(Method::Monocular).distance().filter(|_| tilt.radians() != 0.0)
    }

    /// The inputs of `method` with their σ, as one model.
    pub(super) fn model(&self, method: Method) -> Option<Result<Model, Unsolvable>> {
        let focal_length = self.focal_length?;
        Some(match method {
            Method::Stereo => Model::stereo(focal_length, self.baseline?, self.disparity?, self.offset()),
            Method::Monocular => Model::monocular(focal_length, self.foreshortened_width()?, self.image_width?),
        })
    }

    /// How sure one can be of the distance of `method`; `None` where no input has a σ. The error names the input whose σ is
    /// out of all proportion.
    fn uncertainty(&self, method: Method) -> Option<Result<Uncertainty, Field>> {
        match self.model(method)? {
            Ok(model) if model.relative_sigma() == 0.0 => None,
            Ok(model) => Some(Ok(Uncertainty::new(model))),
            Err(_) => Some(Err(self.least_certain(method))),
        }
    }

    /// The input of `method` with the largest σ for its value.
    fn least_certain(&self, method: Method) -> Field {
        let relative = |field: Field| {
            let value = match field {
                Field::Disparity | Field::Doffs => self.effective_disparity().map(Pixels::px),
                _ => self.get(field),
            };
            value.map_or(0.0, |value| Measured::new(value, self.sigma(field)).relative())
        };
        let [first, others @ ..] = method.fields();
        others
            .into_iter()
            .chain([method.optional_field()])
            .fold(first, |worst, field| if relative(field) > relative(worst) { field } else { worst })
    }

    fn solve_method(&self, method: Method) -> Outcome {
        for field in std::iter::once(method.optional_field()).chain(method.fields()) {
            if let Err(refusal) = self.check(field) {
                return Outcome::Refused { field, refusal };
            }
        }
        let distance = match method {
            Method::Stereo => match (self.focal_length, self.baseline, self.effective_disparity()) {
                (Some(f), Some(b), Some(d)) => stereo::depth(f.value, b.value, d),
                _ => return Outcome::Incomplete,
            },
            Method::Monocular => match (self.focal_length, self.foreshortened_width(), self.image_width) {
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

fn split(uncertainty: Option<Result<Uncertainty, Field>>) -> (Option<Uncertainty>, Option<Field>) {
    match uncertainty {
        Some(Ok(uncertainty)) => (Some(uncertainty), None),
        Some(Err(field)) => (None, Some(field)),
        None => (None, None),
    }
}

fn finite_length(length: Length) -> Option<Length> {
    length.m().is_normal().then_some(length)
}

fn finite_px(pixels: Pixels) -> Option<Pixels> {
    pixels.px().is_normal().then_some(pixels)
}
