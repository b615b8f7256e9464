//! Two distances to the same object: do they agree, what do they say together, and what is likely to be wrong if not.
//!
//! Both are computed from the same focal length. Its error moves both alike: it can neither make them disagree nor be
//! averaged away.

use crate::arithmetic::root_sum_of_squares;
use crate::field::Field;
use crate::measured::Measured;
use crate::quantity::{Length, LengthUnit};
use crate::uncertainty::Model;

/// The two distances combined, weighted by what each does not share with the other.
///
/// With r₁ and r₂ the relative σ of each without the focal length and r_f = σ_f/f:
/// ln Z = (ln Z₁/r₁² + ln Z₂/r₂²)/(1/r₁² + 1/r₂²) and (σ/Z)² = 1/(1/r₁² + 1/r₂²) + r_f².
/// The result lies between the two, and its relative σ is never more than the smaller one. Where one of them has no
/// uncertainty of its own it is the result; `None` where neither has: nothing is there to weigh them with.
///
/// Both models must have the same focal length; r_f is taken from `first`.
///
/// Source: weighted least squares (Gauss–Markov) for two measurements of ln Z with a common error, with the weights of
/// the independent parts, which keeps the result between the two where the optimal weights may not (R. W. Peelle's
/// puzzle, 1987).
pub fn combine(first: &Model, second: &Model) -> Option<Measured<Length>> {
    let (z1, z2) = (first.depth().m(), second.depth().m());
    let (r1, r2) = (first.own_relative_sigma(), second.own_relative_sigma());
    let r = root_sum_of_squares(&[r1, r2]);
    if r == 0.0 {
        return None;
    }
    let weight_of_second = (r1 / r) * (r1 / r);
    let log_ratio = log_ratio(z1, z2);
    // From the weightier of the two, so that the exponential stays in range however far they are apart.
    let value = if weight_of_second <= 0.5 {
        z1 * (-weight_of_second * log_ratio).exp()
    } else {
        z2 * ((r2 / r) * (r2 / r) * log_ratio).exp()
    };
    let value = value.clamp(z1.min(z2), z1.max(z2));
    let relative = root_sum_of_squares(&[r1 * (r2 / r), first.focal_length().relative()]);
    Some(Measured::from_base(value, value * relative))
}

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

/// What may have gone wrong where two distances disagree.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Suspect {
    /// The disparity was not divided by `scale`: the file stores fixed-point numbers (16 for OpenCV's StereoBM and
    /// StereoSGBM).
    RawDisparity {
        /// What to divide by.
        scale: f64,
    },
    /// A length was given in the wrong unit.
    Unit {
        /// The baseline or the real width.
        source: Field,
        /// The unit it was taken to be in.
        taken: LengthUnit,
        /// The unit in which the two distances would agree.
        meant: LengthUnit,
    },
    /// Pixels counted in an image of another size than the one the focal length belongs to.
    Resized {
        /// The disparity or the width in the image.
        source: Field,
        /// How many times larger that image is: 2 or ½.
        times: f64,
    },
    /// An input that claims to be exact.
    NoSigma(Field),
    /// The input with the largest relative uncertainty.
    LargestSigma(Field),
}

/// How near, in the logarithm, a ratio must come to a blunder's factor to be laid at its door: 8 %. Half the gap between
/// the two nearest factors of different kinds of unit slip (10 and 12).
const BLUNDER_TOLERANCE: f64 = 0.08;

/// Compares two distances that were computed from the same focal length.
///
/// z = |ln(Z₁/Z₂)|/√(r₁² + r₂²) with the relative σ of each without the focal length, which both share.
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

/// What to look at where two distances that were computed from the same focal length disagree, likeliest first: blunders
/// that would explain their ratio, inputs that claim to be exact, the vaguest input. Empty where they
/// [agree](Verdict::Agree). The focal length is never a suspect: it cancels.
pub fn suspects(first: &Model, second: &Model) -> Vec<Suspect> {
    let log_ratio = log_ratio(first.depth().m(), second.depth().m());
    if compare(first, second).verdict == Some(Verdict::Agree) || log_ratio.abs() < 1e-12 {
        return Vec::new();
    }
    let mut blunders: Vec<(f64, Suspect)> = blunders(first)
        .into_iter()
        .chain(blunders(second).into_iter().map(|(factor, blunder)| (-factor, blunder)))
        .map(|(log_factor, blunder)| ((log_ratio - log_factor).abs(), blunder))
        .filter(|&(distance, _)| distance <= BLUNDER_TOLERANCE)
        .collect();
    blunders.sort_by(|(a, _), (b, _)| a.total_cmp(b));

    let inputs = [first, second].into_iter().flat_map(|model| {
        let ((length, l), (pixels, p)) = (model.length(), model.pixels());
        [(length, l.sigma.m()), (pixels, p.sigma.px())]
    });
    let exact = inputs.filter(|&(_, sigma)| sigma == 0.0);
    let largest = [first, second]
        .into_iter()
        .flat_map(|model| model.relative_sigmas())
        .filter(|&(source, relative)| source != Field::FocalLength && relative > 0.0)
        .max_by(|(_, a), (_, b)| a.total_cmp(b));

    blunders
        .into_iter()
        .map(|(_, blunder)| blunder)
        .chain(exact.map(|(source, _)| Suspect::NoSigma(source)))
        .chain(largest.map(|(source, _)| Suspect::LargestSigma(source)))
        .collect()
}

/// The typical blunders in a model, each with the logarithm of the factor by which it makes the distance too large.
fn blunders(model: &Model) -> Vec<(f64, Suspect)> {
    let (pixels, _) = model.pixels();
    let (length, _) = model.length();
    let mut list = Vec::new();
    if pixels == Field::Disparity {
        // OpenCV's fixed point; DepthAI's three, four and five sub-pixel bits; KITTI's 16-bit images.
        list.extend([16.0_f64, 8.0, 32.0, 256.0].map(|scale| (-scale.ln(), Suspect::RawDisparity { scale })));
    }
    list.extend([2.0_f64, 0.5].map(|times| (-times.ln(), Suspect::Resized { source: pixels, times })));
    for taken in LengthUnit::ALL {
        for meant in LengthUnit::ALL.into_iter().filter(|&meant| meant != taken) {
            let factor = Length::new(1.0, taken).m() / Length::new(1.0, meant).m();
            let slip = Suspect::Unit {
                source: length,
                taken,
                meant,
            };
            list.push((factor.ln(), slip));
        }
    }
    list
}

/// ln(a/b), also where a/b cannot be represented.
fn log_ratio(a: f64, b: f64) -> f64 {
    let ratio = a / b;
    if ratio.is_normal() { ratio.ln() } else { a.ln() - b.ln() }
}
