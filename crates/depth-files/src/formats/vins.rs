//! VINS and camodocal: a file for each camera, and the settings of VINS-Fusion with where the cameras are. Meters.
//!
//! Source: camodocal, `PinholeCamera.cc`; VINS-Fusion, `parameters.cpp`: `body_T_cam0` leads from the camera to the IMU.

use super::matrix::{place_pair, size};
use crate::camera::{Basis, Camera};
use crate::checks::{camera, coefficients, in_meters};
use crate::format::Format;
use crate::found::Found;
use crate::geometry::{Transform, length};
use crate::node::Node;
use crate::refusal::Refusal;
use crate::warning::Warning;

const FORMAT: Format = Format::Vins;

pub(super) fn is_vins(document: &Node) -> bool {
    let has = |key: &str| document.get(key).is_some();
    has("model_type") || has("body_T_cam0") || has("body_T_cam1")
}

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let mut found = Found::of(FORMAT);
    let mut cameras: Vec<&Node> = documents.iter().copied().filter(|one| one.get("model_type").is_some()).collect();
    // Where the files say it, they may come in any order.
    cameras.sort_by_key(|node| is_right(node));
    for (index, node) in cameras.into_iter().enumerate() {
        found.cameras.push(read_camera(index, node)?);
    }
    let pose = |name: &str| {
        let node = documents.iter().find_map(|document| document.get(name));
        node.map(|node| Ok((Transform::read(node, FORMAT, name)?, node))).transpose()
    };
    let poses = (pose("body_T_cam0")?, pose("body_T_cam1")?);
    if found.cameras.is_empty() {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "camera: give the files that its cam0_calib and cam1_calib name as well",
        });
    }
    let is_pair = found.cameras.len() >= 2;
    match poses {
        (Some((first, _)), Some((second, node))) => {
            let shift @ [x, y, _] = second.inverse().after(first).shift;
            place_pair(&mut found, [0, 1], [-x, -y]);
            // A zero is said already.
            let baseline = in_meters(length(shift), &mut Vec::new());
            let how = "|t| of inverse(body_T_cam1) · body_T_cam0";
            found.measure(baseline, node.place.origin(how));
            found.warnings.push(Warning::Raw { format: FORMAT });
            // Of the two that stand there, one may not be here.
            found.pair = found.pair.filter(|_| is_pair);
        }
        _ if is_pair => {
            found.pair = Some([0, 1]);
            found.warnings.push(Warning::NoExtrinsics);
        }
        _ => found.warnings.push(Warning::NoBaseline { format: FORMAT }),
    }
    Ok(found)
}

/// Whether the name of a camera says that it is the second.
fn is_right(node: &Node) -> bool {
    let name = node
        .get("camera_name")
        .and_then(Node::text)
        .unwrap_or_default()
        .to_ascii_lowercase();
    name.contains("right") || name.ends_with('1')
}

fn read_camera(index: usize, node: &Node) -> Result<Camera, Refusal> {
    let text = |key: &str| node.get(key).and_then(Node::text).unwrap_or_default().to_owned();
    let model = text("model_type");
    // MEI and SCARAMUZZA have a mirror or a polynomial in front of what they call a focal length, KANNALA_BRANDT a lens of a fisheye.
    if !model.eq_ignore_ascii_case("PINHOLE") && !model.eq_ignore_ascii_case("PINHOLE_FULL") {
        return Err(Refusal::NotPinhole {
            format: FORMAT,
            model,
            place: node.get("model_type").unwrap_or(node).place,
        });
    }
    let Some(projection) = node.get("projection_parameters") else {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "projection_parameters",
        });
    };
    let number = |key: &'static str| match projection.get(key) {
        Some(node) => node.number(FORMAT, key),
        None => Err(Refusal::Missing { format: FORMAT, what: key }),
    };
    let pinhole = [number("fx")?, number("fy")?, number("cx")?, number("cy")?];
    let side = |key: &str| node.get(key).map_or(Ok(f64::NAN), |node| node.number(FORMAT, key));
    let size = size([side("image_width")?, side("image_height")?]);
    let distortion = node.get("distortion_parameters");
    let distortion = distortion.map(|node| node.entries().map(|(key, node)| node.number(FORMAT, key).ok()).collect());
    let name = Some(text("camera_name")).filter(|name| !name.is_empty());
    let name = name.unwrap_or_else(|| format!("cam{index}"));
    let origin = projection.place.origin("projection_parameters");
    Ok(Camera {
        distortion: coefficients(distortion.flatten()),
        model: Some(model),
        ..camera(FORMAT, &name, pinhole, (size, Basis::Raw, origin))?
    })
}
