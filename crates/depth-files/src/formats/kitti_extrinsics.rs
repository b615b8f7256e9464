//! KITTI: what `calib_cam_to_cam.txt` says of the cameras as they were measured, before anything was rectified.
//!
//! Source: the readme of the raw data: `R_xx` and `T_xx` lead from camera 0 to camera xx; `S_xx` is the size of the raw images, `K_xx` their
//! camera matrix.

use super::matrix::{of_matrix, size};
use crate::format::Format;
use crate::geometry::{Transform, Vector};
use crate::place::Origin;
use crate::refusal::Refusal;
use crate::text::{Line, lines};
use crate::warning::Warning;
use std::collections::HashMap;

const FORMAT: Format = Format::Kitti;
const UNTURNED: [Vector; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// The lines of a file with what was measured of its cameras.
pub(super) struct Extrinsics<'a> {
    stations: HashMap<&'a str, (Vector, Origin)>,
    outside: Vec<Warning>,
}

impl<'a> Extrinsics<'a> {
    pub(super) fn read(text: &'a str) -> Result<Self, Refusal> {
        let (rotations, shifts) = (by_number(text, "R_"), by_number(text, "T_"));
        let (matrices, sizes) = (by_number(text, "K_"), by_number(text, "S_"));
        let mut stations = HashMap::new();
        for (number, (line, values)) in shifts {
            let shift = line.array(values, FORMAT, "T", "3")?;
            let rotation = match rotations.get(number) {
                Some((line, values)) => {
                    let [a, b, c, d, e, f, g, h, i] = line.array(values, FORMAT, "R", "9")?;
                    [[a, b, c], [d, e, f], [g, h, i]]
                }
                None => UNTURNED,
            };
            let origin = line.place.origin(format!("T_{number}"));
            stations.insert(number, (Transform::new(rotation, shift).origin(), origin));
        }
        let mut outside = Vec::new();
        for (number, (line, values)) in matrices {
            let [_, _, cx, cy] = of_matrix(line.array(values, FORMAT, "K", "9")?);
            let Some((line, values)) = sizes.get(number) else { continue };
            let Some(sides) = size(line.array(values, FORMAT, "S", "2")?) else {
                continue;
            };
            let found = [cx, cy].into_iter().zip(sides).find(|(at, side)| *at > f64::from(*side));
            let camera = format!("camera {number}");
            outside.extend(found.map(|(principal, side)| Warning::RawSizeContradicts { camera, principal, side }));
        }
        // A map has no order.
        outside.sort_by_key(ToString::to_string);
        outside.dedup();
        Ok(Self { stations, outside })
    }

    /// Where the camera of this number stands, in meters from camera 0.
    pub(super) fn station(&self, number: &str) -> Option<(Vector, Origin)> {
        self.stations.get(number).cloned()
    }

    /// That principal points of raw images lie outside of them.
    pub(super) fn outside(self) -> Vec<Warning> {
        self.outside
    }
}

/// The lines whose keys begin so, with what comes behind the colon, by the numbers of their cameras.
fn by_number<'a>(text: &'a str, start: &str) -> HashMap<&'a str, (Line<'a>, &'a str)> {
    let named = |line: Line<'a>| {
        let (number, values) = line.text.strip_prefix(start)?.split_once(':')?;
        let is_number = !number.is_empty() && number.chars().all(|one| one.is_ascii_digit());
        is_number.then_some((number, (line, values)))
    };
    lines(text).filter_map(named).collect()
}
