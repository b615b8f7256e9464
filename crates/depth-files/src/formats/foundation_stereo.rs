//! FoundationStereo and BundleSDF: K.txt, a camera matrix and below it, of a stereo camera, the baseline in meters.
//!
//! Source: the README of FoundationStereo: “the first line is the flattened 1×9 intrinsic matrix, the second line is the baseline (meter)”.

use super::matrix::of_matrix;
use crate::checks::{camera, in_meters};
use crate::format::Format;
use crate::found::{Basis, Found, Warning};
use crate::number::numbers;
use crate::refusal::Refusal;
use crate::text::{Line, lines};

const FORMAT: Format = Format::FoundationStereo;

/// Whether there are only numbers, of which the first nine are a camera matrix.
pub(crate) fn is_foundation_stereo(text: &str) -> bool {
    let rows = rows(text);
    let first: Option<Vec<Vec<f64>>> = rows.iter().take(3).map(|line| numbers(line.text)).collect();
    let is_all_numbers = || rows.iter().all(|line| numbers(line.text).is_some());
    let is_matrix = |first: Vec<Vec<f64>>| matches!(first.concat().as_slice(), [f, _, _, zero, g, _, a, b, one, ..] if is_k([*f, *g], [*zero, *a, *b, *one]));
    first.is_some_and(is_matrix) && is_all_numbers()
}

fn is_k(focal: [f64; 2], rest: [f64; 4]) -> bool {
    rest == [0.0, 0.0, 0.0, 1.0] && focal.iter().all(|one| one.abs() > 1.0)
}

/// The lines that are no remark.
fn rows(text: &str) -> Vec<Line<'_>> {
    lines(text).filter(|line| !line.text.starts_with('#')).collect()
}

pub(super) fn read(text: &str) -> Result<Found, Refusal> {
    let rows = rows(text);
    let mut found = Found::of(FORMAT);
    let Some(first) = rows.first() else { return Err(Refusal::Empty) };
    // In one line, or in three.
    let count = numbers(first.text).map_or(0, |row| row.len());
    let (matrix, rest) = rows.split_at_checked(if count >= 9 { 1 } else { 3 }).unwrap_or((&rows, &[]));
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
