//! Numbers under their names: Open3D, RealSense, ARKit, nerfstudio, FoundationStereo and Bouguet’s toolbox. Files of our own; what is
//! expected are the numbers of the file, or was computed by hand or by NumPy where it is said.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{bytes, found, pinhole, refused, said, value};
use depth_core::quantity::LengthUnit;
use depth_files::{Baseline, Basis, Format, Guess, Warning, read};

#[test]
fn a_matrix_column_by_column_has_its_principal_point_at_its_end() {
    for (file, expected, size) in [
        ("intrinsics/open3d.json", [611.5, 612.25, 318.75, 241.5], [640, 480]),
        ("intrinsics/arkit.json", [1445.5, 1445.5, 960.25, 721.75], [1920, 1440]),
        ("intrinsics/record3d.json", [1340.5, 1340.5, 719.25, 956.5], [1440, 1920]),
    ] {
        let one = found(&[file]);
        assert_eq!((one.format, one.cameras.len()), (Format::Intrinsics, 1), "{file}");
        assert_eq!((pinhole(&one.cameras[0]), one.cameras[0].size), (expected, Some(size)), "{file}");
        assert!(one.cameras[0].origin.how.contains("column by column"), "{file}");
        assert!(said(&one).contains("no baseline"), "{file}");
    }
    // Under the names of OpenCV too, as MATLAB’s IntrinsicMatrix; row by row it stays as it is.
    let pair = br#"{"K1": [[700,0,0],[0,701,0],[320,240,1]], "K2": [[700,0,330],[0,701,250],[0,0,1]], "T": [-60,0,0]}"#;
    let pair = read(&[pair]).unwrap();
    assert_eq!(pinhole(&pair.cameras[0]), [700.0, 701.0, 320.0, 240.0]);
    assert_eq!(pinhole(&pair.cameras[1]), [700.0, 701.0, 330.0, 250.0]);
}

#[test]
fn realsense_and_plain_names_are_read() {
    let one = found(&["intrinsics/realsense.json"]);
    assert_eq!(pinhole(&one.cameras[0]), [425.5, 425.75, 421.25, 238.75]);
    assert_eq!(one.cameras[0].model.as_deref(), Some("distortion.brown_conrady"));
    let streams = found(&["intrinsics/realsense_streams.json"]);
    assert_eq!((streams.cameras.len(), streams.pair), (3, Some([1, 2])));
    assert_eq!((value(&streams), streams.doffs.unwrap().px()), (0.04995, 0.0));
    let one = found(&["intrinsics/one_f.json"]);
    assert_eq!(pinhole(&one.cameras[0]), [712.25, 712.25, 330.5, 250.75]);
    assert_eq!((value(&one), one.doffs.unwrap().px(), one.is_rectified()), (0.065, 12.5, true));
}

#[test]
fn a_baseline_without_a_unit_is_asked_for_beside_fx_and_beside_a_matrix() {
    let meters = Guess::Unit(LengthUnit::Meter);
    let expected = Some(Baseline::InFileUnits {
        value: 0.12,
        guess: meters,
    });
    let one = found(&["intrinsics/bare_baseline.json"]);
    assert_eq!((one.baseline, one.cameras[0].basis), (expected, Basis::Rectified));
    assert_eq!(one.baseline_origin.as_ref().unwrap().how, "baseline");
    assert!(said(&one).contains("does not say in which unit"));
    let matrix = read(&[br#"{"K": [[700,0,320],[0,700,240],[0,0,1]], "baseline": 0.12}"#]).unwrap();
    assert_eq!((matrix.format, matrix.baseline), (Format::OpenCv, expected));
    let zero = read(&[br#"{"fx": 700, "cx": 320, "cy": 240, "baseline": 0}"#]).unwrap();
    assert!(zero.warnings.contains(&Warning::ZeroBaseline) && zero.baseline.is_none());
}

#[test]
fn without_a_principal_point_the_center_is_taken_and_said() {
    // The norm of (−63.5, 0.5, −1) by NumPy.
    let pair = found(&["intrinsics/left_right_no_center.json"]);
    assert_eq!(pinhole(&pair.cameras[0]), [700.5, 701.25, 640.0, 360.0]);
    assert_eq!(pinhole(&pair.cameras[1]), [698.5, 699.25, 640.0, 360.0]);
    assert!((value(&pair) - 63.509_841_757_006_45).abs() < 1e-12);
    assert!(said(&pair).contains("left: the file has no principal point"));
    // Of six pictures by one camera, one.
    let pictures = found(&["intrinsics/many_pictures.json"]);
    assert_eq!(pictures.cameras.len(), 1);
    let sentence = read(&[br#"{"fx": 700, "fy": 700}"#]).unwrap_err().to_string();
    assert!(sentence.contains("cx and cy"), "{sentence}");
}

#[test]
fn a_focal_length_in_millimeters_and_a_word_for_one_are_said() {
    let one = found(&["intrinsics/focal_in_mm.json"]);
    assert_eq!(pinhole(&one.cameras[0]), [4.2, 4.2, 320.5, 240.25]);
    assert!(said(&one).contains("is it in mm?"));
    let sentence = refused(&["intrinsics/word_for_a_number.json"]);
    assert!(sentence.contains("“px” of fx is not a number"), "{sentence}");
    let sentence = read(&[br#"{"fx": 700, "fy": "seven", "cx": 1, "cy": 1}"#]).unwrap_err().to_string();
    assert!(sentence.contains("“seven” of fy"), "{sentence}");
}

#[test]
fn transforms_have_a_focal_length_or_an_angle() {
    let one = found(&["transforms/nerfstudio.json"]);
    assert_eq!((one.format, one.cameras.len()), (Format::Transforms, 1));
    assert_eq!(pinhole(&one.cameras[0]), [1402.5, 1401.25, 958.75, 541.5]);
    assert_eq!(one.cameras[0].distortion, [0.021, -0.05, 0.001, -0.0005]);
    assert!(one.ignored[0].contains("2 poses") && said(&one).contains("no baseline"));
    // NumPy: 800 / 2 / tan(0.6911112070083618 / 2).
    let angle = found(&["transforms/angle.json"]);
    assert!((angle.cameras[0].fx.px() - 1_111.111_031_193_768_2).abs() < 1e-9);
    assert_eq!(angle.cameras[0].cx.px(), 400.0);
    assert!(refused(&["transforms/angle_without_size.json"]).contains("w and h"));
}

#[test]
fn frames_with_cameras_of_their_own_are_cameras_once_each() {
    let two = found(&["transforms/each_frame.json"]);
    let names: Vec<&str> = two.cameras.iter().map(|camera| camera.name.as_str()).collect();
    assert_eq!(names, ["frame 1", "frame 3"]);
    assert!(said(&two).contains("OPENCV_FISHEYE is a model of a fisheye lens"));
    assert!(refused(&["transforms/equirectangular.json"]).contains("no pinhole"));
}

#[test]
fn nine_numbers_and_a_baseline_below_them_are_a_rectified_camera_in_meters() {
    let one = found(&["foundation_stereo/K.txt"]);
    assert_eq!((one.format, one.is_rectified()), (Format::FoundationStereo, true));
    assert_eq!(pinhole(&one.cameras[0]), [754.625, 754.625, 489.375, 265.125]);
    assert_eq!((value(&one), one.baseline_origin.as_ref().unwrap().line), (0.063, 2));
    let alone = found(&["foundation_stereo/cam_K.txt"]);
    assert_eq!(pinhole(&alone.cameras[0]), [319.575, 417.475, 320.25, 244.375]);
    assert!(alone.baseline.is_none() && !alone.is_rectified());
    assert!(said(&found(&["foundation_stereo/baseline_in_mm.txt"])).contains("63 m is implausible"));
    // As NumPy prints it.
    let printed = read(&[b"[[700.5   0.  320. ]\n [  0.  701.  240. ]\n [  0.    0.    1. ]]\n"]).unwrap();
    assert_eq!(pinhole(&printed.cameras[0]), [700.5, 701.0, 320.0, 240.0]);
    let sentence = refused(&["foundation_stereo/two_matrices.txt"]);
    assert!(sentence.contains("line 2") && sentence.contains("9 numbers"), "{sentence}");
}

#[test]
fn results_of_bouguets_toolbox_have_their_sigma() {
    // By hand: a third of fc_error and of cc_error.
    let one = found(&["bouguet/Calib_Results.m"]);
    assert_eq!((one.format, one.cameras.len()), (Format::Bouguet, 1));
    let camera = &one.cameras[0];
    assert_eq!(
        (pinhole(camera), camera.size),
        ([657.3, 657.75, 302.985, 242.6175], Some([640, 480]))
    );
    let sigma = camera.sigma.unwrap().map(|one| one.px());
    for (got, want) in sigma.into_iter().zip([0.1155, 0.1237, 0.2352, 0.2153]) {
        assert!((got - want).abs() < 1e-12, "{sigma:?}");
    }
    assert_eq!(camera.distortion, [-0.25583, 0.12758, -0.00021, 0.000031, 0.0]);
    assert_eq!((camera.origin.line, camera.origin.how.as_str()), (7, "fc, cc"));
}

#[test]
fn a_pair_of_bouguets_toolbox_is_that_after_the_optimization_and_its_unit_is_asked_for() {
    for (file, has_right_sigma) in [("bouguet/stereo_as_printed.txt", true), ("bouguet/stereo_as_variables.m", false)] {
        let pair = found(&[file]);
        assert_eq!(pinhole(&pair.cameras[0]), [533.52325, 533.527, 341.60375, 235.19275], "{file}");
        assert_eq!(pinhole(&pair.cameras[1]), [536.81375, 536.4765, 326.2865, 250.10125], "{file}");
        // NumPy: norm(−99.849, 0.822, 0.436).
        assert!((value(&pair) - 99.853_335_352_405_74).abs() < 1e-12, "{file}");
        assert!(said(&pair).contains("probably mm") && !said(&pair).contains("swapped"), "{file}");
        let sigma = pair.cameras[0].sigma.unwrap().map(|one| one.px());
        for (got, want) in sigma.into_iter().zip([0.277, 0.28, 0.413, 0.401]) {
            assert!((got - want).abs() < 1e-12, "{file}: {sigma:?}");
        }
        assert_eq!(pair.cameras[1].sigma.is_some(), has_right_sigma, "{file}");
    }
    assert_eq!(found(&["bouguet/stereo_as_variables.m"]).cameras[1].size, Some([640, 480]));
    let sentence = refused(&["bouguet/truncated_in_fc.m"]);
    assert!(
        sentence.contains("line 3") && sentence.contains("of fc is not a number"),
        "{sentence}"
    );
}

#[test]
fn files_of_names_end_in_windows_line_ends_and_begin_with_a_mark_too() {
    for file in [
        "intrinsics/open3d.json",
        "bouguet/Calib_Results.m",
        "foundation_stereo/K.txt",
        "vins/left.yaml",
        "ftc/three_calibrations.xml",
    ] {
        let text = String::from_utf8(bytes(file)).unwrap();
        let other = format!("\u{feff}{}", text.replace('\n', "\r\n"));
        let (one, other) = (found(&[file]), read(&[other.as_bytes()]).unwrap());
        assert_eq!(one, other, "{file}");
    }
}
