//! Focal lengths of photographers: of 35 mm film, and of a lens that is focused near.

use super::focal_length::{diagonal, positive};
use crate::judge;
use crate::quantity::{Length, Pixels};

/// Width of a picture on 35 mm film, in millimeters.
const FILM_WIDTH: f64 = 36.0;
/// Its height.
const FILM_HEIGHT: f64 = 24.0;

/// Which extent of the picture on 35 mm film is meant by an equivalent focal length.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FilmExtent {
    /// The diagonal, as CIPA has it: f = f₃₅·√(W² + H²)/√(36² + 24²).
    Diagonal,
    /// The width, which is that of the longer side: f = f₃₅·W/36. At 4:3 the two differ by 4 %.
    Width,
}

impl FilmExtent {
    /// Pixels of an image of this size for a millimeter of film.
    fn pixels_per_millimeter(self, width: Pixels, height: Pixels) -> f64 {
        match self {
            Self::Diagonal => diagonal(width, height).px() / FILM_WIDTH.hypot(FILM_HEIGHT),
            // Who holds a camera upright holds its film upright.
            Self::Width => width.px().max(height.px()) / FILM_WIDTH,
        }
    }

    /// The focal length in pixels of a lens that is equivalent to one of `equivalent` on 35 mm film.
    ///
    /// ```
    /// use depth_core::camera::FilmExtent;
    /// use depth_core::quantity::{Length, Pixels};
    ///
    /// let f = FilmExtent::Width.focal_length(Length::from_m(0.026), [Pixels::new(4032.0), Pixels::new(3024.0)]).unwrap();
    /// assert!((f.px() - 2912.0).abs() < 1e-9);
    /// ```
    ///
    /// Source: CIPA DCG-001, guideline for noting digital camera specifications, 35 mm film equivalent focal length.
    pub fn focal_length(self, equivalent: Length, [width, height]: [Pixels; 2]) -> Option<Pixels> {
        let millimeters = judge::positive(equivalent.m()).ok()? * 1000.0;
        positive(millimeters * self.pixels_per_millimeter(width, height))
    }

    /// The lens for 35 mm film that is equivalent to one of `focal_length`.
    ///
    /// ```
    /// use depth_core::camera::FilmExtent;
    /// use depth_core::quantity::Pixels;
    ///
    /// let film = FilmExtent::Width.equivalent(Pixels::new(2912.0), [Pixels::new(4032.0), Pixels::new(3024.0)]).unwrap();
    /// assert!((film.m() - 0.026).abs() < 1e-15);
    /// ```
    ///
    /// Source: as [`FilmExtent::focal_length`].
    pub fn equivalent(self, focal_length: Pixels, [width, height]: [Pixels; 2]) -> Option<Length> {
        let millimeters = focal_length.px() / self.pixels_per_millimeter(width, height);
        judge::positive(millimeters / 1000.0).ok().map(Length::from_m)
    }
}

/// How far behind a lens of focal length f the image of something at distance s is sharp, v = f·s/(s − f): what counts as the focal
/// length of the pinhole then. `None` unless s is more than f.
///
/// ```
/// use depth_core::camera::focused_image_distance;
/// use depth_core::quantity::Length;
///
/// // 50 mm, focused at 0.55 m: 55 mm.
/// let v = focused_image_distance(Length::from_m(0.05), Length::from_m(0.55)).unwrap();
/// assert!((v.m() - 0.055).abs() < 1e-15);
/// ```
///
/// Source: the thin lens, 1/f = 1/s + 1/v; E. Hecht, *Optics*, 5.2.
pub fn focused_image_distance(lens: Length, distance: Length) -> Option<Length> {
    let (f, s) = (judge::positive(lens.m()).ok()?, judge::positive(distance.m()).ok()?);
    (s > f)
        .then(|| f * s / (s - f))
        .and_then(|v| judge::positive(v).ok())
        .map(Length::from_m)
}

/// The focal length of the lens whose image of something at distance s is sharp at v behind it, f = v·s/(v + s): the inverse of
/// [`focused_image_distance`].
///
/// ```
/// use depth_core::camera::focused_lens;
/// use depth_core::quantity::Length;
///
/// let f = focused_lens(Length::from_m(0.055), Length::from_m(0.55)).unwrap();
/// assert!((f.m() - 0.05).abs() < 1e-15);
/// ```
///
/// Source: as [`focused_image_distance`].
pub fn focused_lens(image_distance: Length, distance: Length) -> Option<Length> {
    let (v, s) = (judge::positive(image_distance.m()).ok()?, judge::positive(distance.m()).ok()?);
    judge::positive(v * s / (v + s)).ok().map(Length::from_m)
}

/// The focal length under water of a camera behind a flat window, about 1.333 times that in air, for rays near the axis: farther out it
/// is no pinhole any more.
///
/// ```
/// use depth_core::camera::focal_length_under_water;
/// use depth_core::quantity::Pixels;
///
/// assert_eq!(focal_length_under_water(Pixels::new(600.0)), Some(Pixels::new(799.8)));
/// ```
///
/// Source: T. Treibitz et al., Flat refractive geometry, 2012.
pub fn focal_length_under_water(in_air: Pixels) -> Option<Pixels> {
    const WATER: f64 = 1.333;
    positive(in_air.px() * WATER)
}
