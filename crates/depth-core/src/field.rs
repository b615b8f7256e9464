//! [`Field`]: the inputs of a distance.

use crate::quantity::{Length, LengthUnit};
use std::f64::consts::FRAC_PI_2;

/// An input of a distance.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum Field {
    /// fx, px or a length
    FocalLength,
    /// The focal length of the lens that fx was computed from, a length; none where fx was calibrated
    Lens,
    /// fy, px or a length: for a height or a vertical pair; fx where it is not known
    Fy,
    /// b, a length
    Baseline,
    /// d, px, a length or an angle
    Disparity,
    /// δ = cx_right − cx_left, px: 0 where the principal points coincide
    Doffs,
    /// w_img, px, a length or an angle
    ImageWidth,
    /// w_real, a length
    RealWidth,
    /// φ, an angle: by how much the object is turned away from facing the camera
    Tilt,
    /// How far in front of the lens distances are counted from, a length
    Zero,
}

impl Field {
    /// Every field, in reading order.
    pub const ALL: [Self; 10] = [
        Self::FocalLength,
        Self::Lens,
        Self::Fy,
        Self::Baseline,
        Self::Disparity,
        Self::Doffs,
        Self::ImageWidth,
        Self::RealWidth,
        Self::Tilt,
        Self::Zero,
    ];

    /// The range outside which a value deserves a warning, in px, meters or radians. What is measured in an image has one in
    /// pixels only.
    ///
    /// Wide on purpose: the presets of real cameras lie far inside; a value outside is nearly always a slip of the unit.
    ///
    /// ```
    /// use depth_core::field::Field;
    ///
    /// // From 5 mm to 5 m.
    /// assert_eq!(Field::Baseline.usual_range(), (0.005, 5.0));
    /// ```
    pub const fn usual_range(self) -> (f64, f64) {
        match self {
            // A telephoto lens on a small sensor reaches 100 000 px; below 10 px it is a multiple of the image's width.
            Self::FocalLength | Self::Fy => (50.0, 100_000.0),
            // From an endoscope to a telescope.
            Self::Lens => (0.0005, 5.0),
            Self::Baseline => (0.005, 5.0),
            // The disparity is judged together with doffs, as it enters the formula.
            Self::Disparity => (0.5, 1000.0),
            Self::Doffs => (-1000.0, 1000.0),
            Self::ImageWidth => (5.0, 5000.0),
            Self::RealWidth => (0.005, 50.0),
            Self::Tilt => (-FRAC_PI_2, FRAC_PI_2),
            // A camera is no longer than this.
            Self::Zero => (-1.0, 1.0),
        }
    }

    /// Whether `value` (px, meters or radians) lies in the [usual range](Self::usual_range), its ends included.
    ///
    /// ```
    /// use depth_core::field::Field;
    ///
    /// // 100 mm typed as meters is no usual baseline.
    /// assert!(Field::Baseline.is_usual(0.1) && !Field::Baseline.is_usual(100.0));
    /// ```
    pub fn is_usual(self, value: f64) -> bool {
        let (low, high) = self.usual_range();
        (low..=high).contains(&value)
    }
}

/// The first unit in which `typed` would be a usual value of `field`, a length, if it is not one in the unit it was typed in.
///
/// ```
/// use depth_core::field::{Field, better_unit};
/// use depth_core::quantity::LengthUnit;
///
/// // A baseline of 100 m is 100 mm.
/// assert_eq!(better_unit(Field::Baseline, 100.0, LengthUnit::Meter), Some(LengthUnit::Millimeter));
/// ```
pub fn better_unit(field: Field, typed: f64, unit: LengthUnit) -> Option<LengthUnit> {
    const LIKELIEST_FIRST: [LengthUnit; 5] = [
        LengthUnit::Meter,
        LengthUnit::Millimeter,
        LengthUnit::Centimeter,
        LengthUnit::Inch,
        LengthUnit::Foot,
    ];
    let usual = |unit| field.is_usual(Length::new(typed, unit).m());
    if usual(unit) {
        return None;
    }
    LIKELIEST_FIRST.into_iter().find(|&candidate| usual(candidate))
}
