//! What calibration files fill in beside the options.

use super::calibration::Calibration;
use super::typed::Typed;
use crate::core::setup::{Object, Pair};
use depth_files::{Baseline, Camera, Format, Found, Warning};
use depth_text::field::Key;
use depth_text::fields;
use depth_text::note::Part;

/// Fills in what was not typed of what a calibration says. Returns what is to be said of it. Err: a sentence, where it cannot be read, or
/// the unit of its baseline has to be asked for.
pub(super) fn fill(
    calibration: &Calibration,
    typed: &mut Typed,
    (object, pair): (Object, Pair),
    unknown: Option<Key>,
) -> Result<Vec<String>, String> {
    let found = calibration.found()?;
    let [first, _] = found.pair.unwrap_or([0, 0]).map(|at| found.cameras.get(at));
    let is_stereo = typed.is_given(fields::DISPARITY, Part::Value) || unknown == Some(fields::DISPARITY);
    if is_stereo && found.baseline.is_some() {
        refuse_other_pair(found.is_vertical, pair)?;
    }
    let has_point = [fields::PIXEL_COLUMN, fields::PIXEL_ROW]
        .into_iter()
        .any(|key| typed.is_given(key, Part::Value));
    fill_sigma(typed, first, unknown);
    let mut fill = |key: Key, value: Option<String>| {
        if let Some(value) = value.filter(|_| !typed.is_given(key, Part::Value) && unknown != Some(key)) {
            typed.typed.push((key, Part::Value, value));
        }
    };
    if has_point {
        fill(fields::CX, first.map(|camera| format!("{} px", camera.cx.px())));
        fill(fields::CY, first.map(|camera| format!("{} px", camera.cy.px())));
    }
    fill(fields::FOCAL_LENGTH, first.map(|camera| format!("{} px", camera.fx.px())));
    if object == Object::Height || pair == Pair::Vertical {
        fill(fields::FY, first.map(|camera| format!("{} px", camera.fy.px())));
    }
    let doffs = found.doffs.filter(|doffs| doffs.px() != 0.0);
    fill(fields::DOFFS, doffs.map(|doffs| format!("{} px", doffs.px())));
    let has_doffs = typed.is_given(fields::DOFFS, Part::Value);
    if is_stereo && !typed.is_given(fields::BASELINE, Part::Value) && unknown != Some(fields::BASELINE) {
        match found.baseline.map(|baseline| (baseline, baseline.length(calibration.file_unit))) {
            Some((_, Some(length))) => typed.typed.push((fields::BASELINE, Part::Value, format!("{} m", length.m()))),
            Some((Baseline::InFileUnits { value, guess }, None)) => {
                let question = Warning::UnitUnknown { value, guess };
                return Err(format!(
                    "{question} Say it with --file-unit, such as --file-unit 1mm, or 25mm for squares."
                ));
            }
            _ => {}
        }
    }
    Ok(said(calibration, &found, is_stereo, has_doffs))
}

/// What is to be said of the files where a disparity is in question or is not, and doffs was typed or filled in or was not.
fn said(calibration: &Calibration, found: &Found, is_stereo: bool, has_doffs: bool) -> Vec<String> {
    let [first, _] = found.pair.unwrap_or([0, 0]).map(|at| found.cameras.get(at));
    let mut said: Vec<String> = found
        .warnings
        .iter()
        .filter(|warning| is_said(warning, is_stereo))
        .map(|warning| calibration.sentence(|names| warning.sentence(names)))
        .collect();
    if is_stereo && found.baseline.is_some() && found.doffs.is_none() && !has_doffs {
        said.push(without_doffs(found).to_owned());
    }
    if is_stereo {
        said.extend(calibration.unused_unit(found));
    }
    if let Some(first) = first.filter(|_| found.cameras.len() > 2 || found.cameras.len() == 2 && found.pair.is_none()) {
        said.push(format!(
            "The focal length is that of {}; --camera chooses another, and --fx says one.",
            first.name
        ));
    }
    said
}

/// Fills in how uncertain the focal length is, where it is that of the file and the file says it.
fn fill_sigma(typed: &mut Typed, camera: Option<&Camera>, unknown: Option<Key>) {
    let key = fields::FOCAL_LENGTH;
    let is_typed = [Part::Value, Part::Sigma].into_iter().any(|part| typed.is_given(key, part));
    if let Some([fx, ..]) = camera.and_then(|camera| camera.sigma)
        && !is_typed
        && unknown != Some(key)
    {
        typed.typed.push((key, Part::Sigma, format!("{} px", fx.px())));
    }
}

/// Whether a warning is one of what is calculated.
const fn is_said(warning: &Warning, is_stereo: bool) -> bool {
    match warning {
        Warning::UnitUnknown { .. } | Warning::Vertical => false,
        Warning::NoBaseline { .. } | Warning::NoExtrinsics | Warning::OneOfPair { .. } => is_stereo,
        _ => true,
    }
}

/// What is said where doffs is not in the files.
fn without_doffs(found: &Found) -> &'static str {
    if found.format == Format::Ros && found.cameras.len() == 1 {
        "doffs is not in it and is counted as 0: give the file of the other camera as well, or --doffs."
    } else if found.is_rectified() {
        "doffs is not in it and is counted as 0: give --doffs if you know it."
    } else {
        "The file has no doffs, as it is of raw images: it is counted as 0. Give --doffs of the rectified images."
    }
}

/// Refuses a disparity that is counted along the other side of the image than the cameras stand.
fn refuse_other_pair(is_vertical: bool, pair: Pair) -> Result<(), String> {
    match (is_vertical, pair) {
        (true, Pair::Horizontal) => {
            Err("The cameras of this file stand one above the other: add --pair vertical, and count the disparity in rows.".to_owned())
        }
        (false, Pair::Vertical) => Err("The cameras of this file stand side by side: leave out --pair vertical.".to_owned()),
        _ => Ok(()),
    }
}
