//! `between`: the length between two points that a stereo pair sees.

use super::ascii::in_sentence;
use super::options::{chosen, pair_option};
use super::reply::Reply;
use super::typed::{SIGMA_DISPARITY, Typed, UNCERTAINTY, name};
use super::warning::Warning;
use crate::core::setup::Pair;
use crate::core::two_points::TwoPointsSolution;
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use depth_text::field::{Key, Section};
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::geometry::missing_for;
use depth_text::note::{Part, Severity};
use depth_text::report;
use depth_text::sentences::CommandLine;
use serde::Serialize;

/// What was given to `between`.
#[derive(Debug)]
pub(super) struct Between {
    fields: Typed,
    pair: Pair,
}

/// The fields that `between` has options of their own for.
fn between_fields() -> Vec<Key> {
    vec![
        fields::FOCAL_LENGTH,
        fields::FY,
        fields::BASELINE,
        fields::DOFFS,
        fields::CX,
        fields::CY,
    ]
}

/// The fields of the points of `between`, by their option.
const POINTS: [(&str, [Key; 3]); 2] = [
    ("from", [fields::FROM_COLUMN, fields::FROM_ROW, fields::FROM_DISPARITY]),
    ("to", [fields::TO_COLUMN, fields::TO_ROW, fields::TO_DISPARITY]),
];

impl Args for Between {
    fn augment_args(command: Command) -> Command {
        let point = |name: &'static str, help| Arg::new(name).long(name).value_name("U,V,D").value_parser(point_parser).help(help);
        let sigma = Arg::new(SIGMA_DISPARITY)
            .long(SIGMA_DISPARITY)
            .value_name("PX|%")
            .help("1 σ of both disparities, such as 0.5")
            .help_heading(UNCERTAINTY);
        command.args(Typed::options(&between_fields())).args([
            point("from", "The first point: column, row and disparity, such as 138,219,36"),
            point("to", "The second point"),
            pair_option(),
            sigma,
        ])
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Between {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let mut typed = Typed::from(matches, &between_fields());
        for (option, keys) in POINTS {
            let texts = matches.get_one::<[String; 3]>(option);
            let texts = texts.into_iter().flatten().cloned();
            typed
                .typed
                .extend(keys.into_iter().zip(texts).map(|(key, text)| (key, Part::Value, text)));
        }
        Ok(Self {
            fields: typed.sigma_of(matches, SIGMA_DISPARITY, &[fields::FROM_DISPARITY, fields::TO_DISPARITY]),
            pair: chosen(matches, "pair", Pair::ALL, Pair::key).unwrap_or_default(),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// The three numbers of a point, between commas; between semicolons where the commas are those of the numbers.
fn point_parser(text: &str) -> Result<[String; 3], String> {
    let between = if text.contains(';') { ';' } else { ',' };
    let parts: Vec<String> = text.split(between).map(|part| part.trim().to_owned()).collect();
    parts.try_into().map_err(|_| CommandLine::NotAPoint.to_string())
}

/// Lengths in meters; null for what is unknown.
#[derive(Serialize)]
struct Answer<'a> {
    distance_m: f64,
    sigma_m: Option<f64>,
    dx_m: f64,
    sigma_dx_m: Option<f64>,
    dy_m: f64,
    sigma_dy_m: Option<f64>,
    dz_m: f64,
    sigma_dz_m: Option<f64>,
    warnings: &'a [Warning],
}

impl Between {
    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        self.fields.refuse_empty()?;
        let inputs = Inputs {
            entries: self.fields.entries(),
            pair: self.pair,
            ..Inputs::default()
        };
        let assessment = inputs.assess();
        if let Some(note) = assessment.notes.iter().find(|note| note.severity == Severity::Error) {
            return Err(Warning::typed(note, &self.fields).to_string());
        }
        let Some(points) = &assessment.geometry.two_points else {
            let mut options: Vec<String> = Vec::new();
            for option in missing_for(Section::TwoPoints, &inputs)
                .into_iter()
                .map(|key| name(key, Part::Value))
            {
                if !options.contains(&option) {
                    options.push(option);
                }
            }
            if options.is_empty() {
                options = ["fx", "baseline", "cx", "cy", "from", "to"].map(str::to_owned).into();
            }
            return Err(CommandLine::NoWay { options }.to_string());
        };
        let warnings: Vec<Warning> = assessment.notes.iter().map(|note| Warning::typed(note, &self.fields)).collect();
        if self.fields.json {
            return json(points, &warnings);
        }
        let mut text = String::new();
        for (place, (what, value)) in report::two_points(self.fields.style(), points, self.fields.unit)
            .into_iter()
            .enumerate()
        {
            let line = if place == 0 {
                format!("{value} ({})\n", what.to_ascii_lowercase())
            } else {
                format!("  {what}: {value}\n")
            };
            text.push_str(&line);
        }
        Ok(Reply {
            text: in_sentence(&text),
            warnings: warnings.iter().map(Warning::to_string).collect(),
        })
    }
}

fn json(points: &TwoPointsSolution, warnings: &[Warning]) -> Result<Reply, String> {
    let sigma = |sigma: f64| (sigma > 0.0).then_some(sigma);
    let answer = Answer {
        distance_m: points.distance.value.m(),
        sigma_m: sigma(points.distance.sigma.m()),
        dx_m: points.dx.value.m(),
        sigma_dx_m: sigma(points.dx.sigma.m()),
        dy_m: points.dy.value.m(),
        sigma_dy_m: sigma(points.dy.sigma.m()),
        dz_m: points.dz.value.m(),
        sigma_dz_m: sigma(points.dz.sigma.m()),
        warnings,
    };
    Reply::json(&answer)
}
