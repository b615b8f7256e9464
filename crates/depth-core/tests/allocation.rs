//! Solving allocates nothing, so that a million problems can be solved in a row.
#![allow(clippy::unwrap_used, reason = "tests")]

use depth_core::problem::{Field, Problem};

/// Two cameras and an object of known width, every input with its σ.
fn everything() -> Problem {
    let mut problem = Problem::default();
    for (field, value, sigma) in [
        (Field::FocalLength, 700.0, 2.0),
        (Field::Baseline, 0.1, 0.0005),
        (Field::Disparity, 50.0, 0.5),
        (Field::Doffs, 3.0, 0.1),
        (Field::ImageWidth, 150.0, 2.0),
        (Field::RealWidth, 0.6, 0.01),
    ] {
        problem.set(field, Some(value));
        problem.set_sigma(field, sigma);
    }
    problem
}

#[test]
fn solving_a_problem_with_everything_given_allocates_nothing() {
    let mut problem = everything();
    // 0.6 m contradict the stereo distance, 0.3 m do not.
    for (width, is_combined) in [(0.3, true), (0.6, false)] {
        problem.set(Field::RealWidth, Some(width));
        let mut solution = None;
        let counted = allocation_counter::measure(|| solution = Some(std::hint::black_box(&problem).solve()));
        let solution = solution.unwrap();
        assert_eq!(solution.combined.is_some(), is_combined);
        assert!(solution.comparison.is_some(), "both methods have an answer");
        assert_eq!(counted.count_total, 0, "{counted:?}");
    }
    let solution = problem.solve();
    // The counter counts: what is worked out on demand is a list.
    let counted = allocation_counter::measure(|| assert!(!solution.suspects().is_empty()));
    assert!(counted.count_total > 0, "{counted:?}");
}
