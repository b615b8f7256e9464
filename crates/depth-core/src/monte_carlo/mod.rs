//! The distribution of a distance by drawing its inputs at random: what the formulas of [`uncertainty`](super::uncertainty)
//! approximate, without an approximation.
//!
//! Two kinds of draw have no distance of their own, and leaving them out would bend the answer, so both are counted:
//!
//! - A divisor (d + δ, or w_img) of 0 or less: the object is **infinitely far** away. Going down through 0 is the limit of
//!   ever farther distances, so these draws belong at the far end.
//! - A focal length, baseline or real width of 0 or less, though none can be: the distance shrinks to **zero** with each of
//!   them, so these draws belong at the near end, at 0. (Only a σ of a quarter of the value or more makes them.)
//!
//! Both ends keep the order of the draws, so that every quantile is right; the mean and the standard deviation of such a
//! distance do not exist, and none is given.

mod distribution;
mod experiment;
mod random;

pub use distribution::{BINS, Distribution, Histogram, Quantiles};
pub use experiment::MonteCarlo;
