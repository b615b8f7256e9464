//! [`Solution`]: everything that follows from a [`Problem`].

use super::inputs::Problem;
use crate::agreement::{self, Comparison, Suspect};
use crate::field::Field;
use crate::judge::Refusal;
use crate::measured::Measured;
use crate::method::Method;
use crate::model::Model;
use crate::quantity::{Length, Pixels};
use crate::uncertainty::{Interval, Uncertainty};

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
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// assert_eq!(mug.solve().stereo.distance().unwrap().m(), 1.4);
    /// ```
    pub const fn distance(self) -> Option<Length> {
        match self {
            Self::Distance(distance) => Some(distance),
            Self::Incomplete | Self::Refused { .. } => None,
        }
    }
}

/// The part of a distance from which on the focal length of the lens in it is worth a word: 1 %.
pub const NOTABLE_LENS: f64 = 0.01;

/// Where a distance is from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Origin {
    /// One of the two methods.
    Method(Method),
    /// Both, combined.
    Combined,
}

/// The distance to use, with its σ but for what the focal length has in it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BestDistance {
    /// Where it is from.
    pub origin: Origin,
    /// The distance with its own σ: [`own_relative_sigma`](crate::uncertainty::Model::own_relative_sigma).
    pub distance: Measured<Length>,
    /// Whether it grows with fx, so that its σ has a part that is not in `distance`. That of an angle does not, nor what has an fy
    /// with a σ of its own.
    pub has_focal_length: bool,
    /// What of it is no distance from the center of projection: the focal length of the lens less where zero is.
    pub shift: Length,
}

/// Everything computed from a [`Problem`]; made once when the inputs change.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Solution {
    /// What it was computed from.
    pub problem: Problem,
    /// D = fx·b/d.
    pub stereo: Outcome,
    /// D = w_real·cos φ·fx/w_img.
    pub monocular: Outcome,
    /// w_real·cos φ·fx/D, with the stereo distance whenever there is one.
    pub estimated_width_px: Option<Pixels>,
    /// w_img·D/(fx·cos φ), with the stereo distance whenever there is one.
    pub estimated_width: Option<Length>,
    /// How sure one can be of the stereo distance; `None` where no input has a σ.
    pub stereo_uncertainty: Option<Uncertainty>,
    /// How sure one can be of the monocular distance; `None` where no input has a σ.
    pub monocular_uncertainty: Option<Uncertainty>,
    /// One distance against the other; `None` unless both are known. Where they do not agree, [`Solution::suspects`] says what
    /// to look at.
    pub comparison: Option<Comparison>,
    /// Both distances [combined](agreement::combine); `None` unless each has a σ of its own: one that nobody has stated is not 0.
    pub combined: Option<Measured<Length>>,
    /// An input whose σ is out of all proportion to its value, so that nothing can be said.
    pub unusable_sigma: Option<Field>,
}

impl Solution {
    /// The outcome of `method`.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// use depth_core::problem::{Method, Outcome};
    ///
    /// assert_eq!(mug.solve().outcome(Method::Monocular), Outcome::Incomplete);
    /// ```
    pub const fn outcome(&self, method: Method) -> Outcome {
        match method {
            Method::Stereo => self.stereo,
            Method::Monocular => self.monocular,
        }
    }

    /// How sure one can be of the distance of `method`.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// use depth_core::problem::Method;
    ///
    /// assert!(mug.solve().uncertainty(Method::Stereo).is_none());
    /// // 2 %.
    /// mug.set_sigma(Field::Disparity, 1.0);
    /// assert!((mug.solve().uncertainty(Method::Stereo).unwrap().sigma.m() - 0.028).abs() < 1e-12);
    /// ```
    pub const fn uncertainty(&self, method: Method) -> Option<&Uncertainty> {
        match method {
            Method::Stereo => self.stereo_uncertainty.as_ref(),
            Method::Monocular => self.monocular_uncertainty.as_ref(),
        }
    }

    /// What to look at where both distances disagree, likeliest first; empty where they agree. Worked out on demand, because
    /// few want it: [`agreement::suspects`].
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// use depth_core::agreement::Suspect;
    ///
    /// // 16 times too many pixels: 0.0875 m against 1.4 m.
    /// mug.set(Field::Disparity, Some(800.0));
    /// mug.set(Field::ImageWidth, Some(150.0));
    /// mug.set(Field::RealWidth, Some(0.3));
    /// mug.set_sigma(Field::Disparity, 8.0);
    /// mug.set_sigma(Field::ImageWidth, 2.0);
    /// assert_eq!(mug.solve().suspects().first(), Some(&Suspect::RawDisparity { scale: 16.0 }));
    /// ```
    pub fn suspects(&self) -> Vec<Suspect> {
        if self.comparison.is_none() {
            return Vec::new();
        }
        let model = |method| self.problem.model(method)?.ok();
        match (model(Method::Stereo), model(Method::Monocular)) {
            (Some(stereo), Some(monocular)) => agreement::suspects(&stereo, &monocular),
            _ => Vec::new(),
        }
    }

    /// The weights of the stereo and of the monocular distance in the [combined](Self::combined) one, which add to 1; `None` without that.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// for (field, value, sigma) in [(Field::FocalLength, 700.0, 0.0), (Field::Baseline, 0.1, 0.002), (Field::Disparity, 50.0, 0.0),
    ///     (Field::ImageWidth, 150.0, 6.0), (Field::RealWidth, 0.3, 0.0)] {
    ///     mug.set(field, Some(value));
    ///     mug.set_sigma(field, sigma);
    /// }
    /// // 2 % and 4 %: 1/2² to 1/4².
    /// assert!((mug.solve().weights().unwrap()[0] - 0.8).abs() < 1e-12);
    /// ```
    pub fn weights(&self) -> Option<[f64; 2]> {
        self.combined?;
        let [stereo, monocular] = Method::ALL.map(|method| self.problem.model(method)?.ok());
        agreement::weights(&stereo?, &monocular?)
    }

    /// The distance to use: both combined where they can be, else the stereo distance, else the monocular one.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// use depth_core::problem::{Method, Origin};
    ///
    /// let best = mug.solve().best().unwrap();
    /// assert_eq!((best.origin, best.distance.value.m()), (Origin::Method(Method::Stereo), 1.4));
    /// ```
    pub fn best(&self) -> Option<BestDistance> {
        let [stereo, monocular] = Method::ALL.map(|method| self.problem.model(method)?.ok());
        let shares = |model: &Model| model.calibration() == Some(Field::FocalLength);
        let shift = |model: &Model| Length::from_m(model.depth().m() - model.projected_depth().m());
        if let (Some(combined), Some(stereo), Some(monocular)) = (self.combined, &stereo, &monocular) {
            let shift = shift(stereo);
            let has_fx = shares(stereo) && shares(monocular);
            let relative = if has_fx {
                agreement::shared_relative_sigma(stereo, monocular)
            } else {
                0.0
            };
            let shared = relative * (combined.value.m() + stereo.zero().m());
            let own = ((combined.sigma.m() - shared).max(0.0) * (combined.sigma.m() + shared)).sqrt();
            return Some(BestDistance {
                origin: Origin::Combined,
                distance: Measured::new(combined.value, Length::from_m(own)),
                has_focal_length: has_fx,
                shift,
            });
        }
        Method::ALL.into_iter().find_map(|method| {
            let distance = self.outcome(method).distance()?;
            let exact = self.problem.without_sigmas().model(method)?.ok()?;
            let has_fx = self
                .uncertainty(method)
                .map_or_else(|| shares(&exact), |known| shares(&known.model));
            let own = self.uncertainty(method).map_or(0.0, |known| {
                let model = &known.model;
                let relative = if has_fx {
                    model.own_relative_sigma()
                } else {
                    model.relative_sigma()
                };
                model.projected_depth().m() * relative
            });
            Some(BestDistance {
                origin: Origin::Method(method),
                distance: Measured::new(distance, Length::from_m(own)),
                has_focal_length: has_fx,
                shift: shift(&exact),
            })
        })
    }

    /// The 1 σ interval of the [best](Self::best) distance; `None` where it has no σ. That of the combined distance is symmetric, as
    /// only its first order is known.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// assert_eq!(mug.solve().best_interval(), None);
    /// mug.set_sigma(Field::Disparity, 10.0);
    /// // 70/60 and 70/40.
    /// let interval = mug.solve().best_interval().unwrap();
    /// assert!((interval.near.m() - 1.166667).abs() < 1e-6 && (interval.far.unwrap().m() - 1.75).abs() < 1e-6);
    /// ```
    pub fn best_interval(&self) -> Option<Interval> {
        match (self.best()?.origin, self.combined) {
            (Origin::Method(method), _) => self.uncertainty(method).map(|uncertainty| uncertainty.interval),
            (Origin::Combined, combined) => combined.map(|combined| Interval {
                near: Length::from_m((combined.value.m() - combined.sigma.m()).max(0.0)),
                far: Some(Length::from_m(combined.value.m() + combined.sigma.m())),
            }),
        }
    }

    /// The stereo distances with the disparity one pixel larger (nearer) and one smaller; the second is `None` where the
    /// object would be infinitely far away. `None` as a whole without a stereo distance.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// // 70/51 and 70/49.
    /// let (near, far) = mug.solve().one_pixel_range().unwrap();
    /// assert!((near.m() - 1.372549).abs() < 1e-6);
    /// assert!((far.unwrap().m() - 1.428571).abs() < 1e-6);
    /// ```
    pub fn one_pixel_range(&self) -> Option<(Length, Option<Length>)> {
        self.stereo.distance()?;
        Some((self.problem.stereo_distance_if(1.0)?, self.problem.stereo_distance_if(-1.0)))
    }

    /// How much the stereo distance changes with one pixel of disparity, Z/(d + δ), to first order; `None` without a distance in pixels.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// // 1.4 m / 50 px.
    /// assert!((mug.solve().depth_of_one_pixel().unwrap().m() - 0.028).abs() < 1e-15);
    /// ```
    ///
    /// Source: the derivative of f·b/(d + δ).
    pub fn depth_of_one_pixel(&self) -> Option<Length> {
        self.stereo.distance()?;
        let disparity = self.problem.effective_disparity()?.px();
        let model = self.problem.without_sigmas().model(Method::Stereo)?.ok()?;
        Some(Length::from_m(model.projected_depth().m() / disparity)).filter(|length| length.m().is_normal())
    }

    /// The focal length of the lens that the distance of `method` has in it, where that is worth a word: more than
    /// a hundredth of it.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Method, Problem};
    /// let mut pair = Problem::default();
    /// pair.set(Field::FocalLength, Some(4000.0));
    /// pair.set(Field::Baseline, Some(0.02));
    /// pair.set(Field::Disparity, Some(400.0));
    /// pair.set(Field::Lens, Some(0.016));
    /// // 16 mm of 216 mm.
    /// assert_eq!(pair.solve().added_lens(Method::Stereo).unwrap().m(), 0.016);
    /// pair.set(Field::Disparity, Some(40.0));
    /// assert_eq!(pair.solve().added_lens(Method::Stereo), None);
    /// ```
    pub fn added_lens(&self, method: Method) -> Option<Length> {
        let distance = self.outcome(method).distance()?;
        let model = self.problem.without_sigmas().model(method)?.ok()?;
        self.notable_lens(distance).filter(|_| model.is_in_pixels())
    }

    /// The focal length of the lens where it is more than 1 % of `distance`.
    ///
    /// ```
    /// # use depth_core::problem::Problem;
    /// # use depth_core::quantity::Length;
    /// let lens = Some(Length::from_m(0.05));
    /// let solution = Problem { lens, ..Problem::default() }.solve();
    /// assert_eq!(solution.notable_lens(Length::from_m(2.0)), lens);
    /// assert_eq!(solution.notable_lens(Length::from_m(10.0)), None);
    /// ```
    pub fn notable_lens(&self, distance: Length) -> Option<Length> {
        self.problem.lens.filter(|lens| lens.m() > NOTABLE_LENS * distance.m())
    }

    /// How far the entered image width is off what the stereo distance and the real width predict, as a fraction of the
    /// prediction: w_img / (w_real·fx/D) − 1. `None` unless both methods have a distance; the same figure holds for the
    /// real width.
    ///
    /// With both distances known it equals D_stereo/D_monocular − 1, both from the center of projection.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// mug.set(Field::RealWidth, Some(0.3));
    /// // 0.3 m at 1.4 m are 150 px; 165 px are 10 % more.
    /// mug.set(Field::ImageWidth, Some(165.0));
    /// assert!((mug.solve().width_discrepancy().unwrap() - 0.1).abs() < 1e-12);
    /// ```
    pub fn width_discrepancy(&self) -> Option<f64> {
        let from_lens = |method| {
            self.outcome(method).distance()?;
            let model = self.problem.without_sigmas().model(method)?.ok()?;
            Some(model.projected_depth().m())
        };
        let ratio = from_lens(Method::Stereo)? / from_lens(Method::Monocular)?;
        Some(ratio - 1.0).filter(|r| r.is_finite())
    }
}
