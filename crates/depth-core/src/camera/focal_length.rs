//! The focal length in pixels from a data sheet, a photograph, or another resolution.

use crate::angle::Angle;
use crate::arithmetic::{root_sum_of_squares, signed_times_over};
use crate::judge;
use crate::quantity::{Length, Pixels};
use std::f64::consts::PI;

/// Focal length in pixels from that of the lens and the size of one pixel, f = f_lens/pitch.
///
/// `None` unless both are positive and the result can be represented. So for every function here that returns an
/// [`Option`].
///
/// ```
/// use depth_core::camera::focal_length_from_pixel_pitch;
/// use depth_core::quantity::Length;
///
/// // 4 mm over 4 µm.
/// let f = focal_length_from_pixel_pitch(Length::from_m(4e-3), Length::from_m(4e-6)).unwrap();
/// assert!((f.px() - 1000.0).abs() < 1e-9);
/// ```
///
/// Source: the definition of the pinhole model's focal length; R. Hartley, A. Zisserman, *Multiple View Geometry*, 6.1.
pub fn focal_length_from_pixel_pitch(lens: Length, pitch: Length) -> Option<Pixels> {
    (pitch.m() > 0.0).then(|| lens.m() / pitch.m()).and_then(positive)
}

/// Focal length in pixels from that of the lens and the width of the sensor that `image_width` pixels cover,
/// f = f_lens·W/sensor_width.
///
/// ```
/// use depth_core::camera::focal_length_from_sensor_width;
/// use depth_core::quantity::{Length, LengthUnit, Pixels};
///
/// let mm = |value| Length::new(value, LengthUnit::Millimeter);
/// // 4 mm · 1280 px / 6.4 mm.
/// let f = focal_length_from_sensor_width(mm(4.0), mm(6.4), Pixels::new(1280.0)).unwrap();
/// assert!((f.px() - 800.0).abs() < 1e-9);
/// ```
///
/// Source: as [`focal_length_from_pixel_pitch`], with pitch = sensor_width/W. Holds only where the image uses the whole
/// width of the sensor.
pub fn focal_length_from_sensor_width(lens: Length, sensor_width: Length, image_width: Pixels) -> Option<Pixels> {
    signed_times_over(lens.m(), image_width.px(), sensor_width.m()).and_then(positive)
}

/// Focal length in pixels from the same as a multiple of an extent of the image: of its width (files of structure from motion), or
/// of half of it (an OpenGL projection matrix's P00).
///
/// ```
/// use depth_core::camera::focal_length_from_multiple;
/// use depth_core::quantity::Pixels;
///
/// // A multiple of ½ of the width: a view of 90°.
/// assert_eq!(focal_length_from_multiple(0.5, Pixels::new(1280.0)), Some(Pixels::new(640.0)));
/// ```
///
/// Source: OpenGL, `glFrustum`: P00 = 2·near/(right − left), with the image from −1 to 1.
pub fn focal_length_from_multiple(multiple: f64, extent: Pixels) -> Option<Pixels> {
    if judge::positive(multiple).is_err() || judge::positive(extent.px()).is_err() {
        return None;
    }
    positive(multiple * extent.px())
}

/// Focal length in pixels from a field of view and the extent of the image along the same direction,
/// f = (extent/2)/tan(view/2): horizontal with the width, vertical with the height, [`diagonal`] with the diagonal.
///
/// `None` unless the view lies between 0° and 180°. For a principal point in the middle of the image; a data sheet's
/// field of view is often that of the unrectified image.
///
/// ```
/// use depth_core::angle::Angle;
/// use depth_core::camera::focal_length_from_field_of_view;
/// use depth_core::quantity::Pixels;
///
/// // At 90° the image is twice as wide as the focal length is long.
/// let f = focal_length_from_field_of_view(Angle::from_degrees(90.0), Pixels::new(1280.0)).unwrap();
/// assert!((f.px() - 640.0).abs() < 1e-9);
/// ```
///
/// Source: pinhole projection of the image's edge; Stereolabs' and Luxonis' documentation give the same formula.
pub fn focal_length_from_field_of_view(view: Angle, extent: Pixels) -> Option<Pixels> {
    let is_a_view = view.radians() > 0.0 && view.radians() < PI;
    is_a_view
        .then(|| extent.px() / 2.0 / (view.radians() / 2.0).tan())
        .and_then(positive)
}

/// The diagonal of an image, √(W² + H²).
///
/// ```
/// use depth_core::camera::diagonal;
/// use depth_core::quantity::Pixels;
///
/// assert_eq!(diagonal(Pixels::new(640.0), Pixels::new(480.0)), Pixels::new(800.0));
/// ```
pub fn diagonal(width: Pixels, height: Pixels) -> Pixels {
    Pixels::new(root_sum_of_squares(&[width.px(), height.px()]).min(f64::MAX))
}

/// Focal length from one photograph of an object of known width at a known distance, f = w_img·Z/w_real.
///
/// With uncertainties: [`MonocularEquation`](crate::unknown::MonocularEquation).
///
/// ```
/// use depth_core::camera::focal_length_from_reference_photo;
/// use depth_core::quantity::{Length, Pixels};
///
/// // 150 px · 2 m / 0.5 m.
/// let f = focal_length_from_reference_photo(Pixels::new(150.0), Length::from_m(2.0), Length::from_m(0.5));
/// assert_eq!(f, Some(Pixels::new(600.0)));
/// ```
///
/// Source: pinhole projection by similar triangles, used this way by A. Rosebrock, Find distance from camera to object
/// using Python and OpenCV, 2015.
pub fn focal_length_from_reference_photo(width_in_image: Pixels, distance: Length, real_width: Length) -> Option<Pixels> {
    signed_times_over(width_in_image.px(), distance.m(), real_width.m()).and_then(positive)
}

/// Focal length after an image of `width_before` was resized to `width_after`, f' = f·(W'/W). Cropping does not change it.
///
/// ```
/// use depth_core::camera::resized_focal_length;
/// use depth_core::quantity::Pixels;
///
/// let f = resized_focal_length(Pixels::new(700.0), Pixels::new(1280.0), Pixels::new(640.0));
/// assert_eq!(f, Some(Pixels::new(350.0)));
/// ```
///
/// Source: as [`Intrinsics::resized`](super::Intrinsics::resized), whose fx it is.
pub fn resized_focal_length(focal_length: Pixels, width_before: Pixels, width_after: Pixels) -> Option<Pixels> {
    let scale = positive(width_after.px() / width_before.px())?;
    positive(focal_length.px() * scale.px())
}

pub(super) fn positive(value: f64) -> Option<Pixels> {
    judge::positive(value).ok().map(Pixels::new)
}
