//! Two distances to the same object: do they agree, what do they say together, and what is likely to be wrong if not.
//!
//! Both are computed from the same focal length. Its error moves both alike: it can neither make them disagree nor be
//! averaged away.

mod combination;
mod comparison;
mod suspects;

pub(crate) use combination::shared_relative_sigma;
pub use combination::{combine, weights};
pub use comparison::{Agreement, Comparison, LARGEST_RATIO, Verdict};
pub use suspects::{Suspect, suspects};
