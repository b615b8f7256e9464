//! Stored disparities and Q matrices, against what OpenCV and the data sets hold.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

use depth_core::disparity::{Encoding, NoDisparity, SubpixelBits, doffs, from_columns};
use depth_core::measured::Measured;
use depth_core::q_matrix::{self, Expected, WrongEntry};
use depth_core::quantity::{Length, Pixels};
use depth_core::uncertainty::Model;
use proptest::prelude::*;

fn opencv(min_disparity: i32) -> Encoding {
    Encoding::OpenCv { min_disparity }
}

#[test]
fn fifty_pixels_in_every_encoding() {
    let fifty = Ok(Pixels::new(50.0));
    assert_eq!(Encoding::Pixels.decode(50.0), fifty);
    assert_eq!(opencv(0).decode(800.0), fifty);
    assert_eq!(Encoding::Kitti.decode(12_800.0), fifty);
    assert_eq!(Encoding::DepthAi(SubpixelBits::Three).decode(400.0), fifty);
    assert_eq!(Encoding::DepthAi(SubpixelBits::Four).decode(800.0), fifty);
    assert_eq!(Encoding::DepthAi(SubpixelBits::Five).decode(1600.0), fifty);
    let image_width = Pixels::new(1280.0);
    assert_eq!(Encoding::FractionOfWidth { image_width }.decode(0.039_062_5), fifty);
    assert_eq!(Encoding::Zed.decode(-50.0), fifty);
}

#[test]
fn opencv_marks_a_missing_disparity_below_the_search_range() {
    // Measured with OpenCV 4.14 and 5.0.
    for (min_disparity, invalid) in [(0, -16.0), (16, 240.0), (-16, -272.0)] {
        assert_eq!(opencv(min_disparity).decode(invalid), Err(NoDisparity::Invalid));
    }
    assert_eq!(opencv(0).decode(240.0), Ok(Pixels::new(15.0)));
    assert_eq!(opencv(-16).decode(-16.0), Ok(Pixels::new(-1.0)));
}

#[test]
fn each_encoding_refuses_its_own_mark_and_what_it_cannot_hold() {
    for encoding in [Encoding::Kitti, Encoding::DepthAi(SubpixelBits::Five)] {
        assert_eq!(encoding.decode(0.0), Err(NoDisparity::Invalid));
        assert_eq!(encoding.decode(-1.0), Err(NoDisparity::OutOfRange));
        assert_eq!(encoding.decode(65_536.0), Err(NoDisparity::OutOfRange));
        assert_eq!(encoding.decode(50.5), Err(NoDisparity::NotWhole));
    }
    assert_eq!(opencv(0).decode(32_768.0), Err(NoDisparity::OutOfRange));
    assert_eq!(opencv(0).decode(50.25), Err(NoDisparity::NotWhole));
    let image_width = Pixels::new(1e300);
    for number in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        for encoding in [Encoding::Pixels, Encoding::Zed, Encoding::FractionOfWidth { image_width }] {
            assert_eq!(encoding.decode(number), Err(NoDisparity::Invalid), "{encoding:?}");
        }
        // Whole numbers have no such marks.
        let depth_ai = Encoding::DepthAi(SubpixelBits::Three);
        let of_16_bits = [
            Encoding::Kitti,
            Encoding::Cityscapes,
            Encoding::RealSense,
            Encoding::Ensenso,
            depth_ai,
        ];
        for encoding in of_16_bits.into_iter().chain([Encoding::KinectV1, opencv(0)]) {
            assert_eq!(encoding.decode(number), Err(NoDisparity::OutOfRange), "{encoding:?}");
        }
    }
    assert_eq!(
        Encoding::FractionOfWidth { image_width }.decode(1e300),
        Err(NoDisparity::OutOfRange)
    );
}

#[test]
fn columns_and_principal_points_give_the_ros_disparity() {
    let (left, right) = (Measured::from_base(660.0, 0.3), Measured::from_base(610.0, 0.4));
    let (cx_left, cx_right) = (Measured::from_base(610.0, 0.0), Measured::from_base(650.0, 0.0));
    let d = from_columns(left, right);
    let o = doffs(cx_left, cx_right);
    assert_eq!(d.value.px(), 50.0);
    assert!((d.sigma.px() - 0.5).abs() < 1e-15);
    assert_eq!(o, Measured::from_base(40.0, 0.0));
    // ROS: x_l − x_r − (cx_l − cx_r).
    let model = Model::stereo(Measured::from_base(700.0, 0.0), Measured::from_base(0.1, 0.0), d, o).unwrap();
    assert_eq!(model.divisor().value, 660.0 - 610.0 - (610.0 - 650.0));
}

/// What OpenCV's stereoRectify returns for f 700 px, T = (−100, 0, 0), cx 610 and 650, cy 350.
const Q: [[f64; 4]; 4] = [
    [1.0, 0.0, 0.0, -610.0],
    [0.0, 1.0, 0.0, -350.0],
    [0.0, 0.0, 0.0, 700.0],
    [0.0, 0.0, 0.01, 0.4],
];

#[test]
fn opencvs_matrix_is_read() {
    let geometry = q_matrix::read(&Q).unwrap();
    assert_eq!(geometry.focal_length, Pixels::new(700.0));
    assert!((geometry.baseline - 100.0).abs() < 1e-12);
    assert!((geometry.doffs.px() - 40.0).abs() < 1e-12);
    assert_eq!((geometry.cx, geometry.cy), (Pixels::new(610.0), Pixels::new(350.0)));
    assert!(!geometry.swapped);
    let model = Model::stereo(
        Measured::from_base(geometry.focal_length.px(), 0.0),
        Measured::from_base(geometry.baseline, 0.0),
        Measured::from_base(50.0, 0.0),
        Measured::from_base(geometry.doffs.px(), 0.0),
    );
    assert!((model.unwrap().depth().m() - 777.777_78).abs() < 5e-6);
}

#[test]
fn swapped_cameras_are_noticed() {
    let mut q = Q;
    q[3][2] = -0.01;
    q[3][3] = -0.4;
    let geometry = q_matrix::read(&q).unwrap();
    assert!(geometry.swapped);
    assert!((geometry.baseline - 100.0).abs() < 1e-12);
    assert!((geometry.doffs.px() - 40.0).abs() < 1e-12);
}

#[test]
fn the_entry_that_is_wrong_is_named() {
    let wrong = |row: usize, column: usize, found: f64| {
        let mut q = Q;
        q[row][column] = found;
        q_matrix::read(&q).err()
    };
    let entry = |row, column, found, expected| {
        Some(WrongEntry {
            row,
            column,
            found,
            expected,
        })
    };
    assert_eq!(wrong(1, 1, -1.0), entry(1, 1, -1.0, Expected::Exactly(1.0)));
    assert_eq!(wrong(0, 2, 5.0), entry(0, 2, 5.0, Expected::Exactly(0.0)));
    assert_eq!(wrong(2, 3, -700.0), entry(2, 3, -700.0, Expected::Positive));
    assert_eq!(wrong(3, 2, 0.0), entry(3, 2, 0.0, Expected::NotZero));
    assert_eq!(wrong(0, 3, f64::INFINITY), entry(0, 3, f64::INFINITY, Expected::Finite));
    assert!(wrong(2, 3, f64::NAN).is_some());
    assert_eq!(wrong(0, 1, 1e-9), None, "few digits are no fault");
    // A camera matrix is none.
    let k = [[700.0, 0.0, 610.0, 0.0], [0.0, 705.0, 350.0, 0.0], [0.0, 0.0, 1.0, 0.0], [0.0; 4]];
    assert_eq!(q_matrix::read(&k).err(), entry(0, 0, 700.0, Expected::Exactly(1.0)));
}

proptest! {
    #[test]
    fn a_read_matrix_reprojects_as_opencv_does(
        f in 100.0..5000.0_f64, b in 0.01..500.0_f64, o in -50.0..50.0_f64, d in 60.0..500.0_f64,
    ) {
        let mut q = Q;
        q[2][3] = f;
        q[3][2] = 1.0 / b;
        q[3][3] = o / b;
        let geometry = q_matrix::read(&q).unwrap();
        // reprojectImageTo3D: [X Y Z W] = Q·[x y d 1], Z/W.
        let z = q[2][3] / (q[3][2] * d + q[3][3]);
        let model = Model::stereo(
            Measured::from_base(geometry.focal_length.px(), 0.0), Measured::from_base(geometry.baseline, 0.0),
            Measured::from_base(d, 0.0), Measured::from_base(geometry.doffs.px(), 0.0),
        ).unwrap();
        prop_assert!((model.depth().m() / z - 1.0).abs() < 1e-12);
    }

    #[test]
    fn what_is_read_is_finite_at_every_magnitude(f in -310.0..308.0_f64, w in -310.0..308.0_f64, o in -310.0..308.0_f64) {
        let mut q = Q;
        (q[2][3], q[3][2], q[3][3]) = (10.0_f64.powf(f), 10.0_f64.powf(w), 10.0_f64.powf(o));
        if let Ok(geometry) = q_matrix::read(&q) {
            prop_assert!(geometry.baseline.is_normal() && geometry.doffs.px().is_finite());
            prop_assert!(Length::from_m(geometry.focal_length.px()).m().is_normal());
        }
    }

    #[test]
    fn fixed_point_numbers_come_back(stored in 1..=65_535_i32) {
        let stored = f64::from(stored);
        prop_assert_eq!(Encoding::Kitti.decode(stored).unwrap().px() * 256.0, stored);
        prop_assert_eq!(Encoding::DepthAi(SubpixelBits::Four).decode(stored).unwrap().px() * 16.0, stored);
    }
}
