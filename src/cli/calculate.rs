//! `calculate`: its options, which are made from the table of fields, and what is answered, warned about or refused.

use super::digits::in_sentence;
use super::{Reply, json, text};
use crate::core::problem::{Method, Outcome, Solution};
use crate::core::quantity::LengthUnit;
use crate::formats::field::{CommandOption, Key};
use crate::formats::fields;
use crate::formats::inputs::{Entry, Inputs, Note, Part, Severity};
use crate::formats::sentences::CommandLine;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches, ValueHint};
use serde::Serialize;

/// The lines are short enough for a manual page in 80 columns.
pub(super) const MORE_HELP: &str = "\
Formulas:
  stereo     D = fx · b / (d + doffs)   needs --fx, --baseline, --disparity
  monocular  D = w_real · fx / w_img    needs --fx, --w-img, --w-real

Units:
  A length may carry mm, cm, m, in or ft (100mm, 0.1m). Bare, --baseline is
  in mm and --w-real in m. An uncertainty is one standard deviation: with a
  unit, in percent (1%), or bare in the unit of its value. A raw value of
  OpenCV's StereoBM or StereoSGBM is 16 times the disparity: divide it.

Answer:
  The first line starts with the distance; with both methods and their
  uncertainties it is the two combined. Warnings go to standard error, or
  with --json into \"warnings\".

Examples:
  depth-calculator calculate --fx 700 --baseline 100mm --disparity 50
      a coffee mug, 1.400 m away
  depth-calculator calculate --fx 950 --w-img 200 --w-real 0.9m --unit ft
      a doorway, 14.03 ft away
  depth-calculator calculate --fx 700 --baseline 100 --disparity 50 \\
      --sigma-fx 2 --sigma-baseline 0.5mm --sigma-disparity 0.5 --json
      how sure one can be of the mug, for a program to read

Exit status:
  0 with an answer, 2 with a one-line reason on standard error,
  1 if the answer could not be written";

const UNCERTAINTY: &str = "Uncertainty";
const OUTPUT: &str = "Output";

/// What was given to `calculate`.
#[derive(Debug)]
pub(super) struct Calculate {
    /// The texts of the options that fill in a field, in the order of the table.
    typed: Vec<(Key, Part, String)>,
    /// Unit of every length in the answer.
    unit: LengthUnit,
    /// Whether to answer in JSON.
    json: bool,
}

/// The fields that have an option.
fn fields_with_option() -> impl Iterator<Item = (Key, CommandOption)> {
    fields::TABLE.iter().filter_map(|&key| Some((key, key.option?)))
}

/// The options for the values, then those for their σ.
fn field_options() -> Vec<(Key, Part, Arg)> {
    let option = |name: String, value: String, help| {
        Arg::new(name.clone())
            .long(name)
            .value_name(value)
            .value_hint(ValueHint::Other)
            .help(help)
    };
    let values = fields_with_option().map(|(key, field)| {
        let placeholder = key.kind.placeholder().to_owned();
        (key, Part::Value, option(name(key, Part::Value), placeholder, field.help))
    });
    let sigmas = fields_with_option().filter(|(key, _)| key.has_sigma).map(|(key, field)| {
        let placeholder = format!("{}|%", key.kind.placeholder());
        let sigma = option(name(key, Part::Sigma), placeholder, field.sigma_help);
        (key, Part::Sigma, sigma.help_heading(UNCERTAINTY))
    });
    values.chain(sigmas).collect()
}

/// The name of the option that sets the value of `key` or its σ, without its dashes.
fn name(key: Key, part: Part) -> String {
    let value = key.option.map_or(key.as_str(), |option| option.name);
    match part {
        Part::Value => value.to_owned(),
        Part::Sigma => format!("sigma-{value}"),
    }
}

impl Args for Calculate {
    fn augment_args(command: Command) -> Command {
        let unit = Arg::new("unit")
            .long("unit")
            .default_value(LengthUnit::Metre.symbol())
            .value_name("UNIT")
            .value_parser(unit_parser())
            .help("Unit of every length in the answer; JSON stays in meters")
            .help_heading(OUTPUT);
        let json = Arg::new("json")
            .long("json")
            .action(ArgAction::SetTrue)
            .help("Answer in JSON: lengths in meters, null for what is unknown or unbounded")
            .help_heading(OUTPUT);
        let fields = field_options().into_iter().map(|(_, _, option)| option);
        command.args(fields.chain([unit, json]))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Calculate {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        let typed = |(key, part, option): (Key, Part, Arg)| {
            let text = matches.get_one::<String>(option.get_id().as_str())?;
            Some((key, part, text.clone()))
        };
        Ok(Self {
            typed: field_options().into_iter().filter_map(typed).collect(),
            unit: matches.get_one::<LengthUnit>("unit").copied().unwrap_or(LengthUnit::Metre),
            json: matches.get_flag("json"),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

fn unit_parser() -> impl TypedValueParser<Value = LengthUnit> {
    PossibleValuesParser::new(LengthUnit::ALL.map(LengthUnit::symbol)).try_map(|symbol| {
        let unit = LengthUnit::ALL.into_iter().find(|unit| unit.symbol() == symbol);
        unit.ok_or("not a unit of length")
    })
}

/// What is to be said about an option without refusing it.
#[derive(Serialize)]
pub(super) struct Warning {
    /// The option without its dashes.
    field: String,
    message: String,
}

impl Warning {
    fn new(key: Key, part: Part, sentence: &impl ToString) -> Self {
        Self {
            field: name(key, part),
            message: in_sentence(&sentence.to_string()),
        }
    }

    fn of(note: &Note) -> Self {
        Self::new(note.key, note.part, &note.issue)
    }
}

impl Calculate {
    /// Whether the option for the value of `key` or for its σ was given.
    fn is_given(&self, key: impl Into<Key>, part: Part) -> bool {
        let key = key.into();
        self.typed.iter().any(|typed| (typed.0, typed.1) == (key, part))
    }

    fn inputs(&self) -> Inputs {
        let mut inputs = Inputs::default();
        inputs.with_uncertainty = true;
        for (key, part, text) in &self.typed {
            match part {
                Part::Value => inputs.fill(*key, Entry::new(text, None)),
                Part::Sigma => inputs.set_sigma(*key, text),
            }
        }
        inputs
    }

    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        self.refuse_empty()?;
        let inputs = self.inputs();
        let assessment = inputs.assess();
        let solution = &assessment.solution;
        let answered = Method::ALL.iter().any(|&method| solution.outcome(method).distance().is_some());
        let error = assessment.notes.iter().find(|note| note.severity == Severity::Error);
        if let Some(note) = error
            && !(answered && is_beside_the_answer(solution, note.key))
        {
            let Warning { field, message } = Warning::of(note);
            return Err(format!("--{field}: {message}"));
        }
        if !answered {
            return Err(self.what_is_missing().to_string());
        }
        // Half of the other method was given: that is worth a warning, an untouched one is not.
        let missing = inputs.missing();
        let missing = missing.iter().filter(|note| assessment.note(note.key).is_none());
        let mut warnings: Vec<Warning> = assessment.notes.iter().chain(missing).map(Warning::of).collect();
        let unused = self.unused(solution);
        // What there is a better sentence about is not mentioned again.
        let is_new = |unused: &Warning| warnings.iter().all(|warning| warning.field != unused.field);
        let unused: Vec<Warning> = unused.into_iter().filter(is_new).collect();
        warnings.extend(unused);
        if self.json {
            return json::answer(solution, &warnings).map(Reply::without_warnings);
        }
        Ok(Reply {
            text: text::answer(solution, self.unit),
            warnings: warnings
                .iter()
                .map(|Warning { field, message }| format!("--{field}: {message}"))
                .collect(),
        })
    }

    /// An empty value is a variable of a script that was not set, not an input that was left out.
    fn refuse_empty(&self) -> Result<(), String> {
        let empty = |(_, _, text): &&(Key, Part, String)| text.trim().is_empty();
        // Field by field, as they are asked for.
        match self.typed.iter().filter(empty).min_by_key(|(key, part, _)| (*key, *part)) {
            Some((key, part, _)) => Err(CommandLine::EmptyOption { option: name(*key, *part) }.to_string()),
            None => Ok(()),
        }
    }

    /// Which options would give a distance: those of the methods of which something was typed, else those of both.
    fn what_is_missing(&self) -> CommandLine {
        let touched = |method: &Method| method.own_fields().into_iter().any(|field| self.is_given(field, Part::Value));
        let any_touched = Method::ALL.iter().any(touched);
        let ways = Method::ALL
            .into_iter()
            .filter(|method| touched(method) || !any_touched)
            .map(|method| {
                let missing = method.fields().into_iter().filter(|&field| !self.is_given(field, Part::Value));
                (missing.map(|field| name(field.into(), Part::Value)).collect(), method.name())
            })
            .collect();
        CommandLine::NoDistance { ways }
    }

    /// What was typed and plays no part in the answer.
    fn unused(&self, solution: &Solution) -> Vec<Warning> {
        let stereo = Method::Stereo.own_fields();
        let is_stereo = solution.stereo.distance().is_some() || stereo.iter().any(|&field| self.is_given(field, Part::Value));
        let reason = |key: Key, part| match part {
            _ if key == fields::DOFFS => (!is_stereo).then_some(CommandLine::UnusedDoffs),
            Part::Sigma if !self.is_given(key, Part::Value) => Some(CommandLine::UnusedSigma {
                option: name(key, Part::Value),
            }),
            Part::Sigma | Part::Value => None,
        };
        let mut typed: Vec<(Key, Part)> = self.typed.iter().map(|&(key, part, _)| (key, part)).collect();
        typed.sort();
        typed
            .into_iter()
            .filter_map(|(key, part)| Some(Warning::new(key, part, &reason(key, part)?)))
            .collect()
    }
}

/// Whether `key` belongs only to a method that is not the one that gave an answer.
fn is_beside_the_answer(solution: &Solution, key: Key) -> bool {
    let belongs = |method: Method| {
        let is_offset = method == Method::Stereo && key == fields::DOFFS;
        method.fields().into_iter().any(|field| key == field) || is_offset
    };
    Method::ALL
        .into_iter()
        .filter(|&method| matches!(solution.outcome(method), Outcome::Distance(_)))
        .all(|method| !belongs(method))
}
