//! The ways to a disparity, most of them from what is stored for a pixel, and to doffs.

use super::stored::{NotStored, Stored, Values, finite, needed, not_zero, positive, wrong};
use super::way::{Compute, Way};
use crate::field::Key;
use crate::fields::{
    self, BLUE, DISPARITY, DOFFS, FAR_PLANE, FOCAL_LENGTH, FRAME_WIDTH, GREEN, MIN_DISPARITY, NEAR_PLANE, NETWORK_OUTPUT, NETWORK_SCALE,
    NO_MATCH, RED, STEPS_PER_METER, STEPS_PER_PIXEL, STORED_OFFSET, STORED_VALUE, SUBPIXEL_BITS,
};
use crate::note::Issue;
use depth_core::disparity::{self, Encoding, Linear, SubpixelBits};
use depth_core::measured::Measured;
use depth_core::quantity::Pixels;
use depth_core::stored::DepthEncoding;

const fn stored(key: &'static str, name: &'static str, remark: &'static str, encoding: Stored) -> Way {
    Way {
        key,
        name,
        remark,
        asks: &[STORED_VALUE],
        target: DISPARITY,
        compute: Compute::Stored(encoding),
    }
}

/// The ways to a disparity and to doffs.
pub const DISPARITIES: &[Way] = &[
    Way {
        key: "columns",
        name: "Columns in both images",
        remark: "d = x left − x right, in the rectified images.",
        asks: &[fields::LEFT_COLUMN, fields::RIGHT_COLUMN],
        target: DISPARITY,
        compute: Compute::Two(|left, right| {
            Ok(
                disparity::from_columns(Measured::from_base(left, 0.0), Measured::from_base(right, 0.0))
                    .value
                    .px(),
            )
        }),
    },
    Way {
        key: "opencv",
        name: "OpenCV StereoBM or StereoSGBM",
        remark: "They store sixteenths of a pixel in 16-bit numbers; (minDisparity − 1) · 16 means that nothing was found.",
        asks: &[STORED_VALUE, MIN_DISPARITY],
        target: DISPARITY,
        compute: Compute::StoredBy(opencv),
    },
    stored(
        "kitti",
        "KITTI, 16-bit image",
        "It stores 256ths of a pixel; 0 means that there is none.",
        Stored::Disparity(Encoding::Kitti),
    ),
    stored(
        "cityscapes",
        "Cityscapes, 16-bit image",
        "d = (stored − 1) / 256; 0 means that there is none.",
        Stored::Disparity(Encoding::Cityscapes),
    ),
    stored(
        "realsense",
        "RealSense D400, disparity",
        "It stores 32nds of a pixel; 0 means that there is none.",
        Stored::Disparity(Encoding::RealSense),
    ),
    Way {
        key: "depthai",
        name: "DepthAI, sub-pixel",
        remark: "With 3, 4 or 5 sub-pixel bits it stores 8ths, 16ths or 32nds of a pixel.",
        asks: &[STORED_VALUE, SUBPIXEL_BITS],
        target: DISPARITY,
        compute: Compute::StoredBy(depth_ai),
    },
    stored(
        "ensenso",
        "Ensenso",
        "It stores sixteenths of a pixel; −32768 means that there is none.",
        Stored::Disparity(Encoding::Ensenso),
    ),
    stored(
        "kinect1",
        "Kinect, the first one",
        "d = (1090 − stored) / 8; 2047 means that there is none. Its fx of 580 px and b of 75 mm are filled in too.",
        Stored::Disparity(Encoding::KinectV1),
    ),
    stored(
        "pfm",
        "Middlebury or PFM, floating point",
        "It stores pixels; inf means that there is none.",
        Stored::Disparity(Encoding::Pixels),
    ),
    Way {
        key: "zed",
        name: "ZED, negative sign",
        remark: "The ZED SDK gives disparities with the opposite sign.",
        asks: &[fields::ZED_DISPARITY],
        target: DISPARITY,
        compute: Compute::Stored(Stored::Disparity(Encoding::Zed)),
    },
    Way {
        key: "fraction",
        name: "Fraction of the image width",
        remark: "Some networks give the disparity as a part of the width of the image.",
        asks: &[fields::FRACTION, FRAME_WIDTH],
        target: DISPARITY,
        compute: Compute::StoredBy(fraction),
    },
    Way {
        key: "linear",
        name: "Any other: factor, offset, no match",
        remark: "d = (stored − offset) / steps in a pixel.",
        asks: &[STORED_VALUE, STEPS_PER_PIXEL, STORED_OFFSET, NO_MATCH],
        target: DISPARITY,
        compute: Compute::StoredBy(linear),
    },
    Way {
        key: "depth",
        name: "Depth: steps in a meter",
        remark: "Z = stored / steps; 0 and 65535 mean that there is none.",
        asks: &[STORED_VALUE, STEPS_PER_METER],
        target: DISPARITY,
        compute: Compute::StoredBy(steps),
    },
    Way {
        key: "carla",
        name: "Depth in three channels, CARLA",
        remark: "Z = (R + 256 · G + 65536 · B) / (2²⁴ − 1) · 1000 m; the sky has all bits set.",
        asks: &[RED, GREEN, BLUE],
        target: DISPARITY,
        compute: Compute::Stored(Stored::Depth(DepthEncoding::ThreeChannels)),
    },
    Way {
        key: "inverse-depth",
        name: "Network: inverse depth",
        remark: "1/Z = 1/far + (1/near − 1/far) · output, times the scale: monodepth2 and its family.",
        asks: &[NETWORK_OUTPUT, NEAR_PLANE, FAR_PLANE, NETWORK_SCALE],
        target: DISPARITY,
        compute: Compute::StoredBy(inverse),
    },
    Way {
        key: "da3-metric",
        name: "Network: Depth Anything 3, metric",
        remark: "Z = fx · output / 300, with the fx of the image that the network was given.",
        asks: &[NETWORK_OUTPUT],
        target: DISPARITY,
        compute: Compute::StoredBy(depth_anything),
    },
    Way {
        key: "metric3d",
        name: "Network: Metric3D",
        remark: "Z = output · fx / 1000, with the fx of the image that the network was given.",
        asks: &[NETWORK_OUTPUT],
        target: DISPARITY,
        compute: Compute::StoredBy(metric3d),
    },
    Way {
        key: "principal-points",
        name: "doffs from both principal points",
        remark: "doffs = cx right − cx left. Stereo then reads D = fx · b / (d + doffs). Zero for most rectified pairs.",
        asks: &[fields::LEFT_CX, fields::RIGHT_CX],
        target: DOFFS,
        compute: Compute::Two(|left, right| {
            Ok(disparity::doffs(Measured::from_base(left, 0.0), Measured::from_base(right, 0.0))
                .value
                .px())
        }),
    },
    Way {
        key: "doffs",
        name: "doffs as a calibration file gives it",
        remark: "Middlebury's calib.txt has it by this name.",
        asks: &[fields::FILE_DOFFS],
        target: DOFFS,
        compute: Compute::One(Ok),
    },
];

fn opencv(of: Values<'_>) -> Result<Stored, NotStored> {
    let min_disparity = needed(of, MIN_DISPARITY)?;
    if min_disparity.fract() != 0.0 || min_disparity.abs() > 30_000.0 {
        return wrong(MIN_DISPARITY, Issue::MinDisparityNotWhole);
    }
    #[expect(clippy::cast_possible_truncation, reason = "checked to be whole and small")]
    let min_disparity = min_disparity as i32;
    Ok(Stored::Disparity(Encoding::OpenCv { min_disparity }))
}

fn depth_ai(of: Values<'_>) -> Result<Stored, NotStored> {
    let bits = match needed(of, SUBPIXEL_BITS)? {
        3.0 => SubpixelBits::Three,
        4.0 => SubpixelBits::Four,
        5.0 => SubpixelBits::Five,
        _ => return wrong(SUBPIXEL_BITS, Issue::WrongSubpixelBits),
    };
    Ok(Stored::Disparity(Encoding::DepthAi(bits)))
}

fn fraction(of: Values<'_>) -> Result<Stored, NotStored> {
    let image_width = Pixels::new(positive(needed(of, FRAME_WIDTH)?, FRAME_WIDTH)?);
    Ok(Stored::Disparity(Encoding::FractionOfWidth { image_width }))
}

fn linear(of: Values<'_>) -> Result<Stored, NotStored> {
    Ok(Stored::Disparity(Encoding::Linear(Linear {
        factor: not_zero(needed(of, STEPS_PER_PIXEL)?, STEPS_PER_PIXEL)?,
        offset: finite(of(STORED_OFFSET).unwrap_or(0.0), STORED_OFFSET)?,
        no_match: of(NO_MATCH),
    })))
}

fn steps(of: Values<'_>) -> Result<Stored, NotStored> {
    let per_meter = positive(needed(of, STEPS_PER_METER)?, STEPS_PER_METER)?;
    Ok(Stored::Depth(DepthEncoding::Steps { per_meter }))
}

fn inverse(of: Values<'_>) -> Result<Stored, NotStored> {
    let or = |key: Key, usual: f64| positive(of(key).unwrap_or(usual), key);
    let (near, far, scale) = (or(NEAR_PLANE, 0.1)?, or(FAR_PLANE, 100.0)?, or(NETWORK_SCALE, 1.0)?);
    if far <= near {
        return wrong(FAR_PLANE, Issue::FarPlaneNotFarther);
    }
    Ok(Stored::Depth(DepthEncoding::Inverse { near, far, scale }))
}

fn depth_anything(of: Values<'_>) -> Result<Stored, NotStored> {
    let focal_length = Pixels::new(needed(of, FOCAL_LENGTH)?);
    Ok(Stored::Depth(DepthEncoding::DepthAnything3 { focal_length }))
}

fn metric3d(of: Values<'_>) -> Result<Stored, NotStored> {
    let focal_length = Pixels::new(needed(of, FOCAL_LENGTH)?);
    Ok(Stored::Depth(DepthEncoding::Metric3D { focal_length }))
}
