//! The options that fill in fields, which are made from the table of fields, and those that every answer has.

use super::calibration::{Calibration, file_unit};
use super::presets::Chosen;
use crate::core::problem::{Field, Method};
use crate::core::quantity::{Length, LengthUnit};
use crate::core::setup::{Object, Pair};
use clap::builder::{PossibleValue, PossibleValuesParser, TypedValueParser, ValueParser};
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches, ValueHint};
use depth_text::entry::{Entries, Entry};
use depth_text::field::{Key, Section};
use depth_text::fields;
use depth_text::note::Part;
use depth_text::sentences::CommandLine;
use depth_text::style::Style;
use std::path::PathBuf;

pub(super) const UNCERTAINTY: &str = "Uncertainty";
const POINT: &str = "Point in space";
const INVERSE: &str = "Another unknown";
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

/// What was given to `calculate`.
#[derive(Clone, Debug)]
pub(super) struct Calculate {
    pub(super) fields: Typed,
    /// What is solved for, where it is not the distance.
    pub(super) solve_for: Option<Key>,
    /// What of the object is measured; `None` where that was not said.
    pub(super) object: Option<Object>,
    /// How the cameras stand; `None` where that was not said.
    pub(super) pair: Option<Pair>,
    /// Where the rest is from.
    pub(super) calibration: Option<Calibration>,
    /// The camera that everybody knows which the rest is of.
    pub(super) preset: Option<Chosen>,
    /// The object of known size whose size the real width is.
    pub(super) known: Option<String>,
}

/// What was given to `ground`.
#[derive(Debug)]
pub(super) struct Ground {
    pub(super) fields: Typed,
}

/// The fields that `calculate` has options for.
fn calculate_fields() -> Vec<Key> {
    let form = Key::form().filter(|key| !key.section.is_some_and(Section::is_way_of_its_own));
    form.chain([fields::DISTANCE]).filter(|key| key.option.is_some()).collect()
}

/// The fields that `ground` has options for.
fn ground_fields() -> Vec<Key> {
    let camera = [fields::FOCAL_LENGTH, fields::FY, fields::CX, fields::CY].into_iter();
    camera.chain(Section::Ground.keys()).filter(|key| key.option.is_some()).collect()
}

/// The inputs of which one can be solved for.
pub(super) fn unknowns() -> impl Iterator<Item = Key> {
    // The focal length is in both.
    let is_unknown = |field: &Field| Method::ALL.into_iter().flat_map(Method::unknowns).any(|one| one == *field);
    Field::ALL.into_iter().filter(is_unknown).map(Key::from)
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

impl Args for Calculate {
    fn augment_args(command: Command) -> Command {
        let solve_for = Arg::new("solve-for")
            .long("solve-for")
            .value_name("FIELD")
            .value_parser(unknown_parser())
            .help("Solve for this input instead of the distance, which --distance then gives")
            .help_heading(INVERSE);
        let object = choice("object", Object::ALL.map(Object::key), Object::default().key()).help(
            "What of the object --w-img and --w-real are: heights go with --fy, a ball in the middle of the image counts to its center",
        );
        command.args(Typed::options(&calculate_fields())).args([
            object,
            pair_option(),
            solve_for,
            from_option(),
            camera_option(),
            file_unit_option(),
            preset_option(),
            width_option(),
            known_option(),
        ])
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Calculate {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        Ok(Self {
            fields: Typed::from(matches, &calculate_fields()),
            solve_for: matches.get_one::<Key>("solve-for").copied(),
            object: chosen(matches, "object", Object::ALL, Object::key),
            pair: chosen(matches, "pair", Pair::ALL, Pair::key),
            calibration: matches.get_many::<PathBuf>("from").map(|files| Calibration {
                files: files.cloned().collect(),
                file_unit: matches.get_one::<Length>("file-unit").copied(),
                cameras: matches.get_many::<String>("camera").into_iter().flatten().cloned().collect(),
            }),
            preset: matches.get_one::<String>("preset").map(|name| Chosen {
                name: name.clone(),
                width: matches.get_one::<u32>("width").copied(),
            }),
            known: matches.get_one::<String>("known").cloned(),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

impl Args for Ground {
    fn augment_args(command: Command) -> Command {
        command.args(Typed::options(&ground_fields()))
    }

    fn augment_args_for_update(command: Command) -> Command {
        Self::augment_args(command)
    }
}

impl FromArgMatches for Ground {
    fn from_arg_matches(matches: &ArgMatches) -> Result<Self, clap::Error> {
        Ok(Self {
            fields: Typed::from(matches, &ground_fields()),
        })
    }

    fn update_from_arg_matches(&mut self, matches: &ArgMatches) -> Result<(), clap::Error> {
        *self = Self::from_arg_matches(matches)?;
        Ok(())
    }
}

pub(super) fn pair_option() -> Arg {
    choice("pair", Pair::ALL.map(Pair::key), Pair::default().key())
        .help("How the cameras stand: side by side, or one above the other: the disparity is then the row in the upper image minus that in the lower one, and goes with --fy")
}

/// An option with one of `names`, of which `usual` is meant without it.
fn choice<const N: usize>(option: &'static str, names: [&'static str; N], usual: &'static str) -> Arg {
    Arg::new(option)
        .long(option)
        .value_name("WHICH")
        .value_parser(PossibleValuesParser::new(names))
        .default_value(usual)
}

/// What was chosen by `option`; `None` where nothing was.
pub(super) fn chosen<T: Copy, const N: usize>(matches: &ArgMatches, option: &str, all: [T; N], key: fn(T) -> &'static str) -> Option<T> {
    if matches.value_source(option) != Some(ValueSource::CommandLine) {
        return None;
    }
    let name = matches.get_one::<String>(option)?;
    all.into_iter().find(|&one| key(one) == name)
}

fn from_option() -> Arg {
    Arg::new("from")
        .long("from")
        .value_name("FILE")
        .num_args(1..)
        .action(ArgAction::Append)
        .value_parser(ValueParser::path_buf())
        .value_hint(ValueHint::FilePath)
        .help("Calibration files that fx, baseline and doffs are taken from, where they are not given; - is standard input. See import")
}

fn preset_option() -> Arg {
    Arg::new("preset").long("preset").value_name("NAME").conflicts_with("from").help(
        "A camera that fx, baseline and doffs are taken from, where they are not given; with --zero preset the zero point too. See presets",
    )
}

fn known_option() -> Arg {
    Arg::new("known")
        .long("known")
        .value_name("NAME")
        .help("An object that --w-real and its uncertainty are taken from, where they are not given. See sizes")
}

fn width_option() -> Arg {
    Arg::new("width")
        .long("width")
        .value_name("PX")
        .value_parser(clap::value_parser!(u32))
        .requires("preset")
        .help("The width of the images of the preset; without it the first in its list")
}

fn camera_option() -> Arg {
    Arg::new("camera")
        .long("camera")
        .value_name("NAME[,NAME]")
        .value_delimiter(',')
        .requires("from")
        .help("Which camera of the calibration files is meant where there are several, or which two: by what import calls them")
}

fn file_unit_option() -> Arg {
    Arg::new("file-unit")
        .long("file-unit")
        .value_name("LENGTH")
        .value_parser(file_unit)
        .requires("from")
        .help("What one unit is of a calibration file that does not say it: 1mm, or 25mm for squares of 25 mm")
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

fn unknown_parser() -> impl TypedValueParser<Value = Key> {
    let names: Vec<&str> = unknowns().filter_map(|key| Some(key.option?.name)).collect();
    PossibleValuesParser::new(names).try_map(|name| {
        let unknown = unknowns().find(|key| key.option.is_some_and(|option| option.name == name));
        unknown.ok_or("not an input")
    })
}

/// The equation to solve for `key`; `None` for the focal length, which both have.
pub(super) fn method_of(key: Key) -> Option<Method> {
    Method::ALL.into_iter().find(|method| {
        method
            .own_fields()
            .into_iter()
            .chain([method.own_optional_field()])
            .any(|field| key == field)
    })
}
