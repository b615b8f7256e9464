//! Of several cameras another one or another pair can be chosen, and what is between them follows.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

use depth_files::{Found, Refusal, Warning, read};

fn found(text: &str) -> Found {
    read(&[text.as_bytes()]).unwrap()
}

fn meters(found: &Found) -> f64 {
    let length = found.baseline.and_then(|baseline| baseline.length(None)).unwrap();
    (length.m() * 1e6).round() / 1e6
}

fn names(found: &Found) -> Vec<&str> {
    found.cameras.iter().map(|camera| camera.name.as_str()).collect()
}

const KITTI: &str = "P0: 700 0 600 0 0 700 180 0 0 0 1 0\nP1: 700 0 600 -378 0 700 180 0 0 0 1 0\n\
                     P2: 720 0 610 43.2 0 720 172 0 0 0 1 0\nP3: 720 0 615 -338.4 0 720 172 0 0 0 1 0\n";

#[test]
fn of_kitti_the_color_pair_has_its_own_baseline_and_doffs() {
    let all = found(KITTI);
    assert_eq!((all.pair, meters(&all), all.doffs.unwrap().px()), (Some([0, 1]), 0.54, 0.0));
    let color = all.choose_named(&["2", "3"]).unwrap();
    assert_eq!(
        (names(&color), meters(&color), color.doffs.unwrap().px()),
        (vec!["camera 2", "camera 3"], 0.53, 5.0)
    );
    assert_eq!(color.baseline_origin.as_ref().unwrap().how, "(P2[0][3] - P3[0][3]) / P3[0][0]");
    assert!(!color.warnings.iter().any(|one| matches!(one, Warning::Many { .. })));
    // In whatever order they are named, the left one comes first.
    assert_eq!(all.choose_named(&["camera 3", "camera 2"]).unwrap(), color);
}

#[test]
fn what_is_wrong_of_the_raw_images_of_kitti_is_said_of_the_cameras_that_are_chosen() {
    let raw = "S_03: 1000 370\nK_03: 700 0 1200 0 700 180 0 0 1\n";
    let all = found(&format!("{raw}{}", KITTI.replace("P", "P_rect_0")));
    let is_said = |found: &Found| {
        found
            .warnings
            .iter()
            .any(|one| one.to_string().contains("principal point 1200 of its raw images"))
    };
    assert!(is_said(&all), "{:?}", all.warnings);
    assert!(is_said(&all.choose_named(&["02", "03"]).unwrap()));
    assert!(!is_said(&all.choose_named(&["00", "01"]).unwrap()));
}

#[test]
fn a_single_camera_has_no_baseline() {
    let all = found(KITTI);
    let one = all.choose_named(&["camera 3"]).unwrap();
    assert_eq!(
        (names(&one), one.pair, one.baseline, one.doffs),
        (vec!["camera 3"], None, None, None)
    );
    assert_eq!(one.cameras[0].origin.how, "P3");
}

#[test]
fn of_a_zed_each_mode_can_be_chosen() {
    let all = found(include_str!("data/quirks/zed_four_modes.conf"));
    assert_eq!((all.pairs.len(), all.pairs[2].cameras), (4, [4, 5]));
    let hd = all.choose_named(&["left HD", "right HD"]).unwrap();
    assert_eq!(
        (hd.cameras[0].size, hd.cameras[0].fx.px(), meters(&hd)),
        (Some([1280, 720]), 700.25, 0.119_875)
    );
    // Two modes are no pair.
    assert_eq!(all.choose_named(&["left HD", "right VGA"]), Err(Refusal::TwoCameras));
}

#[test]
fn of_a_realsense_each_resolution_can_be_chosen() {
    let stream = |name: &str, width: u32, height: u32, f: f64| {
        let (cx, cy) = (f64::from(width) / 2.0, f64::from(height) / 2.0);
        format!(
            " Intrinsic of \"{name}\" / {width}x{height} / {{Y8}}\n  Width: {width}\n  Height: {height}\n  PPX: {cx}\n  PPY: {cy}\n  Fx: {f}\n  Fy: {f}\n  \
             Distortion: Brown Conrady\n  Coeffs: 0 0 0 0 0\n"
        )
    };
    let pair = |width, height, f| stream("Infrared 1", width, height, f) + &stream("Infrared 2", width, height, f);
    let shift = "Extrinsic from \"Infrared 1\" To \"Infrared 2\" :\n Translation Vector: -0.05 0 0\n";
    let text = pair(640, 480, 380.0) + &stream("Color", 1280, 720, 900.0) + &pair(1280, 720, 640.0) + shift;
    let all = found(&text);
    assert_eq!(
        names(&all),
        [
            "Infrared 1 640x480",
            "Infrared 2 640x480",
            "Infrared 1 1280x720",
            "Infrared 2 1280x720"
        ]
    );
    assert_eq!((all.pair, all.ignored.len()), (Some([0, 1]), 1));
    let large = all.choose(&[2, 3]).unwrap();
    assert_eq!(
        (large.cameras[0].fx.px(), meters(&large), large.doffs.unwrap().px()),
        (640.0, 0.05, 0.0)
    );
    // Where there is no first infrared stream, the depth stands in its place.
    let depth = text.replace("Infrared 1", "Depth");
    assert_eq!((meters(&found(&depth)), names(&found(&depth))[0]), (0.05, "Depth 640x480"));
}

#[test]
fn a_chain_of_kalibr_has_the_distance_of_any_two() {
    let camera = |number: u32, x: f64| {
        let link = if number == 0 {
            String::new()
        } else {
            format!(", T_cn_cnm1: [[1,0,0,{x}],[0,1,0,0],[0,0,1,0],[0,0,0,1]]")
        };
        format!("cam{number}: {{camera_model: pinhole, intrinsics: [700, 700, 640, 360], resolution: [1280, 720]{link}}}\n")
    };
    let text = camera(0, 0.0) + &camera(1, -0.1) + &camera(2, -0.25);
    let all = found(&text);
    assert_eq!((meters(&all), all.pairs.len()), (0.1, 3));
    assert_eq!(meters(&all.choose_named(&["cam1", "cam2"]).unwrap()), 0.25);
    let far = all.choose_named(&["cam0", "cam2"]).unwrap();
    assert_eq!(meters(&far), 0.35);
    assert_eq!(far.baseline_origin.unwrap().how, "distance from cam0 to cam2 by T_cn_cnm1");
    // Without the camera between them nothing is known.
    let gap = found(&(camera(0, 0.0) + &camera(2, -0.25)));
    assert!(gap.baseline.is_none());
}

#[test]
fn poses_say_which_camera_is_left_and_a_chain_that_contradicts_them_is_said() {
    let pose = |x: f64| format!("[[1,0,0,{x}],[0,1,0,0],[0,0,1,0],[0,0,0,1]]");
    let camera =
        |number: u32, x: f64, more: &str| format!("cam{number}: {{intrinsics: [700, 700, 640, 360], T_imu_cam: {}{more}}}\n", pose(x));
    let pair = found(&(camera(0, 0.3, "") + &camera(1, 0.2, "")));
    assert_eq!((meters(&pair), pair.pair), (0.1, Some([1, 0])));
    let link = format!(", T_cn_cnm1: {}", pose(-0.12));
    let both = found(&(camera(0, 0.2, "") + &camera(1, 0.3, &link)));
    assert_eq!(meters(&both), 0.12);
    let said = both.warnings.iter().map(ToString::to_string).collect::<String>();
    assert!(
        said.contains("|t| of T_cn_cnm1 in line 2 says 0.12 m, but distance by T_imu_cam in line 2 says 0.1 m"),
        "{said}"
    );
}

#[test]
fn of_colmap_any_camera_can_be_chosen_and_a_wrong_name_lists_them() {
    let all = found("1 PINHOLE 640 480 500 500 320 240\n2 OPENCV_FISHEYE 640 480 510 510 320 240 0 0 0 0\n");
    assert_eq!(all.pair, None);
    let one = all.choose_named(&["camera 1"]).unwrap();
    assert!(!one.warnings.iter().any(|one| matches!(one, Warning::Fisheye { .. })));
    let said = all.choose_named(&["left"]).unwrap_err().to_string();
    assert!(said.contains("“left”") && said.contains("“camera 1”, “camera 2”"), "{said}");
    let said = all.choose_named(&["1", "2", "1"]).unwrap_err().to_string();
    assert!(said.contains("two"), "{said}");
    assert!(all.choose(&[]).is_none() && all.choose(&[2]).is_none() && all.choose(&[0, 0]).is_none());
}
