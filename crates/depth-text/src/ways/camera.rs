//! The ways to a focal length and to a baseline.

use super::way::{Compute, Way};
use crate::fields::{self, BASELINE, FOCAL_LENGTH, FRAME_HEIGHT, FRAME_WIDTH, LENS};
use crate::note::Issue;
use depth_core::angle::Angle;
use depth_core::camera;
use depth_core::quantity::{Length, Pixels};
use depth_core::stereo;

/// The ways to a focal length.
pub const FOCAL_LENGTHS: &[Way] = &[
    Way {
        key: "pixel-pitch",
        name: "Lens and pixel size",
        remark: "fx = focal length / pixel pitch. Use the pitch of the image as you have it: twice as large after 2 × 2 binning. Where the lens is focused on the object, its focal length is added to the distance.",
        asks: &[LENS, fields::PIXEL_PITCH],
        target: FOCAL_LENGTH,
        compute: Compute::Two(|lens, pitch| found(camera::focal_length_from_pixel_pitch(Length::from_m(lens), Length::from_m(pitch)))),
    },
    Way {
        key: "sensor-width",
        name: "Lens and sensor width",
        remark: "fx = focal length · image width / sensor width. An inch figure is a name, not a size: choose the format below.",
        asks: &[LENS, fields::SENSOR_WIDTH, FRAME_WIDTH],
        target: FOCAL_LENGTH,
        compute: Compute::Three(|lens, sensor, width| {
            let (lens, sensor) = (Length::from_m(lens), Length::from_m(sensor));
            found(camera::focal_length_from_sensor_width(lens, sensor, Pixels::new(width)))
        }),
    },
    Way {
        key: "horizontal-view",
        name: "Horizontal field of view",
        remark: "fx = (width / 2) / tan(view / 2). A datasheet often gives the view before rectification, which is wider.",
        asks: &[fields::HORIZONTAL_VIEW, FRAME_WIDTH],
        target: FOCAL_LENGTH,
        compute: Compute::Two(|view, width| from_view(view, Pixels::new(width))),
    },
    Way {
        key: "vertical-view",
        name: "Vertical field of view",
        remark: "fy = (height / 2) / tan(view / 2); with square pixels fx is the same.",
        asks: &[fields::VERTICAL_VIEW, FRAME_HEIGHT],
        target: FOCAL_LENGTH,
        compute: Compute::Two(|view, height| from_view(view, Pixels::new(height))),
    },
    Way {
        key: "diagonal-view",
        name: "Diagonal field of view",
        remark: "fx = ½ · √(width² + height²) / tan(view / 2).",
        asks: &[fields::DIAGONAL_VIEW, FRAME_WIDTH, FRAME_HEIGHT],
        target: FOCAL_LENGTH,
        compute: Compute::Three(|view, width, height| from_view(view, camera::diagonal(Pixels::new(width), Pixels::new(height)))),
    },
    Way {
        key: "multiple-of-width",
        name: "Multiple of the image width",
        remark: "fx = multiple · width. Some file formats and programs have the focal length in widths of the image.",
        asks: &[fields::MULTIPLE, FRAME_WIDTH],
        target: FOCAL_LENGTH,
        compute: Compute::Two(|multiple, width| found(camera::focal_length_from_multiple(multiple, Pixels::new(width)))),
    },
    Way {
        key: "multiple-of-half-width",
        name: "Multiple of half the image width",
        remark: "fx = multiple · width / 2: OpenGL’s and Unity’s projection matrix has it in row 1, column 1 (P00).",
        asks: &[fields::MULTIPLE, FRAME_WIDTH],
        target: FOCAL_LENGTH,
        compute: Compute::Two(|multiple, width| found(camera::focal_length_from_multiple(multiple, Pixels::new(width / 2.0)))),
    },
    Way {
        key: "reference-photo",
        name: "One reference photo",
        remark: "fx = width in the image · distance / real width, for something of known width at a measured distance, facing the camera.",
        asks: &[
            fields::REFERENCE_IMAGE_WIDTH,
            fields::REFERENCE_DISTANCE,
            fields::REFERENCE_REAL_WIDTH,
        ],
        target: FOCAL_LENGTH,
        compute: Compute::Three(|width, distance, real| {
            let (distance, real) = (Length::from_m(distance), Length::from_m(real));
            found(camera::focal_length_from_reference_photo(Pixels::new(width), distance, real))
        }),
    },
    Way {
        key: "other-resolution",
        name: "Same camera, other resolution",
        remark: "Resizing scales fx and the disparity, never the baseline. Cropping changes neither: enter the width before the crop.",
        asks: &[fields::KNOWN_FOCAL_LENGTH, fields::WIDTH_BEFORE, fields::WIDTH_AFTER],
        target: FOCAL_LENGTH,
        compute: Compute::Three(|focal_length, before, after| {
            let px = Pixels::new;
            found(camera::resized_focal_length(px(focal_length), px(before), px(after)))
        }),
    },
];

/// The ways to a baseline.
pub const BASELINES: &[Way] = &[Way {
    key: "angle",
    name: "Not square to the line of sight",
    remark: "b = distance · sin(angle), the angle between the line from one camera to the other and the line of sight. 90° changes nothing.",
    asks: &[fields::STATIONS, fields::BASELINE_ANGLE],
    target: BASELINE,
    compute: Compute::Two(|stations, angle| {
        let effective = stereo::effective_baseline(Length::from_m(stations), Angle::from_radians(angle));
        effective.map(Length::m).filter(|b| *b > 0.0).ok_or(Issue::NoBaseline)
    }),
}];

fn from_view(view: f64, extent: Pixels) -> Result<f64, Issue> {
    found(camera::focal_length_from_field_of_view(Angle::from_radians(view), extent))
}

fn found(focal_length: Option<Pixels>) -> Result<f64, Issue> {
    focal_length.map(Pixels::px).ok_or(Issue::NoFocalLength)
}
