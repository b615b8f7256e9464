//! [`Problem`] to [`Solution`], the one step.

use super::inputs::Problem;
use super::solution::{Outcome, Solution};
use crate::agreement::{self, Comparison};
use crate::field::Field;
use crate::in_image::InImage;
use crate::judge::{Refusal, Term, Unsolvable};
use crate::measured::Measured;
use crate::method::Method;
use crate::model::Model;
use crate::projected::Projected;
use crate::quantity::{Length, Pixels, Quantity as _};
use crate::setup::Object;
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
        let models = Method::ALL.map(|method| self.exact_model(method));
        // With the monocular distance the two widths would only repeat the input.
        let reference = models.into_iter().flatten().next();
        let estimated_width_px = reference.and_then(|reference| self.estimated_width_px(&reference));
        let estimated_width = reference.and_then(|reference| self.estimated_width(&reference));
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

    /// w_img that w_real and the distance of `reference` predict, where the image is in pixels.
    fn estimated_width_px(&self, reference: &Model) -> Option<Pixels> {
        let usable = |field| self.check(field).is_ok();
        let focal_length = self.focal_length_of(Method::Monocular)?.px()?.value;
        let width = self
            .foreshortened_width()
            .filter(|_| usable(Field::RealWidth) && usable(Field::Tilt))?
            .value;
        let mut depth = reference.projected_depth();
        if self.object == Object::Ball {
            depth = monocular::depth_of_disk(depth, width)?;
        }
        finite_px(monocular::width_in_image(focal_length, width, depth))
    }

    /// w_real that w_img and the distance of `reference` predict.
    fn estimated_width(&self, reference: &Model) -> Option<Length> {
        let usable = |field| self.check(field).is_ok();
        let extent = self.image_width.filter(|_| usable(Field::ImageWidth) && usable(Field::Tilt))?;
        let projected = Projected::new(self.focal_length_of(Method::Monocular).unwrap_or(extent), extent, Field::ImageWidth).ok()?;
        let [focal_length, extent] = [projected.focal_length, projected.extent].map(|number| Pixels::new(number.value));
        let depth = reference.projected_depth();
        let width = match self.object {
            Object::Ball => monocular::diameter(focal_length, extent, depth),
            Object::Width | Object::Height => monocular::real_width(focal_length, extent, depth),
        };
        finite_length(self.turned_away(Measured::exact(width)).value)
    }

    /// The stereo distance had the disparity been `shift` px larger (nearer) or smaller (farther); `None` where the object
    /// would be infinitely far away or the inputs are incomplete or not in pixels.
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
        let focal_length = self.focal_length_of(Method::Stereo)?.px()?.value;
        let depth = finite_length(stereo::depth(focal_length, self.baseline?.value, disparity))?;
        let counted = depth.m() + self.counted_from(true).m();
        finite_length(Length::from_m(counted)).filter(|counted| counted.m() > 0.0)
    }

    /// What is added to a distance from the center of projection where the image is in pixels: the focal length of the lens less where
    /// zero is.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut camera = Problem::default();
    /// camera.set(Field::Zero, Some(0.25));
    /// assert_eq!(camera.shift().m(), -0.25);
    /// ```
    pub fn shift(&self) -> Length {
        self.counted_from(true)
    }

    /// What is added to a distance from the center of projection, f of the lens − zero; without that of the lens where the image is
    /// not `in_pixels`.
    pub(crate) fn counted_from(&self, in_pixels: bool) -> Length {
        let lens = self.lens.filter(|_| in_pixels).map_or(0.0, Length::m);
        Length::from_m(lens - self.zero.map_or(0.0, Length::m))
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
        let tilt = self.tilt.filter(|_| self.object != Object::Ball)?;
        let facing = Self { tilt: None, ..*self };
        facing.solve_method(Method::Monocular).distance().filter(|_| tilt.radians() != 0.0)
    }

    /// The inputs of `method` with their σ, as one model; `None` where one is missing.
    pub(crate) fn model(&self, method: Method) -> Option<Result<Model, Unsolvable>> {
        let projected = self.projected(method)?;
        let length = match method {
            Method::Stereo => self.baseline?,
            Method::Monocular => self.foreshortened_width()?,
        };
        Some(projected.and_then(|projected| self.model_of(method, projected, length).checked()))
    }

    /// The extent of `method` and its focal length; `None` where one is missing.
    pub(super) fn projected(&self, method: Method) -> Option<Result<Projected, Unsolvable>> {
        let (extent, source) = match method {
            Method::Stereo => (self.disparity?, Field::Disparity),
            Method::Monocular => (self.image_width?, Field::ImageWidth),
        };
        let focal_length = match (self.focal_length_of(method), extent) {
            (Some(focal_length), _) => focal_length,
            (None, InImage::Angle(_)) => extent,
            (None, _) => return None,
        };
        Some(match (method, extent) {
            // The offset of the principal points is in pixels.
            (Method::Stereo, InImage::OnSensor(_) | InImage::Angle(_)) if self.offset() != Measured::exact(Pixels::new(0.0)) => {
                Err(Unsolvable::Value {
                    term: Term::Input(Field::Doffs),
                    refusal: Refusal::OtherUnit,
                })
            }
            _ => Projected::new(focal_length, extent, source),
        })
    }

    pub(super) fn model_of(&self, method: Method, projected: Projected, length: Measured<Length>) -> Model {
        let model = Model::unchecked(method, projected, length);
        let model = match method {
            Method::Stereo => model.with_doffs(self.offset().to_base()),
            Method::Monocular if self.object == Object::Ball => model.of_ball(),
            Method::Monocular => model,
        };
        let has_own_fy = self.needs_fy(method) && self.fy.is_some_and(|fy| fy.relative() > 0.0);
        let model = if has_own_fy { model.with_fy() } else { model };
        let lens = self.lens.filter(|_| projected.is_in_pixels);
        model.counted(lens.unwrap_or(Length::ZERO), self.zero.unwrap_or(Length::ZERO))
    }

    /// The model of `method` with its inputs taken to be exact, where it has a distance.
    fn exact_model(&self, method: Method) -> Option<Model> {
        self.solve_method(method).distance()?;
        self.without_sigmas().model(method)?.ok()
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
            let effective = self.effective_disparity().map(Pixels::px);
            let value = match field {
                Field::Disparity | Field::Doffs => effective.or(self.get(Field::Disparity)),
                _ => self.get(field),
            };
            value.map_or(0.0, |value| Measured::new(value, self.sigma(field)).relative())
        };
        let [first, others @ ..] = method.fields();
        others
            .into_iter()
            .chain([method.own_optional_field()])
            .fold(first, |worst, field| if relative(field) > relative(worst) { field } else { worst })
    }

    fn solve_method(&self, method: Method) -> Outcome {
        for field in method.optional_fields().into_iter().chain(method.fields()) {
            if let Err(refusal) = self.check(field) {
                return Outcome::Refused { field, refusal };
            }
        }
        match self.without_sigmas().model(method) {
            None => Outcome::Incomplete,
            Some(Ok(model)) => Outcome::Distance(model.depth()),
            Some(Err(Unsolvable::Value {
                term: Term::Input(field),
                refusal,
            })) => Outcome::Refused { field, refusal },
            Some(Err(_)) => Outcome::Refused {
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
