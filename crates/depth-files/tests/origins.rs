//! Each number is said with where it stands and how it was derived.

#![allow(clippy::unwrap_used, clippy::expect_used, reason = "tests")]

use depth_files::{Found, Origin, read};
use std::fs;
use std::path::Path;

fn found(names: &[&str]) -> Found {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/quirks");
    let files: Vec<Vec<u8>> = names.iter().map(|name| fs::read(folder.join(name)).unwrap()).collect();
    let files: Vec<&[u8]> = files.iter().map(Vec::as_slice).collect();
    read(&files).unwrap()
}

fn origin(file: usize, line: usize, how: &str) -> Origin {
    let how = how.to_owned();
    Origin { file, line, how }
}

/// The line of a file, to compare with what was said of it.
fn line_of(name: &str, begins: &str) -> usize {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data/quirks");
    let text = fs::read_to_string(folder.join(name)).unwrap();
    1 + text.lines().position(|line| line.trim_start().starts_with(begins)).unwrap()
}

#[test]
fn the_baseline_of_each_format_is_said_with_its_line_and_its_formula() {
    for (file, begins, how) in [
        ("middlebury_2021_crlf_no_last_newline.txt", "baseline", "baseline"),
        ("kitti_odometry_with_Tr.txt", "P1", "P1[0][3] / P1[0][0]"),
        (
            "kitti_raw_colour_pair_crlf.txt",
            "P_rect_03",
            "(P_rect_02[0][3] - P_rect_03[0][3]) / P_rect_03[0][0]",
        ),
        ("zed_four_modes.conf", "Baseline", "Baseline"),
        ("orbslam2_stereo_not_real_yaml.yaml", "Camera.bf", "Camera.bf / fx"),
        ("orbslam3_pinhole_T_c1_c2.yaml", "Stereo.T_c1_c2", "|t| of Stereo.T_c1_c2"),
        ("kalibr_three_cameras.yaml", "T_cn_cnm1", "|t| of T_cn_cnm1"),
        ("opencv_left_right_names_baseline_cm.yml", "baseline_cm", "baseline_cm"),
        ("ros_ost_text_both_cameras.txt", "projection", "projection[0][3] / projection[0][0]"),
    ] {
        let said = found(&[file]).baseline_origin.expect(file);
        assert_eq!(said.how.replace(" of narrow_stereo/right", ""), how, "{file}");
        let first = line_of(file, begins);
        // A matrix may begin in the line below its key; of several with this key it is not the first.
        assert!(
            said.line == first || said.line == first + 1 || how.contains("projection"),
            "{file}: {said:?}"
        );
    }
}

#[test]
fn of_two_files_it_is_said_which_a_number_comes_from() {
    let pair = found(&["ros_topic_echo2_left.yaml", "ros_topic_echo2_right.yaml"]);
    assert_eq!(pair.cameras.iter().map(|camera| camera.origin.file).collect::<Vec<_>>(), [0, 1]);
    assert_eq!(pair.baseline_origin.as_ref().map(|origin| origin.file), Some(1));
    let turned = found(&["ros_topic_echo2_right.yaml", "ros_topic_echo2_left.yaml"]);
    assert_eq!(turned.baseline_origin.as_ref().map(|origin| origin.file), Some(0));
    assert_eq!(turned.baseline, pair.baseline);
    let place = pair.cameras.last().unwrap().origin.place();
    assert_eq!(place.words(&["l.yaml", "r.yaml"]), format!("line {} of r.yaml", place.line));
    assert_eq!(place.words(&[]), format!("line {} of file 2", place.line));
}

#[test]
fn doffs_is_of_the_file_or_of_the_principal_points() {
    let of_file = found(&["middlebury_doffs_contradicts_cx.txt"]);
    let line = line_of("middlebury_doffs_contradicts_cx.txt", "doffs");
    assert_eq!(of_file.doffs_origin, Some(origin(0, line, "doffs")));
    let of_points = found(&["opencv_T_plain_list_doffs.yml"]).doffs_origin.unwrap();
    assert_eq!(of_points.how, "cx of P2 - cx of P1");
}

#[test]
fn distortion_and_model_are_those_of_the_file() {
    let zed = found(&["zed_four_modes.conf"]);
    assert_eq!(zed.cameras.first().unwrap().distortion, [-0.171, 0.0273, 0.0001, -0.0002, -1e-10]);
    let colmap = found(&["colmap_seven_models_unordered.txt"]);
    let camera = colmap
        .cameras
        .iter()
        .find(|camera| camera.model.as_deref() == Some("SIMPLE_RADIAL"))
        .unwrap();
    assert_eq!((camera.distortion.len(), camera.sigma), (1, None));
    let kalibr = found(&["kalibr_flat_lists_equidistant.yaml"]);
    assert!(
        kalibr
            .cameras
            .iter()
            .all(|camera| camera.model.as_deref() == Some("equidistant") && camera.distortion.len() == 4)
    );
}
