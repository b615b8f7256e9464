//! FoundationStereo and BundleSDF: K.txt, a camera matrix and below it, of a stereo camera, the baseline in meters.
//!
//! Source: the README of FoundationStereo: “the first line is the flattened 1×9 intrinsic matrix, the second line is the baseline (meter)”.

use super::matrix::of_matrix;
use crate::camera::Basis;
use crate::checks::{camera, in_meters};
use crate::format::Format;
use crate::found::Found;
use crate::number::numbers;
use crate::refusal::Refusal;
use crate::text::{Line, lines};
use crate::warning::Warning;

const FORMAT: Format = Format::FoundationStereo;
/// A file with more lines is another.
const MOST_ROWS: usize = 20;

/// Whether there are only numbers, of which the first nine, in one line or in three, are a camera matrix. A list of JSON is none, what NumPy
/// prints is one.
pub(crate) fn is_foundation_stereo(text: &str) -> bool {
    let is_json = text.trim_start().starts_with('[') && text.contains(',');
    let rows = rows(text);
    if rows.len() > MOST_ROWS {
        return false;
    }
    let all: Option<Vec<Vec<f64>>> = rows.iter().map(|line| numbers(line.text)).collect();
    let Some(all) = all.filter(|_| !is_json) else { return false };
    let first: Vec<f64> = match all.as_slice() {
        [first, ..] if first.len() == 9 => first.clone(),
        [a, b, c, ..] if [a, b, c].iter().all(|row| row.len() == 3) => [a.as_slice(), b, c].concat(),
        _ => return false,
    };
    matches!(first.as_slice(), [fx, _, _, zero, fy, _, a, b, one]
        if [*zero, *a, *b, *one] == [0.0, 0.0, 0.0, 1.0] && fx.abs() > 1.0 && fy.abs() > 1.0)
}

/// The lines that are no remark: no more than are needed to see that there are too many.
fn rows(text: &str) -> Vec<Line<'_>> {
    let all = lines(text).filter(|line| !line.text.starts_with('#'));
    all.take(MOST_ROWS + 1).collect()
}

pub(super) fn read(text: &str) -> Result<Found, Refusal> {
    let rows = rows(text);
    let mut found = Found::of(FORMAT);
    let Some(first) = rows.first() else { return Err(Refusal::Empty) };
    let is_one_line = numbers(first.text).is_some_and(|row| row.len() == 9);
    let (matrix, rest) = rows.split_at_checked(if is_one_line { 1 } else { 3 }).unwrap_or((&rows, &[]));
    let matrix: Vec<&str> = matrix.iter().map(|line| line.text).collect();
    let pinhole = of_matrix(first.array(&matrix.join(" "), FORMAT, "K", "9")?);
    // What follows K are images of a rectified pair.
    let basis = if rest.is_empty() { Basis::Raw } else { Basis::Rectified };
    found
        .cameras
        .push(camera(FORMAT, "camera", pinhole, (None, basis, first.place.origin("K")))?);
    match rest {
        [] => found.warnings.push(Warning::NoBaseline { format: FORMAT }),
        [line] => {
            let [meters] = line.array(line.text, FORMAT, "the baseline", "1")?;
            if meters < 0.0 {
                found.warnings.push(Warning::NegativeBaseline);
            }
            let baseline = in_meters(meters.abs(), &mut found.warnings);
            found.measure(baseline, line.place.origin("baseline, the line below K"));
        }
        [line, ..] => {
            let all: Vec<&str> = rest.iter().map(|line| line.text).collect();
            let [_] = line.array(&all.join(" "), FORMAT, "what stands below K", "1, the baseline")?;
        }
    }
    Ok(found)
}
