//! Whether two distances to the same object agree.

use crate::arithmetic::{log_ratio, root_sum_of_squares};
use crate::model::Model;

/// How well two distances agree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Agreement {
    /// First distance over second; `None` where it is too large or too small to be represented.
    pub ratio: Option<f64>,
    /// Their difference in standard deviations; `None` where neither has an uncertainty of its own.
    pub z: Option<f64>,
    /// What that means; `None` where `z` is.
    pub verdict: Option<Verdict>,
}

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

/// Compares two distances that were computed from the same focal length.
///
/// z = |ln(Z₁/Z₂)|/√(r₁² + r₂²) with the relative σ of each without the focal length, which both share.
///
/// ```
/// use depth_core::agreement::{Verdict, compare};
/// # use depth_core::measured::Measured;
/// # use depth_core::uncertainty::Model;
/// # let exact = |px: f64| Measured::from_base(px, 0.0);
/// let stereo = Model::stereo(exact(700.0), Measured::from_base(0.1, 0.0), Measured::from_base(50.0, 2.0), exact(0.0))?;
/// let monocular = Model::monocular(exact(700.0), Measured::from_base(0.6, 0.0), Measured::from_base(150.0, 6.0))?;
///
/// // 1.4 m and 2.8 m, each to 4 %: ln 2 is 12 times 4 %·√2.
/// let agreement = compare(&stereo, &monocular);
/// assert_eq!(agreement.verdict, Some(Verdict::Disagree));
/// assert!((agreement.z.unwrap() - 12.25).abs() < 0.01);
/// # Ok::<(), depth_core::judge::Unsolvable>(())
/// ```
///
/// Source: the ζ score of ISO 13528 (difference over its standard uncertainty, with its limits 2 and 3), here of the
/// logarithms, because both distances are products.
pub fn compare(first: &Model, second: &Model) -> Agreement {
    let (z1, z2) = (first.depth().m(), second.depth().m());
    let log_ratio = log_ratio(z1, z2);
    let sigma = root_sum_of_squares(&[first.own_relative_sigma(), second.own_relative_sigma()]);
    let z = (sigma > 0.0).then(|| (log_ratio.abs() / sigma).min(f64::MAX));
    let verdict = z.map(Verdict::of);
    Agreement {
        ratio: Some(z1 / z2).filter(|ratio| ratio.is_normal()),
        z,
        verdict,
    }
}
