//! What EuRoC and Kalibr have in common: how a camera is described, and where it stands to the others.

use super::matrix::{place_pair, size};
use crate::camera::{Basis, Camera};
use crate::checks::{camera, in_meters, same_length};
use crate::format::Format;
use crate::found::Found;
use crate::geometry::{Transform, distance, length};
use crate::node::Node;
use crate::place::Place;
use crate::refusal::Refusal;
use crate::warning::Warning;

/// Cameras of a rig that stand farther apart in their file are no pair.
const FARTHEST: usize = 64;
/// Models of a fisheye lens that come after a pinhole.
const FISHEYES: [&str; 2] = ["equidistant", "fov"];

/// One camera: `camera_model`, `intrinsics`, `resolution` and the distortion, whose coefficients have the key `coefficients`.
pub(super) fn read_camera(
    format: Format,
    name: &str,
    (node, coefficients): (&Node, &str),
    warnings: &mut Vec<Warning>,
) -> Result<Camera, Refusal> {
    let text = |key: &str| node.get(key).and_then(Node::text).unwrap_or_default().to_owned();
    let model = text("camera_model");
    if !["", "pinhole"].contains(&model.as_str()) {
        return Err(Refusal::NotPinhole {
            format,
            model,
            place: node.get("camera_model").map_or(node.place, |model| model.place),
        });
    }
    let distortion = text("distortion_model");
    if FISHEYES.contains(&distortion.as_str()) {
        warnings.push(Warning::Fisheye {
            camera: name.to_owned(),
            model: distortion.clone(),
        });
    }
    let Some(intrinsics) = node.get("intrinsics") else {
        return Err(Refusal::Missing {
            format,
            what: "intrinsics",
        });
    };
    let pinhole = intrinsics.array(format, "intrinsics", "4")?;
    let size = match node.get("resolution") {
        Some(node) => size(node.array(format, "resolution", "2")?),
        None => None,
    };
    let origin = intrinsics.place.origin("intrinsics");
    Ok(Camera {
        distortion: Node::coefficients(node.get(coefficients), format),
        model: Some(distortion).filter(|model| !model.is_empty()),
        ..camera(format, name, pinhole, (size, Basis::Raw, origin))?
    })
}

/// A transform of a file, by its name there.
#[derive(Clone, Copy, Debug)]
pub(super) struct Named {
    pub(super) transform: Transform,
    pub(super) name: &'static str,
    pub(super) place: Place,
}

impl Named {
    /// The first of these names that `node` has.
    pub(super) fn read(node: &Node, format: Format, names: &[&'static str]) -> Result<Option<Self>, Refusal> {
        let Some((name, node)) = names.iter().find_map(|name| Some((*name, node.get(name)?))) else {
            return Ok(None);
        };
        Ok(Some(Self {
            transform: Transform::read(node, format, name)?,
            name,
            place: node.place,
        }))
    }
}

/// Where a camera stands.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Station {
    /// From the camera before it to this one.
    pub(super) link: Option<Named>,
    /// From this camera to a frame that all have in common.
    pub(super) pose: Option<Named>,
}

/// Makes pairs of all cameras that the stations say something between, those that follow each other first.
pub(super) fn pair_up(found: &mut Found, stations: &[Station]) -> Result<(), Refusal> {
    for step in 1..stations.len().min(FARTHEST) {
        if found.has_all_pairs() {
            break;
        }
        for (at, from_here) in stations.windows(step + 1).enumerate() {
            let Some(relation) = Relation::of(from_here) else { continue };
            found.pair_up([at, at + step], |two| relation.measure(two))?;
        }
    }
    Ok(())
}

/// How the last of some stations stands to the first.
struct Relation {
    /// From the first camera to the last.
    transform: Transform,
    length: f64,
    named: Named,
    /// Whether it is the file’s own number, and not one of several.
    is_plain: bool,
    /// What the poses say where there are links as well.
    by_poses: Option<(f64, Named)>,
}

impl Relation {
    fn of(stations: &[Station]) -> Option<Self> {
        let (first, rest) = stations.split_first()?;
        let last = rest.last()?;
        let by_poses = first.pose.zip(last.pose).map(|(one, other)| {
            let transform = other.transform.inverse().after(one.transform);
            (transform, distance(one.transform.shift, other.transform.shift), other)
        });
        let links: Option<Vec<Named>> = rest.iter().map(|station| station.link).collect();
        let by_links = links.and_then(|links| {
            let named = *links.last()?;
            let transforms = links.iter().map(|link| link.transform);
            let transform = transforms.reduce(|before, link| link.after(before))?;
            Some((transform, named))
        });
        match (by_links, by_poses) {
            (Some((transform, named)), by_poses) => Some(Self {
                transform,
                length: length(transform.shift),
                named,
                is_plain: rest.len() == 1,
                by_poses: by_poses.map(|(_, length, named)| (length, named)),
            }),
            (None, Some((transform, length, named))) => Some(Self {
                transform,
                length,
                named,
                is_plain: false,
                by_poses: None,
            }),
            (None, None) => None,
        }
    }

    fn measure(&self, two: &mut Found) -> Result<(), Refusal> {
        let Named { name, place, .. } = self.named;
        let how = match (self.is_plain, two.cameras.as_slice()) {
            (true, _) => format!("|t| of {name}"),
            (false, [first, second]) => format!("distance from {} to {} by {name}", first.name, second.name),
            _ => name.to_owned(),
        };
        let [right, down, ahead] = self.transform.origin();
        place_pair(two, [0, 1], [right, down]);
        if ahead.abs() > right.hypot(down) {
            two.warnings.retain(|warning| *warning != Warning::ZeroBaseline);
            two.warnings.push(Warning::Ahead);
        }
        let origin = place.origin(how);
        if let Some((length, named)) = self.by_poses {
            let other = named.place.origin(format!("distance by {}", named.name));
            two.warnings.extend(same_length((self.length, &origin), (length, &other)));
        }
        let baseline = in_meters(self.length, &mut two.warnings);
        two.measure(baseline, origin);
        Ok(())
    }
}
