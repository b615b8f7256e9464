//! One camera and an object of known size: depth from the object's width in the image.
//!
//! The object is taken to face the camera (its width parallel to the image plane).

use crate::arithmetic::{root_sum_of_squares, times_over};
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

/// The depth of the center of a ball, from the depth at which a disk of its `diameter` would look as wide: √(Z² + R²), with
/// Z = 2R·f/w that of the disk, which is R·√(1 + (2f/w)²).
///
/// In the middle of the image. There the rays that touch a ball make a cone whose half angle has the sine R/D and the tangent
/// w/2f.
///
/// ```
/// use depth_core::monocular::{depth, depth_of_center};
/// use depth_core::quantity::{Length, Pixels};
///
/// // 0.2 m of ball, f = 1000 px: half a meter away it is 408.2 px wide.
/// let ball = Length::from_m(0.2);
/// let disk = depth(Pixels::new(1000.0), ball, Pixels::new(408.248));
/// assert!((depth_of_center(disk, ball).m() - 0.5).abs() < 1e-6);
/// ```
///
/// Source: the outline of a sphere under perspective projection; R. Hartley, A. Zisserman, *Multiple View Geometry*, 8.3.
pub fn depth_of_center(depth_of_disk: Length, diameter: Length) -> Length {
    Length::from_m(root_sum_of_squares(&[depth_of_disk.m(), diameter.m() / 2.0]))
}

/// The inverse of [`depth_of_center`]; `None` where the center is not farther away than the radius.
///
/// ```
/// use depth_core::monocular::depth_of_disk;
/// use depth_core::quantity::Length;
///
/// // 3-4-5.
/// assert_eq!(depth_of_disk(Length::from_m(5.0), Length::from_m(6.0)), Some(Length::from_m(4.0)));
/// ```
pub fn depth_of_disk(depth_of_center: Length, diameter: Length) -> Option<Length> {
    let (center, radius) = (depth_of_center.m(), diameter.m() / 2.0);
    (center > radius).then(|| Length::from_m(center * ((1.0 - radius / center) * (1.0 + radius / center)).sqrt()))
}

/// The diameter of a ball whose outline is `width_in_image` wide and whose center is at `depth_of_center`:
/// 2·D/√(1 + (2f/w)²).
///
/// ```
/// use depth_core::monocular::diameter;
/// use depth_core::quantity::{Length, Pixels};
///
/// let ball = diameter(Pixels::new(1000.0), Pixels::new(408.248), Length::from_m(0.5));
/// assert!((ball.m() - 0.2).abs() < 1e-6);
/// ```
///
/// Source: as [`depth_of_center`], solved for R.
pub fn diameter(focal_length: Pixels, width_in_image: Pixels, depth_of_center: Length) -> Length {
    let at_one_meter = times_over(width_in_image.px(), 1.0, focal_length.px());
    Length::from_m(depth_of_center.m() * at_one_meter / root_sum_of_squares(&[1.0, at_one_meter / 2.0]))
}
