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
    assert!(said(&outside).contains("440 lies outside"), "{}", said(&outside));
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
