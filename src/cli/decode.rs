//! `decode`: what a number that a picture or a network stores for a pixel says of the distance.

use super::camera_facts::{Quantity, optional};
use super::reply::Reply;
use super::warning::Warning;
use crate::core::disparity::{Encoding, KINECT_V1_BASELINE, KINECT_V1_FOCAL_LENGTH, Linear, NoDisparity, SubpixelBits};
use crate::core::quantity::{Length, Pixels};
use crate::core::stereo;
use crate::core::stored::DepthEncoding;
use clap::{Args, ValueEnum};
use depth_text::number::{Notation, TYPED_DIGITS};
use serde::Serialize;

/// What was given to `decode`.
#[derive(Debug, Args)]
pub(super) struct Decode {
    /// The number that is stored, or R,G,B of three channels
    #[arg(value_name = "RAW", allow_hyphen_values = true)]
    raw: String,
    /// How it is stored
    #[arg(long = "as", value_name = "NAME", required_unless_present = "divide", conflicts_with_all = ["divide", "offset", "invalid"])]
    name: Option<Name>,
    /// Of another encoding: the stored steps in a pixel, negative where less is stored for what is nearer
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    divide: Option<f64>,
    /// And what is stored for a disparity of 0
    #[arg(
        long,
        value_name = "NUMBER",
        allow_hyphen_values = true,
        requires = "divide",
        default_value_t = 0.0
    )]
    offset: f64,
    /// And what is stored where there is no disparity
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true, requires = "divide")]
    invalid: Option<f64>,
    /// Focal length in pixels, of the image that the number is of
    #[arg(long, value_name = "PX")]
    fx: Option<String>,
    /// Baseline, such as 100mm or 0.1m; without a unit in millimeters
    #[arg(long, value_name = "LENGTH")]
    baseline: Option<String>,
    /// Width of the image in pixels, of a fraction of which the disparity is
    #[arg(long, value_name = "PX")]
    width: Option<String>,
    /// The matcher's minDisparity, of opencv
    #[arg(long, value_name = "PX", allow_hyphen_values = true, default_value_t = 0)]
    min_disparity: i32,
    /// The near plane, of inverse-depth
    #[arg(long, value_name = "NUMBER", default_value_t = 0.1)]
    near: f64,
    /// The far plane, of inverse-depth
    #[arg(long, value_name = "NUMBER", default_value_t = 100.0)]
    far: f64,
    /// Meters in the unit of inverse-depth, such as 5.4 for monodepth2's stereo models of KITTI
    #[arg(long, value_name = "NUMBER", default_value_t = 1.0)]
    scale: f64,
    /// Answer in JSON: lengths in meters, null for what is unknown
    #[arg(long)]
    json: bool,
}

/// The encodings that have a name.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Name {
    /// StereoBM, StereoSGBM: sixteenths of a pixel
    Opencv,
    /// KITTI disparity: p/256
    Kitti,
    /// Cityscapes: (p - 1)/256
    Cityscapes,
    /// RealSense D400 disparity: p/32
    Realsense,
    /// DepthAI with 3 sub-pixel bits: p/8
    Depthai3,
    /// DepthAI with 4: p/16
    Depthai4,
    /// DepthAI with 5: p/32
    Depthai5,
    /// Ensenso: p/16
    Ensenso,
    /// The first Kinect: (1090 - p)/8, with 580 px and 75 mm
    Kinect1,
    /// ZED: the opposite sign
    Zed,
    /// A fraction of the image's width
    Fraction,
    /// A network's inverse depth between two planes
    InverseDepth,
    /// Depth in millimeters: RealSense, `ScanNet`
    DepthMm,
    /// Depth of TUM RGB-D: p/5000
    Tum,
    /// Depth of KITTI: p/256
    KittiDepth,
    /// Depth of Virtual KITTI, in centimeters
    Vkitti,
    /// Depth in three channels of CARLA
    Carla,
    /// Depth Anything 3, metric: f·p/300
    Da3Metric,
    /// Metric3D: p·f/1000
    Metric3d,
}

/// A way to store a disparity, or a depth.
enum Way {
    Disparity(Encoding),
    Depth(DepthEncoding),
}

#[derive(Serialize)]
struct Answer {
    disparity_px: Option<f64>,
    distance_m: Option<f64>,
    no_match: bool,
    warnings: Vec<Warning>,
    /// Whether a focal length and a baseline are known.
    #[serde(skip)]
    has_camera: bool,
}

impl Decode {
    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        let given = Given {
            focal_length: optional("fx", self.fx.as_deref(), Quantity::Pixels)?.map(Pixels::new),
            baseline: optional("baseline", self.baseline.as_deref(), Quantity::Millimeters)?.map(Length::from_m),
            width: optional("width", self.width.as_deref(), Quantity::Pixels)?.map(Pixels::new),
        };
        let way = self.way(&given)?;
        let raw = self.raw()?;
        let mut answer = given.answer(&way, raw).or_else(|reason| self.without(reason))?;
        let eight_bits = self.eight_bits(raw, &answer);
        answer.warnings.extend(eight_bits.as_ref().map(Warning::of_results));
        answer.warnings.extend(given.unusual_baseline());
        if self.json {
            return Reply::json(&answer);
        }
        Ok(Reply {
            text: answer.lines(),
            warnings: answer.warnings.iter().map(Warning::to_string).collect(),
        })
    }

    fn way(&self, given: &Given) -> Result<Way, String> {
        let needs = |value: Option<Pixels>, option: &str| value.ok_or_else(|| format!("{} needs --{option}.", self.called()));
        let steps = |per_meter| Way::Depth(DepthEncoding::Steps { per_meter });
        let depth_ai = |bits| Way::Disparity(Encoding::DepthAi(bits));
        let Some(name) = self.name else { return self.linear() };
        Ok(match name {
            Name::Opencv => Way::Disparity(Encoding::OpenCv {
                min_disparity: self.min_disparity,
            }),
            Name::Kitti => Way::Disparity(Encoding::Kitti),
            Name::Cityscapes => Way::Disparity(Encoding::Cityscapes),
            Name::Realsense => Way::Disparity(Encoding::RealSense),
            Name::Depthai3 => depth_ai(SubpixelBits::Three),
            Name::Depthai4 => depth_ai(SubpixelBits::Four),
            Name::Depthai5 => depth_ai(SubpixelBits::Five),
            Name::Ensenso => Way::Disparity(Encoding::Ensenso),
            Name::Kinect1 => Way::Disparity(Encoding::KinectV1),
            Name::Zed => Way::Disparity(Encoding::Zed),
            Name::Fraction => Way::Disparity(Encoding::FractionOfWidth {
                image_width: needs(given.width, "width")?,
            }),
            Name::InverseDepth => self.inverse()?,
            Name::DepthMm => steps(1000.0),
            Name::Tum => steps(5000.0),
            Name::KittiDepth => steps(256.0),
            Name::Vkitti => steps(100.0),
            Name::Carla => Way::Depth(DepthEncoding::ThreeChannels),
            Name::Da3Metric => Way::Depth(DepthEncoding::DepthAnything3 {
                focal_length: needs(given.focal_length, "fx")?,
            }),
            Name::Metric3d => Way::Depth(DepthEncoding::Metric3D {
                focal_length: needs(given.focal_length, "fx")?,
            }),
        })
    }

    fn linear(&self) -> Result<Way, String> {
        let factor = self.divide.unwrap_or(1.0);
        if factor == 0.0 || !factor.is_finite() || !self.offset.is_finite() {
            return Err("--divide is how many steps a pixel has: it cannot be 0, and like --offset it is a number.".to_owned());
        }
        let (offset, no_match) = (self.offset, self.invalid);
        Ok(Way::Disparity(Encoding::Linear(Linear { factor, offset, no_match })))
    }

    fn inverse(&self) -> Result<Way, String> {
        let is_right = self.near > 0.0 && self.far > self.near && self.far.is_finite() && self.scale > 0.0 && self.scale.is_finite();
        if !is_right {
            return Err("--near and --far are distances above 0, the far one the larger, and --scale is above 0.".to_owned());
        }
        let (near, far, scale) = (self.near, self.far, self.scale);
        Ok(Way::Depth(DepthEncoding::Inverse { near, far, scale }))
    }

    /// The stored number; of three channels R + 256·G + 65 536·B.
    fn raw(&self) -> Result<f64, String> {
        if self.name != Some(Name::Carla) {
            let text = self.raw.trim().replace('\u{2212}', "-");
            let hexadecimal = text.strip_prefix("0x").and_then(|digits| u32::from_str_radix(digits, 16).ok());
            let number = hexadecimal.map_or_else(|| text.parse::<f64>(), |number| Ok(f64::from(number)));
            return number.map_err(|_| format!("“{}” is no number that a file can store: give one, such as 12345.", self.raw));
        }
        let channels: Vec<Option<u8>> = self.raw.split(',').map(|channel| channel.trim().parse().ok()).collect();
        match *channels {
            [Some(red), Some(green), Some(blue)] => Ok(f64::from(red) + 256.0 * f64::from(green) + 65_536.0 * f64::from(blue)),
            _ => Err("carla needs three numbers from 0 to 255, red, green and blue, such as 100,20,1.".to_owned()),
        }
    }

    /// The answer where a number is none of the encoding.
    fn without(&self, reason: NoDisparity) -> Result<Answer, String> {
        match reason {
            NoDisparity::Invalid => Ok(Answer {
                disparity_px: None,
                distance_m: None,
                no_match: true,
                warnings: Vec::new(),
                has_camera: false,
            }),
            NoDisparity::NotWhole => Err(format!(
                "{} stores whole numbers, and {} is none: it may have been divided already.",
                self.called(),
                self.raw
            )),
            NoDisparity::OutOfRange => Err(format!("{} cannot be stored as {}.", self.raw, self.called())),
        }
    }

    /// That a file with 16 bits may have been read with 8.
    fn eight_bits(&self, raw: f64, answer: &Answer) -> Option<String> {
        let has_16_bits = matches!(
            self.name,
            Some(Name::Kitti | Name::Cityscapes | Name::DepthMm | Name::Tum | Name::KittiDepth | Name::Vkitti)
        );
        (has_16_bits && raw > 0.0 && raw <= 255.0 && !answer.no_match).then(|| {
            format!(
                "{raw} is small for 16 bits. If no pixel has more than 255, the file was read with 8 bits: read it with IMREAD_UNCHANGED in OpenCV."
            )
        })
    }

    fn called(&self) -> String {
        let value = self.name.and_then(|name| name.to_possible_value());
        value.map_or_else(|| "it".to_owned(), |value| value.get_name().to_owned())
    }
}

/// What is known of the camera.
struct Given {
    focal_length: Option<Pixels>,
    baseline: Option<Length>,
    width: Option<Pixels>,
}

impl Given {
    /// That meters may have been taken for millimeters, or the other way round.
    fn unusual_baseline(&self) -> Option<Warning> {
        let baseline = self.baseline.filter(|baseline| !(0.005..=5.0).contains(&baseline.m()))?;
        let said = format!(
            "{} mm is unusual for the baseline: most lie between 5 mm and 5 m. Say its unit, such as 0.54m.",
            Notation::LONG.plain(baseline.m() * 1000.0, TYPED_DIGITS)
        );
        Some(Warning::of_option("baseline", &said))
    }

    fn answer(&self, way: &Way, raw: f64) -> Result<Answer, NoDisparity> {
        let is_kinect = matches!(way, Way::Disparity(Encoding::KinectV1));
        let focal_length = self.focal_length.or(is_kinect.then_some(KINECT_V1_FOCAL_LENGTH));
        let baseline = self.baseline.or(is_kinect.then_some(KINECT_V1_BASELINE));
        let camera = focal_length.zip(baseline);
        let (disparity, distance) = match way {
            Way::Disparity(encoding) => {
                let disparity = encoding.decode(raw)?;
                let seen = camera.filter(|_| disparity.px() > 0.0);
                let distance = seen.map(|(f, b)| stereo::depth(f, b, disparity));
                (Some(disparity), distance.map(finite).transpose()?)
            }
            Way::Depth(encoding) => {
                let distance = encoding.decode(raw)?;
                let seen = camera.filter(|_| distance.m() > 0.0);
                (seen.map(|(f, b)| stereo::disparity(f, b, distance)), Some(distance))
            }
        };
        let warnings = disparity.filter(|disparity| disparity.px() <= 0.0).map(|_| {
            Warning::of_results(&"A disparity of 0 or less is no distance: the cameras may be swapped, or doffs has to be added.")
        });
        Ok(Answer {
            disparity_px: disparity.map(Pixels::px),
            distance_m: distance.map(Length::m),
            no_match: false,
            warnings: warnings.into_iter().collect(),
            has_camera: camera.is_some(),
        })
    }
}

/// What can be written down.
fn finite(distance: Length) -> Result<Length, NoDisparity> {
    if distance.m().is_finite() && distance.m() > 0.0 {
        Ok(distance)
    } else {
        Err(NoDisparity::OutOfRange)
    }
}

impl Answer {
    fn lines(&self) -> String {
        if self.no_match {
            return "no match: the pixel has no disparity and no depth\n".to_owned();
        }
        let number = |value: f64| Notation::LONG.plain(value, TYPED_DIGITS);
        let mut text = String::new();
        if let Some(disparity) = self.disparity_px {
            text.push_str(&format!("disparity {} px\n", number(disparity)));
        }
        match self.distance_m {
            Some(distance) => text.push_str(&format!("distance {} m\n", number(distance))),
            None if self.has_camera => text.push_str("distance: none\n"),
            None => text.push_str("distance: needs --fx and --baseline\n"),
        }
        text
    }
}
