//! `camera`: what data sheets, photographers and simulators say of a camera, as its focal length in pixels, and all the others from it.

use super::camera_facts::{Fact, FactKind, Quantity, TOLERANCE, number, optional, read};
use super::reply::Reply;
use super::warning::Warning;
use crate::core::angle::Angle;
use crate::core::camera::{FilmExtent, Projection, focal_length_under_water, focused_lens};
use crate::core::quantity::{Length, Pixels};
use clap::builder::PossibleValuesParser;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches};
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
        let size =
            [("width", &self.width), ("height", &self.height)].map(|(name, text)| read(name, text, Quantity::Pixels).map(Pixels::new));
        let [width, height] = size;
        let size = [width?, height?];
        let pitch = self.pitch(size, &mut warnings)?;
        let focused_at = optional("focused-at", self.focused_at.as_deref(), Quantity::Meters)?.map(Length::from_m);
        let mut facts = Vec::new();
        for (kind, text) in &self.facts {
            let fact = Fact::read(*kind, text, self.projection)?;
            warnings.extend(fact.radians().map(|said| Warning::of_option(kind.option(), &said)));
            facts.push(fact.focal_length(size, (pitch, focused_at))?);
        }
        let Some(([fx, fy], said)) = Fact::focal_lengths(&facts) else {
            return Err(
                "Nothing says the focal length: add --fx, --hfov, --vfov, --dfov, --lens with the sensor or its pixels, or --f35."
                    .to_owned(),
            );
        };
        warnings.extend(said.iter().map(Warning::of_results));
        let widest = facts.iter().filter_map(|fact| fact.view).map(Angle::degrees).fold(0.0, f64::max);
        if self.projection == Projection::Pinhole && widest > MOST_OF_A_PINHOLE {
            warnings.push(Warning::of_results(&self.as_fisheye(size, widest)));
        }
        let lens = pitch.map(|pitch| Length::from_m(fx.px() * pitch.m()));
        let lens = lens.and_then(|image| focused_at.map_or(Some(image), |distance| focused_lens(image, distance)));
        let film = |extent: FilmExtent| {
            let is_pinhole = self.projection == Projection::Pinhole;
            extent.equivalent(fx, size).filter(|_| is_pinhole).map(|length| length.m() * 1000.0)
        };
        let (f35_diagonal_mm, f35_width_mm) = (film(FilmExtent::Diagonal), film(FilmExtent::Width));
        let [fx, fy] = if self.is_under_water {
            warnings.push(Warning::of_results(&UNDER_WATER));
            [fx, fy].map(|f| focal_length_under_water(f).unwrap_or(f))
        } else {
            [fx, fy]
        };
        let [hfov_deg, vfov_deg, dfov_deg] = self.views([fx, fy], size);
        Ok(Answer {
            fx_px: fx.px(),
            fy_px: fy.px(),
            lens_mm: lens.map(|lens| lens.m() * 1000.0),
            hfov_deg,
            vfov_deg,
            dfov_deg,
            f35_diagonal_mm,
            f35_width_mm,
            warnings,
        })
    }

    /// Horizontal, vertical and diagonal view, in degrees.
    fn views(&self, [fx, fy]: [Pixels; 2], [width, height]: [Pixels; 2]) -> [Option<f64>; 3] {
        let [across, down] = [width.px() / fx.px(), height.px() / fy.px()];
        [across, down, across.hypot(down)].map(|extent| {
            // In focal lengths.
            let view = self.projection.view(Pixels::new(1.0), Pixels::new(extent));
            view.map(Angle::degrees)
        })
    }

    /// The size of a pixel: the stated one, or that of the sensor. Where rows or columns were cut, its own side has more pixels.
    fn pitch(&self, size: [Pixels; 2], warnings: &mut Vec<Warning>) -> Result<Option<Length>, String> {
        let [width, height] = size.map(Pixels::px);
        let side = |at: usize| {
            let option = SENSOR.get(at).copied().unwrap_or_default();
            optional(option, self.sensor.get(at).and_then(Option::as_deref), Quantity::Millimeters)
        };
        let (across, down, diagonal) = (side(0)?, side(1)?, side(2)?);
        let other = |one: Option<f64>| diagonal.zip(one).map(|(diagonal, one)| (diagonal * diagonal - one * one).sqrt());
        let (across, down) = (across.or_else(|| other(down)), down.or_else(|| other(across)));
        if [across, down].into_iter().flatten().any(f64::is_nan) {
            return Err("--sensor-diagonal is shorter than a side of the sensor.".to_owned());
        }
        let own = optional("pixel-pitch", self.pitch.as_deref(), Quantity::Micrometers)?;
        let by_sides = [across.map(|across| across / width), down.map(|down| down / height)];
        let Some(pitch) = own
            .or_else(|| by_sides.into_iter().flatten().reduce(f64::min))
            .or_else(|| diagonal.map(|diagonal| diagonal / width.hypot(height)))
        else {
            return Ok(None);
        };
        for (what, side, pixels) in [("rows", down, height), ("columns", across, width)] {
            let Some(all) = side.map(|side| side / pitch) else { continue };
            let all_in_words = number(all.round());
            let said = if all > pixels * (1.0 + TOLERANCE) {
                format!(
                    "The image is not the whole sensor: with square pixels of {} um it has {all_in_words} {what}, of which the image has {}. So {what} \
                     were cut, which changes neither fx nor fy.",
                    number(pitch * 1e6),
                    number(pixels)
                )
            } else if all < pixels * (1.0 - TOLERANCE) {
                format!(
                    "--pixel-pitch and the sensor exclude one another: with pixels of {} um it has {all_in_words} {what}, and the image has {}. The \
                     pitch is followed.",
                    number(pitch * 1e6),
                    number(pixels)
                )
            } else {
                continue;
            };
            warnings.push(Warning::of_results(&said));
        }
        Ok(Some(Length::from_m(pitch)))
    }

    /// What the widest view would be the focal length of, were the lens a fisheye.
    fn as_fisheye(&self, [width, height]: [Pixels; 2], widest: f64) -> String {
        let extent = self
            .facts
            .iter()
            .find_map(|(kind, _)| kind.extent([width, height]))
            .unwrap_or(width);
        let of = |projection: Projection| {
            let f = projection.focal_length(Angle::from_degrees(widest), extent)?;
            Some(format!("{} {} px", projection.name(), number(f.px())))
        };
        let others: Vec<String> = Projection::ALL.into_iter().skip(1).filter_map(of).collect();
        format!(
            "A view of {} deg is rarely that of a pinhole: of a fisheye lens the focal length cannot be had from its angle this way. With --model it \
             would be: {}.",
            number(widest),
            others.join(", ")
        )
    }
}

/// In degrees. Wider lenses distort on purpose.
const MOST_OF_A_PINHOLE: f64 = 100.0;
const UNDER_WATER: &str = "Was fx calibrated in the water? Then leave out --water, as it is in fx already. fx and fy are 1.333 times those in air, an \
                           approximation for a flat window and the middle of the image.";

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
