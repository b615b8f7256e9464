//! What is said of numbers that do not go together, in words.

use crate::remarks::at;
use crate::sentences::shown;
use crate::warning::{Statement, Warning};

impl Warning {
    /// The sentence, where this is of numbers that do not go together.
    pub(crate) fn of_mismatch(&self, names: &[&str]) -> Option<String> {
        Some(match self {
            Self::FocalLengths { one, other } => {
                let say = |said: &Statement| format!("{} in {}", said.value, at(&said.origin, names));
                format!(
                    "Rectified cameras have the same focal length, but here it is {}, and {}: the files are stale or mixed.",
                    say(one),
                    say(other)
                )
            }
            Self::Sizes { sizes } => {
                let [[width, height], [other_width, other_height]] = sizes;
                format!(
                    "The images of the two cameras are of different sizes, {width} × {height} and {other_width} × {other_height}: the files \
                     are stale or mixed, and doffs is unknown."
                )
            }
            Self::FileOrder => "The files do not say which camera is which: the first file is taken as the left one.".to_owned(),
            Self::SwappedRows => {
                "Upper and lower are swapped: the second camera stands above the first. The baseline is taken without its sign.".to_owned()
            }
            Self::Ahead => {
                "One camera stands in front of the other rather than beside it: this is no stereo pair, and its disparity does not say the distance."
                    .to_owned()
            }
            Self::Scale { origin, last } => format!(
                "The last number of {} is {}, not 1: all of its numbers are divided by it.",
                at(origin, names),
                shown(*last)
            ),
            Self::RectifiedSize {
                camera,
                size: [width, height],
                ratio,
            } => format!(
                "{camera}: the rectified images are {} times as large as {width} × {height}, the size that the file says: the numbers are \
                 those of the rectified images.",
                shown((ratio * 100.0).round() / 100.0)
            ),
            Self::RawSizeContradicts { camera, principal, side } => format!(
                "{camera}: the principal point {principal} of its raw images lies outside of them, as the file says that they are {side} pixels in \
                 size: its lines are of several resolutions."
            ),
            Self::Unnumbered => {
                "The files do not say which camera is cam0: it is the first that was given. Where they stand is what the files say.".to_owned()
            }
            Self::Doubled { key, places } => {
                let [first, last] = places.map(|place| place.words(names));
                format!("“{key}” stands twice, in {first} and in {last}: the last one is taken.")
            }
            _ => return None,
        })
    }
}
