//! A rig: a camera or a pair of cameras, with what is known of it. What calibration files, the calculator and the list of rigs hand to
//! each other.

use crate::core::quantity::{Length, LengthUnit, Pixels};
use crate::core::setup::Pair;
use depth_jobs::{Baseline, Camera, Choice};
use depth_presets::{Mode, Preset};
use depth_text::entry::Entry;
use depth_text::field::Key;
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::names::Named;
use depth_text::number::{Notation, TYPED_DIGITS};
use serde::{Deserialize, Serialize};

/// Nobody compares more.
pub const MOST: usize = 6;

/// Characters of the longest text that is taken from a file.
const LONGEST: usize = 250;

/// Of which images a focal length is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Basis {
    /// Without distortion, with the same rows in both.
    #[default]
    Rectified,
    /// As they come from the camera.
    Raw,
}

impl Basis {
    /// Both.
    pub const ALL: [Self; 2] = [Self::Rectified, Self::Raw];
}

impl Named for Basis {
    fn name(self) -> &'static str {
        match self {
            Self::Rectified => "Rectified",
            Self::Raw => "Raw",
        }
    }
}

/// A camera or a pair of cameras.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Rig {
    /// What the person calls it.
    pub name: String,
    /// Where the numbers are from: a file, a data sheet.
    pub source: String,
    /// Of which images they are.
    pub basis: Basis,
    /// The model of the lens and its coefficients, as the file lists them.
    pub distortion: String,
    /// The fields of the rig, under the keys that they have in the calculator.
    pub inputs: Inputs,
}

impl Rig {
    /// The fields of a rig, in their order.
    pub const KEYS: [Key; 9] = [
        fields::FRAME_WIDTH,
        fields::FRAME_HEIGHT,
        fields::FOCAL_LENGTH,
        fields::FY,
        fields::CX,
        fields::CY,
        fields::BASELINE,
        fields::DOFFS,
        fields::ZERO,
    ];
    /// Those of them that the calculator has.
    pub fn shared() -> impl Iterator<Item = Key> {
        Self::KEYS.into_iter().filter(|key| key.section.is_some())
    }

    /// A camera that everybody knows, with images of this size.
    pub fn of_preset(preset: &Preset, mode: &Mode) -> Self {
        let mut inputs = Inputs::default();
        let mut fill = |key: Key, number: Option<String>, unit: Option<LengthUnit>| {
            if let Some(text) = number {
                *inputs.entry_mut(key) = Entry::new(text, unit);
            }
        };
        let millimeters = |length: Option<Length>| length.map(|length| number(length.m() * 1000.0));
        fill(fields::FRAME_WIDTH, mode.width.map(|side| side.to_string()), None);
        fill(fields::FRAME_HEIGHT, mode.height.map(|side| side.to_string()), None);
        fill(fields::FOCAL_LENGTH, Some(number(mode.focal_length.px())), None);
        fill(fields::BASELINE, millimeters(preset.baseline), Some(LengthUnit::Millimeter));
        let doffs = preset.doffs.map(Pixels::px).filter(|doffs| *doffs != 0.0);
        fill(fields::DOFFS, doffs.map(number), None);
        let zero = preset.zero.map_or_else(String::new, |zero| {
            let source = preset.zero_source.unwrap_or_default();
            format!(
                "; the front glass is {} mm in front of where it counts from ({source})",
                number(zero.m() * 1000.0)
            )
        });
        let is_cut = preset.doffs.is_none() && preset.baseline.is_some();
        let cut = if is_cut {
            "; doffs is the number in the dmin.txt of each scene"
        } else {
            ""
        };
        Self {
            name: preset.label.to_owned(),
            source: format!("{}: {}{cut}{zero}", preset.basis.name(), preset.source),
            inputs,
            ..Self::default()
        }
    }

    /// What was chosen of files of this format, with these `names`; the unit of its baseline, where the files do not say it.
    pub fn of_calibration(choice: &Choice, format: &str, names: &[String], unit: Option<&str>) -> Self {
        let camera = &choice.camera;
        let mut inputs = Inputs::default();
        let mut rig = Self {
            name: first_name(names, format),
            source: format!("{} ({format}: {})", names.join(", "), choice.name),
            basis: if camera.is_rectified { Basis::Rectified } else { Basis::Raw },
            distortion: distortion(camera),
            ..Self::default()
        };
        if let Some([width, height]) = camera.size {
            *inputs.entry_mut(fields::FRAME_WIDTH) = Entry::new(width.to_string(), None);
            *inputs.entry_mut(fields::FRAME_HEIGHT) = Entry::new(height.to_string(), None);
        }
        let keys = [fields::FOCAL_LENGTH, fields::FY, fields::CX, fields::CY];
        for (place, (key, px)) in keys.into_iter().zip(camera.intrinsics_px).enumerate() {
            let entry = inputs.entry_mut(key);
            *entry = Entry::new(number(px), None);
            let sigma = camera.sigma_px.and_then(|sigma| sigma.get(place).copied());
            if let Some(sigma) = sigma.filter(|_| key.has_sigma) {
                entry.sigma = number(sigma);
            }
        }
        if let Some(baseline) = choice.baseline {
            *inputs.entry_mut(fields::BASELINE) = baseline_entry(baseline, unit);
            if let Some(doffs) = choice.doffs_px.filter(|doffs| *doffs != 0.0) {
                *inputs.entry_mut(fields::DOFFS) = Entry::new(number(doffs), None);
            }
            inputs.pair = if choice.is_vertical { Pair::Vertical } else { Pair::Horizontal };
        }
        rig.inputs = inputs;
        rig
    }

    /// `before` with what this rig says in place of what it said of another: an empty field of the rig empties that of the calculator,
    /// but for a baseline, which somebody with one camera may have typed.
    pub fn used_in(&self, before: &Inputs) -> Inputs {
        let mut inputs = before.clone();
        if !self.inputs.entry(fields::BASELINE).is_blank() {
            inputs.pair = self.inputs.pair;
        }
        for key in Self::shared() {
            let entry = self.inputs.entry(key);
            if entry.is_blank() && key == fields::BASELINE {
                continue;
            }
            // fy counts for what is measured along the columns; where it is fx it is no news.
            let is_news = key != fields::FY || entry != self.inputs.entry(fields::FOCAL_LENGTH) || inputs.needs_fy();
            *inputs.entry_mut(key) = if is_news { entry.clone() } else { Entry::default() };
        }
        inputs.edited(fields::FOCAL_LENGTH);
        // What is filled in is no longer what is solved for.
        let is_filled = |field| Self::shared().any(|key| key == field && !self.inputs.entry(key).is_blank());
        inputs.unknown = inputs.unknown.filter(|(_, field)| !is_filled(*field));
        inputs
    }

    /// The same without what no rig has, and with texts that a person could have typed: for a rig from a file.
    #[must_use]
    pub fn cleaned(self) -> Self {
        let short = |text: &str| -> String { text.chars().filter(|one| !one.is_control()).take(LONGEST).collect() };
        let mut inputs = Inputs {
            pair: self.inputs.pair,
            ..Inputs::default()
        };
        for key in Self::KEYS {
            let entry = self.inputs.entry(key);
            *inputs.entry_mut(key) = Entry {
                text: short(&entry.text),
                sigma: short(&entry.sigma),
                ..entry.clone()
            };
        }
        Self {
            name: short(&self.name),
            source: short(&self.source),
            distortion: short(&self.distortion),
            basis: self.basis,
            inputs,
        }
    }

    /// Whether nothing was typed into any of its fields.
    pub fn is_blank(&self) -> bool {
        self.inputs.entries.is_blank()
    }

    /// What it is called in the list: its name, or that it has none.
    pub fn shown_name(&self) -> &str {
        let name = self.name.trim();
        if name.is_empty() { "Rig without a name" } else { name }
    }
}

/// A number of a file, with as many digits as count.
pub fn number(number: f64) -> String {
    Notation::LONG.plain(number, TYPED_DIGITS)
}

/// A baseline in the unit that is usual for cameras, or in the `unit` that a person says it is in: the symbol of one, or
/// "squares of 25 mm".
fn baseline_entry(baseline: Baseline, unit: Option<&str>) -> Entry {
    match (baseline, unit) {
        (Baseline::Meters(m), _) => Entry::new(number(m * 1000.0), Some(LengthUnit::Millimeter)),
        (Baseline::InFileUnits { value, .. }, Some(unit)) => {
            let mut entry = Entry::new(format!("{} {unit}", number(value)), None);
            entry.tidy(fields::BASELINE);
            entry
        }
        (Baseline::InFileUnits { .. }, None) => Entry::default(),
    }
}

fn distortion(camera: &Camera) -> String {
    let numbers: Vec<String> = camera.distortion.iter().map(|one| number(*one)).collect();
    let model = camera.model.clone().unwrap_or_default();
    [model, numbers.join(", ")]
        .into_iter()
        .filter(|part| !part.is_empty())
        .collect::<Vec<_>>()
        .join(": ")
}

/// What to call a rig from files with these names.
fn first_name(names: &[String], format: &str) -> String {
    let file = names.first().map_or("", String::as_str);
    let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
    if stem.is_empty() { format.to_owned() } else { stem.to_owned() }
}
