//! Lenses that are no pinhole: where a ray at some angle from the axis meets the image.

use super::focal_length::positive;
use crate::angle::Angle;
use crate::quantity::Pixels;
use std::f64::consts::{FRAC_PI_2, PI};

/// How far from the center of the image a ray is seen, in focal lengths, by its angle θ from the axis.
///
/// Source: J. Kannala, S. Brandt, A generic camera model and calibration method for conventional, wide-angle, and fish-eye lenses, 2006,
/// equations 1 to 5.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Projection {
    /// r = f·tan θ, up to 90°.
    #[default]
    Pinhole,
    /// r = f·θ, up to 180°.
    Equidistant,
    /// r = 2f·sin(θ/2), up to 180°.
    Equisolid,
    /// r = 2f·tan(θ/2), below 180°.
    Stereographic,
    /// r = f·sin θ, up to 90°.
    Orthographic,
}

impl Projection {
    /// All of them.
    pub const ALL: [Self; 5] = [
        Self::Pinhole,
        Self::Equidistant,
        Self::Equisolid,
        Self::Stereographic,
        Self::Orthographic,
    ];

    /// What it is called.
    ///
    /// ```
    /// use depth_core::camera::Projection;
    ///
    /// assert_eq!(Projection::Equisolid.name(), "equisolid");
    /// ```
    pub const fn name(self) -> &'static str {
        match self {
            Self::Pinhole => "pinhole",
            Self::Equidistant => "equidistant",
            Self::Equisolid => "equisolid",
            Self::Stereographic => "stereographic",
            Self::Orthographic => "orthographic",
        }
    }

    /// r/f of a ray at `angle` from the axis; `None` where the projection has no such rays.
    fn radius(self, angle: f64) -> Option<f64> {
        let (radius, most) = match self {
            Self::Pinhole => (angle.tan(), FRAC_PI_2),
            Self::Equidistant => (angle, PI),
            Self::Equisolid => (2.0 * (angle / 2.0).sin(), PI),
            Self::Stereographic => (2.0 * (angle / 2.0).tan(), PI),
            Self::Orthographic => (angle.sin(), FRAC_PI_2),
        };
        // At its end the image of a pinhole is infinitely large; that of an orthographic one is not.
        let is_inside = angle > 0.0 && (angle < most || angle <= most && !matches!(self, Self::Pinhole | Self::Stereographic));
        is_inside.then_some(radius)
    }

    /// The angle from the axis of a ray that is seen at `radius` focal lengths; `None` where nothing is.
    fn angle(self, radius: f64) -> Option<f64> {
        let angle = match self {
            Self::Pinhole => radius.atan(),
            Self::Equidistant => radius,
            Self::Equisolid => 2.0 * (radius / 2.0).asin(),
            Self::Stereographic => 2.0 * (radius / 2.0).atan(),
            Self::Orthographic => radius.asin(),
        };
        (radius >= 0.0 && angle.is_finite() && angle <= PI).then_some(angle)
    }

    /// The focal length of a lens that sees `view` over `extent` pixels around the center.
    ///
    /// `None` where it can see no such view: a pinhole none of 180° or more.
    ///
    /// ```
    /// use depth_core::angle::Angle;
    /// use depth_core::camera::Projection;
    /// use depth_core::quantity::Pixels;
    ///
    /// let view = Angle::from_degrees(180.0);
    /// assert_eq!(Projection::Pinhole.focal_length(view, Pixels::new(1000.0)), None);
    /// let f = Projection::Orthographic.focal_length(view, Pixels::new(1000.0)).unwrap();
    /// assert!((f.px() - 500.0).abs() < 1e-9);
    /// ```
    pub fn focal_length(self, view: Angle, extent: Pixels) -> Option<Pixels> {
        positive(extent.px() / 2.0 / self.radius(view.radians() / 2.0)?)
    }

    /// What a lens of this focal length sees over `extent` pixels around the center; `None` where the image is larger than what it
    /// can see.
    ///
    /// ```
    /// use depth_core::camera::Projection;
    /// use depth_core::quantity::Pixels;
    ///
    /// let view = Projection::Pinhole.view(Pixels::new(640.0), Pixels::new(1280.0)).unwrap();
    /// assert!((view.degrees() - 90.0).abs() < 1e-12);
    /// ```
    pub fn view(self, focal_length: Pixels, extent: Pixels) -> Option<Angle> {
        let radius = positive(extent.px() / 2.0 / positive(focal_length.px())?.px())?;
        self.angle(radius.px()).map(|angle| Angle::from_radians(2.0 * angle))
    }
}
