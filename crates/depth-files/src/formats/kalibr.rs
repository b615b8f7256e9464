//! Kalibr: camchain.yaml, also as OpenVINS has it. Meters.
//!
//! Source: the Kalibr wiki, “Yaml formats”: `T_cn_cnm1` leads from the camera before to this one, `T_cam_imu` from the IMU to the camera.

use super::sensor::{Named, Station, pair_up, read_camera};
use crate::format::Format;
use crate::found::Found;
use crate::node::Node;
use crate::refusal::Refusal;
use crate::warning::Warning;

const FORMAT: Format = Format::Kalibr;

/// The cameras of a chain: `cam0`, `cam1` and so on, with their names.
pub(super) fn cameras(document: &Node) -> impl Iterator<Item = (&str, &Node)> {
    document.entries().filter(|(name, node)| {
        let number = name.strip_prefix("cam").unwrap_or_default();
        let is_numbered = !number.is_empty() && number.chars().all(|one| one.is_ascii_digit());
        is_numbered && (node.get("intrinsics").is_some() || node.get("T_cn_cnm1").is_some())
    })
}

fn number(name: &str) -> Option<u32> {
    name.strip_prefix("cam")?.parse().ok()
}

pub(super) fn read(documents: &[&Node]) -> Result<Found, Refusal> {
    let mut all: Vec<(&str, &Node)> = documents.iter().flat_map(|document| cameras(document)).collect();
    all.sort_by_key(|(name, _)| number(name));
    let mut found = Found::of(FORMAT);
    let mut stations = Vec::new();
    let mut before = None;
    for (name, node) in &all {
        let camera = read_camera(FORMAT, name, (node, "distortion_coeffs"), &mut found.warnings)?;
        found.add(camera)?;
        let mut station = station(node)?;
        // It leads from the camera whose number is less by one, which may not be there.
        let is_next = number(name)
            .zip(before.flatten())
            .is_none_or(|(this, before): (u32, u32)| this == before + 1);
        station.link = station.link.filter(|_| is_next);
        before = Some(number(name));
        stations.push(station);
    }
    pair_up(&mut found, &stations)?;
    found.take_first_pair();
    if found.pair.is_some() {
        found.warnings.push(Warning::Raw { format: FORMAT });
    } else {
        found.warnings.push(Warning::NoBaseline { format: FORMAT });
    }
    Ok(found)
}

fn station(node: &Node) -> Result<Station, Refusal> {
    let link = Named::read(node, FORMAT, &["T_cn_cnm1", "baseline_last_to_this_cam"])?;
    let to_imu = Named::read(node, FORMAT, &["T_imu_cam"])?;
    let of_imu = Named::read(node, FORMAT, &["T_cam_imu"])?.map(|named| Named {
        transform: named.transform.inverse(),
        ..named
    });
    Ok(Station {
        link,
        pose: to_imu.or(of_imu),
    })
}
