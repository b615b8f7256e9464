//! Whether two distances to the same object agree.

use crate::arithmetic::{log_ratio, root_sum_of_squares};
use crate::measured::Measured;
use crate::model::Model;
use crate::quantity::Length;

/// How well two distances agree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// Their difference in standard deviations.
    pub z: f64,
    /// What that means.
    pub verdict: Verdict,
}

impl Agreement {
    /// By how much the σ of each is multiplied where the two are [combined](super::combine): what differs by more than its σ has a
    /// larger one.
    ///
    /// ```
    /// use depth_core::agreement::{Agreement, Verdict};
    ///
    /// assert_eq!(Agreement { z: 1.8, verdict: Verdict::Agree }.widening(), 1.8);
    /// assert_eq!(Agreement { z: 0.3, verdict: Verdict::Agree }.widening(), 1.0);
    /// ```
    ///
    /// Source: the Birge ratio √(χ²/(N − 1)) for N = 2, not below 1, as the Particle Data Group scales the errors of measurements that
    /// do not agree well (Review of Particle Physics, Introduction, 5.2.2).
    pub fn widening(&self) -> f64 {
        self.z.max(1.0)
    }
}

/// One distance against another one to the same object.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// First distance over second; `None` where it is too large or too small to be represented.
    pub ratio: Option<f64>,
    /// How well they agree; `None` unless each has an uncertainty of its own.
    pub agreement: Option<Agreement>,
}

/// The ratio of two distances from which on they contradict each other where no uncertainty says so.
pub const LARGEST_RATIO: f64 = 1.5;

/// What a difference of so many standard deviations means.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Up to 2 σ: the stated uncertainties explain it.
    Agree,
    /// Up to 3 σ: one case in twenty, were the uncertainties right.
    Doubtful,
    /// More than 3 σ: one case in 370. An input or its uncertainty is wrong.
    Disagree,
}

impl Verdict {
    /// The verdict on a difference of `z` standard deviations.
    ///
    /// ```
    /// use depth_core::agreement::Verdict;
    ///
    /// assert_eq!(Verdict::of(2.5), Verdict::Doubtful);
    /// ```
    pub fn of(z: f64) -> Self {
        if z <= 2.0 {
            Self::Agree
        } else if z <= 3.0 {
            Self::Doubtful
        } else {
            Self::Disagree
        }
    }
}

impl Comparison {
    /// Compares two distances that were computed from the same focal length, as far as they need one. Wherever they are counted from,
    /// it is their distances from the lens that are compared.
    ///
    /// z = |ln(Z₁/Z₂)|/√(r₁² + r₂²) with the relative σ of each without the focal length, where both share it.
    ///
    /// ```
    /// use depth_core::agreement::{Comparison, Verdict};
    /// # use depth_core::measured::Measured;
    /// # use depth_core::uncertainty::Model;
    /// # let exact = |px: f64| Measured::from_base(px, 0.0);
    /// let stereo = Model::stereo(exact(700.0), Measured::from_base(0.1, 0.0), Measured::from_base(50.0, 2.0), exact(0.0))?;
    /// let monocular = Model::monocular(exact(700.0), Measured::from_base(0.6, 0.0), Measured::from_base(150.0, 6.0))?;
    ///
    /// // 1.4 m and 2.8 m, each to 4 %: ln 2 is 12 times 4 %·√2.
    /// let agreement = Comparison::of(&stereo, &monocular).agreement.unwrap();
    /// assert_eq!(agreement.verdict, Verdict::Disagree);
    /// assert!((agreement.z - 12.25).abs() < 0.01);
    /// # Ok::<(), depth_core::judge::Unsolvable>(())
    /// ```
    ///
    /// Source: the ζ score of ISO 13528 (difference over its standard uncertainty, with its limits 2 and 3), here of the
    /// logarithms, because both distances are products.
    pub fn of(first: &Model, second: &Model) -> Self {
        Self::relative([first, second].map(|model| model.optical_depth().m()), unshared([first, second]))
    }

    /// Compares two distances that share nothing, each with its whole σ.
    ///
    /// ```
    /// use depth_core::agreement::{Comparison, Verdict};
    /// use depth_core::measured::Measured;
    ///
    /// // ln(2/1.4) is 12.6 times √(1 %² + 2.65 %²).
    /// let comparison = Comparison::of_independent(Measured::from_base(2.0, 0.02), Measured::from_base(1.4, 0.0371));
    /// assert!((comparison.agreement.unwrap().z - 12.59).abs() < 0.01);
    /// assert!(Comparison::of_independent(Measured::from_base(2.0, 0.0), Measured::from_base(1.4, 0.1)).agreement.is_none());
    /// ```
    ///
    /// Source: as [`of`](Self::of).
    pub fn of_independent(first: Measured<Length>, second: Measured<Length>) -> Self {
        Self::relative([first.value.m(), second.value.m()], [first.relative(), second.relative()])
    }

    /// Compares two distances, m, with the relative σ that they do not share.
    fn relative([z1, z2]: [f64; 2], [r1, r2]: [f64; 2]) -> Self {
        let agreement = (r1 > 0.0 && r2 > 0.0).then(|| {
            let z = (log_ratio(z1, z2).abs() / root_sum_of_squares(&[r1, r2])).min(f64::MAX);
            Agreement {
                z,
                verdict: Verdict::of(z),
            }
        });
        Self {
            ratio: Some(z1 / z2).filter(|ratio| ratio.is_normal()),
            agreement,
        }
    }

    /// Whether not both can be right: they are more than 3 σ apart or, where not each has a σ of its own, one is more than
    /// [1.5 times](LARGEST_RATIO) the other.
    ///
    /// ```
    /// use depth_core::agreement::Comparison;
    ///
    /// assert!(Comparison { ratio: Some(10.0), agreement: None }.contradict());
    /// assert!(!Comparison { ratio: Some(1.2), agreement: None }.contradict());
    /// ```
    pub fn contradict(&self) -> bool {
        match (self.agreement, self.ratio) {
            (Some(agreement), _) => agreement.verdict == Verdict::Disagree,
            (None, Some(ratio)) => ratio.max(1.0 / ratio) > LARGEST_RATIO,
            // Too far apart to be represented.
            (None, None) => true,
        }
    }

    /// Whether nothing speaks against both: they neither [contradict](Self::contradict) each other nor are they doubtful.
    ///
    /// ```
    /// use depth_core::agreement::Comparison;
    ///
    /// assert!(Comparison { ratio: Some(1.2), agreement: None }.is_fine());
    /// ```
    pub fn is_fine(&self) -> bool {
        match self.agreement {
            Some(agreement) => agreement.verdict == Verdict::Agree,
            None => !self.contradict(),
        }
    }
}

/// The relative σ of the distance of each model from the lens that it does not share with the other.
pub(super) fn unshared(models: [&Model; 2]) -> [f64; 2] {
    let [first, second] = models.map(Model::calibration);
    let share_focal_length = first.is_some() && first == second;
    models.map(|model| {
        let relative = if share_focal_length {
            model.own_relative_sigma()
        } else {
            model.relative_sigma()
        };
        of_optical_depth(model, relative)
    })
}

/// The same σ as a part of the distance from the lens.
pub(super) fn of_optical_depth(model: &Model, relative: f64) -> f64 {
    let (projected, optical) = (model.projected_depth().m(), model.optical_depth().m());
    // Nearly always the same.
    if projected == optical {
        relative
    } else {
        relative * (projected / optical)
    }
}
