//! OpenCV: what `stereoCalibrate` and `stereoRectify` give, in FileStorage or in anything else with the same names.
//!
//! Source: the samples of OpenCV, `stereo_calib.cpp`; `P2[0][3] = −fx·b`, in the unit of the board.

use super::matrix::{Projection, how, place_pair, read_matrix, read_projection, scaled, size};
use super::opencv_baseline;
use super::opencv_names::{Matrices, Part, SIZES, TRANSLATIONS, WIDTHS, find, fisheye, parts};
use crate::camera::{Basis, Camera};
use crate::checks::{camera, contradict, read_doffs, resized, unusable};
use crate::format::Format;
use crate::found::Found;
use crate::geometry::length;
use crate::node::Node;
use crate::refusal::Refusal;
use crate::warning::Warning;
use depth_core::quantity::Pixels;

const FORMAT: Format = Format::OpenCv;
type Parts<'a> = [Part<'a>];

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let parts: Vec<Part<'_>> = documents.iter().flat_map(|document| parts(document)).collect();
    let mut found = Found::of(FORMAT);
    let size = read_size(&parts)?;
    let has_p = Matrices::projections(&parts).second.is_some();
    if !read_rectified(&mut found, &parts, size)? && (has_p || !read_q(&mut found, &parts, size)?) {
        read_raw(&mut found, &parts, size)?;
    }
    if found.cameras.len() == 2 && found.pair.is_none() {
        found.pair = Some([0, 1]);
    }
    opencv_baseline::compare(&mut found, &parts)?;
    if let Some(model) = fisheye(&parts) {
        let cameras = found.cameras.iter().map(|camera| camera.name.clone());
        let warnings = cameras.map(|camera| Warning::Fisheye {
            camera,
            model: model.clone(),
        });
        found.warnings.extend(warnings);
    }
    if found.baseline.is_none() && found.cameras.len() == 1 {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
    } else if found.baseline.is_none()
        && found
            .warnings
            .iter()
            .all(|one| matches!(one, Warning::Raw { .. } | Warning::FileOrder | Warning::Fisheye { .. }))
    {
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
    let left = projection(first, &mut found.warnings)?;
    let right = projection(second, &mut found.warnings)?;
    let why = [left, right]
        .into_iter()
        .find_map(|one| scaled(one).or_else(|| unusable(one.pinhole, size)));
    if let Some(why) = why {
        found.warnings.push(Warning::RectificationUnusable { why });
        return Ok(false);
    }
    let raw = Matrices::cameras(parts)
        .first
        .map(|part| part.node.array::<9>(FORMAT, "the camera matrix", "9"))
        .transpose()?;
    let raw = raw.map(|raw| read_matrix(raw, &first.origin(), &mut Vec::new()));
    if raw.is_some_and(|raw| contradict(left.pinhole, raw)) {
        let why = "its focal length is many times that of the camera".to_owned();
        found.warnings.push(Warning::RectificationUnusable { why });
        return Ok(false);
    }
    let size = size.filter(|size| {
        let ratio = raw.and_then(|raw| resized(left.pinhole, raw, *size));
        found.warnings.extend(ratio.map(|ratio| Warning::RectifiedSize {
            camera: "first".to_owned(),
            size: *size,
            ratio,
        }));
        ratio.is_none()
    });
    let cameras = [("first", left, first), ("second", right, second)];
    let distortions = Matrices::distortions(parts);
    for ((name, projection, part), distortion) in cameras.into_iter().zip([distortions.first, distortions.second]) {
        let place = (size, Basis::Rectified, part.origin());
        found.cameras.push(Camera {
            distortion: Node::coefficients(distortion.map(|part| part.node), FORMAT),
            ..camera(FORMAT, name, projection.pinhole, place)?
        });
    }
    // Without the last column of P only T says how far they are apart.
    let is_cut = first.node.numbers(FORMAT, "P1")?.len() == 9 || second.node.numbers(FORMAT, "P2")?.len() == 9;
    if is_cut {
        found.pair = Some([0, 1]);
        read_translation(found, parts)?;
    } else {
        let value = place_pair(found, [0, 1], left.to(right));
        let baseline = (value > 0.0).then(|| opencv_baseline::in_units(value, parts));
        found.measure(baseline, second.node.place.origin(how([&first.name, &second.name], [left, right])));
    }
    read_doffs(found, None);
    Ok(true)
}

/// P is 3 × 4, and without its last column where somebody cut it off.
fn projection(part: &Part<'_>, warnings: &mut Vec<Warning>) -> Result<Projection, Refusal> {
    if part.node.numbers(FORMAT, &part.name)?.len() == 9 {
        let [fx, s, cx, a, fy, cy, b, c, d] = part.node.array(FORMAT, &part.name, "9")?;
        return Ok(Projection::new([fx, s, cx, 0.0, a, fy, cy, 0.0, b, c, d, 0.0]));
    }
    let projection = part.node.array(FORMAT, &part.name, "12")?;
    Ok(read_projection(projection, &part.origin(), warnings))
}

/// Reads Q, where there is no P. Returns whether it can be used.
fn read_q(found: &mut Found, parts: &Parts<'_>, size: Option<[u32; 2]>) -> Result<bool, Refusal> {
    let Some((part, q)) = opencv_baseline::q(parts)? else {
        return Ok(false);
    };
    let [f, cx, cy] = [q.focal_length, q.cx, q.cy].map(Pixels::px);
    // The first camera is the right one where they are swapped; in Q, doffs is that of the second camera all the same.
    let pinholes = [[f, f, cx, cy], [f, f, cx + q.doffs.px(), cy]];
    if let Some(why) = pinholes.into_iter().find_map(|pinhole| unusable(pinhole, size)) {
        found.warnings.push(Warning::RectificationUnusable { why });
        return Ok(false);
    }
    for (name, pinhole) in ["first", "second"].into_iter().zip(pinholes) {
        let place = (size, Basis::Rectified, part.origin());
        found.cameras.push(camera(FORMAT, name, pinhole, place)?);
    }
    let along = if q.swapped { -q.baseline } else { q.baseline };
    let value = place_pair(found, [0, 1], [along, 0.0]);
    let baseline = (value.is_finite() && value > 0.0).then(|| opencv_baseline::in_units(value, parts));
    found.measure(baseline, part.node.place.origin(format!("1 / {}[3][2]", part.name)));
    let sign = if q.swapped { -1.0 } else { 1.0 };
    let doffs = part.node.place.origin(format!("{0}[3][3] / {0}[3][2]", part.name));
    read_doffs(found, Some((sign * q.doffs.px() + 0.0, doffs)));
    Ok(true)
}

/// Reads M1 and M2, or the one camera matrix of each file, and T.
fn read_raw(found: &mut Found, parts: &Parts<'_>, size: Option<[u32; 2]>) -> Result<(), Refusal> {
    let matrices = Matrices::cameras(parts);
    if matrices.first.is_none() {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "camera matrix: give the file of the intrinsics as well",
        });
    }
    if let (Some(first), Some(second)) = (matrices.first, matrices.second) {
        let distortions = Matrices::distortions(parts);
        let first = read_camera(("first", first), distortions.first, size, &mut found.warnings)?;
        found.cameras.push(first);
        let second = read_camera(("second", second), distortions.second, size, &mut found.warnings)?;
        found.cameras.push(second);
    } else {
        read_singles(found, parts, size)?;
    }
    if found.cameras.len() == 2 {
        found.warnings.push(Warning::Raw { format: FORMAT });
        read_translation(found, parts)?;
    }
    Ok(())
}

/// Reads the files of single cameras, each with its own size.
fn read_singles(found: &mut Found, parts: &Parts<'_>, size: Option<[u32; 2]>) -> Result<(), Refusal> {
    let files = parts.chunk_by(|one, other| one.node.place.file == other.node.place.file);
    let with_camera = files.filter_map(|parts| Some((parts, Matrices::cameras(parts).first?)));
    let singles: Vec<(&Parts<'_>, &Part<'_>)> = with_camera.collect();
    if singles.len() == 2 {
        found.warnings.push(Warning::FileOrder);
    }
    for (at, (parts, matrix)) in singles.iter().enumerate() {
        let name = match (singles.len(), at) {
            (1, _) => "camera".to_owned(),
            (2, 0) => "first".to_owned(),
            (2, _) => "second".to_owned(),
            _ => format!("camera {}", at + 1),
        };
        let distortion = Matrices::distortions(parts).first;
        let size = read_size(parts)?.or(size);
        let camera = read_camera((&name, matrix), distortion, size, &mut found.warnings)?;
        found.add(camera)?;
    }
    Ok(())
}

fn read_camera(
    (name, part): (&str, &Part<'_>),
    distortion: Option<&Part<'_>>,
    size: Option<[u32; 2]>,
    warnings: &mut Vec<Warning>,
) -> Result<Camera, Refusal> {
    let matrix = part.node.array(FORMAT, "the camera matrix", "9")?;
    let matrix = read_matrix(matrix, &part.origin(), warnings);
    Ok(Camera {
        distortion: Node::coefficients(distortion.map(|part| part.node), FORMAT),
        ..camera(FORMAT, name, matrix, (size, Basis::Raw, part.origin()))?
    })
}

/// Reads T, which leads from the first camera to the second: −b along the row.
fn read_translation(found: &mut Found, parts: &Parts<'_>) -> Result<(), Refusal> {
    if let Some(part) = find(parts, &TRANSLATIONS) {
        let [x, y, z]: [f64; 3] = part.node.array(FORMAT, "T", "3")?;
        place_pair(found, [0, 1], [-x, -y]);
        let value = length([x, y, z]);
        let baseline = (value > 0.0).then(|| opencv_baseline::in_units(value, parts));
        found.measure(baseline, part.node.place.origin(format!("|{}|", part.name)));
    }
    Ok(())
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
