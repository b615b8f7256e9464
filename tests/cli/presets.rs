//! `presets`, and `calculate --preset`.

use crate::{json, refusal};
use serde_json::Value;

fn presets(arguments: &str) -> Value {
    crate::answer(&format!("presets {arguments}"))
}

#[test]
fn every_camera_has_its_basis_and_its_source() {
    let all = presets("");
    let all = all.as_array().unwrap();
    assert!(all.len() >= 20, "{}", all.len());
    for preset in all {
        for key in ["name", "label", "basis", "source"] {
            assert!(preset[key].as_str().is_some_and(|text| !text.is_empty()), "{key}: {preset}");
        }
        assert!(preset["fx_px"].as_f64().unwrap() > 100.0, "{preset}");
        assert_eq!(
            presets(preset["name"].as_str().unwrap()),
            *preset,
            "the list has the first mode of each"
        );
    }
    let without: Vec<&Value> = all.iter().filter(|preset| preset["baseline_m"].is_null()).collect();
    assert_eq!(without.len(), 1);
    assert_eq!((&without[0]["name"], &without[0]["fx_px"]), (&"nuscenes".into(), &1266.417.into()));
}

#[test]
fn figures_of_the_table() {
    // The reference's section 5: of one unit, of a vendor, computed, of a data set.
    for (arguments, baseline, fx, width) in [
        ("realsense-d405", 0.018, 636.386, 1280),
        ("realsense-d435i --width 640", 0.049_864, 378.806, 640),
        ("zed --width 672", 0.12, 350.0, 672),
        ("oak-d", 0.075, 882.5, 1280),
        ("oak-d-pro-w", 0.075, 566.0, 1280),
        ("kitti", 0.537_166, 718.856, 1241),
        ("cityscapes", 0.22, 2262.0, 2048),
    ] {
        let preset = presets(arguments);
        assert_eq!(preset["baseline_m"], baseline, "{arguments}");
        assert_eq!((&preset["fx_px"], &preset["width"]), (&fx.into(), &width.into()), "{arguments}");
    }
    assert_eq!(presets("realsense-d435i")["zero_m"], 0.0042);
    assert_eq!(presets("realsense-d415")["baseline_m"], 0.0548);
    assert_eq!(presets("middlebury-2014-motorcycle")["doffs_px"], 131.111);
    assert_eq!(presets("middlebury-2005")["baseline_m"], 0.16);
    // Its scenes are cut, each in its own way, and two cameras that are no pair have none.
    assert!(presets("middlebury-2005")["doffs_px"].is_null() && presets("nuscenes")["doffs_px"].is_null());
    assert_eq!(presets("zed")["doffs_px"], 0.0);
}

#[test]
fn a_preset_fills_in_what_is_not_typed() {
    let answer = json("--preset realsense-d435i --width 640 --disparity 20");
    let distance = answer["stereo"]["distance_m"].as_f64().unwrap();
    // 378.806 px · 0.049864 m / 20 px.
    assert!((distance - 0.944_439_119_2).abs() < 1e-9, "{distance}");
    let zeroed = json("--preset realsense-d435i --width 640 --disparity 20 --zero preset");
    assert!(
        (zeroed["stereo"]["distance_m"].as_f64().unwrap() - (distance - 0.0042)).abs() < 1e-12,
        "{zeroed}"
    );
    let own = json("--preset kitti --fx 700 --baseline 100mm --disparity 50");
    assert!(
        (own["stereo"]["distance_m"].as_f64().unwrap() - 1.4).abs() < 1e-12,
        "what is typed wins"
    );
    let motorcycle = json("--preset middlebury-2014-motorcycle --disparity 100");
    let expected = 3997.684 * 0.193_001 / 231.111;
    assert!((motorcycle["stereo"]["distance_m"].as_f64().unwrap() - expected).abs() < 1e-9);
    // doffs belongs to the images of the preset.
    let foreign = json("--preset middlebury-2014-motorcycle --fx 700 --baseline 100mm --disparity 20");
    assert!((foreign["stereo"]["distance_m"].as_f64().unwrap() - 3.5).abs() < 1e-12);
    let cut = json("--preset middlebury-2006 --disparity 20");
    assert!(cut["warnings"].to_string().contains("dmin.txt"), "{cut}");
    let said = answer["warnings"][0]["message"].as_str().unwrap();
    assert!(said.contains("one unit") && said.contains("librealsense"), "{said}");
}

#[test]
fn what_is_not_known_of_a_camera_is_said() {
    for (arguments, words) in [
        ("presets realsense", "realsense-d435i"),
        ("presets toaster", "lists them"),
        ("presets zed --width 640", "1280 x 720"),
        ("presets middlebury-2006 --width 640", "does not say"),
        ("calculate --preset toaster --disparity 3", "lists them"),
        ("calculate --preset nuscenes --disparity 20", "no two of its cameras"),
        ("calculate --preset oak-d --disparity 20 --zero preset", "No zero point of OAK-D"),
        ("calculate --fx 700 --baseline 100 --disparity 50 --zero preset", "--preset"),
    ] {
        let said = refusal(arguments);
        assert!(said.contains(words) && said.lines().count() == 1, "{arguments}: {said}");
    }
}
