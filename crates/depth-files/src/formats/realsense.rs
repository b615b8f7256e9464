//! RealSense: what `rs-enumerate-devices -c` prints. Meters.
//!
//! Source: librealsense, `tools/enumerate-devices`; the infrared streams are rectified by the camera, and the depth is that of the left one.

use super::matrix::size;
use crate::camera::{Basis, Camera};
use crate::checks::{camera, coefficients, in_meters, read_doffs};
use crate::format::Format;
use crate::found::Found;
use crate::geometry::length;
use crate::place::Place;
use crate::refusal::Refusal;
use crate::text::{Line, lines};
use crate::warning::Warning;
use std::borrow::Cow;

const FORMAT: Format = Format::RealSense;
const HEAD: &str = "Intrinsic of \"";

/// Whether a line begins a stream, also where somebody made a comment or a text of it.
pub(crate) fn is_realsense(text: &str) -> bool {
    let is_head = |line: Line<'_>| line.text.contains("Intrinsic of") && plain(line.text).starts_with(HEAD);
    lines(text).any(is_head)
}

/// A line without what makes a comment or a text of it.
fn plain(text: &str) -> Cow<'_, str> {
    let text = text.trim_start_matches(|one: char| one.is_whitespace() || "#/*>|'\"`".contains(one));
    let text = text.trim_end_matches(|one: char| one.is_whitespace() || "'`,".contains(one));
    // The names of the streams are in quotes, which are even in number.
    let is_odd = text.replace("\\\"", "").matches('"').count() % 2 == 1;
    let text = text.strip_suffix('"').filter(|_| is_odd).unwrap_or(text);
    let text = text.strip_suffix("\\n").unwrap_or(text);
    if text.contains('\\') {
        Cow::Owned(text.replace("\\\"", "\"").replace("\\t", "\t"))
    } else {
        Cow::Borrowed(text)
    }
}

/// A stream, of which there is one for each size and format of its images.
struct Stream {
    name: String,
    camera: Camera,
}

pub(super) fn read(text: &str) -> Result<Found, Refusal> {
    let plain: Vec<(Place, Cow<'_, str>)> = lines(text).map(|line| (line.place, plain(line.text))).collect();
    let all: Vec<Line<'_>> = plain.iter().map(|(place, text)| Line { place: *place, text }).collect();
    let mut streams = Vec::new();
    for (index, line) in all.iter().enumerate() {
        if line.text.starts_with(HEAD) {
            streams.extend(stream(all.get(index..).unwrap_or_default())?);
        }
    }
    let has = |name: &str| streams.iter().any(|stream: &Stream| stream.name == name);
    let left = if has("Infrared 1") { "Infrared 1" } else { "Depth" };
    let is_pair = has(left) && has("Infrared 2");
    let mut found = Found::of(FORMAT);
    for Stream { name, camera } in streams {
        if !is_pair || name == left || name == "Infrared 2" {
            found.add(camera)?;
        } else {
            found.ignored.push(format!("{name}: not one of the pair"));
        }
    }
    found.ignored.dedup();
    found.tell_apart();
    if is_pair {
        let shift = shift(&all, left)?;
        for pair in pairs(&found.cameras, left) {
            found.pair_up(pair, |two| {
                if let Some((shift, place)) = shift {
                    let baseline = in_meters(length(shift), &mut two.warnings);
                    two.measure(baseline, place.origin(format!("|Translation Vector| from {left} to Infrared 2")));
                } else {
                    two.warnings.push(Warning::NoBaseline { format: FORMAT });
                }
                read_doffs(two, None);
                Ok(())
            })?;
        }
    }
    found.take_first_pair();
    if found.pair.is_none() {
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

/// The left and the right camera of each size, in the order of the file.
fn pairs(cameras: &[Camera], left: &str) -> Vec<[usize; 2]> {
    let is_of = |camera: &Camera, name: &str| camera.name.starts_with(name);
    let lefts = cameras.iter().enumerate().filter(|(_, camera)| is_of(camera, left));
    let pairs = lefts.filter_map(|(at, one)| {
        let is_other = |other: &Camera| is_of(other, "Infrared 2") && other.size == one.size;
        Some([at, cameras.iter().position(is_other)?])
    });
    pairs.collect()
}

/// The stream that begins with the first line.
fn stream(all: &[Line<'_>]) -> Result<Option<Stream>, Refusal> {
    let Some(head) = all.first() else { return Ok(None) };
    let name = head.text.split('"').nth(1).unwrap_or_default().replace('_', " ");
    let mut numbers = [f64::NAN; 6];
    let mut distortion = Vec::new();
    let mut has_coefficients = false;
    let mut model = None;
    for line in all.iter().skip(1).take_while(|line| !line.text.starts_with("Intrinsic of")) {
        let Some((key, value)) = line.text.split_once(':') else { continue };
        let key = key.trim();
        let at = ["Width", "Height", "Fx", "Fy", "PPX", "PPY"].iter().position(|name| *name == key);
        if let Some(place) = at.and_then(|at| numbers.get_mut(at)) {
            let [number] = line.array(value, FORMAT, key, "1")?;
            *place = number;
        }
        if key == "Distortion" {
            model = Some(value.trim().to_owned());
        }
        if key == "Coeffs" {
            distortion = coefficients(crate::number::numbers(value));
            has_coefficients = distortion.is_empty() || distortion.iter().any(|number| *number != 0.0);
            break;
        }
    }
    let [width, height, fx, fy, cx, cy] = numbers;
    if fx.is_nan() {
        return Ok(None);
    }
    let basis = if (name.starts_with("Infrared") || name == "Depth") && !has_coefficients {
        Basis::Rectified
    } else {
        Basis::Raw
    };
    let origin = head.place.origin("Fx, Fy, PPX, PPY");
    let camera = Camera {
        distortion,
        model,
        ..camera(FORMAT, &name, [fx, fy, cx, cy], (size([width, height]), basis, origin))?
    };
    Ok(Some(Stream { name, camera }))
}

/// From the left camera to the second infrared one.
fn shift(all: &[Line<'_>], left: &str) -> Result<Option<([f64; 3], Place)>, Refusal> {
    let is_head = |line: &&Line<'_>| {
        let words: Vec<&str> = line.text.split('"').collect();
        let is = |at: usize, name: &str| words.get(at).is_some_and(|word| word.replace('_', " ") == name);
        line.text.starts_with("Extrinsic from") && is(1, left) && is(3, "Infrared 2")
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
