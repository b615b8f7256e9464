//! What people call the matrices of OpenCV.

use crate::node::{Node, Value};

/// All that may be a number or a matrix in `document`, however deep, by its key in small letters without `_`, `-` and `.`.
pub(super) fn parts(document: &Node) -> Vec<(String, &Node)> {
    let mut all = Vec::new();
    collect(document, "", &mut all);
    all
}

/// Adds what is in `node`. In the map of one camera the keys get its name behind them: `left: {K: …}` is `Kleft`.
fn collect<'a>(node: &'a Node, camera: &str, all: &mut Vec<(String, &'a Node)>) {
    for (key, part) in node.entries() {
        let is_matrix = part.get("data").is_some() || !matches!(part.value, Value::Map(_));
        let key: String = key.chars().filter(|one| !"_-. ".contains(*one)).collect();
        let key = key.to_ascii_lowercase();
        if is_matrix {
            all.push((format!("{key}{camera}"), part));
        } else {
            let name = key.trim_start_matches("camera").trim_start_matches("cam");
            let is_camera = ["left", "right", "l", "r"].contains(&name);
            collect(
                part,
                if is_camera {
                    if name.starts_with('l') { "left" } else { "right" }
                } else {
                    camera
                },
                all,
            );
        }
    }
}

const MATRICES: [&str; 6] = ["m", "k", "cameramatrix", "mtx", "intrinsicmatrix", "intrinsics"];
const PROJECTIONS: [&str; 3] = ["p", "projectionmatrix", "projmat"];
pub(super) const TRANSLATIONS: [&str; 6] = ["t", "translationvector", "translation", "trans", "transmat", "tvec"];
pub(super) const SIZES: [&str; 5] = ["imagesize", "calibimagesize", "imgsize", "capsize", "size"];
pub(super) const WIDTHS: [[&str; 2]; 3] = [["imagewidth", "imageheight"], ["framewidth", "frameheight"], ["width", "height"]];
pub(super) const SQUARES: [&str; 3] = ["squaresize", "squaresizemm", "squaresizem"];
/// How the first and the second camera are told apart.
const FIRST: [&str; 3] = ["1", "left", "l"];
const SECOND: [&str; 3] = ["2", "right", "r"];

/// A part with one of these names.
pub(super) fn find<'a>(parts: &[(String, &'a Node)], names: &[&str]) -> Option<&'a Node> {
    names
        .iter()
        .find_map(|name| parts.iter().find(|(key, _)| key == name).map(|(_, node)| *node))
}

/// The matrices of one camera or of two.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Matrices<'a> {
    pub(super) first: Option<&'a Node>,
    pub(super) second: Option<&'a Node>,
}

impl<'a> Matrices<'a> {
    /// The camera matrices: of a single camera the first.
    pub(super) fn cameras(parts: &[(String, &'a Node)]) -> Self {
        let pair = Self::pair(parts, &MATRICES);
        let single = || find(parts, &MATRICES);
        Self {
            first: pair.first.or_else(single),
            ..pair
        }
    }

    /// The projection matrices.
    pub(super) fn projections(parts: &[(String, &'a Node)]) -> Self {
        Self::pair(parts, &PROJECTIONS)
    }

    /// P1 is the right one where there is a P0, and the left one where there is a P2.
    fn pair(parts: &[(String, &'a Node)], stems: &[&str]) -> Self {
        let of = |suffixes: &[&str]| {
            let names: Vec<String> = stems
                .iter()
                .flat_map(|stem| suffixes.iter().map(move |suffix| format!("{stem}{suffix}")))
                .collect();
            let names: Vec<&str> = names.iter().map(String::as_str).collect();
            find(parts, &names)
        };
        match of(&["0"]) {
            Some(first) => Self {
                first: Some(first),
                second: of(&["1"]),
            },
            None => Self {
                first: of(&FIRST),
                second: of(&SECOND),
            },
        }
    }
}

/// Whether one of these names is in it, or a translation, as in a file of extrinsics alone.
pub(super) fn is_known(document: &Node) -> bool {
    let parts = parts(document);
    let is_matrix = |node: &&Node| node.get("data").is_some() || !node.items().is_empty();
    let any = |matrices: Matrices<'_>| matrices.first.or(matrices.second).filter(is_matrix).is_some();
    any(Matrices::cameras(&parts)) || any(Matrices::projections(&parts)) || find(&parts, &TRANSLATIONS).filter(is_matrix).is_some()
}
