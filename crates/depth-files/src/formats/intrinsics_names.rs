//! What people call a focal length, a principal point and the size of an image.

use super::matrix::{of_columns, size};
use crate::checks::Pinhole;
use crate::format::Format;
use crate::node::{Node, Value};

const FORMAT: Format = Format::Intrinsics;

pub(super) const FX: [&str; 6] = ["fx", "flx", "focalx", "focallengthx", "focallengthpx", "fpx"];
pub(super) const FY: [&str; 4] = ["fy", "fly", "focaly", "focallengthy"];
/// Of one number or of two; of other trades too, if nothing of a camera stands beside them.
pub(super) const FOCALS: [&str; 3] = ["f", "focallength", "focal"];
pub(super) const CX: [&str; 6] = ["cx", "ppx", "principalx", "principalpointx", "u0", "centerx"];
pub(super) const CY: [&str; 6] = ["cy", "ppy", "principaly", "principalpointy", "v0", "centery"];
pub(super) const PRINCIPALS: [&str; 3] = ["principalpoint", "pp", "opticalcenter"];
/// Camera matrices that some write column by column.
const MATRICES: [&str; 5] = ["intrinsicmatrix", "intrinsics", "intrinsic", "k", "cameraintrinsics"];
const WIDTHS: [&str; 4] = ["width", "w", "imagewidth", "imgwidth"];
const HEIGHTS: [&str; 4] = ["height", "h", "imageheight", "imgheight"];
const SIZES: [&str; 7] = [
    "imagesize",
    "resolution",
    "imageresolution",
    "size",
    "imgsize",
    "calibimagesize",
    "framesize",
];

/// The entry with one of these names, which are in small letters without `_`, with its key; one that is no map.
pub(super) fn get<'a>(node: &'a Node, names: &[&str]) -> Option<(&'a str, &'a Node)> {
    entry(node, names).filter(|(_, part)| !matches!(part.value, Value::Map(_)))
}

fn entry<'a>(node: &'a Node, names: &[&str]) -> Option<(&'a str, &'a Node)> {
    let is_it = |key: &str, name: &str| {
        let letters = key.chars().filter(|one| !"_-. ".contains(*one));
        letters.map(|one| one.to_ascii_lowercase()).eq(name.chars())
    };
    names.iter().find_map(|name| node.entries().find(|(key, _)| is_it(key, name)))
}

/// Whether a focal length stands in this map.
pub(super) fn has_focal(node: &Node) -> bool {
    let is_number = |(_, part): &(&str, &Node)| part.numbers(FORMAT, "").is_ok_and(|all| matches!(all.len(), 1 | 2));
    let has = |names: &[&str]| get(node, names).is_some();
    let has_number = |names: &[&str]| get(node, names).filter(is_number).is_some();
    let has_baseline = || entry(node, &["baseline", "baselinemm", "baselinecm", "baselinem"]).is_some();
    // A template has words for its numbers, and beside them what only a camera has.
    let is_named = has_number(&FX) || has(&FX) && (has(&FY) || has(&CX));
    is_named || has_number(&FOCALS) && (has(&CX) || has(&PRINCIPALS) || has_baseline())
}

/// A camera matrix column by column: its name, what it says, and where it stands.
pub(super) fn columns(node: &Node) -> Option<(&str, Pinhole, &Node)> {
    let (key, matrix) = get(node, &MATRICES)?;
    let numbers = matrix.array(FORMAT, key, "9").ok()?;
    Some((key, of_columns(numbers)?, matrix))
}

/// The width and the height of the images.
pub(super) fn size_of(node: &Node) -> Option<[u32; 2]> {
    let sides = |node: &Node| {
        let side = |names: &[&str]| get(node, names).and_then(|(key, part)| part.number(FORMAT, key).ok());
        Some([side(&WIDTHS)?, side(&HEIGHTS)?])
    };
    let listed = |(key, part): (&str, &Node)| sides(part).or_else(|| part.array(FORMAT, key, "2").ok());
    sides(node).or_else(|| entry(node, &SIZES).and_then(listed)).and_then(size)
}
