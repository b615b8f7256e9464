//! `presets`: the cameras that are known, and what `calculate --preset` fills in of one.

use super::reply::Reply;
use super::typed::Typed;
use clap::Args;
use depth_presets::{Mode, PRESETS, Preset};
use depth_text::field::Key;
use depth_text::fields;
use depth_text::note::Part;
use depth_text::number::{Notation, TYPED_DIGITS};
use serde::Serialize;

/// What was given to `presets`.
#[derive(Debug, Args)]
pub(super) struct Presets {
    /// One of them; without it all are listed
    name: Option<String>,
    /// The width of the images, of a camera that has several; without it the first one
    #[arg(long, value_name = "PX", requires = "name")]
    width: Option<u32>,
    /// Answer in JSON: lengths in meters, null for what is unknown
    #[arg(long)]
    json: bool,
}

/// What was given to `calculate`.
#[derive(Clone, Debug)]
pub(super) struct Chosen {
    /// The name of the preset.
    pub(super) name: String,
    /// The width of the images.
    pub(super) width: Option<u32>,
}

#[derive(Serialize)]
struct Answer {
    name: &'static str,
    label: &'static str,
    basis: &'static str,
    source: &'static str,
    baseline_m: Option<f64>,
    fx_px: f64,
    width: Option<u32>,
    height: Option<u32>,
    doffs_px: Option<f64>,
    zero_m: Option<f64>,
    zero_source: Option<&'static str>,
}

impl Answer {
    fn of(preset: &Preset, mode: &Mode) -> Self {
        Self {
            name: preset.name,
            label: preset.label,
            basis: preset.basis.name(),
            source: preset.source,
            baseline_m: preset.baseline.map(|length| length.m()),
            fx_px: mode.focal_length.px(),
            width: mode.width,
            height: mode.height,
            doffs_px: preset.doffs.map(|doffs| doffs.px()),
            zero_m: preset.zero.map(|length| length.m()),
            zero_source: preset.zero_source,
        }
    }
}

impl Presets {
    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        let one = self.name.as_ref().map(|name| find(name, self.width)).transpose()?;
        match (one, self.json) {
            (Some((preset, mode)), true) => Reply::json(&Answer::of(preset, mode)),
            (Some((preset, _)), false) => Ok(Reply::without_warnings(lines(preset))),
            (None, true) => Reply::json(&PRESETS.iter().filter_map(usual).collect::<Vec<_>>()),
            (None, false) => Ok(Reply::without_warnings(list())),
        }
    }
}

impl Chosen {
    /// Fills in what was not typed. Returns what is to be said of it. Err: a sentence, where there is no such preset.
    pub(super) fn fill(&self, typed: &mut Typed, unknown: Option<Key>) -> Result<String, String> {
        let (preset, mode) = find(&self.name, self.width)?;
        let zero = typed
            .typed
            .iter_mut()
            .find(|(key, part, text)| *key == fields::ZERO && *part == Part::Value && text.trim() == OF_PRESET);
        if let Some((_, _, text)) = zero {
            let length = preset
                .zero
                .ok_or_else(|| format!("No zero point of {} is known: type it, such as --zero 4.2.", preset.label))?;
            *text = format!("{} m", length.m());
        }
        let mut filled: Vec<String> = Vec::new();
        let mut fill = |key: Key, name: &str, value: Option<String>| {
            if let Some(value) = value.filter(|_| !typed.is_given(key, Part::Value) && unknown != Some(key)) {
                filled.push(format!("{name} {value}"));
                typed.typed.push((key, Part::Value, value));
            }
        };
        fill(fields::FOCAL_LENGTH, "fx", Some(format!("{} px", number(mode.focal_length.px()))));
        let baseline = preset.baseline.map(|length| format!("{} mm", number(length.m() * 1000.0)));
        fill(fields::BASELINE, "baseline", baseline);
        // It belongs to the images and the cameras that the other two are of.
        let is_whole = filled.len() == 2;
        let mut fill_doffs = |doffs: f64| {
            if doffs != 0.0 && !typed.is_given(fields::DOFFS, Part::Value) && unknown != Some(fields::DOFFS) {
                filled.push(format!("doffs {} px", number(doffs)));
                typed.typed.push((fields::DOFFS, Part::Value, format!("{} px", number(doffs))));
            }
        };
        match preset.doffs {
            Some(doffs) if is_whole => fill_doffs(doffs.px()),
            _ => {}
        }
        let of = size(mode).map_or_else(String::new, |size| format!(" at {size} px"));
        let mut said = if filled.is_empty() {
            format!("Nothing of {} is used: all was typed.", preset.label)
        } else {
            let (values, basis) = (filled.join(", "), basis_in_words(preset));
            format!("{}{of}: {values}; {basis}: {}.", preset.label, preset.source)
        };
        let is_missing = preset.doffs.is_none() && preset.baseline.is_some() && !typed.is_given(fields::DOFFS, Part::Value);
        if is_missing {
            said.push_str(" Its images are cut differently in each scene: add the number in its dmin.txt as --doffs, without which the distance is far too large.");
        }
        Ok(said)
    }
}

/// What stands for the zero point of the preset.
const OF_PRESET: &str = "preset";

/// Whether the zero point of a preset is asked for.
pub(super) fn asks_zero(typed: &Typed) -> bool {
    let is_it = |(key, part, text): &(Key, Part, String)| *key == fields::ZERO && *part == Part::Value && text.trim() == OF_PRESET;
    typed.typed.iter().any(is_it)
}

const fn basis_in_words(preset: &Preset) -> &'static str {
    use depth_presets::Basis;
    match preset.basis {
        Basis::OneUnit => "measured of one unit, yours differs",
        Basis::Vendor => "the vendor's nominal figures",
        Basis::Computed => "computed from a nominal field of view",
        Basis::DataSet => "of a data set",
    }
}

fn usual(preset: &'static Preset) -> Option<Answer> {
    preset.mode(None).map(|mode| Answer::of(preset, mode))
}

fn find(name: &str, width: Option<u32>) -> Result<(&'static Preset, &'static Mode), String> {
    let Some(preset) = Preset::named(name) else {
        let part = name.trim().to_ascii_lowercase();
        let near: Vec<&str> = PRESETS
            .iter()
            .filter(|preset| !part.is_empty() && (preset.name.contains(&part) || preset.label.to_ascii_lowercase().contains(&part)))
            .map(|preset| preset.name)
            .collect();
        return Err(if near.is_empty() {
            format!("No preset is called “{name}”: `depth-calculator presets` lists them.")
        } else {
            format!("No preset is called “{name}”: there is {}.", near.join(", "))
        });
    };
    let mode = preset.mode(width).ok_or_else(|| {
        let sizes: Vec<String> = preset.modes.iter().filter_map(size).collect();
        let known = if sizes.is_empty() {
            "its source does not say for which size its focal length is".to_owned()
        } else {
            format!("known are {}", sizes.join(", "))
        };
        format!("No images of {} are that wide: {known}.", preset.label)
    })?;
    Ok((preset, mode))
}

fn size(mode: &Mode) -> Option<String> {
    match (mode.width, mode.height) {
        (Some(width), Some(height)) => Some(format!("{width} x {height}")),
        (Some(width), None) => Some(format!("{width} wide")),
        _ => None,
    }
}

fn number(value: f64) -> String {
    Notation::LONG.plain(value, TYPED_DIGITS)
}

fn list() -> String {
    let width = PRESETS.iter().map(|preset| preset.name.len()).max().unwrap_or_default();
    let line = |preset: &Preset| {
        let baseline = preset.baseline.map_or_else(
            || "no stereo pair".to_owned(),
            |length| format!("{} mm", number(length.m() * 1000.0)),
        );
        let fx = preset
            .mode(None)
            .map_or_else(String::new, |mode| format!("{} px", number(mode.focal_length.px())));
        format!("{:<width$}  {baseline:<14}  {fx:<12}  {}\n", preset.name, preset.basis.name())
    };
    PRESETS.iter().map(line).collect()
}

fn lines(preset: &Preset) -> String {
    let mut text = format!("{} ({}: {})\n", preset.label, preset.basis.name(), preset.source);
    if let Some(baseline) = preset.baseline {
        text.push_str(&format!("baseline {} mm\n", number(baseline.m() * 1000.0)));
    }
    for mode in preset.modes {
        let of = size(mode).map_or_else(String::new, |size| format!(" at {size}"));
        text.push_str(&format!("fx {} px{of}\n", number(mode.focal_length.px())));
    }
    match preset.doffs {
        Some(doffs) if doffs.px() != 0.0 => text.push_str(&format!("doffs {} px\n", number(doffs.px()))),
        None if preset.baseline.is_some() => text.push_str("doffs: in the dmin.txt of each scene\n"),
        _ => {}
    }
    if let (Some(zero), Some(source)) = (preset.zero, preset.zero_source) {
        text.push_str(&format!("zero point {} mm in front ({source})\n", number(zero.m() * 1000.0)));
    }
    text
}
