//! The options of `calculate` and `ground`.

use super::calibration::{Calibration, file_unit};
use super::presets::Chosen;
use super::typed::{INVERSE, Typed};
use crate::core::problem::{Field, Method};
use crate::core::quantity::Length;
use crate::core::setup::{Object, Pair};
use clap::builder::{PossibleValuesParser, TypedValueParser, ValueParser};
use clap::parser::ValueSource;
use clap::{Arg, ArgAction, ArgMatches, Args, Command, FromArgMatches, ValueHint};
use depth_text::field::{Key, Section};
use depth_text::fields;
use std::path::PathBuf;

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
