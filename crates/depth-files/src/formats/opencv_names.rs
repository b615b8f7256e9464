//! What people call the matrices of OpenCV.

use crate::format::Format;
use crate::node::{Node, Value};
use crate::place::Origin;
use depth_core::quantity::LengthUnit;

/// A part of a file that may be a number or a matrix.
#[derive(Clone, Debug)]
pub(super) struct Part<'a> {
    /// Its key in small letters without `_`, `-` and `.`, with `left` or `right` behind it where it is in the map of one camera.
    pub(super) key: String,
    /// What the file calls it.
    pub(super) name: String,
    pub(super) node: &'a Node,
}

impl Part<'_> {
    /// Where it stands, with its name.
    pub(super) fn origin(&self) -> Origin {
        self.node.place.origin(self.name.clone())
    }
}

/// All that may be a number or a matrix in `document`, however deep.
pub(super) fn parts(document: &Node) -> Vec<Part<'_>> {
    let mut all = Vec::new();
    collect(document, "", &mut all);
    all
}

/// Adds what is in `node`. In the map of one camera the keys get its name behind them: `left: {K: …}` is `Kleft`.
fn collect<'a>(node: &'a Node, camera: &str, all: &mut Vec<Part<'a>>) {
    for (written, part) in node.entries() {
        let is_matrix = part.get("data").is_some() || !matches!(part.value, Value::Map(_));
        let key: String = written.chars().filter(|one| !"_-. ".contains(*one)).collect();
        let key = key.to_ascii_lowercase();
        if is_matrix {
            let name = if camera.is_empty() {
                written.to_owned()
            } else {
                format!("{written} of {camera}")
            };
            let key = format!("{key}{camera}");
            all.push(Part { key, name, node: part });
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

const DISTORTIONS: [&str; 8] = [
    "d",
    "distcoeffs",
    "distcoeff",
    "distortioncoefficients",
    "distortioncoeffs",
    "distortion",
    "dist",
    "kc",
];
const MATRICES: [&str; 6] = ["m", "k", "cameramatrix", "mtx", "intrinsicmatrix", "intrinsics"];
const PROJECTIONS: [&str; 3] = ["p", "projectionmatrix", "projmat"];
pub(super) const TRANSLATIONS: [&str; 6] = ["t", "translationvector", "translation", "trans", "transmat", "tvec"];
pub(super) const QS: [&str; 6] = [
    "q",
    "qmatrix",
    "matrixq",
    "disparitytodepthmappingmatrix",
    "disptodepthmatrix",
    "disparitytodepth",
];
pub(super) const SIZES: [&str; 5] = ["imagesize", "calibimagesize", "imgsize", "capsize", "size"];
pub(super) const WIDTHS: [[&str; 2]; 3] = [["imagewidth", "imageheight"], ["framewidth", "frameheight"], ["width", "height"]];
const SQUARES: [&str; 3] = ["squaresize", "squaresizemm", "squaresizem"];
const FISHEYE_FLAGS: [&str; 3] = ["fisheyemodel", "fisheye", "isfisheye"];
const MODELS: [&str; 5] = ["model", "cameramodel", "lensmodel", "modeltype", "cameratype"];
const UNITS: [&str; 6] = ["unit", "units", "lengthunit", "lengthunits", "baselineunit", "baselineunits"];
/// How the first and the second camera are told apart.
const FIRST: [&str; 3] = ["1", "left", "l"];
const SECOND: [&str; 3] = ["2", "right", "r"];

/// A part with one of these names.
pub(super) fn find<'p, 'a>(parts: &'p [Part<'a>], names: &[&str]) -> Option<&'p Part<'a>> {
    names.iter().find_map(|name| parts.iter().find(|part| part.key == *name))
}

/// The matrices of one camera or of two.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Matrices<'p, 'a> {
    pub(super) first: Option<&'p Part<'a>>,
    pub(super) second: Option<&'p Part<'a>>,
}

impl<'p, 'a> Matrices<'p, 'a> {
    /// The camera matrices: of a single camera the first.
    pub(super) fn cameras(parts: &'p [Part<'a>]) -> Self {
        let pair = Self::pair(parts, &MATRICES);
        let single = || find(parts, &MATRICES);
        Self {
            first: pair.first.or_else(single),
            ..pair
        }
    }

    /// The coefficients of the distortion: of a single camera the first.
    pub(super) fn distortions(parts: &'p [Part<'a>]) -> Self {
        let pair = Self::pair(parts, &DISTORTIONS);
        Self {
            first: pair.first.or_else(|| find(parts, &DISTORTIONS)),
            ..pair
        }
    }

    /// The projection matrices.
    pub(super) fn projections(parts: &'p [Part<'a>]) -> Self {
        Self::pair(parts, &PROJECTIONS)
    }

    /// P1 is the right one where there is a P0, and the left one where there is a P2.
    fn pair(parts: &'p [Part<'a>], stems: &[&str]) -> Self {
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

/// Whether a part is a matrix, by what it is written in.
fn is_matrix(part: &&Part<'_>) -> bool {
    part.node.get("data").is_some() || !part.node.items().is_empty()
}

/// Whether a camera matrix or a projection matrix is in it.
pub(super) fn has_matrix(document: &Node) -> bool {
    let parts = parts(document);
    let any = |matrices: Matrices<'_, '_>| matrices.first.or(matrices.second).filter(is_matrix).is_some();
    any(Matrices::cameras(&parts)) || any(Matrices::projections(&parts))
}

/// Whether one of these names is in it, or a translation, as in a file of extrinsics alone.
pub(super) fn is_known(document: &Node) -> bool {
    let parts = parts(document);
    let has = |names: &[&str]| find(&parts, names).filter(is_matrix).is_some();
    has_matrix(document) || has(&TRANSLATIONS) || has(&QS)
}

/// The size of the squares of the board, in the unit of whoever wrote it down.
pub(super) fn square(parts: &[Part<'_>]) -> Option<f64> {
    let numbers = find(parts, &SQUARES)?.node.numbers(Format::OpenCv, "the square").ok()?;
    numbers.first().copied().filter(|size| *size > 0.0)
}

/// The unit of its lengths, where a file says it under a key of its own.
pub(super) fn unit(parts: &[Part<'_>]) -> Option<LengthUnit> {
    let text = find(parts, &UNITS)?.node.text()?.trim().to_ascii_lowercase();
    match text.trim_end_matches('s') {
        "mm" | "millimeter" | "millimetre" => Some(LengthUnit::Millimeter),
        "cm" | "centimeter" | "centimetre" => Some(LengthUnit::Centimeter),
        "m" | "meter" | "metre" => Some(LengthUnit::Meter),
        "in" | "inch" | "inche" => Some(LengthUnit::Inch),
        _ => None,
    }
}

/// What a file calls the model of its lenses, where that is one of a fisheye lens.
pub(super) fn fisheye(parts: &[Part<'_>]) -> Option<String> {
    let text = |part: &Part<'_>| part.node.text().unwrap_or_default().trim().to_ascii_lowercase();
    let flag = find(parts, &FISHEYE_FLAGS).filter(|part| ["1", "true", "yes", "on"].contains(&text(part).as_str()));
    let model = || find(parts, &MODELS).map(text).filter(|text| is_fisheye(text));
    flag.map(|_| "fisheye".to_owned()).or_else(model)
}

fn is_fisheye(model: &str) -> bool {
    ["fisheye", "equidistant", "kannala"].iter().any(|name| model.contains(name))
}
