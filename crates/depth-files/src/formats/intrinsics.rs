//! fx, fy, cx and cy under their names, as Open3D, RealSense, ARKit and people themselves write them, of one camera or of several; also a
//! camera matrix column by column.
//!
//! Source: Open3D, `PinholeCameraIntrinsic::ConvertToJsonValue`: `intrinsic_matrix` is in column-major order. librealsense, `rs_types.h`:
//! `rs2_intrinsics` has fx, fy, ppx and ppy. ARKit, `ARCamera.intrinsics`: a `simd_float3x3`, whose columns follow each other.

use super::baseline::{bare, with_unit};
use super::intrinsics_names::{CX, CY, FOCALS, FX, FY, PRINCIPALS, columns, get, has_focal, size_of};
use super::matrix::place_pair;
use super::opencv_names::{Part, TRANSLATIONS, find, has_matrix, parts};
use crate::camera::{Basis, Camera};
use crate::checks::{Pinhole, camera, read_doffs};
use crate::format::Format;
use crate::found::Found;
use crate::geometry::length;
use crate::node::Node;
use crate::place::Origin;
use crate::refusal::Refusal;
use crate::units::in_file_units;
use crate::warning::Warning;

const FORMAT: Format = Format::Intrinsics;
/// So many cameras are listed: a file of all pictures of a scan has thousands, most of them alike.
const MOST_CAMERAS: usize = 100;
const DISTORTIONS: [&str; 6] = [
    "coeffs",
    "distortion",
    "distortioncoefficients",
    "distcoeffs",
    "distortioncoeffs",
    "d",
];

/// A map with a camera in it, the one around it, and what it is called there.
#[derive(Clone, Copy)]
struct Spot<'a> {
    name: &'a str,
    node: &'a Node,
    around: &'a Node,
}

/// Whether there is a camera matrix column by column in it, however deep, or a focal length, which does not count beside a matrix of OpenCV.
pub(super) fn is_intrinsics(document: &Node) -> bool {
    let spots = spots(document);
    let has_columns = || spots.iter().any(|spot| columns(spot.node).is_some());
    !spots.is_empty() && (!has_matrix(document) || has_columns())
}

fn spots(document: &Node) -> Vec<Spot<'_>> {
    let mut all = Vec::new();
    collect("camera", document, document, &mut all);
    all
}

fn collect<'a>(name: &'a str, node: &'a Node, around: &'a Node, all: &mut Vec<Spot<'a>>) {
    if has_focal(node) || columns(node).is_some() {
        all.push(Spot { name, node, around });
        return;
    }
    for (key, part) in node.entries() {
        // What the camera is called stands around its intrinsics.
        let is_kind = key.to_ascii_lowercase().contains("intrinsic") || key.eq_ignore_ascii_case("focalLength");
        collect(if is_kind { name } else { key }, part, node, all);
    }
    for part in node.items() {
        collect(name, part, node, all);
    }
}

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let parts: Vec<Part<'_>> = documents.iter().flat_map(|document| parts(document)).collect();
    let mut found = Found::of(FORMAT);
    for spot in documents.iter().flat_map(|document| spots(document)) {
        let (camera, is_centered) = read_camera(spot, documents)?;
        let is_same = |other: &Camera| {
            let numbers = |one: &Camera| [one.fx, one.fy, one.cx, one.cy];
            numbers(other) == numbers(&camera) && other.size == camera.size
        };
        // The left and the right camera both count, be they alike or not.
        let is_new = side(&camera.name).is_some() || !found.cameras.iter().any(is_same);
        if found.cameras.len() < MOST_CAMERAS && is_new {
            if is_centered {
                let camera = camera.name.clone();
                found.warnings.push(Warning::NoPrincipalPoint { camera });
            }
            found.cameras.push(camera);
        }
    }
    let sided = |wanted: Side| found.cameras.iter().position(|camera| side(&camera.name) == Some(wanted));
    found.pair = sided(Side::Left).zip(sided(Side::Right)).map(|(left, right)| [left, right]);
    read_stereo(&mut found, &parts)?;
    found.tell_apart();
    Ok(found)
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Side {
    Left,
    Right,
}

/// Which of a pair a camera is, by its name: `left`, `cam0`, `infrared_1`.
fn side(name: &str) -> Option<Side> {
    let name: String = name.to_ascii_lowercase().chars().filter(|one| !"_-. ".contains(*one)).collect();
    let stem = name.trim_start_matches("camera").trim_start_matches("cam");
    if stem.contains("left") || ["l", "0", "infrared1", "infra1"].contains(&stem) {
        Some(Side::Left)
    } else {
        let is_right = stem.contains("right") || ["r", "1", "infrared2", "infra2"].contains(&stem);
        is_right.then_some(Side::Right)
    }
}

/// A camera, and whether its principal point is only the center.
fn read_camera(spot: Spot<'_>, documents: &[&Node]) -> Result<(Camera, bool), Refusal> {
    let Spot { name, node, around } = spot;
    let size = [node, around].iter().chain(documents).find_map(|node| size_of(node));
    let (pinhole, origin, is_centered) = match columns(node) {
        Some((key, pinhole, matrix)) => {
            let origin = matrix.place.origin(format!("{key}, column by column"));
            (pinhole, origin, false)
        }
        None => by_names(spot, size)?,
    };
    let listed = get(node, &DISTORTIONS).or_else(|| get(around, &DISTORTIONS));
    let model = get(node, &["model", "distortionmodel", "cameramodel"]).and_then(|(_, node)| node.text());
    let camera = Camera {
        distortion: Node::coefficients(listed.map(|(_, node)| node), FORMAT),
        model: model.map(str::to_owned),
        ..camera(FORMAT, name, pinhole, (size, Basis::Raw, origin))?
    };
    Ok((camera, is_centered))
}

/// fx and fy, or one f for both; cx and cy, and where there are none those of the center, which is then said.
fn by_names(spot: Spot<'_>, size: Option<[u32; 2]>) -> Result<(Pinhole, Origin, bool), Refusal> {
    let Spot { node, around, .. } = spot;
    // The principal point may stand in a map of its own, beside that of the focal length.
    let beside = || around.entries().map(|(_, part)| part);
    let nodes = || [node, around].into_iter().chain(beside());
    let find = |names: &[&str]| nodes().find_map(|node| get(node, names));
    let missing = |what| Refusal::Missing { format: FORMAT, what };
    let (key, part) = get(node, &FX).or_else(|| get(node, &FOCALS)).ok_or(missing("fx"))?;
    let (focal, mut how) = match part.items() {
        [_, _] => (part.array(FORMAT, key, "2")?, key.to_owned()),
        _ => match get(node, &FY) {
            Some((other, below)) => ([part.number(FORMAT, key)?, below.number(FORMAT, other)?], format!("{key}, {other}")),
            None => ([part.number(FORMAT, key)?; 2], key.to_owned()),
        },
    };
    let (center, is_centered) = match (find(&CX), find(&CY), find(&PRINCIPALS), size) {
        (Some((x, one)), Some((y, other)), ..) => {
            how = format!("{how}, {x}, {y}");
            ([one.number(FORMAT, x)?, other.number(FORMAT, y)?], false)
        }
        (_, _, Some((key, node)), _) => {
            how = format!("{how}, {key}");
            (node.array(FORMAT, key, "2")?, false)
        }
        (.., Some(size)) => {
            how = format!("{how}; cx, cy: half the size");
            (size.map(|side| f64::from(side) / 2.0), true)
        }
        _ => return Err(missing("cx and cy, nor a width and a height, whose halves they are about")),
    };
    let ([fx, fy], [cx, cy]) = (focal, center);
    Ok(([fx, fy, cx, cy], part.place.origin(how), is_centered))
}

/// The baseline, and of which images the numbers are: next to a baseline, without distortion, they are those of rectified images.
fn read_stereo(found: &mut Found, parts: &[Part<'_>]) -> Result<(), Refusal> {
    if let Some((baseline, origin)) = with_unit(parts, FORMAT)? {
        found.measure(Some(baseline), origin);
    } else if let Some((baseline, origin)) = bare(parts, FORMAT, &mut found.warnings)? {
        found.measure(Some(baseline), origin);
    } else if let (Some(pair), Some(part)) = (found.pair, find(parts, &TRANSLATIONS)) {
        let shift @ [x, y, _] = part.node.array(FORMAT, &part.name, "3")?;
        let value = length(shift);
        place_pair(found, pair, [-x, -y]);
        let baseline = (value > 0.0).then(|| in_file_units(value, None));
        found.measure(baseline, part.node.place.origin(format!("|{}|", part.name)));
    }
    if found.baseline.is_none() {
        if found.pair.is_some() && found.warnings.is_empty() {
            found.warnings.push(Warning::NoExtrinsics);
        } else if !found.warnings.contains(&Warning::ZeroBaseline) {
            found.warnings.push(Warning::NoBaseline { format: FORMAT });
        }
        return Ok(());
    }
    if found.cameras.iter().any(|camera| camera.distortion.iter().any(|one| *one != 0.0)) {
        found.warnings.push(Warning::Raw { format: FORMAT });
        return Ok(());
    }
    for camera in &mut found.cameras {
        camera.basis = Basis::Rectified;
    }
    let doffs = find(parts, &["doffs"]).map(|part| Ok((part.node.number(FORMAT, "doffs")?, part.origin())));
    read_doffs(found, doffs.transpose()?);
    Ok(())
}
