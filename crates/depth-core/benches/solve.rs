//! What the mathematics costs: `cargo bench -p depth-core`.
#![allow(clippy::unwrap_used, missing_docs, reason = "a measurement")]

use depth_core::measured::Measured;
use depth_core::monte_carlo::MonteCarlo;
use depth_core::problem::{Field, Problem};
use depth_core::uncertainty::Model;
use divan::{AllocProfiler, Bencher, black_box, counter::ItemsCount};

/// Shows what is allocated beside the time.
#[global_allocator]
static ALLOCATIONS: AllocProfiler = AllocProfiler::system();

fn main() {
    divan::main();
}

/// The stereo example with both methods complete.
fn problem() -> Problem {
    let mut problem = Problem::default();
    for (field, value) in [
        (Field::FocalLength, 700.0),
        (Field::Baseline, 0.1),
        (Field::Disparity, 50.0),
        (Field::ImageWidth, 150.0),
        (Field::RealWidth, 0.3),
    ] {
        problem.set(field, Some(value));
    }
    problem
}

#[divan::bench]
fn solve_without_sigma(bencher: Bencher) {
    let problem = problem();
    assert!(
        problem.solve().monocular_uncertainty.is_none(),
        "nothing is known about the uncertainty"
    );
    bencher.bench(|| black_box(&problem).solve());
}

#[divan::bench]
fn solve_with_sigma(bencher: Bencher) {
    let mut problem = problem();
    for field in Field::ALL {
        problem.set_sigma(field, problem.get(field).map_or(0.0, |value| 0.01 * value));
    }
    assert!(problem.solve().comparison.is_some(), "both methods have an uncertainty");
    bencher.bench(|| black_box(&problem).solve());
}

/// The two distances disagree.
#[divan::bench]
fn solve_with_sigma_and_disagree(bencher: Bencher) {
    let mut problem = problem();
    problem.set(Field::RealWidth, Some(0.9));
    for field in Field::ALL {
        problem.set_sigma(field, problem.get(field).map_or(0.0, |value| 0.01 * value));
    }
    bencher.bench(|| black_box(&problem).solve());
}

const DRAWS: u32 = 10_000;

fn model() -> Model {
    let exact = Measured::from_base(0.0, 0.0);
    Model::stereo(
        Measured::from_base(700.0, 5.0),
        Measured::from_base(0.1, 1e-3),
        Measured::from_base(50.0, 0.5),
        exact,
    )
    .unwrap()
}

/// The counter gives draws per second.
#[divan::bench]
fn monte_carlo_draws(bencher: Bencher) {
    bencher
        .counter(ItemsCount::new(DRAWS))
        .with_inputs(|| MonteCarlo::new(model(), 1))
        .bench_values(|mut experiment| {
            experiment.draw(DRAWS);
            experiment
        });
}

/// The last piece of the largest experiment that the program makes, and what all of it shows.
#[divan::bench(sample_count = 20)]
fn monte_carlo_last_of_100_000(bencher: Bencher) {
    let mut experiment = MonteCarlo::new(model(), 1);
    experiment.draw(95_000);
    bencher.with_inputs(|| experiment.clone()).bench_values(|mut experiment| {
        experiment.draw(5_000);
        experiment.distribution()
    });
}
