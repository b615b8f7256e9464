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

/// The number of a camera by its comment: `VI-Sensor cam1 (MT9M034)`.
fn number(document: &Node) -> Option<usize> {
    let comment = document.get("comment")?.text()?;
    let words = comment.split(|one: char| !one.is_ascii_alphanumeric());
    words
        .filter_map(|word| word.strip_prefix("cam"))
        .find_map(|digits| digits.parse().ok())
}

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let mut found = Found::of(FORMAT);
    let mut stations = Vec::new();
    // The data sets say in a comment which camera it is; where that is not in all of the files, their order counts.
    let mut documents: Vec<(Option<usize>, &Node)> = documents.iter().map(|document| (number(document), *document)).collect();
    let mut numbers: Vec<usize> = documents.iter().filter_map(|(number, _)| *number).collect();
    numbers.sort_unstable();
    numbers.dedup();
    let are_numbered = numbers.len() == documents.len();
    if are_numbered {
        documents.sort_by_key(|(number, _)| *number);
    }
    for (index, (number, document)) in documents.iter().enumerate() {
        let index = number.filter(|_| are_numbered).unwrap_or(index);
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
    if !are_numbered && documents.len() > 1 {
        found.warnings.push(Warning::Unnumbered);
    }
    pair_up(&mut found, &stations)?;
    for pair in &mut found.pairs {
        // The files come in any order.
        pair.warnings
            .retain(|warning| !matches!(warning, Warning::Swapped | Warning::SwappedRows));
    }
    found.take_first_pair();
    match (found.cameras.len(), found.pair) {
        (1, _) => {
            let is_second = found.cameras.iter().any(|camera| camera.name == "cam1");
            let other = if is_second { "of cam0" } else { "of cam1" };
            found.warnings.push(Warning::OneOfPair { other });
        }
        (_, Some(_)) => found.warnings.push(Warning::Raw { format: FORMAT }),
        _ => found.warnings.push(Warning::NoBaseline { format: FORMAT }),
    }
    Ok(found)
}
