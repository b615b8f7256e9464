//! EuRoC: sensor.yaml, one for each camera. Meters.
//!
//! Source: Burri et al.: The EuRoC micro aerial vehicle datasets, 2016: `T_BS` leads from the sensor to the body.

use super::sensor::{Named, Station, pair_up, read_camera};
use crate::format::Format;
use crate::found::Found;
use crate::node::Node;
use crate::refusal::Refusal;
use crate::warning::Warning;

const FORMAT: Format = Format::Euroc;

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let mut found = Found::of(FORMAT);
    let mut stations = Vec::new();
    for (index, document) in documents.iter().enumerate() {
        if document.get("intrinsics").is_none() {
            return Err(Refusal::Other {
                what: "the sensor.yaml of an IMU or another sensor, not of a camera",
                todo: "Give those of cam0 and cam1.",
            });
        }
        let camera = read_camera(
            FORMAT,
            &format!("cam{index}"),
            (document, "distortion_coefficients"),
            &mut found.warnings,
        )?;
        found.add(camera)?;
        stations.push(Station {
            link: None,
            pose: Named::read(document, FORMAT, &["T_BS"])?,
        });
    }
    pair_up(&mut found, &stations)?;
    for pair in &mut found.pairs {
        // The files come in any order.
        pair.warnings
            .retain(|warning| !matches!(warning, Warning::Swapped | Warning::SwappedRows));
    }
    found.take_first_pair();
    match (found.cameras.len(), found.pair) {
        (1, _) => found.warnings.push(Warning::OneOfPair { other: "of cam1" }),
        (_, Some(_)) => found.warnings.push(Warning::Raw { format: FORMAT }),
        _ => found.warnings.push(Warning::NoBaseline { format: FORMAT }),
    }
    Ok(found)
}
