//! The form: what was typed, what it means, and what is said about it.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, missing_docs, reason = "tests")]

use depth_core::problem::{Field, Method, Outcome};
use depth_core::quantity::Length;
use depth_core::quantity::LengthUnit::{Centimeter, Foot, Meter, Millimeter};
use depth_text::entry::Entry;
use depth_text::field::Key;
use depth_text::fields;
use depth_text::form::{Example, Inputs};
use depth_text::note::{Fix, Issue, Note, Severity};
use depth_text::unit::Unit;

fn with(field: Field, text: &str) -> Inputs {
    let mut inputs = Inputs::default();
    inputs.entry_mut(field).text = text.into();
    inputs
}

fn note(inputs: &Inputs, field: Field) -> Note {
    inputs
        .assess()
        .note(field)
        .cloned()
        .unwrap_or_else(|| panic!("no note at {field:?}"))
}

#[test]
fn the_examples_give_the_distances_of_the_page() {
    let mug = Example::CoffeeMug.inputs().assess();
    assert_eq!(mug.solution.stereo, Outcome::Distance(Length::from_m(1.4)));
    assert_eq!(mug.notes, []);
    let doorway = Example::Doorway.inputs().assess();
    assert_eq!(doorway.solution.monocular, Outcome::Distance(Length::from_m(4.275)));
    assert_eq!(doorway.notes, []);
}

#[test]
fn a_typed_unit_holds_at_once_and_moves_beside_the_field_when_tidied() {
    let mut inputs = with(Field::Baseline, "10 cm");
    let reading = inputs.assess().reading(Field::Baseline).and_then(|reading| reading.unit);
    assert_eq!(reading, Some(Unit::Length(Centimeter)));
    assert_eq!(inputs.assess().solution.problem.get(Field::Baseline), Some(0.1));
    inputs.tidy(Field::Baseline);
    let tidied = Entry {
        unit_was_typed: true,
        ..Entry::new("10", Some(Centimeter))
    };
    assert_eq!(inputs.entry(Field::Baseline), &tidied);
}

#[test]
fn choosing_a_unit_keeps_the_typed_number() {
    let mut inputs = with(Field::Baseline, "10 cm");
    inputs.choose_unit(Field::Baseline, Meter);
    assert_eq!(inputs.entry(Field::Baseline), &Entry::new("10", Some(Meter)));
}

#[test]
fn pixels_where_a_length_belongs_and_the_reverse_are_refused() {
    let fx = note(&with(Field::FocalLength, "4 mm"), Field::FocalLength);
    assert!(fx.message().contains("one pixel in mm"), "{}", fx.message());
    let b = note(&with(Field::Baseline, "4 px"), Field::Baseline);
    assert!(b.message().contains("mm, cm, m, km, in, ft, yd or mi"), "{}", b.message());
}

#[test]
fn zero_disparity_is_infinity_and_a_negative_one_a_swap() {
    let zero = note(&with(Field::Disparity, "0"), Field::Disparity);
    assert!(zero.message().contains("infinitely far"), "{}", zero.message());
    let negative = note(&with(Field::Disparity, "−50"), Field::Disparity);
    assert!(negative.message().contains("swapped"), "{}", negative.message());
    assert_eq!(negative.fixes.first().unwrap().entry.text, "50");
}

#[test]
fn a_slip_of_the_unit_is_offered_the_right_one() {
    let b = note(&with(Field::Baseline, "0.1"), Field::Baseline);
    assert_eq!(b.severity, Severity::Warning);
    assert_eq!(b.fixes.first().unwrap().entry, Entry::new("0.1", Some(Meter)));
    let mut inputs = with(Field::Baseline, "100");
    inputs.choose_unit(Field::Baseline, Meter);
    assert_eq!(
        note(&inputs, Field::Baseline).fixes.first().unwrap().entry,
        Entry::new("100", Some(Millimeter))
    );
}

#[test]
fn one_bad_field_leaves_the_other_method_alone() {
    let mut inputs = Example::Doorway.inputs();
    inputs.entry_mut(Field::Disparity).text = "0".into();
    inputs.entry_mut(Field::Baseline).text = "x".into();
    let assessment = inputs.assess();
    assert_eq!(assessment.solution.monocular, Outcome::Distance(Length::from_m(4.275)));
    assert_eq!(assessment.notes.len(), 2);
}

#[test]
fn an_overflowing_distance_is_refused_at_the_strangest_field() {
    let mut inputs = Example::CoffeeMug.inputs();
    inputs.entry_mut(Field::FocalLength).text = "1e308".into();
    inputs.entry_mut(Field::Disparity).text = "1e-5".into();
    let assessment = inputs.assess();
    assert_eq!(assessment.solution.stereo.distance(), None);
    assert_eq!(assessment.note(Field::FocalLength).unwrap().severity, Severity::Error);
    // Only a conversion pushes this one out of range.
    assert_eq!(note(&with(Field::Baseline, "1e-306"), Field::Baseline).severity, Severity::Error);
}

#[test]
fn missing_names_what_a_half_filled_method_lacks_and_nothing_of_an_untouched_one() {
    let fields = |inputs: &Inputs| inputs.missing().iter().map(|note| note.key.input.unwrap()).collect::<Vec<_>>();
    assert_eq!(fields(&Inputs::default()), [Field::FocalLength]);
    assert_eq!(fields(&with(Field::FocalLength, "700")), [Field::Baseline]);
    assert_eq!(fields(&with(Field::Disparity, "50")), [Field::FocalLength, Field::Baseline]);
    assert_eq!(fields(&Example::CoffeeMug.inputs()), []);
    let mut both = Example::CoffeeMug.inputs();
    both.entry_mut(Field::RealWidth).text = "1".into();
    assert_eq!(fields(&both), [Field::ImageWidth]);
}

#[test]
fn what_is_solved_for_is_not_missing() {
    let mut inputs = with(Field::FocalLength, "700");
    inputs.entry_mut(Field::Disparity).text = "50".into();
    inputs.unknown = Some((Method::Stereo, Field::Baseline));
    inputs.entry_mut(fields::DISTANCE).text = "1.4".into();
    assert_eq!(inputs.missing(), []);
    let found = inputs.assess().unknown.unwrap().outcome.unwrap();
    assert!((found.to_base().value - 0.1).abs() < 1e-12, "{found:?}");
}

fn typed(texts: &[(Key, &str)]) -> Inputs {
    let mut inputs = Inputs::default();
    for &(key, text) in texts {
        let (value, sigma) = text.split_once('±').unwrap_or((text, ""));
        let entry = inputs.entry_mut(key);
        entry.text = value.into();
        entry.sigma = sigma.into();
    }
    inputs
}

/// A camera at fx 700, cy 360 that looks 10° down, the point on row 500: h/(sin 10° + 0.2·cos 10°)·(cos 10° − 0.2·sin 10°).
fn floor(texts: &[(Key, &str)]) -> Inputs {
    let camera = [
        (fields::FOCAL_LENGTH, "700"),
        (fields::CY, "360"),
        (fields::CAMERA_PITCH, "10"),
        (fields::FLOOR_ROW, "500"),
    ];
    typed(&[&camera[..], texts].concat())
}

fn along_floor(inputs: &Inputs) -> (f64, f64) {
    let assessment = inputs.assess();
    let distance = assessment
        .geometry
        .ground
        .unwrap_or_else(|| panic!("{:?}", assessment.notes))
        .distance;
    (distance.value.m(), distance.sigma.m())
}

#[test]
fn a_typed_unit_is_converted_on_the_floor_too() {
    for (height, expected) in [("120 cm", 3.076), ("1.2", 3.076), ("1200 mm", 3.076), ("4 ft", 3.125)] {
        let (distance, _) = along_floor(&floor(&[(fields::CAMERA_HEIGHT, height)]));
        assert!((distance - expected).abs() < 1e-3, "{height}: {distance}");
    }
    let level = [
        (fields::CAMERA_HEIGHT, "40 in"),
        (fields::CAMERA_PITCH, "25°"),
        (fields::FLOOR_ROW, "360"),
    ];
    assert!((along_floor(&floor(&level)).0 - 2.179).abs() < 1e-3);
    let radians = [(fields::CAMERA_HEIGHT, "1.2"), (fields::CAMERA_PITCH, "0.17453 rad")];
    assert!((along_floor(&floor(&radians)).0 - 3.076).abs() < 1e-3);
}

#[test]
fn every_sigma_of_the_floor_is_read_or_refused() {
    let of = |key, text| floor(&[(fields::CAMERA_HEIGHT, "1.2"), (key, text)]);
    for (key, text, expected) in [
        (fields::CAMERA_HEIGHT, "1.2 ± 5 cm", 0.128),
        (fields::CAMERA_HEIGHT, "120 cm ± 5", 0.128),
        (fields::CAMERA_HEIGHT, "1.2 ± 5%", 0.154),
        (fields::CAMERA_PITCH, "10 ± 0.5°", 0.079),
        (fields::CAMERA_PITCH, "10 ± ±0.5", 0.079),
        (fields::CAMERA_PITCH, "10 ± 0.5", 0.079),
    ] {
        let (_, sigma) = along_floor(&of(key, text));
        assert!((sigma - expected).abs() < 1e-3, "{text}: {sigma}");
    }
    for (key, text) in [
        (fields::CAMERA_HEIGHT, "1.2 ± abc"),
        (fields::CAMERA_PITCH, "10 ± 2 m"),
        (fields::FLOOR_ROW, "500 ± 3 cm"),
    ] {
        let assessment = of(key, text).assess();
        assert_eq!(assessment.geometry.ground, None, "{text}");
        assert!(assessment.sigma_note(key).is_some(), "{text}");
    }
}

/// Without it the distance would be plausible and wrong.
#[test]
fn what_cannot_be_read_is_no_reason_to_go_on_without_it() {
    let stereo = [(fields::FOCAL_LENGTH, "700"), (fields::BASELINE, "100"), (fields::DISPARITY, "50")];
    let with = |key, text| typed(&[&stereo[..], &[(key, text)]].concat()).assess();
    assert_eq!(with(fields::DOFFS, "abc").solution.stereo.distance(), None);
    assert!(with(fields::DOFFS, "4").solution.stereo.distance().is_some());
    let door = [
        (fields::FOCAL_LENGTH, "950"),
        (fields::IMAGE_WIDTH, "200"),
        (fields::REAL_WIDTH, "0.9"),
    ];
    for (tilt, is_there) in [("20", true), ("20 px", false), ("abc", false), ("95", false), ("0.3 rad", true)] {
        let assessment = typed(&[&door[..], &[(fields::TILT, tilt)]].concat()).assess();
        assert_eq!(assessment.solution.monocular.distance().is_some(), is_there, "{tilt}");
        assert_eq!(assessment.note(fields::TILT).is_none(), is_there, "{tilt}");
    }
    for sigma in ["abc", "3 m", "-1", "1 px %"] {
        let mut inputs = typed(&stereo);
        inputs.set_sigma(fields::BASELINE, "1");
        inputs.set_sigma(fields::DISPARITY, sigma);
        let assessment = inputs.assess();
        assert!(assessment.solution.stereo.distance().is_some());
        assert_eq!(assessment.solution.stereo_uncertainty, None, "{sigma}");
        assert_eq!(assessment.notes.len(), 1, "{sigma}: {:?}", assessment.notes);
    }
}

#[test]
fn a_disparity_of_any_sign_gives_doffs() {
    for (disparity, doffs) in [("0", 104.282), ("-10", 114.282), ("40", 64.282)] {
        let mut inputs = typed(&[
            (fields::FOCAL_LENGTH, "443.2"),
            (fields::BASELINE, "4 in"),
            (fields::DISPARITY, disparity),
            (fields::DISTANCE, "17 in"),
        ]);
        inputs.unknown = Some((Method::Stereo, Field::Doffs));
        let assessment = inputs.assess();
        let found = assessment.unknown.unwrap().outcome.unwrap();
        assert!((found.to_base().value - doffs).abs() < 1e-3, "{disparity}: {found:?}");
        assert_eq!(assessment.notes, []);
    }
}

#[test]
fn no_match_is_no_disparity_but_where_doffs_makes_it_one() {
    for text in ["-16", "-1", "-272", "-17", "−16 px", "-528"] {
        let stereo = [(fields::FOCAL_LENGTH, "700"), (fields::BASELINE, "100"), (fields::DISPARITY, text)];
        let assessment = typed(&stereo).assess();
        let note = assessment.note(fields::DISPARITY).unwrap();
        assert!(matches!(note.issue, Issue::NoMatch { .. }), "{text}: {note:?}");
        assert_eq!((note.severity, &note.fixes[..]), (Severity::Error, &[][..]), "{text}");
        let offset = typed(&[&stereo[..], &[(fields::DOFFS, "600")]].concat()).assess();
        assert!(offset.solution.stereo.distance().is_some(), "{text}");
        assert_eq!(offset.note(fields::DISPARITY).unwrap().severity, Severity::Warning, "{text}");
    }
    let swapped = typed(&[(fields::FOCAL_LENGTH, "700"), (fields::BASELINE, "100"), (fields::DISPARITY, "-50")]).assess();
    assert_eq!(swapped.note(fields::DISPARITY).unwrap().issue, Issue::NegativeDisparity);
}

#[test]
fn a_unit_that_was_typed_is_believed_also_after_the_field_was_left() {
    let mut inputs = typed(&[(fields::FOCAL_LENGTH, "700"), (fields::BASELINE, "576.67 ft")]);
    for _ in 0..2 {
        let assessment = inputs.assess();
        let note = assessment.note(fields::BASELINE).unwrap();
        assert_eq!((&note.issue, note.fixes.len()), (&Issue::Unusual { key: fields::BASELINE }, 0));
        inputs.tidy(fields::BASELINE);
    }
    inputs.choose_unit(fields::BASELINE, Foot);
    assert_eq!(
        inputs.assess().note(fields::BASELINE).unwrap().fixes.len(),
        1,
        "a chosen one may be a slip"
    );
}

/// fx·b/d = 670.35 · 1.695 · 23.6 mm / 40.
#[test]
fn a_baseline_in_squares_of_the_board_is_read_and_asked_for() {
    let of = |baseline| {
        typed(&[
            (fields::FOCAL_LENGTH, "670.35"),
            (fields::BASELINE, baseline),
            (fields::DISPARITY, "40"),
        ])
    };
    let squares = of("1.695 squares of 23.6 mm").assess();
    assert!((squares.solution.stereo.distance().unwrap().m() - 0.670).abs() < 5e-4);
    assert_eq!(squares.notes, []);
    let bare = of("1.695").assess();
    let fixes: Vec<_> = bare.note(fields::BASELINE).unwrap().fixes.iter().map(Fix::label).collect();
    assert_eq!(fixes, ["Use 1.695 m", "Use squares of … mm"]);
    let unsized_ = of("1.695 squares of ").assess();
    assert!(matches!(
        unsized_.note(fields::BASELINE).unwrap().issue,
        Issue::SizeOfSquares { .. }
    ));
    // It is kept as it was typed: there is no choice of unit that says as much.
    let mut inputs = of("1.695 squares of 23.6 mm");
    inputs.tidy(fields::BASELINE);
    assert_eq!(inputs.entry(fields::BASELINE).text, "1.695 squares of 23.6 mm");
}

#[test]
fn a_negative_baseline_says_why_and_is_mended_by_one_click() {
    let inputs = typed(&[(fields::BASELINE, "-1.695 m")]);
    let assessment = inputs.assess();
    let note = assessment.note(fields::BASELINE).unwrap();
    assert_eq!(note.issue, Issue::NegativeBaseline);
    assert_eq!(note.fixes.iter().map(Fix::label).collect::<Vec<_>>(), ["Use 1.695 m"]);
    let mut mended = inputs.clone();
    mended.fill(fields::BASELINE, note.fixes[0].entry.clone());
    assert_eq!(mended.assess().solution.problem.get(Field::Baseline), Some(1.695));
}

/// As it stands in papers and logs.
#[test]
fn a_sigma_behind_the_value_counts_and_moves_into_its_field() {
    for (field, text, value, sigma) in [
        (Field::Disparity, "50 ± 0.5", 50.0, 0.5),
        (Field::Disparity, "50±0.5 px", 50.0, 0.5),
        (Field::Disparity, "50 +/- 1 %", 50.0, 0.5),
        (Field::Baseline, "1.2 m ± 2 cm", 1.2, 0.02),
        (Field::Baseline, "120 ± 2 cm", 1.2, 0.02),
        (Field::Baseline, "(1.200 ± 0.016) m", 1.2, 0.016),
        (Field::Baseline, "120 ± 2", 0.12, 0.002),
        (Field::Baseline, "(0.5 ± 1 %) m", 0.5, 0.005),
        (Field::Disparity, "50 +- 0.5", 50.0, 0.5),
    ] {
        let mut inputs = with(field, text);
        for is_tidied in [false, true] {
            if is_tidied {
                inputs.tidy(field);
                assert!(!inputs.entry(field).text.contains('±'), "{text}");
            }
            let problem = inputs.assess().solution.problem;
            assert!((problem.get(field).unwrap() / value - 1.0).abs() < 1e-12, "{text}");
            assert!((problem.sigma(field) / sigma - 1.0).abs() < 1e-12, "{text}");
        }
    }
    let typing = with(Field::Disparity, "50 ±").assess();
    assert_eq!((typing.solution.problem.get(Field::Disparity), typing.notes.len()), (Some(50.0), 0));
    let mut twice = with(Field::Disparity, "50 ± 0.5");
    twice.set_sigma(Field::Disparity, "1");
    twice.tidy(Field::Disparity);
    // What was typed last.
    assert_eq!(
        (twice.entry(Field::Disparity).text.as_str(), twice.sigma(Field::Disparity)),
        ("50", "0.5")
    );
    let mut exact = Inputs::default();
    exact.entry_mut(fields::CX).text = "640 ± 1".into();
    assert!(exact.assess().note(fields::CX).unwrap().message().contains("is taken to be exact"));
}
