//! Which of two cameras is which: a sign that is turned is a distance that is wrong.

#![allow(clippy::unwrap_used, reason = "tests")]

use depth_files::{Found, Warning, read};

fn info(name: &str, p: [f64; 4]) -> String {
    let [f, cx, cy, tx] = p;
    format!(
        "image_width: 1280\nimage_height: 720\ncamera_name: {name}\ndistortion_model: plumb_bob\nprojection_matrix:\n  rows: 3\n  cols: 4\n  data: \
         [{f}, 0, {cx}, {tx}, 0, {f}, {cy}, 0, 0, 0, 1, 0]\n"
    )
}

fn found(files: &[&str]) -> Found {
    let files: Vec<&[u8]> = files.iter().map(|text| text.as_bytes()).collect();
    read(&files).unwrap()
}

fn figures(found: &Found) -> (f64, f64) {
    let round = |number: f64| (number * 1e6).round() / 1e6;
    let value = match found.baseline.unwrap() {
        depth_files::Baseline::Known(length) => length.m(),
        depth_files::Baseline::InFileUnits { value, .. } => value,
    };
    (round(value), round(found.doffs.unwrap().px()))
}

#[test]
fn the_right_camera_is_the_right_one_in_whatever_order_its_file_comes() {
    let (left, right) = (
        info("left", [690.0, 630.0, 350.0, 0.0]),
        info("right", [690.0, 640.0, 350.0, -82.8]),
    );
    let (one, other) = (found(&[&left, &right]), found(&[&right, &left]));
    assert_eq!((figures(&one), one.pair), ((0.12, 10.0), Some([0, 1])));
    assert_eq!((figures(&other), other.pair), ((0.12, 10.0), Some([1, 0])));
    assert!(!other.warnings.contains(&Warning::Swapped));
}

#[test]
fn doffs_of_swapped_cameras_is_that_of_where_they_stand() {
    let file = "P1: {data: [690, 0, 630, 0, 0, 690, 350, 0, 0, 0, 1, 0]}\nP2: {data: [690, 0, 655, 82800, 0, 690, 350, 0, 0, 0, 1, 0]}\n";
    let found = found(&[file]);
    assert!(found.warnings.contains(&Warning::Swapped));
    assert_eq!((figures(&found), found.pair), ((120.0, -25.0), Some([1, 0])));
}

#[test]
fn a_vertical_pair_has_its_doffs_in_rows() {
    let file = "P1: {data: [690, 0, 630, 0, 0, 690, 350, 0, 0, 0, 1, 0]}\nP2: {data: [690, 0, 630, 0, 0, 690, 358, -82800, 0, 0, 1, 0]}\n";
    let found = found(&[file]);
    assert!(found.is_vertical);
    assert_eq!(figures(&found), (120.0, 8.0));
}

#[test]
fn without_the_last_column_of_p_the_baseline_is_that_of_t() {
    let file = "P1: [[690, 0, 630], [0, 690, 350], [0, 0, 1]]\nP2: [[690, 0, 655], [0, 690, 350], [0, 0, 1]]\nT: [-120, 0, 0]\n";
    assert_eq!(figures(&found(&[file])), (120.0, 25.0));
}

#[test]
fn a_chain_is_read_by_its_numbers_and_maps_of_cameras_by_their_names() {
    let chain = "cam1: {intrinsics: [700, 700, 640, 360], T_cn_cnm1: [1,0,0,-0.075, 0,1,0,0, 0,0,1,0, 0,0,0,1]}\ncam0: {intrinsics: [701, 701, 640, 360]}\n";
    let found_chain = found(&[chain]);
    assert_eq!(found_chain.cameras.first().unwrap().name, "cam0");
    assert!(found_chain.baseline.is_some());
    let k = |f: u32| format!("[[{f},0,640],[0,{f},360],[0,0,1]]");
    let json = format!(
        r#"{{"right":{{"camera_matrix":{}}},"left":{{"camera_matrix":{}}},"translation":[-60,0,0]}}"#,
        k(705),
        k(700)
    );
    let pair = found(&[&json]);
    assert_eq!(pair.cameras.iter().map(|one| one.fx.px()).collect::<Vec<_>>(), [700.0, 705.0]);
    assert!(pair.baseline.is_some());
}

#[test]
fn a_focal_length_of_another_world_is_not_believed_of_p() {
    let file = "M1: [[700,0,640],[0,700,360],[0,0,1]]\nM2: [[700,0,640],[0,700,360],[0,0,1]]\nT: [-120, 0, 0]\n\
                P1: {data: [53205, 0, 630, 0, 0, 53205, 350, 0, 0, 0, 1, 0]}\nP2: {data: [53205, 0, 655, -82800, 0, 53205, 350, 0, 0, 0, 1, 0]}\n";
    let found = found(&[file]);
    assert!(!found.is_rectified());
    assert_eq!(found.cameras.first().unwrap().fx.px(), 700.0);
}
