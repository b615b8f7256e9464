//! What is said of calibration files.

use crate::format::Format;
use crate::found::{Guess, Warning};
use crate::place::Place;
use crate::refusal::Refusal;
use std::fmt;

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence(&[]))
    }
}

impl Refusal {
    /// The sentence, with `names` for the files in their order.
    pub fn sentence(&self, names: &[&str]) -> String {
        match self {
            Self::Empty => "The file is empty.".to_owned(),
            Self::TooLarge => "The file is larger than any calibration: more than 16 MB.".to_owned(),
            Self::Binary { what: Some(what), todo } => format!("This is {what}, not text. {todo}"),
            Self::Binary { what: None, todo } => format!("This is a binary file, not a calibration in text. {todo}"),
            Self::Other { what, todo } => format!("This is {what}. {todo}"),
            Self::Damaged { what, reason } => format!("This is {what}, but it is truncated or damaged: {reason}."),
            Self::Syntax { what, place, reason } => {
                let line = upper(&place.words(names));
                format!("{line} is not {what} ({reason}): the file may be truncated, or a line in it be damaged.")
            }
            Self::TooDeep => "It is nested too deeply for a calibration: brackets within brackets.".to_owned(),
            Self::TooMuch => "Its aliases stand for more numbers than any calibration has.".to_owned(),
            Self::Mixed { formats: [first, second] } => format!(
                "These files do not go together: one is {}, another {}. Give the two of one pair.",
                first.title(),
                second.title()
            ),
            Self::Unknown => {
                "No calibration is recognized in it: there is no camera matrix under a name that OpenCV, ROS, Kalibr, KITTI, COLMAP or others use."
                    .to_owned()
            }
            Self::NotANumber { format, .. }
            | Self::Count { format, .. }
            | Self::Missing { format, .. }
            | Self::NotPinhole { format, .. }
            | Self::FocalLength { format, .. } => format!("This is {}, but {}", format.title(), self.but(names)),
        }
    }

    /// What keeps a file from being read whose format is known.
    fn but(&self, names: &[&str]) -> String {
        match self {
            Self::NotANumber { name, place, text, .. } => {
                format!("in {} “{text}” of {name} is not a number.", place.words(names))
            }
            Self::Count {
                name,
                place,
                count,
                expected,
                ..
            } => format!("in {} {name} has {count} numbers, not {expected}.", place.words(names)),
            Self::Missing { what, .. } => format!("it has no {what}."),
            Self::NotPinhole { model, place, .. } => format!(
                "the model “{model}” in {} is no pinhole: its first number is not a focal length. \
                 Calibrate with a pinhole model, or undistort the images and give the new camera matrix.",
                place.words(names)
            ),
            Self::FocalLength { fx, place, .. } => {
                format!("in {} the focal length {fx} is not a number above zero.", place.words(names))
            }
            _ => String::new(),
        }
    }
}

impl Place {
    /// `line 12`, and of which file where there are several: `line 12 of right.yaml`.
    pub fn words(self, names: &[&str]) -> String {
        let Self { file, line } = self;
        let line = if line == 0 { String::new() } else { format!("line {line}") };
        let of = match names.get(file) {
            Some(_) if names.len() == 1 => String::new(),
            Some(name) => (*name).to_owned(),
            None if file == 0 => String::new(),
            None => format!("file {}", file + 1),
        };
        if line.is_empty() && of.is_empty() {
            return "the file".to_owned();
        }
        let between = if line.is_empty() || of.is_empty() { "" } else { " of " };
        format!("{line}{between}{of}")
    }
}

/// With a capital letter.
fn upper(text: &str) -> String {
    let mut all = text.chars();
    all.next()
        .map_or_else(String::new, |first| first.to_uppercase().chain(all).collect())
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnitUnknown { value, guess } => {
                let value = shown(*value);
                write!(f, "The file does not say in which unit the baseline {value} is: {guess}")
            }
            Self::Implausible { baseline } => write!(
                f,
                "A baseline of {} m is implausible: check the unit. Most lie between 1 mm and 5 m.",
                shown(baseline.m())
            ),
            Self::RectificationUnusable { why } => write!(
                f,
                "The rectification cannot be used: {why}. What was measured of the raw images is taken instead; rectify anew."
            ),
            Self::SizeContradicts { principal, side } => write!(
                f,
                "The principal point {principal} lies outside of the image, which is {side} pixels in size: the numbers are of another resolution."
            ),
            Self::Fisheye { camera, model } => write!(
                f,
                "{camera}: {model} is a model of a fisheye lens. Its focal length holds only after the images were undistorted."
            ),
            Self::FocalLength { fx, width } => write!(
                f,
                "A focal length of {} px is hardly one for an image {width} px wide: is it in mm?",
                fx.px()
            ),
            Self::Doffs { of_file, of_points } => write!(
                f,
                "doffs is {} px in the file, but the principal points differ by {} px. The file’s doffs is taken.",
                shown(of_file.px()),
                shown(of_points.px())
            ),
            Self::Many { cameras, pair: None } => write!(f, "There are {cameras} cameras: choose which."),
            Self::Many {
                cameras,
                pair: Some([left, right]),
            } => {
                write!(f, "There are {cameras} cameras: {left} and {right} are taken as the pair.")
            }
            Self::OneOfPair { other } => write!(f, "This is one camera of a pair: for the baseline give the file {other} as well."),
            Self::NoPrincipalPoint { camera } => write!(
                f,
                "{camera}: the file has no principal point (cx, cy). The center of the image is taken, from which it may be some percent away."
            ),
            _ => f.write_str(self.fixed()),
        }
    }
}

impl Warning {
    /// The sentence of a warning in which nothing of the file is said.
    const fn fixed(&self) -> &'static str {
        match self {
            Self::Swapped => "Left and right are swapped: the second camera stands at the left. The baseline is taken without its sign.",
            Self::Vertical => "The cameras stand one above the other: count the disparity in rows, with fy.",
            Self::ZeroBaseline => "The baseline is zero: these are files of a single camera, or of one camera twice.",
            Self::NegativeBaseline => "The baseline is negative in the file; it is taken without its sign.",
            Self::Raw { format } => raw(*format),
            Self::NoExtrinsics => "The baseline is not in it: give the file of the extrinsics as well.",
            Self::DepthCamera => "This is an RGB-D camera: its bf is a rounded distance of the projector, not a stereo baseline.",
            Self::ByDesign => {
                "The cameras are not calibrated: what is between them is how they were designed (specTranslation), not what was measured."
            }
            Self::NoBaseline { .. } => "There is no baseline in it.",
            _ => "",
        }
    }
}

impl fmt::Display for Guess {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Unit(unit) => write!(f, "probably {}.", unit.symbol()),
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

/// A number without what the computer’s arithmetic added to it.
fn shown(number: f64) -> f64 {
    format!("{number:.8e}").parse().unwrap_or(number)
}
