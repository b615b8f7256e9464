//! From a keystroke to its answer: the shortest of many runs, which a busy machine hardly changes. The figures themselves are those
//! of `cargo bench -p depth-text`; without optimization, as here, everything takes about twenty times as long.
#![allow(missing_docs, reason = "tests")]

use depth_text::field::Key;
use depth_text::form::{Example, Inputs};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// The shortest of so many runs.
fn shortest(runs: u32, mut work: impl FnMut()) -> Duration {
    let run = |_| {
        let start = Instant::now();
        work();
        start.elapsed()
    };
    (0..runs).map(run).min().unwrap_or_default()
}

/// At most 1 ms: that is a sixteenth of a frame.
#[test]
fn a_keystroke_has_its_answer_within_a_millisecond() {
    let mut inputs = Example::CoffeeMug.inputs();
    for key in Key::form() {
        inputs.entry_mut(key).text = key.example().to_owned();
        inputs.set_sigma(key, "1 %");
    }
    let time = shortest(300, || {
        black_box(black_box(&inputs).assess());
    });
    assert!(time < Duration::from_millis(1), "{time:?}");
}

/// 5 ms with optimization; a scanner without it takes twenty times as long.
const Q_MATRIX_MS: u64 = if cfg!(debug_assertions) { 100 } else { 5 };

/// At most 5 ms, in every field and in that of a matrix.
#[test]
fn ten_thousand_characters_are_refused_within_five_milliseconds() {
    for pattern in ["7", "1 ", "1,1.", "word ", "1/2 ", "±", "1 ± ", "Q ", "[[1, "] {
        let text = pattern.repeat(10_000 / pattern.len());
        let mut inputs = Inputs::default();
        for key in Key::form() {
            inputs.entry_mut(key).text.clone_from(&text);
            inputs.entry_mut(key).sigma.clone_from(&text);
        }
        let time = shortest(20, || {
            let assessment = black_box(&inputs).assess();
            black_box(assessment.notes.iter().map(|note| note.message().len()).sum::<usize>());
        });
        assert!(time < Duration::from_millis(5), "{pattern:?} in every field: {time:?}");
        let time = shortest(20, || {
            black_box(depth_text::q_matrix::read(black_box(&text)).is_ok());
        });
        assert!(time < Duration::from_millis(Q_MATRIX_MS), "{pattern:?} as a matrix: {time:?}");
    }
}
