//! What is said of numbers that can be read, in words.

use crate::baseline::Guess;
use crate::format::Format;
use crate::place::Origin;
use crate::sentences::{in_one_line, shown};
use crate::warning::{Statement, Warning};
use std::fmt;

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence(&[]))
    }
}

impl Warning {
    /// The sentence, with `names` for the files in their order.
    pub fn sentence(&self, names: &[&str]) -> String {
        let text = self.of_mismatch(names).unwrap_or_else(|| {
            if self.is_of_pair() {
                self.of_pair(names)
            } else {
                self.of_files(names)
            }
        });
        in_one_line(&text)
    }

    fn of_files(&self, names: &[&str]) -> String {
        match self {
            Self::Photo(warning) => warning.to_string(),
            Self::RectificationUnusable { why } => {
                format!("The rectification cannot be used: {why}. What was measured of the raw images is taken instead; rectify anew.")
            }
            Self::Raw { format } => raw(*format).to_owned(),
            Self::SizeContradicts { principal, side } => format!(
                "The principal point {principal} lies outside of the image, which is {side} pixels in size: the numbers are of another resolution."
            ),
            Self::Fisheye { camera, model } => {
                format!("{camera}: {model} is a model of a fisheye lens. Its focal length holds only after the images were undistorted.")
            }
            Self::NoPrincipalPoint { camera } => format!(
                "{camera}: the file has no principal point (cx, cy). The center of the image is taken, from which it may be some percent away."
            ),
            Self::FocalLength { fx, width } => format!(
                "A focal length of {} px is hardly one for an image {width} px wide: is it in mm?",
                fx.px()
            ),
            Self::Transposed { origin } => format!(
                "{} is transposed, as MATLAB has it: its last row was read as its last column.",
                at(origin, names)
            ),
            Self::SideBySide { size: [width, height] } => format!(
                "The size {width} × {height} is that of both images side by side: cx lies in the middle of its left half. One image is {} × {height}.",
                width / 2
            ),
            Self::Resized { camera, from, to } => {
                let ([width, height], [new_width, new_height]) = (from, to);
                format!(
                    "{camera}: fx, fy, cx and cy are scaled from {width} × {height} to {new_width} × {new_height}, the size of the images."
                )
            }
            Self::Binned { camera, binning, offset } => {
                let ([columns, rows], [x, y]) = (binning, offset);
                format!(
                    "{camera}: the numbers are those of the images as they are published, with binning {columns} × {rows} and a region of interest \
                     that begins at {x}, {y}."
                )
            }
            Self::SameFile { files } => {
                let [first, again] = files.map(|file| {
                    names
                        .get(file)
                        .map_or_else(|| format!("file {}", file + 1), |name| (*name).to_owned())
                });
                format!("{again} holds the same as {first}, and is left out.")
            }
            _ => "This is an RGB-D camera: its bf is a rounded distance of the projector, not a stereo baseline.".to_owned(),
        }
    }

    fn of_pair(&self, names: &[&str]) -> String {
        match self {
            Self::UnitUnknown { value, guess } => {
                let value = shown(*value);
                format!("The file does not say in which unit the baseline {value} is: {guess}")
            }
            Self::Swapped => {
                "Left and right are swapped: the second camera stands at the left. The baseline is taken without its sign.".to_owned()
            }
            Self::Vertical => "The cameras stand one above the other: count the disparity in rows, with fy.".to_owned(),
            Self::ZeroBaseline => "The baseline is zero: these are files of a single camera, or of one camera twice.".to_owned(),
            Self::Implausible { baseline } => format!(
                "A baseline of {} m is implausible: check the unit. Most lie between 1 mm and 5 m.",
                shown(baseline.m())
            ),
            Self::NegativeBaseline => "The baseline is negative in the file; it is taken without its sign.".to_owned(),
            Self::Doffs { of_file, of_points } => format!(
                "doffs is {} px in the file, but the principal points differ by {} px. The file’s doffs is taken.",
                shown(of_file.px()),
                shown(of_points.px())
            ),
            Self::Contradiction { used, other } => {
                let say = |one: &Statement| (at(&one.origin, names), one.value.clone());
                let ((used, value), (other, other_value)) = (say(used), say(other));
                format!("{used} says {value}, but {other} says {other_value}: {value} is used.")
            }
            Self::Many { cameras, pair: None } => format!("There are {cameras} cameras: choose which."),
            Self::Many {
                cameras,
                pair: Some([left, right]),
            } => format!("There are {cameras} cameras: {left} and {right} are taken as the pair."),
            Self::OneOfPair { other } => format!("This is one camera of a pair: for the baseline give the file {other} as well."),
            Self::ByDesign => {
                "The cameras are not calibrated: what is between them is how they were designed (specTranslation), not what was measured."
                    .to_owned()
            }
            Self::NoExtrinsics => "The baseline is not in it: give the file of the extrinsics as well.".to_owned(),
            _ => "There is no baseline in it.".to_owned(),
        }
    }
}

/// `T in line 12 of left.yaml`.
pub(crate) fn at(origin: &Origin, names: &[&str]) -> String {
    let place = origin.place().words(names);
    if place.is_empty() {
        origin.how.clone()
    } else {
        format!("{} in {place}", origin.how)
    }
}

impl fmt::Display for Guess {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unit(unit) => write!(f, "probably {}.", unit.symbol()),
            Self::Squares { size: 1.0 } => f.write_str("probably squares of the board, whose size the file does not say."),
            Self::Squares { size } => write!(f, "probably squares of the board, {size} each in the unit of its maker."),
        }
    }
}

const fn raw(format: Format) -> &'static str {
    match format {
        Format::Zed => "The values are of raw images. The SDK rectifies with others: ask it for those.",
        _ => "The values are of raw images; those of the rectified images, in which disparities are measured, differ.",
    }
}
