//! [`Angle`]: kept in radians, read and shown in degrees.

use crate::quantity::Quantity;

/// An angle, kept in radians whatever unit it was given in.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Angle(f64);

impl Angle {
    /// An angle of `radians` rad.
    ///
    /// ```
    /// use depth_core::angle::Angle;
    ///
    /// assert_eq!(Angle::from_radians(std::f64::consts::PI).degrees(), 180.0);
    /// ```
    pub const fn from_radians(radians: f64) -> Self {
        Self(radians)
    }

    /// An angle of `degrees`°.
    ///
    /// ```
    /// use depth_core::angle::Angle;
    ///
    /// assert_eq!(Angle::from_degrees(180.0).radians(), std::f64::consts::PI);
    /// ```
    pub const fn from_degrees(degrees: f64) -> Self {
        Self(degrees.to_radians())
    }

    /// This angle in radians.
    ///
    /// ```
    /// use depth_core::angle::Angle;
    ///
    /// assert_eq!(Angle::from_radians(0.5).radians(), 0.5);
    /// ```
    pub const fn radians(self) -> f64 {
        self.0
    }

    /// This angle in degrees.
    ///
    /// ```
    /// use depth_core::angle::Angle;
    ///
    /// assert_eq!(Angle::from_degrees(90.0).degrees(), 90.0);
    /// ```
    pub const fn degrees(self) -> f64 {
        self.0.to_degrees()
    }
}

impl Quantity for Angle {
    const ZERO: Self = Self(0.0);

    fn from_base(radians: f64) -> Self {
        Self(radians)
    }

    fn to_base(self) -> f64 {
        self.0
    }
}
