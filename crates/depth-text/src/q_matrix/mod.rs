//! A Q matrix as people paste it: printed by numpy or MATLAB, written in a program, cut from OpenCV's YAML, XML or JSON, or
//! sixteen numbers. One scanner takes the numbers behind the name Q; it is no parser of any of these formats.

mod scan;

use crate::assess::Assessment;
use crate::entry::Entry;
use crate::field::Key;
use crate::fields::{BASELINE, CX, CY, DOFFS, FOCAL_LENGTH};
use crate::form::Inputs;
use crate::note::Issue;
use crate::number::{exact, plain};
use depth_core::problem::Method;
use depth_core::q_matrix::{self, StereoGeometry};
use depth_core::quantity::Pixels;
use scan::{Scanned, entries, side_by_side, sixteen, without_comments};

/// Reads the Q matrix in `text`. In a whole calibration file it is the entry named Q.
///
/// # Errors
/// What is wrong with the text, or which entry of the matrix cannot be one of a Q.
pub fn read(text: &str) -> Result<StereoGeometry, Issue> {
    // Whatever stands for a minus in what was copied from a document.
    let text = text.replace(['−', '–', '—', '‐', '‑', '﹣', '－'], "-");
    let text = without_comments(&text);
    let entries = entries(&text)?;
    let side_by_side = side_by_side(entries);
    let entries = side_by_side.as_deref().unwrap_or(entries);
    let Scanned { numbers, factor } = sixteen(entries)?;
    let mut matrix = [[0.0; 4]; 4];
    for (slot, (number, _)) in matrix.iter_mut().flatten().zip(&numbers) {
        *slot = number * factor.unwrap_or(1.0);
    }
    if numbers.len() != 16 {
        return Err(Issue::QMatrixCount { found: numbers.len() });
    }
    let is_rounded = numbers
        .get(W_PER_D)
        .is_some_and(|&(number, unit)| unit / 2.0 > LARGEST_ROUNDING * number.abs());
    if factor.is_some() && is_rounded {
        return Err(Issue::QMatrixRounded);
    }
    q_matrix::read(&matrix).map_err(|wrong| Issue::QMatrixEntry {
        row: wrong.row + 1,
        column: wrong.column + 1,
        expected: wrong.expected,
        found: wrong.found,
    })
}

/// The place of one over the baseline among the sixteen numbers.
const W_PER_D: usize = 14;
/// How far, as a fraction of it, one over the baseline may have been rounded by a factor that all numbers share.
const LARGEST_ROUNDING: f64 = 1e-3;

/// What a Q matrix would hold of the form: its baseline in meters. `None` while focal length, baseline or principal point is
/// missing.
pub fn of_form(assessment: &Assessment) -> Option<StereoGeometry> {
    let problem = &assessment.solution.problem;
    let pixels = |key| assessment.reading(key).map(|reading| Pixels::new(reading.value));
    Some(StereoGeometry {
        focal_length: problem.focal_length_of(Method::Stereo)?.px()?.value,
        baseline: problem.baseline?.value.m(),
        doffs: problem.offset().value,
        cx: pixels(CX)?,
        cy: pixels(CY)?,
        swapped: false,
    })
}

/// The Q matrix of `geometry` as `stereoRectify` makes it, in YAML as OpenCV's `FileStorage` writes and reads it.
pub fn written(geometry: &StereoGeometry) -> Option<String> {
    // OpenCV's own writer puts a point behind every whole number, as its reader makes an integer of what has none.
    let entry = |number: f64| {
        let digits = exact(number);
        if digits.contains(['.', 'e']) { digits } else { digits + "." }
    };
    let rows = q_matrix::of(geometry)?.map(|row| row.map(entry).join(", "));
    let data = rows.join(",\n       ");
    Some(format!(
        "%YAML:1.0\n---\nQ: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: d\n   data: [ {data} ]\n"
    ))
}

/// What of the form is missing for a Q matrix, in reading order.
pub fn missing_for_form(inputs: &Inputs) -> Vec<Key> {
    let needed = [FOCAL_LENGTH, BASELINE, CX, CY].into_iter();
    needed.filter(|&key| inputs.entry(key).is_blank()).collect()
}

/// `inputs` with what the matrix says, its baseline with a unit.
pub fn filled_in(inputs: &Inputs, geometry: &StereoGeometry, baseline: Entry) -> Inputs {
    let mut filled = inputs.clone();
    for (key, value) in [(CX, geometry.cx), (CY, geometry.cy)] {
        filled.fill(key, Entry::new(plain(value.px()), None));
    }
    filled.fill(FOCAL_LENGTH, Entry::new(plain(geometry.focal_length.px()), None));
    filled.fill(BASELINE, baseline);
    let doffs = geometry.doffs.px();
    let doffs = if doffs == 0.0 { String::new() } else { plain(doffs) };
    filled.fill(DOFFS, Entry::new(doffs, None));
    filled
}
