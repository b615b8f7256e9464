//! What reading a form costs: `cargo bench -p depth-text`.
#![allow(missing_docs, reason = "a measurement")]

use depth_core::problem::Field;
use depth_text::field::Key;
use depth_text::fields::FLOOR_ANGLE;
use depth_text::form::{Example, Inputs};
use depth_text::number;
use divan::{Bencher, black_box};

fn main() {
    divan::main();
}

/// From the texts of the whole form to everything that is computed and said about them.
#[divan::bench]
fn assess_a_form(bencher: Bencher) {
    let inputs = form();
    bencher.bench(|| black_box(&inputs).assess());
}

/// The same with range, tilt and ground plane.
#[divan::bench]
fn assess_everything(bencher: Bencher) {
    let mut inputs = form();
    for key in Key::form().filter(|key| key.is_optional && *key != FLOOR_ANGLE) {
        inputs.entry_mut(key).text = key.example().to_owned();
    }
    let geometry = inputs.assess().geometry;
    assert!(geometry.point.is_some() && geometry.ground.is_some(), "everything is complete");
    bencher.bench(|| black_box(&inputs).assess());
}

/// 10 000 characters that look like numbers: refused in every field at once.
#[divan::bench(args = ["7", "1 ", "1,1.", "word ", "1/2 "])]
fn refuse_10_000_characters(bencher: Bencher, pattern: &str) {
    let text = pattern.repeat(10_000 / pattern.len());
    let mut inputs = Inputs::default();
    for key in Key::form() {
        inputs.entry_mut(key).text.clone_from(&text);
        inputs.entry_mut(key).sigma.clone_from(&text);
    }
    bencher.bench(|| {
        let assessment = black_box(&inputs).assess();
        assessment.notes.iter().map(|note| note.message().len()).sum::<usize>()
    });
}

#[divan::bench(args = ["7 ", "1/", "Q ", "[[1, "])]
fn refuse_a_q_matrix_of_10_000_characters(bencher: Bencher, pattern: &str) {
    let text = pattern.repeat(10_000 / pattern.len());
    bencher.bench(|| depth_text::q_matrix::read(black_box(&text)).is_ok());
}

fn form() -> Inputs {
    let mut inputs = Example::CoffeeMug.inputs();
    inputs.entry_mut(Field::ImageWidth).text = "150".into();
    inputs.entry_mut(Field::RealWidth).text = "0.3".into();
    for field in Field::ALL {
        inputs.set_sigma(field, "1 %");
    }
    assert!(inputs.assess().solution.comparison.is_some(), "the form is complete");
    inputs
}

#[divan::bench(args = ["700", "0,1", "10 cm", "1.234,5", "1,000", "twelve"])]
fn read_a_number(text: &str) -> bool {
    number::read(black_box(text), number::Primes::FeetAndInches).is_ok()
}
