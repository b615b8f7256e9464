//! ROS: `sensor_msgs/CameraInfo` as a calibration file, as `rostopic echo` and `ros2 topic echo` print it, and as the calibrator does.

use super::matrix::{Projection, how, of_matrix, place_pair, size};
use crate::checks::{Pinhole, camera, coefficients, in_meters, read_doffs, unusable};
use crate::format::Format;
use crate::found::{Basis, Camera, Found, Warning};
use crate::node::Node;
use crate::number::numbers;
use crate::place::Origin;
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
                if length > 0.0 {
                    let baseline = in_meters(length, &mut found.warnings);
                    let (names, camera) = names(&first.camera, &second.camera, other);
                    found.measure(
                        baseline,
                        camera
                            .origin
                            .place()
                            .origin(how(names.each_ref().map(String::as_str), [one, other])),
                    );
                }
                read_doffs(&mut found, None);
            }
        }
        _ => found.warnings.push(Warning::Many {
            cameras: infos.len(),
            pair: None,
        }),
    }
    Ok(found)
}

/// What to call the matrices of two cameras, which have the same name in both files, and the camera whose matrix has the baseline.
fn names<'a>(first: &'a Camera, second: &'a Camera, right: Projection) -> ([String; 2], &'a Camera) {
    let names = [first, second].map(|camera| {
        let matrix = &camera.origin.how;
        if first.name == second.name {
            matrix.clone()
        } else {
            format!("{matrix} of {}", camera.name)
        }
    });
    (names, if right.shift == [0.0; 2] { first } else { second })
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
        let baseline = in_meters(length, &mut found.warnings);
        let name = &one.camera.origin.how;
        found.measure(baseline, one.camera.origin.place().origin(how([name, name], [left, right])));
    }
}

fn info(document: &Node, warnings: &mut Vec<Warning>) -> Result<Info, Refusal> {
    let named = |names: [&'static str; 2]| names.into_iter().find_map(|name| document.get(name).map(|node| (node, name)));
    let first = |names: [&'static str; 2]| named(names).map(|(node, _)| node);
    let side = |names: [&'static str; 2], name: &str| first(names).map_or(Ok(f64::NAN), |node| node.number(FORMAT, name));
    let size = size([
        side(["image_width", "width"], "the width")?,
        side(["image_height", "height"], "the height")?,
    ]);
    let text = |names: [&'static str; 2]| first(names).and_then(Node::text).unwrap_or_default().to_owned();
    let name = text(["camera_name", "frame_id"]);
    let name = if name.is_empty() { "camera".to_owned() } else { name };
    let model = text(["distortion_model", "camera_model"]);
    let projection = match named(["projection_matrix", "P"]) {
        Some((node, name)) => Some((Projection::new(node.array(FORMAT, "P", "12")?), node.place.origin(name))),
        None => None,
    };
    let matrix = match named(["camera_matrix", "K"]) {
        Some((node, name)) => Some((of_matrix(node.array(FORMAT, "K", "9")?), node.place.origin(name))),
        None => None,
    };
    let distortion = first(["distortion_coefficients", "D"]).or_else(|| document.get("distortion_coefficents"));
    let mut info = of_matrices(&name, (size, model), (projection, matrix), warnings)?;
    info.camera.distortion = Node::coefficients(distortion, FORMAT);
    info.camera.model = Some(info.model.clone()).filter(|model| !model.is_empty());
    Ok(info)
}

/// What a file has of a camera, and where it stands.
type Placed<T> = Option<(T, Origin)>;

/// A camera of P where that can be used, else of K.
fn of_matrices(
    name: &str,
    (size, model): (Option<[u32; 2]>, String),
    (projection, matrix): (Placed<Projection>, Placed<Pinhole>),
    warnings: &mut Vec<Warning>,
) -> Result<Info, Refusal> {
    if let Some((projection, origin)) = projection {
        match unusable(projection.pinhole, size) {
            None => {
                return Ok(Info {
                    camera: camera(FORMAT, name, projection.pinhole, (size, Basis::Rectified, origin))?,
                    projection: Some(projection),
                    model,
                });
            }
            Some(why) => warnings.push(Warning::RectificationUnusable { why }),
        }
    }
    let Some((matrix, origin)) = matrix else {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "usable K or P",
        });
    };
    Ok(Info {
        camera: camera(FORMAT, name, matrix, (size, Basis::Raw, origin))?,
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
    let mut distortion = Vec::new();
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
            "camera matrix" => {
                let numbers = line.array(&after(3), FORMAT, "the camera matrix", "9")?;
                matrix = Some((of_matrix(numbers), line.place.origin("camera matrix")));
            }
            "distortion" => distortion = coefficients(numbers(&after(1))),
            "projection" => {
                let projection = Projection::new(line.array(&after(3), FORMAT, "the projection", "12")?);
                let kind = (size(size_now), String::new());
                let matrices = (Some((projection, line.place.origin("projection"))), matrix.take());
                let mut info = of_matrices(&name, kind, matrices, &mut warnings)?;
                info.camera.distortion = std::mem::take(&mut distortion);
                infos.push(info);
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
