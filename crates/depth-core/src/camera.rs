//! Where a camera's numbers come from, and where a pixel lies in space.
//!
//! A pinhole camera: x to the right, y down, z along the optical axis; pixel coordinates with the origin in the centre of
//! the first pixel, as OpenCV has them.

use crate::angle::Angle;
use crate::field::Field;
use crate::judge::{self, Term, Unsolvable};
use crate::measured::{Measured, root_sum_of_squares};
use crate::quantity::{Length, Pixels, times_over};
use std::f64::consts::{FRAC_PI_2, PI};

/// Focal length in pixels from that of the lens and the size of one pixel, f = f_lens/pitch.
///
/// `None` unless both are positive and the result can be represented. So for every function here that returns an
/// [`Option`].
///
/// Source: the definition of the pinhole model's focal length; R. Hartley, A. Zisserman, *Multiple View Geometry*, 6.1.
pub fn focal_length_from_pixel_pitch(lens: Length, pitch: Length) -> Option<Pixels> {
    (pitch.m() > 0.0).then(|| lens.m() / pitch.m()).and_then(positive)
}

/// Focal length in pixels from that of the lens and the width of the sensor that `image_width` pixels cover,
/// f = f_lens·W/sensor_width.
///
/// Source: as [`focal_length_from_pixel_pitch`], with pitch = sensor_width/W. Holds only where the image uses the whole
/// width of the sensor.
pub fn focal_length_from_sensor_width(lens: Length, sensor_width: Length, image_width: Pixels) -> Option<Pixels> {
    product_over(lens.m(), image_width.px(), sensor_width.m()).and_then(positive)
}

/// Focal length in pixels from a field of view and the extent of the image along the same direction,
/// f = (extent/2)/tan(view/2): horizontal with the width, vertical with the height, [`diagonal`] with the diagonal.
///
/// `None` unless the view lies between 0° and 180°. For a principal point in the middle of the image; a data sheet's
/// field of view is often that of the unrectified image.
///
/// Source: pinhole projection of the image's edge; Stereolabs' and Luxonis' documentation give the same formula.
pub fn focal_length_from_field_of_view(view: Angle, extent: Pixels) -> Option<Pixels> {
    let is_a_view = view.radians() > 0.0 && view.radians() < PI;
    is_a_view
        .then(|| extent.px() / 2.0 / (view.radians() / 2.0).tan())
        .and_then(positive)
}

/// The diagonal of an image, √(W² + H²).
pub fn diagonal(width: Pixels, height: Pixels) -> Pixels {
    Pixels::new(root_sum_of_squares(&[width.px(), height.px()]).min(f64::MAX))
}

/// Field of view along one direction, atan(c/f) + atan((extent − c)/f), with the principal point at `centre`.
///
/// Source: OpenCV, `calibrationMatrixValues` (fovx with cx and the width, fovy with cy and the height).
pub fn field_of_view(focal_length: Pixels, centre: Pixels, extent: Pixels) -> Angle {
    let f = focal_length.px();
    Angle::from_radians(centre.px().atan2(f) + (extent.px() - centre.px()).atan2(f))
}

/// Focal length from one photograph of an object of known width at a known distance, f = w_img·Z/w_real.
///
/// With uncertainties: [`MonocularEquation`](super::unknown::MonocularEquation).
///
/// Source: pinhole projection by similar triangles, used this way by A. Rosebrock, Find distance from camera to object
/// using Python and OpenCV, 2015.
pub fn focal_length_from_reference_photo(width_in_image: Pixels, distance: Length, real_width: Length) -> Option<Pixels> {
    product_over(width_in_image.px(), distance.m(), real_width.m()).and_then(positive)
}

/// True depth of a target whose width is turned by `tilt` away from facing the camera, given the depth that the
/// monocular formula computes: Z = Z_apparent·cos φ, because the width appears cos φ as large.
///
/// `None` at 90° and more. To first order in width/depth: the exact apparent width is larger by the factor
/// 1/(1 − (w·sin φ/2Z)²), 0.25 % for a target as deep as a tenth of its distance.
///
/// Source: foreshortening under orthographic projection scaled by depth (weak perspective), Hartley and Zisserman, 6.3.
pub fn depth_of_tilted_target(apparent: Length, tilt: Angle) -> Option<Length> {
    (tilt.radians().abs() < FRAC_PI_2).then(|| Length::from_m(apparent.m() * tilt.radians().cos()))
}

/// What one pixel covers at `depth`, Z/f, on a plane that faces the camera.
///
/// Source: similar triangles; ROS image_geometry, `PinholeCameraModel::getDeltaX`.
pub fn pixel_size(focal_length: Pixels, depth: Length) -> Option<Length> {
    let size = depth.m() / focal_length.px();
    (focal_length.px() > 0.0 && size.is_finite()).then_some(Length::from_m(size))
}

/// A camera's intrinsic parameters, all in pixels of one image.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Intrinsics {
    /// Focal length along the rows.
    pub fx: Pixels,
    /// Focal length along the columns; equals `fx` for square pixels.
    pub fy: Pixels,
    /// Column of the principal point.
    pub cx: Pixels,
    /// Row of the principal point.
    pub cy: Pixels,
    /// Width of the image.
    pub width: Pixels,
    /// Height of the image.
    pub height: Pixels,
}

/// What a camera matrix says of a sensor of known size, as OpenCV's `calibrationMatrixValues` returns it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnSensor {
    /// Focal length of the lens, from fx and the sensor's width.
    pub lens: Length,
    /// Principal point from the sensor's left edge.
    pub principal_x: Length,
    /// Principal point from the sensor's upper edge.
    pub principal_y: Length,
    /// fy/fx.
    pub aspect_ratio: f64,
}

impl Intrinsics {
    /// Horizontal [field of view](field_of_view).
    pub fn horizontal_view(&self) -> Angle {
        field_of_view(self.fx, self.cx, self.width)
    }

    /// Vertical [field of view](field_of_view).
    pub fn vertical_view(&self) -> Angle {
        field_of_view(self.fy, self.cy, self.height)
    }

    /// Diagonal field of view, 2·atan(√(W² + H²)/2f), with fx and a principal point in the middle: the inverse of
    /// [`focal_length_from_field_of_view`] with the [diagonal].
    ///
    /// Source: pinhole projection of the image's corner.
    pub fn diagonal_view(&self) -> Angle {
        let extent = diagonal(self.width, self.height);
        field_of_view(self.fx, Pixels::new(extent.px() / 2.0), extent)
    }

    /// The lens and the principal point in millimetres' terms, for a sensor of `width` by `height`.
    ///
    /// Source: OpenCV, `calibrationMatrixValues`.
    pub fn on_sensor(&self, width: Length, height: Length) -> Option<OnSensor> {
        let aspect_ratio = self.fy.px() / self.fx.px();
        Some(OnSensor {
            lens: Length::from_m(product_over(self.fx.px(), width.m(), self.width.px())?),
            principal_x: Length::from_m(product_over(self.cx.px(), width.m(), self.width.px())?),
            principal_y: Length::from_m(product_over(self.cy.px(), height.m(), self.height.px())?),
            aspect_ratio: Some(aspect_ratio).filter(|ratio| ratio.is_finite())?,
        })
    }

    /// The same camera after its image was resized to `width` by `height`: focal length and principal point scale with it,
    /// cx' = (cx + ½)·s − ½. (So do disparities, doffs and widths in the image: those by the same s, without the halves. The
    /// baseline does not.)
    ///
    /// Source: the pixel-centre convention of OpenCV's `resize`; COLMAP issue 845 on what scales.
    pub fn resized(&self, width: Pixels, height: Pixels) -> Option<Self> {
        let sx = positive(width.px() / self.width.px())?.px();
        let sy = positive(height.px() / self.height.px())?.px();
        Self {
            fx: Pixels::new(self.fx.px() * sx),
            fy: Pixels::new(self.fy.px() * sy),
            cx: Pixels::new((self.cx.px() + 0.5) * sx - 0.5),
            cy: Pixels::new((self.cy.px() + 0.5) * sy - 0.5),
            width,
            height,
        }
        .finite()
    }

    /// The same camera after its image was cut down to `width` by `height` from column `left` and row `top`: only the
    /// principal point moves. (A crop of the left image alone changes doffs and disparities; of both alike, neither.)
    ///
    /// Source: a translation of pixel coordinates; Hartley and Zisserman, 6.1.
    pub fn cropped(&self, left: Pixels, top: Pixels, width: Pixels, height: Pixels) -> Option<Self> {
        Self {
            cx: Pixels::new(self.cx.px() - left.px()),
            cy: Pixels::new(self.cy.px() - top.px()),
            width: positive(width.px())?,
            height: positive(height.px())?,
            ..*self
        }
        .finite()
    }

    /// How far right of (X) and below (Y) the optical axis a point at `depth` lies that is seen at column `u` and row `v`:
    /// X = (u − cx)·Z/fx, Y = (v − cy)·Z/fy.
    ///
    /// Source: inverse of the pinhole projection; Point Grey knowledge base article 10102.
    pub fn point(&self, u: Pixels, v: Pixels, depth: Length) -> Option<(Length, Length)> {
        let x = product_over(u.px() - self.cx.px(), depth.m(), self.fx.px())?;
        let y = product_over(v.px() - self.cy.px(), depth.m(), self.fy.px())?;
        Some((Length::from_m(x), Length::from_m(y)))
    }

    /// How far the camera is from a point at `depth` that is seen at column `u` and row `v`: the length of the ray,
    /// R = Z·√(1 + ((u − cx)/fx)² + ((v − cy)/fy)²), which a tape measure or a laser would show.
    ///
    /// Source: Euclidean norm of (X, Y, Z) of [`point`](Self::point).
    pub fn range(&self, u: Pixels, v: Pixels, depth: Length) -> Option<Length> {
        let (x, y) = self.point(u, v, depth)?;
        let range = root_sum_of_squares(&[x.m(), y.m(), depth.m()]);
        range.is_finite().then_some(Length::from_m(range))
    }

    fn finite(self) -> Option<Self> {
        let all = [self.fx, self.fy, self.cx, self.cy, self.width, self.height];
        all.iter().all(|pixels| pixels.px().is_finite()).then_some(self)
    }
}

/// A camera above a flat, level floor, looking at a point of it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundView {
    /// Height of the camera above the floor.
    pub height: Measured<Length>,
    /// How far the optical axis points down from the horizontal.
    pub pitch: Measured<Angle>,
    /// Row at which the point is seen.
    pub row: Measured<Pixels>,
    /// Focal length along the columns.
    pub fy: Pixels,
    /// Row of the principal point.
    pub cy: Pixels,
}

impl GroundView {
    /// Horizontal distance to the point with its σ to first order: D = h/tan(θ + atan((v − cy)/fy)), with
    /// dD/dh = D/h, dD/dθ = −(D² + h²)/h and dD/dv = dD/dθ·fy/(fy² + (v − cy)²).
    ///
    /// # Errors
    /// [`Unsolvable`].
    ///
    /// Source: intersection of the pixel's ray with a plane (Hartley and Zisserman, 8.1); JCGM 100:2008 (GUM), 5.1.2, for σ.
    pub fn distance(&self) -> Result<Measured<Length>, Unsolvable> {
        let below_axis = self.below_axis()?;
        let height = self.height.value.m();
        let down = self.pitch.value.radians() + below_axis.atan();
        if down <= 0.0 {
            return Err(Unsolvable::AboveHorizon {
                horizon: self.horizon_row(),
            });
        }
        if down >= FRAC_PI_2 {
            return Err(Unsolvable::BelowCamera {
                down: Angle::from_radians(down),
            });
        }
        let distance = height / down.tan();
        // (D² + h²)/h = h/sin², without squaring a length.
        let per_radian = height / down.sin() / down.sin();
        let sigma = root_sum_of_squares(&[
            self.height.sigma.m() / down.tan(),
            per_radian * self.pitch.sigma.radians(),
            per_radian * (self.row.sigma.px() / self.fy.px() / (1.0 + below_axis * below_axis)),
        ]);
        if distance.is_finite() && sigma.is_finite() {
            Ok(Measured::from_base(distance, sigma))
        } else {
            Err(Unsolvable::too_extreme(Term::Distance))
        }
    }

    /// The row at which the floor ends, v = cy − fy·tan θ; `None` where the camera looks straight down or the numbers are
    /// unusable.
    ///
    /// Source: the row of [`distance`](Self::distance) whose ray is horizontal.
    pub fn horizon_row(&self) -> Option<Pixels> {
        self.below_axis().ok()?;
        let row = self.cy.px() - self.fy.px() * self.pitch.value.radians().tan();
        (self.pitch.value.radians().abs() < FRAC_PI_2 && row.is_finite()).then_some(Pixels::new(row))
    }

    /// (v − cy)/fy, where every number can be used.
    fn below_axis(&self) -> Result<f64, Unsolvable> {
        judge::positive_measured(Term::CameraHeight, self.height)?;
        judge::finite_measured(Term::Pitch, self.pitch)?;
        let row = judge::finite_measured(Term::Row, self.row)?.value.px();
        let fy = judge::value(Term::Input(Field::FocalLength), judge::positive(self.fy.px()))?;
        let cy = judge::value(Term::PrincipalPoint, judge::finite(self.cy.px()))?;
        judge::value(Term::Row, judge::finite((row - cy) / fy))
    }
}

/// A sensor format and its true dimensions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensorFormat {
    /// What it is called: an inch figure is the diameter of a video tube with about such a picture, half as much again as
    /// the sensor's diagonal.
    pub name: &'static str,
    /// Width in millimetres.
    pub width_mm: f64,
    /// Height in millimetres.
    pub height_mm: f64,
    /// Where the dimensions come from.
    pub basis: SensorBasis,
}

/// Where a [`SensorFormat`]'s dimensions come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SensorBasis {
    /// Typical of the format; sensors of that name differ by some per cent.
    Typical,
    /// Pixels times pixel pitch of one common chip of the format.
    OneChip,
    /// Fixed by a standard.
    Standard,
}

/// Common sensor formats, smallest first.
///
/// Source: the table of typical dimensions in Digital Photography Review, Making (some) sense out of sensor sizes, 2002,
/// and in the encyclopedias that follow it, for [`SensorBasis::Typical`]; 1/2.9″ is 1440 × 1080 pixels of 3.45 µm (Sony
/// IMX273), 1/2.8″ is 1920 × 1080 pixels of 2.9 µm (Sony IMX290); the Four Thirds and 35 mm film standards.
pub const SENSOR_FORMATS: [SensorFormat; 16] = {
    use SensorBasis::{OneChip, Standard, Typical};
    [
        sensor("1/4″", 3.20, 2.40, Typical),
        sensor("1/3.2″", 4.54, 3.42, Typical),
        sensor("1/3″", 4.80, 3.60, Typical),
        sensor("1/2.9″", 4.968, 3.726, OneChip),
        sensor("1/2.8″", 5.568, 3.132, OneChip),
        sensor("1/2.5″", 5.76, 4.29, Typical),
        sensor("1/2.3″", 6.17, 4.55, Typical),
        sensor("1/2″", 6.40, 4.80, Typical),
        sensor("1/1.8″", 7.18, 5.32, Typical),
        sensor("1/1.7″", 7.60, 5.70, Typical),
        sensor("2/3″", 8.80, 6.60, Typical),
        sensor("1″", 13.20, 8.80, Typical),
        sensor("4/3", 17.30, 13.00, Standard),
        sensor("APS-C (Canon)", 22.30, 14.90, Typical),
        sensor("APS-C", 23.60, 15.60, Typical),
        sensor("Full frame", 36.00, 24.00, Standard),
    ]
};

const fn sensor(name: &'static str, width_mm: f64, height_mm: f64, basis: SensorBasis) -> SensorFormat {
    SensorFormat {
        name,
        width_mm,
        height_mm,
        basis,
    }
}

fn positive(value: f64) -> Option<Pixels> {
    judge::positive(value).ok().map(Pixels::new)
}

/// a·b/c for any sign of a and b and a positive c; `None` where it cannot be represented.
fn product_over(a: f64, b: f64, c: f64) -> Option<f64> {
    if !(a.is_finite() && b.is_finite() && c.is_finite() && c > 0.0) {
        return None;
    }
    if a == 0.0 || b == 0.0 {
        return Some(0.0);
    }
    let magnitude = times_over(a.abs(), b.abs(), c);
    magnitude.is_finite().then(|| magnitude * a.signum() * b.signum())
}
