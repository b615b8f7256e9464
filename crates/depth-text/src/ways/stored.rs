//! What files, programs and networks store for a pixel, a disparity or a depth, and what that is to a pair of cameras.

use crate::field::Key;
use crate::note::{Issue, Note};
use crate::number::plain;
use depth_core::disparity::{Encoding, KINECT_V1_BASELINE, KINECT_V1_FOCAL_LENGTH, NoDisparity};
use depth_core::problem::{Field, Method, Problem};
use depth_core::quantity::{Length, Pixels};
use depth_core::stereo;
use depth_core::stored::DepthEncoding;

/// How a disparity or a depth is stored.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Stored {
    /// A disparity.
    Disparity(Encoding),
    /// A depth.
    Depth(DepthEncoding),
}

/// What a stored number says.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Decoded {
    /// The disparity; of a depth the one that it would be, where the cameras are known.
    pub disparity: Option<Pixels>,
    /// The depth; of a disparity where the cameras are known.
    pub distance: Option<Length>,
}

/// The number in a field, in its base unit, where there is one.
pub type Values<'a> = &'a dyn Fn(Key) -> Option<f64>;

/// Why it is not known what is stored.
#[derive(Clone, Debug, PartialEq)]
pub enum NotStored {
    /// A field has no number.
    Missing(Key),
    /// A number that cannot be right.
    Wrong(Note),
}

impl Stored {
    /// What `number` says, seen by the pair of cameras in `camera`: its focal length, baseline and doffs.
    ///
    /// # Errors
    /// [`NoDisparity`].
    pub fn decode(self, number: f64, camera: &Problem) -> Result<Decoded, NoDisparity> {
        let offset = camera.offset().value.px();
        Ok(match self {
            Self::Disparity(encoding) => {
                let disparity = encoding.decode(number)?;
                Decoded {
                    disparity: Some(disparity),
                    distance: camera.depth_at(Pixels::new(disparity.px() + offset)),
                }
            }
            Self::Depth(encoding) => {
                let distance = encoding.decode(number)?;
                let cameras = focal_length(camera).zip(camera.baseline);
                let seen = cameras.map(|(focal_length, baseline)| stereo::disparity(focal_length, baseline.value, distance).px() - offset);
                Decoded {
                    disparity: seen.filter(|disparity| disparity.is_finite()).map(Pixels::new),
                    distance: Some(distance),
                }
            }
        })
    }

    /// Focal length and baseline of the one camera that stores so.
    pub fn own_camera(self) -> Option<(Pixels, Length)> {
        (self == Self::Disparity(Encoding::KinectV1)).then_some((KINECT_V1_FOCAL_LENGTH, KINECT_V1_BASELINE))
    }

    /// What to say where a file with 16 bits may have been read with 8.
    pub fn eight_bits(self, number: f64) -> Option<Issue> {
        let has_16_bits = matches!(
            self,
            Self::Disparity(Encoding::Kitti | Encoding::Cityscapes | Encoding::KinectV1) | Self::Depth(DepthEncoding::Steps { .. })
        );
        (has_16_bits && number > 0.0 && number <= 255.0).then(|| Issue::EightBits { number: plain(number) })
    }

    /// What to say where a number is none of this encoding.
    pub(super) const fn refusal(self, reason: NoDisparity) -> Issue {
        match (self, reason) {
            (Self::Depth(_), NoDisparity::Invalid) => Issue::NoDepth,
            _ => Issue::NotADisparity { reason },
        }
    }
}

/// The focal length of a pair of cameras, where it is in pixels.
pub(super) fn focal_length(camera: &Problem) -> Option<Pixels> {
    Some(camera.focal_length_of(Method::Stereo)?.px()?.value)
}

/// A pair of cameras of which nothing else is known.
pub(super) fn pair(focal_length: Pixels, baseline: Length) -> Problem {
    let mut pair = Problem::default();
    pair.set(Field::FocalLength, Some(focal_length.px()));
    pair.set(Field::Baseline, Some(baseline.m()));
    pair
}

/// The number in the field `key`.
pub(super) fn needed(of: Values<'_>, key: Key) -> Result<f64, NotStored> {
    of(key).ok_or(NotStored::Missing(key))
}

/// `value`, that of the field `key`, where it is above zero.
pub(super) fn positive(value: f64, key: Key) -> Result<f64, NotStored> {
    let value = not_zero(value, key)?;
    if value > 0.0 {
        Ok(value)
    } else {
        wrong(key, Issue::Negative { key })
    }
}

/// `value`, that of the field `key`, where it is a number other than zero.
pub(super) fn not_zero(value: f64, key: Key) -> Result<f64, NotStored> {
    match finite(value, key)? {
        0.0 => wrong(key, Issue::Zero { key }),
        value => Ok(value),
    }
}

/// `value`, that of the field `key`, where it is a finite number.
pub(super) fn finite(value: f64, key: Key) -> Result<f64, NotStored> {
    if value.is_finite() {
        Ok(value)
    } else {
        let text = value.to_string();
        wrong(key, Issue::TooExtreme { key, text })
    }
}

pub(super) const fn wrong<T>(key: Key, issue: Issue) -> Result<T, NotStored> {
    Err(NotStored::Wrong(Note::error(key, issue)))
}
