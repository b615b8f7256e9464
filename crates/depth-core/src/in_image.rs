//! [`InImage`]: what is measured in an image, in whichever unit.

use crate::angle::Angle;
use crate::measured::Measured;
use crate::quantity::{Length, Pixels};

/// An extent in an image (a disparity, the width of an object), or the focal length that belongs to it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum InImage {
    /// In pixels.
    Pixels(Measured<Pixels>),
    /// As a length on the sensor or the film; the focal length is then the principal distance.
    OnSensor(Measured<Length>),
    /// As the angle that the extent subtends, seen from the lens. It needs no focal length, and a focal length is none.
    Angle(Measured<Angle>),
}

impl InImage {
    /// `value` pixels, taken to be exact.
    ///
    /// ```
    /// use depth_core::in_image::InImage;
    ///
    /// assert_eq!(InImage::from_px(50.0).to_base().value, 50.0);
    /// ```
    pub const fn from_px(value: f64) -> Self {
        Self::Pixels(Measured::exact(Pixels::new(value)))
    }

    /// Value and σ in px, meters or radians.
    ///
    /// ```
    /// use depth_core::in_image::InImage;
    /// use depth_core::measured::Measured;
    ///
    /// let on_film = InImage::OnSensor(Measured::from_base(0.03625, 0.0001));
    /// assert_eq!(on_film.to_base(), Measured::new(0.03625, 0.0001));
    /// ```
    pub fn to_base(self) -> Measured<f64> {
        match self {
            Self::Pixels(pixels) => pixels.to_base(),
            Self::OnSensor(length) => length.to_base(),
            Self::Angle(angle) => angle.to_base(),
        }
    }

    /// Value and σ where it is in pixels.
    ///
    /// ```
    /// use depth_core::in_image::InImage;
    ///
    /// assert!(InImage::from_px(50.0).px().is_some());
    /// ```
    pub const fn px(self) -> Option<Measured<Pixels>> {
        match self {
            Self::Pixels(pixels) => Some(pixels),
            Self::OnSensor(_) | Self::Angle(_) => None,
        }
    }

    /// The same kind of measure with another value and σ in its base unit.
    ///
    /// ```
    /// use depth_core::in_image::InImage;
    /// use depth_core::measured::Measured;
    ///
    /// assert_eq!(InImage::from_px(50.0).with_base(Measured::new(51.0, 0.0)), InImage::from_px(51.0));
    /// ```
    #[must_use]
    pub fn with_base(self, base: Measured<f64>) -> Self {
        let Measured { value, sigma } = base;
        match self {
            Self::Pixels(_) => Self::Pixels(Measured::from_base(value, sigma)),
            Self::OnSensor(_) => Self::OnSensor(Measured::from_base(value, sigma)),
            Self::Angle(_) => Self::Angle(Measured::from_base(value, sigma)),
        }
    }

    /// The relative σ; see [`Measured::relative`].
    ///
    /// ```
    /// use depth_core::in_image::InImage;
    ///
    /// assert_eq!(InImage::from_px(50.0).relative(), 0.0);
    /// ```
    pub fn relative(self) -> f64 {
        self.to_base().relative()
    }
}

/// An angle as the multiple of the focal length that its extent is in the middle of the image, 2·tan(α/2), with σ to first order;
/// α without σ is exact.
///
/// Source: pinhole projection of an extent that is centered on the optical axis; JCGM 100:2008 (GUM), 5.1.2, with the derivative
/// 1 + tan²(α/2).
pub(crate) fn extent_of(angle: Measured<Angle>) -> Measured<f64> {
    let tangent = (angle.value.radians() / 2.0).tan();
    Measured::new(2.0 * tangent, angle.sigma.radians() * (1.0 + tangent * tangent))
}
