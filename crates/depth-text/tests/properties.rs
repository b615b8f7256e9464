//! Properties of what is read and written that hold for every text and number.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use depth_core::problem::Field;
use depth_generators::{any_magnitude, any_unit};
use depth_text::entry::Entry;
use depth_text::export::{Exporter as _, Results, Text};
use depth_text::field::Key;
use depth_text::fields::TABLE;
use depth_text::form::Inputs;
use depth_text::sentences::Statement;
use depth_text::{number, reading, report};
use proptest::prelude::*;

fn close(got: f64, expected: f64, relative: f64) -> bool {
    (got / expected - 1.0).abs() <= relative
}

/// Text that looks enough like numbers to reach every branch of the reader, and text that does not.
fn typed_text() -> impl Strategy<Value = String> {
    prop_oneof![
        "\\PC{0,24}",
        "[-+−]?[0-9]{0,5}[.,' ]?[0-9]{0,4}[.,' ]?[0-9]{0,4}([eE][-+−]?[0-9]{1,4})? ?(mm|cm|m|in|ft|px|'|\"|km)?",
        "(nan|inf|-inf|1e999|1e-999|0|-0|0,0|1,000|1.000|٣|½|NaN px)",
    ]
}

proptest! {
    /// Whatever is typed or stored: no panic, no NaN and no infinity in any text that is shown or copied.
    #[test]
    fn no_text_that_can_be_typed_shows_nan_or_infinity(
        texts in proptest::array::uniform10(typed_text()), baseline_unit in any_unit(), result_unit in any_unit(), steps in -20..20i32,
    ) {
        let mut inputs = Inputs::default();
        for (field, text) in Field::ALL.into_iter().zip(&texts) {
            *inputs.entry_mut(field) = Entry::new(text.clone(), Key::from(field).is_length().then_some(baseline_unit));
        }
        let assessment = inputs.assess();
        let rows = report::parameter_rows(&assessment, result_unit);
        let shown = rows.iter().map(|row| row.value.clone())
            .chain([report::length(assessment.solution.stereo.distance(), result_unit)])
            .chain(report::one_pixel_range(&assessment.solution, result_unit))
            .chain([Statement::widths(&assessment).to_string()]);
        for text in shown {
            prop_assert!(!text.contains("NaN") && !text.contains("inf"), "{text}");
        }
        for note in &assessment.notes {
            prop_assert!(note.message().ends_with(['.', '?']), "{}", note.message());
        }
        let _ = Text.export(&Results { inputs: &inputs, assessment: &assessment, unit: result_unit });
        for field in Field::ALL {
            inputs.step(field, steps);
            inputs.tidy(field);
        }
        let _ = (inputs.assess(), inputs.missing());
    }

    /// Every correction that a note offers is itself accepted without an error.
    #[test]
    fn corrections_correct(text in typed_text(), unit in any_unit()) {
        for field in Field::ALL {
            let mut inputs = Inputs::default();
            *inputs.entry_mut(field) = Entry::new(text.clone(), Key::from(field).is_length().then_some(unit));
            let Some(note) = inputs.assess().note(field).cloned() else { continue };
            // One that opens a helper leaves the rest to the person.
            for fix in note.fixes.iter().filter(|fix| fix.way.is_none()) {
                let mut fixed = inputs.clone();
                *fixed.entry_mut(field) = fix.entry.clone();
                let after = fixed.assess().note(field).cloned();
                prop_assert!(after.as_ref().is_none_or(|after| after.message() != note.message()), "{note:?} then {after:?}");
            }
        }
    }

    /// For every field: no text panics, and a σ that was typed is either used or a note.
    #[test]
    fn no_sigma_is_dropped(text in typed_text(), sigma in typed_text()) {
        for &key in TABLE {
            let entry = Entry { sigma: sigma.clone(), ..Entry::new(text.clone(), None) };
            if let Ok(Some(reading)) = reading::read_with_sigma(key, &entry) {
                prop_assert_eq!(reading.sigma.is_none(), entry.sigma_text().is_empty(), "{:?} {:?}", key, entry);
                prop_assert!(reading.value.is_finite());
            }
        }
    }

    #[test]
    fn what_is_written_with_four_digits_reads_back_to_four_digits(value in any_magnitude()) {
        let text = number::significant(value, 4);
        prop_assert!(close(number::read(&text, number::Primes::FeetAndInches).unwrap().number, value, 6e-4), "{text}");
        prop_assert_eq!(number::read(&number::exact(value), number::Primes::FeetAndInches).unwrap().number, value);
    }
}
