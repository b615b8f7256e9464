//! [`Angle`]: kept in radians, read and shown in degrees.

use crate::quantity::Quantity;

/// An angle, kept in radians whatever unit it was given in.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Angle(f64);

impl Angle {
    /// An angle of `radians` rad.
    pub const fn from_radians(radians: f64) -> Self {
        Self(radians)
    }

    /// An angle of `degrees`°.
    pub const fn from_degrees(degrees: f64) -> Self {
        Self(degrees.to_radians())
    }

    /// This angle in radians.
    pub const fn radians(self) -> f64 {
        self.0
    }

    /// This angle in degrees.
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
