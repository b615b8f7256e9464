//! The golden numbers, as a program reads them.

use super::{MUG, SIGMAS, TWIN, json, near};

#[test]
fn the_mug_and_the_doorway() {
    let mug = json(MUG);
    assert_eq!(mug["stereo"]["distance_m"], 1.4);
    assert!(mug["stereo"]["sigma_m"].is_null() && mug["stereo"]["near_m"].is_null() && mug["stereo"]["far_m"].is_null());
    assert!(mug["monocular"].is_null() && mug["combined"].is_null() && mug["estimated_width_px"].is_null());
    assert_eq!(mug["warnings"].as_array().unwrap().len(), 0);
    assert_eq!(json("--fx 950 --w-img 200 --w-real 0.9m")["monocular"]["distance_m"], 4.275);
}

/// The golden figures: (1.400 ± 0.016) m; (1.400 ± 0.050) m (1.3498 … 1.4507); combined ± 0.01547 m.
#[test]
fn uncertainty_of_both_methods_and_of_their_combination() {
    let both = json(&format!("{MUG} {SIGMAS} {TWIN}"));
    near(&both["stereo"]["sigma_m"], 0.0162, 5e-5);
    near(&both["stereo"]["near_m"], 1.3840, 5e-5);
    near(&both["stereo"]["far_m"], 1.4163, 5e-5);
    near(&both["monocular"]["sigma_m"], 0.050, 5e-4);
    near(&both["monocular"]["near_m"], 1.3498, 5e-5);
    near(&both["monocular"]["far_m"], 1.4507, 5e-5);
    near(&both["combined"]["distance_m"], 1.4, 1e-12);
    near(&both["combined"]["sigma_m"], 0.01547, 5e-6);
    near(&both["estimated_width_px"], 150.0, 1e-9);
    near(&both["estimated_width_m"], 0.3, 1e-9);
}

#[test]
fn bare_lengths_percentages_and_other_units() {
    assert_eq!(json("--fx 700 --baseline 100 --disparity 50")["stereo"]["distance_m"], 1.4);
    assert_eq!(json("--fx 950 --w-img 200 --w-real 0.9")["monocular"]["distance_m"], 4.275);
    near(
        &json("--fx 700 --baseline 4in --disparity 50")["stereo"]["distance_m"],
        1.4224,
        1e-12,
    );
    near(&json(&format!("{MUG} --sigma-disparity 1%"))["stereo"]["sigma_m"], 0.014, 1e-12);
    near(&json(&format!("{MUG} --sigma-baseline 1mm"))["stereo"]["sigma_m"], 0.014, 1e-12);
    near(&json(&format!("{MUG} --sigma-baseline 1"))["stereo"]["sigma_m"], 0.014, 1e-12);
}

/// OpenCV's stereoRectify with cx 610 and 650: Z = 777.78 mm at d = 50 px.
#[test]
fn doffs_is_added_to_the_disparity_and_may_be_negative() {
    near(
        &json("--fx 700 --baseline 100 --disparity 50 --doffs 40")["stereo"]["distance_m"],
        0.777_777_8,
        1e-6,
    );
    near(
        &json("--fx 700 --baseline 100 --disparity 90 --doffs=-40")["stereo"]["distance_m"],
        1.4,
        1e-12,
    );
    // Only d + doffs has to be positive.
    near(
        &json("--fx 700 --baseline 100 --disparity=-10 --doffs 60")["stereo"]["distance_m"],
        1.4,
        1e-12,
    );
}

#[test]
fn an_unbounded_far_end_is_null() {
    let far = json("--fx 700 --baseline 100 --disparity 1 --sigma-disparity 1");
    assert!(far["stereo"]["far_m"].is_null());
    near(&far["stereo"]["near_m"], 35.0, 1e-9);
}

#[test]
fn half_of_the_other_method_is_a_warning() {
    let half = json(&format!("{MUG} --w-img 150"));
    assert_eq!(half["warnings"][0]["field"], "w-real");
    assert!(half["warnings"][0]["message"].as_str().unwrap().contains("missing"));
    let beside = json("--fx 950 --w-img 200 --w-real 0.9 --baseline 100 --disparity 0");
    assert_eq!(beside["warnings"][0]["field"], "disparity");
    let unusual = json("--fx 700 --baseline 0.1 --disparity 50");
    assert_eq!(unusual["warnings"][0]["field"], "baseline");
}

#[test]
fn an_option_that_cannot_be_read_is_warned_of_once() {
    let answer = json(&format!("{MUG} --w-img 100 --sigma-w-real abc"));
    let named = |warning: &&serde_json::Value| warning["field"] == "sigma-w-real";
    assert_eq!(answer["warnings"].as_array().unwrap().iter().filter(named).count(), 1);
}
