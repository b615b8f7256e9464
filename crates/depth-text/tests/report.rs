//! The table of parameters, the answer strip and the line under a field say what the page says.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, missing_docs, reason = "tests")]

use depth_core::problem::Field;
use depth_core::quantity::LengthUnit;
use depth_text::field::Key;
use depth_text::form::Inputs;
use depth_text::report::{self, Tone};
use depth_text::sentences;
use proptest::prelude::*;

/// What is typed: a value with its σ a field, as `700 ± 2`.
fn form(fields: &[(&str, &str)]) -> Inputs {
    let mut inputs = Inputs::default();
    for (name, text) in fields {
        let key = Key::named(name).unwrap();
        inputs.entry_mut(key).text = (*text).to_owned();
        inputs.tidy(key);
    }
    inputs
}

/// 700 px ± 2, 100 mm ± 0.5, 50 px ± 0.5, 150 px ± 2, 0.30 m ± 0.01.
fn mug() -> Inputs {
    form(&[
        ("fx", "700 ± 2"),
        ("b", "100 ± 0.5"),
        ("d", "50 ± 0.5"),
        ("wimg", "150 ± 2"),
        ("wreal", "0.30 ± 0.01"),
    ])
}

#[test]
fn the_table_has_nine_rows_and_combined_with_their_sigmas() {
    let rows = report::parameter_rows(&mug().assess(), LengthUnit::Meter);
    let cells: Vec<String> = rows
        .iter()
        .map(|row| {
            let sigma = row.sigma.as_deref().unwrap_or_default();
            format!("{}|{}|{sigma}|{}|{}", row.label, row.value, row.symbol, row.description)
        })
        .collect();
    assert_eq!(
        cells,
        [
            "Focal length|700|2|px|camera, K[0][0]",
            "Camera baseline|100|0.5|mm|between the two lens centers",
            "Disparity|50|0.5|px|shift between the two images",
            "Object width in image|150|2|px|edge to edge, in the image",
            "Object real width|0.30|0.01|m|edge to edge, seen face on",
            "Estimated object width (pixels)|150.0|5.3|px|what b, d and w_real predict",
            "Estimated object width (meters)|0.3000|0.0052|m|what b, d and w_img predict",
            "Object distance (D, stereo)|1.400|0.016|m|fx · b / d",
            "Object distance (D, monocular)|1.400|0.050|m|w_real · fx / w_img",
            "Object distance (D, combined)|1.400|0.015|m|weights 91 : 9",
        ]
    );
    assert_eq!(rows.iter().position(|row| row.heading == Some(report::INTERMEDIATE)), Some(5));
    assert_eq!((rows[0].parameter.as_str(), rows[0].parameter_symbol), ("Focal length (fx)", "fx"));
    assert_eq!(
        (rows[1].tone, rows[3].tone, rows[9].tone),
        (Tone::Stereo, Tone::Monocular, Tone::Combined)
    );
}

#[test]
fn an_empty_table_has_its_rows_and_what_was_refused_stays_in_it() {
    let rows = report::parameter_rows(&Inputs::default().assess(), LengthUnit::Meter);
    assert_eq!(rows.len(), 10);
    assert!(rows.iter().all(|row| row.value == report::NONE && row.sigma.is_none()));
    let mut inputs = mug();
    inputs.entry_mut(Field::Disparity).text = "−12".into();
    let rows = report::parameter_rows(&inputs.assess(), LengthUnit::Meter);
    let values: Vec<&str> = rows.iter().map(|row| row.value.as_str()).collect();
    assert_eq!(values, ["700", "100", "−12", "150", "0.30", "–", "–", "–", "1.400", "–"]);
    assert_eq!(rows[9].description, "needs both distances");
}

#[test]
fn a_sigma_in_percent_or_in_another_unit_stands_in_that_of_its_value() {
    let inputs = form(&[("fx", "700 ± 1 %"), ("b", "10 cm ± 0.5 mm"), ("d", "50 ± 0.50")]);
    let rows = report::parameter_rows(&inputs.assess(), LengthUnit::Meter);
    let sigmas: Vec<_> = rows.iter().take(3).map(|row| row.sigma.as_deref().unwrap()).collect();
    assert_eq!(sigmas, ["7", "0.05", "0.50"]);
}

proptest! {
    #[test]
    fn shares_add_up_to_what_they_are_of(parts in proptest::collection::vec(0.0..1.0_f64, 1..7)) {
        let total: f64 = parts.iter().sum();
        prop_assume!(total > 0.0);
        let parts: Vec<f64> = parts.iter().map(|part| part / total).collect();
        let written = sentences::shares(&parts);
        let number = |text: &String| text.trim_end_matches(" %").parse::<f64>().unwrap_or(0.0);
        prop_assert_eq!(written.iter().map(number).sum::<f64>(), 100.0, "{:?}", written);
        for (text, part) in written.iter().zip(&parts) {
            prop_assert!((number(text) - part * 100.0).abs() < 5.0, "{} of {}", text, part);
            prop_assert!(!text.starts_with("0 ") || *part == 0.0, "{} of {}", text, part);
        }
    }
}
