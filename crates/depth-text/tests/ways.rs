//! The ways to a focal length, a disparity and doffs.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, missing_docs, reason = "tests")]

use depth_core::problem::Problem;
use depth_text::entry::Entries;
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::note::{Issue, Note};
use depth_text::ways::{DISPARITIES, FOCAL_LENGTHS, Way};

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
