//! What is typed into fields by options, which are made from the table of fields, and the options that every answer has.

use crate::core::quantity::LengthUnit;
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser};
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, ValueHint};
use depth_text::entry::{Entries, Entry};
use depth_text::field::{Key, Section};
use depth_text::note::Part;
use depth_text::sentences::CommandLine;
use depth_text::style::Style;

pub(super) const UNCERTAINTY: &str = "Uncertainty";
const POINT: &str = "Point in space";
pub(super) const INVERSE: &str = "Another unknown";
const OUTPUT: &str = "Output";
/// The option for σ of both disparities of two points.
pub(super) const SIGMA_DISPARITY: &str = "sigma-disparity";

/// What was typed into fields by options, and how to answer.
#[derive(Clone, Debug)]
pub(super) struct Typed {
    /// The texts of the options that fill in a field, in the order of the table.
    pub(super) typed: Vec<(Key, Part, String)>,
    /// Unit of every length in the answer.
    pub(super) unit: LengthUnit,
    /// Whether that was asked for.
    unit_is_given: bool,
    /// Whether to answer in JSON.
    pub(super) json: bool,
    /// The option that σ of several fields was typed with, and these.
    pub(super) shared_sigma: Option<(&'static str, Vec<Key>)>,
}

/// The options of `keys` for the values, then those for their σ.
fn field_options(keys: &[Key]) -> Vec<(Key, Part, Arg)> {
    let option = |name: String, value: String, help| {
        Arg::new(name.clone())
            .long(name)
            .value_name(value)
            .value_hint(ValueHint::Other)
            .help(help)
    };
    let with_option = keys.iter().filter_map(|&key| Some((key, key.option?)));
    let values = with_option.clone().map(|(key, field)| {
        let placeholder = key.kind.placeholder().to_owned();
        let value = option(name(key, Part::Value), placeholder, field.help);
        let value = match key.section {
            Some(Section::Point) if key.input.is_none() => value.help_heading(POINT),
            None => value.help_heading(INVERSE),
            _ => value,
        };
        (key, Part::Value, value)
    });
    let sigmas = with_option.filter(|(key, _)| key.has_sigma).map(|(key, field)| {
        let placeholder = format!("{}|%", key.kind.placeholder());
        let sigma = option(name(key, Part::Sigma), placeholder, field.sigma_help);
        (key, Part::Sigma, sigma.help_heading(UNCERTAINTY))
    });
    values.chain(sigmas).collect()
}

/// The name of the option that sets the value of `key` or its σ, without its dashes.
pub(super) fn name(key: Key, part: Part) -> String {
    if key.section == Some(Section::TwoPoints) {
        // One option has all of a point.
        let point = key.as_str().split('-').next().unwrap_or_default();
        return match part {
            Part::Value => point.to_owned(),
            Part::Sigma => SIGMA_DISPARITY.to_owned(),
        };
    }
    let value = key.option.map_or(key.as_str(), |option| option.name);
    match part {
        Part::Value => value.to_owned(),
        Part::Sigma => format!("sigma-{value}"),
    }
}

impl Typed {
    pub(super) fn options(keys: &[Key]) -> impl Iterator<Item = Arg> {
        let fields = field_options(keys).into_iter().map(|(_, _, option)| option);
        fields.chain([unit_option(), json_option()])
    }

    pub(super) fn from(matches: &ArgMatches, keys: &[Key]) -> Self {
        let typed = |(key, part, option): (Key, Part, Arg)| {
            let text = matches.get_one::<String>(option.get_id().as_str())?;
            Some((key, part, text.clone()))
        };
        Self {
            typed: field_options(keys).into_iter().filter_map(typed).collect(),
            unit: matches.get_one::<LengthUnit>("unit").copied().unwrap_or(LengthUnit::Meter),
            unit_is_given: matches.value_source("unit") == Some(ValueSource::CommandLine),
            json: matches.get_flag("json"),
            shared_sigma: None,
        }
    }

    /// How results are written: in the unit that was asked for, or where none was in the next one if they are long or short in it.
    pub(super) const fn style(&self) -> Style {
        if self.unit_is_given {
            Style::TERMINAL.in_unit_asked_for()
        } else {
            Style::TERMINAL
        }
    }

    /// Takes the option `option` for what was typed for σ of those `keys` that have no option for it, or whose own was not given.
    pub(super) fn sigma_of(mut self, matches: &ArgMatches, option: &'static str, keys: &[Key]) -> Self {
        if let Some(text) = matches.get_one::<String>(option) {
            let keys = keys.iter().copied().filter(|&key| !self.is_given(key, Part::Sigma));
            let keys: Vec<Key> = keys.collect();
            self.typed.extend(keys.iter().map(|&key| (key, Part::Sigma, text.clone())));
            self.shared_sigma = Some((option, keys));
        }
        self
    }

    /// Whether the option for the value of `key` or for its σ was given.
    pub(super) fn is_given(&self, key: impl Into<Key>, part: Part) -> bool {
        let key = key.into();
        self.typed.iter().any(|typed| (typed.0, typed.1) == (key, part))
    }

    /// What the fields have in them.
    pub(super) fn entries(&self) -> Entries {
        let mut entries = Entries::default();
        for (key, part, text) in &self.typed {
            match part {
                Part::Value => entries.fill(*key, Entry::new(text, None)),
                Part::Sigma => entries.entry_mut(*key).sigma.clone_from(text),
            }
        }
        // An option of its own says more than what stands behind a value.
        for (key, _, _) in self.typed.iter().filter(|(_, part, _)| *part == Part::Sigma) {
            entries.entry_mut(*key).drop_sigma_behind();
        }
        entries
    }

    /// Refuses an empty value: it is a variable of a script that was not set, not an input that was left out.
    pub(super) fn refuse_empty(&self) -> Result<(), String> {
        // So is a σ that was begun behind the value.
        let is_begun = |text: &str| ["±", "+/-", "+-"].iter().any(|sign| text.ends_with(sign));
        let empty = |(_, _, text): &&(Key, Part, String)| text.trim().is_empty() || is_begun(text.trim());
        // Field by field, as they are asked for.
        match self.typed.iter().filter(empty).min_by_key(|(key, part, _)| (*key, *part)) {
            Some((key, part, text)) if !text.trim().is_empty() => Err(CommandLine::EmptySigma { option: name(*key, *part) }.to_string()),
            Some((key, part, _)) => Err(CommandLine::EmptyOption { option: name(*key, *part) }.to_string()),
            None => Ok(()),
        }
    }
}

fn unit_option() -> Arg {
    Arg::new("unit")
        .long("unit")
        .default_value(LengthUnit::Meter.symbol())
        .value_name("UNIT")
        .value_parser(unit_parser())
        .help("Unit of every length in the answer; without it meters, or km or less where these are too short or too long. JSON stays in meters")
        .help_heading(OUTPUT)
}

fn json_option() -> Arg {
    Arg::new("json")
        .long("json")
        .action(ArgAction::SetTrue)
        .help("Answer in JSON: lengths in meters, null for what is unknown or unbounded")
        .help_heading(OUTPUT)
}

/// Reads the symbol of a unit of length.
pub(super) fn unit_parser() -> impl TypedValueParser<Value = LengthUnit> {
    let value = |unit: LengthUnit| match unit {
        LengthUnit::Micrometer => PossibleValue::new(unit.symbol()).aliases(["um", "μm"]),
        _ => PossibleValue::new(unit.symbol()),
    };
    PossibleValuesParser::new(LengthUnit::ALL.map(value)).try_map(|symbol| {
        let symbol = if ["um", "μm"].contains(&symbol.as_str()) {
            LengthUnit::Micrometer.symbol().to_owned()
        } else {
            symbol
        };
        let unit = LengthUnit::ALL.into_iter().find(|unit| unit.symbol() == symbol);
        unit.ok_or("not a unit of length")
    })
}
