//! OpenCV: what `stereoCalibrate` and `stereoRectify` give, in FileStorage or in anything else with the same names.
//!
//! Source: the samples of OpenCV, `stereo_calib.cpp`; `P2[0][3] = −fx·b`, in the unit of the board.

use super::baseline::{bare, with_unit};
use super::matrix::{Projection, how, of_matrix, place_pair, size};
use super::opencv_names::{Matrices, Part, SIZES, SQUARES, TRANSLATIONS, WIDTHS, find, parts};
use crate::checks::{camera, contradict, in_file_units, read_doffs, unusable};
use crate::format::Format;
use crate::found::{Baseline, Basis, Camera, Found, Warning};
use crate::geometry::length;
use crate::node::Node;
use crate::place::Origin;
use crate::refusal::Refusal;

const FORMAT: Format = Format::OpenCv;
type Parts<'a> = [Part<'a>];

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let parts: Vec<Part<'_>> = documents.iter().flat_map(|document| parts(document)).collect();
    let mut found = Found::of(FORMAT);
    let size = read_size(&parts)?;
    if !read_rectified(&mut found, &parts, size)? {
        read_raw(&mut found, &parts, size)?;
    }
    if found.cameras.len() == 2 && found.pair.is_none() {
        found.pair = Some([0, 1]);
    }
    if let Some((known, origin)) = with_unit(&parts, FORMAT)? {
        found.measure(Some(known), origin);
    } else if let Some((baseline, origin)) = bare_baseline(&mut found, &parts)? {
        found.measure(Some(baseline), origin);
    } else if found.baseline.is_none() && found.cameras.len() == 1 {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
    } else if found.baseline.is_none() && found.warnings.iter().all(|one| matches!(one, Warning::Raw { .. })) {
        found.warnings.push(Warning::NoExtrinsics);
    }
    Ok(found)
}

/// Reads P1 and P2. Returns whether they can be used.
fn read_rectified(found: &mut Found, parts: &Parts<'_>, size: Option<[u32; 2]>) -> Result<bool, Refusal> {
    let Matrices {
        first: Some(first),
        second: Some(second),
    } = Matrices::projections(parts)
    else {
        return Ok(false);
    };
    let [left, right] = [projection(first.node, "P1")?, projection(second.node, "P2")?];
    if let Some(why) = unusable(left.pinhole, size).or_else(|| unusable(right.pinhole, size)) {
        found.warnings.push(Warning::RectificationUnusable { why });
        return Ok(false);
    }
    let raw = Matrices::cameras(parts)
        .first
        .map(|part| part.node.array::<9>(FORMAT, "the camera matrix", "9"))
        .transpose()?;
    if raw.is_some_and(|raw| contradict(left.pinhole, of_matrix(raw))) {
        let why = "its focal length is many times that of the camera".to_owned();
        found.warnings.push(Warning::RectificationUnusable { why });
        return Ok(false);
    }
    let cameras = [("first", left, first), ("second", right, second)];
    for (name, projection, part) in cameras {
        let place = (size, Basis::Rectified, part.origin());
        found.cameras.push(camera(FORMAT, name, projection.pinhole, place)?);
    }
    // Without the last column of P only T says how far they are apart.
    let is_cut = first.node.numbers(FORMAT, "P1")?.len() == 9 || second.node.numbers(FORMAT, "P2")?.len() == 9;
    if is_cut {
        found.pair = Some([0, 1]);
        read_translation(found, parts)?;
    } else {
        let value = place_pair(found, [0, 1], left.to(right));
        let baseline = (value > 0.0).then(|| in_file_units(value, square(parts)));
        found.measure(baseline, second.node.place.origin(how([&first.name, &second.name], [left, right])));
    }
    read_doffs(found, None);
    Ok(true)
}

/// P is 3 × 4, and without its last column where somebody cut it off.
fn projection(node: &Node, name: &str) -> Result<Projection, Refusal> {
    if node.numbers(FORMAT, name)?.len() == 9 {
        let [fx, s, cx, a, fy, cy, b, c, d] = node.array(FORMAT, name, "9")?;
        return Ok(Projection::new([fx, s, cx, 0.0, a, fy, cy, 0.0, b, c, d, 0.0]));
    }
    Ok(Projection::new(node.array(FORMAT, name, "12")?))
}

/// Reads M1 and M2, or the one camera matrix, and T.
fn read_raw(found: &mut Found, parts: &Parts<'_>, size: Option<[u32; 2]>) -> Result<(), Refusal> {
    let matrices = Matrices::cameras(parts);
    let distortions = Matrices::distortions(parts);
    let read = |name: &str, part: &Part<'_>, distortion: Option<&Part<'_>>| -> Result<Camera, Refusal> {
        let matrix = of_matrix(part.node.array(FORMAT, "the camera matrix", "9")?);
        Ok(Camera {
            distortion: Node::coefficients(distortion.map(|part| part.node), FORMAT),
            ..camera(FORMAT, name, matrix, (size, Basis::Raw, part.origin()))?
        })
    };
    let (Some(first), second) = (matrices.first, matrices.second) else {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "camera matrix: give the file of the intrinsics as well",
        });
    };
    let name = if second.is_some() { "first" } else { "camera" };
    found.cameras.push(read(name, first, distortions.first)?);
    if let Some(second) = second {
        found.cameras.push(read("second", second, distortions.second)?);
        found.warnings.push(Warning::Raw { format: FORMAT });
    }
    if second.is_some() {
        read_translation(found, parts)?;
    }
    Ok(())
}

/// Reads T, which leads from the first camera to the second: −b along the row.
fn read_translation(found: &mut Found, parts: &Parts<'_>) -> Result<(), Refusal> {
    if let Some(part) = find(parts, &TRANSLATIONS) {
        let [x, y, z]: [f64; 3] = part.node.array(FORMAT, "T", "3")?;
        place_pair(found, [0, 1], [-x, -y]);
        let value = length([x, y, z]);
        let baseline = (value > 0.0).then(|| in_file_units(value, square(parts)));
        found.measure(baseline, part.node.place.origin(format!("|{}|", part.name)));
    }
    Ok(())
}

/// A baseline without a unit, where no matrix has said one.
fn bare_baseline(found: &mut Found, parts: &Parts<'_>) -> Result<Option<(Baseline, Origin)>, Refusal> {
    if found.baseline.is_some() {
        return Ok(None);
    }
    bare(parts, FORMAT, &mut found.warnings)
}

fn read_size(parts: &Parts<'_>) -> Result<Option<[u32; 2]>, Refusal> {
    for [width, height] in WIDTHS {
        if let (Some(width), Some(height)) = (find(parts, &[width]), find(parts, &[height])) {
            return Ok(size([
                width.node.number(FORMAT, "the width")?,
                height.node.number(FORMAT, "the height")?,
            ]));
        }
    }
    find(parts, &SIZES).map_or(Ok(None), |part| Ok(size(part.node.array(FORMAT, "the size", "2")?)))
}

fn square(parts: &Parts<'_>) -> Option<f64> {
    let numbers = find(parts, &SQUARES)?.node.numbers(FORMAT, "the square").ok()?;
    numbers.first().copied().filter(|size| *size > 0.0)
}
