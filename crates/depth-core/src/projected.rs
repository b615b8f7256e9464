//! [`Projected`]: an extent in the image with its focal length.

use crate::angle::Angle;
use crate::field::Field;
use crate::in_image::{InImage, extent_of};
use crate::judge::{Refusal, Term, Unsolvable};
use crate::measured::Measured;
use std::f64::consts::PI;

/// An extent in the image and the focal length that belongs to it, as numbers of one unit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Projected {
    pub(crate) focal_length: Measured<f64>,
    pub(crate) extent: Measured<f64>,
    /// The extent, where it is an angle.
    pub(crate) angle: Option<Measured<Angle>>,
    pub(crate) is_in_pixels: bool,
}

impl Projected {
    /// Of an `extent`, which `source` is, and a focal length in the same unit; an angle needs none.
    ///
    /// # Errors
    /// [`Refusal::OtherUnit`] about the extent, and [`Refusal::TooWide`] for an angle of 180° or more.
    pub(crate) fn new(focal_length: InImage, extent: InImage, source: Field) -> Result<Self, Unsolvable> {
        let refused = |refusal| {
            Err(Unsolvable::Value {
                term: Term::Input(source),
                refusal,
            })
        };
        match (focal_length, extent) {
            (_, InImage::Angle(angle)) if angle.value.radians() >= PI => refused(Refusal::TooWide),
            (_, InImage::Angle(angle)) => Ok(Self {
                focal_length: Measured::exact(1.0),
                extent: extent_of(angle),
                angle: Some(angle),
                is_in_pixels: false,
            }),
            (InImage::Pixels(_), InImage::Pixels(_)) | (InImage::OnSensor(_), InImage::OnSensor(_)) => Ok(Self {
                focal_length: focal_length.to_base(),
                extent: extent.to_base(),
                angle: None,
                is_in_pixels: extent.px().is_some(),
            }),
            _ => refused(Refusal::OtherUnit),
        }
    }
}
