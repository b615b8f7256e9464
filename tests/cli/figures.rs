//! Figures that were worked out independently, each through the program.

use super::{json, near, refused, refused_words, run_words, text};
use serde_json::Value;

#[test]
fn distances_that_disagree_are_not_combined() {
    let answer = json("--fx 700 --baseline 100mm --disparity 50 --sigma-baseline 0.5mm --w-img 150 --w-real 3 --sigma-w-img 1");
    assert!(answer["combined"].is_null());
    assert_eq!(answer["agreement"]["verdict"], "disagree");
    // ln 10/√(0.005² + (1/150)²)
    near(&answer["agreement"]["z"], 276.31, 0.01);
    let suspects = answer["agreement"]["suspects"].as_array().unwrap();
    assert!(suspects[0].as_str().unwrap().contains("the baseline really in millimeters"));
    let warnings = answer["warnings"].as_array().unwrap();
    assert!(
        warnings
            .iter()
            .any(|warning| warning["message"].as_str().unwrap().contains("disagree"))
    );
}

/// 1.4 m to 1 % and 1.4 m·e^(0.0141421·z) to 1 %: z apart; combined to 0.7071 %, times z where that is above 1.
#[test]
fn a_combination_of_what_differs_is_wider() {
    for (real_width, z, widened) in [("0.3", 0.0, 1.0), ("0.308613", 2.0029, 2.0029), ("0.3122", 2.818, 2.818)] {
        let answer = json(&format!(
            "--fx 700 --baseline 100 --disparity 50 --sigma-disparity 1% --w-img 150 --sigma-w-img 1% --w-real {real_width}"
        ));
        near(&answer["agreement"]["z"], z, 2e-3);
        let combined = &answer["combined"];
        let relative = combined["sigma_m"].as_f64().unwrap() / combined["distance_m"].as_f64().unwrap();
        assert!((relative - 0.007_071 * widened).abs() < 2e-5, "{real_width}: {relative}");
    }
    let beyond = json("--fx 700 --baseline 100 --disparity 50 --sigma-disparity 1% --w-img 150 --sigma-w-img 1% --w-real 0.3131");
    assert!(beyond["combined"].is_null());
}

#[test]
fn without_a_sigma_of_both_a_ratio_beyond_one_and_a_half_is_a_warning() {
    let both = "--fx 700 --baseline 100 --disparity 50 --w-img 150";
    for (arguments, is_warned) in [
        ("--w-real 3", true),
        ("--w-real 3 --sigma-w-img 1", true),
        ("--w-real 3 --sigma-fx 2", true),
        ("--w-real 0.19", true),
        ("--w-real 0.4", false),
        ("--w-real 0.4 --sigma-w-img 1", false),
    ] {
        let answer = json(&format!("{both} {arguments}"));
        assert!(answer["agreement"].is_null(), "{arguments}");
        let contradicts = |warning: &Value| warning["field"].is_null() && warning["message"].as_str().unwrap().contains("times");
        let warnings = answer["warnings"].as_array().unwrap();
        assert_eq!(warnings.iter().any(contradicts), is_warned, "{arguments}: {warnings:?}");
        assert!(!is_warned || answer["combined"].is_null(), "{arguments}");
    }
}

#[test]
fn every_input_can_be_solved_for() {
    let stereo = "--fx 700 --baseline 100 --disparity 50 --doffs 0";
    let monocular = "--fx 950 --w-img 200 --w-real 0.9";
    for (all, option, distance, expected, unit) in [
        (stereo, "fx", "1.4", 700.0, "px"),
        (stereo, "baseline", "1.4", 0.1, "m"),
        (stereo, "disparity", "1.4", 50.0, "px"),
        (stereo, "doffs", "1.4", 0.0, "px"),
        (monocular, "fx", "4.275", 950.0, "px"),
        (monocular, "w-img", "4.275", 200.0, "px"),
        (monocular, "w-real", "4.275", 0.9, "m"),
    ] {
        let others: Vec<&str> = all
            .split("--")
            .filter(|given| !given.is_empty() && !given.starts_with(&format!("{option} ")))
            .collect();
        let arguments = format!("--{} --solve-for {option} --distance {distance}", others.join("--").trim());
        let answer = json(&arguments);
        assert_eq!(answer["solved"]["field"], option, "{arguments}");
        assert_eq!(answer["solved"]["unit"], unit, "{arguments}");
        near(&answer["solved"]["value"], expected, 1e-9);
        assert!(answer["solved"]["sigma"].is_null());
    }
    // 1 % of the distance is 1 % of the disparity.
    let uncertain = json("--fx 700 --baseline 100 --solve-for disparity --distance 1.4 --sigma-distance 1%");
    near(&uncertain["solved"]["sigma"], 0.5, 1e-12);
    let (lines, _) = text("calculate --fx 700 --baseline 100 --solve-for disparity --distance 2");
    assert_eq!(lines, ["35.00 px (the disparity)"]);
    let reason = refused("calculate --baseline 100 --disparity 50 --w-img 150 --w-real 0.3 --solve-for fx --distance 2");
    assert!(reason.contains("Both methods have an fx"), "{reason}");
    assert!(refused("calculate --fx 700 --baseline 100 --solve-for disparity").contains("--distance"));
    assert!(refused("calculate --fx 700 --solve-for disparity --distance 2").contains("baseline"));
    assert!(json("--fx 700 --baseline 100 --disparity 50")["solved"].is_null());
}

/// What is solved for repeats its own equation; the σ of everything else stays.
#[test]
fn solving_for_an_input_keeps_the_sigmas_of_the_rest() {
    let pixel = "--cx 640 --cy 360 --u 1000 --v 500";
    let point = json(&format!(
        "--fx 700 --baseline 100 --sigma-fx 70 --solve-for disparity --distance 2 --sigma-distance 0.1 {pixel}"
    ));
    near(&point["point"]["sigma_z_m"], 0.1, 1e-12);
    // X = (u − cx)·Z/f: 5 % of the distance and 10 % of the focal length.
    near(&point["point"]["sigma_x_m"], 360.0 / 700.0 * 2.0 * 0.0125_f64.sqrt(), 1e-9);
    let other = json("--fx 700 --baseline 100 --sigma-fx 7 --solve-for disparity --distance 2 --w-img 150 --w-real 0.4 --sigma-w-img 2");
    near(&other["monocular"]["sigma_m"], 0.031, 5e-4);
    assert!(other["stereo"]["sigma_m"].is_null() && other["combined"].is_null() && other["agreement"].is_null());
}

#[test]
fn a_sigma_of_doffs_is_blamed_only_for_itself() {
    for sigma in ["abc", "1 mm", "-1", "1e160", "10%"] {
        let reason = refused_words(&[
            "calculate",
            "--fx",
            "700",
            "--baseline",
            "100",
            "--disparity",
            "50",
            "--sigma-doffs",
            sigma,
        ]);
        assert!(reason.starts_with("depth-calculator: --sigma-doffs: "), "{sigma}: {reason}");
    }
    for zero in ["--doffs 0 --sigma-doffs 10%", "--doffs 60 --disparity 0 --sigma-disparity 5%"] {
        let disparity = if zero.contains("--disparity") { "" } else { "--disparity 50" };
        let reason = refused(&format!("calculate --fx 700 --baseline 100 {disparity} {zero}"));
        assert!(reason.contains("of zero is nothing"), "{reason}");
    }
}

#[test]
fn a_distance_without_a_sigma_of_its_own_is_not_combined() {
    let answer = json("--fx 700 --baseline 100 --disparity 50 --w-img 150 --w-real 0.32 --sigma-w-img 1");
    assert!(answer["combined"].is_null() && answer["agreement"].is_null());
}

#[test]
fn a_range_that_contradicts_the_distance_is_a_warning() {
    let pixel = "--cx 640 --cy 360 --u 1000 --v 500";
    let of = |range: &str| json(&format!("--fx 700 --baseline 100 --disparity 50 --range {range} {pixel}"));
    assert_eq!(of("16")["warnings"][0]["field"], "range");
    assert_eq!(of("1.6")["warnings"].as_array().unwrap().len(), 0);
    for (arguments, option) in [
        ("--range 0", "range"),
        ("--range -1", "range"),
        ("--fy 0", "fy"),
        ("--fy -700", "fy"),
    ] {
        let reason = refused(&format!("calculate --fx 700 --baseline 100 --disparity 50 {pixel} {arguments}"));
        assert!(reason.starts_with(&format!("depth-calculator: --{option}: ")), "{reason}");
    }
}

#[test]
fn doffs_from_a_disparity_of_any_sign() {
    for (disparity, doffs) in [("0", 104.282), ("-10", 114.282)] {
        let answer = json(&format!(
            "--fx 443.2 --baseline 4in --disparity {disparity} --distance 17in --solve-for doffs"
        ));
        near(&answer["solved"]["value"], doffs, 1e-3);
    }
    let mark = json("--fx 443.2 --baseline 4in --disparity -16 --distance 17in --solve-for doffs");
    assert_eq!(mark["warnings"][0]["field"], "disparity");
}

#[test]
fn the_point_is_where_the_best_distance_puts_it() {
    let answer = json(
        "--fx 700 --baseline 100 --disparity 50 --sigma-disparity 2 --w-img 150 --sigma-w-img 2 --w-real 0.31 --cx 640 --cy 360 --u 1000 --v 360",
    );
    let point = &answer["point"];
    assert_eq!(point["from"], "combined");
    for (name, expected) in [("x_m", 0.7416), ("y_m", 0.0), ("z_m", 1.4419), ("range_m", 1.6214)] {
        near(&point[name], expected, 5e-5);
    }
    for (name, expected) in [
        ("sigma_x_m", 0.00938),
        ("sigma_y_m", 0.0),
        ("sigma_z_m", 0.01824),
        ("sigma_range_m", 0.02051),
    ] {
        near(&point[name], expected, 5e-6);
    }
    let pixel = "--cx 640 --cy 360 --u 1000 --v 360";
    for (arguments, from) in [
        ("--fx 700 --baseline 100 --disparity 50", "stereo"),
        ("--fx 700 --w-img 150 --w-real 0.3", "monocular"),
        ("--fx 700 --range 1.62", "range"),
    ] {
        let answer = json(&format!("{arguments} {pixel}"));
        assert_eq!(answer["point"]["from"], from);
        assert!(answer["point"]["sigma_z_m"].is_null());
    }
    assert!(json("--fx 700 --baseline 100 --disparity 50")["point"].is_null());
    // A taped 1.5743 m to the mug is a depth of 1.4 m: √(1 + (360/700)²) times less.
    near(&json(&format!("--fx 700 --range 1.574294 {pixel}"))["point"]["z_m"], 1.4, 1e-6);
    // Rows count with fy.
    let tall = json("--fx 700 --fy 350 --baseline 100 --disparity 50 --cx 640 --cy 360 --u 640 --v 710");
    near(&tall["point"]["y_m"], 1.4, 1e-12);
}

#[test]
fn a_tilt_corrects_the_monocular_distance() {
    near(
        &json("--fx 950 --w-img 200 --w-real 0.9 --tilt 60")["monocular"]["distance_m"],
        2.1375,
        1e-9,
    );
    near(
        &json("--fx 950 --w-img 200 --w-real 0.9 --tilt -60°")["monocular"]["distance_m"],
        2.1375,
        1e-9,
    );
    assert!(refused("calculate --fx 950 --w-img 200 --w-real 0.9 --tilt 90").contains("--tilt"));
    assert!(refused("calculate --fx 950 --w-img 200 --w-real 0.9 --tilt 20px").contains("--tilt"));
    let unused = json("--fx 700 --baseline 100 --disparity 50 --tilt 20");
    assert_eq!(unused["warnings"][0]["field"], "tilt");
}

#[test]
fn no_match_is_refused_and_offers_no_number() {
    for mark in ["-16", "-1", "-272", "-17"] {
        let reason = refused(&format!("calculate --fx 700 --baseline 100 --disparity {mark}"));
        assert!(reason.contains("without a match") && !reason.contains("swapped"), "{reason}");
        let used = json(&format!("--fx 700 --baseline 100 --disparity {mark} --doffs 300"));
        assert!(used["stereo"]["distance_m"].as_f64().unwrap() > 0.0);
        assert_eq!(used["warnings"][0]["field"], "disparity");
    }
}

#[test]
fn the_largest_relative_sigma_is_blamed() {
    for arguments in [
        "--fx 700 --baseline 1e305m --disparity 50 --sigma-disparity 1e5",
        "--fx 700 --sigma-fx 1 --baseline 1e305m --disparity 50 --sigma-disparity 1e5",
    ] {
        let reason = refused(&format!("calculate {arguments}"));
        assert!(reason.starts_with("depth-calculator: --sigma-disparity: "), "{reason}");
    }
}

#[test]
fn negative_baselines_board_squares_and_multiples_of_the_width() {
    assert!(refused("calculate --fx 700 --baseline -0.07 --disparity 50").contains("OpenCV"));
    let output = run_words(&[
        "calculate",
        "--fx",
        "670.35",
        "--baseline",
        "1.695 squares of 23.6 mm",
        "--disparity",
        "40",
        "--json",
    ]);
    let answer: Value = serde_json::from_slice(&output.stdout).unwrap();
    near(&answer["stereo"]["distance_m"], 0.670, 5e-4);
    let warned = |arguments: &str| json(arguments)["warnings"][0]["message"].as_str().unwrap().to_owned();
    assert!(warned("--fx 670.35 --baseline 1.695 --disparity 40").contains("squares of the calibration board"));
    let multiple = warned("--fx 0.97428 --baseline 100 --disparity 40");
    assert!(multiple.contains("54.3°") && multiple.contains("91.5°"), "{multiple}");
    assert_eq!(
        json("--fx 22154 --baseline 100 --disparity 40")["warnings"]
            .as_array()
            .unwrap()
            .len(),
        0
    );
    assert_eq!(
        json("--fx 100000 --baseline 100 --disparity 1000")["warnings"]
            .as_array()
            .unwrap()
            .len(),
        0
    );
}

#[test]
fn a_q_matrix_is_read_from_a_file_and_from_standard_input() {
    use std::io::Write as _;
    let folder = std::path::Path::new(env!("CARGO_TARGET_TMPDIR"));
    let file = folder.join("q.yml");
    std::fs::write(
        &file,
        "%YAML:1.0\n---\nP1: !!opencv-matrix\n   rows: 3\n   cols: 4\n   data: [ 1., 2. ]\nQ: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: d\n   data: [ 1., 0., 0., -610., 0., 1., 0., -350., 0., 0., 0., 700., 0., 0., 0.01, 0.4 ]\n",
    )
    .unwrap();
    let name = file.to_str().unwrap();
    let answer =
        |words: &[&str]| -> Value { serde_json::from_slice(&run_words(&[&["q", name, "--json"], words].concat()).stdout).unwrap() };
    let without = answer(&[]);
    for (field, expected) in [("fx", 700.0), ("baseline", 100.0), ("doffs_px", 40.0), ("cx", 610.0), ("cy", 350.0)] {
        near(&without[field], expected, 1e-9);
    }
    assert!(without["baseline_m"].is_null());
    near(&answer(&["--file-unit", "1mm"])["baseline_m"], 0.1, 1e-12);
    let mut child = super::program(&["q", "-"])
        .stdin(std::process::Stdio::piped())
        .stdout(std::process::Stdio::piped())
        .spawn()
        .unwrap();
    child
        .stdin
        .take()
        .unwrap()
        .write_all(b"1 0 0 -610 0 1 0 -350 0 0 0 700 0 0 0.01 0.4")
        .unwrap();
    let text = String::from_utf8(child.wait_with_output().unwrap().stdout).unwrap();
    assert!(text.starts_with("fx 700 px\nbaseline 100 "), "{text}");
    assert!(refused("q /no/such/file").contains("cannot be read"));
    std::fs::write(&file, "K1: [1, 2, 3]").unwrap();
    assert!(refused(&format!("q {name}")).contains("There is no Q in it"));
    std::fs::write(&file, [0xff, 0xfe, 0x00]).unwrap();
    assert!(refused(&format!("q {name}")).contains("not text"));
}

/// The examples that `--help` shows are what they say.
#[test]
fn the_examples_of_the_help_are_true() {
    let (lines, _) = text("calculate --fx 700 --baseline 100 --distance 2 --solve-for disparity");
    assert_eq!(lines[0], "35.00 px (the disparity)");
    near(
        &json("--fx 700 --baseline 100 --disparity 50 --cx 640 --cy 360 --u 1000 --v 360")["point"]["range_m"],
        1.574,
        5e-4,
    );
    for command in ["calculate", "ground", "q"] {
        let help = String::from_utf8(run_words(&[command, "--help"]).stdout).unwrap();
        assert!(help.contains("Example"), "{command}");
    }
}

#[test]
fn squares_keep_the_unit_of_their_size() {
    let output = run_words(&[
        "calculate",
        "--fx",
        "700",
        "--baseline",
        "1.695 squares of 1 in",
        "--disparity",
        "40",
    ]);
    let said = String::from_utf8(output.stdout).unwrap();
    assert!(said.contains("1.695 squares of 1 in"), "{said}");
}
