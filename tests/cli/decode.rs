//! `decode`: a number that is stored for a pixel.

use crate::text;
use depth_calculator::core::problem::{Field, Problem};
use depth_text::entry::Entries;
use depth_text::ways::{ENCODING_NAMES, EncodingName};
use serde_json::{Value, json};

fn answer(arguments: &str) -> Value {
    crate::answer(&format!("decode {arguments}"))
}

fn refusal(arguments: &str) -> String {
    crate::refusal(&format!("decode {arguments}"))
}

/// 50 px and 1.400 m in every encoding that holds a disparity, with 700 px and 100 mm.
#[test]
fn fifty_pixels_in_every_named_encoding() {
    for (raw, name) in [
        ("800", "opencv"),
        ("12800", "kitti"),
        ("12801", "cityscapes"),
        ("1600", "realsense"),
        ("400", "depthai3"),
        ("800", "depthai4"),
        ("1600", "depthai5"),
        ("800", "ensenso"),
        ("690", "kinect1"),
        ("50", "pfm"),
        ("-50", "zed"),
        ("0.0390625 --width 1280", "fraction"),
    ] {
        let value = answer(&format!("{raw} --as {name} --fx 700 --baseline 100mm"));
        assert_eq!(value["disparity_px"], 50.0, "{name}");
        assert!((value["distance_m"].as_f64().unwrap() - 1.4).abs() < 1e-12, "{name}: {value}");
        assert_eq!(value["no_match"], false);
    }
}

#[test]
fn depths_in_every_named_encoding_and_the_disparity_that_they_would_be() {
    for (raw, name) in [
        ("1400", "depth-mm"),
        ("7000", "tum"),
        ("140", "vkitti"),
        ("14000", "depth --per-meter 10000"),
        ("0.6", "da3-metric"),
        ("2", "metric3d"),
    ] {
        let value = answer(&format!("{raw} --as {name} --fx 700 --baseline 100"));
        assert!((value["distance_m"].as_f64().unwrap() - 1.4).abs() < 1e-12, "{name}: {value}");
        assert!((value["disparity_px"].as_f64().unwrap() - 50.0).abs() < 1e-9, "{name}: {value}");
    }
    assert_eq!(answer("2560 --as kitti-depth")["distance_m"], 10.0);
    assert!((answer("100,20,1 --as carla")["distance_m"].as_f64().unwrap() - 4.217).abs() < 5e-4);
    assert!((answer("1 --as inverse-depth --scale 5.4")["distance_m"].as_f64().unwrap() - 0.54).abs() < 1e-12);
    assert!((answer("0 --as inverse-depth --near 0.5 --far 80")["distance_m"].as_f64().unwrap() - 80.0).abs() < 1e-9);
}

#[test]
fn any_other_encoding_by_its_factor_offset_and_mark() {
    // Of the first Kinect, with 580 px and 75 mm.
    let kinect = "--divide -8 --offset 1090 --invalid 2047 --fx 580 --baseline 75";
    let value = answer(&format!("800 {kinect}"));
    assert_eq!(value["disparity_px"], 36.25);
    assert!((value["distance_m"].as_f64().unwrap() - 1.2).abs() < 1e-12);
    assert!((answer("800 --as kinect1")["distance_m"].as_f64().unwrap() - 1.2).abs() < 1e-12);
    assert_eq!(
        answer(&format!("2047 {kinect}")),
        json!({ "disparity_px": null, "distance_m": null, "no_match": true, "warnings": [] })
    );
}

#[test]
fn a_pixel_without_a_match_is_an_answer_and_a_distance_that_cannot_be_known_is_null() {
    for (raw, name) in [
        ("-16", "opencv"),
        ("0", "kitti"),
        ("0", "cityscapes"),
        ("-32768", "ensenso"),
        ("32768", "ensenso"),
        ("0x8000", "ensenso"),
        ("0 --fx 1200", "da3-metric"),
        ("2047", "kinect1"),
        ("inf", "zed"),
        ("nan", "pfm"),
        ("65535", "depth-mm"),
        ("255,255,255", "carla"),
    ] {
        assert_eq!(answer(&format!("{raw} --as {name}"))["no_match"], true, "{name}");
    }
    assert_eq!(answer("12345 --as kitti")["distance_m"], Value::Null);
    assert_eq!(
        answer("50 --as zed --fx 700 --baseline 100")["distance_m"],
        Value::Null,
        "behind the cameras"
    );
    let (lines, _) = text("decode 12345 --as kitti");
    assert_eq!(lines, ["disparity 48.22265625 px", "distance: needs --fx and --baseline"]);
    let (lines, _) = text("decode 1100 --as kinect1");
    assert_eq!(lines, ["disparity -1.25 px", "distance: none"], "its camera is known");
    let meters = answer("12345 --as kitti --fx 700 --baseline 0.54");
    assert!(meters["warnings"].to_string().contains("such as 0.54m"), "{meters}");
}

#[test]
fn a_file_of_16_bits_that_was_read_with_8_is_named() {
    let value = answer("200 --as kitti");
    assert!(
        value["warnings"][0]["message"].as_str().unwrap().contains("IMREAD_UNCHANGED"),
        "{value}"
    );
    assert_eq!(answer("12345 --as kitti")["warnings"], json!([]));
}

#[test]
fn what_is_no_stored_number_says_what_to_do() {
    for (arguments, words) in [
        ("12.5 --as kitti", "divided already"),
        ("70000 --as tum", "cannot be stored"),
        ("foo --as tum", "such as 12345"),
        ("100,20 --as carla", "three numbers"),
        ("3 --as da3-metric", "needs --fx"),
        ("0.5 --as fraction", "needs --width"),
        ("5", "--as"),
        ("5 --divide 0", "--divide: The number of steps in a pixel cannot be zero"),
        ("5 --as inverse-depth --near 3 --far 2", "--far: The far plane must be the larger"),
        ("5 --as inverse-depth --near=-3", "--near: The near plane cannot be negative"),
        ("5 --as inverse-depth --far inf", "--far: With"),
        ("5 --as inverse-depth --scale nan", "--scale: With"),
        ("5 --as opencv --min-disparity 40000", "--min-disparity: minDisparity is"),
        ("1400 --as depth", "depth needs --per-meter"),
        ("1400 --as depth --per-meter 0", "cannot be zero"),
        ("inf --as kitti", "cannot be stored as kitti"),
        ("nan --as depth-mm", "cannot be stored as depth-mm"),
        ("1.5 --as fraction --width 1242", "cannot be stored"),
        ("1.2 --as inverse-depth", "cannot be stored"),
        ("12345 --as kitti --fx 700mm --baseline 100", "such as 1280"),
        ("12345 --as kitti --fx 1e300 --baseline 1e300", "cannot"),
        ("800 --as opencv --fx 700 --baseline -3", "above 0"),
        ("800 --as opencv --fx abc", "abc"),
    ] {
        let said = refusal(arguments);
        assert!(said.contains(words) && said.lines().count() == 1, "{arguments}: {said}");
    }
}

#[test]
fn a_name_may_be_typed_in_capitals() {
    assert_eq!(answer("12345 --as KITTI")["disparity_px"], 48.222_656_25);
    assert!(refusal("12.5 --as Kitti").contains(" kitti stores whole numbers"));
}

#[test]
fn an_option_that_says_nothing_of_what_is_decoded_is_refused() {
    for (arguments, words) in [
        ("12345 --as kitti --near 1", "kitti has no use for --near: leave it out"),
        ("12345 --as kitti --min-disparity 0", "no use for --min-disparity"),
        ("12345 --as kitti --width 1242", "no use for --width"),
        ("12345 --as kitti --per-meter 256", "no use for --per-meter"),
        ("1400 --as depth-mm --per-meter 1000", "no use for --per-meter"),
        ("0.5 --as zed --scale 5.4", "no use for --scale"),
        ("800 --divide 16 --far 100", "--divide has no use for --far"),
    ] {
        let said = refusal(arguments);
        assert!(said.contains(words) && said.lines().count() == 1, "{arguments}: {said}");
    }
    // A camera can always be known.
    assert_eq!(answer("1400 --as depth-mm --fx 700 --baseline 100")["distance_m"], 1.4);
    assert_eq!(answer("0.6 --as da3-metric --fx 700")["disparity_px"], Value::Null);
}

/// Of each name a number, what else is given, and the same as the window has it: the texts of the fields of the way.
const BOTH: [(&str, &str, &str, &[&str]); 21] = [
    ("opencv", "803", "--min-disparity -16", &["803", "-16"]),
    ("kitti", "12345", "", &["12345"]),
    ("cityscapes", "12345", "", &["12345"]),
    ("realsense", "1601", "", &["1601"]),
    ("depthai3", "401", "", &["401", "3"]),
    ("depthai4", "401", "", &["401", "4"]),
    ("depthai5", "401", "", &["401", "5"]),
    ("ensenso", "801", "", &["801"]),
    ("kinect1", "801", "", &["801"]),
    ("pfm", "48.25", "", &["48.25"]),
    ("zed", "-48.25", "", &["-48.25"]),
    ("fraction", "0.039", "--width 1242", &["0.039", "1242"]),
    ("inverse-depth", "0.4", "--near 0.2 --scale 5.4", &["0.4", "0.2", "", "5.4"]),
    ("depth-mm", "1234", "", &["1234", "1000"]),
    ("tum", "1234", "", &["1234", "5000"]),
    ("kitti-depth", "1234", "", &["1234", "256"]),
    ("vkitti", "1234", "", &["1234", "100"]),
    ("depth", "1234", "--per-meter 4000", &["1234", "4000"]),
    ("carla", "100,20,1", "", &["100", "20", "1"]),
    ("da3-metric", "1.5", "", &["1.5"]),
    ("metric3d", "2.5", "", &["2.5"]),
];

#[test]
fn the_window_decodes_what_the_command_line_does() {
    assert!(BOTH.iter().map(|(name, ..)| *name).eq(ENCODING_NAMES.iter().map(|name| name.name)));
    for (name, raw, options, texts) in BOTH {
        // Of the first Kinect its own camera counts in the window.
        let (fx, b) = if name == "kinect1" { (580.0, 0.075) } else { (700.0, 0.1) };
        let value = answer(&format!("{raw} --as {name} {options} --fx {fx} --baseline {b}m"));
        let way = EncodingName::called(name).unwrap().way().unwrap();
        let mut entries = Entries::default();
        for (&key, &text) in way.asks.iter().zip(texts) {
            entries.entry_mut(key).text = text.into();
        }
        let mut form = Problem::default();
        form.set(Field::FocalLength, Some(fx));
        form.set(Field::Baseline, Some(b));
        let result = way.solve(&entries, &form);
        assert!(result.notes.is_empty() && result.value.is_some(), "{name}: {result:?}");
        let distance = result.depth.or(result.distance).map(|distance| distance.m());
        for (field, expected) in [("disparity_px", result.value), ("distance_m", distance)] {
            let ratio = value[field].as_f64().unwrap() / expected.unwrap();
            // The reader of JSON rounds once more.
            assert!((ratio - 1.0).abs() < 1e-15, "{name}: {value} and {result:?}");
        }
    }
}
