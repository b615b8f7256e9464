//! The form: what was typed, what it means, and what is said about it.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use depth_core::problem::{Field, Method, Outcome};
use depth_core::quantity::Length;
use depth_core::quantity::LengthUnit::{Centimeter, Meter, Millimeter};
use depth_text::entry::Entry;
use depth_text::fields;
use depth_text::form::{Example, Inputs};
use depth_text::note::{Note, Severity};

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
    assert_eq!(inputs.assess().length_unit(Field::Baseline, &inputs), Some(Centimeter));
    assert_eq!(inputs.assess().solution.problem.get(Field::Baseline), Some(0.1));
    inputs.tidy(Field::Baseline);
    assert_eq!(inputs.entry(Field::Baseline), &Entry::new("10", Some(Centimeter)));
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
    assert!(b.message().contains("mm, cm, m, in or ft"), "{}", b.message());
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
    assert!((found.value - 0.1).abs() < 1e-12, "{found:?}");
}
