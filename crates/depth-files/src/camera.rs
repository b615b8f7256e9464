//! A camera of a file.

use crate::place::Origin;
use depth_core::quantity::Pixels;

/// One camera.
#[derive(Clone, Debug, PartialEq)]
pub struct Camera {
    /// What the file calls it.
    pub name: String,
    /// Width and height of the images that the numbers are of.
    pub size: Option<[u32; 2]>,
    /// The focal lengths.
    pub fx: Pixels,
    /// The same, up and down.
    pub fy: Pixels,
    /// The principal point.
    pub cx: Pixels,
    /// The same, up and down.
    pub cy: Pixels,
    /// Of which images.
    pub basis: Basis,
    /// Where the focal lengths and the principal point come from.
    pub origin: Origin,
    /// The coefficients of the distortion, in the order of the file; none where the file has none.
    pub distortion: Vec<f64>,
    /// The name of the model, of the distortion or of the camera, where the file says one.
    pub model: Option<String>,
    /// 1 σ of fx, fy, cx and cy, where the file says it.
    pub sigma: Option<[Pixels; 4]>,
}

/// Of which images a focal length is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Basis {
    /// As they come from the camera.
    Raw,
    /// Without distortion, with the same rows in both.
    Rectified,
}
