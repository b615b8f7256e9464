//! Whether an input can be used, and whether it is usual.

use super::inputs::Problem;
use crate::field::Field;
use crate::in_image::InImage;
use crate::judge::{self, Refusal};
use crate::quantity::Pixels;
use std::f64::consts::{FRAC_PI_2, PI};

impl Problem {
    /// Checks that the value of `field`, if it has one, can be used: positive, finite and normal. A disparity in pixels is judged
    /// together with doffs, which itself may be any finite number, as may zero; a tilt is below 90° in either direction, what an
    /// object subtends below 180°.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// assert_eq!(mug.check(Field::Disparity), Ok(()));
    /// mug.set(Field::Doffs, Some(-50.0));
    /// assert_eq!(mug.check(Field::Disparity), Err(depth_core::problem::Refusal::Zero));
    /// ```
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn check(&self, field: Field) -> Result<(), Refusal> {
        let value = match (field, self.effective_disparity()) {
            (Field::Disparity, Some(disparity)) => Some(disparity.px()),
            _ => self.get(field),
        };
        let Some(value) = value else { return Ok(()) };
        match field {
            Field::Doffs | Field::Zero => judge::finite(value)?,
            Field::Tilt => judge::finite(value).and_then(|tilt| below(tilt.abs(), FRAC_PI_2, Refusal::TurnedAway))?,
            Field::Disparity | Field::ImageWidth if self.is_angle(field) => {
                judge::positive(value).and_then(|angle| below(angle, PI, Refusal::TooWide))?
            }
            _ => judge::positive(value)?,
        };
        Ok(())
    }

    fn is_angle(&self, field: Field) -> bool {
        let extent = if field == Field::Disparity {
            self.disparity
        } else {
            self.image_width
        };
        matches!(extent, Some(InImage::Angle(_)))
    }

    /// Whether the value of `field` lies in its [usual range](Field::usual_range); true where there is none, and for what is
    /// measured in the image in another unit than pixels.
    ///
    /// ```
    /// # use depth_core::problem::{Field, Problem};
    /// let mut mug = Problem::default();
    /// mug.set(Field::FocalLength, Some(700.0));
    /// mug.set(Field::Baseline, Some(0.1));
    /// mug.set(Field::Disparity, Some(50.0));
    /// assert!(mug.is_usual(Field::Baseline));
    /// // 100 mm taken for meters.
    /// mug.set(Field::Baseline, Some(100.0));
    /// assert!(!mug.is_usual(Field::Baseline));
    /// ```
    pub fn is_usual(&self, field: Field) -> bool {
        let in_px = |in_image: Option<InImage>| in_image.and_then(|extent| Some(extent.px()?.value.px()));
        let value = match field {
            Field::Disparity => self.effective_disparity().map(Pixels::px),
            Field::FocalLength => in_px(self.focal_length),
            Field::Fy => in_px(self.fy),
            Field::ImageWidth => in_px(self.image_width),
            _ => self.get(field),
        };
        value.is_none_or(|value| field.is_usual(value))
    }
}

fn below(value: f64, limit: f64, refusal: Refusal) -> Result<f64, Refusal> {
    if value < limit { Ok(value) } else { Err(refusal) }
}
