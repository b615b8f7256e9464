//! nerfstudio and instant-ngp: transforms.json. Without a baseline: its poses have a scale of their own.
//!
//! Source: nerfstudio’s documentation, “Data conventions”; instant-ngp, `nerf_loader.cu`: fl = w / (2·tan(angle / 2)), and without cx and cy
//! the center.

use super::matrix::size;
use crate::camera::{Basis, Camera};
use crate::checks::{camera, coefficients};
use crate::format::Format;
use crate::found::Found;
use crate::node::Node;
use crate::refusal::Refusal;
use crate::warning::Warning;

const FORMAT: Format = Format::Transforms;
/// So many cameras are listed, of frames that have each their own.
const MOST_CAMERAS: usize = 100;

pub(super) fn is_transforms(document: &Node) -> bool {
    document.get("frames").is_some() && (has_focal(document) || frames(document).any(has_focal))
}

fn has_focal(node: &Node) -> bool {
    ["fl_x", "camera_angle_x", "camera_angle_y", "fl_y"]
        .iter()
        .any(|key| node.get(key).is_some())
}

fn frames(document: &Node) -> impl Iterator<Item = &Node> {
    document.get("frames").into_iter().flat_map(Node::items)
}

pub(super) fn read(document: &Node) -> Result<Found, Refusal> {
    let mut found = Found::of(FORMAT);
    if has_focal(document) {
        read_camera(&mut found, "camera", [document, document])?;
    } else {
        for (index, frame) in frames(document).enumerate().filter(|(_, frame)| has_focal(frame)) {
            if found.cameras.len() < MOST_CAMERAS {
                read_camera(&mut found, &format!("frame {}", index + 1), [frame, document])?;
            }
        }
    }
    let frames = frames(document).count();
    found
        .ignored
        .push(format!("frames: {frames} poses, in a scale that nothing says in meters"));
    found.warnings.push(Warning::NoBaseline { format: FORMAT });
    Ok(found)
}

/// Adds a camera of a frame, or of all; what the frame does not say is that of the whole.
fn read_camera(found: &mut Found, name: &str, nodes: [&Node; 2]) -> Result<(), Refusal> {
    let get = |key: &str| nodes.iter().find_map(|node| node.get(key));
    let number = |key: &str| get(key).map(|node| node.number(FORMAT, key)).transpose();
    let (width, height) = (number("w")?, number("h")?);
    let focal = |key: &str, angle: &str, side: Option<f64>| match (number(key)?, number(angle)?, side) {
        (Some(focal), ..) => Ok(Some((focal, key.to_owned()))),
        (None, Some(angle_rad), Some(side)) => {
            let how = format!("half the size / tan({angle} / 2)");
            Ok(Some((side / 2.0 / (angle_rad / 2.0).tan(), how)))
        }
        _ => Ok(None),
    };
    let across = focal("fl_x", "camera_angle_x", width)?;
    let down = focal("fl_y", "camera_angle_y", height)?;
    let Some((fx, how)) = across.clone().or_else(|| down.clone()) else {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "w and h: without them its angles are no focal length in pixels. Write the size of the images into it",
        });
    };
    let fy = down.map_or(fx, |(fy, _)| fy);
    let first = ["fl_x", "camera_angle_x", "fl_y", "camera_angle_y"].iter().find_map(|key| get(key));
    let place = first.unwrap_or(nodes[0]).place;
    let size = width.zip(height).and_then(|(width, height)| size([width, height]));
    let half = |side: Option<f64>| side.map(|side| side / 2.0);
    let (Some(cx), Some(cy)) = (number("cx")?.or(half(width)), number("cy")?.or(half(height))) else {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "cx and cy, nor w and h, whose halves they are about",
        });
    };
    let model = get("camera_model").and_then(Node::text);
    if let Some(model) = model.filter(|model| !["OPENCV", "PINHOLE", "SIMPLE_PINHOLE", "SIMPLE_RADIAL", "RADIAL"].contains(model)) {
        if !model.contains("FISHEYE") {
            return Err(Refusal::NotPinhole {
                format: FORMAT,
                model: model.to_owned(),
                place,
            });
        }
        found.warnings.push(Warning::Fisheye {
            camera: name.to_owned(),
            model: model.to_owned(),
        });
    }
    let listed = ["k1", "k2", "p1", "p2", "k3", "k4"].iter().filter_map(|key| get(key));
    let camera = Camera {
        distortion: coefficients(listed.map(|node| node.number(FORMAT, "the distortion").ok()).collect()),
        model: model.map(str::to_owned),
        ..camera(FORMAT, name, [fx, fy, cx, cy], (size, Basis::Raw, place.origin(how)))?
    };
    let numbers = |one: &Camera| [one.fx, one.fy, one.cx, one.cy];
    if !found.cameras.iter().any(|other| numbers(other) == numbers(&camera)) {
        if get("cx").is_none() || get("cy").is_none() {
            let camera = name.to_owned();
            found.warnings.push(Warning::NoPrincipalPoint { camera });
        }
        found.cameras.push(camera);
    }
    Ok(())
}
