//! ORB-SLAM2 and ORB-SLAM3: settings. Meters; `bf` is the baseline times fx.
//!
//! Source: the examples of ORB-SLAM3, and its class `Settings`: `T_c1_c2` leads from the right camera to the left, and the numbers are scaled
//! to `Camera.newWidth` and `Camera.newHeight`.

use super::matrix::{Projection, place_pair, size};
use crate::camera::{Basis, Camera};
use crate::checks::{self, Pinhole, agree, camera, in_meters, same_length};
use crate::format::Format;
use crate::found::Found;
use crate::geometry::{Transform, length};
use crate::node::Node;
use crate::place::Origin;
use crate::refusal::Refusal;
use crate::sentences::shown;
use crate::warning::{Statement, Warning};
use depth_core::quantity::Pixels;

const FORMAT: Format = Format::OrbSlam;

/// The settings, which may stand in several documents of a file.
struct Settings<'a>(&'a [&'a Node]);

impl<'a> Settings<'a> {
    fn get(&self, key: &str) -> Option<&'a Node> {
        self.0.iter().find_map(|document| document.get(key))
    }

    fn number(&self, key: &str) -> Result<Option<f64>, Refusal> {
        self.get(key).map(|node| node.number(FORMAT, key)).transpose()
    }
}

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let settings = Settings(documents);
    let size = match (settings.number("Camera.width")?, settings.number("Camera.height")?) {
        (Some(width), Some(height)) => size([width, height]),
        _ => None,
    };
    let mut found = Found::of(FORMAT);
    let bf = settings.number("Camera.bf")?;
    let b = settings.number("Stereo.b")?;
    let is_depth_camera = settings.get("DepthMapFactor").is_some();
    let is_rectified = !is_depth_camera && (bf.is_some_and(|bf| bf != 0.0) || b.is_some());
    let basis = if is_rectified { Basis::Rectified } else { Basis::Raw };
    for (name, prefix) in [("camera", "Camera"), ("left", "Camera1"), ("right", "Camera2")] {
        if let Some(one) = read_camera(&settings, (name, prefix), (size, basis))? {
            found.cameras.push(one);
        }
    }
    if found.cameras.len() == 2 {
        found.pair = Some([0, 1]);
    }
    read_baseline(&mut found, &settings)?;
    if is_depth_camera && found.baseline.take().is_some() {
        found.baseline_origin = None;
        found.warnings.push(Warning::DepthCamera);
    } else {
        compare_p(&mut found, &settings);
    }
    let model = settings.get("Camera.type").and_then(Node::text).unwrap_or_default();
    if model.starts_with("Kannala") {
        for camera in &found.cameras {
            let (camera, model) = (camera.name.clone(), model.to_owned());
            found.warnings.push(Warning::Fisheye { camera, model });
        }
    }
    resize(&mut found, &settings)?;
    Ok(found)
}

fn read_camera(
    settings: &Settings<'_>,
    (name, prefix): (&str, &str),
    (size, basis): (Option<[u32; 2]>, Basis),
) -> Result<Option<Camera>, Refusal> {
    let Some(first) = settings.get(&format!("{prefix}.fx")) else {
        return Ok(None);
    };
    let mut pinhole: Pinhole = [0.0; 4];
    for (value, part) in pinhole.iter_mut().zip(["fx", "fy", "cx", "cy"]) {
        let Some(number) = settings.number(&format!("{prefix}.{part}"))? else {
            return Err(Refusal::Missing {
                format: FORMAT,
                what: "fx, fy, cx or cy",
            });
        };
        *value = number;
    }
    let coefficients: Option<Vec<f64>> = ["k1", "k2", "p1", "p2", "k3", "k4"]
        .iter()
        .filter_map(|part| settings.get(&format!("{prefix}.{part}")))
        .map(|node| node.number(FORMAT, "the distortion").ok())
        .collect();
    let origin = first.place.origin(format!("{prefix}.fx, fy, cx, cy"));
    Ok(Some(Camera {
        distortion: checks::coefficients(coefficients),
        model: settings.get("Camera.type").and_then(Node::text).map(str::to_owned),
        ..camera(FORMAT, name, pinhole, (size, basis, origin))?
    }))
}

/// What a setting says of the baseline, in meters, with its sign.
fn said(settings: &Settings<'_>, key: &str, how: &str, focal: f64) -> Result<Option<(f64, Origin)>, Refusal> {
    let Some(node) = settings.get(key) else { return Ok(None) };
    Ok(Some((node.number(FORMAT, key)? / focal, node.place.origin(how))))
}

fn read_baseline(found: &mut Found, settings: &Settings<'_>) -> Result<(), Refusal> {
    let mut claims = Vec::new();
    if let Some(node) = settings.get("Stereo.T_c1_c2") {
        let shift = Transform::read(node, FORMAT, "Stereo.T_c1_c2")?.shift;
        let [x, y, _] = shift;
        place_pair(found, [0, 1], [x, y]);
        found.warnings.push(Warning::Raw { format: FORMAT });
        claims.push((length(shift), node.place.origin("|t| of Stereo.T_c1_c2")));
    }
    claims.extend(said(settings, "Stereo.b", "Stereo.b", 1.0)?);
    if let Some(camera) = found.cameras.first() {
        claims.extend(said(settings, "Camera.bf", "Camera.bf / fx", camera.fx.px())?);
    }
    let Some(((value, origin), others)) = claims.split_first() else {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
        return Ok(());
    };
    if *value < 0.0 {
        found.warnings.push(Warning::NegativeBaseline);
    }
    for (other, other_origin) in others {
        let contradiction = same_length((value.abs(), origin), (other.abs(), other_origin));
        found.warnings.extend(contradiction);
    }
    let baseline = in_meters(value.abs(), &mut found.warnings);
    found.measure(baseline, origin.clone());
    Ok(())
}

/// Where `LEFT.P` and `RIGHT.P`, which the examples rectify with, are of another camera than the settings.
fn compare_p(found: &mut Found, settings: &Settings<'_>) {
    let projection = |key: &str| {
        let node = settings.get(key)?;
        let matrix: [f64; 12] = node.array(FORMAT, key, "12").ok()?;
        Some((Projection::new(matrix), node.place))
    };
    let (Some((left, left_place)), Some((right, right_place)), Some(camera)) =
        (projection("LEFT.P"), projection("RIGHT.P"), found.cameras.first())
    else {
        return;
    };
    let mut said = Vec::new();
    let (of_camera, [of_p, ..]) = (camera.fx.px(), left.pinhole);
    if !agree(of_camera, of_p) {
        let px = |value: f64, origin: Origin| Statement {
            value: format!("{} px", shown(value)),
            origin,
        };
        let key = camera.origin.how.split(',').next().unwrap_or_default();
        said.push(Warning::Contradiction {
            used: px(of_camera, camera.origin.place().origin(key)),
            other: px(of_p, left_place.origin("LEFT.P[0][0]")),
        });
    }
    if let Some((baseline, origin)) = found.baseline.and_then(|one| one.length(None)).zip(found.baseline_origin.as_ref()) {
        let [across, _] = left.to(right);
        let other = right_place.origin("RIGHT.P[0][3] / RIGHT.P[0][0]");
        said.extend(same_length((baseline.m(), origin), (across.abs(), &other)));
    }
    found.warnings.append(&mut said);
}

/// Scales the cameras to the size that ORB-SLAM3 gives the images.
fn resize(found: &mut Found, settings: &Settings<'_>) -> Result<(), Refusal> {
    let sides = [settings.number("Camera.newWidth")?, settings.number("Camera.newHeight")?];
    for camera in &mut found.cameras {
        let Some(from) = camera.size else { continue };
        let [width, height] = from.map(f64::from);
        let [new_width, new_height] = sides;
        let Some(to) = size([new_width.unwrap_or(width), new_height.unwrap_or(height)]).filter(|to| *to != from) else {
            continue;
        };
        let [new_width, new_height] = to.map(f64::from);
        let (across, down) = (new_width / width, new_height / height);
        let scaled = |px: Pixels, scale: f64| Pixels::new(px.px() * scale);
        (camera.fx, camera.cx) = (scaled(camera.fx, across), scaled(camera.cx, across));
        (camera.fy, camera.cy) = (scaled(camera.fy, down), scaled(camera.cy, down));
        camera.size = Some(to);
        found.warnings.push(Warning::Resized {
            camera: camera.name.clone(),
            from,
            to,
        });
    }
    Ok(())
}
