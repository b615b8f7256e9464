//! What can be chosen instead of typed: sensor formats with their true dimensions, and matching errors that people state.

use depth_core::quantity::Pixels;

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

/// A standard deviation that somebody states for the disparities of a matcher.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MatchingError {
    /// One standard deviation.
    pub sigma: Pixels,
    /// Who states it, and of what.
    pub source: &'static str,
}

/// Matching errors that people state, smallest first, to choose a σ of the disparity from.
pub const MATCHING_ERRORS: [MatchingError; 7] = [
    matching_error(0.08, "RealSense on good texture (librealsense #3904)"),
    matching_error(0.15, "Point Grey, by mask size 0.10 to 0.18"),
    matching_error(0.2, "Point Grey (knowledge base 10102)"),
    matching_error(0.25, "common (Carnegie Robotics)"),
    matching_error(0.4, "mrcal, 0.3 to 0.5"),
    matching_error(0.5, "limit (Carnegie Robotics)"),
    matching_error(1.3, "mrcal with a poor lens model"),
];

const fn matching_error(sigma_px: f64, source: &'static str) -> MatchingError {
    MatchingError {
        sigma: Pixels::new(sigma_px),
        source,
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    fn an_inch_of_a_sensor_format_is_about_16_mm_of_diagonal() {
        for format in SENSOR_FORMATS {
            let Some(fraction) = format.name.strip_suffix('″').or((format.name == "4/3").then_some("4/3")) else {
                continue;
            };
            let (whole, part) = fraction.split_once('/').unwrap_or((fraction, "1"));
            let inches = whole.parse::<f64>().unwrap() / part.parse::<f64>().unwrap();
            let per_inch = format.width_mm.hypot(format.height_mm) / inches;
            // Sensors up to 1/2.3″ are traditionally named by 18 mm to the inch, larger ones by 16.
            assert!((15.8..18.3).contains(&per_inch), "{}: {per_inch}", format.name);
        }
        assert!(SENSOR_FORMATS.is_sorted_by(|a, b| a.width_mm < b.width_mm));
        let name = |name| SENSOR_FORMATS.iter().find(|format| format.name == name).unwrap();
        assert_eq!((name("Full frame").width_mm, name("Full frame").height_mm), (36.0, 24.0));
    }
}
