//! DepthAI: what an OAK camera knows of itself, as JSON. Centimeters, if it does not say another unit.
//!
//! Source: depthai-core, `EepromData.hpp`, `Extrinsics.hpp` and `CalibrationHandler.cpp`: the extrinsics of a camera lead from it to the one
//! in the socket `toCameraSocket`.

use super::matrix::{of_matrix, place_pair, size};
use crate::baseline::Baseline;
use crate::camera::{Basis, Camera};
use crate::checks::camera;
use crate::format::Format;
use crate::found::Found;
use crate::geometry::{Transform, length};
use crate::node::Node;
use crate::place::Place;
use crate::refusal::Refusal;
use crate::warning::Warning;
use depth_core::quantity::{Length, LengthUnit};
use std::iter;

const FORMAT: Format = Format::DepthAi;
/// What the sockets are called, by their numbers. Without `stereoRectificationData` the left camera is in the second and the right in the third.
const SOCKETS: [&str; 10] = [
    "CAM_A", "CAM_B", "CAM_C", "CAM_D", "CAM_E", "CAM_F", "CAM_G", "CAM_H", "CAM_I", "CAM_J",
];
/// No board has more.
const MOST_SOCKETS: usize = 100;
const LEFT_AND_RIGHT: [i64; 2] = [1, 2];

/// From the camera in one socket to that in another.
struct Step {
    from: i64,
    to: i64,
    transform: Transform,
    is_by_design: bool,
    /// Whether there is a design that is not taken.
    has_design: bool,
    place: Place,
}

pub(super) fn is_depth_ai(document: &Node) -> bool {
    document.get("cameraData").is_some()
}

pub(super) fn read(document: &Node) -> Result<Found, Refusal> {
    let mut found = Found::of(FORMAT);
    let mut sockets = Vec::new();
    let mut steps = Vec::new();
    for (socket, node) in entries(document)? {
        if let Some(camera) = read_camera(socket, node, &mut found)? {
            found.cameras.push(camera);
            sockets.push(socket);
        }
        steps.extend(read_step(socket, node)?);
    }
    if found.cameras.is_empty() {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "camera with an intrinsicMatrix",
        });
    }
    let wanted = left_and_right(document)?;
    let at = |socket: i64| sockets.iter().position(|one| *one == socket);
    let [Some(left), Some(right)] = wanted.map(at) else {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
        return Ok(found);
    };
    found.warnings.push(Warning::Raw { format: FORMAT });
    let all = 0..sockets.len();
    let others = all
        .clone()
        .flat_map(|one| all.clone().filter(move |other| one < *other).map(move |other| [one, other]));
    let others = others.filter(|pair| *pair != [left, right] && *pair != [right, left]);
    for pair in iter::once([left, right]).chain(others) {
        let between = pair.map(|at| sockets.get(at).copied().unwrap_or(-1));
        found.pair_up(pair, |two| read_baseline(two, between, &steps))?;
    }
    found.take_first_pair();
    if found.pairs.iter().any(|pair| pair.baseline.is_some()) && steps.iter().any(|step| step.has_design) {
        let why = "specTranslation: it is how the cameras were designed; what was measured is taken";
        found.ignored.push(why.to_owned());
    }
    Ok(found)
}

/// The sockets with what is in them: DepthAI writes pairs in a list, as JSON has no maps by numbers.
fn entries(document: &Node) -> Result<Vec<(i64, &Node)>, Refusal> {
    let Some(data) = document.get("cameraData") else {
        return Ok(Vec::new());
    };
    let pairs = data.items().iter().filter_map(|pair| match pair.items() {
        [socket, node] => Some((socket.number(FORMAT, "the socket"), node)),
        _ => None,
    });
    let named = data.entries().map(|(key, node)| {
        let number = SOCKETS.iter().position(|name| *name == key).and_then(|at| i64::try_from(at).ok());
        let socket = number.or_else(|| key.parse().ok());
        let socket = socket.ok_or_else(|| Refusal::NotANumber {
            format: FORMAT,
            name: "the socket".to_owned(),
            place: node.place,
            text: key.chars().take(40).collect(),
        });
        (socket, node)
    });
    let pairs = pairs.map(|(socket, node)| (socket.map(to_socket), node));
    let all = pairs.chain(named).take(MOST_SOCKETS);
    all.map(|(socket, node)| Ok((socket?, node))).collect()
}

/// A socket of a number; −1, which stands for none, for all that is none.
fn to_socket(number: f64) -> i64 {
    (0..100_i16).find(|socket| f64::from(*socket) == number).map_or(-1, i64::from)
}

fn left_and_right(document: &Node) -> Result<[i64; 2], Refusal> {
    let Some(data) = document.get("stereoRectificationData") else {
        return Ok(LEFT_AND_RIGHT);
    };
    let socket = |key: &str| data.get(key).map_or(Ok(-1.0), |node| node.number(FORMAT, key)).map(to_socket);
    let named = [socket("leftCameraSocket")?, socket("rightCameraSocket")?];
    Ok(if named.contains(&-1) { LEFT_AND_RIGHT } else { named })
}

fn name_of(socket: i64) -> String {
    let name = usize::try_from(socket).ok().and_then(|at| SOCKETS.get(at));
    name.map_or_else(|| format!("socket {socket}"), |name| (*name).to_owned())
}

/// A camera; nothing for a socket in which none was calibrated.
fn read_camera(socket: i64, node: &Node, found: &mut Found) -> Result<Option<Camera>, Refusal> {
    let name = name_of(socket);
    let matrix = node.get("intrinsicMatrix").filter(|matrix| !matrix.items().is_empty());
    let Some(matrix) = matrix else { return Ok(None) };
    let numbers = matrix.array::<9>(FORMAT, "intrinsicMatrix", "9")?;
    if numbers.iter().all(|one| *one == 0.0) {
        found
            .ignored
            .push(format!("{name}: its intrinsicMatrix is zero, it was not calibrated"));
        return Ok(None);
    }
    let kind = node.get("cameraType").and_then(Node::text).unwrap_or("0");
    match kind {
        "0" | "Perspective" => {}
        "1" | "Fisheye" => found.warnings.push(Warning::Fisheye {
            camera: name.clone(),
            model: "Fisheye".to_owned(),
        }),
        _ => {
            return Err(Refusal::NotPinhole {
                format: FORMAT,
                model: format!("cameraType {kind}"),
                place: node.place,
            });
        }
    }
    let side = |key: &str| node.get(key).map_or(Ok(f64::NAN), |node| node.number(FORMAT, key));
    let size = size([side("width")?, side("height")?]);
    let origin = matrix.place.origin("intrinsicMatrix");
    Ok(Some(Camera {
        distortion: Node::coefficients(node.get("distortionCoeff"), FORMAT),
        ..camera(FORMAT, &name, of_matrix(numbers), (size, Basis::Raw, origin))?
    }))
}

/// Where a camera's extrinsics lead, in meters; nothing where they lead nowhere.
fn read_step(from: i64, node: &Node) -> Result<Option<Step>, Refusal> {
    let Some(extrinsics) = node.get("extrinsics") else {
        return Ok(None);
    };
    let socket = extrinsics
        .get("toCameraSocket")
        .map_or(Ok(-1.0), |node| node.number(FORMAT, "toCameraSocket"))?;
    let to = to_socket(socket);
    let rotation = extrinsics.get("rotationMatrix").filter(|node| !node.items().is_empty());
    let (Some(rotation), true) = (rotation, to >= 0) else {
        return Ok(None);
    };
    let [a, b, c, d, e, f, g, h, i] = rotation.array(FORMAT, "rotationMatrix", "9")?;
    let Some((measured, place)) = vector(extrinsics, "translation")? else {
        return Ok(None);
    };
    let designed = vector(extrinsics, "specTranslation")?.map(|(designed, _)| designed);
    let has_design = designed.is_some_and(|designed| designed != [0.0; 3]);
    let is_by_design = has_design && measured == [0.0; 3];
    let shift = designed.filter(|_| is_by_design).unwrap_or(measured);
    let unit = unit(extrinsics)?;
    let shift = shift.map(|one| Length::new(one, unit).m());
    Ok(Some(Step {
        from,
        to,
        transform: Transform::new([[a, b, c], [d, e, f], [g, h, i]], shift),
        is_by_design,
        has_design: has_design && !is_by_design,
        place,
    }))
}

fn vector(extrinsics: &Node, key: &str) -> Result<Option<([f64; 3], Place)>, Refusal> {
    let Some(node) = extrinsics.get(key) else { return Ok(None) };
    let part = |name: &str| node.get(name).map_or(Ok(0.0), |node| node.number(FORMAT, key));
    let vector = match node.items() {
        [] => [part("x")?, part("y")?, part("z")?],
        _ => node.array(FORMAT, key, "3")?,
    };
    Ok(Some((vector, node.place)))
}

/// The unit of the translations: centimeters where it is not said.
fn unit(extrinsics: &Node) -> Result<LengthUnit, Refusal> {
    let Some(node) = extrinsics.get("lengthUnit") else {
        return Ok(LengthUnit::Centimeter);
    };
    let text = node.text().unwrap_or_default();
    match text.to_ascii_lowercase().as_str() {
        "0" | "meter" | "m" => Ok(LengthUnit::Meter),
        "1" | "centimeter" | "cm" => Ok(LengthUnit::Centimeter),
        "2" | "millimeter" | "mm" => Ok(LengthUnit::Millimeter),
        "3" | "inch" => Ok(LengthUnit::Inch),
        "4" | "foot" => Ok(LengthUnit::Foot),
        _ => Err(Refusal::Missing {
            format: FORMAT,
            what: "lengthUnit that is known here: 0 are meters, 1 centimeters, 2 millimeters, 3 inches, 4 feet",
        }),
    }
}

/// Goes from the left camera to the right one, from each to the next that its extrinsics or those of the next name.
fn read_baseline(found: &mut Found, [left, right]: [i64; 2], steps: &[Step]) -> Result<(), Refusal> {
    let start = Transform::new([[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]], [0.0; 3]);
    let mut reached = vec![(left, start, Vec::<&Step>::new())];
    let mut at = 0;
    while let Some((here, way, path)) = reached.get(at).cloned() {
        if here == right {
            return take(found, way, &path);
        }
        for step in steps {
            let next = if step.from == here {
                (step.to, step.transform.after(way))
            } else if step.to == here {
                (step.from, step.transform.inverse().after(way))
            } else {
                continue;
            };
            if reached.iter().all(|(socket, ..)| *socket != next.0) {
                let path = path.iter().copied().chain([step]).collect();
                reached.push((next.0, next.1, path));
            }
        }
        at += 1;
    }
    found.warnings.push(Warning::NoExtrinsics);
    Ok(())
}

/// Takes what leads from the left camera to the right one.
fn take(found: &mut Found, way: Transform, path: &[&Step]) -> Result<(), Refusal> {
    let shift @ [x, y, _] = way.shift;
    place_pair(found, [0, 1], [-x, -y]);
    if path.iter().any(|step| step.is_by_design) {
        found.warnings.push(Warning::ByDesign);
    }
    let names: Vec<String> = path
        .iter()
        .map(|step| format!("{} to {}", name_of(step.from), name_of(step.to)))
        .collect();
    let (meters, how) = (length(shift), format!("|translation| of {}", names.join(", ")));
    if let Some(step) = path.first() {
        let baseline = (meters > 0.0).then(|| Baseline::Known(Length::from_m(meters)));
        found.measure(baseline, step.place.origin(how));
    }
    Ok(())
}
