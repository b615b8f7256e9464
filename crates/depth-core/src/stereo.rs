//! Two parallel, rectified cameras: depth from disparity.

use crate::angle::Angle;
use crate::arithmetic::times_over;
use crate::quantity::{Length, Pixels};

/// Depth of a point along the optical axis, Z = f·b/d, for a rectified pair whose principal points coincide.
///
/// `focal_length` and `disparity` in pixels of the same image, `baseline` a length; the result is a length.
/// The result is infinite for `disparity` 0 and negative for a negative one: the caller checks.
///
/// ```
/// use depth_core::quantity::{Length, Pixels};
/// use depth_core::stereo;
///
/// assert_eq!(stereo::depth(Pixels::new(700.0), Length::from_m(0.1), Pixels::new(50.0)).m(), 1.4);
/// ```
///
/// Source: Middlebury 2014 calibration format ("Z = baseline * f / (d + doffs)", here with doffs = 0); similar
/// triangles as in Hartley and Zisserman, *Multiple View Geometry*, chapter 9.
pub fn depth(focal_length: Pixels, baseline: Length, disparity: Pixels) -> Length {
    Length::from_m(times_over(focal_length.px(), baseline.m(), disparity.px()))
}

/// Disparity at which a point at `depth` appears, d = f·b/Z: the inverse of [`depth`].
///
/// ```
/// use depth_core::quantity::{Length, Pixels};
/// use depth_core::stereo;
///
/// assert_eq!(stereo::disparity(Pixels::new(700.0), Length::from_m(0.1), Length::from_m(2.0)).px(), 35.0);
/// ```
pub fn disparity(focal_length: Pixels, baseline: Length, depth: Length) -> Pixels {
    Pixels::new(times_over(focal_length.px(), baseline.m(), depth.m()))
}

/// The part of a baseline that counts where it is not square to the line of sight: b·sin(angle between the two).
///
/// `None` where nothing of it is left: an angle of 0° or 180° and beyond.
///
/// ```
/// use depth_core::angle::Angle;
/// use depth_core::quantity::Length;
/// use depth_core::stereo::effective_baseline;
///
/// // 100 m at 60°.
/// let b = effective_baseline(Length::from_m(100.0), Angle::from_degrees(60.0)).unwrap();
/// assert!((b.m() - 86.6025).abs() < 1e-4);
/// ```
///
/// Source: the component of the baseline in the image plane; triangulation from two stations by the law of sines, for a target that
/// is far away compared with the baseline.
pub fn effective_baseline(baseline: Length, angle: Angle) -> Option<Length> {
    let is_between = angle.radians() > 0.0 && angle.radians() < std::f64::consts::PI;
    is_between.then(|| Length::from_m(baseline.m() * angle.radians().sin()))
}
