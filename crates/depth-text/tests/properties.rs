//! Properties of what is read and written that hold for every text and number.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, missing_docs, reason = "tests")]

use depth_core::problem::{Field, Method};
use depth_core::quantity::LengthUnit;
use depth_core::setup::{Object, Pair};
use depth_generators::{any_magnitude, any_unit};
use depth_text::entry::Entry;
use depth_text::export::{Exporter as _, Provenance, Results, Text};
use depth_text::field::Key;
use depth_text::fields::TABLE;
use depth_text::form::Inputs;
use depth_text::report::{Mode, Shown, Strip};
use depth_text::sentences::Statement;
use depth_text::{fields, link, number, reading, report};
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

/// What can be read: numbers as people type them, some with a unit.
fn typed_value() -> impl Strategy<Value = String> {
    prop_oneof![
        Just(String::new()),
        "[-−]?[1-9][0-9]{0,3}([.,][0-9]{1,2})?",
        "[1-9][0-9]{0,3}( ?(mm|cm|m|in|ft|px|°|mrad))",
        "(1/3|1 1/8 in|5'11\"|2 × 10⁻³|1\\.695 squares of 23\\.6 mm|1° 30′)",
    ]
}

/// The same for a σ.
fn typed_sigma() -> impl Strategy<Value = String> {
    prop_oneof![Just(String::new()), "0\\.[0-9]{1,3}", "[1-9] ?%", "[1-9](\\.5)? ?(mm|cm|m|px|°)"]
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
        let _ = Text.export(&Results { inputs: &inputs, assessment: &assessment, unit: result_unit, provenance: Provenance::default() });
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

    /// Whatever is typed into any field, whatever is asked for: three cells without NaN, infinity and a minus of a typewriter.
    #[test]
    fn the_strip_shows_no_nan_whatever_is_typed(
        texts in proptest::collection::vec((0..50usize, prop_oneof![typed_value(), typed_text()], prop_oneof![typed_sigma(), typed_text()]), 0..16),
        unknown in proptest::option::of((0..2usize, 0..4usize)), result_unit in any_unit(),
    ) {
        let unknown = unknown.and_then(|(method, field)| Some((Method::ALL[method], Method::ALL[method].unknowns().nth(field)?)));
        let mut inputs = Inputs { unknown, ..Inputs::default() };
        let was = inputs.assess();
        let keys: Vec<Key> = Key::form().chain([fields::DISTANCE]).collect();
        for (at, text, sigma) in texts {
            *inputs.entry_mut(keys[at % keys.len()]) = Entry { sigma, ..Entry::new(text, None) };
        }
        let assessment = inputs.assess();
        let shown = Shown { inputs: &inputs, assessment: &assessment, unit: result_unit, was: Some(&was) };
        for mode in Mode::ALL {
            for cell in Strip::new(mode, &shown).cells {
                let computed = cell.value.text();
                prop_assert!(!computed.contains("NaN") && !computed.contains("inf ") && !computed.contains('-'), "{cell:?}");
                prop_assert!(!cell.lines.iter().flat_map(|line| &line.parts).any(|part| part.text().is_empty()), "{cell:?}");
            }
        }
        for key in keys {
            prop_assert!(!report::field_line(key, assessment.reading(key)).is_empty());
        }
    }

    /// A link that is opened again loses nothing of what can be read.
    #[test]
    fn a_link_fills_in_the_form_that_it_was_made_of(
        texts in proptest::collection::vec((0..50usize, typed_value(), typed_sigma(), proptest::option::of(any_unit())), 0..12),
        (object, pair) in (proptest::sample::select(Object::ALL.to_vec()), proptest::sample::select(Pair::ALL.to_vec())),
        unknown in proptest::option::of((0..2usize, 0..4usize)), result_unit in any_unit(),
    ) {
        let unknown = unknown.and_then(|(method, field)| {
            let method = Method::ALL[method];
            Some((method, method.unknowns().nth(field)?))
        });
        let mut inputs = Inputs { object, pair, unknown, ..Inputs::default() };
        let keys: Vec<Key> = Key::form().chain([fields::DISTANCE]).collect();
        for (at, text, sigma, unit) in texts {
            let key = keys[at % keys.len()];
            // Beside a unit that stays in the text there is nothing to choose.
            let has_choice = !text.is_empty() && !text.contains(|c: char| c.is_alphabetic() || "'′°".contains(c));
            let unit = unit.filter(|_| key.is_length() && has_choice);
            let sigma = if key.has_sigma { sigma } else { String::new() };
            *inputs.entry_mut(key) = Entry { sigma, ..Entry::new(text, unit) };
            inputs.tidy(key);
        }
        let fragment = link::fragment(&inputs, result_unit);
        let mut back = Inputs::default();
        link::apply(&fragment, &mut back);
        prop_assert_eq!(&back, &inputs, "{}", fragment);
        prop_assert_eq!(link::result_unit(&fragment).unwrap_or(LengthUnit::Meter), result_unit);
        let sigmas = |inputs: &Inputs| inputs.assess().readings.iter().map(|reading| (reading.value, reading.sigma)).collect::<Vec<_>>();
        prop_assert_eq!(sigmas(&back), sigmas(&inputs));
    }

    #[test]
    fn what_is_written_with_four_digits_reads_back_to_four_digits(value in any_magnitude()) {
        let text = number::significant(value, 4);
        prop_assert!(close(number::read(&text, number::Primes::FeetAndInches).unwrap().number, value, 6e-4), "{text}");
        prop_assert_eq!(number::read(&number::exact(value), number::Primes::FeetAndInches).unwrap().number, value);
    }
}
