//! RealSense: what `rs-enumerate-devices -c` prints. Meters.
//!
//! Source: librealsense, `tools/enumerate-devices`; the infrared streams are rectified by the camera.

use super::matrix::size;
use crate::checks::{camera, coefficients, in_meters, read_doffs};
use crate::format::Format;
use crate::found::{Basis, Camera, Found, Warning};
use crate::geometry::length;
use crate::place::Place;
use crate::refusal::Refusal;
use crate::text::{Line, lines};

const FORMAT: Format = Format::RealSense;

pub(super) fn read(text: &str) -> Result<Found, Refusal> {
    let all: Vec<Line<'_>> = lines(text).collect();
    let mut cameras = Vec::new();
    for (index, line) in all.iter().enumerate() {
        if line.text.starts_with("Intrinsic of \"") {
            cameras.extend(stream(all.get(index..).unwrap_or_default())?);
        }
    }
    let infrared = |number: char| {
        let is_it = move |camera: &&Camera| camera.name.starts_with("Infrared") && camera.name.ends_with(number);
        cameras.iter().find(is_it).cloned()
    };
    let mut found = Found::of(FORMAT);
    if let (Some(left), Some(right)) = (infrared('1'), infrared('2')) {
        if let Some((shift, place)) = shift(&all)? {
            let baseline = in_meters(length(shift), &mut found.warnings);
            found.measure(baseline, place.origin("|Translation Vector| from Infrared 1 to Infrared 2"));
        }
        found.ignored = cameras
            .iter()
            .filter(|one| !one.name.starts_with("Infrared"))
            .map(|one| format!("{}: not one of the pair", one.name))
            .collect();
        found.cameras = vec![left, right];
        found.pair = Some([0, 1]);
        read_doffs(&mut found, None);
    } else {
        found.cameras = cameras;
    }
    if found.baseline.is_none() && found.warnings.is_empty() {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
    }
    if found.cameras.is_empty() {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "stream with Fx and Fy",
        });
    }
    Ok(found)
}

/// The stream that begins with the first line.
fn stream(all: &[Line<'_>]) -> Result<Option<Camera>, Refusal> {
    let Some(head) = all.first() else { return Ok(None) };
    let name = head.text.split('"').nth(1).unwrap_or_default();
    let mut numbers = [f64::NAN; 6];
    let mut distortion = Vec::new();
    let mut has_coefficients = false;
    let mut model = None;
    for line in all.iter().skip(1).take_while(|line| !line.text.starts_with("Intrinsic of")) {
        let Some((key, value)) = line.text.split_once(':') else { continue };
        let at = ["Width", "Height", "Fx", "Fy", "PPX", "PPY"]
            .iter()
            .position(|name| *name == key.trim());
        if let Some(place) = at.and_then(|at| numbers.get_mut(at)) {
            let [number] = line.array(value, FORMAT, key.trim(), "1")?;
            *place = number;
        }
        if key.trim() == "Distortion" {
            model = Some(value.trim().to_owned());
        }
        if key.trim() == "Coeffs" {
            distortion = coefficients(crate::number::numbers(value));
            has_coefficients = distortion.is_empty() || distortion.iter().any(|number| *number != 0.0);
            break;
        }
    }
    let [width, height, fx, fy, cx, cy] = numbers;
    if fx.is_nan() {
        return Ok(None);
    }
    let basis = if name.starts_with("Infrared") && !has_coefficients {
        Basis::Rectified
    } else {
        Basis::Raw
    };
    let place = (size([width, height]), basis, head.place.origin("Fx, Fy, PPX, PPY"));
    Ok(Some(Camera {
        distortion,
        model,
        ..camera(FORMAT, name, [fx, fy, cx, cy], place)?
    }))
}

/// From the first infrared camera to the second.
fn shift(all: &[Line<'_>]) -> Result<Option<([f64; 3], Place)>, Refusal> {
    let is_head = |line: &&Line<'_>| {
        let words: Vec<&str> = line.text.split('"').collect();
        let pair = (words.get(1).copied().unwrap_or_default(), words.get(3).copied().unwrap_or_default());
        let is_right = pair.1 == "Infrared 2" || pair.1 == "Infrared_2";
        line.text.starts_with("Extrinsic from") && is_right && ["Infrared 1", "Infrared_1"].contains(&pair.0)
    };
    let Some(at) = all.iter().position(|line| is_head(&line)) else {
        return Ok(None);
    };
    let rest = all.get(at..).unwrap_or_default();
    let vector = rest.iter().find(|line| line.text.starts_with("Translation Vector"));
    let Some(line) = vector else { return Ok(None) };
    let values = line.text.split_once(':').map_or("", |(_, values)| values);
    Ok(Some((line.array(values, FORMAT, "the translation", "3")?, line.place)))
}
