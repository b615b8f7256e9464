//! Kalibr: camchain.yaml, also as OpenVINS has it. Meters.
//!
//! Source: the Kalibr wiki, “Yaml formats”: `T_cn_cnm1` leads from the camera before to this one, `T_cam_imu` from the IMU to the camera.

use super::matrix::size;
use crate::checks::{camera, in_meters};
use crate::format::Format;
use crate::found::{Basis, Camera, Found, Warning};
use crate::geometry::{Transform, Vector, distance, length};
use crate::node::Node;
use crate::place::Origin;
use crate::refusal::Refusal;

const FORMAT: Format = Format::Kalibr;

/// The cameras of a chain: `cam0`, `cam1` and so on, with their names.
pub(super) fn cameras(document: &Node) -> impl Iterator<Item = (&str, &Node)> {
    document.entries().filter(|(name, node)| {
        let number = name.strip_prefix("cam").unwrap_or_default();
        let is_numbered = !number.is_empty() && number.chars().all(|one| one.is_ascii_digit());
        is_numbered && (node.get("intrinsics").is_some() || node.get("T_cn_cnm1").is_some())
    })
}

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let mut all: Vec<(&str, &Node)> = documents.iter().flat_map(|document| cameras(document)).collect();
    all.sort_by_key(|(name, _)| name.trim_start_matches("cam").parse::<u32>().ok());
    let mut found = Found::of(FORMAT);
    for (name, node) in &all {
        found.cameras.push(read_camera(name, node, &mut found.warnings)?);
    }
    if let [(_, first), (_, second), ..] = all.as_slice() {
        found.pair = Some([0, 1]);
        found.warnings.push(Warning::Raw { format: FORMAT });
        read_baseline(&mut found, first, second)?;
        if all.len() > 2 {
            found.warnings.push(Warning::Many {
                cameras: all.len(),
                pair: match all.as_slice() {
                    [(first, _), (second, _), ..] => Some([(*first).to_owned(), (*second).to_owned()]),
                    _ => None,
                },
            });
        }
    } else {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
    }
    Ok(found)
}

fn read_camera(name: &str, node: &Node, warnings: &mut Vec<Warning>) -> Result<Camera, Refusal> {
    let text = |key: &str| node.get(key).and_then(Node::text).unwrap_or_default().to_owned();
    let model = text("camera_model");
    if !["", "pinhole"].contains(&model.as_str()) {
        return Err(Refusal::NotPinhole {
            format: FORMAT,
            model,
            place: node.place,
        });
    }
    let distortion = text("distortion_model");
    if ["equidistant", "fov"].contains(&distortion.as_str()) {
        warnings.push(Warning::Fisheye {
            camera: name.to_owned(),
            model: distortion.clone(),
        });
    }
    let Some(intrinsics) = node.get("intrinsics") else {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "intrinsics",
        });
    };
    let pinhole = intrinsics.array(FORMAT, "intrinsics", "4")?;
    let size = match node.get("resolution") {
        Some(node) => size(node.array(FORMAT, "resolution", "2")?),
        None => None,
    };
    let origin = intrinsics.place.origin("intrinsics");
    Ok(Camera {
        distortion: Node::coefficients(node.get("distortion_coeffs"), FORMAT),
        model: Some(distortion).filter(|model| !model.is_empty()),
        ..camera(FORMAT, name, pinhole, (size, Basis::Raw, origin))?
    })
}

fn read_baseline(found: &mut Found, first: &Node, second: &Node) -> Result<(), Refusal> {
    let chained = ["T_cn_cnm1", "baseline_last_to_this_cam"];
    if let Some((name, node)) = chained.iter().find_map(|name| second.get(name).map(|node| (*name, node))) {
        let shift = Transform::read(node, FORMAT, name)?.shift;
        let [x, y, _] = shift;
        super::matrix::place_pair(found, [0, 1], [-x, -y]);
        let baseline = in_meters(length(shift), &mut found.warnings);
        found.measure(baseline, node.place.origin(format!("|t| of {name}")));
        return Ok(());
    }
    if let (Some((first, _)), Some((second, origin))) = (place(first)?, place(second)?) {
        let baseline = in_meters(distance(first, second), &mut found.warnings);
        found.measure(baseline, origin);
    } else {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
    }
    Ok(())
}

/// Where a camera is in the frame of the IMU, and how the distance to another follows.
fn place(node: &Node) -> Result<Option<(Vector, Origin)>, Refusal> {
    let origin = |node: &Node, name: &str| node.place.origin(format!("distance between the cameras by {name}"));
    if let Some(node) = node.get("T_imu_cam") {
        return Ok(Some((Transform::read(node, FORMAT, "T_imu_cam")?.shift, origin(node, "T_imu_cam"))));
    }
    if let Some(node) = node.get("T_cam_imu") {
        return Ok(Some((
            Transform::read(node, FORMAT, "T_cam_imu")?.origin(),
            origin(node, "T_cam_imu"),
        )));
    }
    Ok(None)
}
