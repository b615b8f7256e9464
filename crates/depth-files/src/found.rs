//! What was found in calibration files.

use crate::format::Format;
use crate::place::Origin;
use depth_core::quantity::{Length, LengthUnit, Pixels};

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
    /// What somebody has to know before they use it.
    pub warnings: Vec<Warning>,
    /// What else is in the files, which was not read, each with why not.
    pub ignored: Vec<String>,
}

/// One camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// What the file calls it.
    pub name: String,
    /// Width and height of the images that the numbers are of.
    pub size: Option<[u32; 2]>,
    /// The focal lengths.
    pub fx: Pixels,
    /// The same, up and down.
    pub fy: Pixels,
    /// The principal point.
    pub cx: Pixels,
    /// The same, up and down.
    pub cy: Pixels,
    /// Of which images.
    pub basis: Basis,
    /// Where the focal lengths and the principal point come from.
    pub origin: Origin,
    /// The coefficients of the distortion, in the order of the file; none where the file has none.
    pub distortion: Vec<f64>,
    /// The name of the model, of the distortion or of the camera, where the file says one.
    pub model: Option<String>,
    /// 1 σ of fx, fy, cx and cy, where the file says it.
    pub sigma: Option<[Pixels; 4]>,
}

/// Of which images a focal length is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// As they come from the camera.
    Raw,
    /// Without distortion, with the same rows in both.
    Rectified,
}

/// How far the lenses are apart.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Baseline {
    /// In a unit that the file or its format says.
    Known(Length),
    /// In the unit in which somebody measured the board.
    InFileUnits {
        /// How many.
        value: f64,
        /// What the unit may be.
        guess: Guess,
    },
}

/// What the unit of a file may be that does not say it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Guess {
    /// One of these, by the number.
    Unit(LengthUnit),
    /// Squares of the board, whose size stands beside it in an unknown unit.
    Squares {
        /// That size.
        size: f64,
    },
}

impl Baseline {
    /// The length, where its unit is known or one unit of the file is `file_unit`.
    pub fn length(self, file_unit: Option<Length>) -> Option<Length> {
        match self {
            Self::Known(length) => Some(length),
            Self::InFileUnits { value, .. } => file_unit.map(|unit| Length::from_m(unit.m() * value)),
        }
    }
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

/// What somebody has to know of a calibration before they use it. The sentence is its `Display`.
#[derive(Clone, Debug, PartialEq)]
pub enum Warning {
    /// The file does not say in which unit the baseline is.
    UnitUnknown {
        /// So many of them.
        value: f64,
        /// What it may be.
        guess: Guess,
    },
    /// The second camera stands at the left.
    Swapped,
    /// One camera stands above the other.
    Vertical,
    /// Both cameras stand at the same place.
    ZeroBaseline,
    /// Hardly a baseline of anything.
    Implausible {
        /// As it is in the file.
        baseline: Length,
    },
    /// A baseline that is written as a negative number.
    NegativeBaseline,
    /// The rectified values cannot be used.
    RectificationUnusable {
        /// In a few words.
        why: String,
    },
    /// The values are of raw images.
    Raw {
        /// Who wrote them.
        format: Format,
    },
    /// cx or cy lies outside of the image.
    SizeContradicts {
        /// cx or cy, in pixels.
        principal: f64,
        /// The width or the height.
        side: u32,
    },
    /// The model is one of a fisheye lens.
    Fisheye {
        /// Its name.
        camera: String,
        /// What the file calls it.
        model: String,
    },
    /// Not a focal length in pixels.
    FocalLength {
        /// As it is in the file.
        fx: Pixels,
        /// Of the image.
        width: u32,
    },
    /// doffs and the principal points contradict each other.
    Doffs {
        /// As it is in the file.
        of_file: Pixels,
        /// How far they differ.
        of_points: Pixels,
    },
    /// Which two of many cameras are meant?
    Many {
        /// So many.
        cameras: usize,
        /// The names of those that are taken.
        pair: Option<[String; 2]>,
    },
    /// One camera of a pair.
    OneOfPair {
        /// Which file the other is in.
        other: &'static str,
    },
    /// Two cameras without what is between them.
    NoExtrinsics,
    /// A baseline that belongs to a depth camera.
    DepthCamera,
    /// The file has no cx and cy: they are those of the center.
    NoPrincipalPoint {
        /// Its name.
        camera: String,
    },
    /// The baseline is how the cameras were designed, not measured.
    ByDesign,
    /// A single camera.
    NoBaseline {
        /// Who wrote it.
        format: Format,
    },
}
