//! ROS: `sensor_msgs/CameraInfo` as a calibration file, as `rostopic echo` and `ros2 topic echo` print it, and as the calibrator does.

use super::matrix::{Projection, of_matrix, place_pair, size};
use crate::checks::{Pinhole, camera, doffs, in_meters, unusable};
use crate::format::Format;
use crate::found::{Basis, Camera, Found, Warning};
use crate::node::Node;
use crate::refusal::Refusal;
use crate::text::{Line, lines};

const FORMAT: Format = Format::Ros;

/// What one message says.
struct Info {
    camera: Camera,
    /// P, where it can be used.
    projection: Option<Projection>,
    model: String,
}

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let mut warnings = Vec::new();
    let infos = documents
        .iter()
        .map(|document| info(document, &mut warnings))
        .collect::<Result<Vec<_>, _>>()?;
    found(infos, warnings)
}

fn found(infos: Vec<Info>, mut warnings: Vec<Warning>) -> Result<Found, Refusal> {
    for info in &infos {
        if ["equidistant", "fisheye"].contains(&info.model.as_str()) {
            warnings.push(Warning::Fisheye {
                camera: info.camera.name.clone(),
                model: info.model.clone(),
            });
        }
    }
    let mut found = Found {
        cameras: infos.iter().map(|info| info.camera.clone()).collect(),
        warnings,
        ..Found::of(FORMAT)
    };
    match infos.as_slice() {
        [one] => read_one(&mut found, one),
        [first, second] => {
            found.pair = Some([0, 1]);
            if let (Some(one), Some(other)) = (first.projection, second.projection) {
                let length = place_pair(&mut found, [0, 1], one.to(other));
                // The right camera is the one whose P has the baseline, in whatever order the files come.
                if other.shift == [0.0; 2] {
                    found.warnings.retain(|warning| *warning != Warning::Swapped);
                }
                found.baseline = (length > 0.0).then(|| in_meters(length, &mut found.warnings)).flatten();
                found.doffs = doffs(&found, None).0;
            }
        }
        _ => found.warnings.push(Warning::Many {
            cameras: infos.len(),
            pair: None,
        }),
    }
    Ok(found)
}

/// The right camera of a pair has the baseline in its P.
fn read_one(found: &mut Found, one: &Info) {
    let shift = one.projection.map_or([0.0; 2], |projection| projection.shift);
    if shift == [0.0; 2] {
        found.warnings.push(Warning::OneOfPair {
            other: "of the right camera",
        });
    } else if let Some(right) = one.projection {
        let left = Projection { shift: [0.0; 2], ..right };
        let length = place_pair(found, [0, 0], left.to(right));
        found.pair = None;
        found.baseline = in_meters(length, &mut found.warnings);
    }
}

fn info(document: &Node, warnings: &mut Vec<Warning>) -> Result<Info, Refusal> {
    let first = |names: [&str; 2]| names.into_iter().find_map(|name| document.get(name));
    let side = |names: [&str; 2], name: &str| first(names).map_or(Ok(f64::NAN), |node| node.number(FORMAT, name));
    let size = size([
        side(["image_width", "width"], "the width")?,
        side(["image_height", "height"], "the height")?,
    ]);
    let text = |names: [&str; 2]| first(names).and_then(Node::text).unwrap_or_default().to_owned();
    let name = text(["camera_name", "frame_id"]);
    let name = if name.is_empty() { "camera".to_owned() } else { name };
    let model = text(["distortion_model", "camera_model"]);
    let projection = match first(["projection_matrix", "P"]) {
        Some(node) => Some((Projection::new(node.array(FORMAT, "P", "12")?), node.line)),
        None => None,
    };
    let matrix = match first(["camera_matrix", "K"]) {
        Some(node) => Some((of_matrix(node.array(FORMAT, "K", "9")?), node.line)),
        None => None,
    };
    of_matrices(&name, (size, model), (projection, matrix), warnings)
}

/// What a file has of a camera, with its line.
type Placed<T> = Option<(T, usize)>;

/// A camera of P where that can be used, else of K.
fn of_matrices(
    name: &str,
    (size, model): (Option<[u32; 2]>, String),
    (projection, matrix): (Placed<Projection>, Placed<Pinhole>),
    warnings: &mut Vec<Warning>,
) -> Result<Info, Refusal> {
    if let Some((projection, line)) = projection {
        match unusable(projection.pinhole, size) {
            None => {
                return Ok(Info {
                    camera: camera(FORMAT, name, projection.pinhole, (size, Basis::Rectified, line))?,
                    projection: Some(projection),
                    model,
                });
            }
            Some(why) => warnings.push(Warning::RectificationUnusable { why }),
        }
    }
    let Some((matrix, line)) = matrix else {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "usable K or P",
        });
    };
    Ok(Info {
        camera: camera(FORMAT, name, matrix, (size, Basis::Raw, line))?,
        projection: None,
        model,
    })
}

/// What the calibrator prints, which is saved as ost.txt: both cameras one after the other.
pub(super) fn read_text(text: &str) -> Result<Found, Refusal> {
    let all: Vec<Line<'_>> = lines(text).collect();
    let mut warnings = Vec::new();
    let mut infos = Vec::new();
    let mut size_now = [f64::NAN; 2];
    let mut name = String::new();
    let mut matrix = None;
    for (index, line) in all.iter().enumerate() {
        let after = |rows: usize| {
            all.iter()
                .skip(index + 1)
                .take(rows)
                .map(|line| line.text)
                .collect::<Vec<_>>()
                .join(" ")
        };
        match line.text {
            "width" => size_now = [one(*line, &after(1), "the width")?, f64::NAN],
            "height" => {
                let [width, _] = size_now;
                size_now = [width, one(*line, &after(1), "the height")?];
            }
            "camera matrix" => matrix = Some((of_matrix(line.array(&after(3), FORMAT, "the camera matrix", "9")?), line.number)),
            "projection" => {
                let projection = Projection::new(line.array(&after(3), FORMAT, "the projection", "12")?);
                let kind = (size(size_now), String::new());
                let matrices = (Some((projection, line.number)), matrix.take());
                infos.push(of_matrices(&name, kind, matrices, &mut warnings)?);
            }
            section if section.starts_with('[') && section != "[image]" => name = section.trim_matches(['[', ']']).to_owned(),
            _ => {}
        }
    }
    if infos.is_empty() {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "projection",
        });
    }
    found(infos, warnings)
}

fn one(line: Line<'_>, text: &str, name: &str) -> Result<f64, Refusal> {
    let [number] = line.array(text, FORMAT, name, "1")?;
    Ok(number)
}
