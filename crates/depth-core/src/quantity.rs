//! Quantities that carry their unit in their type: [`Length`] in meters, [`Pixels`] in image pixels.

/// A quantity that is kept as a number of its base unit: meters, pixels or radians; for a plain number, itself.
pub trait Quantity: Copy {
    /// Nothing of it.
    const ZERO: Self;

    /// `value` base units.
    fn from_base(value: f64) -> Self;

    /// The number of base units.
    fn to_base(self) -> f64;
}

impl Quantity for f64 {
    const ZERO: Self = 0.0;

    fn from_base(value: f64) -> Self {
        value
    }

    fn to_base(self) -> f64 {
        self
    }
}

impl Quantity for Length {
    const ZERO: Self = Self(0.0);

    fn from_base(meters: f64) -> Self {
        Self(meters)
    }

    fn to_base(self) -> f64 {
        self.0
    }
}

impl Quantity for Pixels {
    const ZERO: Self = Self(0.0);

    fn from_base(pixels: f64) -> Self {
        Self(pixels)
    }

    fn to_base(self) -> f64 {
        self.0
    }
}

/// A length, kept in meters whatever unit it was given in.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Length(f64);

impl Length {
    /// A length of `meters` meters.
    ///
    /// ```
    /// use depth_core::quantity::{Length, LengthUnit};
    ///
    /// assert_eq!(Length::from_m(0.1).in_unit(LengthUnit::Centimeter), 10.0);
    /// ```
    pub const fn from_m(meters: f64) -> Self {
        Self(meters)
    }

    /// A length of `value` in `unit`.
    ///
    /// ```
    /// use depth_core::quantity::{Length, LengthUnit};
    ///
    /// assert_eq!(Length::new(100.0, LengthUnit::Millimeter).m(), 0.1);
    /// ```
    pub fn new(value: f64, unit: LengthUnit) -> Self {
        Self(match unit {
            // Dividing by a power of ten rounds once, so that 100 mm is exactly the f64 nearest to 0.1.
            LengthUnit::Nanometer => value / 1e9,
            LengthUnit::Micrometer => value / 1e6,
            LengthUnit::Millimeter => value / 1000.0,
            LengthUnit::Centimeter => value / 100.0,
            LengthUnit::Meter => value,
            LengthUnit::Kilometer => value * 1000.0,
            LengthUnit::Inch => value * METERS_PER_INCH,
            LengthUnit::Foot => value * METERS_PER_FOOT,
            LengthUnit::Yard => value * METERS_PER_YARD,
            LengthUnit::Mile => value * METERS_PER_MILE,
        })
    }

    /// This length in meters.
    ///
    /// ```
    /// use depth_core::quantity::{Length, LengthUnit};
    ///
    /// assert_eq!(Length::new(1.0, LengthUnit::Foot).m(), 0.3048);
    /// ```
    pub const fn m(self) -> f64 {
        self.0
    }

    /// This length as a number of `unit`.
    ///
    /// ```
    /// use depth_core::quantity::{Length, LengthUnit};
    ///
    /// assert_eq!(Length::from_m(0.0254).in_unit(LengthUnit::Inch), 1.0);
    /// ```
    pub fn in_unit(self, unit: LengthUnit) -> f64 {
        match unit {
            LengthUnit::Nanometer => self.0 * 1e9,
            LengthUnit::Micrometer => self.0 * 1e6,
            LengthUnit::Millimeter => self.0 * 1000.0,
            LengthUnit::Centimeter => self.0 * 100.0,
            LengthUnit::Meter => self.0,
            LengthUnit::Kilometer => self.0 / 1000.0,
            LengthUnit::Inch => self.0 / METERS_PER_INCH,
            LengthUnit::Foot => self.0 / METERS_PER_FOOT,
            LengthUnit::Yard => self.0 / METERS_PER_YARD,
            LengthUnit::Mile => self.0 / METERS_PER_MILE,
        }
    }
}

/// Exact by definition: international yard and pound agreement, 1959.
const METERS_PER_INCH: f64 = 0.0254;
/// Exact by definition: international yard and pound agreement, 1959.
const METERS_PER_FOOT: f64 = 0.3048;
/// Exact by definition: international yard and pound agreement, 1959.
const METERS_PER_YARD: f64 = 0.9144;
/// Exact by definition: 1760 yards.
const METERS_PER_MILE: f64 = 1609.344;

/// A distance in the image plane, in pixels. Also the unit of a focal length in the pinhole model.
#[derive(Clone, Copy, Debug, PartialEq, PartialOrd)]
pub struct Pixels(f64);

impl Pixels {
    /// `value` pixels.
    ///
    /// ```
    /// use depth_core::quantity::Pixels;
    ///
    /// assert!(Pixels::new(50.0) < Pixels::new(51.0));
    /// ```
    pub const fn new(value: f64) -> Self {
        Self(value)
    }

    /// The number of pixels.
    ///
    /// ```
    /// use depth_core::quantity::Pixels;
    ///
    /// assert_eq!(Pixels::new(700.0).px(), 700.0);
    /// ```
    pub const fn px(self) -> f64 {
        self.0
    }
}

/// The units a length can be typed and shown in.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize, serde::Deserialize))]
pub enum LengthUnit {
    /// nm
    #[cfg_attr(feature = "serde", serde(rename = "nm"))]
    Nanometer,
    /// µm
    #[cfg_attr(feature = "serde", serde(rename = "µm"))]
    Micrometer,
    /// mm
    #[cfg_attr(feature = "serde", serde(rename = "mm"))]
    Millimeter,
    /// cm
    #[cfg_attr(feature = "serde", serde(rename = "cm"))]
    Centimeter,
    /// m
    #[cfg_attr(feature = "serde", serde(rename = "m"))]
    Meter,
    /// km
    #[cfg_attr(feature = "serde", serde(rename = "km"))]
    Kilometer,
    /// in
    #[cfg_attr(feature = "serde", serde(rename = "in"))]
    Inch,
    /// ft
    #[cfg_attr(feature = "serde", serde(rename = "ft"))]
    Foot,
    /// yd
    #[cfg_attr(feature = "serde", serde(rename = "yd"))]
    Yard,
    /// mi
    #[cfg_attr(feature = "serde", serde(rename = "mi"))]
    Mile,
}

impl LengthUnit {
    /// Every unit, the metric ones first, each system from small to large.
    pub const ALL: [Self; 10] = [
        Self::Nanometer,
        Self::Micrometer,
        Self::Millimeter,
        Self::Centimeter,
        Self::Meter,
        Self::Kilometer,
        Self::Inch,
        Self::Foot,
        Self::Yard,
        Self::Mile,
    ];

    /// The units that objects and baselines are measured in every day; a slip is from one of these to another.
    pub const COMMON: [Self; 5] = [Self::Millimeter, Self::Centimeter, Self::Meter, Self::Inch, Self::Foot];

    /// The unit's symbol, as written after a number.
    ///
    /// ```
    /// use depth_core::quantity::LengthUnit;
    ///
    /// assert_eq!(LengthUnit::Inch.symbol(), "in");
    /// ```
    pub const fn symbol(self) -> &'static str {
        match self {
            Self::Nanometer => "nm",
            Self::Micrometer => "µm",
            Self::Millimeter => "mm",
            Self::Centimeter => "cm",
            Self::Meter => "m",
            Self::Kilometer => "km",
            Self::Inch => "in",
            Self::Foot => "ft",
            Self::Yard => "yd",
            Self::Mile => "mi",
        }
    }
}
