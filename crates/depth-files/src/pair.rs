//! Two cameras of a file.

use crate::baseline::Baseline;
use crate::place::Origin;
use crate::warning::Warning;
use depth_core::quantity::Pixels;

/// Two cameras, and what the files say between them.
#[derive(Clone, Debug, PartialEq)]
pub struct Pair {
    /// Their places in [`Found::cameras`](crate::Found::cameras): the left one first, or the upper one.
    pub cameras: [usize; 2],
    /// Whether they stand one above the other.
    pub is_vertical: bool,
    /// The distance of their lenses.
    pub baseline: Option<Baseline>,
    /// Where the baseline comes from; `None` where there is none.
    pub baseline_origin: Option<Origin>,
    /// As in [`Found::doffs`](crate::Found::doffs).
    pub doffs: Option<Pixels>,
    /// Where doffs comes from; `None` where there is none.
    pub doffs_origin: Option<Origin>,
    /// What is to be said of the two together.
    pub warnings: Vec<Warning>,
}
