//! What the tests of the formats share.

#![allow(dead_code, clippy::unwrap_used, clippy::panic, reason = "tests, of which each uses some of it")]

use depth_files::{Baseline, Camera, Found, Refusal, read};
use std::fs;
use std::path::Path;

/// What a file below `tests/data` holds.
pub fn bytes(name: &str) -> Vec<u8> {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name);
    fs::read(&path).unwrap_or_else(|error| panic!("{name}: {error}"))
}

pub fn answer(names: &[&str]) -> Result<Found, Refusal> {
    let files: Vec<Vec<u8>> = names.iter().map(|name| bytes(name)).collect();
    let files: Vec<&[u8]> = files.iter().map(Vec::as_slice).collect();
    read(&files)
}

pub fn found(names: &[&str]) -> Found {
    answer(names).unwrap_or_else(|refusal| panic!("{names:?}: {refusal}"))
}

/// Why files are refused.
pub fn refused(names: &[&str]) -> String {
    match answer(names) {
        Ok(found) => panic!("{names:?}: {found:?}"),
        Err(refusal) => refusal.to_string(),
    }
}

/// fx, fy, cx and cy in pixels.
pub fn pinhole(camera: &Camera) -> [f64; 4] {
    [camera.fx, camera.fy, camera.cx, camera.cy].map(|one| one.px())
}

/// The baseline in meters, or in the unit of the file where it does not say which.
pub fn value(found: &Found) -> f64 {
    match found.baseline {
        Some(Baseline::Known(length)) => length.m(),
        Some(Baseline::InFileUnits { value, .. }) => value,
        None => panic!("no baseline in {found:?}"),
    }
}

pub fn said(found: &Found) -> String {
    let all: Vec<String> = found.warnings.iter().map(ToString::to_string).collect();
    all.join(" ")
}
