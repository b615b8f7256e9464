//! How sure can one be: the uncertainty of a distance that follows from the uncertainty of its inputs.
//!
//! Stereo and monocular are one equation, Z = f·L/x: a focal length f, a length L (the baseline, or the object's real
//! width) and a divisor x in pixels (the disparity plus doffs, or the object's width in the image). f and L scale the
//! distance and keep its spread symmetric; x divides, and where its σ is not small the distance has a long far side. That
//! is why [`Model::interval`] is the honest answer and [`Model::relative_sigma`] its small-σ limit.

use crate::arithmetic::root_sum_of_squares;
use crate::measured::Measured;
use crate::quantity::Length;
use std::f64::consts::PI;

pub use crate::budget::{Budget, Share, part_of_sigma};
pub use crate::model::Model;

/// The relative σ of the divisor up to which the first-order σ can be trusted: 10 %.
///
/// At 10 % the far end of the exact 1 σ interval lies 1.11 σ away, the near end 0.91 σ.
pub const FIRST_ORDER_LIMIT: f64 = 0.10;

/// An interval of distances.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Interval {
    /// The near end.
    pub near: Length,
    /// The far end; `None` where there is no upper bound.
    pub far: Option<Length>,
}

impl Model {
    /// The distance with its first-order σ.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// // 5 % of 1.4 m.
    /// let distance = mug.depth_with_sigma();
    /// assert_eq!(distance.value.m(), 1.4);
    /// assert!((distance.sigma.m() - 0.07).abs() < 1e-12);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub fn depth_with_sigma(&self) -> Measured<Length> {
        let sigma = self.projected_depth().m() * self.relative_sigma();
        Measured::new(self.depth(), Length::from_m(sigma))
    }

    /// [`relative_sigma`](Self::relative_sigma) with the focal length taken to be exact: what this distance does not share with
    /// another one that was computed from the same focal length.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// // The 3 % of the focal length do not count.
    /// assert!((mug.own_relative_sigma() - 0.04).abs() < 1e-12);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub fn own_relative_sigma(&self) -> f64 {
        let [_of_focal_length, own @ ..] = self.relative_sigmas().map(|(_, relative)| relative);
        root_sum_of_squares(&own)
    }

    /// The 1 σ interval with every uncertainty and no linearization: all distances that the inputs do not contradict by
    /// more than 1 σ.
    ///
    /// Z·(1 ± √(rk² + rx² − rk²·rx²))/(1 − rx²) with rk the relative σ of f·L (rk² = σ_f²/f² + σ_L²/L²) and rx that of the
    /// divisor. There is no upper bound once rx ≥ 1: the divisor may then be 0. The near end is 0 once rk ≥ 1. With rk = 0
    /// it is the interval of the distances at x + σ and x − σ. Of a ball that of a disk as wide, each end then taken to the center; of
    /// an angle with the rx of either side, so that with rk = 0 it is that at α + σ and α − σ.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// # let exact = |px: f64| Measured::from_base(px, 0.0);
    /// // Only the disparity is uncertain: the distances at 50 + 20 and 50 − 15 px.
    /// let at = |sigma| Model::stereo(exact(700.0), Measured::from_base(0.1, 0.0), Measured::from_base(50.0, sigma), exact(0.0));
    /// assert!((at(20.0)?.interval().near.m() - 1.0).abs() < 1e-12);
    /// assert!((at(15.0)?.interval().far.unwrap().m() - 2.0).abs() < 1e-12);
    /// assert_eq!(at(50.0)?.interval().far, None);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    ///
    /// Source: E. C. Fieller, Some problems in interval estimation, Journal of the Royal Statistical Society B 16 (1954),
    /// for the ratio of two independent normal variables; f·L is taken to be normal.
    pub fn interval(&self) -> Interval {
        let depth = self.facing_depth().m();
        let rk = root_sum_of_squares(&[self.focal_length().relative(), self.length().1.relative()]);
        let [nearer, farther] = self.relative_divisor_ends();
        // (1 − s)·(1 + s) = (1 − rk²)·(1 − rx²) turns the two roots into forms in which nothing cancels.
        let near = if rk < 1.0 {
            let rest = (1.0 - rk) * (1.0 + rk);
            depth * (rest / (1.0 + root_sum_of_squares(&[rk, nearer * rest.sqrt()])))
        } else {
            0.0
        };
        let far = (farther < 1.0)
            .then(|| {
                let rest = (1.0 - farther) * (1.0 + farther);
                depth * ((1.0 + root_sum_of_squares(&[farther, rk * rest.sqrt()])) / rest)
            })
            .filter(|far| far.is_finite());
        let counted = |facing: f64| {
            let end = self.counted_from_zero(self.center_behind(Length::from_m(facing), self.length().1.value));
            Length::from_m(end.m().max(0.0))
        };
        Interval {
            near: if near > 0.0 { counted(near) } else { Length::from_m(0.0) },
            far: far.map(counted),
        }
    }

    /// By which part of itself the divisor is larger 1 σ nearer, and smaller 1 σ farther away: twice its relative σ, but for an angle.
    fn relative_divisor_ends(&self) -> [f64; 2] {
        let Some(angle) = self.angle() else {
            return [self.divisor().relative(); 2];
        };
        let (value, sigma) = (angle.value.radians(), angle.sigma.radians());
        let extent = |angle: f64| (angle / 2.0).tan() / (value / 2.0).tan();
        let larger = if value + sigma < PI {
            extent(value + sigma) - 1.0
        } else {
            f64::INFINITY
        };
        [larger, 1.0 - extent((value - sigma).max(0.0))]
    }

    /// The relative σ of the divisor: √(σ_d² + σ_δ²)/(d + δ), or σ_p/w_img.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// assert_eq!(mug.relative_divisor_sigma(), 0.04);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub fn relative_divisor_sigma(&self) -> f64 {
        self.divisor().relative()
    }

    /// Whether the first-order σ can be trusted: the divisor is known to [10 %](FIRST_ORDER_LIMIT) or better.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// // 4 % are less than 10 %.
    /// assert!(mug.first_order_is_good());
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub fn first_order_is_good(&self) -> bool {
        self.relative_divisor_sigma() <= FIRST_ORDER_LIMIT
    }

    /// How much too far the average of many such distances comes out, as a fraction of the distance: rx², with rx the
    /// relative σ of the divisor. The median has no such bias.
    ///
    /// `None` above rx = 1/3, where the next term of the series, 3·rx⁴, is more than a third of this one. (It is an
    /// asymptotic series: strictly the mean of 1/x does not exist for a normal x.)
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// // (4 %)².
    /// assert!((mug.relative_bias().unwrap() - 0.0016).abs() < 1e-12);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    ///
    /// Source: G. Sibley, L. Matthies, G. Sukhatme, Bias reduction and filter convergence for long range stereo, ISRR
    /// 2005; second-order Taylor series of 1/x.
    pub fn relative_bias(&self) -> Option<f64> {
        let rx = self.relative_divisor_sigma();
        (rx <= 1.0 / 3.0).then_some(rx * rx)
    }

    /// [`relative_bias`](Self::relative_bias) as a length.
    ///
    /// ```
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// // f known to 3 %, d to 4 %.
    /// let mug = Model::stereo(
    ///     Measured::from_base(700.0, 21.0),
    ///     Measured::from_base(0.1, 0.0),
    ///     Measured::from_base(50.0, 2.0),
    ///     Measured::from_base(0.0, 0.0),
    /// )?;
    /// // 0.16 % of 1.4 m.
    /// assert!((mug.bias().unwrap().m() - 0.00224).abs() < 1e-12);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    pub fn bias(&self) -> Option<Length> {
        Some(Length::from_m(self.relative_bias()? * self.projected_depth().m()))
    }
}

/// How sure one can be of a distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Uncertainty {
    /// The inputs with their σ.
    pub model: Model,
    /// σ of the distance to first order.
    pub sigma: Length,
    /// The 1 σ interval without linearization.
    pub interval: Interval,
    /// Which input causes which part of the variance; adds to 1.
    pub budget: Budget,
    /// How much too far the average of many such distances comes out; `None` where that cannot be said.
    pub bias: Option<Length>,
}

impl Uncertainty {
    pub(crate) fn new(model: Model) -> Self {
        Self {
            sigma: model.depth_with_sigma().sigma,
            interval: model.interval(),
            budget: model.variance_budget(),
            bias: model.bias(),
            model,
        }
    }

    /// The bias where it is worth a word: more than a hundredth of σ.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// // 1 %: σ is 14 mm, the bias 0.14 mm and a hundredth of σ too.
    /// mug.set_sigma(Field::Disparity, 0.4);
    /// assert_eq!(mug.solve().stereo_uncertainty.unwrap().notable_bias(), None);
    /// mug.set_sigma(Field::Disparity, 2.0);
    /// assert!(mug.solve().stereo_uncertainty.unwrap().notable_bias().is_some());
    /// ```
    pub fn notable_bias(&self) -> Option<Length> {
        self.bias.filter(|bias| bias.m() > self.sigma.m() / 100.0)
    }

    /// The input that causes the largest part of the variance.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// mug.set_sigma(Field::FocalLength, 21.0);
    /// mug.set_sigma(Field::Disparity, 2.0);
    /// // (4 %)² of (5 %)².
    /// let cause = mug.solve().stereo_uncertainty.unwrap().main_cause().unwrap();
    /// assert_eq!(cause.source, Field::Disparity);
    /// assert!((cause.share - 0.64).abs() < 1e-12);
    /// ```
    pub fn main_cause(&self) -> Option<Share> {
        self.budget.iter().copied().max_by(|a, b| a.share.total_cmp(&b.share))
    }
}
