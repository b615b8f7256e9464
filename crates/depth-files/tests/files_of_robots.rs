//! FTC’s webcams, VINS and camodocal, and OAK cameras. Files of our own.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{bytes, found, pinhole, refused, said, value};
use depth_files::{Basis, Format, Warning, read};

#[test]
fn every_calibration_of_a_robot_is_a_camera_but_those_in_remarks_and_those_to_remove() {
    // By hand: three elements that are no remark, of which none has the attribute remove; the order is that of the file.
    let all = found(&["ftc/three_calibrations.xml"]);
    assert_eq!(all.format, Format::Ftc);
    let cameras: Vec<_> = all.cameras.iter().map(|camera| (pinhole(camera), camera.size.unwrap())).collect();
    assert_eq!(
        cameras,
        [
            ([801.5, 802.25, 321.75, 238.5], [640, 480]),
            ([1402.5, 1403.0, 955.25, 541.5], [1920, 1080]),
            ([1101.5, 1102.5, 639.5, 361.25], [1280, 720]),
        ]
    );
    let first = &all.cameras[0];
    assert_eq!((first.name.as_str(), first.origin.line), ("Logitech 0x0999 640 × 480", 6));
    assert_eq!(first.distortion, [-0.031, 0.95, 0.0, 0.0, -2.75, 0.0, 0.0, 0.0]);
    assert_eq!(all.ignored.len(), 1);
    assert!(all.warnings.contains(&Warning::Many { cameras: 3, pair: None }));
}

#[test]
fn a_robot_without_a_calibration_outside_of_remarks_is_told_so() {
    assert!(refused(&["ftc/all_in_remarks.xml"]).contains("<!--"));
    let sentence = refused(&["ftc/word_for_a_number.xml"]);
    assert!(
        sentence.contains("line 3") && sentence.contains("focalLength is not a number"),
        "{sentence}"
    );
}

#[test]
fn the_cameras_of_vins_are_a_pair_with_the_settings_in_whatever_order_the_files_come() {
    // NumPy: inv(body_T_cam1) @ body_T_cam0 has the translation (−0.09988, 0.0013, −0.00192), whose norm is this.
    for files in [
        ["vins/stereo_config.yaml", "vins/left.yaml", "vins/right.yaml"],
        ["vins/right.yaml", "vins/left.yaml", "vins/stereo_config.yaml"],
    ] {
        let pair = found(&files);
        assert_eq!((pair.format, pair.pair, pair.is_vertical), (Format::Vins, Some([0, 1]), false));
        assert_eq!(pinhole(&pair.cameras[0]), [461.25, 460.5, 366.75, 249.25]);
        assert_eq!(pinhole(&pair.cameras[1]), [459.75, 459.0, 378.5, 254.75]);
        assert!((value(&pair) - 0.099_910_910_315_140_25).abs() < 1e-15);
        assert_eq!(pair.cameras[0].distortion, [-0.275, 0.065, 3e-4, -1e-4]);
        assert_eq!((pair.cameras[0].size, pair.cameras[0].basis), (Some([752, 480]), Basis::Raw));
        assert!(!said(&pair).contains("swapped"));
    }
}

#[test]
fn files_of_vins_that_are_not_all_there_ask_for_the_others() {
    assert!(refused(&["vins/stereo_config.yaml"]).contains("cam0_calib"));
    let two = found(&["vins/left.yaml", "vins/right.yaml"]);
    assert!(two.warnings.contains(&Warning::NoExtrinsics) && two.baseline.is_none());
    let one = found(&["vins/left.yaml"]);
    assert!(one.warnings.contains(&Warning::NoBaseline { format: Format::Vins }));
}

#[test]
fn swapped_cameras_of_vins_are_said() {
    let text = String::from_utf8(bytes("vins/stereo_config.yaml")).unwrap();
    let text = text
        .replace("body_T_cam0", "body_T_camX")
        .replace("body_T_cam1", "body_T_cam0")
        .replace("body_T_camX", "body_T_cam1");
    let (left, right) = (bytes("vins/left.yaml"), bytes("vins/right.yaml"));
    let pair = read(&[text.as_bytes(), &left, &right]).unwrap();
    assert!(said(&pair).contains("swapped") && pair.pair == Some([1, 0]));
}

#[test]
fn models_with_a_mirror_or_a_fisheye_in_front_are_no_pinhole() {
    for (file, model) in [("vins/mei.yaml", "MEI"), ("vins/kannala_brandt.yaml", "KANNALA_BRANDT")] {
        let sentence = refused(&[file]);
        assert!(
            sentence.contains(model) && sentence.contains("line 3") && sentence.contains("no pinhole"),
            "{sentence}"
        );
    }
}

#[test]
fn an_oak_camera_has_its_pair_by_name_and_its_baseline_in_centimeters() {
    // NumPy: norm(−7.53, 0.04, −0.06) / 100.
    let all = found(&["depthai/three_cameras_cm.json"]);
    assert_eq!((all.format, all.cameras.len(), all.pair), (Format::DepthAi, 3, Some([1, 2])));
    assert_eq!(all.cameras[1].name, "CAM_B");
    assert_eq!(pinhole(&all.cameras[1]), [801.25, 801.75, 641.5, 402.25]);
    assert_eq!((all.cameras[0].size, all.cameras[2].size), (Some([1920, 1080]), Some([1280, 800])));
    assert!((value(&all) - 0.075_303_452_776_084_58).abs() < 1e-15);
    assert_eq!(all.baseline_origin.as_ref().unwrap().how, "|translation| of CAM_B to CAM_C");
    assert!(all.ignored[0].contains("specTranslation"));
    let names = ["CAM_B", "CAM_C"].map(str::to_owned);
    let pair = Some(names);
    assert!(all.warnings.contains(&Warning::Many { cameras: 3, pair }));
}

#[test]
fn an_oak_camera_whose_sides_both_lead_to_the_color_camera_has_its_baseline_by_that_chain() {
    // NumPy: norm of the translation of inv(T_right) @ T_left, which is (−75.395, 1.095, −0.4) mm. The first camera of the file is the left.
    let all = found(&["depthai/chain_by_color_mm.json"]);
    assert_eq!(all.pair, Some([0, 1]));
    assert!((value(&all) - 0.075_404_310_221_631_23).abs() < 1e-15);
    assert_eq!(
        all.baseline_origin.as_ref().unwrap().how,
        "|translation| of CAM_B to CAM_A, CAM_C to CAM_A"
    );
}

#[test]
fn an_oak_camera_that_was_not_calibrated_says_so() {
    let by_design = found(&["depthai/fisheye_by_design.json"]);
    assert!(by_design.warnings.contains(&Warning::ByDesign) && said(&by_design).contains("fisheye"));
    assert_eq!(value(&by_design), 0.075);
    let one = found(&["depthai/not_calibrated.json"]);
    assert_eq!((one.cameras.len(), one.baseline), (1, None));
    assert!(one.ignored[0].contains("CAM_B"));
}

#[test]
fn a_unit_of_an_oak_camera_that_is_none_is_refused() {
    let text = String::from_utf8(bytes("depthai/chain_by_color_mm.json")).unwrap();
    let refusal = read(&[text.replace("\"lengthUnit\": 2", "\"lengthUnit\": 9").as_bytes()]).unwrap_err();
    assert!(refusal.to_string().contains("lengthUnit"), "{refusal}");
    // 7 540 m, where it were meters.
    let meters = read(&[text.replace("\"lengthUnit\": 2", "\"lengthUnit\": \"METER\"").as_bytes()]).unwrap();
    assert!(said(&meters).contains("implausible"));
}
