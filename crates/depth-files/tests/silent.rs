//! What was read wrongly, or without a word, where files are not as their formats say.

#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::indexing_slicing,
    clippy::panic,
    reason = "tests"
)]

use depth_files::{Baseline, Found, Refusal, Warning, read};

fn answer(files: &[&str]) -> Result<Found, Refusal> {
    let files: Vec<&[u8]> = files.iter().map(|text| text.as_bytes()).collect();
    read(&files)
}

fn found(files: &[&str]) -> Found {
    answer(files).unwrap()
}

fn refused(files: &[&str], names: &[&str]) -> String {
    answer(files).unwrap_err().sentence(names)
}

fn said(found: &Found) -> String {
    found.warnings.iter().map(ToString::to_string).collect::<Vec<_>>().join(" ")
}

fn pinhole(found: &Found, at: usize) -> [f64; 4] {
    let camera = &found.cameras[at];
    [camera.fx, camera.fy, camera.cx, camera.cy].map(|one| one.px())
}

fn meters(found: &Found) -> f64 {
    let length = found.baseline.and_then(|baseline| baseline.length(None)).unwrap();
    (length.m() * 1e9).round() / 1e9
}

fn units(found: &Found) -> f64 {
    match found.baseline {
        Some(Baseline::InFileUnits { value, .. }) => (value * 1e9).round() / 1e9,
        other => panic!("{other:?}"),
    }
}

const RIGHT: &str = "image_width: 1280\nimage_height: 960\ncamera_name: right\ndistortion_model: plumb_bob\n\
                     K: [800, 0, 640, 0, 800, 480, 0, 0, 1]\nP: [800, 0, 640, -96, 0, 800, 480, 0, 0, 0, 1, 0]\n";

#[test]
fn binning_and_region_of_interest_make_the_numbers_those_of_the_published_image() {
    let file =
        format!("{RIGHT}binning_x: 2\nbinning_y: 2\nroi: {{x_offset: 100, y_offset: 60, width: 1000, height: 800, do_rectify: true}}\n");
    let info = found(&[&file]);
    assert_eq!(pinhole(&info, 0), [400.0, 400.0, 270.0, 210.0]);
    assert_eq!(info.cameras[0].size, Some([500, 400]));
    // The baseline is what it was.
    assert_eq!(meters(&info), 0.12);
    assert!(said(&info).contains("binning 2 × 2"), "{}", said(&info));
    // What drivers write who do neither.
    let file = format!("{RIGHT}binning_x: 0\nbinning_y: 0\nroi: {{x_offset: 0, y_offset: 0, width: 0, height: 0, do_rectify: false}}\n");
    assert_eq!(found(&[&file]), found(&[RIGHT]));
}

#[test]
fn orb_slam_scales_its_numbers_to_the_size_that_it_gives_the_images() {
    let file = "Camera.type: \"PinHole\"\nCamera1.fx: 800\nCamera1.fy: 800\nCamera1.cx: 640\nCamera1.cy: 360\nCamera.width: 1280\n\
                Camera.height: 720\nCamera.newWidth: 640\nCamera.newHeight: 180\nStereo.b: 0.1\n";
    let settings = found(&[file]);
    assert_eq!(pinhole(&settings, 0), [400.0, 200.0, 320.0, 90.0]);
    assert_eq!((settings.cameras[0].size, meters(&settings)), (Some([640, 180]), 0.1));
    assert!(said(&settings).contains("640 × 180"));
}

#[test]
fn orb_slam_settings_of_two_cameras_contradict_each_other_aloud() {
    let file = "Camera.fx: 800\nCamera.fy: 800\nCamera.cx: 640\nCamera.cy: 360\nCamera.bf: 60\n\
                LEFT.P: [435, 0, 367, 0, 0, 435, 252, 0, 0, 0, 1, 0]\nRIGHT.P: [435, 0, 367, -47.9, 0, 435, 252, 0, 0, 0, 1, 0]\n";
    let settings = found(&[file]);
    assert_eq!(meters(&settings), 0.075);
    let said = said(&settings);
    assert!(
        said.contains("Camera.fx in line 1 says 800 px, but LEFT.P[0][0] in line 6 says 435 px: 800 px is used."),
        "{said}"
    );
    assert!(said.contains("0.075 m is used") && said.contains("0.110114943 m"), "{said}");
    let both = found(&[
        "Camera1.fx: 800\nCamera1.fy: 800\nCamera1.cx: 640\nCamera1.cy: 360\nCamera.bf: 60\nCamera.fx: 800\nCamera.fy: 800\nCamera.cx: 640\nCamera.cy: 360\nStereo.b: 0.12\n",
    ]);
    assert!(
        both.warnings.iter().any(|one| matches!(one, Warning::Contradiction { .. })),
        "{both:?}"
    );
}

const K: &str = "K1: [[700,0,640],[0,700,360],[0,0,1]]\nK2: [[700,0,640],[0,700,360],[0,0,1]]\n";
const P: &str = "P1: {data: [700, 0, 640, 0, 0, 700, 360, 0, 0, 0, 1, 0]}\nP2: {data: [700, 0, 640, -84000, 0, 700, 360, 0, 0, 0, 1, 0]}\n";

#[test]
fn contradictions_of_t_p_q_and_baseline_name_both_values_and_the_one_that_is_used() {
    let one = found(&[&format!("{P}T: [-60, 0, 0]\n")]);
    assert_eq!(units(&one), 120.0);
    assert!(
        said(&one).contains("P2[0][3] / P2[0][0] in line 2 says 120, but |T| in line 3 says 60: 120 is used."),
        "{}",
        said(&one)
    );
    let one = found(&[&format!("{K}T: [-60, 0, 0]\nbaseline_mm: 75\n")]);
    assert_eq!(meters(&one), 0.075);
    assert!(
        said(&one).contains("baseline_mm in line 4 says 0.075 m, but |T| in line 3 says 60"),
        "{}",
        said(&one)
    );
    let q = "Q: [1,0,0,-640, 0,1,0,-360, 0,0,0,500, 0,0,0.01,0.5]\n";
    let one = said(&found(&[&format!("{P}{q}")]));
    for words in [
        "but 1 / Q[3][2] in line 3 says 100",
        "but Q[2][3] in line 3 says 500 px",
        "but Q[3][3] / Q[3][2] in line 3 says 50 px",
    ] {
        assert!(one.contains(words), "{words}: {one}");
    }
    // The same in another unit is none.
    for same in [
        format!("{P}T: [-120, 0, 0]\n"),
        format!("{K}T: [-0.06, 0, 0]\nbaseline_mm: 60\n"),
        format!("{K}T: [-60, 0, 0]\nbaseline: 0.06\n"),
        format!("{K}T: [-2.4, 0, 0]\nsquare_size: 25\nbaseline_mm: 60\n"),
        format!("{P}Q: [1,0,0,-640, 0,1,0,-360, 0,0,0,700, 0,0,0.00833333,0]\n"),
    ] {
        let found = found(&[&same]);
        assert!(
            !found.warnings.iter().any(|one| matches!(one, Warning::Contradiction { .. })),
            "{same}: {}",
            said(&found)
        );
    }
}

#[test]
fn q_alone_gives_a_rectified_pair_with_its_doffs() {
    let q =
        "Q: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: d\n   data: [1, 0, 0, -640, 0, 1, 0, -360, 0, 0, 0, 700, 0, 0, 0.01, 0.25]\n";
    let file = format!("%YAML:1.0\n---\n{q}");
    let pair = found(&[&file]);
    assert_eq!(
        (pinhole(&pair, 0), pinhole(&pair, 1)),
        ([700.0, 700.0, 640.0, 360.0], [700.0, 700.0, 665.0, 360.0])
    );
    assert_eq!((units(&pair), pair.doffs.unwrap().px(), pair.is_rectified()), (100.0, 25.0, true));
    assert_eq!(pair.baseline_origin.as_ref().unwrap().how, "1 / Q[3][2]");
    let swapped = found(&[&file.replace("0.01, 0.25", "-0.01, -0.25")]);
    assert_eq!(
        (units(&swapped), swapped.doffs.unwrap().px(), swapped.pair),
        (100.0, -25.0, Some([1, 0]))
    );
    let refused = refused(&[&file.replace("[1, 0,", "[2, 0,")], &[]);
    assert!(refused.contains("Q[0][0] is 2"), "{refused}");
}

#[test]
fn a_baseline_without_a_unit_is_one_whose_unit_is_asked_for() {
    let pair = found(&[&format!("{K}baseline: 60\n")]);
    assert_eq!(units(&pair), 60.0);
    assert!(said(&pair).contains("unit") && pair.baseline_origin.unwrap().how == "baseline");
}

#[test]
fn utf_16_is_read_in_both_orders() {
    let text = "cam0=[700 0 320; 0 700 240; 0 0 1]\r\ncam1=[700 0 320; 0 700 240; 0 0 1]\r\ndoffs=0\r\nbaseline=100\r\nwidth=640\r\nheight=480\r\n";
    let units: Vec<u16> = std::iter::once(0xfeff).chain(text.encode_utf16()).collect();
    let little: Vec<u8> = units.iter().flat_map(|unit| unit.to_le_bytes()).collect();
    let big: Vec<u8> = units.iter().flat_map(|unit| unit.to_be_bytes()).collect();
    for bytes in [little, big] {
        assert_eq!(read(&[&bytes]).unwrap(), found(&[text]));
    }
}

#[test]
fn realsense_is_read_as_a_comment_or_a_text_too() {
    let plain = include_str!("data/quirks/realsense_infrared_pair.txt");
    let begin_with = |start: &str, end: &str| plain.lines().map(|line| format!("{start}{line}{end}\n")).collect::<String>();
    for changed in [
        begin_with("# ", ""),
        begin_with("// ", ""),
        begin_with("    > ", ""),
        format!("'{plain}'"),
        begin_with("\"", "\",")
            .replace("Infrared 1\"", "Infrared 1\\\"")
            .replace("of \"", "of \\\""),
    ] {
        let found = found(&[&changed]);
        assert_eq!((found.cameras.len(), meters(&found)), (2, 0.050_312_742), "{changed}");
    }
}

#[test]
fn a_transposed_matrix_is_read_as_it_is_meant_and_said() {
    let file = "camera_matrix: [[700,0,0],[0,710,0],[640,360,1]]\ndist_coeff: [0,0,0,0]\n";
    let camera = found(&[file]);
    assert_eq!(pinhole(&camera, 0), [700.0, 710.0, 640.0, 360.0]);
    assert!(said(&camera).contains("camera_matrix in line 1 is transposed"), "{}", said(&camera));
    let p = "P1: [[700,0,0],[0,700,0],[640,360,1],[0,0,0]]\nP2: [[700,0,0],[0,700,0],[650,360,1],[-84000,0,0]]\n";
    let pair = found(&[p]);
    assert_eq!((units(&pair), pair.doffs.unwrap().px()), (120.0, 10.0));
}

#[test]
fn the_size_of_both_images_side_by_side_is_halved_and_said() {
    let file = "image_width: 2560\nimage_height: 960\n".to_owned() + &K.replace("640", "635").replace("360", "470");
    let pair = found(&[&file]);
    assert_eq!(pair.cameras[1].size, Some([1280, 960]));
    assert!(said(&pair).contains("side by side"), "{}", said(&pair));
    // A wide image with its principal point in the middle is one.
    let kitti = found(&[&file.replace("635", "1275")]);
    assert_eq!(kitti.cameras[0].size, Some([2560, 960]));
}

#[test]
fn of_two_files_a_refusal_names_the_one_that_its_line_is_of() {
    let names = ["left.yaml", "right.yaml"];
    let wrong = RIGHT
        .replace("camera_name: right", "camera_name: left")
        .replace("800, 0, 640, -96", "fx, 0, 640, -96");
    let refusal = refused(&[RIGHT, &wrong], &names);
    assert!(refusal.contains("line 6 of right.yaml") && refusal.contains("“fx”"), "{refusal}");
    assert!(refused(&[&wrong, RIGHT], &names).contains("line 6 of left.yaml"));
    assert_eq!(refused(&[RIGHT, ""], &names), "right.yaml: The file is empty.");
    assert!(refused(&[RIGHT, "title: no camera\n"], &names).starts_with("right.yaml: No calibration"));
}

#[test]
fn a_file_that_is_given_twice_counts_once() {
    let twice = found(&[RIGHT, RIGHT]);
    assert_eq!(twice.cameras.len(), 1);
    assert_eq!(twice.warnings[0].sentence(&["a", "b"]), "b holds the same as a, and is left out.");
    assert_eq!(meters(&twice), 0.12);
}

#[test]
fn three_files_are_a_choice_or_are_refused() {
    let left = RIGHT.replace("right", "left").replace("-96", "0");
    let three = found(&[&left, RIGHT, &RIGHT.replace("right", "far").replace("-96", "-192")]);
    assert_eq!((three.cameras.len(), three.pair, three.baseline), (3, None, None));
    assert!(said(&three).contains("3 cameras: choose which"), "{}", said(&three));
    let pair = three.choose_named(&["far", "left"]).unwrap();
    assert_eq!((meters(&pair), pair.cameras[0].name.as_str()), (0.24, "left"));
    let kitti = include_str!("data/quirks/kitti_odometry_with_Tr.txt");
    let refusal = refused(&[kitti, &format!("{kitti}\n")], &[]);
    assert!(refusal.contains("one file"), "{refusal}");
    // Files of single cameras are those of a pair, in the order in which they are given.
    let singles = [
        "K: [[700,0,640],[0,700,360],[0,0,1]]\n",
        "K: [[705,0,640],[0,705,360],[0,0,1]]\n",
        "T: [-60, 0, 0]\n",
    ];
    let pair = found(&singles);
    assert_eq!((pinhole(&pair, 0)[0], pinhole(&pair, 1)[0], units(&pair)), (700.0, 705.0, 60.0));
    assert_eq!(pair.cameras[1].origin.file, 1);
}

#[test]
fn a_decimal_comma_is_named_with_its_line() {
    let refusal = refused(
        &[
            "image_width: 640\ncamera_matrix: {rows: 3, cols: 3, data: [700,5, 0,0, 320,0, 0,0, 700,5, 240,0, 0,0, 0,0, 1,0]}\ndistortion_model: plumb_bob\n",
        ],
        &[],
    );
    assert!(refusal.contains("line 2") && refusal.contains("decimal"), "{refusal}");
    let refusal = refused(&["[LEFT_CAM_HD]\nfx=700,5\nfy=700\ncx=640\ncy=360\n"], &[]);
    assert!(refusal.contains("line 2") && refusal.contains("700.5"), "{refusal}");
    let refusal = refused(
        &["cam0=[700 0 320; 0 700 240; 0 0 1]\ncam1=[700 0 320; 0 700 240; 0 0 1]\nbaseline=193,001\n"],
        &[],
    );
    assert!(refusal.contains("line 3") && refusal.contains("points"), "{refusal}");
}

#[test]
fn a_baseline_is_judged_as_soon_as_its_unit_is_known() {
    let kitti = found(&[include_str!("data/quirks/kitti_raw_colour_pair_crlf.txt")]);
    assert_eq!(said(&kitti), "");
    let pair = found(&[&format!("{K}T: [-120, 0, 0]\n")]);
    assert!(!said(&pair).contains("implausible"));
    let unit = depth_core::quantity::Length::from_m;
    let in_meters = pair.clone().in_unit(unit(1.0));
    assert!(said(&in_meters).contains("120 m is implausible") && !said(&in_meters).contains("which unit"));
    assert!(!said(&pair.in_unit(unit(0.001))).contains("implausible"));
}
