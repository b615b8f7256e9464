//! Two parallel, rectified cameras: depth from disparity.

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
