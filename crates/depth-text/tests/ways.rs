//! The ways to a focal length, a disparity and doffs.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, missing_docs, reason = "tests")]

use depth_core::disparity::NoDisparity;
use depth_core::problem::{Field, Problem};
use depth_text::choices::DEPTH_SCALES;
use depth_text::entry::Entries;
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::note::{Issue, Note};
use depth_text::ways::{DISPARITIES, ENCODING_NAMES, FOCAL_LENGTHS, Way, WayResult};

fn compute(ways: &'static [Way], name: &str, texts: &[&str]) -> Result<Option<f64>, Note> {
    let way = ways.iter().find(|way| way.name == name).unwrap_or_else(|| panic!("{name}"));
    assert_eq!(way.asks.len(), texts.len(), "{name}");
    let mut entries = Entries::default();
    for (&key, &text) in way.asks.iter().zip(texts) {
        entries.entry_mut(key).text = text.into();
    }
    let result = way.solve(&entries, &Problem::default());
    result.notes.into_iter().next().map_or(Ok(result.value), Err)
}

/// Golden figures: the web page's f_mm / pixel pitch; OpenCV's `calibrationMatrixValues` (2.625 mm on 4.8 mm with
/// 1280 px is 700 px); the vendor's OAK-D Lite (73° on 640 px is 432.5 px); the mug; the D435i's 0.6 scale.
#[test]
fn focal_lengths_come_out_as_published() {
    for (name, texts, expected) in [
        ("Lens and pixel size", &["4", "3"][..], 1333.333),
        ("Lens and sensor width", &["2.625", "4.8", "1280"], 700.0),
        ("Horizontal field of view", &["73", "640"], 432.45),
        ("Vertical field of view", &["54.093788", "720"], 705.0),
        ("Diagonal field of view", &["90", "800", "600"], 500.0),
        ("One reference photo", &["150", "1.4", "0.3"], 700.0),
        ("Same camera, other resolution", &["631.343", "1280", "768"], 378.806),
    ] {
        let got = compute(FOCAL_LENGTHS, name, texts).unwrap().unwrap();
        // The vertical one has its principal point 10 px off the center in the source.
        let tolerance = if name.starts_with("Vertical") { 1e-3 } else { 2e-4 };
        assert!((got / expected - 1.0).abs() < tolerance, "{name}: {got}");
    }
}

#[test]
fn every_way_to_the_mug_s_fifty_pixels() {
    for (name, texts) in [
        ("Columns in both images", &["660", "610"][..]),
        ("OpenCV StereoBM or StereoSGBM", &["800", "0"]),
        ("KITTI, 16-bit image", &["12800"]),
        ("Cityscapes, 16-bit image", &["12801"]),
        ("RealSense D400, disparity", &["1600"]),
        ("Ensenso", &["800"]),
        ("Kinect, the first one", &["690"]),
        ("Middlebury or PFM, floating point", &["50"]),
        ("Any other: factor, offset, no match", &["690", "-8", "1090", "2047"]),
        ("Any other: factor, offset, no match", &["800", "16", "", ""]),
        ("DepthAI, sub-pixel", &["400", "3"]),
        ("Fraction of the image width", &["0.0390625", "1280"]),
        ("ZED, negative sign", &["-50"]),
    ] {
        assert_eq!(compute(DISPARITIES, name, texts), Ok(Some(50.0)), "{name}");
    }
    assert_eq!(
        compute(DISPARITIES, "doffs from both principal points", &["610", "650"]),
        Ok(Some(40.0))
    );
    assert_eq!(
        compute(DISPARITIES, "doffs as a calibration file gives it", &["131.1 px"]),
        Ok(Some(131.1))
    );
}

/// The same numbers in other units: once these units were dropped, and 4 cm were taken for 4 mm.
#[test]
fn units_that_were_typed_are_converted_or_refused() {
    for (name, bare, with_units) in [
        ("Lens and pixel size", &["4", "3"][..], &["0.4 cm", "0.003 mm"][..]),
        ("Lens and pixel size", &["4", "3"], &["4 mm", "3 µm"]),
        ("Lens and sensor width", &["2.54", "4.8", "1280"], &["0.1 in", "0.48 cm", "1280 px"]),
        ("Horizontal field of view", &["57.29577951308232", "640"], &["1 rad", "640px"]),
        ("Vertical field of view", &["60", "720"], &["1.0471975511965976 rad", "720 px"]),
        ("Diagonal field of view", &["90", "800", "600"], &["90°", "800 px", "600px"]),
        ("One reference photo", &["150", "1.4", "0.3"], &["150 px", "140 cm", "300mm"]),
        (
            "Same camera, other resolution",
            &["700", "1280", "640"],
            &["700 px", "1280 px", "640px"],
        ),
        ("Multiple of the image width", &["0.9", "1280"], &["0.9", "1280 px"]),
        ("Multiple of half the image width", &["0.9", "1280"], &["0.9", "1280 px"]),
    ] {
        let (bare, with_units) = (compute(FOCAL_LENGTHS, name, bare), compute(FOCAL_LENGTHS, name, with_units));
        let (bare, with_units) = (bare.unwrap().unwrap(), with_units.unwrap().unwrap());
        assert!((bare / with_units - 1.0).abs() < 1e-15, "{name}: {bare} and {with_units}");
    }
    // 3.67 mm on 4.8 mm with 1280 px; something 28 cm wide on 200 px at 1.4 m.
    for (name, texts, expected) in [
        ("Lens and sensor width", &["3.67 mm", "4.8 mm", "1280 px"][..], 978.667),
        ("One reference photo", &["200", "1.4 m", "28 cm"], 1000.0),
        ("Horizontal field of view", &["60°", "1280 px"], 1108.513),
        ("Horizontal field of view", &["1.047 rad", "320 px"], 277.191),
    ] {
        let found = compute(FOCAL_LENGTHS, name, texts).unwrap().unwrap();
        assert!((found / expected - 1.0).abs() < 1e-5, "{name}: {found}");
    }
    for (name, texts) in [
        ("Multiple of the image width", &["0.9 px", "1280"][..]),
        ("Same camera, other resolution", &["700 mm", "1280", "640"]),
        ("Same camera, other resolution", &["700", "1280 cm", "640"]),
        ("Lens and pixel size", &["4 px", "3"]),
        ("Lens and pixel size", &["4", "3 px"]),
        ("Horizontal field of view", &["73 px", "640"]),
        ("Horizontal field of view", &["73", "640°"]),
        ("Horizontal field of view", &["73 C", "640"]),
    ] {
        assert!(compute(FOCAL_LENGTHS, name, texts).is_err(), "{name} {texts:?}");
    }
    assert!(compute(DISPARITIES, "KITTI, 16-bit image", &["12800 px"]).is_err());
}

/// 1.047 rad is 59.99°: 320/2/tan(0.5235) = 277.19 px. As degrees it would be 17 511 px.
#[test]
fn a_view_that_may_be_in_radians_is_asked_about() {
    let of = |view: &str, width| compute(FOCAL_LENGTHS, "Horizontal field of view", &[view, width]);
    let note = of("1.047", "320").unwrap_err();
    let labels: Vec<_> = note.fixes.iter().map(|fix| fix.label()).collect();
    assert_eq!(labels, ["Use 1.047 rad", "Use 1.047°"]);
    for (view, expected) in [("1.047 rad", 277.19), ("1.047°", 17_511.0), ("60°", 277.13), ("3.2", 5728.0)] {
        let found = of(view, "320").unwrap().unwrap();
        assert!((found / expected - 1.0).abs() < 1e-4, "{view}: {found}");
    }
    // An honest telephoto lens.
    assert!((of("6", "640").unwrap().unwrap() - 6105.96).abs() < 0.01);
    // What was answered stays answered when the field is left.
    let mut entry = note.fixes[1].entry.clone();
    entry.tidy(fields::HORIZONTAL_VIEW);
    let mut entries = Entries::default();
    *entries.entry_mut(fields::HORIZONTAL_VIEW) = entry;
    entries.entry_mut(fields::FRAME_WIDTH).text = "320".into();
    let way = Way::named(FOCAL_LENGTHS, "horizontal-view").unwrap();
    assert!(way.solve(&entries, &Problem::default()).value.is_some());
}

/// 0.97428 at 800 px: 779.4 px and a view of 54.3°, or 389.7 px and 91.5°.
#[test]
fn a_focal_length_may_be_a_multiple_of_the_width_or_of_half_of_it() {
    for (name, expected) in [
        ("Multiple of the image width", 779.424),
        ("Multiple of half the image width", 389.712),
    ] {
        let found = compute(FOCAL_LENGTHS, name, &["0.97428", "800"]).unwrap().unwrap();
        assert!((found - expected).abs() < 1e-9, "{found}");
    }
    let mut inputs = Inputs::default();
    inputs.entry_mut(fields::FOCAL_LENGTH).text = "0.97428".into();
    let said = inputs.assess().note(fields::FOCAL_LENGTH).unwrap().message();
    assert!(said.contains("54.3°") && said.contains("91.5°"), "{said}");
    // However small: such a view is wide, and no number of pixels is like that.
    for tiny in ["0.05", "9.99", "0.001"] {
        inputs.entry_mut(fields::FOCAL_LENGTH).text = tiny.into();
        let note = inputs.assess().note(fields::FOCAL_LENGTH).cloned().unwrap();
        assert!(
            matches!(note.issue, Issue::MultipleOfWidth { .. }) && note.fixes.len() == 2,
            "{tiny}: {note:?}"
        );
    }
    inputs.entry_mut(fields::FOCAL_LENGTH).text = "22154".into();
    assert_eq!(inputs.assess().notes, [], "a telephoto lens of a system camera");
}

#[test]
fn nothing_is_said_while_something_is_missing() {
    assert_eq!(compute(FOCAL_LENGTHS, "Lens and pixel size", &["4", ""]), Ok(None));
    assert_eq!(compute(FOCAL_LENGTHS, "Lens and pixel size", &["", "0"]), Ok(None));
}

#[test]
fn invalid_values_of_opencv_are_recognized_for_the_min_disparity_given() {
    for (stored, min_disparity) in [("-16", "0"), ("240", "16"), ("-272", "-16"), ("-272", "0"), ("-1", "0")] {
        let note = compute(DISPARITIES, "OpenCV StereoBM or StereoSGBM", &[stored, min_disparity]).unwrap_err();
        assert!(note.message().contains("found nothing"), "{note:?}");
    }
}

#[test]
fn numbers_that_give_no_focal_length_are_refused_in_words() {
    for (name, texts) in [
        ("Horizontal field of view", &["180", "640"][..]),
        ("Lens and pixel size", &["0", "3"]),
    ] {
        assert_eq!(compute(FOCAL_LENGTHS, name, texts).unwrap_err().issue, Issue::NoFocalLength);
    }
}

#[test]
fn no_two_ways_share_a_key() {
    for ways in [FOCAL_LENGTHS, DISPARITIES] {
        for way in ways {
            assert_eq!(ways.iter().filter(|other| other.key == way.key).count(), 1, "{}", way.name);
            assert_eq!(Way::named(ways, way.key).unwrap().name, way.name);
        }
    }
}

/// What came of the way `key` with `texts` in its fields, for the cameras of `form`.
fn solve(key: &str, texts: &[&str], form: &Problem) -> WayResult {
    let way = Way::named(DISPARITIES, key).unwrap();
    let mut entries = Entries::default();
    for (&key, &text) in way.asks.iter().zip(texts) {
        entries.entry_mut(key).text = text.into();
    }
    way.solve(&entries, form)
}

fn form(fields: &[(Field, f64)]) -> Problem {
    let mut form = Problem::default();
    fields.iter().for_each(|&(field, value)| form.set(field, Some(value)));
    form
}

fn mug() -> Problem {
    form(&[(Field::FocalLength, 700.0), (Field::Baseline, 0.1)])
}

fn issue(key: &str, texts: &[&str]) -> Option<(String, Issue)> {
    let result = solve(key, texts, &mug());
    assert_eq!(result.value, None, "{key}");
    result.notes.into_iter().next().map(|note| (note.key.key.to_owned(), note.issue))
}

/// Every depth of 1.4 m is 50 px to 700 px and 100 mm.
#[test]
fn a_stored_depth_is_the_disparity_that_it_would_be() {
    for (key, texts) in [
        ("depth", &["1400", "1000"][..]),
        ("depth", &["7000", "5000"]),
        ("da3-metric", &["0.6"]),
        ("metric3d", &["2"]),
    ] {
        let result = solve(key, texts, &mug());
        assert!((result.depth.unwrap().m() - 1.4).abs() < 1e-12, "{key}: {result:?}");
        assert!((result.value.unwrap() - 50.0).abs() < 1e-9, "{key}: {result:?}");
        assert!(result.missing.is_empty() && result.distance.is_none(), "{key}: {result:?}");
    }
    // CARLA's reference, and monodepth2's stereo models of KITTI.
    let carla = solve("carla", &["100", "20", "1"], &Problem::default());
    assert!((carla.depth.unwrap().m() - 4.217).abs() < 5e-4, "{carla:?}");
    let inverse = |texts: &[&str]| solve("inverse-depth", texts, &mug()).depth.unwrap().m();
    assert!((inverse(&["1", "", "", "5.4"]) - 0.54).abs() < 1e-12);
    assert!((inverse(&["0", "", "", ""]) - 100.0).abs() < 1e-9);
    assert!((inverse(&["0", "0.5", "80", ""]) - 80.0).abs() < 1e-9);
    // fx·b/Z less doffs.
    let with_doffs = form(&[(Field::FocalLength, 700.0), (Field::Baseline, 0.1), (Field::Doffs, 20.0)]);
    assert!((solve("depth", &["1400", "1000"], &with_doffs).value.unwrap() - 30.0).abs() < 1e-9);
}

#[test]
fn a_depth_says_what_the_form_lacks() {
    let missing = |key: &str, texts: &[&str], form: &Problem| {
        let result = solve(key, texts, form);
        assert_eq!((result.value, result.notes.len()), (None, 0), "{key}");
        let keys: Vec<_> = result.missing.iter().map(|key| key.key).collect();
        (result.depth.map(|depth| depth.m()), keys.join(" "))
    };
    let depth = |form: &Problem| missing("depth", &["1400", "1000"], form);
    assert_eq!(depth(&Problem::default()), (Some(1.4), "fx b".to_owned()));
    assert_eq!(depth(&form(&[(Field::FocalLength, 700.0)])), (Some(1.4), "b".to_owned()));
    assert_eq!(depth(&form(&[(Field::Baseline, 0.1)])), (Some(1.4), "fx".to_owned()));
    assert_eq!(missing("metric3d", &["2"], &Problem::default()), (None, "fx".to_owned()));
    assert_eq!(missing("metric3d", &[""], &Problem::default()), (None, String::new()));
}

#[test]
fn a_stored_disparity_says_how_far_away_that_is() {
    let distance = |key: &str, texts: &[&str], form: &Problem| solve(key, texts, form).distance.map(|distance| distance.m());
    assert_eq!(distance("kitti", &["12800"], &mug()), Some(1.4));
    assert_eq!(distance("columns", &["660", "610"], &mug()), Some(1.4));
    assert_eq!(distance("kitti", &["12800"], &Problem::default()), None);
    assert_eq!(distance("zed", &["50"], &mug()), None, "behind the cameras");
    let with_doffs = form(&[(Field::FocalLength, 700.0), (Field::Baseline, 0.1), (Field::Doffs, 20.0)]);
    assert_eq!(distance("kitti", &["12800"], &with_doffs), Some(1.0));
    // Its own 580 px and 75 mm, whatever is in the form: the result fills them in.
    assert!((distance("kinect1", &["800"], &with_doffs).unwrap() - 1.2).abs() < 1e-12);
    let also = Way::named(DISPARITIES, "kinect1").unwrap().also(&Entries::default());
    let also: Vec<_> = also.into_iter().map(|(key, entry)| format!("{} {}", key.key, entry.text)).collect();
    assert_eq!(also, ["fx 580", "b 75", "doffs ", "fy "]);
}

#[test]
fn a_file_of_16_bits_that_was_read_with_8_is_named_and_used_all_the_same() {
    for (key, texts) in [("kitti", &["200"][..]), ("cityscapes", &["255"]), ("depth", &["140", "1000"])] {
        let result = solve(key, texts, &mug());
        assert!(
            matches!(result.notes[0].issue, Issue::EightBits { .. }) && result.value.is_some(),
            "{key}"
        );
    }
    for (key, texts) in [("kitti", &["256"][..]), ("realsense", &["200"]), ("opencv", &["200", "0"])] {
        assert_eq!(solve(key, texts, &mug()).notes, [], "{key}");
    }
}

#[test]
fn what_cannot_be_stored_is_said_at_its_field() {
    let not = |reason| Issue::NotADisparity { reason };
    for (key, texts, field, expected) in [
        ("kitti", &["inf"][..], "stored", not(NoDisparity::OutOfRange)),
        ("pfm", &["inf"], "stored", not(NoDisparity::Invalid)),
        ("pfm", &["NaN"], "stored", not(NoDisparity::Invalid)),
        ("zed", &["-inf"], "zed-disparity", not(NoDisparity::Invalid)),
        ("ensenso", &["-32768"], "stored", not(NoDisparity::Invalid)),
        ("linear", &["2047", "-8", "1090", "2047"], "stored", not(NoDisparity::Invalid)),
        ("depth", &["65535", "1000"], "stored", Issue::NoDepth),
        ("carla", &["255", "255", "255"], "red", Issue::NoDepth),
        ("carla", &["1", "256", "0"], "green", Issue::NotAChannel),
        ("inverse-depth", &["0.5", "3", "2", ""], "far-plane", Issue::FarPlaneNotFarther),
    ] {
        assert_eq!(issue(key, texts), Some((field.to_owned(), expected)), "{key} {texts:?}");
    }
    assert!(matches!(issue("linear", &["5", "0", "", ""]), Some((field, Issue::Zero { .. })) if field == "steps-per-pixel"));
    assert!(matches!(issue("depth", &["5", "-1"]), Some((field, Issue::Negative { .. })) if field == "steps-per-meter"));
    // A parameter that cannot be read is none that was left out.
    assert!(matches!(issue("inverse-depth", &["0.5", "near", "", ""]), Some((field, Issue::NotANumber { .. })) if field == "near-plane"));
    assert!(matches!(issue("pfm", &["abc"]), Some((_, Issue::NotANumber { .. }))));
}

#[test]
fn the_names_of_the_command_line_stand_for_ways_and_for_common_scales() {
    for name in ENCODING_NAMES {
        let way = name.way().unwrap_or_else(|| panic!("{}", name.name));
        assert_eq!(
            ENCODING_NAMES.iter().filter(|other| other.name == name.name).count(),
            1,
            "{}",
            name.name
        );
        let Some((key, value)) = name.fixed else { continue };
        assert!(way.asks.contains(&key), "{}", name.name);
        let is_common = DEPTH_SCALES.iter().any(|(steps, _)| *steps == value);
        assert!(is_common || key == fields::SUBPIXEL_BITS, "{}", name.name);
    }
    assert!(DEPTH_SCALES.is_sorted_by(|a, b| a.0 < b.0));
}

/// First two columns, then what matchers and cameras store, then depths, then what is no disparity.
#[test]
fn the_ways_to_a_disparity_are_in_a_sensible_order() {
    let names: Vec<_> = DISPARITIES.iter().map(|way| way.name).collect();
    assert_eq!(
        names,
        [
            "Columns in both images",
            "OpenCV StereoBM or StereoSGBM",
            "KITTI, 16-bit image",
            "Cityscapes, 16-bit image",
            "RealSense D400, disparity",
            "DepthAI, sub-pixel",
            "Ensenso",
            "Kinect, the first one",
            "Middlebury or PFM, floating point",
            "ZED, negative sign",
            "Fraction of the image width",
            "Any other: factor, offset, no match",
            "Depth: steps in a meter",
            "Depth in three channels, CARLA",
            "Network: inverse depth",
            "Network: Depth Anything 3, metric",
            "Network: Metric3D",
            "doffs from both principal points",
            "doffs as a calibration file gives it",
        ]
    );
}
