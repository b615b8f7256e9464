//! What contradicts something else, or looks like it, is a warning; what is only uncertain is none.

use super::{json, near, run_words, text};
use serde_json::Value;

fn warnings(arguments: &str) -> Vec<String> {
    let answer = json(arguments);
    let warnings = answer["warnings"].as_array().unwrap().iter();
    warnings.map(|warning| warning["message"].as_str().unwrap().to_owned()).collect()
}

/// A taped range and a distance with σ: on the axis the focal length is in the distance only, 10 % of it; and a range without σ is
/// judged by the ratio.
#[test]
fn a_range_contradicts_only_what_it_is_sure_to() {
    let rig = "--fx 700 --baseline 100 --disparity 50 --cx 640 --u 640 --cy 360 --v 360";
    for (more, is_warned) in [
        ("--sigma-fx 10% --range 1.45 --sigma-range 1cm", false),
        ("--sigma-fx 0.5% --range 1.45 --sigma-range 1cm", true),
        ("--sigma-baseline 0.1 --range 1.41", false),
        ("--sigma-baseline 0.1 --range 1.41 --sigma-range 1mm", true),
        ("--sigma-fx 1 --range 2", false),
        ("--sigma-fx 1 --range 2 --sigma-range 1cm", true),
        ("--range 2.2", true),
    ] {
        let said = warnings(&format!("{rig} {more}"));
        let warned = said.iter().any(|warning| warning.contains("one of them is wrong"));
        assert_eq!(warned, is_warned, "{more}: {said:?}");
    }
}

/// A given distance has no σ of the focal length in it; what a range gives has 1 − Z²/R² of it.
#[test]
fn a_range_is_compared_with_the_distance_that_was_given() {
    let rig = [
        "calculate",
        "--fx",
        "700",
        "--baseline",
        "100",
        "--solve-for",
        "disparity",
        "--json",
    ];
    let pixel = ["--cx", "640", "--cy", "360", "--u", "1000", "--v", "360"];
    for (distance, range, is_warned) in [
        ("2 ± 0.001", "2.5 ± 0.001", true),
        ("2 ± 0.8", "3.6 ± 0.1", false),
        ("2", "3.6", true),
        ("2", "2.5", false),
    ] {
        let arguments = [&rig[..], &pixel[..], &["--distance", distance, "--range", range]].concat();
        let answer: Value = serde_json::from_slice(&run_words(&arguments).stdout).unwrap();
        let warned = answer["warnings"].to_string().contains("times the distance that was given");
        assert_eq!(warned, is_warned, "{distance} and {range}: {answer}");
        // What was given is an input and no result.
        assert!(
            answer["stereo"].is_null() && answer["inputs"]["distance"]["value"] == 2.0,
            "{answer}"
        );
    }
}

/// What was given is compared with what the other method computes.
#[test]
fn a_given_distance_that_contradicts_the_other_method_is_a_warning() {
    let given = json(
        "--fx 700 --w-img 150 --sigma-w-img 1 --solve-for w-real --distance 2 --sigma-distance 1cm --baseline 100 --disparity 50 --sigma-disparity 0.5",
    );
    // |ln(1.4/2)| / √(0.005² + 0.01²)
    near(&given["agreement"]["z"], 31.9, 0.1);
    assert_eq!(given["agreement"]["verdict"], "disagree");
    assert!(
        given["warnings"]
            .as_array()
            .unwrap()
            .iter()
            .any(|one| one["message"].as_str().unwrap().contains("disagree"))
    );
    let (lines, _) = text("calculate --fx 700 --baseline 100 --solve-for disparity --distance 14 --w-img 150 --w-real 0.3");
    let said = lines.concat();
    assert!(said.contains("The given distance is 10.0 times monocular"), "{said}");
    assert!(!said.contains("tereo"), "{said}");
    let (lines, _) = text("calculate --fx 700 --w-img 150 --solve-for w-real --distance 2 --u 1000 --cx 640 --v 360 --cy 360");
    assert!(lines.concat().contains("from the distance that was given"), "{lines:?}");
}

/// An angle with decimals that nobody measures in degrees.
#[test]
fn an_angle_that_looks_like_radians_is_asked_about() {
    let tilt = |angle: &str| warnings(&format!("--fx 700 --w-img 150 --w-real 0.31 --tilt {angle}"));
    assert!(tilt("0.5236")[0].contains("in radians"), "{:?}", tilt("0.5236"));
    // Nor where it is not used.
    let unused = warnings("--fx 700 --baseline 100 --disparity 50 --tilt 0.524");
    assert!(unused.len() == 1 && unused[0].contains("Not used"), "{unused:?}");
    for angle in ["0.5236rad", "30", "0.5", "1.25", "45.125", "1.5e0"] {
        assert_eq!(tilt(angle), Vec::<String>::new(), "{angle}");
    }
}
