//! What the command line calls the ways to decode a stored number.

use super::disparity::DISPARITIES;
use super::way::Way;
use crate::field::Key;
use crate::fields::{STEPS_PER_METER, SUBPIXEL_BITS};

/// A name for a way that decodes a stored number, or for one of its commonest cases.
#[derive(Clone, Copy, Debug)]
pub struct EncodingName {
    /// The name.
    pub name: &'static str,
    /// What stores so, and the formula.
    pub help: &'static str,
    /// The key of the way among [`DISPARITIES`].
    pub way: &'static str,
    /// A field of the way and the number in it that the name stands for.
    pub fixed: Option<(Key, f64)>,
}

impl EncodingName {
    /// The way that it is a name for.
    pub fn way(&self) -> Option<&'static Way> {
        Way::named(DISPARITIES, self.way)
    }

    /// What is called `name`, in capitals or not.
    pub fn called(name: &str) -> Option<&'static Self> {
        ENCODING_NAMES.iter().find(|one| one.name.eq_ignore_ascii_case(name))
    }
}

const fn named(name: &'static str, way: &'static str, help: &'static str) -> EncodingName {
    EncodingName {
        name,
        help,
        way,
        fixed: None,
    }
}

const fn depth_ai(name: &'static str, bits: f64, help: &'static str) -> EncodingName {
    EncodingName {
        fixed: Some((SUBPIXEL_BITS, bits)),
        ..named(name, "depthai", help)
    }
}

const fn depth(name: &'static str, per_meter: f64, help: &'static str) -> EncodingName {
    EncodingName {
        fixed: Some((STEPS_PER_METER, per_meter)),
        ..named(name, "depth", help)
    }
}

/// Every name. Of no use to a page, which does not download them.
pub const ENCODING_NAMES: &[EncodingName] = &[
    named("opencv", "opencv", "StereoBM, StereoSGBM: sixteenths of a pixel"),
    named("kitti", "kitti", "KITTI disparity: p/256"),
    named("cityscapes", "cityscapes", "Cityscapes: (p - 1)/256"),
    named("realsense", "realsense", "RealSense D400 disparity: p/32"),
    depth_ai("depthai3", 3.0, "DepthAI with 3 sub-pixel bits: p/8"),
    depth_ai("depthai4", 4.0, "DepthAI with 4: p/16"),
    depth_ai("depthai5", 5.0, "DepthAI with 5: p/32"),
    named("ensenso", "ensenso", "Ensenso: p/16"),
    named("kinect1", "kinect1", "The first Kinect: (1090 - p)/8, with 580 px and 75 mm"),
    named("pfm", "pfm", "Middlebury, PFM: pixels as a real number"),
    named("zed", "zed", "ZED: the opposite sign"),
    named("fraction", "fraction", "A fraction of the image's width"),
    named("inverse-depth", "inverse-depth", "A network's inverse depth between two planes"),
    depth("depth-mm", 1000.0, "Depth in millimeters: RealSense, ScanNet"),
    depth("tum", 5000.0, "Depth of TUM RGB-D: p/5000"),
    depth("kitti-depth", 256.0, "Depth of KITTI: p/256"),
    depth("vkitti", 100.0, "Depth of Virtual KITTI, in centimeters"),
    named("depth", "depth", "Any other depth, with --per-meter"),
    named("carla", "carla", "Depth in three channels of CARLA"),
    named("da3-metric", "da3-metric", "Depth Anything 3, metric: f·p/300"),
    named("metric3d", "metric3d", "Metric3D: p·f/1000"),
];
