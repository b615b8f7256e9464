//! Numbers of a file that do not go together are said, with both values.

#![allow(clippy::unwrap_used, clippy::panic, reason = "tests")]

use depth_files::{Baseline, Found, Refusal, Warning, read};

fn answer(files: &[&str]) -> Result<Found, Refusal> {
    let files: Vec<&[u8]> = files.iter().map(|text| text.as_bytes()).collect();
    read(&files)
}

fn found(files: &[&str]) -> Found {
    answer(files).unwrap()
}

fn said(found: &Found) -> String {
    let all: Vec<String> = found.warnings.iter().map(ToString::to_string).collect();
    all.join(" ")
}

fn value(found: &Found) -> f64 {
    let value = match found.baseline {
        Some(Baseline::Known(length)) => length.m(),
        Some(Baseline::InFileUnits { value, .. }) => value,
        None => panic!("no baseline in {found:?}"),
    };
    (value * 1e9).round() / 1e9
}

const KITTI: &str = "S_101: 880 400\nK_101: 1000 0 430 0 1000 200 0 0 1\nT_101: 0 0 0\nP_rect_101: 1000 0 430 0 0 1000 200 0 0 0 1 0\n\
                     S_103: 880 400\nK_103: 1000 0 440 0 1000 200 0 0 1\nT_103: -0.5 0.01 0\nP_rect_103: 1000 0 430 -1000 0 1000 200 0 0 0 1 0\n";

#[test]
fn a_baseline_of_kitti_that_contradicts_what_was_measured_is_that_which_was_measured() {
    let pair = found(&[KITTI]);
    assert_eq!(value(&pair), 0.50009999);
    assert!(
        said(&pair).contains(
            "distance by T_101 and T_103 in line 7 says 0.50009999 m, but P_rect_103[0][3] / P_rect_103[0][0] in line 8 says 1 m"
        ),
        "{}",
        said(&pair)
    );
    let agreed = found(&[&KITTI.replace("-1000", "-502")]);
    assert_eq!((value(&agreed), said(&agreed).as_str()), (0.502, ""));
    let outside = found(&[&KITTI.replace("-1000", "-502").replace("S_103: 880", "S_103: 430")]);
    assert!(
        said(&outside).contains("camera 103: the principal point 440 of its raw images lies outside"),
        "{}",
        said(&outside)
    );
}

#[test]
fn each_shift_of_kitti_is_divided_by_the_focal_length_of_its_own_camera() {
    let pair = found(&["P2: 700 0 600 70 0 700 180 0 0 0 1 0\nP3: 800 0 600 -320 0 800 180 0 0 0 1 0\n"]);
    assert_eq!(value(&pair), 0.5);
    assert!(
        said(&pair).contains("700 px in P2 in line 1, and 800 px in P3 in line 2"),
        "{}",
        said(&pair)
    );
    let refusal = answer(&["P2: 700 0 600 0 0 700 180 0 0 0 0.8 0\n"]).unwrap_err();
    assert!(refusal.to_string().contains("P2[2][2] is 0.8"), "{refusal}");
}

fn info(name: &str, [width, height]: [u32; 2], [f, cx, tx]: [f64; 3]) -> String {
    format!(
        "image_width: {width}\nimage_height: {height}\ncamera_name: {name}\ndistortion_model: plumb_bob\n\
         projection_matrix: {{rows: 3, cols: 4, data: [{f}, 0, {cx}, {tx}, 0, {f}, 180, 0, 0, 0, 1, 0]}}\n"
    )
}

#[test]
fn two_files_of_ros_of_other_sizes_have_no_doffs() {
    let pair = found(&[
        &info("left", [640, 360], [500.0, 320.0, 0.0]),
        &info("right", [1280, 720], [500.0, 640.0, -60.0]),
    ]);
    assert_eq!((value(&pair), pair.doffs), (0.12, None));
    assert!(said(&pair).contains("640 × 360 and 1280 × 720"), "{}", said(&pair));
}

#[test]
fn rectified_cameras_of_two_focal_lengths_are_said_to_be_mixed() {
    let ros = found(&[
        &info("left", [640, 360], [500.0, 320.0, 0.0]),
        &info("right", [640, 360], [510.0, 320.0, -51.0]),
    ]);
    let opencv =
        found(&["P1: {data: [500, 0, 320, 0, 0, 500, 180, 0, 0, 0, 1, 0]}\nP2: {data: [510, 0, 320, -51, 0, 510, 180, 0, 0, 0, 1, 0]}\n"]);
    let middlebury = found(&["cam0=[500 0 320; 0 500 180; 0 0 1]\ncam1=[510 0 320; 0 510 180; 0 0 1]\ndoffs=0\nbaseline=100\n"]);
    for pair in [ros, opencv, middlebury] {
        assert!(
            pair.warnings.iter().any(|one| matches!(one, Warning::FocalLengths { .. })),
            "{pair:?}"
        );
    }
    let same = found(&[
        &info("left", [640, 360], [500.0, 320.0, 0.0]),
        &info("right", [640, 360], [504.0, 320.0, -50.4]),
    ]);
    assert_eq!(said(&same), "");
}

#[test]
fn a_matrix_whose_last_number_is_not_1_is_divided_by_it_or_not_used() {
    let k = found(&["camera_matrix: [[1400,0,1280],[0,1400,720],[0,0,2]]\ndist_coeffs: [0,0,0,0]\n"]);
    assert_eq!(k.cameras.first().unwrap().fx.px(), 700.0);
    assert!(said(&k).contains("camera_matrix in line 1 is 2, not 1"), "{}", said(&k));
    let p = "image_width: 1280\nimage_height: 720\ndistortion_model: plumb_bob\nK: [700, 0, 640, 0, 700, 360, 0, 0, 1]\n\
             P: [690, 0, 640, -69, 0, 690, 360, 0, 0, 0, 0.8377, 0]\n";
    let p = found(&[p]);
    assert_eq!(
        (p.cameras.first().unwrap().fx.px(), p.baseline, p.is_rectified()),
        (700.0, None, false)
    );
    assert!(said(&p).contains("0.8377"), "{}", said(&p));
}

#[test]
fn rectified_images_of_another_size_are_not_said_to_be_of_the_one_in_the_file() {
    let file = |p: &str| {
        format!(
            "image_width: 1280\nimage_height: 720\ndistortion_model: plumb_bob\nK: [700, 0, 640, 0, 700, 360, 0, 0, 1]\nP: [{p}, 0, 1, 0]\n"
        )
    };
    let half = found(&[&file("350, 0, 322, -35, 0, 350, 179, 0, 0")]);
    assert_eq!((half.cameras.first().unwrap().size, value(&half)), (None, 0.1));
    assert!(said(&half).contains("0.5 times as large as 1280 × 720"), "{}", said(&half));
    // Zoomed, and of the same size.
    let zoomed = found(&[&file("490, 0, 640, -49, 0, 490, 360, 0, 0")]);
    assert_eq!(
        (zoomed.cameras.first().unwrap().size, said(&zoomed).as_str()),
        (Some([1280, 720]), "")
    );
    let opencv = found(&[
        "image_size: [1280, 720]\nM1: [[700,0,640],[0,700,360],[0,0,1]]\nP1: {data: [350, 0, 320, 0, 0, 350, 180, 0, 0, 0, 1, 0]}\n\
         P2: {data: [350, 0, 320, -21000, 0, 350, 180, 0, 0, 0, 1, 0]}\n",
    ]);
    assert_eq!(opencv.cameras.last().unwrap().size, None);
    assert!(said(&opencv).contains("0.5 times"), "{}", said(&opencv));
}

#[test]
fn the_unit_of_a_baseline_is_guessed_by_what_is_a_distance_of_two_lenses() {
    const K: &str = "K1: [[700,0,640],[0,700,360],[0,0,1]]\nK2: [[700,0,640],[0,700,360],[0,0,1]]\n";
    for (rest, words) in [
        ("T: [-0.06, 0, 0]\nsquare_size: 0.025\n", "probably m."),
        ("T: [-60, 0, 0]\nsquare_size: 25\n", "probably mm."),
        ("T: [-6, 0, 0]\nsquare_size: 2.5\n", "probably cm."),
        ("T: [-2.4, 0, 0]\nsquare_size: 25\n", "probably squares"),
        ("T: [-2.4, 0, 0]\nsquare_size: 1\n", "probably squares"),
        ("T: [-2.4, 0, 0]\n", "probably squares"),
        ("T: [-120, 0, 0]\n", "probably mm."),
        ("T: [-0.12, 0, 0]\n", "probably m."),
    ] {
        let pair = found(&[&format!("{K}{rest}")]);
        assert!(said(&pair).contains(words), "{rest}: {}", said(&pair));
    }
    for (rest, meters) in [
        ("T: [-12, 0, 0]\nunits: cm\n", 0.12),
        ("T: [-120, 0, 0]\nunit: mm\n", 0.12),
        ("T: [-0.12, 0, 0]\nlength_unit: meters\n", 0.12),
    ] {
        let pair = found(&[&format!("{K}{rest}")]);
        assert!(
            matches!(pair.baseline, Some(Baseline::Known(_))) && value(&pair) == meters,
            "{rest}: {pair:?}"
        );
    }
}

#[test]
fn of_a_key_that_stands_twice_the_last_value_is_taken_and_both_lines_are_said() {
    let yaml = found(&["K: [[700,0,640],[0,700,360],[0,0,1]]\nD: [0,0,0,0]\nK:\n  - [800,0,640]\n  - [0,800,360]\n  - [0,0,1]\n"]);
    assert_eq!(yaml.cameras.first().unwrap().fx.px(), 800.0);
    assert!(said(&yaml).contains("“K” stands twice, in line 1 and in line 3"), "{}", said(&yaml));
    let json = found(&["{\"fx\": 700, \"fy\": 700, \"cx\": 320, \"cy\": 240,\n\"fx\": 800}"]);
    assert_eq!(json.cameras.first().unwrap().fx.px(), 800.0);
    assert!(said(&json).contains("“fx” stands twice"), "{}", said(&json));
    let middlebury =
        found(&["cam0=[500 0 320; 0 500 180; 0 0 1]\ncam1=[500 0 320; 0 500 180; 0 0 1]\ndoffs=0\nbaseline=100\nbaseline=200\n"]);
    assert_eq!(value(&middlebury), 0.2);
    assert!(
        said(&middlebury).contains("“baseline” stands twice, in line 4 and in line 5"),
        "{}",
        said(&middlebury)
    );
}

#[test]
fn the_line_of_a_matrix_is_that_of_its_key() {
    let camera = found(&["D: [0,0,0,0]\nK:\n  - [700,0,640]\n  - [0,700,360]\n  - [0,0,1]\n"]);
    assert_eq!(camera.cameras.first().unwrap().origin.line, 2);
}

#[test]
fn a_fisheye_model_under_the_names_of_opencv_is_said() {
    const K: &str = "K1: [[700,0,640],[0,700,360],[0,0,1]]\nK2: [[700,0,640],[0,700,360],[0,0,1]]\nT: [-60, 0, 0]\n";
    for line in ["fisheye_model: 1", "model: fisheye", "fisheye: true"] {
        let pair = found(&[&format!("{K}{line}\n")]);
        assert!(said(&pair).contains("fisheye lens"), "{line}: {}", said(&pair));
    }
    for line in ["fisheye_model: 0", "model: pinhole", "fisheye: false"] {
        let pair = found(&[&format!("{K}{line}\n")]);
        assert!(!said(&pair).contains("fisheye lens"), "{line}: {}", said(&pair));
    }
}

#[test]
fn of_two_files_of_single_cameras_the_first_is_said_to_be_taken_as_the_left_one() {
    let file = |f: u32| format!("camera_matrix: [[{f},0,640],[0,{f},360],[0,0,1]]\n");
    let pair = found(&[&file(700), &file(705)]);
    assert!(said(&pair).contains("the first file is taken as the left one"), "{}", said(&pair));
    assert!(said(&pair).contains("give the file of the extrinsics"), "{}", said(&pair));
}

#[test]
fn a_camera_in_front_of_the_other_is_no_pair_and_one_above_it_is_not_at_its_left() {
    let chain = |t: &str| {
        format!(
            "cam0: {{intrinsics: [700, 700, 640, 360]}}\ncam1: {{intrinsics: [700, 700, 640, 360], T_cn_cnm1: [1,0,0,{}, 0,1,0,{}, 0,0,1,{}, 0,0,0,1]}}\n",
            t.split(' ').next().unwrap(),
            t.split(' ').nth(1).unwrap(),
            t.split(' ').nth(2).unwrap()
        )
    };
    let ahead = said(&found(&[&chain("0 0 -0.1")]));
    assert!(ahead.contains("in front of the other") && !ahead.contains("zero"), "{ahead}");
    let above = said(&found(&[&chain("0 0.1 0")]));
    assert!(
        above.contains("Upper and lower are swapped") && !above.contains("Left and right"),
        "{above}"
    );
}

#[test]
fn the_same_message_of_ros_again_is_not_another_camera() {
    let right = info("right", [640, 360], [500.0, 320.0, -60.0]);
    let twice = found(&[&format!("{right}---\n{right}---\n")]);
    assert_eq!((twice.cameras.len(), value(&twice)), (1, 0.12));
    assert!(!said(&twice).contains("zero"), "{}", said(&twice));
}

#[test]
fn a_camera_of_ros_that_is_named_neither_left_nor_right_is_a_single_one() {
    let webcam = said(&found(&[&info("webcam", [640, 360], [500.0, 320.0, 0.0])]));
    assert!(!webcam.contains("right camera") && webcam.contains("no baseline"), "{webcam}");
    let left = said(&found(&[&info("stereo/left", [640, 360], [500.0, 320.0, 0.0])]));
    assert!(left.contains("right camera"), "{left}");
}

#[test]
fn a_text_about_something_else_is_no_calibration_rather_than_damaged() {
    for text in [
        "Shopping: bread\n- milk: two: three\n\tand more: [\n",
        "To whom it may concern: hello\n  - a: b\n c: {\n",
    ] {
        let refusal = answer(&[text]).unwrap_err();
        assert!(refusal.to_string().starts_with("No calibration is recognized"), "{refusal}");
    }
    let damaged = answer(&["camera_matrix: !!opencv-matrix\n   rows: 3\n   data: [700, 0,\n"]).unwrap_err();
    assert!(damaged.to_string().contains("truncated"), "{damaged}");
}

#[test]
fn two_files_that_the_calibrator_of_ros_printed_are_a_pair() {
    let ost = |name: &str, tx: f64| {
        format!(
            "# oST version 5.0 parameters\n\n[image]\n\nwidth\n640\n\nheight\n360\n\n[{name}]\n\ncamera matrix\n500 0 320\n0 500 180\n0 0 1\n\n\
             distortion\n0 0 0 0 0\n\nrectification\n1 0 0\n0 1 0\n0 0 1\n\nprojection\n500 0 320 {tx}\n0 500 180 0\n0 0 1 0\n"
        )
    };
    let (left, right) = (ost("left", 0.0), ost("right", -60.0));
    let pair = found(&[&left, &right]);
    assert_eq!((value(&pair), pair.doffs.unwrap().px(), pair.pair), (0.12, 0.0, Some([0, 1])));
    assert_eq!(pair.cameras.iter().map(|camera| camera.origin.file).collect::<Vec<_>>(), [0, 1]);
    let wrong = answer(&[&left, &right.replace("500 0 320 -60", "x 0 320 -60")]).unwrap_err();
    assert!(wrong.to_string().contains("of file 2"), "{wrong}");
}

#[test]
fn cameras_of_euroc_are_named_by_their_comments_and_not_by_the_order_of_the_files() {
    let file = |name: &str, x: f64| {
        format!(
            "sensor_type: camera\ncomment: Rig {name} (left or right)\nT_BS: {{rows: 4, cols: 4, data: [1,0,0,{x}, 0,1,0,0, 0,0,1,0, 0,0,0,1]}}\n\
             intrinsics: [700, 700, 640, 360]\nresolution: [1280, 720]\n"
        )
    };
    let (left, right) = (file("cam0", 0.0), file("cam1", 0.1));
    for files in [[&left, &right], [&right, &left]] {
        let pair = found(&files.map(String::as_str));
        let names: Vec<&str> = pair.cameras.iter().map(|camera| camera.name.as_str()).collect();
        assert_eq!((names, pair.pair, value(&pair)), (vec!["cam0", "cam1"], Some([0, 1]), 0.1));
        assert!(!said(&pair).contains("cam0"), "{}", said(&pair));
    }
    // Without them, the order of the files is said to be all there is.
    let unnamed = found(&[&file("one", 0.0), &file("other", 0.1)]);
    assert_eq!((value(&unnamed), unnamed.pair), (0.1, Some([0, 1])));
    assert!(said(&unnamed).contains("do not say which camera is cam0"), "{}", said(&unnamed));
}

#[test]
fn a_model_that_is_no_pinhole_is_refused_with_the_line_that_says_it() {
    let chain = "cam0:\n  intrinsics: [0.8, 700, 700, 640, 360]\n  camera_model: omni\n";
    let refusal = answer(&[chain]).unwrap_err();
    assert!(refusal.to_string().contains("“omni” in line 3"), "{refusal}");
}
