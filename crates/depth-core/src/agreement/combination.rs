//! Two distances to the same object made one.

use super::comparison::{Comparison, Verdict, of_optical_depth, unshared};
use crate::arithmetic::{log_ratio, root_sum_of_squares};
use crate::measured::Measured;
use crate::model::Model;
use crate::quantity::Length;

/// The two distances combined, weighted by what each does not share with the other.
///
/// With r₁ and r₂ the relative σ of each without the focal length and r_f = σ_f/f:
/// ln Z = (ln Z₁/r₁² + ln Z₂/r₂²)/(1/r₁² + 1/r₂²) and (σ/Z)² = 1/(1/r₁² + 1/r₂²) + r_f², with r₁ and r₂ multiplied by
/// max(1, z), z being how many σ the two are apart: what differs by more than its σ has a larger one.
/// The result lies between the two.
///
/// `None` where one of them has no uncertainty of its own: nothing is there to weigh it with. And where they
/// [contradict](super::Comparison::contradict) each other: nothing between them would be right.
///
/// Both models must count from the same place. r_f is that of the focal length which both share; where they have different ones, or
/// one is from an angle and has none, it is 0, and each has all of its σ for itself.
///
/// ```
/// use depth_core::agreement::combine;
/// # use depth_core::measured::Measured;
/// # use depth_core::uncertainty::Model;
/// # let exact = |px: f64| Measured::from_base(px, 0.0);
/// let stereo = Model::stereo(exact(700.0), Measured::from_base(0.1, 0.0), Measured::from_base(50.0, 2.0), exact(0.0))?;
/// let monocular = Model::monocular(exact(700.0), Measured::from_base(0.3, 0.0), Measured::from_base(150.0, 6.0))?;
///
/// // 1.4 m twice, each to 4 %: one distance to 4 %/√2.
/// let combined = combine(&stereo, &monocular).unwrap();
/// assert!((combined.value.m() - 1.4).abs() < 1e-12);
/// assert!((combined.relative() - 0.04 / 2.0_f64.sqrt()).abs() < 1e-12);
/// # Ok::<(), depth_core::judge::Unsolvable>(())
/// ```
///
/// Source: weighted least squares (Gauss–Markov) for two measurements of ln Z with a common error, with the weights of
/// the independent parts, which keeps the result between the two where the optimal weights may not (R. W. Peelle's
/// puzzle, 1987). The factor is that of [`Agreement::widening`](super::Agreement::widening).
pub fn combine(first: &Model, second: &Model) -> Option<Measured<Length>> {
    let [z1, z2] = [first, second].map(|model| model.optical_depth().m());
    let [r1, r2] = unshared([first, second]);
    let r = root_sum_of_squares(&[r1, r2]);
    let agreement = Comparison::of(first, second).agreement?;
    if agreement.verdict == Verdict::Disagree {
        return None;
    }
    let widened = agreement.widening();
    let weight_of_second = (r1 / r) * (r1 / r);
    let log_ratio = log_ratio(z1, z2);
    // From the weightier of the two, so that the exponential stays in range however far they are apart.
    let value = if weight_of_second <= 0.5 {
        z1 * (-weight_of_second * log_ratio).exp()
    } else {
        z2 * ((r2 / r) * (r2 / r) * log_ratio).exp()
    };
    let value = value.clamp(z1.min(z2), z1.max(z2));
    let relative = root_sum_of_squares(&[widened * r1 * (r2 / r), shared_relative_sigma(first, second)]);
    let counted = value - first.zero().m();
    (counted > 0.0).then(|| Measured::from_base(counted, value * relative))
}

/// The weights with which [`combine`] takes the two, which add to 1; `None` where one has no uncertainty of its own.
///
/// ```
/// use depth_core::agreement::weights;
/// # use depth_core::measured::Measured;
/// # use depth_core::uncertainty::Model;
/// # let exact = |px: f64| Measured::from_base(px, 0.0);
/// let stereo = Model::stereo(exact(700.0), Measured::from_base(0.1, 0.0), Measured::from_base(50.0, 1.0), exact(0.0))?;
/// let monocular = Model::monocular(exact(700.0), Measured::from_base(0.3, 0.0), Measured::from_base(150.0, 6.0))?;
/// // 2 % and 4 %: 1/2² to 1/4².
/// let [of_stereo, of_monocular] = weights(&stereo, &monocular).unwrap();
/// assert!((of_stereo - 0.8).abs() < 1e-12 && (of_monocular - 0.2).abs() < 1e-12);
/// # Ok::<(), depth_core::judge::Unsolvable>(())
/// ```
///
/// Source: as [`combine`].
pub fn weights(first: &Model, second: &Model) -> Option<[f64; 2]> {
    let [r1, r2] = unshared([first, second]);
    let r = root_sum_of_squares(&[r1, r2]);
    (r1 > 0.0 && r2 > 0.0 && r.is_finite()).then(|| [(r2 / r) * (r2 / r), (r1 / r) * (r1 / r)])
}

/// The relative σ that both distances have in common: that of the focal length, where both need it.
pub(crate) fn shared_relative_sigma(first: &Model, second: &Model) -> f64 {
    if first.calibration().is_some() && first.calibration() == second.calibration() {
        of_optical_depth(first, first.focal_length().relative())
    } else {
        0.0
    }
}
