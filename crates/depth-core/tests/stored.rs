//! What files store of a pixel, against figures of those who store it.
#![allow(clippy::unwrap_used, reason = "tests")]

use depth_core::disparity::{Encoding, KINECT_V1_BASELINE, KINECT_V1_FOCAL_LENGTH, Linear, NoDisparity};
use depth_core::quantity::Pixels;
use depth_core::stereo;
use depth_core::stored::DepthEncoding;
use proptest::prelude::*;

const EVERY_DEPTH: [DepthEncoding; 5] = [
    DepthEncoding::Steps { per_meter: 1000.0 },
    DepthEncoding::ThreeChannels,
    DepthEncoding::Inverse {
        near: 0.1,
        far: 100.0,
        scale: 5.4,
    },
    DepthEncoding::DepthAnything3 {
        focal_length: Pixels::new(1200.0),
    },
    DepthEncoding::Metric3D {
        focal_length: Pixels::new(700.0),
    },
];

fn px(encoding: Encoding, stored: f64) -> f64 {
    encoding.decode(stored).unwrap().px()
}

fn m(encoding: DepthEncoding, stored: f64) -> f64 {
    encoding.decode(stored).unwrap().m()
}

#[test]
fn disparities_of_data_sets_and_cameras() {
    // Cityscapes: d = (p − 1)/256.
    assert_eq!(px(Encoding::Cityscapes, 12_801.0), 50.0);
    assert_eq!(px(Encoding::RealSense, 1600.0), 50.0);
    assert_eq!(px(Encoding::Ensenso, -800.0), -50.0);
    assert_eq!(px(Encoding::Kitti, 12_345.0), 48.222_656_25);
    for (encoding, mark) in [
        (Encoding::Cityscapes, 0.0),
        (Encoding::RealSense, 0.0),
        (Encoding::Ensenso, -32_768.0),
        (Encoding::KinectV1, 2047.0),
    ] {
        assert_eq!(encoding.decode(mark), Err(NoDisparity::Invalid), "{encoding:?}");
    }
    assert_eq!(Encoding::KinectV1.decode(2048.0), Err(NoDisparity::OutOfRange));
    assert_eq!(Encoding::RealSense.decode(0.5), Err(NoDisparity::NotWhole));
}

#[test]
fn the_first_kinect_sees_its_number_800_at_1_200_m() {
    let disparity = Encoding::KinectV1.decode(800.0).unwrap();
    let depth = stereo::depth(KINECT_V1_FOCAL_LENGTH, KINECT_V1_BASELINE, disparity);
    assert!((depth.m() - 1.2).abs() < 1e-12, "{depth:?}");
    // The same by its factor and offset.
    let linear = Encoding::Linear(Linear {
        factor: -8.0,
        offset: 1090.0,
        no_match: Some(2047.0),
    });
    assert_eq!(linear.decode(800.0), Ok(disparity));
    assert_eq!(linear.decode(2047.0), Err(NoDisparity::Invalid));
}

#[test]
fn depths_of_data_sets_simulators_and_networks() {
    assert_eq!(m(DepthEncoding::Steps { per_meter: 5000.0 }, 7000.0), 1.4);
    // CARLA's reference: (100, 20, 1) is 4.217 m.
    let stored = 100.0 + 256.0 * 20.0 + 65_536.0;
    assert!((m(DepthEncoding::ThreeChannels, stored) - 4.217).abs() < 5e-4);
    let [_, _, inverse, depth_anything, metric3d] = EVERY_DEPTH;
    // Of monodepth2: 0 is the far plane, 1 the near one.
    assert!((m(inverse, 0.0) - 540.0).abs() < 1e-9 && (m(inverse, 1.0) - 0.54).abs() < 1e-12);
    assert_eq!((m(depth_anything, 1.5), m(metric3d, 2.0)), (6.0, 1.4));
    for mark in [0.0, 65_535.0] {
        assert_eq!(DepthEncoding::Steps { per_meter: 256.0 }.decode(mark), Err(NoDisparity::Invalid));
    }
    assert_eq!(
        DepthEncoding::ThreeChannels.decode(16_777_215.0),
        Err(NoDisparity::Invalid),
        "the sky"
    );
    assert_eq!(metric3d.decode(-1.0), Err(NoDisparity::OutOfRange));
    for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refusals = EVERY_DEPTH.map(|encoding| encoding.decode(number).unwrap_err());
        let (whole, of_networks) = refusals.split_at(2);
        assert_eq!(whole, [NoDisparity::OutOfRange; 2], "{number}");
        assert_eq!(of_networks, [NoDisparity::Invalid; 3], "{number}");
    }
}

proptest! {
    #[test]
    fn nothing_that_is_stored_is_a_distance_below_zero_or_none_at_all(stored in prop_oneof![any::<f64>(), -70_000.0..70_000.0, (0_u32..70_000).prop_map(f64::from)]) {
        for encoding in EVERY_DEPTH {
            if let Ok(distance) = encoding.decode(stored) {
                prop_assert!(distance.m().is_finite() && distance.m() >= 0.0, "{:?}", encoding);
            }
        }
    }

    #[test]
    fn a_linear_encoding_goes_both_ways(disparity in -1000.0_f64..1000.0, factor in prop_oneof![0.1_f64..500.0, -500.0_f64..-0.1], offset in -5000.0_f64..5000.0) {
        let linear = Encoding::Linear(Linear { factor, offset, no_match: None });
        let decoded = linear.decode(factor * disparity + offset).unwrap().px();
        prop_assert!((decoded - disparity).abs() < 1e-9 * (1.0 + (offset / factor).abs() + disparity.abs()));
    }
}
