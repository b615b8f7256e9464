//! What *Copy Results* puts on the clipboard.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, missing_docs, reason = "tests")]

use depth_core::problem::{Field, Method};
use depth_core::quantity::LengthUnit;
use depth_core::setup::Object;
use depth_text::export::{Exporter as _, Provenance, Results, Text};
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
        provenance: Provenance {
            version: "0.1.0",
            date: "November 25, 2026",
            link: "https://example.org/#fx=700",
        },
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
fn the_answer_comes_first_and_can_be_quoted_as_it_stands() {
    let mut inputs = form(&[
        ("fx", "700 ± 2"),
        ("b", "100 ± 0.5"),
        ("d", "50 ± 0.5"),
        ("wimg", "150 ± 2"),
        ("wreal", "0.30 m ± 1 cm"),
    ]);
    for key in Key::form() {
        inputs.tidy(key);
    }
    let text = copied(&inputs, LengthUnit::Meter);
    let lines: Vec<&str> = text.lines().collect();
    assert_eq!(
        lines[..3],
        [
            "Stereo: (1.400 ± 0.016) m (k = 1), D = fx·b/d, fx = (700 ± 2) px, b = (100 ± 0.5) mm, d = (50 ± 0.5) px",
            "Monocular: (1.400 ± 0.050) m (k = 1), D = w_real·fx/w_img, fx = (700 ± 2) px, w_img = (150 ± 2) px, w_real = (0.30 ± 0.01) m",
            "Combined: (1.400 ± 0.015) m (k = 1), the shared focal length accounted for. Stereo and monocular agree within their uncertainties (0 σ apart).",
        ]
    );
    assert_lines(
        &text,
        &[
            "D = 700 px · 100 mm / 50 px = 1.400 m",
            "1 σ interval: 1.384…1.416 m",
            "variance: disparity 75 %, baseline 19 %, focal length 6 %",
            "Parameter\tValue\t± 1 σ\tUnit\tDescription",
            "Camera baseline (b)\t100\t0.5\tmm\tbetween the two lens centers",
            "Object distance (D, combined)\t1.400\t0.015\tm\tweights 91 : 9",
        ],
    );
    assert_eq!(
        lines[lines.len() - 2..],
        ["Depth Calculator 0.1.0, November 25, 2026", "https://example.org/#fx=700"]
    );
    assert!(!text.contains("unrounded"), "{text}");
}

#[test]
fn a_spreadsheet_reads_the_numbers_of_the_table() {
    let inputs = form(&[("fx", "70000"), ("b", "10 m"), ("d", "50"), ("doffs", "-1"), ("wimg", "abc")]);
    let text = copied(&inputs, LengthUnit::Meter);
    let cells = |name: &str| -> Vec<String> {
        let row = text
            .lines()
            .find(|line| line.starts_with(name))
            .unwrap_or_else(|| panic!("{name} is not in\n{text}"));
        row.split('\t').map(str::to_owned).collect()
    };
    assert_eq!(cells("Object distance (D, stereo)")[1], "14290");
    assert_eq!(cells("Principal point offset (doffs)")[1], "-1");
    assert_eq!(cells("Object width in image (w_img)")[1], "“abc” (not usable)");
    assert!(!text.contains("Object distance (D, monocular)"), "{text}");
}

#[test]
fn what_was_solved_for_is_a_result_and_the_distance_that_was_given_is_none() {
    let mut inputs = form(&[("fx", "700"), ("d", "50"), ("distance", "1.4")]);
    inputs.unknown = Some((Method::Stereo, Field::Baseline));
    let text = copied(&inputs, LengthUnit::Centimeter);
    assert_lines(
        &text,
        &[
            "Camera baseline: 10.00 cm, b = D·d/fx, fx = 700 px, d = 50 px, D = 1.4 m",
            "Distance (D)\t1.4\t\tm\talong the axis, from the lens",
        ],
    );
    assert!(!text.contains("Stereo: "), "{text}");
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
            "Column of the pixel (u)\t1000\t\tpx\tfrom the left edge",
            "Point in space, from the stereo distance",
            "X, to the right: 0.7200 m",
            "Z, depth along the axis: 1.400 m",
            "R, range from the lens: 1.574 m",
            "Ground plane: straight ahead 3.076 m, to the right 2.128 m, along the floor 3.740 m, slant, from the lens 3.928 m, depth, from the lens 3.238 m, fx = 700 px, cx = 640 px, cy = 360 px, H = 1.2 m, θ = 10°, v = 500 px, u = 1100 px",
        ],
    );
}

#[test]
fn a_tilt_is_in_the_distance_and_said() {
    let mut inputs = Example::Doorway.inputs();
    inputs.entry_mut(Field::Tilt).text = "60".to_owned();
    let text = copied(&inputs, LengthUnit::Meter);
    assert_lines(
        &text,
        &[
            "Monocular: 2.138 m, D = w_real·cos φ·fx/w_img, fx = 950 px, w_img = 200 px, w_real = 0.9 m, φ = 60°",
            "without the tilt: 4.275 m",
            "Tilt of the target\t60\t\t°\t0° is facing the camera",
        ],
    );
}

#[test]
fn a_refusal_is_said_once() {
    let mut inputs = Example::CoffeeMug.inputs();
    inputs.entry_mut(Field::Disparity).text = "0".to_owned();
    let text = copied(&inputs, LengthUnit::Meter);
    assert_eq!(text.matches("A disparity of zero means").count(), 1, "{text}");
    assert_lines(&text, &["Stereo: none; see the note on the disparity"]);
    inputs.entry_mut(Field::Disparity).text.clear();
    assert_lines(&copied(&inputs, LengthUnit::Meter), &["Stereo: needs d"]);
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
            assert!(!text.to_ascii_lowercase().contains("width"), "{text}");
        }
    }
}
