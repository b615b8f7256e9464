//! KITTI: calib.txt of the odometry benchmark and calib_cam_to_cam.txt of the raw data. Meters.
//!
//! Source: Geiger et al.: Vision meets robotics, 2013: `P_rect(i)[0][3]` = −f·b(i), with b(i) from camera 0.

use super::kitti_extrinsics::Extrinsics;
use super::matrix::{Projection, how, place_pair, size};
use crate::camera::Basis;
use crate::checks::{agree, camera, in_meters, read_doffs, same_length};
use crate::format::Format;
use crate::found::Found;
use crate::geometry::{Vector, distance};
use crate::number::first_numbers;
use crate::place::{Origin, Place};
use crate::refusal::Refusal;
use crate::text::{Line, lines};
use crate::warning::Warning;
use std::collections::HashMap;

const FORMAT: Format = Format::Kitti;
/// KITTI has four.
const MOST_CAMERAS: usize = 12;

/// Whether a line is a projection matrix: `P0:`, `P_rect_02:`, or two lines and more of twelve numbers without a name.
pub(crate) fn is_kitti(text: &str) -> bool {
    let has_names = lines(text).any(|line| named(line).is_some());
    let is_row = |line: Line<'_>| first_numbers::<0>(line.text).is_some_and(|(count, _)| count == 12);
    let mut all = lines(text);
    has_names || (all.clone().count() >= 2 && all.all(is_row))
}

/// A projection matrix.
struct Row {
    /// The number of the camera, as the file writes it.
    number: String,
    /// What the file calls the matrix.
    name: String,
    projection: Projection,
    place: Place,
    /// Where the camera was measured to stand.
    station: Option<(Vector, Origin)>,
}

/// What a projection matrix is called, the number of its camera, and what comes behind the colon.
fn named(line: Line<'_>) -> Option<[&str; 3]> {
    let (key, values) = line.text.split_once(':')?;
    let number = key.strip_prefix("P_rect_").or_else(|| key.strip_prefix('P'))?;
    let is_number = !number.is_empty() && number.chars().all(|one| one.is_ascii_digit());
    let begins = values.trim_start().starts_with(|one: char| one.is_ascii_digit() || one == '-');
    (is_number && begins).then_some([key, number, values])
}

pub(super) fn read(text: &str) -> Result<Found, Refusal> {
    let sizes = sizes(text);
    let extrinsics = Extrinsics::read(text)?;
    let mut rows: Vec<Row> = Vec::new();
    let mut found = Found::of(FORMAT);
    let has_names = lines(text).any(|line| named(line).is_some());
    for (index, line) in lines(text).enumerate() {
        let number = index.to_string();
        let row = format!("row {}", index + 1);
        let [name, number, values] = match named(line) {
            Some(named) => named,
            None if has_names => continue,
            None => [&row, &number, line.text],
        };
        let matrix = line.array(values, FORMAT, name, "12")?;
        let projection = Projection::new(matrix);
        let [.., last, _] = matrix;
        if (last - 1.0).abs() > 1e-6 {
            let (name, place) = (name.to_owned(), line.place);
            return Err(Refusal::NotQ {
                format: FORMAT,
                name,
                place,
                entry: [2, 2],
                found: last,
            });
        }
        let size = match sizes.get(number) {
            Some((line, values)) => size(line.array(values, FORMAT, "S_rect", "2")?),
            None => None,
        };
        let place = (size, Basis::Rectified, line.place.origin(name));
        found.add(camera(FORMAT, &format!("camera {number}"), projection.pinhole, place)?)?;
        rows.push(Row {
            station: extrinsics.station(number),
            number: number.to_owned(),
            name: name.to_owned(),
            projection,
            place: line.place,
        });
    }
    read_pairs(&mut found, &rows)?;
    found.warnings.extend(extrinsics.outside());
    Ok(found)
}

/// The gray pair, cameras 0 and 1, the color pair, 2 and 3, or the first two; then all others that stand apart.
fn read_pairs(found: &mut Found, rows: &[Row]) -> Result<(), Refusal> {
    let place = |wanted: u32| rows.iter().position(|row| row.number.parse() == Ok(wanted));
    let pairs = [(0, 1), (2, 3), (101, 103)];
    let named = pairs.into_iter().filter_map(|(left, right)| Some([place(left)?, place(right)?]));
    let mut pairs: Vec<[usize; 2]> = named.collect();
    // Many rows are hostile; their pairs need not be listed.
    let count = rows.len().min(MOST_CAMERAS);
    let others = (0..count).flat_map(|first| (first + 1..count).map(move |second| [first, second]));
    for pair in others {
        if !pairs.contains(&pair) {
            pairs.push(pair);
        }
    }
    for (at, pair) in pairs.into_iter().enumerate() {
        let [Some(left), Some(right)] = pair.map(|at| rows.get(at)) else {
            continue;
        };
        // Cameras at the same place are no pair; of the first that is said.
        if at == 0 || left.projection.to(right.projection) != [0.0; 2] {
            found.pair_up(pair, |two| {
                measure(two, left, right);
                Ok(())
            })?;
        }
    }
    found.take_first_pair();
    if found.pairs.is_empty() {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
    }
    Ok(())
}

fn measure(two: &mut Found, left: &Row, right: &Row) {
    let projections = [left.projection, right.projection];
    let length = place_pair(two, [0, 1], left.projection.to(right.projection));
    if length > 0.0 {
        let of_p = (length, right.place.origin(how([&left.name, &right.name], projections)));
        // What was measured does not depend on the size of the images, to which somebody may have scaled a part of P.
        let (length, origin) = match measured(left, right) {
            Some(of_t) if !agree(of_t.0, of_p.0) => {
                two.warnings.extend(same_length((of_t.0, &of_t.1), (of_p.0, &of_p.1)));
                of_t
            }
            _ => of_p,
        };
        let baseline = in_meters(length, &mut two.warnings);
        two.measure(baseline, origin);
        read_doffs(two, None);
    }
}

/// How far the cameras are apart by what was measured of them, and where that stands.
fn measured(left: &Row, right: &Row) -> Option<(f64, Origin)> {
    let ((one, first), (other, second)) = (left.station.as_ref()?, right.station.as_ref()?);
    let length = distance(*one, *other);
    let how = format!("distance by {} and {}", first.how, second.how);
    (length > 0.0 && length.is_finite()).then(|| (length, second.place().origin(how)))
}

/// The lines with the sizes of the rectified images, by the numbers of the cameras.
fn sizes(text: &str) -> HashMap<&str, (Line<'_>, &str)> {
    let mut all = HashMap::new();
    for line in lines(text) {
        if let Some((number, values)) = line.text.strip_prefix("S_rect_").and_then(|rest| rest.split_once(':')) {
            all.entry(number).or_insert((line, values));
        }
    }
    all
}
