//! `decode`: what a number that a picture or a network stores for a pixel says of the distance.

use super::ascii::in_sentence;
use super::camera_facts::{Quantity, optional};
use super::reply::Reply;
use super::warning::Warning;
use crate::core::disparity::NoDisparity;
use crate::core::problem::{Field, Problem};
use crate::core::quantity::{Length, Pixels};
use clap::builder::{PossibleValue, PossibleValuesParser};
use clap::{ArgAction, Args};
use depth_text::field::Key;
use depth_text::fields;
use depth_text::number::{Notation, TYPED_DIGITS};
use depth_text::ways::{DISPARITIES, Decoded, ENCODING_NAMES, EncodingName, NotStored, Stored, Way};
use serde::Serialize;

/// What was given to `decode`.
#[derive(Debug, Args)]
pub(super) struct Decode {
    /// The number that is stored, or R,G,B of three channels
    #[arg(value_name = "RAW", allow_hyphen_values = true)]
    raw: String,
    /// How it is stored
    #[arg(
        long = "as",
        value_name = "NAME",
        value_parser = names(),
        ignore_case = true,
        required_unless_present = "divide",
        conflicts_with_all = ["divide", "offset", "invalid"]
    )]
    name: Option<String>,
    /// Of another encoding: the stored steps in a pixel, negative where less is stored for what is nearer
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true)]
    divide: Option<f64>,
    /// And what is stored for a disparity of 0, if not 0
    #[arg(long, value_name = "NUMBER", allow_hyphen_values = true, requires = "divide")]
    offset: Option<f64>,
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
    /// The matcher's minDisparity, of opencv; without it 0
    #[arg(long, value_name = "PX", allow_hyphen_values = true)]
    min_disparity: Option<i32>,
    /// The stored steps in a meter, of depth
    #[arg(long, value_name = "NUMBER")]
    per_meter: Option<f64>,
    /// The near plane, of inverse-depth; without it 0.1
    #[arg(long, value_name = "NUMBER")]
    near: Option<f64>,
    /// The far plane, of inverse-depth; without it 100
    #[arg(long, value_name = "NUMBER")]
    far: Option<f64>,
    /// Meters in the unit of inverse-depth, such as 5.4 for monodepth2's stereo models of KITTI; without it 1
    #[arg(long, value_name = "NUMBER")]
    scale: Option<f64>,
    /// Answer in JSON: lengths in meters, null for what is unknown
    #[arg(long, action = ArgAction::SetTrue)]
    json: bool,
}

/// A field of a way, its option and what was given there.
type FieldOption = (Key, &'static str, Option<f64>);

/// The names of the table, with their help.
fn names() -> PossibleValuesParser {
    let named = |one: &EncodingName| PossibleValue::new(one.name).help(one.help);
    PossibleValuesParser::new(ENCODING_NAMES.iter().map(named))
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
        let name = self.name.as_deref().and_then(EncodingName::called);
        let way = name.map_or_else(|| Way::named(DISPARITIES, "linear"), EncodingName::way);
        let way = way.ok_or_else(|| format!("{} cannot be decoded.", self.called()))?;
        let fixed = name.and_then(|name| name.fixed);
        let options = self.options()?;
        let is_used = |key: Key| way.asks.contains(&key) && fixed.is_none_or(|(fixed, _)| fixed != key);
        if let Some((_, option, _)) = options.iter().find(|(key, _, value)| value.is_some() && !is_used(*key)) {
            return Err(format!("{} has no use for --{option}: leave it out.", self.called()));
        }
        let given = Given {
            focal_length: optional("fx", self.fx.as_deref(), Quantity::Pixels)?.map(Pixels::new),
            baseline: optional("baseline", self.baseline.as_deref(), Quantity::Millimeters)?.map(Length::from_m),
        };
        let typed = options.iter().filter_map(|(key, _, value)| Some((*key, (*value)?)));
        // In the order in which they count.
        let mut values: Vec<(Key, f64)> = fixed.into_iter().chain(self.raw(way)?).chain(typed).collect();
        values.extend(given.focal_length.map(|focal_length| (fields::FOCAL_LENGTH, focal_length.px())));
        values.push((fields::MIN_DISPARITY, 0.0));
        let of = |key: Key| values.iter().find(|(of, _)| *of == key).map(|(_, value)| *value);
        let stored = way.stored(&of).map_err(|reason| self.said(reason, &options))?;
        let number = way.number(&of).map_err(|reason| self.said(reason, &options))?;
        let mut answer = given.answer(stored, number).or_else(|reason| self.without(reason))?;
        let eight_bits = stored.eight_bits(number).filter(|_| !answer.no_match);
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

    /// The options for the fields of the ways, but for the focal length, which is of use to each.
    fn options(&self) -> Result<[FieldOption; 9], String> {
        Ok([
            (fields::STEPS_PER_PIXEL, "divide", self.divide),
            (fields::STORED_OFFSET, "offset", self.offset),
            (fields::NO_MATCH, "invalid", self.invalid),
            (
                fields::FRAME_WIDTH,
                "width",
                optional("width", self.width.as_deref(), Quantity::Pixels)?,
            ),
            (fields::MIN_DISPARITY, "min-disparity", self.min_disparity.map(f64::from)),
            (fields::STEPS_PER_METER, "per-meter", self.per_meter),
            (fields::NEAR_PLANE, "near", self.near),
            (fields::FAR_PLANE, "far", self.far),
            (fields::NETWORK_SCALE, "scale", self.scale),
        ])
    }

    /// The stored number, in the first field of `way`; of three channels each in its own.
    fn raw(&self, way: &Way) -> Result<Vec<(Key, f64)>, String> {
        let [red, green, blue] = [fields::RED, fields::GREEN, fields::BLUE];
        if way.asks != [red, green, blue] {
            let text = self.raw.trim().replace('\u{2212}', "-");
            let hexadecimal = text.strip_prefix("0x").and_then(|digits| u32::from_str_radix(digits, 16).ok());
            let number = hexadecimal.map_or_else(|| text.parse::<f64>(), |number| Ok(f64::from(number)));
            let number = number.map_err(|_| format!("“{}” is no number that a file can store: give one, such as 12345.", self.raw))?;
            return Ok(way.asks.first().map(|&key| (key, number)).into_iter().collect());
        }
        let channels: Vec<Option<u8>> = self.raw.split(',').map(|channel| channel.trim().parse().ok()).collect();
        match *channels {
            [Some(of_red), Some(of_green), Some(of_blue)] => Ok([(red, of_red), (green, of_green), (blue, of_blue)]
                .map(|(key, value)| (key, f64::from(value)))
                .into()),
            _ => Err("carla needs three numbers from 0 to 255, red, green and blue, such as 100,20,1.".to_owned()),
        }
    }

    /// Why it is not known what is stored, at the option that says it.
    fn said(&self, reason: NotStored, options: &[FieldOption]) -> String {
        let option = |key: Key| options.iter().find(|(of, ..)| *of == key).map_or("fx", |(_, option, _)| option);
        match reason {
            NotStored::Missing(key) => format!("{} needs --{}.", self.called(), option(key)),
            NotStored::Wrong(note) => format!("--{}: {}", option(note.key), in_sentence(&note.message())),
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

    /// What the number is stored as: the name of the table, or what stands for any other.
    fn called(&self) -> &str {
        let name = self.name.as_deref();
        let known = name.and_then(EncodingName::called).map(|known| known.name);
        known.or(name).unwrap_or("--divide")
    }
}

/// What is known of the camera.
struct Given {
    focal_length: Option<Pixels>,
    baseline: Option<Length>,
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

    fn answer(&self, stored: Stored, number: f64) -> Result<Answer, NoDisparity> {
        let own = stored.own_camera();
        let focal_length = self.focal_length.or(own.map(|(focal_length, _)| focal_length));
        let baseline = self.baseline.or(own.map(|(_, baseline)| baseline));
        let mut cameras = Problem::default();
        cameras.set(Field::FocalLength, focal_length.map(Pixels::px));
        cameras.set(Field::Baseline, baseline.map(Length::m));
        let has_camera = focal_length.is_some() && baseline.is_some();
        let Decoded { disparity, distance } = stored.decode(number, &cameras)?;
        let is_behind = disparity.is_some_and(|disparity| disparity.px() <= 0.0);
        if has_camera && !is_behind && (disparity.is_none() || distance.is_none()) {
            return Err(NoDisparity::OutOfRange);
        }
        let warnings = is_behind.then(|| {
            Warning::of_results(&match disparity {
                Some(disparity) if disparity.px() == 0.0 => "A disparity of 0 is infinitely far away, unless doffs has to be added.",
                _ => "A disparity below 0 is no distance: the cameras may be swapped, or doffs has to be added.",
            })
        });
        Ok(Answer {
            disparity_px: disparity.map(Pixels::px),
            distance_m: distance.map(Length::m),
            no_match: false,
            warnings: warnings.into_iter().collect(),
            has_camera,
        })
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
