//! EuRoC: sensor.yaml, one for each camera. Meters.
//!
//! Source: Burri et al.: The EuRoC micro aerial vehicle datasets, 2016: `T_BS` leads from the sensor to the body.

use super::matrix::size;
use crate::checks::{camera, in_meters};
use crate::format::Format;
use crate::found::{Basis, Camera, Found, Warning};
use crate::geometry::{Transform, Vector, distance};
use crate::node::Node;
use crate::place::Place;
use crate::refusal::Refusal;

const FORMAT: Format = Format::Euroc;

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let mut found = Found::of(FORMAT);
    let mut places = Vec::new();
    for (index, document) in documents.iter().enumerate() {
        let (camera, place) = read_camera(index, document, &mut found.warnings)?;
        found.cameras.push(camera);
        places.push(place);
    }
    match places.as_slice() {
        [Some((first, _)), Some((second, place)), ..] => {
            found.pair = Some([0, 1]);
            found.warnings.push(Warning::Raw { format: FORMAT });
            let baseline = in_meters(distance(*first, *second), &mut found.warnings);
            found.measure(baseline, place.origin("distance between the translations of T_BS"));
        }
        [_] => found.warnings.push(Warning::OneOfPair { other: "of cam1" }),
        _ => found.warnings.push(Warning::NoBaseline { format: FORMAT }),
    }
    Ok(found)
}

fn read_camera(index: usize, document: &Node, warnings: &mut Vec<Warning>) -> Result<(Camera, Option<(Vector, Place)>), Refusal> {
    let text = |key: &str| document.get(key).and_then(Node::text).unwrap_or_default().to_owned();
    let Some(intrinsics) = document.get("intrinsics") else {
        return Err(Refusal::Other {
            what: "the sensor.yaml of an IMU or another sensor, not of a camera",
            todo: "Give those of cam0 and cam1.",
        });
    };
    let model = text("camera_model");
    if !["", "pinhole"].contains(&model.as_str()) {
        return Err(Refusal::NotPinhole {
            format: FORMAT,
            model,
            place: document.place,
        });
    }
    let name = format!("cam{index}");
    let distortion = text("distortion_model");
    if distortion == "equidistant" {
        warnings.push(Warning::Fisheye {
            camera: name.clone(),
            model: distortion.clone(),
        });
    }
    let size = match document.get("resolution") {
        Some(node) => size(node.array(FORMAT, "resolution", "2")?),
        None => None,
    };
    let pinhole = intrinsics.array(FORMAT, "intrinsics", "4")?;
    let origin = intrinsics.place.origin("intrinsics");
    let camera = Camera {
        distortion: Node::coefficients(document.get("distortion_coefficients"), FORMAT),
        model: Some(distortion).filter(|model| !model.is_empty()),
        ..camera(FORMAT, &name, pinhole, (size, Basis::Raw, origin))?
    };
    let place = match document.get("T_BS") {
        Some(node) => Some((Transform::read(node, FORMAT, "T_BS")?.shift, node.place)),
        None => None,
    };
    Ok((camera, place))
}
