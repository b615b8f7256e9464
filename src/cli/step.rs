//! `step`: how far away something of unknown size is, from two photographs and the step between them.

use super::ascii::in_sentence;
use super::reply::Reply;
use super::typed::{Typed, UNCERTAINTY, name};
use super::warning::Warning;
use clap::{Arg, ArgMatches, Args, Command, FromArgMatches};
use depth_text::field::{Key, Section};
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::geometry::{TwoShots, missing_for};
use depth_text::note::{Part, Severity};
use depth_text::report;
use depth_text::sentences::{CommandLine, Statement};
use serde::Serialize;

const SIGMA_PX: &str = "sigma-px";

/// What was given to `step`.
#[derive(Debug)]
pub(super) struct Step {
    fields: Typed,
}

/// The fields that `step` has options for.
fn step_fields() -> Vec<Key> {
    Section::TwoShots
        .keys()
        .chain([fields::FOCAL_LENGTH, fields::FX_LENS, fields::ZERO])
        .collect()
}

impl Args for Step {
    fn augment_args(command: Command) -> Command {
        let sigma = Arg::new(SIGMA_PX)
            .long(SIGMA_PX)
            .value_name("PX|%")
            .help("1 σ of both widths; without any it is 1 px")
            .help_heading(UNCERTAINTY);
        command.args(Typed::options(&step_fields())).arg(sigma)
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Step {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let fields = Typed::from(matches, &step_fields());
        Ok(Self {
            fields: fields.sigma_of(matches, SIGMA_PX, &[fields::FAR_WIDTH, fields::NEAR_WIDTH]),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

/// Lengths in meters; null for what is unknown.
#[derive(Serialize)]
struct Answer<'a> {
    distance_far_m: f64,
    distance_near_m: f64,
    /// Of the distance from the first place.
    sigma_m: f64,
    sigma_near_m: f64,
    size_m: Option<f64>,
    sigma_size_m: Option<f64>,
    warnings: &'a [Warning],
}

impl Step {
    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        self.fields.refuse_empty()?;
        let inputs = Inputs {
            entries: self.fields.entries(),
            ..Inputs::default()
        };
        let assessment = inputs.assess();
        if let Some(note) = assessment.notes.iter().find(|note| note.severity == Severity::Error) {
            return Err(Warning::typed(note, &self.fields).to_string());
        }
        let Some(shots) = &assessment.geometry.two_shots else {
            let mut missing = missing_for(Section::TwoShots, &inputs);
            if missing.is_empty() {
                missing.extend(Section::TwoShots.keys());
            }
            let options = missing.into_iter().map(|key| name(key, Part::Value)).collect();
            return Err(CommandLine::NoWay { options }.to_string());
        };
        let remarks = report::shots_remarks(&assessment, shots);
        let mut warnings: Vec<Warning> = assessment.notes.iter().map(|note| Warning::typed(note, &self.fields)).collect();
        if self.fields.json {
            warnings.extend(remarks.iter().map(|remark| {
                let option = if *remark == Statement::OnePixelEach { SIGMA_PX } else { "lens" };
                Warning::of_option(option, remark)
            }));
            return json(shots, &warnings);
        }
        let lines = report::two_shots(self.fields.style(), &shots.solution, self.fields.unit);
        let mut text = String::new();
        for (place, (what, value)) in lines.into_iter().enumerate() {
            let indent = if place == 0 { "" } else { "  " };
            text.push_str(&format!("{indent}{value} ({})\n", what.to_ascii_lowercase()));
        }
        for remark in remarks {
            text.push_str(&format!("  {remark}\n"));
        }
        Ok(Reply {
            text: in_sentence(&text),
            warnings: warnings.iter().map(Warning::to_string).collect(),
        })
    }
}

fn json(shots: &TwoShots, warnings: &[Warning]) -> Result<Reply, String> {
    let solution = &shots.solution;
    let answer = Answer {
        distance_far_m: solution.far.value.m(),
        distance_near_m: solution.near.value.m(),
        sigma_m: solution.far.sigma.m(),
        sigma_near_m: solution.near.sigma.m(),
        size_m: solution.size.map(|size| size.value.m()),
        sigma_size_m: solution.size.map(|size| size.sigma.m()),
        warnings,
    };
    Reply::json(&answer)
}
