//! Bouguet’s calibration toolbox for MATLAB: Calib_Results.m, and what the toolbox prints, of one camera or of two.
//!
//! Source: J.-Y. Bouguet: Camera Calibration Toolbox for MATLAB, `saving_calib_ascii.m` and `show_stereo_calib_results.m`. The toolbox says of
//! its errors that they are “approximately three times the standard deviations”.

use super::matrix::{place_pair, size};
use crate::camera::{Basis, Camera};
use crate::checks::{camera, coefficients};
use crate::format::Format;
use crate::found::Found;
use crate::geometry::length;
use crate::number::numbers;
use crate::place::Place;
use crate::refusal::Refusal;
use crate::text::{Line, lines};
use crate::units::in_file_units;
use crate::warning::Warning;
use depth_core::quantity::Pixels;

const FORMAT: Format = Format::Bouguet;
/// The toolbox prints eleven at a time: nobody keeps so many runs.
const MOST_ASSIGNMENTS: usize = 1_000;
/// How many standard deviations an error of the toolbox is.
const SIGMAS: f64 = 3.0;

/// A variable of MATLAB with what is assigned to it.
struct Assignment<'a> {
    name: &'a str,
    /// All that stands behind the `=`.
    text: String,
    place: Place,
}

pub(crate) fn is_bouguet(text: &str) -> bool {
    let all = assignments(text);
    ["", "_left", "_right"]
        .iter()
        .any(|side| ["fc", "cc"].iter().all(|stem| find(&all, &format!("{stem}{side}")).is_some()))
}

pub(super) fn read(text: &str) -> Result<Found, Refusal> {
    let all = assignments(text);
    let mut found = Found::of(FORMAT);
    for (name, side) in [("camera", ""), ("left", "_left"), ("right", "_right")] {
        if find(&all, &format!("fc{side}")).is_some() {
            found.cameras.push(read_camera(&all, name, side)?);
        }
    }
    if found.cameras.len() != 2 {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
        return Ok(found);
    }
    found.pair = Some([0, 1]);
    found.warnings.push(Warning::Raw { format: FORMAT });
    match find(&all, "T") {
        Some(one) => {
            let shift @ [x, y, _] = one.array("3")?;
            let value = length(shift);
            place_pair(&mut found, [0, 1], [-x, -y]);
            found.measure((value > 0.0).then(|| in_file_units(value, None)), one.place.origin("|T|"));
        }
        None => found.warnings.push(Warning::NoExtrinsics),
    }
    Ok(found)
}

fn read_camera(all: &[Assignment<'_>], name: &str, side: &str) -> Result<Camera, Refusal> {
    let get = |stem: &str| find(all, &format!("{stem}{side}"));
    let missing = Refusal::Missing {
        format: FORMAT,
        what: "fc and cc of a camera",
    };
    let (Some(focal), Some(principal)) = (get("fc"), get("cc")) else {
        return Err(missing);
    };
    let ([fx, fy], [cx, cy]) = (focal.array("2")?, principal.array("2")?);
    let side_of_image = |stem: &str| {
        let one = get(stem).or_else(|| find(all, stem));
        one.map_or(Ok([f64::NAN]), |one| one.array("1"))
    };
    let ([width], [height]) = (side_of_image("nx")?, side_of_image("ny")?);
    let origin = focal.place.origin(format!("{}, {}", focal.name, principal.name));
    let distortion = get("kc").and_then(|one| numbers(one.value()));
    Ok(Camera {
        distortion: coefficients(distortion),
        sigma: sigmas(all, focal).zip(sigmas(all, principal)).map(|([fx, fy], [cx, cy])| {
            let sigma = [fx, fy, cx, cy];
            sigma.map(Pixels::new)
        }),
        ..camera(FORMAT, name, [fx, fy, cx, cy], (size([width, height]), Basis::Raw, origin))?
    })
}

/// The standard deviations of two numbers, of what is printed behind them or of their variable; nothing where they are zero, as before the
/// toolbox has estimated them.
fn sigmas(all: &[Assignment<'_>], of: &Assignment<'_>) -> Option<[f64; 2]> {
    let printed = of.text.split_once("+/-").map(|(_, error)| error.to_owned());
    let names = [format!("{}_error", of.name), of.name.replace('_', "_error_")];
    let assigned = || names.iter().find_map(|name| find(all, name)).map(|one| one.text.clone());
    let errors = <[f64; 2]>::try_from(numbers(inner(&printed.or_else(assigned)?))?).ok()?;
    let are_some = errors.iter().all(|one| one.is_finite() && *one > 0.0);
    are_some.then(|| errors.map(|one| one / SIGMAS))
}

/// The last assignment to a variable: the toolbox prints what it began with above what it arrived at.
fn find<'a, 'b>(all: &'a [Assignment<'b>], name: &str) -> Option<&'a Assignment<'b>> {
    all.iter().rev().find(|one| one.name == name)
}

impl Assignment<'_> {
    /// What stands between its brackets, or without any before the semicolon or the remark.
    fn value(&self) -> &str {
        inner(self.text.split("+/-").next().unwrap_or_default())
    }

    fn array<const N: usize>(&self, expected: &'static str) -> Result<[f64; N], Refusal> {
        let line = Line {
            place: self.place,
            text: self.value(),
        };
        line.array(line.text, FORMAT, self.name, expected)
    }
}

fn inner(text: &str) -> &str {
    let inside = text.split_once('[').map_or(text, |(_, inside)| inside);
    inside.split([']', '%']).next().unwrap_or_default().trim()
}

/// The variables that are needed: `fc = [ 700.5 ; 701.25 ];`, or as printed, with words in front and `+/- [ 3.1 2.9 ]` behind.
fn assignments(text: &str) -> Vec<Assignment<'_>> {
    let mut all: Vec<Assignment<'_>> = Vec::new();
    // A matrix goes on in the next lines until its bracket is closed.
    let mut is_open = false;
    for line in lines(text) {
        for code in statements(line.text, is_open) {
            if all.len() >= MOST_ASSIGNMENTS {
                return all;
            }
            let assigned = code.split_once('=').and_then(|(before, rest)| {
                let name = before.split_whitespace().next_back()?;
                Some((name, rest))
            });
            match (assigned, all.last_mut().filter(|_| is_open)) {
                (Some((name, rest)), _) => {
                    is_open = is_needed(name) && rest.contains('[') && !rest.contains(']');
                    if is_needed(name) {
                        let (text, place) = (rest.to_owned(), line.place);
                        all.push(Assignment { name, text, place });
                    }
                }
                (None, Some(last)) => {
                    last.text.push(';');
                    last.text.push_str(code);
                    is_open = !code.contains(']');
                }
                (None, None) => {}
            }
        }
    }
    all
}

/// What a line holds up to a remark, without the semicolons between: `nx = 640; ny = 480; % the size`. What was printed is often kept as a remark.
fn statements(line: &str, mut is_open: bool) -> impl Iterator<Item = &str> {
    let line = line.trim_start_matches('%');
    let code = line.split('%').next().unwrap_or_default();
    code.split(move |character| {
        is_open = character == '[' || is_open && character != ']';
        character == ';' && !is_open
    })
}

fn is_needed(name: &str) -> bool {
    let stem = name.replace("_error", "").replace("_left", "").replace("_right", "");
    ["fc", "cc", "kc", "nx", "ny", "T"].contains(&stem.as_str())
}
