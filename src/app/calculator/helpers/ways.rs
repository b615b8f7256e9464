//! The table of ways to compute an input: a focal length from a lens, a field of view or a photograph; a disparity from the value that
//! a program stored; doffs.
//!
//! A [`Way`] is a row: what it asks for, what it computes, and which field takes the result.

use crate::app::command::Helper;
use crate::core::angle::Angle;
use crate::core::camera::{self, Intrinsics};
use crate::core::disparity::{self, Encoding, NoDisparity, SubpixelBits};
use crate::core::measured::Measured;
use crate::core::problem::Field;
use crate::core::quantity::{Length, LengthUnit, Pixels};

/// The ways that `helper` offers.
pub const fn of(helper: Helper) -> &'static [Way] {
    match helper {
        Helper::FocalLength => FOCAL_LENGTH,
        Helper::Disparity => DISPARITY,
    }
}

/// A number that a way asks for.
pub struct Ask {
    /// The label of its field.
    pub name: &'static str,
    /// The symbol of its unit, or nothing.
    pub unit: &'static str,
    /// What is shown while the field is empty.
    pub example: &'static str,
}

/// One way to a number.
pub struct Way {
    /// What it is called in the list of ways.
    pub name: &'static str,
    /// The formula, and what to watch out for.
    pub remark: &'static str,
    /// The numbers that it asks for.
    pub asks: &'static [Ask],
    /// The field that takes the result.
    pub field: Field,
    /// The result in px from the numbers asked for, in their order; or what is wrong, empty where a number is missing.
    pub compute: fn(&[f64]) -> Result<f64, String>,
}

const fn ask(name: &'static str, unit: &'static str, example: &'static str) -> Ask {
    Ask { name, unit, example }
}

const LENS: Ask = ask("Focal length of the lens", "mm", "4");
const IMAGE_WIDTH: Ask = ask("Width of the image", "px", "1280");
const IMAGE_HEIGHT: Ask = ask("Height of the image", "px", "720");

const FOCAL_LENGTH: &[Way] = &[
    Way {
        name: "Lens and pixel size",
        remark: "fx = focal length / pixel pitch. Use the pitch of the image as you have it: twice as large after 2 × 2 binning.",
        asks: &[LENS, ask("Pixel pitch", "µm", "3")],
        field: Field::FocalLength,
        compute: |n| {
            let [lens, pitch] = *n else { return incomplete() };
            found(camera::focal_length_from_pixel_pitch(mm(lens), mm(pitch / 1000.0)))
        },
    },
    Way {
        name: "Lens and sensor width",
        remark: "fx = focal length · image width / sensor width. An inch figure is a name, not a size: choose the format below.",
        asks: &[LENS, SENSOR_WIDTH, IMAGE_WIDTH],
        field: Field::FocalLength,
        compute: |n| {
            let [lens, sensor, width] = *n else { return incomplete() };
            found(camera::focal_length_from_sensor_width(mm(lens), mm(sensor), Pixels::new(width)))
        },
    },
    Way {
        name: "Horizontal field of view",
        remark: "fx = (width / 2) / tan(view / 2). A datasheet often gives the view before rectification, which is wider.",
        asks: &[ask("Horizontal field of view", "°", "69"), IMAGE_WIDTH],
        field: Field::FocalLength,
        compute: |n| {
            let [view, width] = *n else { return incomplete() };
            found(camera::focal_length_from_field_of_view(
                Angle::from_degrees(view),
                Pixels::new(width),
            ))
        },
    },
    Way {
        name: "Vertical field of view",
        remark: "fy = (height / 2) / tan(view / 2); with square pixels fx is the same.",
        asks: &[ask("Vertical field of view", "°", "42"), IMAGE_HEIGHT],
        field: Field::FocalLength,
        compute: |n| {
            let [view, height] = *n else { return incomplete() };
            found(camera::focal_length_from_field_of_view(
                Angle::from_degrees(view),
                Pixels::new(height),
            ))
        },
    },
    Way {
        name: "Diagonal field of view",
        remark: "fx = ½ · √(width² + height²) / tan(view / 2).",
        asks: &[ask("Diagonal field of view", "°", "78"), IMAGE_WIDTH, IMAGE_HEIGHT],
        field: Field::FocalLength,
        compute: |n| {
            let [view, width, height] = *n else { return incomplete() };
            let diagonal = camera::diagonal(Pixels::new(width), Pixels::new(height));
            found(camera::focal_length_from_field_of_view(Angle::from_degrees(view), diagonal))
        },
    },
    Way {
        name: "One reference photo",
        remark: "fx = width in the image · distance / real width, for something of known width at a measured distance, facing the camera.",
        asks: &[
            ask("Its width in the image", "px", "150"),
            ask("Its distance", "m", "1.4"),
            ask("Its real width", "m", "0.3"),
        ],
        field: Field::FocalLength,
        compute: |n| {
            let [width, distance, real] = *n else { return incomplete() };
            found(camera::focal_length_from_reference_photo(
                Pixels::new(width),
                Length::from_m(distance),
                Length::from_m(real),
            ))
        },
    },
    Way {
        name: "Same camera, other resolution",
        remark: "Resizing scales fx and the disparity, never the baseline. Cropping changes neither: enter the width before the crop.",
        asks: &[
            ask("Known focal length", "px", "631.3"),
            ask("Width of the image it belongs to", "px", "1280"),
            ask("Width after resizing, before any crop", "px", "768"),
        ],
        field: Field::FocalLength,
        compute: |n| {
            let [focal_length, before, after] = *n else { return incomplete() };
            // Square pixels and the same scale both ways: only the width matters to fx.
            let (f, w) = (Pixels::new(focal_length), Pixels::new(before));
            let camera = Intrinsics {
                fx: f,
                fy: f,
                cx: w,
                cy: w,
                width: w,
                height: w,
            };
            found(camera.resized(Pixels::new(after), Pixels::new(after)).map(|camera| camera.fx))
        },
    },
];

/// The field beside which common sensor formats are offered.
pub const SENSOR_WIDTH: Ask = ask("Width of the sensor", "mm", "4.8");

const RAW: Ask = ask("Stored value", "", "800");

const DISPARITY: &[Way] = &[
    Way {
        name: "Columns in both images",
        remark: "d = x left − x right, in the rectified images.",
        asks: &[ask("x in the left image", "px", "660"), ask("x in the right image", "px", "610")],
        field: Field::Disparity,
        compute: |n| {
            let [left, right] = *n else { return incomplete() };
            Ok(disparity::from_columns(Measured::exact(left), Measured::exact(right)).value)
        },
    },
    Way {
        name: "OpenCV StereoBM or StereoSGBM",
        remark: "They store sixteenths of a pixel in 16-bit numbers; (minDisparity − 1) · 16 means that nothing was found.",
        asks: &[RAW, ask("minDisparity", "", "0")],
        field: Field::Disparity,
        compute: |n| {
            let [stored, min_disparity] = *n else { return incomplete() };
            if min_disparity.fract() != 0.0 || min_disparity.abs() > 30_000.0 {
                return Err("minDisparity is a whole number, such as 0.".to_owned());
            }
            #[expect(clippy::cast_possible_truncation, reason = "checked to be whole and small")]
            let min_disparity = min_disparity as i32;
            decoded(Encoding::OpenCv { min_disparity }, stored)
        },
    },
    Way {
        name: "KITTI, 16-bit image",
        remark: "It stores 256ths of a pixel; 0 means that there is none.",
        asks: &[RAW],
        field: Field::Disparity,
        compute: |n| {
            let [stored] = *n else { return incomplete() };
            decoded(Encoding::Kitti, stored)
        },
    },
    Way {
        name: "DepthAI, sub-pixel",
        remark: "With 3, 4 or 5 sub-pixel bits it stores 8ths, 16ths or 32nds of a pixel.",
        asks: &[RAW, ask("Sub-pixel bits", "", "3")],
        field: Field::Disparity,
        compute: |n| {
            let [stored, bits] = *n else { return incomplete() };
            let bits = match bits {
                3.0 => SubpixelBits::Three,
                4.0 => SubpixelBits::Four,
                5.0 => SubpixelBits::Five,
                _ => return Err("DepthAI has 3, 4 or 5 sub-pixel bits.".to_owned()),
            };
            decoded(Encoding::DepthAi(bits), stored)
        },
    },
    Way {
        name: "Fraction of the image width",
        remark: "Some networks give the disparity as a part of the width of the image.",
        asks: &[ask("Fraction", "", "0.039"), IMAGE_WIDTH],
        field: Field::Disparity,
        compute: |n| {
            let [fraction, width] = *n else { return incomplete() };
            decoded(
                Encoding::FractionOfWidth {
                    image_width: Pixels::new(width),
                },
                fraction,
            )
        },
    },
    Way {
        name: "ZED, negative sign",
        remark: "The ZED SDK gives disparities with the opposite sign.",
        asks: &[ask("Disparity of the ZED", "px", "−50")],
        field: Field::Disparity,
        compute: |n| {
            let [stored] = *n else { return incomplete() };
            decoded(Encoding::Zed, stored)
        },
    },
    Way {
        name: "doffs from both principal points",
        remark: "doffs = cx right − cx left. Stereo then reads D = fx · b / (d + doffs). Zero for most rectified pairs.",
        asks: &[
            ask("cx of the left camera", "px", "610"),
            ask("cx of the right camera", "px", "650"),
        ],
        field: Field::Doffs,
        compute: |n| {
            let [left, right] = *n else { return incomplete() };
            Ok(disparity::doffs(Measured::exact(left), Measured::exact(right)).value)
        },
    },
    Way {
        name: "doffs as a calibration file gives it",
        remark: "Middlebury's calib.txt has it by this name.",
        asks: &[ask("doffs", "px", "131.1")],
        field: Field::Doffs,
        compute: |n| {
            let [doffs] = *n else { return incomplete() };
            Ok(doffs)
        },
    },
];

fn mm(millimeters: f64) -> Length {
    Length::new(millimeters, LengthUnit::Millimetre)
}

fn incomplete() -> Result<f64, String> {
    Err(String::new())
}

fn found(focal_length: Option<Pixels>) -> Result<f64, String> {
    focal_length
        .map(Pixels::px)
        .ok_or_else(|| "These numbers give no focal length: all must be above zero, and a field of view below 180°.".to_owned())
}

fn decoded(encoding: Encoding, stored: f64) -> Result<f64, String> {
    encoding.decode(stored).map(Pixels::px).map_err(|error| {
        match error {
            NoDisparity::Invalid => "This value means that the matcher found nothing at this pixel.",
            NoDisparity::NotWhole => "This encoding stores whole numbers: the value may have been divided already.",
            NoDisparity::OutOfRange => "This encoding cannot hold such a value.",
        }
        .to_owned()
    })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
    use super::*;

    fn compute(helper: Helper, name: &str, numbers: &[f64]) -> Result<f64, String> {
        let way = of(helper).iter().find(|way| way.name == name).unwrap_or_else(|| panic!("{name}"));
        assert_eq!(way.asks.len(), numbers.len(), "{name}");
        (way.compute)(numbers)
    }

    /// Golden figures: f_mm / pixel pitch by hand; OpenCV's `calibrationMatrixValues` (2.625 mm on 4.8 mm with
    /// 1280 px is 700 px); the vendor's OAK-D Lite (73° on 640 px is 432.5 px); the mug; the D435i's 0.6 scale.
    #[test]
    fn focal_lengths_come_out_as_published() {
        for (name, numbers, expected) in [
            ("Lens and pixel size", &[4.0, 3.0][..], 1333.333),
            ("Lens and sensor width", &[2.625, 4.8, 1280.0], 700.0),
            ("Horizontal field of view", &[73.0, 640.0], 432.45),
            ("Vertical field of view", &[54.093_788, 720.0], 705.0),
            ("Diagonal field of view", &[90.0, 800.0, 600.0], 500.0),
            ("One reference photo", &[150.0, 1.4, 0.3], 700.0),
            ("Same camera, other resolution", &[631.343, 1280.0, 768.0], 378.806),
        ] {
            let got = compute(Helper::FocalLength, name, numbers).unwrap();
            // The vertical one has its principal point 10 px off the center in the source.
            let tolerance = if name.starts_with("Vertical") { 1e-3 } else { 2e-4 };
            assert!((got / expected - 1.0).abs() < tolerance, "{name}: {got}");
        }
    }

    #[test]
    fn every_way_to_the_mug_s_fifty_pixels() {
        for (name, numbers) in [
            ("Columns in both images", &[660.0, 610.0][..]),
            ("OpenCV StereoBM or StereoSGBM", &[800.0, 0.0]),
            ("KITTI, 16-bit image", &[12_800.0]),
            ("DepthAI, sub-pixel", &[400.0, 3.0]),
            ("Fraction of the image width", &[50.0 / 1280.0, 1280.0]),
            ("ZED, negative sign", &[-50.0]),
        ] {
            assert_eq!(compute(Helper::Disparity, name, numbers), Ok(50.0), "{name}");
        }
        assert_eq!(
            compute(Helper::Disparity, "doffs from both principal points", &[610.0, 650.0]),
            Ok(40.0)
        );
    }

    #[test]
    fn invalid_values_of_opencv_are_recognized_for_the_min_disparity_given() {
        for (stored, min_disparity) in [(-16.0, 0.0), (240.0, 16.0), (-272.0, -16.0)] {
            let reason = compute(Helper::Disparity, "OpenCV StereoBM or StereoSGBM", &[stored, min_disparity]).unwrap_err();
            assert!(reason.contains("found nothing"), "{reason}");
        }
    }

    #[test]
    fn numbers_that_give_no_focal_length_are_refused_in_words() {
        for (name, numbers) in [
            ("Horizontal field of view", &[180.0, 640.0][..]),
            ("Lens and pixel size", &[0.0, 3.0]),
        ] {
            assert!(compute(Helper::FocalLength, name, numbers).unwrap_err().contains("no focal length"));
        }
    }
}
