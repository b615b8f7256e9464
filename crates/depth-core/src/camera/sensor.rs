//! Sensor formats and their true dimensions.

/// A sensor format and its true dimensions.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SensorFormat {
    /// What it is called: an inch figure is the diameter of a video tube with about such a picture, half as much again as
    /// the sensor's diagonal.
    pub name: &'static str,
    /// Width in millimeters.
    pub width_mm: f64,
    /// Height in millimeters.
    pub height_mm: f64,
    /// Where the dimensions come from.
    pub basis: SensorBasis,
}

/// Where a [`SensorFormat`]'s dimensions come from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SensorBasis {
    /// Typical of the format; sensors of that name differ by some percent.
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
