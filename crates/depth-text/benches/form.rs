//! What reading a form costs: `cargo bench -p depth-text`.
#![allow(missing_docs, reason = "a measurement")]

use depth_core::problem::Field;
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

fn form() -> Inputs {
    let mut inputs = Example::CoffeeMug.inputs();
    inputs.entry_mut(Field::ImageWidth).text = "150".into();
    inputs.entry_mut(Field::RealWidth).text = "0.3".into();
    inputs.with_uncertainty = true;
    for field in Field::ALL {
        inputs.set_sigma(field, "1 %");
    }
    assert!(inputs.assess().solution.comparison.is_some(), "the form is complete");
    inputs
}

#[divan::bench(args = ["700", "0,1", "10 cm", "1.234,5", "1,000", "twelve"])]
fn read_a_number(text: &str) -> bool {
    number::read(black_box(text)).is_ok()
}
