//! `camera`: what data sheets, photographers and simulators say of a camera, as its focal length in pixels, and all the others from it.

use super::camera_facts::{FactKind, Quantity, number, optional, read};
use super::reply::Reply;
use super::warning::Warning;
use crate::core::angle::Angle;
use crate::core::camera::{CameraFacts, Projection, Sensor};
use crate::core::quantity::{Length, Pixels};
use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};
use depth_text::sentences::CameraWords;
use serde::Serialize;

/// What was given to `camera`.
#[derive(Debug)]
pub(super) struct Camera {
    width: String,
    height: String,
    /// The facts as they were typed, in their order.
    facts: Vec<(FactKind, String)>,
    pitch: Option<String>,
    /// Width, height and diagonal of the sensor.
    sensor: [Option<String>; 3],
    focused_at: Option<String>,
    projection: Projection,
    is_under_water: bool,
    json: bool,
}

/// The options of the sensor.
const SENSOR: [&str; 3] = ["sensor-width", "sensor-height", "sensor-diagonal"];

impl Args for Camera {
    fn augment_args(command: Command) -> Command {
        let text = |name: &'static str, value: &'static str, help: &'static str| Arg::new(name).long(name).value_name(value).help(help);
        let facts = FactKind::ALL.map(|kind| text(kind.option(), kind.value_name(), kind.help()).help_heading("What is known"));
        let flag = |name: &'static str, help: &'static str| Arg::new(name).long(name).action(ArgAction::SetTrue).help(help);
        let models = PossibleValuesParser::new(Projection::ALL.map(Projection::name));
        command
            .args([
                text("width", "PX", "Columns of the image").required(true),
                text("height", "PX", "Rows of the image").required(true),
            ])
            .args(facts)
            .args([
                text(
                    "pixel-pitch",
                    "LENGTH",
                    "Size of a pixel on the sensor, such as 3um; bare: in micrometers",
                ),
                text(SENSOR[0], "LENGTH", "Width of the sensor; bare: in mm"),
                text(SENSOR[1], "LENGTH", "Height of the sensor; bare: in mm"),
                text(SENSOR[2], "LENGTH", "Diagonal of the sensor; bare: in mm"),
                text("focused-at", "LENGTH", "At which distance the lens is in focus; bare: in m").requires(FactKind::Lens.option()),
                text("model", "WHICH", "How the lens projects: a pinhole, or a fisheye")
                    .value_parser(models)
                    .default_value("pinhole"),
                flag(
                    "water",
                    "The camera is under water, behind a flat window, and what is stated holds in air",
                ),
                flag("json", "Answer in JSON: null for what cannot be known"),
            ])
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Camera {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let text = |name: &str| matches.get_one::<String>(name).cloned();
        let mut facts: Vec<(usize, FactKind, String)> = FactKind::ALL
            .into_iter()
            .filter_map(|kind| Some((matches.index_of(kind.option())?, kind, text(kind.option())?)))
            .collect();
        facts.sort_unstable_by_key(|(at, _, _)| *at);
        let model = text("model").unwrap_or_default();
        Ok(Self {
            width: text("width").unwrap_or_default(),
            height: text("height").unwrap_or_default(),
            facts: facts.into_iter().map(|(_, kind, text)| (kind, text)).collect(),
            pitch: text("pixel-pitch"),
            sensor: SENSOR.map(text),
            focused_at: text("focused-at"),
            projection: Projection::ALL.into_iter().find(|one| one.name() == model).unwrap_or_default(),
            is_under_water: matches.get_flag("water"),
            json: matches.get_flag("json"),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

#[derive(Serialize)]
struct Answer {
    fx_px: f64,
    fy_px: f64,
    lens_mm: Option<f64>,
    hfov_deg: Option<f64>,
    vfov_deg: Option<f64>,
    dfov_deg: Option<f64>,
    f35_diagonal_mm: Option<f64>,
    f35_width_mm: Option<f64>,
    warnings: Vec<Warning>,
}

impl Camera {
    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        let answer = self.answer()?;
        if self.json {
            return Reply::json(&answer);
        }
        Ok(Reply {
            text: answer.lines(self.projection),
            warnings: answer.warnings.iter().map(Warning::to_string).collect(),
        })
    }

    fn answer(&self) -> Result<Answer, String> {
        let mut warnings = Vec::new();
        let facts = self.facts(&mut warnings)?;
        let option = |at: usize| self.facts.get(at).map_or("", |(kind, _)| kind.option());
        let stated = |at: usize| format!("--{} {}", option(at), self.facts.get(at).map_or("", |(_, text)| text));
        let called = |at: usize| format!("--{}", option(at));
        let words = CameraWords {
            stated: &stated,
            called: &called,
            pitch: "--pixel-pitch",
            sensor: "--pixel-pitch, or --sensor-width, --sensor-height or --sensor-diagonal",
            focus: "--focused-at",
            diagonal: "--sensor-diagonal",
            projection: "With --model",
            dry: "leave out --water",
            facts: "--fx, --hfov, --vfov, --dfov, --lens with the sensor or its pixels, or --f35",
        };
        let answer = facts.solve().map_err(|problem| words.problem(problem, self.projection.name()))?;
        warnings.extend(answer.remarks.iter().map(|remark| Warning::of_results(&words.remark(remark))));
        let millimeters = |length: Option<Length>| length.map(|length| length.m() * 1000.0);
        let [hfov_deg, vfov_deg, dfov_deg] = answer.views.map(|view| view.map(Angle::degrees));
        let [f35_diagonal_mm, f35_width_mm] = answer.film.map(millimeters);
        Ok(Answer {
            fx_px: answer.fx.px(),
            fy_px: answer.fy.px(),
            lens_mm: millimeters(answer.lens),
            hfov_deg,
            vfov_deg,
            dfov_deg,
            f35_diagonal_mm,
            f35_width_mm,
            warnings,
        })
    }

    /// What was stated, with what is to be said of single options.
    fn facts(&self, warnings: &mut Vec<Warning>) -> Result<CameraFacts, String> {
        let pixels = |name, text| read(name, text, Quantity::Pixels).map(Pixels::new);
        let size = [pixels("width", &self.width)?, pixels("height", &self.height)?];
        let [width, height, diagonal] = &self.sensor;
        let length =
            |option, text: &Option<String>, quantity| Ok::<_, String>(optional(option, text.as_deref(), quantity)?.map(Length::from_m));
        let sensor = Sensor {
            pitch: length("pixel-pitch", &self.pitch, Quantity::Micrometers)?,
            width: length(SENSOR[0], width, Quantity::Millimeters)?,
            height: length(SENSOR[1], height, Quantity::Millimeters)?,
            diagonal: length(SENSOR[2], diagonal, Quantity::Millimeters)?,
        };
        let focused_at = length("focused-at", &self.focused_at, Quantity::Meters)?;
        let mut facts = Vec::new();
        for (kind, text) in &self.facts {
            facts.push(kind.read(text)?);
            warnings.extend(kind.radians(text).map(|said| Warning::of_option(kind.option(), &said)));
        }
        Ok(CameraFacts {
            size,
            facts,
            sensor,
            focused_at,
            projection: self.projection,
            is_under_water: self.is_under_water,
        })
    }
}

impl Answer {
    fn lines(&self, projection: Projection) -> String {
        let mut text = format!("fx {} px\nfy {} px\n", number(self.fx_px), number(self.fy_px));
        let rows = [
            ("lens", self.lens_mm, "mm"),
            ("horizontal view", self.hfov_deg, "deg"),
            ("vertical view", self.vfov_deg, "deg"),
            ("diagonal view", self.dfov_deg, "deg"),
            ("35 mm equivalent by the diagonal", self.f35_diagonal_mm, "mm"),
            ("35 mm equivalent by the width", self.f35_width_mm, "mm"),
        ];
        for (name, value, unit) in rows {
            if let Some(value) = value {
                text.push_str(&format!("{name} {} {unit}\n", number(value)));
            }
        }
        if projection != Projection::Pinhole {
            text.push_str(&format!("model {}\n", projection.name()));
        }
        text
    }
}
