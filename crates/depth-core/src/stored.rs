//! What a file stores of the depth of a pixel, and how far away that is.
//!
//! The other half of what pictures store are disparities: [`disparity::Encoding`](crate::disparity::Encoding).

use crate::disparity::NoDisparity;
use crate::quantity::{Length, Pixels};

/// How a depth is written down.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DepthEncoding {
    /// 16-bit unsigned, so many steps in a meter; 0 and 65 535 where there is none.
    ///
    /// Sources: 1000: RealSense, ScanNet; 5000: TUM RGB-D; 256: KITTI depth; 100: Virtual KITTI.
    Steps {
        /// Steps in a meter.
        per_meter: f64,
    },
    /// 24 bits in three channels, R + 256·G + 65 536·B, of which all are 1 000 m; all bits set for the sky.
    ///
    /// Source: CARLA, sensors reference, depth camera.
    ThreeChannels,
    /// Where a network's answer is an inverse depth between those of a near and a far plane, 1/Z = 1/far + (1/near − 1/far)·x.
    ///
    /// Source: monodepth2, `disp_to_depth`, and its stereo scale of 5.4 for KITTI.
    Inverse {
        /// The near plane, in the unit of the network.
        near: f64,
        /// The far plane.
        far: f64,
        /// Meters in that unit.
        scale: f64,
    },
    /// A network's answer for a focal length of 300 px, Z = f·x/300.
    ///
    /// Source: Depth Anything 3, issue 226, the metric model.
    DepthAnything3 {
        /// The focal length of the image that the network was given.
        focal_length: Pixels,
    },
    /// A network's answer for a canonical camera of 1000 px, Z = x·f/1000.
    ///
    /// Source: Metric3D, README.
    Metric3D {
        /// The focal length of the image that the network was given.
        focal_length: Pixels,
    },
}

/// All bits of 24.
const ALL_BITS: f64 = 16_777_215.0;

impl DepthEncoding {
    /// How far away that is for which `stored` stands.
    ///
    /// ```
    /// use depth_core::quantity::Length;
    /// use depth_core::stored::DepthEncoding;
    ///
    /// // Millimeters.
    /// assert_eq!(DepthEncoding::Steps { per_meter: 1000.0 }.decode(1400.0), Ok(Length::from_m(1.4)));
    /// ```
    ///
    /// # Errors
    /// [`NoDisparity`].
    pub fn decode(self, stored: f64) -> Result<Length, NoDisparity> {
        let is_network = !matches!(self, Self::Steps { .. } | Self::ThreeChannels);
        if is_network && !stored.is_finite() {
            return Err(NoDisparity::Invalid);
        }
        if is_network && stored < 0.0 || matches!(self, Self::Inverse { .. }) && stored > 1.0 {
            return Err(NoDisparity::OutOfRange);
        }
        let meters = match self {
            Self::Steps { per_meter } => whole(stored, 65_535.0)? / per_meter,
            Self::ThreeChannels => whole(stored, ALL_BITS)? / ALL_BITS * 1000.0,
            Self::Inverse { near, far, scale } => scale / (1.0 / far + (1.0 / near - 1.0 / far) * stored),
            Self::DepthAnything3 { focal_length } => focal_length.px() * stored / 300.0,
            Self::Metric3D { focal_length } => stored * focal_length.px() / 1000.0,
        };
        if meters == 0.0 {
            return Err(NoDisparity::Invalid);
        }
        if meters.is_finite() && meters > 0.0 {
            Ok(Length::from_m(meters))
        } else {
            Err(NoDisparity::OutOfRange)
        }
    }
}

/// `stored`, where it is a whole number from 1 to below `most`: both ends mark that there is nothing.
fn whole(stored: f64, most: f64) -> Result<f64, NoDisparity> {
    if !(0.0..=most).contains(&stored) {
        Err(NoDisparity::OutOfRange)
    } else if stored.fract() != 0.0 {
        Err(NoDisparity::NotWhole)
    } else if stored == 0.0 || stored == most {
        Err(NoDisparity::Invalid)
    } else {
        Ok(stored)
    }
}
