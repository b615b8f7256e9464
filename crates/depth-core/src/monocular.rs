//! One camera and an object of known size: depth from the object's width in the image.
//!
//! The object is taken to face the camera (its width parallel to the image plane).

use crate::arithmetic::times_over;
use crate::quantity::{Length, Pixels};

/// Depth of an object of known width, Z = w_real·f/w_img.
///
/// `real_width` a length, `focal_length` and `width_in_image` in pixels of the same image; the result is a length.
/// The result is infinite for `width_in_image` 0: the caller checks.
///
/// ```
/// use depth_core::monocular;
/// use depth_core::quantity::{Length, Pixels};
///
/// assert_eq!(monocular::depth(Pixels::new(950.0), Length::from_m(0.9), Pixels::new(200.0)).m(), 4.275);
/// ```
///
/// Source: pinhole projection by similar triangles; the two-formula web page that this program reproduces.
pub fn depth(focal_length: Pixels, real_width: Length, width_in_image: Pixels) -> Length {
    Length::from_m(times_over(real_width.m(), focal_length.px(), width_in_image.px()))
}

/// Width in the image of an object of `real_width` at `depth`, w_img = w_real·f/Z.
///
/// ```
/// use depth_core::monocular;
/// use depth_core::quantity::{Length, Pixels};
///
/// assert_eq!(monocular::width_in_image(Pixels::new(700.0), Length::from_m(0.5), Length::from_m(2.0)).px(), 175.0);
/// ```
pub fn width_in_image(focal_length: Pixels, real_width: Length, depth: Length) -> Pixels {
    Pixels::new(times_over(real_width.m(), focal_length.px(), depth.m()))
}

/// Real width of an object seen `width_in_image` wide at `depth`, w_real = w_img·Z/f.
///
/// ```
/// use depth_core::monocular;
/// use depth_core::quantity::{Length, Pixels};
///
/// assert_eq!(monocular::real_width(Pixels::new(700.0), Pixels::new(175.0), Length::from_m(2.0)).m(), 0.5);
/// ```
pub fn real_width(focal_length: Pixels, width_in_image: Pixels, depth: Length) -> Length {
    Length::from_m(times_over(width_in_image.px(), depth.m(), focal_length.px()))
}
