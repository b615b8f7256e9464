//! Checks assets/presets.json, and writes it as constants: nobody has to parse it, and a mistake in it ends the build.

use serde::Deserialize;
use std::collections::HashSet;
use std::fmt::Write as _;
use std::path::Path;
use std::process::ExitCode;

const FILE: &str = "../../assets/presets.json";

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct File {
    presets: Vec<Preset>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Preset {
    name: String,
    label: String,
    basis: String,
    source: String,
    baseline_mm: Option<f64>,
    doffs_px: Option<f64>,
    zero_mm: Option<f64>,
    zero_source: Option<String>,
    /// Width, height, and focal length in pixels.
    modes: Vec<(Option<u32>, Option<u32>, f64)>,
}

impl Preset {
    /// The variant of `Basis` that it names.
    fn basis(&self) -> Option<&'static str> {
        Some(match self.basis.as_str() {
            "one unit" => "OneUnit",
            "vendor" => "Vendor",
            "computed" => "Computed",
            "data set" => "DataSet",
            _ => return None,
        })
    }

    /// What is wrong with it, in a few words.
    fn fault(&self) -> Option<&'static str> {
        let is_slug = |one: char| one.is_ascii_lowercase() || one.is_ascii_digit() || one == '-';
        let is_plausible = |length: Option<f64>, most: f64| length.is_none_or(|length| length > 0.0 && length <= most);
        let is_mode = |&(width, height, fx): &(Option<u32>, Option<u32>, f64)| {
            let sides_fit = width.zip(height).is_none_or(|(width, height)| width >= height);
            // A view from 12° to 140°.
            let view_fits = width.is_none_or(|width| (0.18..4.8).contains(&(fx / f64::from(width))));
            fx > 0.0 && fx.is_finite() && sides_fit && view_fits
        };
        let faults = [
            (
                self.name.is_empty() || !self.name.chars().all(is_slug),
                "name: small letters, digits and hyphens",
            ),
            (self.label.trim().is_empty(), "label: it needs one"),
            (self.basis().is_none(), "basis: one unit, vendor, computed or data set"),
            (self.source.trim().len() < 8, "source: it needs one"),
            (!is_plausible(self.baseline_mm, 1000.0), "baseline_mm: from above 0 to 1000"),
            (!is_plausible(self.zero_mm, 50.0), "zero_mm: from above 0 to 50"),
            (self.zero_mm.is_some() != self.zero_source.is_some(), "zero_source: with zero_mm"),
            (
                self.modes.is_empty() || !self.modes.iter().all(is_mode),
                "modes: [width, height, fx], which fit",
            ),
        ];
        faults.into_iter().find_map(|(is_wrong, fault)| is_wrong.then_some(fault))
    }

    fn constant(&self) -> String {
        let length = |mm: Option<f64>| mm.map_or_else(|| "None".to_owned(), |mm| format!("Some(Length::from_m({mm:?}e-3))"));
        let modes: Vec<String> = self
            .modes
            .iter()
            .map(|(width, height, fx)| format!("Mode {{ width: {width:?}, height: {height:?}, focal_length: Pixels::new({fx:?}) }}"))
            .collect();
        format!(
            "Preset {{ name: {:?}, label: {:?}, basis: Basis::{}, source: {:?}, baseline: {}, doffs: Pixels::new({:?}), zero: {}, zero_source: {:?}, modes: &[{}] }},",
            self.name,
            self.label,
            self.basis().unwrap_or_default(),
            self.source,
            length(self.baseline_mm),
            self.doffs_px.unwrap_or(0.0),
            length(self.zero_mm),
            self.zero_source,
            modes.join(", ")
        )
    }
}

fn written() -> Result<(), String> {
    let text = std::fs::read_to_string(FILE).map_err(|error| format!("{FILE}: {error}"))?;
    let file: File = serde_json::from_str(&text).map_err(|error| format!("{FILE}: {error}"))?;
    let mut names = HashSet::new();
    let mut code = String::from("/// Every preset.\npub const PRESETS: &[Preset] = &[\n");
    for preset in &file.presets {
        if let Some(fault) = preset.fault() {
            return Err(format!("{FILE}: {}: {fault}", preset.name));
        }
        if !names.insert(&preset.name) {
            return Err(format!("{FILE}: {} is there twice", preset.name));
        }
        writeln!(code, "    {}", preset.constant()).map_err(|error| error.to_string())?;
    }
    code.push_str("];\n");
    let out = std::env::var("OUT_DIR").map_err(|error| error.to_string())?;
    std::fs::write(Path::new(&out).join("presets.rs"), code).map_err(|error| error.to_string())
}

fn main() -> ExitCode {
    println!("cargo:rerun-if-changed={FILE}");
    match written() {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("{fault}");
            ExitCode::FAILURE
        }
    }
}
