//! A camera matrix with its image: fields of view, resizing and cropping, points in space.

use super::focal_length::{diagonal, positive};
use crate::angle::Angle;
use crate::arithmetic::{root_sum_of_squares, signed_times_over};
use crate::measured::Measured;
use crate::quantity::{Length, Pixels};

/// Field of view along one direction, atan(c/f) + atan((extent − c)/f), with the principal point at `center`.
///
/// ```
/// use depth_core::camera::field_of_view;
/// use depth_core::quantity::Pixels;
///
/// // 45° on either side.
/// let view = field_of_view(Pixels::new(640.0), Pixels::new(640.0), Pixels::new(1280.0));
/// assert!((view.degrees() - 90.0).abs() < 1e-12);
/// ```
///
/// Source: OpenCV, `calibrationMatrixValues` (fovx with cx and the width, fovy with cy and the height).
pub fn field_of_view(focal_length: Pixels, center: Pixels, extent: Pixels) -> Angle {
    let f = focal_length.px();
    Angle::from_radians(center.px().atan2(f) + (extent.px() - center.px()).atan2(f))
}

/// What one pixel covers at `depth`, Z/f, on a plane that faces the camera.
///
/// ```
/// use depth_core::camera::pixel_size;
/// use depth_core::quantity::{Length, Pixels};
///
/// assert_eq!(pixel_size(Pixels::new(500.0), Length::from_m(2.0)), Some(Length::from_m(0.004)));
/// ```
///
/// Source: similar triangles; ROS image_geometry, `PinholeCameraModel::getDeltaX`.
pub fn pixel_size(focal_length: Pixels, depth: Length) -> Option<Length> {
    let size = depth.m() / focal_length.px();
    (focal_length.px() > 0.0 && size.is_finite()).then_some(Length::from_m(size))
}

/// The angle that `extent`, square to the line of sight and in the middle of it, takes at `distance`: α = 2·atan(extent/(2·distance)),
/// with its first-order σ. Of a baseline it is the angle between both lines of sight.
///
/// ```
/// use depth_core::camera::subtended_angle;
/// use depth_core::measured::Measured;
/// use depth_core::quantity::Length;
///
/// let meters = |value, sigma| Measured::new(Length::from_m(value), Length::from_m(sigma));
/// let angle = subtended_angle(meters(0.1, 0.0005), meters(1.4, 0.01)).unwrap();
/// assert!((angle.value.degrees() - 4.0908).abs() < 1e-4);
/// assert!((angle.sigma.degrees() - 0.0356).abs() < 1e-4);
/// ```
///
/// Source: the isosceles triangle of both ends and the camera; its partial derivatives are D/(D² + e²/4) and −e/(D² + e²/4).
pub fn subtended_angle(extent: Measured<Length>, distance: Measured<Length>) -> Option<Measured<Angle>> {
    let [e, d] = [extent.value.m(), distance.value.m()];
    let angle = 2.0 * (e / 2.0).atan2(d);
    let squares = d * d + e * e / 4.0;
    let sigma = (d * extent.sigma.m()).hypot(e * distance.sigma.m()) / squares;
    let is_usable = d > 0.0 && angle.is_finite() && sigma.is_finite();
    is_usable.then(|| Measured::new(Angle::from_radians(angle), Angle::from_radians(sigma)))
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
    ///
    /// ```
    /// # use depth_core::camera::Intrinsics;
    /// # use depth_core::quantity::{Length, Pixels};
    /// # let px = Pixels::new;
    /// let camera = Intrinsics { fx: px(640.0), fy: px(640.0), cx: px(640.0), cy: px(360.0), width: px(1280.0), height: px(720.0) };
    /// assert!((camera.horizontal_view().degrees() - 90.0).abs() < 1e-12);
    /// ```
    pub fn horizontal_view(&self) -> Angle {
        field_of_view(self.fx, self.cx, self.width)
    }

    /// Vertical [field of view](field_of_view).
    ///
    /// ```
    /// # use depth_core::camera::Intrinsics;
    /// # use depth_core::quantity::{Length, Pixels};
    /// # let px = Pixels::new;
    /// let camera = Intrinsics { fx: px(640.0), fy: px(640.0), cx: px(640.0), cy: px(360.0), width: px(1280.0), height: px(720.0) };
    /// // Twice atan(360/640).
    /// assert!((camera.vertical_view().degrees() - 58.7155).abs() < 1e-4);
    /// ```
    pub fn vertical_view(&self) -> Angle {
        field_of_view(self.fy, self.cy, self.height)
    }

    /// Diagonal field of view, 2·atan(√(W² + H²)/2f), with fx and a principal point in the middle: the inverse of
    /// [`focal_length_from_field_of_view`](super::focal_length_from_field_of_view) with the [diagonal].
    ///
    /// ```
    /// # use depth_core::camera::Intrinsics;
    /// # use depth_core::quantity::{Length, Pixels};
    /// # let px = Pixels::new;
    /// let camera = Intrinsics { fx: px(640.0), fy: px(640.0), cx: px(640.0), cy: px(360.0), width: px(1280.0), height: px(720.0) };
    /// // Twice atan(√(640² + 360²)/640).
    /// assert!((camera.diagonal_view().degrees() - 97.8508).abs() < 1e-3);
    /// ```
    ///
    /// Source: pinhole projection of the image's corner.
    pub fn diagonal_view(&self) -> Angle {
        let extent = diagonal(self.width, self.height);
        field_of_view(self.fx, Pixels::new(extent.px() / 2.0), extent)
    }

    /// The lens and the principal point in millimeters' terms, for a sensor of `width` by `height`.
    ///
    /// ```
    /// # use depth_core::camera::Intrinsics;
    /// # use depth_core::quantity::{Length, Pixels};
    /// # let px = Pixels::new;
    /// let camera = Intrinsics { fx: px(640.0), fy: px(640.0), cx: px(640.0), cy: px(360.0), width: px(1280.0), height: px(720.0) };
    /// // 1280 pixels of 4 µm are 5.12 mm; 640 of them 2.56 mm.
    /// let sensor = camera.on_sensor(Length::from_m(5.12e-3), Length::from_m(2.88e-3)).unwrap();
    /// assert!((sensor.lens.m() - 2.56e-3).abs() < 1e-12);
    /// assert_eq!(sensor.aspect_ratio, 1.0);
    /// ```
    ///
    /// Source: OpenCV, `calibrationMatrixValues`.
    pub fn on_sensor(&self, width: Length, height: Length) -> Option<OnSensor> {
        let aspect_ratio = self.fy.px() / self.fx.px();
        Some(OnSensor {
            lens: Length::from_m(signed_times_over(self.fx.px(), width.m(), self.width.px())?),
            principal_x: Length::from_m(signed_times_over(self.cx.px(), width.m(), self.width.px())?),
            principal_y: Length::from_m(signed_times_over(self.cy.px(), height.m(), self.height.px())?),
            aspect_ratio: Some(aspect_ratio).filter(|ratio| ratio.is_finite())?,
        })
    }

    /// The same camera after its image was resized to `width` by `height`: focal length and principal point scale with it,
    /// cx' = (cx + ½)·s − ½. (So do disparities, doffs and widths in the image: those by the same s, without the halves. The
    /// baseline does not.)
    ///
    /// ```
    /// # use depth_core::camera::Intrinsics;
    /// # use depth_core::quantity::{Length, Pixels};
    /// # let px = Pixels::new;
    /// let camera = Intrinsics { fx: px(640.0), fy: px(640.0), cx: px(640.0), cy: px(360.0), width: px(1280.0), height: px(720.0) };
    /// let half = camera.resized(px(640.0), px(360.0)).unwrap();
    /// assert_eq!((half.fx, half.cx), (px(320.0), px(319.75)));
    /// ```
    ///
    /// Source: the pixel-center convention of OpenCV's `resize`; COLMAP issue 845 on what scales.
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
    /// ```
    /// # use depth_core::camera::Intrinsics;
    /// # use depth_core::quantity::{Length, Pixels};
    /// # let px = Pixels::new;
    /// let camera = Intrinsics { fx: px(640.0), fy: px(640.0), cx: px(640.0), cy: px(360.0), width: px(1280.0), height: px(720.0) };
    /// let middle = camera.cropped(px(320.0), px(180.0), px(640.0), px(360.0)).unwrap();
    /// assert_eq!((middle.fx, middle.cx, middle.cy), (px(640.0), px(320.0), px(180.0)));
    /// ```
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
    /// ```
    /// # use depth_core::camera::Intrinsics;
    /// # use depth_core::quantity::{Length, Pixels};
    /// # let px = Pixels::new;
    /// let camera = Intrinsics { fx: px(640.0), fy: px(640.0), cx: px(640.0), cy: px(360.0), width: px(1280.0), height: px(720.0) };
    /// // 320 px right of the axis, which is half of f: half a meter at one meter.
    /// let point = camera.point(px(960.0), px(360.0), Length::from_m(1.0));
    /// assert_eq!(point, Some((Length::from_m(0.5), Length::from_m(0.0))));
    /// ```
    ///
    /// Source: inverse of the pinhole projection; Point Grey knowledge base article 10102.
    pub fn point(&self, u: Pixels, v: Pixels, depth: Length) -> Option<(Length, Length)> {
        Some((
            offset_from_axis(u, self.cx, depth, self.fx)?,
            offset_from_axis(v, self.cy, depth, self.fy)?,
        ))
    }

    /// How far the camera is from a point at `depth` that is seen at column `u` and row `v`: the length of the ray,
    /// R = Z·√(1 + ((u − cx)/fx)² + ((v − cy)/fy)²), which a tape measure or a laser would show.
    ///
    /// ```
    /// # use depth_core::camera::Intrinsics;
    /// # use depth_core::quantity::{Length, Pixels};
    /// # let px = Pixels::new;
    /// let camera = Intrinsics { fx: px(640.0), fy: px(640.0), cx: px(640.0), cy: px(360.0), width: px(1280.0), height: px(720.0) };
    /// // 3-4-5: X = 3 m at Z = 4 m.
    /// assert_eq!(camera.range(px(1120.0), px(360.0), Length::from_m(4.0)), Some(Length::from_m(5.0)));
    /// ```
    ///
    /// Source: Euclidean norm of (X, Y, Z) of [`point`](Self::point).
    pub fn range(&self, u: Pixels, v: Pixels, depth: Length) -> Option<Length> {
        let (x, y) = self.point(u, v, depth)?;
        range_of(x, y, depth)
    }

    fn finite(self) -> Option<Self> {
        let all = [self.fx, self.fy, self.cx, self.cy, self.width, self.height];
        all.iter().all(|pixels| pixels.px().is_finite()).then_some(self)
    }
}

/// How far off the optical axis a point lies that is seen at `pixel`, (pixel − principal point)·Z/f.
pub(super) fn offset_from_axis(pixel: Pixels, principal_point: Pixels, depth: Length, focal_length: Pixels) -> Option<Length> {
    signed_times_over(pixel.px() - principal_point.px(), depth.m(), focal_length.px()).map(Length::from_m)
}

/// √(X² + Y² + Z²)
pub(super) fn range_of(x: Length, y: Length, z: Length) -> Option<Length> {
    let range = root_sum_of_squares(&[x.m(), y.m(), z.m()]);
    range.is_finite().then_some(Length::from_m(range))
}
