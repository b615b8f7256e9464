//! What *Copy Results* puts on the clipboard.
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use depth_core::problem::{Field, Method};
use depth_core::quantity::LengthUnit;
use depth_core::setup::Object;
use depth_text::export::{Exporter as _, Results, Text};
use depth_text::field::Key;
use depth_text::form::{Example, Inputs};
use depth_text::report;
use depth_text::sentences::Statement;

fn form(fields: &[(&str, &str)]) -> Inputs {
    let mut inputs = Inputs::default();
    for (name, text) in fields {
        inputs.entry_mut(Key::named(name).unwrap()).text = (*text).to_owned();
    }
    inputs
}

fn copied(inputs: &Inputs, unit: LengthUnit) -> String {
    let assessment = inputs.assess();
    let Ok(text) = Text.export(&Results {
        inputs,
        assessment: &assessment,
        unit,
    });
    text
}

/// Fails unless `text` has these lines.
fn assert_lines(text: &str, lines: &[&str]) {
    for line in lines {
        assert!(text.lines().any(|one| one.trim() == *line), "{line:?} is not in\n{text}");
    }
}

#[test]
fn what_was_solved_for_is_a_result_and_the_distance_that_was_given_is_none() {
    let mut inputs = form(&[("fx", "700"), ("d", "50"), ("distance", "1.4")]);
    inputs.unknown = Some((Method::Stereo, Field::Baseline));
    let text = copied(&inputs, LengthUnit::Centimeter);
    assert_lines(
        &text,
        &[
            "Camera baseline (b): solved for",
            "Distance (D): 1.4 m",
            "Camera baseline (b) of the stereo distance: 10.00 cm",
        ],
    );
    assert!(!text.contains("Stereo distance, D"), "{text}");
}

#[test]
fn the_point_and_the_floor_are_results_with_their_inputs() {
    let mut inputs = Example::CoffeeMug.inputs();
    let more = [
        ("cx", "640"),
        ("cy", "360"),
        ("u", "1000"),
        ("v", "360"),
        ("camera-height", "1.2"),
        ("camera-pitch", "10"),
        ("floor-row", "500"),
        ("floor-column", "1100"),
    ];
    for (name, text) in more {
        inputs.entry_mut(Key::named(name).unwrap()).text = text.to_owned();
    }
    // Depth 1.4 m: X = 360·1.4/700, R = √(0.72² + 1.4²).
    assert_lines(
        &copied(&inputs, LengthUnit::Meter),
        &[
            "Column of the pixel (u): 1000 px",
            "Point in space, from the stereo distance",
            "X, to the right: 0.7200 m",
            "Z, depth along the axis: 1.400 m",
            "R, range from the lens: 1.574 m",
            "Ground plane",
            "Straight ahead: 3.076 m",
            "To the right: 2.128 m",
            "Along the floor: 3.740 m",
            "Slant, from the lens: 3.928 m",
        ],
    );
}

#[test]
fn a_tilt_is_in_the_distance_and_said() {
    let mut inputs = Example::Doorway.inputs();
    inputs.entry_mut(Field::Tilt).text = "60".to_owned();
    let text = copied(&inputs, LengthUnit::Meter);
    assert_lines(&text, &["Tilt of the target: 60°", "without the tilt: 4.275 m"]);
    assert!(text.contains("2.138 m (unrounded"), "{text}");
}

#[test]
fn a_refusal_is_said_once() {
    let mut inputs = Example::CoffeeMug.inputs();
    inputs.entry_mut(Field::Disparity).text = "0".to_owned();
    let text = copied(&inputs, LengthUnit::Meter);
    assert_eq!(text.matches("A disparity of zero means").count(), 1, "{text}");
    assert_lines(&text, &["Stereo distance, D = fx · b / d: none; see the note on the disparity"]);
    inputs.entry_mut(Field::Disparity).text.clear();
    assert_lines(&copied(&inputs, LengthUnit::Meter), &["Stereo distance, D = fx · b / d: needs d"]);
}

#[test]
fn nothing_speaks_of_a_width_where_a_height_is_measured() {
    let both = [
        ("fx", "700"),
        ("b", "100"),
        ("d", "50"),
        ("wimg", "150 ± 2"),
        ("wreal", "0.30 ± 0.01"),
        ("fy", "710"),
    ];
    let refused = [("fx", "700"), ("wimg", "-150"), ("wreal", "0")];
    for fields in [&both[..], &both[..4], &refused] {
        let inputs = Inputs {
            object: Object::Height,
            ..form(fields)
        };
        let assessment = inputs.assess();
        let suspects = assessment.suspects();
        let mut said = vec![copied(&inputs, LengthUnit::Meter)];
        said.extend(suspects.iter().map(|suspect| Statement::suspect(&assessment, suspect).to_string()));
        said.extend(inputs.missing().iter().map(|note| note.message()));
        said.push(Statement::widths(&assessment).to_string());
        said.extend(
            report::parameter_rows(&assessment, LengthUnit::Meter)
                .into_iter()
                .map(|row| format!("{} {}", row.parameter, row.description)),
        );
        said.extend(report::predicted(inputs.object));
        for text in said {
            assert!(!text.to_lowercase().contains("width"), "{text}");
        }
    }
}
