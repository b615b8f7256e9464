//! The options of `calculate`, which are made from the table of fields.

use crate::core::quantity::LengthUnit;
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches, ValueHint};
use depth_text::field::{CommandOption, Key};
use depth_text::fields;
use depth_text::note::Part;

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
    pub(super) typed: Vec<(Key, Part, String)>,
    /// Unit of every length in the answer.
    pub(super) unit: LengthUnit,
    /// Whether to answer in JSON.
    pub(super) json: bool,
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
pub(super) fn name(key: Key, part: Part) -> String {
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
            .default_value(LengthUnit::Meter.symbol())
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
            unit: matches.get_one::<LengthUnit>("unit").copied().unwrap_or(LengthUnit::Meter),
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
