//! `camera`: data sheets and simulators to a focal length, and back.

use crate::run;
use serde_json::Value;

fn camera(arguments: &str) -> Value {
    crate::answer(&format!("camera {arguments}"))
}

fn is(value: &Value, key: &str, expected: f64, tolerance: f64) {
    let found = value[key].as_f64().unwrap_or(f64::NAN);
    assert!((found - expected).abs() < tolerance, "{key} is {found}, not {expected}");
}

fn warnings(value: &Value) -> String {
    value["warnings"]
        .as_array()
        .unwrap()
        .iter()
        .map(|one| one["message"].as_str().unwrap())
        .collect()
}

/// Figures of vendors, standards and simulators.
#[test]
fn every_fact_is_a_focal_length() {
    for (facts, fx, tolerance) in [
        // Luxonis' table: HFOV 71.9°.
        ("--width 1280 --height 800 --hfov 71.9", 882.5, 0.1),
        // Gazebo counts in radians.
        ("--width 320 --height 240 --hfov 1.047rad", 277.19, 0.005),
        ("--width 1600 --height 1200 --hfov 1.7012rad", 701.93, 0.005),
        // AirSim's 90° are horizontal.
        ("--width 256 --height 144 --hfov 90deg", 128.0, 1e-9),
        // CIPA's equivalent is of the diagonal.
        ("--width 4032 --height 3024 --f35 26mm", 3029.0, 0.6),
        ("--width 1280 --height 720 --lens 4mm --pixel-pitch 4um", 1000.0, 1e-9),
        ("--width 1280 --height 720 --lens 4 --sensor-width 6.4", 800.0, 1e-9),
        // 50 mm, focused at 0.55 m, are 55 mm.
        (
            "--width 1600 --height 1200 --lens 50mm --focused-at 0.55m --pixel-pitch 5um",
            11_000.0,
            1e-6,
        ),
        ("--width 1280 --height 720 --p00 1.09375", 700.0, 1e-9),
        // 3.63 mm of diagonal and 120°, with pixels of 1 µm.
        ("--width 2904 --height 2178 --dfov 120 --model equisolid", 1815.0, 0.6),
        ("--width 2904 --height 2178 --dfov 120 --model equidistant", 1733.0, 0.6),
        ("--width 2904 --height 2178 --dfov 120", 1048.0, 0.6),
    ] {
        is(&camera(facts), "fx_px", fx, tolerance);
    }
    // 95° at 1920 × 1080 are 63.09° of the height.
    is(&camera("--width 1920 --height 1080 --hfov 95"), "vfov_deg", 63.09, 0.005);
}

#[test]
fn every_other_fact_follows_and_leads_back() {
    let size = "--width 1600 --height 1200";
    let all = camera(&format!("{size} --fx 1000 --pixel-pitch 3um"));
    is(&all, "lens_mm", 3.0, 1e-12);
    for (option, key) in [
        ("hfov", "hfov_deg"),
        ("vfov", "vfov_deg"),
        ("dfov", "dfov_deg"),
        ("f35", "f35_diagonal_mm"),
    ] {
        is(&camera(&format!("{size} --{option} {}", all[key])), "fx_px", 1000.0, 1e-9);
    }
    is(
        &camera(&format!("{size} --lens {}mm --pixel-pitch 3um", all["lens_mm"])),
        "fx_px",
        1000.0,
        1e-9,
    );
    for model in ["equidistant", "equisolid", "stereographic"] {
        let fisheye = camera(&format!("{size} --fx 700 --model {model}"));
        is(
            &camera(&format!("{size} --dfov {} --model {model}", fisheye["dfov_deg"])),
            "fx_px",
            700.0,
            1e-9,
        );
        assert!(fisheye["f35_diagonal_mm"].is_null());
    }
    let own = camera("--width 1280 --height 720 --fx 700 --fy 710");
    is(&own, "fy_px", 710.0, 1e-12);
    assert_eq!(warnings(&own), "");
}

#[test]
fn facts_that_exclude_one_another_are_named_and_the_first_is_followed() {
    let size = "--width 1280 --height 800";
    let value = camera(&format!("{size} --hfov 71.86 --dfov 83.76 --vfov 56.74"));
    is(&value, "fx_px", 883.2, 0.06);
    for words in ["883.1", "841.7", "740.7", "follows --hfov", "were cut"] {
        assert!(warnings(&value).contains(words), "{words}: {}", warnings(&value));
    }
    is(&camera(&format!("{size} --dfov 83.76 --hfov 71.86")), "fx_px", 841.7, 0.06);
    assert!(warnings(&camera(&format!("{size} --fy 700 --fx 700 --vfov 30"))).contains("fy follows --fy"));
    // Two views that were rounded to a degree agree.
    assert_eq!(warnings(&camera("--width 1280 --height 720 --hfov 69 --vfov 42")), "");
}

#[test]
fn rows_that_were_cut_change_no_focal_length() {
    let value = camera("--width 1600 --height 800 --lens 8mm --sensor-width 9.6mm --sensor-height 7.2mm");
    is(&value, "fx_px", 1333.33, 0.01);
    is(&value, "fy_px", 1333.33, 0.01);
    is(&value, "hfov_deg", 61.93, 0.005);
    is(&value, "vfov_deg", 33.40, 0.005);
    assert!(
        warnings(&value).contains("1200 rows") && warnings(&value).contains("800"),
        "{}",
        warnings(&value)
    );
    let columns = camera("--width 800 --height 1200 --lens 8mm --sensor-width 9.6mm --sensor-height 7.2mm");
    assert!(warnings(&columns).contains("1600 columns"), "{}", warnings(&columns));
}

#[test]
fn a_wide_view_asks_for_a_fisheye_and_water_asks_where_it_was_calibrated() {
    let wide = warnings(&camera("--width 1280 --height 800 --dfov 120"));
    for words in ["equidistant 720.7", "equisolid 754.7", "stereographic", "orthographic"] {
        assert!(wide.contains(words), "{words}: {wide}");
    }
    let water = camera("--width 1280 --height 720 --fx 600 --water");
    is(&water, "fx_px", 799.8, 1e-9);
    assert!(warnings(&water).contains("calibrated in the water?"));
}

#[test]
fn nonsense_gets_a_sentence() {
    for (arguments, words) in [
        ("--width 1280 --height 720 --hfov 200", "no pinhole lens"),
        ("--width 1280 --height 720 --hfov 0", "above 0"),
        ("--width 0 --height 720 --hfov 90", "--width 0"),
        ("--width 1280 --height 720 --lens 4mm", "--pixel-pitch"),
        ("--width 1280 --height 720 --lens 4mm --pixel-pitch -3um", "such as 3um"),
        ("--width 1280 --height 720 --lens 4deg --pixel-pitch 3um", "such as 4mm"),
        ("--width 1280 --height 720 --hfov 4mm", "such as 90"),
        ("--width 1280 --height 720", "--hfov"),
        (
            "--width 1280 --height 720 --lens 0.5m --focused-at 0.3m --pixel-pitch 3um",
            "farther away",
        ),
        ("--height 720 --hfov 90", "--width"),
    ] {
        let output = run(&format!("camera {arguments}"));
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{arguments}");
        assert!(said.contains(words) && said.lines().count() == 1, "{arguments}: {said}");
    }
}

/// What a stranger found: figures that were plausible and wrong.
#[test]
fn no_fact_is_overruled_in_silence() {
    let size = "--width 1280 --height 720";
    let with = |facts: &str| camera(&format!("{size} {facts}"));
    let both = |facts: &str| {
        let value = with(facts);
        [value["fx_px"].as_f64().unwrap().round(), value["fy_px"].as_f64().unwrap().round()]
    };
    // The diagonal and a side say the other side: rows were cut.
    let cut = camera("--width 1600 --height 800 --sensor-diagonal 12mm --lens 8mm --sensor-height 7.2mm");
    is(&cut, "fx_px", 1333.33, 0.01);
    assert!(warnings(&cut).contains("1200 rows"), "{}", warnings(&cut));
    assert!(warnings(&with("--lens 4 --sensor-width 4.8mm --pixel-pitch 3um")).contains("1600 columns"));
    assert!(warnings(&with("--lens 4 --sensor-width 3mm --pixel-pitch 3um")).contains("exclude one another"));
    // The first that was stated is followed, in both directions.
    assert_eq!(both("--fy 705 --vfov 30"), [705.0, 705.0]);
    assert_eq!(both("--vfov 30 --fy 705"), [1344.0, 1344.0]);
    // What was typed in pixels says it most directly.
    assert_eq!(both("--hfov 84 --fx 700"), [700.0, 700.0]);
    for facts in [
        "--vfov 54.101194 --fx 700 --fy 705",
        "--fx 700 --fy 705 --vfov 54.101194",
        "--fx 700 --vfov 54.101194",
    ] {
        assert_eq!((both(facts), warnings(&with(facts))), ([700.0, 705.0], String::new()), "{facts}");
    }
    for facts in ["--fx 700 --fy 70", "--p11 2.6 --p00 3", "--hfov 60 --fy 705"] {
        assert!(warnings(&with(facts)).contains("so far from square"), "{facts}");
    }
    assert!(warnings(&with("--hfov 1.57")).contains("1.57rad"));
    let refused = run(&format!("camera {size} --lens 4mm --sensor-diagonal 1/2.3in"));
    let said = String::from_utf8(refused.stderr).unwrap();
    assert!(refused.status.code() == Some(2) && said.contains("7.67 mm"), "{said}");
}
