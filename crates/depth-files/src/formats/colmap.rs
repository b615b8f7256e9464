//! COLMAP: cameras.txt. Without a baseline: its models have no scale.
//!
//! Source: COLMAP’s documentation, “Output Format” and “Camera Models”.

use super::matrix::size;
use crate::camera::{Basis, Camera};
use crate::checks::{camera, coefficients};
use crate::format::Format;
use crate::found::Found;
use crate::refusal::Refusal;
use crate::text::{Line, lines};
use crate::warning::Warning;

const FORMAT: Format = Format::Colmap;

/// How many numbers each model has, and whether one focal length stands for both.
const MODELS: [(&str, usize, bool); 15] = [
    ("SIMPLE_PINHOLE", 3, true),
    ("PINHOLE", 4, false),
    ("SIMPLE_RADIAL", 4, true),
    ("RADIAL", 5, true),
    ("OPENCV", 8, false),
    ("OPENCV_FISHEYE", 8, false),
    ("FULL_OPENCV", 12, false),
    ("FOV", 5, false),
    ("SIMPLE_RADIAL_FISHEYE", 4, true),
    ("RADIAL_FISHEYE", 5, true),
    ("THIN_PRISM_FISHEYE", 12, false),
    ("RAD_TAN_THIN_PRISM_FISHEYE", 16, false),
    ("SIMPLE_FISHEYE", 3, true),
    ("FISHEYE", 4, false),
    ("DIVISION", 5, false),
];

/// What a line of a camera holds: its number, its model, width and height, and the numbers of the model.
fn parts(line: Line<'_>) -> Option<(&str, &str, [f64; 2], &str)> {
    let mut words = line.text.splitn(5, char::is_whitespace);
    let (id, model) = (words.next()?, words.next()?);
    let sides = [words.next()?.parse().ok()?, words.next()?.parse().ok()?];
    let is_model = model.starts_with(|one: char| one.is_ascii_uppercase())
        && model
            .chars()
            .all(|one| one.is_ascii_uppercase() || one == '_' || one.is_ascii_digit());
    let is_camera = id.parse::<u32>().is_ok() && is_model && size(sides).is_some();
    Some((id, model, sides, words.next()?)).filter(|_| is_camera)
}

pub(crate) fn is_colmap(text: &str) -> bool {
    lines(text).any(|line| parts(line).is_some())
}

pub(super) fn read(text: &str) -> Result<Found, Refusal> {
    let mut found = Found::of(FORMAT);
    for line in lines(text) {
        let Some((id, model, sides, values)) = parts(line) else { continue };
        let Some(&(_, count, is_single)) = MODELS.iter().find(|(name, ..)| *name == model) else {
            return Err(Refusal::NotPinhole {
                format: FORMAT,
                model: model.to_owned(),
                place: line.place,
            });
        };
        let all = crate::number::numbers(values).unwrap_or_default();
        let pinhole = match all.as_slice() {
            all if all.len() != count => None,
            [f, cx, cy, ..] if is_single => Some([*f, *f, *cx, *cy]),
            [fx, fy, cx, cy, ..] => Some([*fx, *fy, *cx, *cy]),
            _ => None,
        };
        let Some(pinhole) = pinhole else {
            return Err(Refusal::Count {
                format: FORMAT,
                name: model.to_owned(),
                place: line.place,
                count: all.len(),
                expected: count.to_string(),
            });
        };
        let name = format!("camera {id}");
        if model.contains("FISHEYE") || model == "FOV" {
            found.warnings.push(Warning::Fisheye {
                camera: name.clone(),
                model: model.to_owned(),
            });
        }
        let place = (size(sides), Basis::Raw, line.place.origin(model));
        let distortion = all.get(if is_single { 3 } else { 4 }..).map(<[f64]>::to_vec);
        found.add(Camera {
            distortion: coefficients(distortion),
            model: Some(model.to_owned()),
            ..camera(FORMAT, &name, pinhole, place)?
        })?;
    }
    found.warnings.push(Warning::NoBaseline { format: FORMAT });
    Ok(found)
}
