//! What can be chosen instead of typed: sensor formats with their true dimensions, matching errors that people
//! state, and scales of stored depths.

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
}

/// Common sensor formats, smallest first.
///
/// Source: the table of typical dimensions in Digital Photography Review, Making (some) sense out of sensor sizes, 2002,
/// and in the encyclopedias that follow it; sensors of one name differ by some percent. But 1/2.9″ is one chip, 1440 × 1080
/// pixels of 3.45 µm (Sony IMX273), so is 1/2.8″, 1920 × 1080 pixels of 2.9 µm (Sony IMX290), and 4/3 and full frame are fixed
/// by the Four Thirds and 35 mm film standards.
pub const SENSOR_FORMATS: [SensorFormat; 16] = [
    sensor("1/4″", 3.20, 2.40),
    sensor("1/3.2″", 4.54, 3.42),
    sensor("1/3″", 4.80, 3.60),
    sensor("1/2.9″", 4.968, 3.726),
    sensor("1/2.8″", 5.568, 3.132),
    sensor("1/2.5″", 5.76, 4.29),
    sensor("1/2.3″", 6.17, 4.55),
    sensor("1/2″", 6.40, 4.80),
    sensor("1/1.8″", 7.18, 5.32),
    sensor("1/1.7″", 7.60, 5.70),
    sensor("2/3″", 8.80, 6.60),
    sensor("1″", 13.20, 8.80),
    sensor("4/3", 17.30, 13.00),
    sensor("APS-C (Canon)", 22.30, 14.90),
    sensor("APS-C", 23.60, 15.60),
    sensor("Full frame", 36.00, 24.00),
];

const fn sensor(name: &'static str, width_mm: f64, height_mm: f64) -> SensorFormat {
    SensorFormat { name, width_mm, height_mm }
}

/// The format that is meant by the type of a sensor, such as "1/2.3 in", and its diagonal in millimeters: of a type that is not in the list
/// 18 mm to the inch below ½″, and 16 mm from there on. `None` where the text is no type.
///
/// ```
/// use depth_text::choices::sensor_of_type;
///
/// let (diagonal_mm, format) = sensor_of_type("1/2.3in").unwrap();
/// assert_eq!(format.unwrap().name, "1/2.3″");
/// assert!((diagonal_mm - 7.666).abs() < 1e-3);
/// assert_eq!(sensor_of_type("4.8 mm"), None);
/// ```
///
/// Source: as [`SENSOR_FORMATS`].
pub fn sensor_of_type(text: &str) -> Option<(f64, Option<&'static SensorFormat>)> {
    let text = text.trim();
    let inches = ["inch", "in", "″", "\"", "''"].iter().find_map(|unit| text.strip_suffix(unit));
    let number = inches.unwrap_or(text).trim_end();
    let of = |text: &str| {
        let (whole, part) = text.split_once('/').unwrap_or((text, "1"));
        let inches = whole.trim().parse::<f64>().ok()? / part.trim().parse::<f64>().ok()?;
        (inches > 0.0 && inches.is_finite()).then_some(inches)
    };
    // Without a unit 6.4/2 is a sum of its own.
    let is_type = ["1/", "2/", "4/"].iter().any(|begin| number.starts_with(begin));
    let size = of(number).filter(|_| inches.is_some() || is_type)?;
    let is_it = |format: &&SensorFormat| of(format.name.trim_end_matches('″')).is_some_and(|other| (other / size - 1.0).abs() < 1e-6);
    let format = SENSOR_FORMATS.iter().find(is_it);
    let diagonal = format.map_or(size * if size < 0.5 { 18.0 } else { 16.0 }, |format| {
        format.width_mm.hypot(format.height_mm)
    });
    Some((diagonal, format))
}

/// Matching errors that people state, smallest first: one σ of the disparity in px, and who states it, of what.
pub const MATCHING_ERRORS: [(f64, &str); 7] = [
    (0.08, "RealSense on good texture (librealsense #3904)"),
    (0.15, "Point Grey, by mask size 0.10 to 0.18"),
    (0.2, "Point Grey (knowledge base 10102)"),
    (0.25, "common (Carnegie Robotics)"),
    (0.4, "mrcal, 0.3 to 0.5"),
    (0.5, "limit (Carnegie Robotics)"),
    (1.3, "mrcal with a poor lens model"),
];

/// Steps in a meter of depths that are stored as whole numbers, fewest first, and who stores so.
pub const DEPTH_SCALES: [(f64, &str); 7] = [
    (100.0, "Virtual KITTI"),
    (256.0, "KITTI depth"),
    (1000.0, "RealSense, ScanNet"),
    (4000.0, "RealSense L515"),
    (5000.0, "TUM RGB-D, ICL-NUIM"),
    (8000.0, "RealSense SR300"),
    (10_000.0, "RealSense D405"),
];

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
