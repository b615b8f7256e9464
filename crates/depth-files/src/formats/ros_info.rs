//! ROS: what one `camera_info` says of its camera: by P where that can be used, else by K.

use super::matrix::{Projection, scaled};
use crate::camera::{Basis, Camera};
use crate::checks::{Pinhole, camera, contradict, resized, unusable};
use crate::format::Format;
use crate::place::Origin;
use crate::refusal::Refusal;
use crate::warning::Warning;

const FORMAT: Format = Format::Ros;

/// What one message says.
pub(super) struct Info {
    pub(super) camera: Camera,
    /// P, where it can be used.
    pub(super) projection: Option<Projection>,
}

impl Info {
    /// Whether `other` is the same message again in the same file.
    pub(super) fn is_repeated_by(&self, other: &Self) -> bool {
        let (one, two) = (&self.camera, &other.camera);
        let origin = &one.origin;
        let is_same = Camera {
            origin: origin.clone(),
            ..two.clone()
        } == *one;
        let shift = |info: &Self| info.projection.map(|projection| projection.shift);
        origin.file == two.origin.file && is_same && shift(self) == shift(other)
    }
}

/// What a file has of a camera, and where it stands.
pub(super) type Placed<T> = Option<(T, Origin)>;

/// A camera of P where that can be used, else of K.
pub(super) fn of_matrices(
    name: &str,
    size: Option<[u32; 2]>,
    (projection, matrix): (Placed<Projection>, Placed<Pinhole>),
    warnings: &mut Vec<Warning>,
) -> Result<Info, Refusal> {
    if let Some((projection, origin)) = projection {
        let of_another = matrix.as_ref().is_some_and(|(matrix, _)| contradict(projection.pinhole, *matrix));
        let why = of_another.then(|| "its focal length is many times that of the camera, or a fraction of it".to_owned());
        match scaled(projection).or_else(|| unusable(projection.pinhole, size)).or(why) {
            None => {
                let resized = matrix.as_ref().and_then(|(raw, _)| resized(projection.pinhole, *raw, size?));
                if let (Some(ratio), Some(size)) = (resized, size) {
                    let camera = name.to_owned();
                    warnings.push(Warning::RectifiedSize { camera, size, ratio });
                }
                let size = size.filter(|_| resized.is_none());
                return Ok(Info {
                    camera: camera(FORMAT, name, projection.pinhole, (size, Basis::Rectified, origin))?,
                    projection: Some(projection),
                });
            }
            Some(why) => warnings.push(Warning::RectificationUnusable { why }),
        }
    }
    let Some((matrix, origin)) = matrix else {
        return Err(Refusal::Missing {
            format: FORMAT,
            what: "usable K or P",
        });
    };
    Ok(Info {
        camera: camera(FORMAT, name, matrix, (size, Basis::Raw, origin))?,
        projection: None,
    })
}
