//! What is said of calibration files.

use crate::format::Format;
use crate::found::{Guess, Warning};
use crate::refusal::Refusal;
use std::fmt;

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Empty => write!(f, "The file is empty."),
            Self::TooLarge => write!(f, "The file is larger than any calibration: more than 16 MB."),
            Self::Binary { what: Some(what), todo } => write!(f, "This is {what}, not text. {todo}"),
            Self::Binary { what: None, todo } => write!(f, "This is a binary file, not a calibration in text. {todo}"),
            Self::Other { what, todo } => write!(f, "This is {what}. {todo}"),
            Self::Syntax { what, line, reason } => write!(
                f,
                "Line {line} is not {what} ({reason}): the file may be truncated, or a line in it be damaged."
            ),
            Self::TooDeep => write!(f, "It is nested too deeply for a calibration: brackets within brackets."),
            Self::TooMuch => write!(f, "Its aliases stand for more numbers than any calibration has."),
            Self::NotANumber { format, name, line, text } => {
                let title = format.title();
                write!(f, "This is {title}, but in line {line} “{text}” of {name} is not a number.")
            }
            Self::Count {
                format,
                name,
                line,
                count,
                expected,
            } => write!(
                f,
                "This is {}, but in line {line} {name} has {count} numbers, not {expected}.",
                format.title()
            ),
            Self::Missing { format, what } => write!(f, "This is {}, but it has no {what}.", format.title()),
            Self::NotPinhole { format, model, line } => write!(
                f,
                "This is {}, but the model “{model}” in line {line} is no pinhole: its first number is not a focal length. \
                 Calibrate with a pinhole model, or undistort the images and give the new camera matrix.",
                format.title()
            ),
            Self::FocalLength { format, fx, line } => write!(
                f,
                "This is {}, but in line {line} the focal length {fx} is not a number above zero.",
                format.title()
            ),
            Self::Mixed { formats: [first, second] } => write!(
                f,
                "These files do not go together: one is {}, another {}. Give the two of one pair.",
                first.title(),
                second.title()
            ),
            Self::Unknown => write!(
                f,
                "No calibration is recognized in it: there is no camera matrix under a name that OpenCV, ROS, Kalibr, KITTI, COLMAP or others use."
            ),
        }
    }
}

impl fmt::Display for Warning {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::UnitUnknown { value, guess } => {
                let value = shown(*value);
                write!(f, "The file does not say in which unit the baseline {value} is: {guess}")
            }
            Self::Swapped => write!(
                f,
                "Left and right are swapped: the second camera stands at the left. The baseline is taken without its sign."
            ),
            Self::Vertical => write!(f, "The cameras stand one above the other: count the disparity in rows, with fy."),
            Self::ZeroBaseline => write!(
                f,
                "The baseline is zero: these are files of a single camera, or of one camera twice."
            ),
            Self::Implausible { baseline } => write!(
                f,
                "A baseline of {} m is implausible: check the unit. Most lie between 1 mm and 5 m.",
                shown(baseline.m())
            ),
            Self::NegativeBaseline => write!(f, "The baseline is negative in the file; it is taken without its sign."),
            Self::RectificationUnusable { why } => write!(
                f,
                "The rectification cannot be used: {why}. What was measured of the raw images is taken instead; rectify anew."
            ),
            Self::Raw { format } => f.write_str(raw(*format)),
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
            Self::NoExtrinsics => write!(f, "The baseline is not in it: give the file of the extrinsics as well."),
            Self::DepthCamera => write!(
                f,
                "This is an RGB-D camera: its bf is a rounded distance of the projector, not a stereo baseline."
            ),
            Self::NoBaseline { .. } => write!(f, "There is no baseline in it."),
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
