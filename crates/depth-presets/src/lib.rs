//! Cameras and objects that everybody knows, each with its source: assets/presets.json and assets/sizes.json, checked when this is built.

use depth_core::quantity::{Length, Pixels};
use depth_core::setup::Object;

/// What the figures of a preset are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// Those of one real camera; another one of its kind differs by a percent or so.
    OneUnit,
    /// The vendor's, which are nominal.
    Vendor,
    /// Computed from a nominal field of view.
    Computed,
    /// Those of a data set, for its own images.
    DataSet,
}

impl Basis {
    /// In words.
    ///
    /// ```
    /// assert_eq!(depth_presets::Basis::OneUnit.name(), "one unit");
    /// ```
    pub const fn name(self) -> &'static str {
        match self {
            Self::OneUnit => "one unit",
            Self::Vendor => "vendor",
            Self::Computed => "computed",
            Self::DataSet => "data set",
        }
    }
}

/// One size of the images of a camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mode {
    /// Columns, where the source says it.
    pub width: Option<u32>,
    /// Rows, where the source says it.
    pub height: Option<u32>,
    /// At this size.
    pub focal_length: Pixels,
}

/// A camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Preset {
    /// What it is called on the command line: small letters, digits, hyphens.
    pub name: &'static str,
    /// What it is called elsewhere.
    pub label: &'static str,
    /// What its figures are.
    pub basis: Basis,
    /// Where they come from.
    pub source: &'static str,
    /// `None` where no two of its cameras are a stereo pair.
    pub baseline: Option<Length>,
    /// δ = cx_right − cx_left; `None` where each scene has its own, and where there is no pair.
    pub doffs: Option<Pixels>,
    /// How far the front glass is in front of where distances are counted from.
    pub zero: Option<Length>,
    /// Where that comes from.
    pub zero_source: Option<&'static str>,
    /// The sizes of its images, the usual one first.
    pub modes: &'static [Mode],
}

/// An object of known size.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Size {
    /// What it is called on the command line: small letters, digits, hyphens.
    pub name: &'static str,
    /// What it is called elsewhere, with what of it is measured.
    pub label: &'static str,
    /// What of it is measured.
    pub object: Object,
    /// How large it is.
    pub size: Length,
    /// One standard deviation, where its source says how much it varies.
    pub sigma: Option<Length>,
    /// Where that comes from.
    pub source: &'static str,
}

include!(concat!(env!("OUT_DIR"), "/known.rs"));

/// Whether each word of `typed` is in `all`, in capital or small letters.
fn has_words(all: &str, typed: &str) -> bool {
    let (all, typed) = (all.to_ascii_lowercase(), typed.to_ascii_lowercase());
    !typed.is_empty() && typed.split_whitespace().all(|word| all.contains(word))
}

/// The only one, where there are not several.
fn only<T>(mut all: impl Iterator<Item = T>) -> Option<T> {
    all.next().filter(|_| all.next().is_none())
}

impl Size {
    /// The size of this name or label, in capital or small letters, else the only one that has all these words.
    ///
    /// ```
    /// use depth_presets::Size;
    ///
    /// assert_eq!(Size::named("card").unwrap().size.m(), 0.0856);
    /// ```
    pub fn named(name: &str) -> Option<&'static Self> {
        let name = name.trim();
        let is_it = |size: &&Self| size.name.eq_ignore_ascii_case(name) || size.label.eq_ignore_ascii_case(name);
        let words = |size: &&Self| has_words(&format!("{} {}", size.name, size.label), name);
        SIZES.iter().find(is_it).or_else(|| only(SIZES.iter().filter(words)))
    }
}

impl Preset {
    /// The preset of this name or label, in capital or small letters, else the only one that has all these words.
    ///
    /// ```
    /// use depth_presets::Preset;
    ///
    /// assert_eq!(Preset::named("RealSense D435i"), Preset::named("realsense-d435i"));
    /// assert_eq!(Preset::named("D435i"), Preset::named("realsense-d435i"));
    /// assert_eq!(Preset::named("realsense"), None, "there are several");
    /// assert_eq!(Preset::named("no such camera"), None);
    /// ```
    pub fn named(name: &str) -> Option<&'static Self> {
        let name = name.trim();
        let is_it = |preset: &&Self| preset.name.eq_ignore_ascii_case(name) || preset.label.eq_ignore_ascii_case(name);
        let words = |preset: &&Self| has_words(&format!("{} {}", preset.name, preset.label), name);
        PRESETS.iter().find(is_it).or_else(|| only(PRESETS.iter().filter(words)))
    }

    /// The mode of this width, or the first one; `None` where there is no mode of it.
    ///
    /// ```
    /// use depth_presets::Preset;
    ///
    /// let d435i = Preset::named("realsense-d435i").unwrap();
    /// // Scaled by 0.6 and cropped, not by one half.
    /// assert_eq!(d435i.mode(Some(640)).unwrap().focal_length.px(), 378.806);
    /// assert_eq!(d435i.mode(Some(320)), None);
    /// ```
    pub fn mode(&self, width: Option<u32>) -> Option<&'static Mode> {
        match width {
            None => self.modes.first(),
            Some(width) => self.modes.iter().find(|mode| mode.width == Some(width)),
        }
    }
}
