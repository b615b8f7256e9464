//! ZED: SN*.conf of Stereolabs. Millimeters; the values are of raw images.
//!
//! Source: Stereolabs, zed-opencv-native, `calibration.hpp`.

use crate::camera::{Basis, Camera};
use crate::checks::{Pinhole, camera, coefficients, in_meters};
use crate::format::Format;
use crate::found::Found;
use crate::number::number;
use crate::place::Place;
use crate::refusal::Refusal;
use crate::text::lines;
use crate::warning::Warning;
use depth_core::quantity::{Length, LengthUnit};

const FORMAT: Format = Format::Zed;

/// The modes, by what the names of the sections end with, and the size of their images.
const MODES: [(&str, [u32; 2]); 7] = [
    ("2K", [2208, 1242]),
    ("FHD1200", [1920, 1200]),
    ("FHD", [1920, 1080]),
    ("SVGA", [960, 600]),
    ("HD", [1280, 720]),
    ("VGA", [672, 376]),
    ("4K", [3840, 2160]),
];

/// What stands in a section.
struct Section {
    name: String,
    place: Place,
    entries: Vec<(String, String, Place)>,
}

pub(super) fn read(text: &str) -> Result<Found, Refusal> {
    let sections = sections(text);
    let mut found = Found {
        warnings: vec![Warning::Raw { format: FORMAT }],
        ..Found::of(FORMAT)
    };
    for section in &sections {
        let Some((side, mode)) = section.name.split_once("_CAM_") else {
            continue;
        };
        let size = MODES.iter().find(|(name, _)| *name == mode).map(|(_, size)| *size);
        let name = format!("{} {mode}", side.to_ascii_lowercase());
        let place = (
            size,
            Basis::Raw,
            section.place.origin(format!("fx, fy, cx, cy of [{}]", section.name)),
        );
        found.add(Camera {
            distortion: distortion(section),
            ..camera(FORMAT, &name, pinhole(section)?, place)?
        })?;
    }
    let mut baseline = None;
    let mut said = Vec::new();
    let stereo = sections.iter().find(|section| section.name == "STEREO");
    match stereo.and_then(|section| section.entries.iter().find(|(key, ..)| key == "baseline")) {
        Some((_, text, place)) => {
            let value = number(text.trim_end_matches("mm")).ok_or_else(|| not_a_number("Baseline", text, *place))?;
            if value < 0.0 {
                said.push(Warning::NegativeBaseline);
            }
            let length = Length::new(value.abs(), LengthUnit::Millimeter);
            baseline = in_meters(length.m(), &mut said).map(|baseline| (baseline, place.origin("Baseline")));
        }
        None => said.push(Warning::NoBaseline { format: FORMAT }),
    }
    for pair in modes(&found.cameras) {
        found.pair_up(pair, |two| {
            two.warnings.clone_from(&said);
            if let Some((baseline, origin)) = &baseline {
                two.measure(Some(*baseline), origin.clone());
            }
            Ok(())
        })?;
    }
    found.take_first_pair();
    if found.pair.is_none() {
        found.warnings.append(&mut said);
    }
    Ok(found)
}

/// The left and the right camera of each mode, in the order of the file.
fn modes(cameras: &[Camera]) -> Vec<[usize; 2]> {
    let side = |camera: &Camera, side: &str| camera.name.strip_prefix(side).map(str::to_owned);
    let lefts = cameras
        .iter()
        .enumerate()
        .filter_map(|(at, camera)| Some((at, side(camera, "left ")?)));
    let pairs = lefts.filter_map(|(left, mode)| {
        let right = cameras.iter().position(|camera| side(camera, "right ").as_ref() == Some(&mode))?;
        Some([left, right])
    });
    // There are seven modes.
    pairs.take(MODES.len()).collect()
}

fn pinhole(section: &Section) -> Result<Pinhole, Refusal> {
    let mut pinhole: Pinhole = [0.0; 4];
    for (value, name) in pinhole.iter_mut().zip(["fx", "fy", "cx", "cy"]) {
        let Some((_, text, place)) = section.entries.iter().find(|(key, ..)| key == name) else {
            return Err(Refusal::Missing {
                format: FORMAT,
                what: "fx, fy, cx or cy",
            });
        };
        *value = number(text).ok_or_else(|| not_a_number(name, text, *place))?;
    }
    Ok(pinhole)
}

/// k1 to k4, p1 and p2, as far as they are there, in the order of the file.
fn distortion(section: &Section) -> Vec<f64> {
    let is_one = |key: &str| key.len() == 2 && key.starts_with(['k', 'p']);
    let all = section.entries.iter().filter(|(key, ..)| is_one(key));
    coefficients(all.map(|(_, text, _)| number(text)).collect())
}

fn not_a_number(name: &str, text: &str, place: Place) -> Refusal {
    Refusal::NotANumber {
        format: FORMAT,
        name: name.to_owned(),
        place,
        text: text.to_owned(),
    }
}

fn sections(text: &str) -> Vec<Section> {
    let mut all: Vec<Section> = Vec::new();
    for line in lines(text) {
        if let Some(name) = line.text.strip_prefix('[').and_then(|rest| rest.strip_suffix(']')) {
            all.push(Section {
                name: name.trim().to_ascii_uppercase(),
                place: line.place,
                entries: Vec::new(),
            });
        } else if let (Some(section), Some((key, value))) = (all.last_mut(), line.text.split_once('=')) {
            let entry = (key.trim().to_ascii_lowercase(), value.trim().to_owned(), line.place);
            section.entries.push(entry);
        }
    }
    all
}
