//! Every way that people count: angles, lengths on the sensor, heights, balls, pairs one above the other, near lenses, another zero,
//! two photographs, two points. The figures were worked out independently.

use super::{json, near, refused, run_words, text};
use serde_json::Value;

/// The answer of a command of its own.
fn answer(arguments: &str) -> Value {
    let output = super::run(&format!("{arguments} --json"));
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The answer to words with blanks in them.
fn answer_to(words: &[&str]) -> Value {
    let output = run_words(&[&["calculate", "--json"], words].concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn distance(arguments: &str, method: &str) -> Value {
    json(arguments)[method]["distance_m"].clone()
}

#[test]
fn lengths_are_read_in_every_unit_and_in_fractions() {
    for (typed, meters) in [
        ("2 km", 2000.0),
        ("3yd", 2.7432),
        ("1mi", 1609.344),
        ("16 um", 16e-6),
        ("16 µm", 16e-6),
        ("550nm", 550e-9),
        ("1 1/8 in", 0.028_575),
        ("9/8in", 0.028_575),
        ("5'11\"", 1.8034),
        ("5 ft 11 in", 1.8034),
        ("6′ 2″", 1.8796),
        ("1/3", 1.0 / 3.0),
        ("٢", 2.0),
        ("۲٫۵ m", 2.5),
    ] {
        let answer = answer_to(&["--fx", "1000", "--w-img", "1000", "--w-real", typed]);
        near(&answer["inputs"]["w-real"]["value"], meters, 1e-9 * meters);
        near(&answer["monocular"]["distance_m"], meters, 1e-9 * meters);
    }
}

#[test]
fn what_a_log_prints_fills_value_sigma_and_unit() {
    for (fx, value, sigma) in [
        ("700 ± 2 px", 700.0, Some(2.0)),
        ("700±2", 700.0, Some(2.0)),
        ("fx = 718.856 px", 718.856, None),
        ("fx = 718.856 ± 0.5 px", 718.856, Some(0.5)),
        ("700 [px]", 700.0, None),
        ("1280/2", 640.0, None),
        ("2*350 px", 700.0, None),
    ] {
        let answer = answer_to(&["--fx", fx, "--baseline", "100", "--disparity", "50"]);
        let input = &answer["inputs"]["fx"];
        near(&input["value"], value, 1e-9);
        assert_eq!(input["sigma"].as_f64(), sigma, "{fx}");
    }
    let explicit = answer_to(&["--fx", "700 ± 2 px", "--sigma-fx", "7", "--baseline", "100", "--disparity", "50"]);
    assert_eq!(explicit["inputs"]["fx"]["sigma"], 7.0);
    // What was worked out is shown as it was read.
    let output = run_words(&["calculate", "--fx", "1280/2", "--baseline", "1 1/8 in", "--disparity", "2*25"]);
    let lines = String::from_utf8(output.stdout).unwrap();
    assert!(lines.contains("640 px · 1.125 in / 50 px"), "{lines}");
}

#[test]
fn a_bare_sigma_behind_several_units_has_the_last_of_them() {
    let answer = answer_to(&["--fx", "1000", "--w-img", "100", "--w-real", "5'11\" ± 1"]);
    near(&answer["inputs"]["w-real"]["sigma"], 0.0254, 1e-12);
    let answer = answer_to(&["--w-img", "1°30′ ± 1", "--w-real", "1"]);
    near(&answer["inputs"]["w-img"]["sigma"], (1.0_f64 / 60.0).to_radians(), 1e-12);
}

#[test]
fn fy_has_a_sigma_of_its_own_and_else_that_of_fx() {
    let person = "--object height --w-img 100 --w-real 1.8";
    near(
        &json(&format!("--fy 853 --sigma-fy 1% {person}"))["monocular"]["sigma_m"],
        0.153_54,
        1e-6,
    );
    near(
        &json(&format!("--fx 600 --sigma-fx 1% --fy 853 {person}"))["monocular"]["sigma_m"],
        0.153_54,
        1e-6,
    );
    near(
        &json(&format!("--fx 600 --sigma-fx 5% --fy 853 --sigma-fy 1% {person}"))["monocular"]["sigma_m"],
        0.153_54,
        1e-6,
    );
}

#[test]
fn the_name_of_another_quantity_is_not_taken_for_this_one() {
    for (option, value, other) in [
        ("--fx", "cx = 640 px", "cx"),
        ("--disparity", "doffs = 131", "doffs"),
        ("--baseline", "fx: 100", "the focal length"),
        ("--disparity", "D = 1.4", "the distance"),
    ] {
        let refusal = super::refused_words(&["calculate", option, value]);
        assert!(
            refusal.contains(option) && refusal.contains(&format!("This is {other}")),
            "{refusal}"
        );
    }
    for (option, value) in [("--fx", "Fx = 700"), ("--fx", "K[0][0] = 700"), ("--fx", "focal length: 700")] {
        let answer = answer_to(&[option, value, "--baseline", "b = 100", "--disparity", "d = 50"]);
        near(&answer["stereo"]["distance_m"], 1.4, 1e-12);
    }
}

#[test]
fn an_angle_takes_the_place_of_pixels_and_focal_length() {
    for (angle, sigma, meters, by_sigma) in [
        ("0.75mrad", "0.05mrad", 338.667, 22.58),
        ("0.75mil", "0.05mil", 344.963, 22.998),
        ("0.75 NATO mil", "0.05mil", 344.963, 22.998),
    ] {
        let answer = answer_to(&["--w-img", angle, "--w-real", "10in", "--sigma-w-img", sigma]);
        near(&answer["monocular"]["distance_m"], meters, 1e-3);
        near(&answer["monocular"]["sigma_m"], by_sigma, 1e-2);
    }
    for eyes in ["0.5'", "0.5′", "0.5arcmin", "30arcsec", "0.5MOA"] {
        near(&distance(&format!("--baseline 65mm --disparity {eyes}"), "stereo"), 446.91, 0.01);
    }
    let (lines, _) = text("calculate --w-img 0.75mil --w-real 10in");
    assert!(lines.iter().any(|line| line.contains("1/6400 of the circle")), "{lines:?}");
}

#[test]
fn lengths_on_the_sensor_are_a_pair() {
    let meters = distance("--fx 152.44mm --disparity 36.25mm --baseline 576.66ft", "stereo");
    near(&meters, 2425.0 * 0.3048, 0.01);
    let meters = distance("--fx 50mm --w-img 5mm --w-real 2m", "monocular");
    near(&meters, 20.0, 1e-9);
    // Alone each is a slip.
    assert!(refused("calculate --fx 4mm --baseline 100 --disparity 50").contains("width of one pixel in mm"));
    assert!(refused("calculate --fx 700 --baseline 100 --disparity 5mm").contains("counted in pixels"));
}

#[test]
fn heights_balls_and_pairs_one_above_the_other() {
    let person = "--fx 600 --w-img 100 --w-real 1.8";
    near(&distance(person, "monocular"), 10.80, 1e-9);
    near(&distance(&format!("{person} --fy 853 --object height"), "monocular"), 15.354, 1e-9);
    near(&distance(&format!("{person} --object height"), "monocular"), 10.80, 1e-9);
    let pair = "--baseline 25mm --disparity 20 --pair vertical";
    for f in ["--fx 768.4", "--fy 768.4", "--fx 700 --fy 768.4"] {
        near(&distance(&format!("{f} {pair}"), "stereo"), 0.9605, 1e-9);
    }
    near(
        &distance("--fx 1000 --w-img 408.2 --w-real 0.2 --object ball", "monocular"),
        0.5,
        1e-4,
    );
}

#[test]
fn a_near_lens_is_added_where_fx_came_from_it() {
    let object = "--fx 937.5 --w-img 350 --w-real 100mm";
    near(&distance(object, "monocular"), 0.267_857, 1e-6);
    near(&distance(&format!("{object} --lens 15mm"), "monocular"), 0.282_857, 1e-6);
    near(
        &distance("--fx 4000 --lens 16mm --baseline 20mm --disparity 400", "stereo"),
        0.216,
        1e-9,
    );
    let (lines, _) = text(&format!("calculate {object} --lens 15mm"));
    assert!(lines.iter().any(|line| line.contains("of the lens")), "{lines:?}");
    let (lines, _) = text("calculate --fx 937.5 --w-real 100mm --lens 15mm --distance 282.857mm --solve-for w-img");
    assert!(lines[0].starts_with("350.0 px") && lines[1].contains("of the lens"), "{lines:?}");
    // It is nothing to speak of where it is less than 1 %.
    let (lines, _) = text("calculate --fx 937.5 --w-img 5 --w-real 100mm --lens 15mm");
    assert!(!lines.iter().any(|line| line.contains("of the lens")), "{lines:?}");
}

#[test]
fn a_zero_is_taken_from_every_distance_and_added_to_every_taped_one() {
    let mug = "--fx 700 --baseline 100 --disparity 50 --sigma-disparity 0.5 --w-img 150 --w-real 0.3 --sigma-w-img 2";
    let (before, after) = (json(mug), json(&format!("{mug} --zero 4.2mm")));
    for (method, end) in [
        ("stereo", "distance_m"),
        ("stereo", "near_m"),
        ("stereo", "far_m"),
        ("monocular", "distance_m"),
        ("combined", "distance_m"),
    ] {
        let value = before[method][end].as_f64().unwrap();
        near(&after[method][end], value - 0.0042, 1e-12);
    }
    for same in ["estimated_width_px", "estimated_width_m"] {
        assert_eq!(before[same], after[same]);
    }
    // X and Y stay, and R = √(X² + Y² + (Z − zero)²).
    let at = "--fx 500 --baseline 100 --disparity 10 --cx 0 --cy 0 --u 400 --v 300";
    let point = json(&format!("{at} --zero 1m"))["point"].clone();
    near(&point["x_m"], 4.0, 1e-9);
    near(&point["y_m"], 3.0, 1e-9);
    near(&point["z_m"], 4.0, 1e-9);
    near(&point["range_m"], 41.0_f64.sqrt(), 1e-9);
    // A taped range and a taped distance count from there.
    let range = "--fx 500 --cx 0 --cy 0 --u 400 --v 300 --zero 1m --range 6.403124237432849";
    near(&json(range)["point"]["z_m"], 4.0, 1e-9);
    let solved = json("--fx 500 --baseline 100 --distance 4 --zero 1m --solve-for disparity");
    near(&solved["solved"]["value"], 10.0, 1e-9);
}

#[test]
fn two_photographs_and_a_step() {
    let shots = answer("step --far-px 1162 --near-px 1429 --step 419.1mm --sigma-px 3");
    near(&shots["distance_far_m"], 2.243, 5e-4);
    near(&shots["distance_near_m"], 1.824, 5e-4);
    near(&shots["sigma_m"], 0.0325, 1e-4);
    assert!(shots["size_m"].is_null());
    let shots = answer("step --far-px 1162 --near-px 1429 --step 419.1mm --fx 3000");
    near(&shots["size_m"], 0.868_807, 1e-6);
    assert_eq!(shots["warnings"][0]["field"], "sigma-px");
    let exact = answer("step --far-px 100 --near-px 120 --step 1 --sigma-px 0");
    near(&exact["sigma_m"], 0.0, 1e-15);
    let counted = answer("step --far-px 100 --near-px 120 --step 1 --zero 5mm --lens 15mm --sigma-px 1");
    near(&counted["distance_far_m"], 6.01, 1e-12);
    // Both widths are measured in the same way.
    let one = answer("step --far-px 100 --near-px 120 --step 1 --sigma-far-px 2");
    let both = answer("step --far-px 100 --near-px 120 --step 1 --sigma-px 2");
    assert_eq!(one["sigma_m"], both["sigma_m"]);
    // One pixel each, where none is given.
    near(&shots["sigma_m"], 0.0325 / 3.0, 1e-4);
    assert!(refused("step --far-px 1429 --near-px 1162 --step 1").contains("swapped"));
    let (lines, _) = text("step --far-px 1162 --near-px 1429 --step 419.1mm --sigma-px 3 --unit mm");
    assert_eq!(lines[0], "(2243 ± 32) mm (from the first place)");
}

#[test]
fn two_points_are_a_length_apart() {
    let pair = "between --fx 452.9 --baseline 75mm --cx 298.85 --cy 245.52 --from 138,219,36 --to 264,216,30 --sigma-disparity 0.5";
    let points = answer(pair);
    near(&points["distance_m"], 0.3122, 5e-5);
    near(&points["sigma_m"], 0.0112, 5e-5);
    near(&points["dx_m"], 0.247_979, 1e-6);
    near(&points["dy_m"], -0.018_55, 1e-6);
    near(&points["dz_m"], 0.188_708, 1e-6);
    let (lines, _) = text(pair);
    assert_eq!(lines[0], "(0.312 ± 0.011) m (between the points)");
    assert!(refused("between --fx 450 --baseline 75 --cx 1 --cy 1 --from 1,2,0 --to 1,2,3").contains("--from"));
}

#[test]
fn everything_can_be_solved_for_in_its_own_unit() {
    // 8 mrad at 250 m are 2 m.
    let wide = json("--w-img 8mrad --distance 250 --solve-for w-real");
    near(&wide["solved"]["value"], 2.000_01, 1e-4);
    assert_eq!(wide["solved"]["unit"], "m");
    let on_film = json("--fx 152.44mm --baseline 576.66ft --distance 2425ft --solve-for disparity");
    near(&on_film["solved"]["value"], 0.03625, 1e-5);
    assert_eq!(on_film["solved"]["unit"], "m");
    let ball = json("--fx 1000 --w-real 0.2 --distance 0.5 --object ball --solve-for w-img");
    near(&ball["solved"]["value"], 408.248, 1e-3);
}

#[test]
fn one_sigma_for_several_is_named_as_it_was_typed_and_gives_way_to_one_s_own() {
    let shots = "step --near-px 1429 --far-px 1162 --step 419.1mm";
    let mistake = super::run(&format!("{shots} --sigma-px foo"));
    assert!(String::from_utf8_lossy(&mistake.stderr).contains("--sigma-px: "));
    let mistake = super::run(&format!("{shots} --sigma-far-px foo --sigma-px 3"));
    assert!(String::from_utf8_lossy(&mistake.stderr).contains("--sigma-far-px: "));
    let sigma = |arguments: &str| answer(&format!("{shots} {arguments}"))["sigma_m"].as_f64().unwrap();
    assert!(sigma("--sigma-far-px 6 --sigma-px 3") > 1.2 * sigma("--sigma-px 3"));
}

#[test]
fn an_angle_that_may_be_half_of_the_world_has_its_near_end_at_zero() {
    for extent in ["170 ± 20°", "45 ± 180°"] {
        for others in [["--w-real", "1", "--w-img"], ["--baseline", "1m", "--disparity"]] {
            let answer = answer_to(&[&others[..], &[extent]].concat());
            let method = if others[0] == "--w-real" { "monocular" } else { "stereo" };
            assert_eq!(answer[method]["near_m"].as_f64(), Some(0.0), "{answer}");
        }
    }
}

#[test]
fn every_answer_says_that_the_lens_counts_and_which_mil_it_is() {
    let warns = |answer: &Value, field: &str, words: &str| {
        let warnings = answer["warnings"].as_array().unwrap();
        let of_field = |warning: &&Value| warning["field"] == field && warning["message"].as_str().unwrap().contains(words);
        warnings.iter().filter(of_field).count()
    };
    let shots = "step --far-px 1162 --near-px 1429 --step 419.1mm --sigma-px 3";
    assert_eq!(warns(&answer(&format!("{shots} --lens 50mm")), "lens", "more than 1 %"), 1);
    assert_eq!(warns(&answer(&format!("{shots} --lens 5mm")), "lens", ""), 0);
    let pair = json("--fx 4000 --lens 16mm --baseline 20mm --disparity 400 --w-img 400 --w-real 20mm");
    assert_eq!(warns(&pair, "lens", "more than 1 %"), 1, "once, though both distances have it");
    assert_eq!(warns(&answer_to(&["--w-img", "3 mil", "--w-real", "1 yd"]), "w-img", "1/6400"), 1);
}

#[test]
fn a_tape_that_starts_behind_the_object_is_said_to() {
    for zero in ["1900mm", "3m"] {
        let mistake = super::run(&format!(
            "step --far-px 1162 --near-px 1429 --step 419.1mm --sigma-px 3 --zero {zero}"
        ));
        let said = String::from_utf8_lossy(&mistake.stderr).into_owned();
        assert!(said.contains("--zero: The tape would start beyond the object"), "{said}");
    }
    let point = "calculate --fx 700 --baseline 100mm --disparity 50 --cx 640 --cy 360 --u 1000 --v 360";
    assert!(text(point).0.join("\n").contains("R, range from the lens"));
    assert!(
        text(&format!("{point} --zero 30mm"))
            .0
            .join("\n")
            .contains("R, range from where the tape starts")
    );
}

#[test]
fn fy_is_used_where_only_a_width_is_predicted_with_it() {
    for other in ["--w-img 100", "--w-real 1.8"] {
        let answer = json(&format!("--fx 600 --fy 853 --baseline 100 --disparity 50 {other} --object height"));
        let warnings = answer["warnings"].as_array().unwrap();
        assert!(warnings.iter().all(|warning| warning["field"] != "fy"), "{answer}");
    }
}

#[test]
fn marks_of_direction_around_a_number_are_none_of_it() {
    for disparity in [
        "\u{200f}50 px\u{200f}",
        "\u{200e}50\u{200e}",
        "\u{2068}50\u{2069}",
        "\u{202b}50 px\u{202c}",
    ] {
        let answer = answer_to(&["--fx", "700", "--baseline", "100", "--disparity", disparity]);
        assert_eq!(answer["stereo"]["distance_m"].as_f64(), Some(1.4), "{disparity:?}");
    }
    let turned = run_words(&["calculate", "--fx", "700", "--baseline", "100", "--disparity", "\u{202e}05"]);
    assert_eq!(turned.status.code(), Some(2), "what is seen as 50 is no 5");
    let half = run_words(&["calculate", "--fx", "700", "--baseline", "100", "--disparity", "50 ±"]);
    assert!(String::from_utf8_lossy(&half.stderr).contains("Nothing stands behind"));
}
