//! What is likely to be wrong where two distances to the same object disagree.

use super::comparison::Comparison;
use crate::arithmetic::log_ratio;
use crate::field::Field;
use crate::model::Model;
use crate::quantity::{Length, LengthUnit};

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

/// What to look at where two distances that were computed from the same focal length disagree, likeliest first: blunders
/// that would explain their ratio and, where each has a σ of its own, inputs that claim to be exact and the vaguest one. Empty where
/// [nothing speaks against both](Comparison::is_fine). The focal length is never a suspect: it cancels.
///
/// ```
/// use depth_core::agreement::{Suspect, suspects};
/// use depth_core::problem::Field;
/// # use depth_core::measured::Measured;
/// # use depth_core::uncertainty::Model;
/// # let exact = |px: f64| Measured::from_base(px, 0.0);
/// let stereo = Model::stereo(exact(700.0), Measured::from_base(0.1, 0.0), Measured::from_base(50.0, 2.0), exact(0.0))?;
/// let monocular = Model::monocular(exact(700.0), Measured::from_base(0.6, 0.0), Measured::from_base(150.0, 6.0))?;
///
/// // The monocular distance is twice the stereo one, as if its pixels were those of an image half as large.
/// let found = suspects(&stereo, &monocular);
/// assert!(found.contains(&Suspect::Resized { source: Field::ImageWidth, times: 0.5 }));
/// assert!(found.contains(&Suspect::NoSigma(Field::RealWidth)));
/// # Ok::<(), depth_core::judge::Unsolvable>(())
/// ```
pub fn suspects(first: &Model, second: &Model) -> Vec<Suspect> {
    let log_ratio = log_ratio(first.optical_depth().m(), second.optical_depth().m());
    let comparison = Comparison::of(first, second);
    if comparison.is_fine() || log_ratio.abs() < 1e-12 {
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
        let ((length, l), (extent, x)) = (model.length(), model.extent());
        [(length, l.sigma.m()), (extent, x.sigma)]
    });
    let exact = inputs.filter(|&(_, sigma)| sigma == 0.0);
    let largest = [first, second]
        .into_iter()
        .flat_map(|model| model.relative_sigmas())
        .filter(|&(source, relative)| !matches!(source, Field::FocalLength | Field::Fy) && relative > 0.0)
        .max_by(|(_, a), (_, b)| a.total_cmp(b));

    let blunders = blunders.into_iter().map(|(_, blunder)| blunder);
    if comparison.agreement.is_none() {
        // Nobody has said how well anything is known.
        return blunders.collect();
    }
    blunders
        .chain(exact.map(|(source, _)| Suspect::NoSigma(source)))
        .chain(largest.map(|(source, _)| Suspect::LargestSigma(source)))
        .collect()
}

/// The typical blunders in a model, each with the logarithm of the factor by which it makes the distance too large.
fn blunders(model: &Model) -> Vec<(f64, Suspect)> {
    let (extent, _) = model.extent();
    let (length, _) = model.length();
    let mut list = Vec::new();
    if model.is_in_pixels() && extent == Field::Disparity {
        // OpenCV's fixed point; DepthAI's three, four and five sub-pixel bits; KITTI's 16-bit images.
        list.extend([16.0_f64, 8.0, 32.0, 256.0].map(|scale| (-scale.ln(), Suspect::RawDisparity { scale })));
    }
    if model.is_in_pixels() {
        list.extend([2.0_f64, 0.5].map(|times| (-times.ln(), Suspect::Resized { source: extent, times })));
    }
    for taken in LengthUnit::ALL {
        for meant in LengthUnit::COMMON.into_iter().filter(|&meant| meant != taken) {
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
