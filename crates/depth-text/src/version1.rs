//! The form as it was stored before fields had keys.

use crate::entry::{Entries, Entry};
use crate::field::{Key, Section};
use crate::fields;
use crate::form::Inputs;
use crate::ways::{DISPARITIES, FOCAL_LENGTHS, Way};
use depth_core::problem::{Field, Method};
use serde::Deserialize;
use std::collections::BTreeMap;

/// The stored form of version 1: a member for each field, the σ apart.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
pub struct StoredInputs {
    focal_length: Entry,
    baseline: Entry,
    disparity: Entry,
    doffs: Entry,
    image_width: Entry,
    real_width: Entry,
    sigmas: BTreeMap<Field, String>,
    with_uncertainty: bool,
    unknown: Option<(Method, Field)>,
    distance: Entry,
    distance_sigma: String,
}

impl From<StoredInputs> for Inputs {
    fn from(stored: StoredInputs) -> Self {
        let mut entries = Entries::default();
        for (key, entry) in [
            (fields::FOCAL_LENGTH, stored.focal_length),
            (fields::BASELINE, stored.baseline),
            (fields::DISPARITY, stored.disparity),
            (fields::DOFFS, stored.doffs),
            (fields::IMAGE_WIDTH, stored.image_width),
            (fields::REAL_WIDTH, stored.real_width),
            (fields::DISTANCE, stored.distance),
        ] {
            entries.fill(key, entry);
        }
        for (field, sigma) in stored.sigmas {
            entries.entry_mut(field).sigma = sigma;
        }
        entries.entry_mut(fields::DISTANCE).sigma = stored.distance_sigma;
        let mut inputs = Self {
            entries,
            unknown: stored.unknown,
            ..Self::default()
        };
        if !stored.with_uncertainty {
            inputs.drop_hidden_sigmas();
        }
        inputs
    }
}

/// The texts that version 1 kept by the English label of their field: "Tilt of the target", "σ of Height of the camera".
/// Labels that no field has are left out.
pub fn entries(texts: BTreeMap<String, String>) -> Entries {
    let mut entries = Entries::default();
    let labeled = |label: &str| {
        let is_in_form = |key: &Key| key.section.is_some_and(|section| Section::FORM.contains(&section));
        let mut apart_from_the_form = fields::TABLE.iter().filter(|key| !is_in_form(key));
        apart_from_the_form.find(|key| key.name == label).copied()
    };
    for (label, text) in texts {
        if let Some(key) = label.strip_prefix("σ of ").and_then(labeled) {
            entries.entry_mut(key).sigma = text;
        } else if let Some(key) = labeled(&label) {
            entries.entry_mut(key).text = text;
        }
    }
    entries
}

/// The ways that version 1 noted as chosen by their English names: the key of each by that of the field that it is for.
pub fn ways(texts: &BTreeMap<String, String>) -> BTreeMap<String, String> {
    let chosen = |label: &str, ways: &[Way]| {
        let name = texts.get(label)?;
        let way = ways.iter().find(|way| way.name == name);
        // The Q matrix stood beside the ways to a focal length.
        let is_q_matrix = name == "A Q matrix of stereoRectify";
        way.map(|way| way.key).or(is_q_matrix.then_some(fields::Q_MATRIX.as_str()))
    };
    [("way: FocalLength", "fx", FOCAL_LENGTHS), ("way: Disparity", "d", DISPARITIES)]
        .into_iter()
        .filter_map(|(label, key, ways)| Some((key.to_owned(), chosen(label, ways)?.to_owned())))
        .collect()
}
