//! Calibration files: `import`, and `calculate --from`. What each kind of file means is tested in `crates/depth-files`.

use super::{json, run, text};
use serde_json::Value;

const FILES: &str = "crates/depth-files/tests/data/quirks";

fn answer(arguments: &str) -> Value {
    let output = run(&format!("import {arguments} --json"));
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    assert!(output.stderr.is_empty());
    serde_json::from_slice(&output.stdout).unwrap()
}

fn refused(arguments: &str) -> String {
    let output = run(arguments);
    let said = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{said}");
    assert_eq!((said.lines().count(), output.stdout.len()), (1, 0), "{said}");
    said
}

fn near(value: &Value, expected: f64) {
    let value = value.as_f64().unwrap();
    assert!((value - expected).abs() <= 1e-9 * expected, "{value} instead of {expected}");
}

#[test]
fn a_file_says_its_cameras_and_their_baseline() {
    let found = answer(&format!("{FILES}/middlebury_2021_crlf_no_last_newline.txt"));
    assert_eq!((&found["format"], &found["rectified"]), (&"middlebury".into(), &true.into()));
    near(&found["baseline_m"], 0.124_875);
    near(&found["cameras"][0]["fx"], 1758.25);
    assert_eq!(found["cameras"][0]["width"], 1920);
    assert_eq!(found["warnings"].as_array().unwrap().len(), 0);
}

#[test]
fn a_unit_that_the_file_does_not_say_is_asked_for_and_then_taken() {
    let file = format!("{FILES}/opencv_nested_maps_crlf.yml");
    let asks = answer(&file);
    assert!(asks["baseline_m"].is_null());
    near(&asks["baseline_file_units"], 201.0);
    assert!(asks["warnings"][0]["message"].as_str().unwrap().contains("unit"), "{asks}");
    let told = answer(&format!("{file} --file-unit 25mm"));
    near(&told["baseline_m"], 5.025);
    // At 25 mm for a square that would be five meters, which is said; the unit no more.
    assert!(!told["warnings"].to_string().contains("does not say"), "{told}");
}

#[test]
fn two_files_of_one_pair_belong_together() {
    let found = answer(&format!("{FILES}/euroc_tabs_cam0.yaml {FILES}/euroc_tabs_cam1.yaml"));
    near(&found["baseline_m"], 0.110_131_103_700_069_73);
    let said = refused(&format!("import {FILES}/euroc_tabs_cam0.yaml {FILES}/opencv_nested_maps_crlf.yml"));
    assert!(said.contains("do not go together"), "{said}");
}

#[test]
fn a_distance_follows_from_a_file_and_a_disparity() {
    let file = format!("{FILES}/middlebury_spaces_and_pasted_matrix.txt");
    // 3980 px · 193 mm / (60 px + 124.5 px)
    let (out, _) = text(&format!("calculate --from {file} --disparity 60"));
    assert!(out.join(" ").contains("4.163 m"), "{out:?}");
    // What is given wins.
    let (out, _) = text(&format!("calculate --from {file} --disparity 60 --baseline 386mm"));
    assert!(out.join(" ").contains("8.327 m"), "{out:?}");
    let file = format!("{FILES}/opencv_nested_maps_crlf.yml");
    let said = refused(&format!("calculate --from {file} --disparity 50"));
    assert!(said.contains("--file-unit 1mm"), "{said}");
    let (out, _) = text(&format!("calculate --from {file} --file-unit 1mm --disparity 50"));
    assert!(out.join(" ").contains("4.577 m"), "{out:?}");
    // One camera needs no baseline, and is not asked for its unit.
    let (out, _) = text(&format!("calculate --from {file} --w-img 100 --w-real 1m"));
    assert!(out.join(" ").contains("11.39 m") || out.join(" ").contains("11.38 m"), "{out:?}");
}

#[test]
fn what_is_no_calibration_is_refused_in_one_line() {
    for (file, word) in [
        ("hostile_zed_html_page.conf", "web page"),
        ("hostile_colmap_binary.bin", "TXT"),
        ("kalibr_template_words_for_numbers.yaml", "line 3"),
        ("no_such_file", "cannot be read"),
    ] {
        let said = refused(&format!("import {FILES}/{file}"));
        assert!(said.contains(word), "{said}");
    }
}

#[test]
fn what_a_file_says_of_its_pair_is_not_ignored() {
    let folder = std::env::temp_dir();
    let file = folder.join("depth-calculator-vertical.yml");
    let p2 = "P2: {data: [690, 0, 630, 0, 0, 690, 358, -82800, 0, 0, 1, 0]}";
    std::fs::write(&file, format!("P1: {{data: [690, 0, 630, 0, 0, 690, 350, 0, 0, 0, 1, 0]}}\n{p2}\n")).unwrap();
    let vertical = file.display();
    // One above the other: rows, and doffs of rows. 690 px · 120 mm / (50 px + 8 px)
    let said = refused(&format!("calculate --from {vertical} --file-unit 1mm --disparity 50"));
    assert!(said.contains("--pair vertical"), "{said}");
    let (out, _) = text(&format!(
        "calculate --from {vertical} --file-unit 1mm --disparity 50 --pair vertical"
    ));
    assert!(out.join(" ").contains("1.428 m"), "{out:?}");
    let said = refused(&format!(
        "calculate --from {FILES}/middlebury_2021_crlf_no_last_newline.txt --disparity 50 --pair vertical"
    ));
    assert!(said.contains("side by side"), "{said}");
    // The right camera alone has no doffs, which is said.
    let (_, err) = text(&format!(
        "calculate --from {FILES}/ros_topic_echo1_right_only_R_nan.yaml --disparity 50"
    ));
    assert!(err.join(" ").contains("doffs is not in it"), "{err:?}");
    // Why there is no baseline is said where it is missing.
    let said = refused(&format!("calculate --from {FILES}/orbslam2_bf_zero.yaml --disparity 50"));
    assert!(said.contains("--baseline") && said.contains("single camera"), "{said}");
}

#[test]
fn each_number_is_said_with_where_it_comes_from() {
    let (left, right) = (
        format!("{FILES}/ros_topic_echo2_left.yaml"),
        format!("{FILES}/ros_topic_echo2_right.yaml"),
    );
    let (out, _) = text(&format!("import {left} {right}"));
    let baseline = out.iter().find(|line| line.starts_with("baseline")).unwrap();
    assert!(
        baseline.contains("[0][3] / ") && baseline.ends_with(&format!(" of {right}")),
        "{baseline}"
    );
    let found = answer(&format!("{left} {right}"));
    assert_eq!(found["baseline_origin"]["file"], right.as_str());
    assert_eq!(found["cameras"][0]["line"], found["cameras"][0]["origin"]["line"]);
    assert!(found["cameras"][0]["distortion"].as_array().unwrap().len() >= 4, "{found}");
    let (out, _) = text(&format!("import {FILES}/middlebury_2021_crlf_no_last_newline.txt"));
    assert!(
        out.iter()
            .any(|line| line.starts_with("baseline 0.1") && line.contains(", baseline, line ")),
        "{out:?}"
    );
}

#[test]
fn another_camera_or_pair_is_chosen_by_name() {
    let file = format!("{FILES}/zed_four_modes.conf");
    let run_of = |names: [&str; 2]| {
        let output = super::run_words(&["import", &file, "--json", "--camera", &names.join(",")]);
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        serde_json::from_slice::<Value>(&output.stdout).unwrap()
    };
    let hd = run_of(["left HD", "right HD"]);
    assert_eq!(
        (hd["cameras"].as_array().unwrap().len(), &hd["cameras"][0]["fx"]),
        (2, &700.25.into())
    );
    near(&hd["baseline_m"], 0.119_875);
    let kitti = format!("{FILES}/kitti_odometry_with_Tr.txt");
    // 718.875 px * 0.53232 m / 38.2675 px
    let (out, _) = text(&format!("calculate --from {kitti} --camera 2,3 --disparity 38.26725"));
    assert!(out.join(" ").contains("10.00 m"), "{out:?}");
    let said = refused(&format!("calculate --from {kitti} --camera left --disparity 38"));
    assert!(said.contains("camera 0"), "{said}");
}

#[test]
fn a_disparity_that_is_asked_for_takes_the_baseline_from_the_file() {
    let file = format!("{FILES}/middlebury_spaces_and_pasted_matrix.txt");
    // 3980 px · 193 mm / 2 m - 124.5 px
    let (out, _) = text(&format!("calculate --from {file} --distance 2m --solve-for disparity"));
    assert!(out.join(" ").contains("259.6 px"), "{out:?}");
}

#[test]
fn a_unit_for_a_file_whose_unit_is_known_is_said_not_to_be_used() {
    let file = format!("{FILES}/middlebury_spaces_and_pasted_matrix.txt");
    for arguments in [
        format!("calculate --from {file} --file-unit 1mm --disparity 50"),
        format!("import {file} --file-unit 1mm"),
    ] {
        let (_, err) = text(&arguments);
        assert!(err.join(" ").contains("--file-unit is not used"), "{err:?}");
    }
}

#[test]
fn where_no_other_file_has_doffs_none_is_asked_for() {
    let (_, err) = text(&format!("calculate --from {FILES}/kalibr_three_cameras.yaml --disparity 50"));
    let err = err.join(" ");
    assert!(err.contains("raw images") && !err.contains("other camera as well"), "{err}");
}

#[test]
fn the_principal_point_of_a_pixel_is_that_of_the_file() {
    let file = format!("{FILES}/middlebury_2021_crlf_no_last_newline.txt");
    let (out, err) = text(&format!("calculate --from {file} --disparity 60 --u 100 --v 100"));
    assert!(!err.join(" ").contains("--cx"), "{err:?}");
    let (typed, _) = text(&format!("calculate --from {file} --disparity 60 --u 100 --v 100 --cx 100 --cy 100"));
    assert_ne!(out, typed);
}

#[test]
fn how_uncertain_a_focal_length_is_comes_with_it_where_the_file_says_so() {
    let file = "crates/depth-files/tests/data/bouguet/Calib_Results.m";
    let found = answer(file);
    let sigma = found["cameras"][0]["sigma_px"][0].as_f64().unwrap();
    assert!(sigma > 0.0);
    let of_file = json(&format!("--from {file} --w-img 100 --w-real 1m"));
    let fx = &found["cameras"][0]["fx"];
    let typed = json(&format!("--fx {fx} --sigma-fx {sigma} --w-img 100 --w-real 1m"));
    near(&of_file["monocular"]["sigma_m"], typed["monocular"]["sigma_m"].as_f64().unwrap());
    let file = format!("{FILES}/middlebury_2021_crlf_no_last_newline.txt");
    assert!(answer(&file)["cameras"][0]["sigma_px"].is_null());
}

#[test]
fn an_archive_has_no_lines() {
    let found = answer("crates/depth-files/tests/data/numpy/mono.npz");
    assert!(found["cameras"][0]["line"].is_null() && found["cameras"][0]["origin"]["line"].is_null());
}
