//! What is to be said of numbers that can be read.

use crate::baseline::Guess;
use crate::format::Format;
use crate::photo_warning::PhotoWarning;
use crate::place::{Origin, Place};
use depth_core::quantity::{Length, Pixels};

/// Something that a file says, and where.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Statement {
    /// The number, with its unit where it has one: `0.12 m`.
    pub value: String,
    /// Where it comes from.
    pub origin: Origin,
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
    /// cx or cy of the raw images lies outside of them, in a file that has both these and rectified ones.
    RawSizeContradicts {
        /// Which camera.
        camera: String,
        /// cx or cy, in pixels.
        principal: f64,
        /// The width or the height.
        side: u32,
    },
    /// The model is one of a fisheye lens.
    Fisheye {
        /// Which camera.
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
    /// Two numbers of the files say different things of the same.
    Contradiction {
        /// What is used.
        used: Statement,
        /// What else is said.
        other: Statement,
    },
    /// Cameras that are said to be rectified have not the same focal length.
    FocalLengths {
        /// That of one of them.
        one: Statement,
        /// That of the other.
        other: Statement,
    },
    /// The images of the two cameras are not of the same size.
    Sizes {
        /// Those of the one, and those of the other.
        sizes: [[u32; 2]; 2],
    },
    /// Only the order of the files says which camera is the left one.
    FileOrder,
    /// Only the order of the files says which camera has which number.
    Unnumbered,
    /// The second camera stands above the first.
    SwappedRows,
    /// One camera stands in front of the other.
    Ahead,
    /// A matrix whose last number is not 1.
    Scale {
        /// Where it stands.
        origin: Origin,
        /// The number.
        last: f64,
    },
    /// The rectified images have not the size that the file says.
    RectifiedSize {
        /// Which camera.
        camera: String,
        /// As it is in the file.
        size: [u32; 2],
        /// So many times as large are the rectified images.
        ratio: f64,
    },
    /// A key stands twice in the same map.
    Doubled {
        /// The key.
        key: String,
        /// Where it stands first, and where it stands last.
        places: [Place; 2],
    },
    /// A camera matrix with rows for columns, as MATLAB has it.
    Transposed {
        /// Where it stands.
        origin: Origin,
    },
    /// The size is that of both images side by side.
    SideBySide {
        /// As it is in the file.
        size: [u32; 2],
    },
    /// The numbers of the file are those of another size than its images have.
    Resized {
        /// Which camera.
        camera: String,
        /// The size that the numbers of the file are of.
        from: [u32; 2],
        /// The size of the images, for which the numbers were computed.
        to: [u32; 2],
    },
    /// The images are a part of what the camera sees, or have several of its pixels in one.
    Binned {
        /// Which camera.
        camera: String,
        /// So many columns and rows of pixels are one of the image.
        binning: [u32; 2],
        /// The first column and the first row of the image, in pixels of the camera.
        offset: [u32; 2],
    },
    /// A file is given twice.
    SameFile {
        /// Which it is given as, and which it is again, counted from 0.
        files: [usize; 2],
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
        /// Which camera.
        camera: String,
    },
    /// The baseline is how the cameras were designed, not measured.
    ByDesign,
    /// A single camera.
    NoBaseline {
        /// Who wrote it.
        format: Format,
    },
    /// The focal length comes from a photograph.
    Photo(PhotoWarning),
}

impl Warning {
    /// Whether it is of two cameras together, and falls away where others are chosen.
    pub(crate) const fn is_of_pair(&self) -> bool {
        matches!(
            self,
            Self::UnitUnknown { .. }
                | Self::Swapped
                | Self::Vertical
                | Self::ZeroBaseline
                | Self::ByDesign
                | Self::Implausible { .. }
                | Self::NegativeBaseline
                | Self::Doffs { .. }
                | Self::Contradiction { .. }
                | Self::FocalLengths { .. }
                | Self::Sizes { .. }
                | Self::FileOrder
                | Self::Unnumbered
                | Self::SwappedRows
                | Self::Ahead
                | Self::Many { .. }
                | Self::OneOfPair { .. }
                | Self::NoExtrinsics
                | Self::NoBaseline { .. }
        )
    }

    /// Whether it follows from the numbers of a camera alone, and is found anew where others are chosen.
    pub(crate) const fn follows(&self) -> bool {
        matches!(self, Self::SizeContradicts { .. } | Self::FocalLength { .. })
    }

    /// The camera that it is of, if it is of one.
    pub(crate) fn camera(&self) -> Option<&str> {
        match self {
            Self::Fisheye { camera, .. }
            | Self::NoPrincipalPoint { camera }
            | Self::RawSizeContradicts { camera, .. }
            | Self::RectifiedSize { camera, .. }
            | Self::Resized { camera, .. }
            | Self::Binned { camera, .. } => Some(camera),
            _ => None,
        }
    }
}
