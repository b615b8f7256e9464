//! Why a calibration cannot be read, in words.

use crate::format::Format;
use crate::number::brief;
use crate::place::Place;
use crate::refusal::Refusal;
use std::fmt;

/// So many names of cameras are listed where one is not found.
const SHOWN: usize = 8;

impl fmt::Display for Refusal {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.sentence(&[]))
    }
}

impl Refusal {
    /// The sentence, with `names` for the files in their order.
    pub fn sentence(&self, names: &[&str]) -> String {
        in_one_line(&self.text(names))
    }

    fn text(&self, names: &[&str]) -> String {
        match self {
            Self::Empty => "The file is empty.".to_owned(),
            Self::TooLarge { megabytes } => format!("The file is larger than any calibration: more than {megabytes} MB."),
            Self::Binary { what: Some(what), todo } => format!("This is {what}, not text. {todo}"),
            Self::Binary { what: None, todo } => format!("This is a binary file, not a calibration in text. {todo}"),
            Self::Other { what, todo } => format!("This is {what}. {todo}"),
            Self::Damaged { what, reason } => format!("This is {what}, but it is truncated or damaged: {reason}."),
            Self::Syntax { what, place, reason } => {
                let line = upper(&place.words(names));
                format!("{line} is not {what} ({reason}): the file may be truncated, or a line in it be damaged.")
            }
            Self::TooDeep => "It is nested too deeply for a calibration: brackets within brackets.".to_owned(),
            Self::TooMuch => "It holds more numbers than any calibration has, or its aliases stand for so many.".to_owned(),
            Self::Mixed { formats: [first, second] } => format!(
                "These files do not go together: one is {}, another {}. Give the two of one pair.",
                first.title(),
                second.title()
            ),
            Self::Unknown => {
                "No calibration is recognized in it: there is no camera matrix under a name that OpenCV, ROS, Kalibr, KITTI, COLMAP or others use."
                    .to_owned()
            }
            Self::InFile { file, refusal } => match names.get(*file) {
                Some(name) if names.len() > 1 => format!("{name}: {}", refusal.sentence(names)),
                None if *file > 0 => format!("File {}: {}", file + 1, refusal.sentence(names)),
                _ => refusal.sentence(names),
            },
            Self::Photo {
                size: [width, height],
                maker,
                has_exif,
                lens_mm,
            } => {
                let maker = maker.as_ref().map_or_else(String::new, |maker| format!(" by {maker}"));
                let photo = format!("This is a photograph{maker}, a JPEG of {width} × {height} pixels");
                photo_without_focal_length(&photo, *has_exif, *lens_mm)
            }
            Self::OneFile { format: Format::Exif } => "Each photograph says the focal length of its own camera: give one at a time.".to_owned(),
            Self::OneFile { format } => format!(
                "{} holds all cameras in one file: give one of these at a time.",
                upper(format.title())
            ),
            Self::NoSuchCamera { name, cameras } => {
                let more = cameras.len().saturating_sub(SHOWN);
                let more = if more == 0 { String::new() } else { format!(" and {more} others") };
                let some: Vec<String> = cameras.iter().take(SHOWN).map(|name| format!("“{name}”")).collect();
                format!("No camera, or more than one, is meant by “{name}”: there are {}{more}.", some.join(", "))
            }
            Self::TwoCameras => "One camera is chosen, or two that are a pair.".to_owned(),
            Self::NotANumber { format, .. }
            | Self::Count { format, .. }
            | Self::Missing { format, .. }
            | Self::NotPinhole { format, .. }
            | Self::NotQ { format, .. }
            | Self::FocalLength { format, .. }
            | Self::ManyCameras { format } => format!("This is {}, but {}", format.title(), self.but(names)),
        }
    }

    /// What keeps a file from being read whose format is known.
    fn but(&self, names: &[&str]) -> String {
        match self {
            Self::NotANumber { name, place, text, .. } => {
                let hint = decimal_comma(text).map_or_else(String::new, |point| format!(" Write it with a point: {point}."));
                format!("in {} “{text}” of {name} is not a number.{hint}", named(*place, names))
            }
            Self::Count {
                name,
                place,
                count,
                expected,
                ..
            } => {
                let is_doubled = expected.parse::<usize>().is_ok_and(|expected| *count == 2 * expected);
                let hint = if is_doubled {
                    " If commas are decimal there, write points."
                } else {
                    ""
                };
                format!("in {} {name} has {count} numbers, not {expected}.{hint}", named(*place, names))
            }
            Self::Missing { what, .. } => format!("it has no {what}."),
            Self::NotPinhole { model, place, .. } => format!(
                "the model “{model}” in {} is no pinhole: its first number is not a focal length. \
                 Calibrate with a pinhole model, or undistort the images and give the new camera matrix.",
                named(*place, names)
            ),
            Self::NotQ {
                name,
                place,
                entry: [row, column],
                found,
                ..
            } => format!(
                "in {} {name}[{row}][{column}] is {found}, which no such matrix has.",
                named(*place, names)
            ),
            Self::FocalLength { fx, place, .. } => {
                format!("in {} the focal length {fx} is not a number above zero.", named(*place, names))
            }
            _ => "it has more cameras than can be chosen among.".to_owned(),
        }
    }
}

/// What a photograph lacks that says no focal length in pixels, and what to do.
fn photo_without_focal_length(photo: &str, has_exif: bool, lens_mm: Option<f64>) -> String {
    if let Some(lens) = lens_mm {
        return format!(
            "{photo}. Its EXIF says that the lens has {} mm, but not how large a pixel of the sensor is (FocalPlaneXResolution), nor the equivalent on \
             35 mm film: look up one of these, and type it in the calculator as the focal length.",
            brief(lens)
        );
    }
    let lacks = if has_exif {
        "but its EXIF has no focal length"
    } else {
        "but without EXIF, which messengers and many websites remove"
    };
    format!(
        "{photo}, {lacks}. Give the photo as the camera made it, or type the 35 mm equivalent of its data sheet in the calculator as the focal length."
    )
}

impl Place {
    /// `line 12`, and of which file where there are several: `line 12 of right.yaml`; nothing of the only file, where it has no lines.
    pub fn words(self, names: &[&str]) -> String {
        let Self { file, line } = self;
        let line = if line == 0 { String::new() } else { format!("line {line}") };
        let of = match names.get(file) {
            Some(_) if names.len() == 1 => String::new(),
            Some(name) => (*name).to_owned(),
            None if file == 0 => String::new(),
            None => format!("file {}", file + 1),
        };
        let between = if line.is_empty() || of.is_empty() { "" } else { " of " };
        format!("{line}{between}{of}")
    }
}

/// A place in a sentence: a file without lines by that word.
fn named(place: Place, names: &[&str]) -> String {
    let words = place.words(names);
    if words.is_empty() { "the file".to_owned() } else { words }
}

/// `700,5` with a point.
fn decimal_comma(text: &str) -> Option<String> {
    let (whole, part) = text.split_once(',')?;
    let are_digits = !part.is_empty() && part.starts_with(|one: char| one.is_ascii_digit());
    let point = format!("{whole}.{part}");
    crate::number::number(&point).filter(|_| are_digits).map(|_| point)
}

/// A text in which a file is quoted, without its ends of lines and what else cannot be seen.
pub(crate) fn in_one_line(text: &str) -> String {
    text.chars().map(|one| if one.is_control() { ' ' } else { one }).collect()
}

/// With a capital letter.
fn upper(text: &str) -> String {
    let mut all = text.chars();
    all.next().map_or_else(String::new, |first| {
        std::iter::once(first.to_ascii_uppercase()).chain(all).collect()
    })
}

/// A number without what the computer’s arithmetic added to it.
pub(crate) fn shown(number: f64) -> f64 {
    format!("{number:.8e}").parse().unwrap_or(number)
}
