//! What was found in calibration files.

use crate::baseline::Baseline;
use crate::camera::{Basis, Camera};
use crate::format::Format;
use crate::pair::Pair;
use crate::place::Origin;
use crate::warning::Warning;
use depth_core::quantity::Pixels;

/// What calibration files say, and what is to be said of it.
#[derive(Clone, Debug, PartialEq)]
pub struct Found {
    /// Who wrote them.
    pub format: Format,
    /// The cameras in the order of the file, of a pair the left first.
    pub cameras: Vec<Camera>,
    /// The two of them that the baseline is between: the left one first, or the upper one.
    pub pair: Option<[usize; 2]>,
    /// Whether these two stand one above the other.
    pub is_vertical: bool,
    /// The distance of their lenses.
    pub baseline: Option<Baseline>,
    /// Where the baseline comes from; `None` where there is none.
    pub baseline_origin: Option<Origin>,
    /// cx of the right camera less cx of the left, of rectified images; of a vertical pair cy of the lower one less cy of the upper one.
    pub doffs: Option<Pixels>,
    /// Where doffs comes from; `None` where there is none.
    pub doffs_origin: Option<Origin>,
    /// Every two cameras that the files say something between, the pair that is taken first; see [`Found::choose`]. Of many at most 64.
    pub pairs: Vec<Pair>,
    /// What somebody has to know before they use it.
    pub warnings: Vec<Warning>,
    /// What else is in the files, which was not read, each with why not.
    pub ignored: Vec<String>,
}

impl Found {
    /// Nothing yet, in a file of this format.
    pub(crate) const fn of(format: Format) -> Self {
        Self {
            format,
            cameras: Vec::new(),
            pair: None,
            is_vertical: false,
            baseline: None,
            baseline_origin: None,
            doffs: None,
            doffs_origin: None,
            pairs: Vec::new(),
            warnings: Vec::new(),
            ignored: Vec::new(),
        }
    }

    /// Takes a baseline and where it comes from, or neither.
    pub(crate) fn measure(&mut self, baseline: Option<Baseline>, origin: Origin) {
        self.baseline_origin = baseline.map(|_| origin);
        self.baseline = baseline;
    }

    /// Are the focal length and the principal point those of rectified images?
    pub fn is_rectified(&self) -> bool {
        !self.cameras.is_empty() && self.cameras.iter().all(|camera| camera.basis == Basis::Rectified)
    }
}
