//! ROS: `sensor_msgs/CameraInfo` as a calibration file, as `rostopic echo` and `ros2 topic echo` print it, and as the calibrator does.

use super::matrix::{Projection, how, place_pair, read_matrix, read_projection, size};
use super::ros_info::{Info, of_matrices};
use super::ros_text;
use super::ros_window::Window;
use crate::camera::Camera;
use crate::checks::{in_meters, read_doffs};
use crate::format::Format;
use crate::found::Found;
use crate::node::Node;
use crate::refusal::Refusal;
use crate::warning::Warning;

const FORMAT: Format = Format::Ros;

/// ROS knows no rig of more cameras.
const MOST_CAMERAS: usize = 12;

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let mut warnings = Vec::new();
    let mut infos: Vec<Info> = Vec::new();
    for document in documents {
        let mut said = Vec::new();
        let info = info(document, &mut said)?;
        // A topic says the same again with every image.
        if !infos.iter().any(|before| before.is_repeated_by(&info)) {
            infos.push(info);
            warnings.append(&mut said);
        }
    }
    found(&infos, warnings)
}

fn found(infos: &[Info], warnings: Vec<Warning>) -> Result<Found, Refusal> {
    let mut found = Found {
        warnings,
        ..Found::of(FORMAT)
    };
    for info in infos {
        found.add(info.camera.clone())?;
    }
    found.tell_apart();
    for camera in &found.cameras {
        if let Some(model) = camera
            .model
            .clone()
            .filter(|model| ["equidistant", "fisheye"].contains(&model.as_str()))
        {
            let camera = camera.name.clone();
            found.warnings.push(Warning::Fisheye { camera, model });
        }
    }
    if let [one] = infos {
        read_one(&mut found, one);
        return Ok(found);
    }
    let count = infos.len().min(MOST_CAMERAS);
    let all = (0..count).flat_map(|first| (first + 1..count).map(move |second| [first, second]));
    for pair in all {
        let [Some(first), Some(second)] = pair.map(|at| infos.get(at)) else {
            continue;
        };
        let (Some(one), Some(other)) = (first.projection, second.projection) else {
            continue;
        };
        // Of two cameras it is said that they stand at the same place; of more only those are pairs that do not.
        if infos.len() == 2 || one.to(other) != [0.0; 2] {
            found.pair_up(pair, |two| {
                measure(two, [one, other]);
                Ok(())
            })?;
        }
    }
    if infos.len() == 2 {
        found.pair = Some([0, 1]);
        found.take_first_pair();
    }
    Ok(found)
}

fn measure(two: &mut Found, [one, other]: [Projection; 2]) {
    let length = place_pair(two, [0, 1], one.to(other));
    // The right camera is the one whose P has the baseline, in whatever order the files come.
    if other.shift == [0.0; 2] {
        two.warnings
            .retain(|warning| !matches!(warning, Warning::Swapped | Warning::SwappedRows));
    }
    if length > 0.0 {
        let baseline = in_meters(length, &mut two.warnings);
        if let [first, second] = two.cameras.as_slice() {
            let (names, camera) = names(first, second, [one, other]);
            let how = how(names.each_ref().map(String::as_str), [one, other]);
            let origin = camera.origin.place().origin(how);
            two.measure(baseline, origin);
        }
    }
    read_doffs(two, None);
}

/// What to call the matrices of two cameras, which have the same name in both files, and the camera whose matrix has the baseline.
fn names<'a>(first: &'a Camera, second: &'a Camera, [one, other]: [Projection; 2]) -> ([String; 2], &'a Camera) {
    let names = [first, second].map(|camera| {
        let matrix = &camera.origin.how;
        if one.shift == [0.0; 2] || other.shift == [0.0; 2] {
            // Only one of them is named.
            matrix.clone()
        } else {
            format!("{matrix} of {}", camera.name)
        }
    });
    (names, if other.shift == [0.0; 2] { first } else { second })
}

/// The right camera of a pair has the baseline in its P.
fn read_one(found: &mut Found, one: &Info) {
    let shift = one.projection.map_or([0.0; 2], |projection| projection.shift);
    let name = one.camera.name.to_ascii_lowercase();
    if shift == [0.0; 2] && !name.contains("left") && !name.contains("right") {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
    } else if shift == [0.0; 2] {
        found.warnings.push(Warning::OneOfPair {
            other: "of the right camera",
        });
    } else if let Some(right) = one.projection {
        let left = Projection { shift: [0.0; 2], ..right };
        let length = place_pair(found, [0, 0], left.to(right));
        found.pair = None;
        let baseline = in_meters(length, &mut found.warnings);
        let name = &one.camera.origin.how;
        found.measure(baseline, one.camera.origin.place().origin(how([name, name], [left, right])));
    }
}

/// What a message or a file has under one of two names.
fn named<'a>(document: &'a Node, names: [&'static str; 2]) -> Option<(&'a Node, &'static str)> {
    names.into_iter().find_map(|name| document.get(name).map(|node| (node, name)))
}

fn info(document: &Node, warnings: &mut Vec<Warning>) -> Result<Info, Refusal> {
    let first = |names: [&'static str; 2]| named(document, names).map(|(node, _)| node);
    let side = |names: [&'static str; 2], name: &str| first(names).map_or(Ok(f64::NAN), |node| node.number(FORMAT, name));
    let size = size([
        side(["image_width", "width"], "the width")?,
        side(["image_height", "height"], "the height")?,
    ]);
    let text = |names: [&'static str; 2]| first(names).and_then(Node::text).unwrap_or_default().to_owned();
    let frame = || {
        document
            .get("header")
            .and_then(|header| header.get("frame_id"))
            .and_then(Node::text)
    };
    let name = text(["camera_name", "frame_id"]);
    let name = [&name, frame().unwrap_or_default(), "camera"]
        .into_iter()
        .find(|name| !name.is_empty());
    let name = name.unwrap_or_default().to_owned();
    let projection = match named(document, ["projection_matrix", "P"]) {
        Some((node, name)) => {
            let origin = node.place.origin(name);
            Some((read_projection(node.array(FORMAT, "P", "12")?, &origin, warnings), origin))
        }
        None => None,
    };
    let matrix = match named(document, ["camera_matrix", "K"]) {
        Some((node, name)) => {
            let origin = node.place.origin(name);
            Some((read_matrix(node.array(FORMAT, "K", "9")?, &origin, warnings), origin))
        }
        None => None,
    };
    let distortion = first(["distortion_coefficients", "D"]).or_else(|| document.get("distortion_coefficents"));
    let mut info = of_matrices(&name, size, (projection, matrix), warnings)?;
    info.camera.distortion = Node::coefficients(distortion, FORMAT);
    info.camera.model = Some(text(["distortion_model", "camera_model"])).filter(|model| !model.is_empty());
    Window::read(document)?.apply(&mut info.camera, &mut info.projection, warnings);
    Ok(info)
}

/// What the calibrator prints, of both cameras in one file, or of each in its own.
pub(super) fn read_texts(texts: &[&str]) -> Result<Found, Refusal> {
    let mut warnings = Vec::new();
    let mut all = Vec::new();
    for (file, text) in texts.iter().enumerate() {
        all.append(&mut ros_text::infos(text, file, &mut warnings)?);
    }
    found(&all, warnings)
}
