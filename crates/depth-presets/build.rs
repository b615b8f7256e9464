//! Checks assets/presets.json and assets/sizes.json, and writes them as constants: nobody has to parse them, and a mistake in them ends
//! the build.

use serde::Deserialize;
use serde::de::DeserializeOwned;
use std::collections::HashSet;
use std::fmt::Write as _;
use std::path::Path;
use std::process::ExitCode;

const PRESETS: &str = "../../assets/presets.json";
const SIZES: &str = "../../assets/sizes.json";

/// Something in one of the files.
trait Entry {
    /// By which it is known.
    fn name(&self) -> &str;
    /// What is wrong with it, in a few words.
    fn fault(&self) -> Option<&'static str>;
    /// The code that makes it.
    fn constant(&self) -> String;
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
    /// Where each scene has its own.
    #[serde(default)]
    doffs_unknown: bool,
    zero_mm: Option<f64>,
    zero_source: Option<String>,
    /// Width, height, and focal length in pixels.
    modes: Vec<(Option<u32>, Option<u32>, f64)>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct Size {
    name: String,
    label: String,
    /// A width where it does not say.
    object: Option<String>,
    size_mm: f64,
    sigma_mm: Option<f64>,
    source: String,
}

fn is_slug(name: &str) -> bool {
    let is_part = |one: char| one.is_ascii_lowercase() || one.is_ascii_digit() || one == '-';
    !name.is_empty() && name.chars().all(is_part)
}

fn length(mm: Option<f64>) -> String {
    mm.map_or_else(|| "None".to_owned(), |mm| format!("Some(Length::from_m({mm:?}e-3))"))
}

fn first_of(faults: &[(bool, &'static str)]) -> Option<&'static str> {
    faults.iter().find_map(|(is_wrong, fault)| is_wrong.then_some(*fault))
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
}

impl Preset {
    /// Unknown also where there is no pair.
    fn doffs(&self) -> String {
        if self.doffs_unknown || self.baseline_mm.is_none() {
            return "None".to_owned();
        }
        format!("Some(Pixels::new({:?}))", self.doffs_px.unwrap_or(0.0))
    }
}

impl Entry for Preset {
    fn name(&self) -> &str {
        &self.name
    }

    fn fault(&self) -> Option<&'static str> {
        let is_plausible = |length: Option<f64>, most: f64| length.is_none_or(|length| length > 0.0 && length <= most);
        let is_mode = |&(width, height, fx): &(Option<u32>, Option<u32>, f64)| {
            let sides_fit = width.zip(height).is_none_or(|(width, height)| width >= height);
            // A view from 12° to 140°.
            let view_fits = width.is_none_or(|width| (0.18..4.8).contains(&(fx / f64::from(width))));
            fx > 0.0 && fx.is_finite() && sides_fit && view_fits
        };
        first_of(&[
            (!is_slug(&self.name), "name: small letters, digits and hyphens"),
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
        ])
    }

    fn constant(&self) -> String {
        let modes: Vec<String> = self
            .modes
            .iter()
            .map(|(width, height, fx)| format!("Mode {{ width: {width:?}, height: {height:?}, focal_length: Pixels::new({fx:?}) }}"))
            .collect();
        format!(
            "Preset {{ name: {:?}, label: {:?}, basis: Basis::{}, source: {:?}, baseline: {}, doffs: {}, zero: {}, zero_source: {:?}, modes: &[{}] }},",
            self.name,
            self.label,
            self.basis().unwrap_or_default(),
            self.source,
            length(self.baseline_mm),
            self.doffs(),
            length(self.zero_mm),
            self.zero_source,
            modes.join(", ")
        )
    }
}

impl Size {
    /// The variant of `Object` that it names.
    fn object(&self) -> Option<&'static str> {
        match self.object.as_deref() {
            None => Some("Width"),
            Some("height") => Some("Height"),
            Some("ball") => Some("Ball"),
            Some(_) => None,
        }
    }
}

impl Entry for Size {
    fn name(&self) -> &str {
        &self.name
    }

    fn fault(&self) -> Option<&'static str> {
        let sigma_fits = self.sigma_mm.is_none_or(|sigma| sigma > 0.0 && sigma < self.size_mm / 5.0);
        first_of(&[
            (!is_slug(&self.name), "name: small letters, digits and hyphens"),
            (self.label.trim().is_empty(), "label: it needs one"),
            (self.object().is_none(), "object: height, ball, or none"),
            (!(5.0..5000.0).contains(&self.size_mm), "size_mm: from 5 to 5000"),
            (!sigma_fits, "sigma_mm: from above 0 to a fifth of the size"),
            (self.source.trim().len() < 8, "source: it needs one"),
        ])
    }

    fn constant(&self) -> String {
        let size = format!("Length::from_m({:?}e-3)", self.size_mm);
        format!(
            "Size {{ name: {:?}, label: {:?}, object: Object::{}, size: {size}, sigma: {}, source: {:?} }},",
            self.name,
            self.label,
            self.object().unwrap_or_default(),
            length(self.sigma_mm),
            self.source
        )
    }
}

/// The list in `file` as the constant `name` of the kind `kind`.
fn code<T: Entry + DeserializeOwned>(file: &str, name: &str, kind: &str) -> Result<String, String> {
    let text = std::fs::read_to_string(file).map_err(|error| format!("{file}: {error}"))?;
    let entries: Vec<T> = serde_json::from_str(&text).map_err(|error| format!("{file}: {error}"))?;
    let mut names = HashSet::new();
    let mut code = format!("/// All of them, in the order of their file.\npub const {name}: &[{kind}] = &[\n");
    for entry in &entries {
        if let Some(fault) = entry.fault() {
            return Err(format!("{file}: {}: {fault}", entry.name()));
        }
        if !names.insert(entry.name()) {
            return Err(format!("{file}: {} is there twice", entry.name()));
        }
        writeln!(code, "    {}", entry.constant()).map_err(|error| error.to_string())?;
    }
    code.push_str("];\n");
    Ok(code)
}

fn written() -> Result<(), String> {
    let code = code::<Preset>(PRESETS, "PRESETS", "Preset")? + &code::<Size>(SIZES, "SIZES", "Size")?;
    let out = std::env::var("OUT_DIR").map_err(|error| error.to_string())?;
    std::fs::write(Path::new(&out).join("known.rs"), code).map_err(|error| error.to_string())
}

fn main() -> ExitCode {
    println!("cargo:rerun-if-changed={PRESETS}");
    println!("cargo:rerun-if-changed={SIZES}");
    match written() {
        Ok(()) => ExitCode::SUCCESS,
        Err(fault) => {
            eprintln!("{fault}");
            ExitCode::FAILURE
        }
    }
}
