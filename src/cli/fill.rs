//! What calibration files fill in beside the options.

use super::ascii::in_sentence;
use super::calibration::Calibration;
use super::options::Typed;
use crate::core::setup::{Object, Pair};
use depth_files::{Baseline, Warning};
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
    let pair_of = found.pair.unwrap_or([0, 0]);
    let [left, _] = pair_of.map(|at| found.cameras.get(at));
    let mut fill = |key: Key, value: Option<String>| {
        if let Some(value) = value.filter(|_| !typed.is_given(key, Part::Value) && unknown != Some(key)) {
            typed.typed.push((key, Part::Value, value));
        }
    };
    fill(fields::FOCAL_LENGTH, left.map(|camera| format!("{} px", camera.fx.px())));
    if object == Object::Height || pair == Pair::Vertical {
        fill(fields::FY, left.map(|camera| format!("{} px", camera.fy.px())));
    }
    let doffs = found.doffs.filter(|doffs| doffs.px() != 0.0);
    fill(fields::DOFFS, doffs.map(|doffs| format!("{} px", doffs.px())));
    let is_stereo = typed.is_given(fields::DISPARITY, Part::Value);
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
    let said = found
        .warnings
        .iter()
        .filter(|warning| !matches!(warning, Warning::UnitUnknown { .. }));
    Ok(said.map(|warning| in_sentence(&warning.to_string())).collect())
}
