//! ORB-SLAM2 and ORB-SLAM3: settings. Meters; `bf` is the baseline times fx.
//!
//! Source: the examples of ORB-SLAM3, and its class `Settings`: `T_c1_c2` leads from the right camera to the left.

use super::matrix::size;
use crate::checks::{self, Pinhole, camera, in_meters};
use crate::format::Format;
use crate::found::{Basis, Camera, Found, Warning};
use crate::geometry::{Transform, length};
use crate::node::Node;
use crate::refusal::Refusal;

const FORMAT: Format = Format::OrbSlam;

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let get = |key: &str| documents.iter().find_map(|document| document.get(key));
    let number = |key: &str| get(key).map(|node| node.number(FORMAT, key)).transpose();
    let size = match (number("Camera.width")?, number("Camera.height")?) {
        (Some(width), Some(height)) => size([width, height]),
        _ => None,
    };
    let mut found = Found::of(FORMAT);
    let bf = number("Camera.bf")?;
    let b = number("Stereo.b")?;
    let is_depth_camera = get("DepthMapFactor").is_some();
    let is_rectified = !is_depth_camera && (bf.is_some_and(|bf| bf != 0.0) || b.is_some());
    let basis = if is_rectified { Basis::Rectified } else { Basis::Raw };
    for (name, prefix) in [("camera", "Camera"), ("left", "Camera1"), ("right", "Camera2")] {
        if let Some(one) = read_camera(&get, (name, prefix), (size, basis))? {
            found.cameras.push(one);
        }
    }
    read_baseline(&mut found, &get, (bf, b))?;
    if is_depth_camera && found.baseline.take().is_some() {
        found.baseline_origin = None;
        found.warnings.push(Warning::DepthCamera);
    }
    let model = get("Camera.type").and_then(Node::text).unwrap_or_default();
    if model.starts_with("Kannala") {
        found.warnings.push(Warning::Fisheye {
            camera: "both".to_owned(),
            model: model.to_owned(),
        });
    }
    Ok(found)
}

fn read_camera<'a>(
    get: &impl Fn(&str) -> Option<&'a Node>,
    (name, prefix): (&str, &str),
    (size, basis): (Option<[u32; 2]>, Basis),
) -> Result<Option<Camera>, Refusal> {
    let Some(first) = get(&format!("{prefix}.fx")) else {
        return Ok(None);
    };
    let mut pinhole: Pinhole = [0.0; 4];
    for (value, part) in pinhole.iter_mut().zip(["fx", "fy", "cx", "cy"]) {
        let key = format!("{prefix}.{part}");
        let Some(node) = get(&key) else {
            return Err(Refusal::Missing {
                format: FORMAT,
                what: "fx, fy, cx or cy",
            });
        };
        *value = node.number(FORMAT, &key)?;
    }
    let coefficients: Option<Vec<f64>> = ["k1", "k2", "p1", "p2", "k3", "k4"]
        .iter()
        .filter_map(|part| get(&format!("{prefix}.{part}")))
        .map(|node| node.number(FORMAT, "the distortion").ok())
        .collect();
    let origin = first.place.origin(format!("{prefix}.fx, fy, cx, cy"));
    Ok(Some(Camera {
        distortion: checks::coefficients(coefficients),
        model: get("Camera.type").and_then(Node::text).map(str::to_owned),
        ..camera(FORMAT, name, pinhole, (size, basis, origin))?
    }))
}

fn read_baseline<'a>(
    found: &mut Found,
    get: &impl Fn(&str) -> Option<&'a Node>,
    (bf, b): (Option<f64>, Option<f64>),
) -> Result<(), Refusal> {
    if let Some(node) = get("Stereo.T_c1_c2") {
        let shift = Transform::read(node, FORMAT, "Stereo.T_c1_c2")?.shift;
        let [x, y, _] = shift;
        super::matrix::place_pair(found, [0, 1], [x, y]);
        let baseline = in_meters(length(shift), &mut found.warnings);
        found.measure(baseline, node.place.origin("|t| of Stereo.T_c1_c2"));
        found.warnings.push(Warning::Raw { format: FORMAT });
        return Ok(());
    }
    let fx = found.cameras.first().map(|camera| camera.fx.px());
    let value = b.or_else(|| bf.zip(fx).map(|(bf, fx)| bf / fx));
    match value {
        Some(value) => {
            if value < 0.0 {
                found.warnings.push(Warning::NegativeBaseline);
            }
            let baseline = in_meters(value.abs(), &mut found.warnings);
            let (key, how) = if b.is_some() {
                ("Stereo.b", "Stereo.b")
            } else {
                ("Camera.bf", "Camera.bf / fx")
            };
            if let Some(node) = get(key) {
                found.measure(baseline, node.place.origin(how));
            }
        }
        None => found.warnings.push(Warning::NoBaseline { format: FORMAT }),
    }
    Ok(())
}
