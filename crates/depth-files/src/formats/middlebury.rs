//! Middlebury and ETH3D: calib.txt. Millimeters.
//!
//! Source: the description of the Middlebury 2014 stereo data sets: Z = baseline · f / (d + doffs).

use super::matrix::{read_matrix, size};
use crate::baseline::Baseline;
use crate::camera::Basis;
use crate::checks::{camera, read_doffs};
use crate::format::Format;
use crate::found::Found;
use crate::refusal::Refusal;
use crate::text::{Line, lines};
use crate::warning::Warning;
use depth_core::quantity::{Length, LengthUnit};

const FORMAT: Format = Format::Middlebury;
/// What such a file has besides, of which nothing is needed here.
const OTHERS: [&str; 6] = ["ndisp", "isint", "vmin", "vmax", "dyavg", "dymax"];
const USED: [&str; 6] = ["cam0", "cam1", "doffs", "baseline", "width", "height"];

pub(super) fn read(text: &str) -> Result<Found, Refusal> {
    let pairs: Vec<(&str, Line<'_>)> = lines(text)
        .filter_map(|line| {
            let (key, value) = line.text.split_once('=')?;
            // Somebody has written a unit or a remark behind it.
            let value = value.split('#').next().unwrap_or_default().trim();
            Some((key.trim(), Line { text: value, ..line }))
        })
        .collect();
    let get = |key: &str| {
        pairs
            .iter()
            .rev()
            .find(|(name, _)| name.eq_ignore_ascii_case(key))
            .map(|(_, line)| *line)
    };
    let number = |key: &str| get(key).map(|line| line.array::<1>(line.text, FORMAT, key, "1")).transpose();
    let origin = |key: &str| get(key).map(|line| line.place.origin(key));
    let size = match (number("width")?, number("height")?) {
        (Some([width]), Some([height])) => size([width, height]),
        _ => None,
    };
    let mut found = Found {
        warnings: doubled(&pairs),
        ignored: ignored(text),
        ..Found::of(FORMAT)
    };
    for name in ["cam0", "cam1"] {
        if let Some(line) = get(name) {
            let origin = line.place.origin(name);
            let matrix = read_matrix(line.array(line.text, FORMAT, name, "9")?, &origin, &mut found.warnings);
            found.cameras.push(camera(FORMAT, name, matrix, (size, Basis::Rectified, origin))?);
        }
    }
    if let Some([value]) = number("baseline")? {
        if value < 0.0 {
            found.warnings.push(Warning::NegativeBaseline);
        }
        if value == 0.0 {
            found.warnings.push(Warning::ZeroBaseline);
        } else {
            let baseline = Baseline::Known(Length::new(value.abs(), LengthUnit::Millimeter));
            found.baseline_origin = origin("baseline");
            found.baseline = Some(baseline);
        }
    } else {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
    }
    found.pair = (found.cameras.len() == 2).then_some([0, 1]);
    let doffs = number("doffs")?.map(|[value]| value).zip(origin("doffs"));
    read_doffs(&mut found, doffs);
    Ok(found)
}

/// What stands twice: of that the last line counts, as where the pairs are put into a map.
fn doubled(pairs: &[(&str, Line<'_>)]) -> Vec<Warning> {
    let places = |key: &str| {
        let mut all = pairs.iter().filter(|(name, _)| name.eq_ignore_ascii_case(key));
        let (_, first) = all.next()?;
        let (_, last) = all.next_back()?;
        Some([first.place, last.place])
    };
    let warning = |key: &str| {
        let (key, places) = (key.to_owned(), places(key)?);
        Some(Warning::Doubled { key, places })
    };
    USED.into_iter().filter_map(warning).collect()
}

fn ignored(text: &str) -> Vec<String> {
    let is_known = |line: &str| {
        let key = line.split('=').next().unwrap_or_default().trim().to_ascii_lowercase();
        line.contains('=') && USED.iter().chain(&OTHERS).any(|name| *name == key)
    };
    let others: Vec<usize> = lines(text)
        .filter(|line| !is_known(line.text))
        .map(|line| line.place.line)
        .collect();
    match others.as_slice() {
        [] => Vec::new(),
        [line] => vec![format!("line {line}: no part of such a file")],
        [first, .., last] => vec![format!("lines {first} to {last}: no part of such a file")],
    }
}
