//! The ways to a number that is not known as such: a focal length from a lens, a field of view or a photograph; a disparity
//! or doffs from what a program stored.
//!
//! A [`Way`] is a row of a table: which fields it asks for, what it computes from their readings, and which field takes the
//! result. Typed units count: a pixel pitch may be in µm or mm.

use crate::entry::{Entries, Entry};
use crate::field::Key;
use crate::fields::{self, BASELINE, DISPARITY, DOFFS, FOCAL_LENGTH, FRAME_HEIGHT, FRAME_WIDTH, LENS, STORED_VALUE};
use crate::note::{Fix, Issue, Note};
use crate::number::{plain, significant};
use crate::reading::{self, Reading};
use depth_core::angle::Angle;
use depth_core::camera;
use depth_core::disparity::{self, Encoding, SubpixelBits};
use depth_core::measured::Measured;
use depth_core::quantity::{Length, LengthUnit, Pixels};
use depth_core::stereo;
use std::f64::consts::PI;

/// One way to a number.
#[derive(Clone, Copy, Debug)]
pub struct Way {
    /// Its name in what is stored. Never changes.
    pub key: &'static str,
    /// The name people choose it by.
    pub name: &'static str,
    /// The formula, and what to watch out for.
    pub remark: &'static str,
    /// The fields it asks for.
    pub asks: &'static [Key],
    /// The field that takes the result.
    pub target: Key,
    compute: Compute,
}

/// A number that was typed into a way and goes into the form with its result.
type Also = (Key, Entry);

/// The result in the base unit of the target from the values of as many fields, in the order of [`Way::asks`] and in their base units.
#[derive(Clone, Copy, Debug)]
enum Compute {
    One(fn(f64) -> Result<f64, Issue>),
    Two(fn(f64, f64) -> Result<f64, Issue>),
    Three(fn(f64, f64, f64) -> Result<f64, Issue>),
}

/// What came of a way.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WayResult {
    /// The result in the base unit of the target, px or meters; `None` while something is missing or wrong.
    pub value: Option<f64>,
    /// The horizontal field of view that a focal length means, where the width of the image is asked for.
    pub view: Option<Angle>,
    /// What could be read of the fields it asks for.
    pub readings: Vec<Reading>,
    /// What is wrong with a field, or, at the first of them, with all of them together.
    pub notes: Vec<Note>,
}

impl Way {
    /// Reads the fields it asks for, and computes where all are there. A taped distance counts from `zero` in front of the lens.
    pub fn solve(&self, entries: &Entries, zero: Length) -> WayResult {
        let mut result = WayResult::default();
        for &key in self.asks {
            match reading::read(key, entries.entry(key)) {
                Ok(Some(reading)) if may_be_radians(&reading) => result.notes.push(degrees_or_radians(&reading)),
                Ok(reading) => result.readings.extend(reading),
                Err(note) => result.notes.push(note),
            }
        }
        let from_lens = |reading: &Reading| {
            let is_taped = reading.key == fields::REFERENCE_DISTANCE;
            if is_taped { reading.value + zero.m() } else { reading.value }
        };
        let values: Vec<f64> = result.readings.iter().map(from_lens).collect();
        let computed = match (self.compute, values.as_slice()) {
            (Compute::One(of), &[a]) => of(a),
            (Compute::Two(of), &[a, b]) => of(a, b),
            (Compute::Three(of), &[a, b, c]) => of(a, b, c),
            _ => return result,
        };
        match computed {
            Ok(value) => {
                result.value = Some(value).filter(|value| value.is_finite());
                result.view = self.view(&result);
            }
            Err(issue) => {
                let key = match issue {
                    Issue::MinDisparityNotWhole => fields::MIN_DISPARITY,
                    Issue::WrongSubpixelBits => fields::SUBPIXEL_BITS,
                    Issue::NoBaseline if result.readings.first().is_some_and(|stations| stations.value > 0.0) => fields::BASELINE_ANGLE,
                    Issue::NoBaseline => fields::STATIONS,
                    _ => self.asks.first().copied().unwrap_or(self.target),
                };
                result.notes.push(Note::error(key, issue));
            }
        }
        result
    }

    /// The horizontal field of view of the result, where it is a focal length of an image of known width.
    fn view(&self, result: &WayResult) -> Option<Angle> {
        let width = result.readings.iter().find(|reading| reading.key == FRAME_WIDTH)?.value;
        let focal_length = result.value.filter(|_| self.target == FOCAL_LENGTH)?;
        let px = Pixels::new;
        Some(camera::field_of_view(px(focal_length), px(width / 2.0), px(width)))
    }

    /// What [`target`](Self::target) becomes with the result `value`.
    pub fn entry(&self, value: f64) -> Entry {
        let unit = self.target.is_length().then_some(LengthUnit::Meter);
        Entry::new(plain(value), unit)
    }

    /// The result as it is offered: "fx = 937.5 px".
    pub fn result_text(&self, value: f64) -> String {
        let unit = self.target.kind.default_unit().map_or("", |unit| unit.base().symbol());
        format!("{} = {} {unit}", self.target.symbol, significant(value, 6))
    }

    /// What goes into the form beside the result: the lens, where a focal length was computed from one.
    pub fn also(&self, entries: &Entries) -> Option<Also> {
        let has_lens = self.target == FOCAL_LENGTH && self.asks.contains(&LENS);
        has_lens.then(|| (fields::FX_LENS, entries.entry(LENS).clone()))
    }

    /// The way among `ways` that is stored as `key`.
    pub fn named(ways: &'static [Self], key: &str) -> Option<&'static Self> {
        ways.iter().find(|way| way.key == key)
    }
}

/// The ways to a focal length.
pub const FOCAL_LENGTHS: &[Way] = &[
    Way {
        key: "pixel-pitch",
        name: "Lens and pixel size",
        remark: "fx = focal length / pixel pitch. Use the pitch of the image as you have it: twice as large after 2 × 2 binning. Where the lens is focused on the object, its focal length is added to the distance.",
        asks: &[LENS, fields::PIXEL_PITCH],
        target: FOCAL_LENGTH,
        compute: Compute::Two(|lens, pitch| found(camera::focal_length_from_pixel_pitch(Length::from_m(lens), Length::from_m(pitch)))),
    },
    Way {
        key: "sensor-width",
        name: "Lens and sensor width",
        remark: "fx = focal length · image width / sensor width. An inch figure is a name, not a size: choose the format below.",
        asks: &[LENS, fields::SENSOR_WIDTH, FRAME_WIDTH],
        target: FOCAL_LENGTH,
        compute: Compute::Three(|lens, sensor, width| {
            let (lens, sensor) = (Length::from_m(lens), Length::from_m(sensor));
            found(camera::focal_length_from_sensor_width(lens, sensor, Pixels::new(width)))
        }),
    },
    Way {
        key: "horizontal-view",
        name: "Horizontal field of view",
        remark: "fx = (width / 2) / tan(view / 2). A datasheet often gives the view before rectification, which is wider.",
        asks: &[fields::HORIZONTAL_VIEW, FRAME_WIDTH],
        target: FOCAL_LENGTH,
        compute: Compute::Two(|view, width| from_view(view, Pixels::new(width))),
    },
    Way {
        key: "vertical-view",
        name: "Vertical field of view",
        remark: "fy = (height / 2) / tan(view / 2); with square pixels fx is the same.",
        asks: &[fields::VERTICAL_VIEW, FRAME_HEIGHT],
        target: FOCAL_LENGTH,
        compute: Compute::Two(|view, height| from_view(view, Pixels::new(height))),
    },
    Way {
        key: "diagonal-view",
        name: "Diagonal field of view",
        remark: "fx = ½ · √(width² + height²) / tan(view / 2).",
        asks: &[fields::DIAGONAL_VIEW, FRAME_WIDTH, FRAME_HEIGHT],
        target: FOCAL_LENGTH,
        compute: Compute::Three(|view, width, height| from_view(view, camera::diagonal(Pixels::new(width), Pixels::new(height)))),
    },
    Way {
        key: "multiple-of-width",
        name: "Multiple of the image width",
        remark: "fx = multiple · width. Some file formats and programs have the focal length in widths of the image.",
        asks: &[fields::MULTIPLE, FRAME_WIDTH],
        target: FOCAL_LENGTH,
        compute: Compute::Two(|multiple, width| found(camera::focal_length_from_multiple(multiple, Pixels::new(width)))),
    },
    Way {
        key: "multiple-of-half-width",
        name: "Multiple of half the image width",
        remark: "fx = multiple · width / 2: OpenGL’s and Unity’s projection matrix has it in row 1, column 1 (P00).",
        asks: &[fields::MULTIPLE, FRAME_WIDTH],
        target: FOCAL_LENGTH,
        compute: Compute::Two(|multiple, width| found(camera::focal_length_from_multiple(multiple, Pixels::new(width / 2.0)))),
    },
    Way {
        key: "reference-photo",
        name: "One reference photo",
        remark: "fx = width in the image · distance / real width, for something of known width at a measured distance, facing the camera.",
        asks: &[
            fields::REFERENCE_IMAGE_WIDTH,
            fields::REFERENCE_DISTANCE,
            fields::REFERENCE_REAL_WIDTH,
        ],
        target: FOCAL_LENGTH,
        compute: Compute::Three(|width, distance, real| {
            let (distance, real) = (Length::from_m(distance), Length::from_m(real));
            found(camera::focal_length_from_reference_photo(Pixels::new(width), distance, real))
        }),
    },
    Way {
        key: "other-resolution",
        name: "Same camera, other resolution",
        remark: "Resizing scales fx and the disparity, never the baseline. Cropping changes neither: enter the width before the crop.",
        asks: &[fields::KNOWN_FOCAL_LENGTH, fields::WIDTH_BEFORE, fields::WIDTH_AFTER],
        target: FOCAL_LENGTH,
        compute: Compute::Three(|focal_length, before, after| {
            let px = Pixels::new;
            found(camera::resized_focal_length(px(focal_length), px(before), px(after)))
        }),
    },
];

/// The ways to a baseline.
pub const BASELINES: &[Way] = &[Way {
    key: "angle",
    name: "Not square to the line of sight",
    remark: "b = distance · sin(angle), the angle between the line from one camera to the other and the line of sight. 90° changes nothing.",
    asks: &[fields::STATIONS, fields::BASELINE_ANGLE],
    target: BASELINE,
    compute: Compute::Two(|stations, angle| {
        let effective = stereo::effective_baseline(Length::from_m(stations), Angle::from_radians(angle));
        effective.map(Length::m).filter(|b| *b > 0.0).ok_or(Issue::NoBaseline)
    }),
}];

/// The ways to a disparity and to doffs.
pub const DISPARITIES: &[Way] = &[
    Way {
        key: "columns",
        name: "Columns in both images",
        remark: "d = x left − x right, in the rectified images.",
        asks: &[fields::LEFT_COLUMN, fields::RIGHT_COLUMN],
        target: DISPARITY,
        compute: Compute::Two(|left, right| {
            Ok(
                disparity::from_columns(Measured::from_base(left, 0.0), Measured::from_base(right, 0.0))
                    .value
                    .px(),
            )
        }),
    },
    Way {
        key: "opencv",
        name: "OpenCV StereoBM or StereoSGBM",
        remark: "They store sixteenths of a pixel in 16-bit numbers; (minDisparity − 1) · 16 means that nothing was found.",
        asks: &[STORED_VALUE, fields::MIN_DISPARITY],
        target: DISPARITY,
        compute: Compute::Two(|stored, min_disparity| {
            if min_disparity.fract() != 0.0 || min_disparity.abs() > 30_000.0 {
                return Err(Issue::MinDisparityNotWhole);
            }
            #[expect(clippy::cast_possible_truncation, reason = "checked to be whole and small")]
            let min_disparity = min_disparity as i32;
            decoded(Encoding::OpenCv { min_disparity }, stored)
        }),
    },
    Way {
        key: "kitti",
        name: "KITTI, 16-bit image",
        remark: "It stores 256ths of a pixel; 0 means that there is none.",
        asks: &[STORED_VALUE],
        target: DISPARITY,
        compute: Compute::One(|stored| decoded(Encoding::Kitti, stored)),
    },
    Way {
        key: "depthai",
        name: "DepthAI, sub-pixel",
        remark: "With 3, 4 or 5 sub-pixel bits it stores 8ths, 16ths or 32nds of a pixel.",
        asks: &[STORED_VALUE, fields::SUBPIXEL_BITS],
        target: DISPARITY,
        compute: Compute::Two(|stored, bits| {
            let bits = match bits {
                3.0 => SubpixelBits::Three,
                4.0 => SubpixelBits::Four,
                5.0 => SubpixelBits::Five,
                _ => return Err(Issue::WrongSubpixelBits),
            };
            decoded(Encoding::DepthAi(bits), stored)
        }),
    },
    Way {
        key: "fraction",
        name: "Fraction of the image width",
        remark: "Some networks give the disparity as a part of the width of the image.",
        asks: &[fields::FRACTION, FRAME_WIDTH],
        target: DISPARITY,
        compute: Compute::Two(|fraction, width| {
            let image_width = Pixels::new(width);
            decoded(Encoding::FractionOfWidth { image_width }, fraction)
        }),
    },
    Way {
        key: "zed",
        name: "ZED, negative sign",
        remark: "The ZED SDK gives disparities with the opposite sign.",
        asks: &[fields::ZED_DISPARITY],
        target: DISPARITY,
        compute: Compute::One(|stored| decoded(Encoding::Zed, stored)),
    },
    Way {
        key: "principal-points",
        name: "doffs from both principal points",
        remark: "doffs = cx right − cx left. Stereo then reads D = fx · b / (d + doffs). Zero for most rectified pairs.",
        asks: &[fields::LEFT_CX, fields::RIGHT_CX],
        target: DOFFS,
        compute: Compute::Two(|left, right| {
            Ok(disparity::doffs(Measured::from_base(left, 0.0), Measured::from_base(right, 0.0))
                .value
                .px())
        }),
    },
    Way {
        key: "doffs",
        name: "doffs as a calibration file gives it",
        remark: "Middlebury's calib.txt has it by this name.",
        asks: &[fields::FILE_DOFFS],
        target: DOFFS,
        compute: Compute::One(Ok),
    },
];

/// Whether a field of view is so small that its number is an angle in radians: below π, a telescope's in degrees.
fn may_be_radians(reading: &Reading) -> bool {
    let is_view = [fields::HORIZONTAL_VIEW, fields::VERTICAL_VIEW, fields::DIAGONAL_VIEW].contains(&reading.key);
    is_view && !reading.unit_was_typed && (0.0..PI).contains(&reading.number) && reading.number > 0.0
}

/// Asks which of the two it is.
fn degrees_or_radians(reading: &Reading) -> Note {
    let number = reading.number_text.clone();
    let fixes = [" rad", "°"].map(|unit| {
        let value = format!("{number}{unit}");
        Fix::new(value.clone(), Entry::new(value, None))
    });
    Note::error(reading.key, Issue::DegreesOrRadians { number }).with_fixes(fixes.into())
}

fn from_view(view: f64, extent: Pixels) -> Result<f64, Issue> {
    found(camera::focal_length_from_field_of_view(Angle::from_radians(view), extent))
}

fn found(focal_length: Option<Pixels>) -> Result<f64, Issue> {
    focal_length.map(Pixels::px).ok_or(Issue::NoFocalLength)
}

fn decoded(encoding: Encoding, stored: f64) -> Result<f64, Issue> {
    let disparity = encoding.decode(stored).map(Pixels::px);
    disparity.map_err(|reason| Issue::NotADisparity { reason })
}
