//! KITTI: calib.txt of the odometry benchmark and calib_cam_to_cam.txt of the raw data. Meters.
//!
//! Source: Geiger et al.: Vision meets robotics, 2013: `P_rect(i)[0][3]` = −f·b(i), with b(i) from camera 0.

use super::matrix::{Projection, how, place_pair, size};
use crate::checks::{camera, in_meters, read_doffs};
use crate::format::Format;
use crate::found::{Basis, Found, Warning};
use crate::number::numbers;
use crate::place::Place;
use crate::refusal::Refusal;
use crate::text::{Line, lines};

const FORMAT: Format = Format::Kitti;

/// Whether a line is a projection matrix: `P0:`, `P_rect_02:`, or two lines and more of twelve numbers without a name.
pub(crate) fn is_kitti(text: &str) -> bool {
    let has_names = lines(text).any(|line| named(line).is_some());
    let is_row = |line: Line<'_>| numbers(line.text).is_some_and(|row| row.len() == 12);
    let mut all = lines(text);
    has_names || (all.clone().count() >= 2 && all.all(is_row))
}

/// The number of the camera that a projection matrix is of, and what comes behind the colon.
fn named(line: Line<'_>) -> Option<(&str, &str)> {
    let (key, values) = line.text.split_once(':')?;
    let number = key.strip_prefix("P_rect_").or_else(|| key.strip_prefix('P'))?;
    let is_number = !number.is_empty() && number.chars().all(|one| one.is_ascii_digit());
    let begins = values.trim_start().starts_with(|one: char| one.is_ascii_digit() || one == '-');
    (is_number && begins).then_some((number, values))
}

pub(super) fn read(text: &str) -> Result<Found, Refusal> {
    let mut rows: Vec<(String, Projection, Place)> = Vec::new();
    for line in lines(text) {
        if let Some((number, values)) = named(line) {
            let name = format!("P{number}");
            let row = line.array(values, FORMAT, &name, "12")?;
            rows.push((number.to_owned(), Projection::new(row), line.place));
        }
    }
    if rows.is_empty() {
        for (index, line) in lines(text).enumerate() {
            let row = line.array(line.text, FORMAT, "a row", "12")?;
            rows.push((index.to_string(), Projection::new(row), line.place));
        }
    }
    let mut found = Found::of(FORMAT);
    for (number, projection, line) in &rows {
        let place = (size_of(text, number)?, Basis::Rectified, line.origin(format!("P{number}")));
        found
            .cameras
            .push(camera(FORMAT, &format!("camera {number}"), projection.pinhole, place)?);
    }
    read_pair(&mut found, &rows);
    Ok(found)
}

/// The gray pair, cameras 0 and 1, or the color pair, 2 and 3, or the first two.
fn read_pair(found: &mut Found, rows: &[(String, Projection, Place)]) {
    let place = |wanted: u32| rows.iter().position(|(number, ..)| number.parse() == Ok(wanted));
    let pairs = [(0, 1), (2, 3), (101, 103)];
    let named = pairs.into_iter().find_map(|(left, right)| Some([place(left)?, place(right)?]));
    let Some(pair) = named.or((rows.len() >= 2).then_some([0, 1])) else {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
        return;
    };
    let [first, second] = pair.map(|at| rows.get(at));
    let (Some((first, left, _)), Some((second, right, place))) = (first, second) else {
        return;
    };
    let length = place_pair(found, pair, left.to(*right));
    if length > 0.0 {
        let baseline = in_meters(length, &mut found.warnings);
        let names = [first, second].map(|number| format!("P{number}"));
        found.measure(baseline, place.origin(how(names.each_ref().map(String::as_str), [*left, *right])));
        read_doffs(found, None);
    }
    if rows.len() > 2 {
        let names = pair.map(|at| rows.get(at).map(|(number, ..)| number.clone()).unwrap_or_default());
        found.warnings.push(Warning::Many {
            cameras: rows.len(),
            pair: Some(names),
        });
    }
}

/// The size of the rectified images of a camera.
fn size_of(text: &str, number: &str) -> Result<Option<[u32; 2]>, Refusal> {
    let name = format!("S_rect_{number}:");
    let line = lines(text).find(|line| line.text.starts_with(&name));
    line.map_or(Ok(None), |line| {
        let values = line.text.get(name.len()..).unwrap_or_default();
        Ok(size(line.array(values, FORMAT, "S_rect", "2")?))
    })
}
