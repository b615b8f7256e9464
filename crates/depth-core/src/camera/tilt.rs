//! A target that does not face the camera.

use crate::angle::Angle;
use crate::quantity::Length;
use std::f64::consts::FRAC_PI_2;

/// The width that something `width` wide shows to the camera when it is turned by `tilt` away from facing it: w·cos φ. What
/// is computed from the full width is too far away by 1/cos φ.
///
/// `None` at 90° and more. To first order in width/depth: the exact apparent width is larger by the factor
/// 1/(1 − (w·sin φ/2Z)²), 0.25 % for a target as deep as a tenth of its distance.
///
/// ```
/// use depth_core::angle::Angle;
/// use depth_core::camera::foreshortened;
/// use depth_core::quantity::Length;
///
/// let width = foreshortened(Length::from_m(2.0), Angle::from_degrees(60.0)).unwrap();
/// assert!((width.m() - 1.0).abs() < 1e-12);
/// ```
///
/// Source: foreshortening under orthographic projection scaled by depth (weak perspective), Hartley and Zisserman, 6.3.
pub fn foreshortened(width: Length, tilt: Angle) -> Option<Length> {
    (tilt.radians().abs() < FRAC_PI_2).then(|| Length::from_m(width.m() * tilt.radians().cos()))
}
