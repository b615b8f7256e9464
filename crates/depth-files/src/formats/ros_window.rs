//! ROS: `binning_x`, `binning_y` and `roi` of a camera_info.
//!
//! Source: `sensor_msgs/CameraInfo`: K and P are of the full resolution, `roi` is in its pixels; `image_geometry`, `pinhole_camera_model.cpp`:
//! the offset is taken off first, then all is divided by the binning.

use super::matrix::{Projection, size};
use crate::camera::Camera;
use crate::checks::Pinhole;
use crate::format::Format;
use crate::node::Node;
use crate::refusal::Refusal;
use crate::warning::Warning;
use depth_core::quantity::Pixels;

/// Which part of what the camera sees its images are.
pub(super) struct Window {
    binning: [u32; 2],
    offset: [u32; 2],
    /// In pixels of the camera, where it is not all.
    size: Option<[u32; 2]>,
}

impl Window {
    pub(super) fn read(document: &Node) -> Result<Self, Refusal> {
        let count = |node: Option<&Node>, name: &str| match node {
            Some(node) => Ok(whole(node.number(Format::Ros, name)?)),
            None => Ok(0),
        };
        let roi = |name: &str| count(document.get("roi").and_then(|roi| roi.get(name)), name);
        let binning = |name: &str| count(document.get(name), name).map(|count| count.max(1));
        let sides = [roi("width")?, roi("height")?];
        Ok(Self {
            binning: [binning("binning_x")?, binning("binning_y")?],
            offset: [roi("x_offset")?, roi("y_offset")?],
            size: size(sides.map(f64::from)),
        })
    }

    /// Makes the numbers those of the images.
    pub(super) fn apply(&self, camera: &mut Camera, projection: &mut Option<Projection>, warnings: &mut Vec<Warning>) {
        let all = self.size.or(camera.size);
        let [columns, rows] = self.binning;
        let is_all = self.size.is_none() || self.size == camera.size;
        if self.binning == [1, 1] && self.offset == [0, 0] && is_all {
            return;
        }
        let size = all.map(|[width, height]| [width / columns, height / rows]);
        camera.size = size.filter(|size| !size.contains(&0));
        let pinhole = self.of([camera.fx, camera.fy, camera.cx, camera.cy].map(Pixels::px));
        [camera.fx, camera.fy, camera.cx, camera.cy] = pinhole.map(Pixels::new);
        if let Some(projection) = projection {
            let [tx, ty] = projection.shift;
            *projection = Projection {
                pinhole: self.of(projection.pinhole),
                shift: [tx / f64::from(columns), ty / f64::from(rows)],
                ..*projection
            };
        }
        warnings.push(Warning::Binned {
            camera: camera.name.clone(),
            binning: self.binning,
            offset: self.offset,
        });
    }

    fn of(&self, [fx, fy, cx, cy]: Pinhole) -> Pinhole {
        let ([x, y], [columns, rows]) = (self.offset.map(f64::from), self.binning.map(f64::from));
        [fx / columns, fy / rows, (cx - x) / columns, (cy - y) / rows]
    }
}

/// A number of pixels; 0 where it is none.
fn whole(number: f64) -> u32 {
    size([number, 1.0]).map_or(0, |[number, _]| number)
}
