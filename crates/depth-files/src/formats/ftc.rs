//! FTC robots: teamwebcamcalibrations.xml, of many cameras, each for some sizes of its images. Without a baseline.
//!
//! Source: the remarks in that file, in the FtcRobotController of FIRST: names are written `focalLength` or `focal_length`.

use super::matrix::size;
use crate::camera::{Basis, Camera};
use crate::carrier::FTC_ROOT;
use crate::checks::{camera, coefficients};
use crate::format::Format;
use crate::found::Found;
use crate::node::Node;
use crate::number::numbers;
use crate::refusal::Refusal;
use crate::text::Line;
use crate::warning::Warning;

const FORMAT: Format = Format::Ftc;

pub(super) fn read(document: &Node) -> Result<Found, Refusal> {
    let mut found = Found::of(FORMAT);
    let root = document.get(FTC_ROOT).into_iter();
    let cameras = root.flat_map(Node::entries).filter(|(name, _)| *name == "Camera");
    for (_, node) in cameras {
        let id = [get(node, "vid"), get(node, "pid")].map(|part| part.and_then(Node::text).unwrap_or("?"));
        for (_, calibration) in node.entries().filter(|(name, _)| *name == "Calibration") {
            read_calibration(&mut found, &id.join(" "), calibration)?;
        }
    }
    if found.cameras.is_empty() {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "Calibration outside of its remarks: take away the <!-- and the --> around that of your camera",
        });
    }
    found.warnings.push(Warning::NoBaseline { format: FORMAT });
    Ok(found)
}

/// The attribute or element with this name, with or without `_`, in whatever case.
fn get<'a>(node: &'a Node, name: &str) -> Option<&'a Node> {
    let is_it = |key: &str| key.replace('_', "").eq_ignore_ascii_case(name);
    node.entries().find(|(key, _)| is_it(key)).map(|(_, node)| node)
}

fn read_calibration(found: &mut Found, id: &str, node: &Node) -> Result<(), Refusal> {
    let [width, height] = array(node, "size")?;
    let name = format!("{id} {width} × {height}");
    if get(node, "remove")
        .and_then(Node::text)
        .is_some_and(|text| text.eq_ignore_ascii_case("true"))
    {
        found
            .ignored
            .push(format!("{name}: it is there to remove one, by its attribute remove"));
        return Ok(());
    }
    let ([fx, fy], [cx, cy]) = (array(node, "focalLength")?, array(node, "principalPoint")?);
    let origin = node.place.origin("focalLength, principalPoint");
    let distortion = get(node, "distortionCoefficients").and_then(Node::text).and_then(numbers);
    found.add(Camera {
        distortion: coefficients(distortion),
        ..camera(FORMAT, &name, [fx, fy, cx, cy], (size([width, height]), Basis::Raw, origin))?
    })
}

/// Two numbers with blanks or commas between them.
fn array(node: &Node, name: &'static str) -> Result<[f64; 2], Refusal> {
    let Some(text) = get(node, name).and_then(Node::text) else {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: name,
        });
    };
    let place = node.place;
    Line { place, text }.array(text, FORMAT, name, "2")
}
