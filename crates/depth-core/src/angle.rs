//! [`Angle`]: kept in radians, read and shown in any [`AngleUnit`].

use crate::quantity::Quantity;
use std::f64::consts::TAU;

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

    /// An angle of `value` in `unit`.
    ///
    /// ```
    /// use depth_core::angle::{Angle, AngleUnit};
    ///
    /// assert_eq!(Angle::new(30.0, AngleUnit::Arcminute), Angle::from_degrees(0.5));
    /// assert!((Angle::new(1600.0, AngleUnit::NatoMil).degrees() - 90.0).abs() < 1e-12);
    /// ```
    pub fn new(value: f64, unit: AngleUnit) -> Self {
        match unit {
            AngleUnit::Degree => Self::from_degrees(value),
            AngleUnit::Arcminute | AngleUnit::MinuteOfAngle => Self::from_degrees(value / 60.0),
            AngleUnit::Arcsecond => Self::from_degrees(value / 3600.0),
            AngleUnit::Radian => Self(value),
            AngleUnit::Milliradian => Self(value / 1000.0),
            AngleUnit::NatoMil => Self(value / NATO_MILS_PER_CIRCLE * TAU),
        }
    }

    /// This angle as a number of `unit`.
    ///
    /// ```
    /// use depth_core::angle::{Angle, AngleUnit};
    ///
    /// assert_eq!(Angle::from_radians(0.75e-3).in_unit(AngleUnit::Milliradian), 0.75);
    /// ```
    pub fn in_unit(self, unit: AngleUnit) -> f64 {
        match unit {
            AngleUnit::Degree => self.degrees(),
            AngleUnit::Arcminute | AngleUnit::MinuteOfAngle => self.degrees() * 60.0,
            AngleUnit::Arcsecond => self.degrees() * 3600.0,
            AngleUnit::Radian => self.0,
            AngleUnit::Milliradian => self.0 * 1000.0,
            AngleUnit::NatoMil => self.0 / TAU * NATO_MILS_PER_CIRCLE,
        }
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

/// A NATO mil is 1/6400 of the circle, 0.98175 mrad. (The former Soviet one is 1/6000, the Swedish streck was 1/6300.)
///
/// Source: NIST Special Publication 811, appendix B.8, "mil (angle)".
const NATO_MILS_PER_CIRCLE: f64 = 6400.0;

/// The units an angle can be typed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum AngleUnit {
    /// °
    Degree,
    /// ′, 1/60°
    Arcminute,
    /// ″, 1/3600°
    Arcsecond,
    /// rad
    Radian,
    /// mrad: what rifle scopes and most rangefinders call a "mil" or "mil-dot"
    Milliradian,
    /// MOA, a minute of angle: an arcminute by another name. (Some shooters round it to 1 in at 100 yd, which is 4.5 % less.)
    MinuteOfAngle,
    /// mil, 1/6400 of the circle: that of artillery, compasses and military binoculars
    NatoMil,
}

impl AngleUnit {
    /// Every unit, in the order in which menus list them.
    pub const ALL: [Self; 7] = [
        Self::Degree,
        Self::Arcminute,
        Self::Arcsecond,
        Self::Radian,
        Self::Milliradian,
        Self::MinuteOfAngle,
        Self::NatoMil,
    ];

    /// The unit's symbol, as written after a number.
    ///
    /// ```
    /// use depth_core::angle::AngleUnit;
    ///
    /// assert_eq!(AngleUnit::Milliradian.symbol(), "mrad");
    /// ```
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Degree => "°",
            Self::Arcminute => "′",
            Self::Arcsecond => "″",
            Self::Radian => "rad",
            Self::Milliradian => "mrad",
            Self::MinuteOfAngle => "MOA",
            Self::NatoMil => "mil",
        }
    }
}
