//! Random draws against exact distributions; tolerances are four standard deviations of the number of draws.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{NO_DOFFS, disparity_only, exact_cameras, mug};
use depth_core::measured::Measured;
use depth_core::monte_carlo::{BINS, Distribution, MonteCarlo};
use depth_core::quantity::Length;
use depth_core::uncertainty::Model;
use depth_generators::any_measured;
use proptest::prelude::*;

const DRAWS: u32 = 200_000;

fn distribution(model: Model) -> Distribution {
    let mut experiment = MonteCarlo::new(model, 2026);
    experiment.draw(DRAWS);
    experiment.distribution()
}

/// Checks a quantile of Z = k/x by the normal quantile of x that it must be: `z` standard deviations above the mean.
fn assert_quantile(found: Option<Length>, z: f64, probability: f64, sigma: f64) {
    let x = 70.0 / found.unwrap().m();
    let density = (-z * z / 2.0).exp() / (2.0 * std::f64::consts::PI).sqrt();
    let deviation = (probability * (1.0 - probability) / f64::from(DRAWS)).sqrt() / density;
    let found = (50.0 - x) / sigma;
    assert!((found - z).abs() < 4.0 * deviation, "{found} is not {z} ± {deviation}");
}

#[test]
fn quantiles_of_the_distance_are_those_of_the_normal_disparity() {
    for sigma in [0.5, 5.0, 20.0] {
        let found = distribution(disparity_only(50.0, sigma));
        assert_quantile(found.median, 0.0, 0.5, sigma);
        assert_quantile(found.interval_68.near, -1.0, 0.158_66, sigma);
        assert_quantile(found.interval_68.far, 1.0, 0.841_34, sigma);
        assert_quantile(found.interval_95.near, -1.959_96, 0.025, sigma);
        assert_quantile(found.interval_95.far, 1.959_96, 0.975, sigma);
    }
}

#[test]
fn draws_without_a_disparity_count_as_infinitely_far() {
    // Φ(−1.5) of the draws have d ≤ 0.
    let expected = 0.066_807_201;
    let found = distribution(disparity_only(50.0, 50.0 / 1.5));
    let deviation = (expected * (1.0 - expected) / f64::from(DRAWS)).sqrt();
    assert!(
        (found.share_infinite - expected).abs() < 4.0 * deviation,
        "{}",
        found.share_infinite
    );
    assert!(found.interval_68.far.is_some());
    assert_eq!(found.interval_95.far, None);
    assert!(found.interval_95.near.is_some() && found.median.is_some());
    assert_eq!(found.drawn, DRAWS);
}

#[test]
fn a_width_of_zero_pixels_counts_as_infinitely_far_too() {
    let model = Model::monocular(
        Measured::from_base(700.0, 0.0),
        Measured::from_base(0.3, 0.0),
        Measured::from_base(2.0, 2.0),
    );
    let found = distribution(model.unwrap());
    let (expected, deviation) = (0.158_655, (0.158_655 * 0.841_345 / f64::from(DRAWS)).sqrt());
    assert!(
        (found.share_infinite - expected).abs() < 4.0 * deviation,
        "{}",
        found.share_infinite
    );
}

#[test]
fn draws_with_an_impossible_length_count_as_distance_zero() {
    let half = Measured::from_base(0.1, 0.05);
    let model = Model::stereo(Measured::from_base(700.0, 0.0), half, Measured::from_base(50.0, 0.0), NO_DOFFS);
    let found = distribution(model.unwrap());
    // Φ(−2)
    let (expected, deviation) = (0.022_750, (0.022_750 * 0.977_25 / f64::from(DRAWS)).sqrt());
    assert!((found.share_zero - expected).abs() < 4.0 * deviation, "{}", found.share_zero);
    assert_eq!(found.share_infinite, 0.0);
    // The quantiles stay those of b: the median at the value, 68 % at half and one and a half times it.
    for (found, expected, sigmas) in [
        (found.median, 1.4, 0.00280),
        (found.interval_68.near, 0.7, 0.00338),
        (found.interval_68.far, 2.1, 0.00338),
    ] {
        // √(p(1−p)/n)/φ of σ = 0.7 m.
        assert!((found.unwrap().m() - expected).abs() < 4.0 * sigmas * 0.7, "{found:?}");
    }
}

#[test]
fn the_mug_has_the_interval_that_the_formula_gives() {
    let found = distribution(mug());
    // σ of the quantile: √(0.1335/n)/0.242 = 0.0034 σ of 16 mm, which is 54 µm; of the median 45 µm.
    assert!((found.interval_68.near.unwrap().m() - 1.3840).abs() < 4.0 * 54e-6 + 50e-6);
    assert!((found.interval_68.far.unwrap().m() - 1.4163).abs() < 4.0 * 54e-6 + 50e-6);
    assert!((found.median.unwrap().m() - 1.4).abs() < 4.0 * 45e-6);
    assert_eq!((found.share_infinite, found.share_zero), (0.0, 0.0));
}

#[test]
fn doffs_and_its_uncertainty_take_part() {
    let model = exact_cameras(Measured::from_base(10.0, 3.0), Measured::from_base(40.0, 4.0));
    // Together 50 ± 5 px, as above.
    assert_quantile(distribution(model).interval_68.far, 1.0, 0.841_34, 5.0);
}

#[test]
fn exact_inputs_give_one_distance() {
    let found = distribution(disparity_only(50.0, 0.0));
    let only = Some(Length::from_m(1.4));
    assert_eq!((found.interval_95.near, found.median, found.interval_95.far), (only, only, only));
    let histogram = found.histogram.unwrap();
    assert_eq!(histogram.counts, [DRAWS]);
}

#[test]
fn the_draws_do_not_depend_on_how_they_are_cut_up() {
    let mut whole = MonteCarlo::new(mug(), 7);
    whole.draw(10_000);
    let mut pieces = MonteCarlo::new(mug(), 7);
    for piece in [1, 999, 0, 4000, 5000] {
        pieces.draw(piece);
    }
    assert_eq!(pieces.drawn(), 10_000);
    assert_eq!(whole.distribution(), pieces.distribution());
    let mut other = MonteCarlo::new(mug(), 8);
    other.draw(10_000);
    assert_ne!(whole.distribution(), other.distribution(), "another seed draws other numbers");
}

#[test]
fn the_draws_are_the_same_to_the_last_bit_on_every_platform() {
    let mut experiment = MonteCarlo::new(disparity_only(50.0, 20.0), 1);
    experiment.draw(100_000);
    let found = experiment.distribution();
    let bits = [found.interval_68.near, found.median, found.interval_68.far].map(|z| z.unwrap().m().to_bits());
    // What x86-64 Linux gave; WebAssembly gives the same.
    assert_eq!(bits, GOLDEN);
}

const GOLDEN: [u64; 3] = [4_607_178_851_000_419_253, 4_608_983_108_259_789_326, 4_612_416_381_596_531_254];

#[test]
fn nothing_is_drawn_before_the_first_draw() {
    let found = MonteCarlo::new(mug(), 1).distribution();
    assert_eq!((found.drawn, found.median, found.histogram), (0, None, None));
    assert_eq!((found.share_infinite, found.share_zero), (0.0, 0.0));
}

#[test]
fn a_long_far_side_does_not_flatten_the_histogram() {
    let found = distribution(disparity_only(50.0, 25.0));
    let histogram = found.histogram.unwrap();
    assert_eq!(histogram.counts.len(), usize::try_from(BINS).unwrap());
    let highest = histogram.counts.iter().copied().max().unwrap();
    let of_all = f64::from(histogram.counts.iter().sum::<u32>());
    assert!(f64::from(highest) < 0.1 * of_all, "a bin is a tenth of all: too coarse");
    assert!(of_all > 0.9 * f64::from(DRAWS), "most draws are shown");
    assert!(f64::from(histogram.beyond) >= found.share_infinite * f64::from(DRAWS));
}

/// Not a check but a figure: `cargo test --release -p depth-core --test monte_carlo -- --ignored --nocapture`.
#[test]
#[ignore = "prints a speed"]
fn speed() {
    let draws = 2_000_000;
    let mut experiment = MonteCarlo::new(mug(), 1);
    let start = std::time::Instant::now();
    experiment.draw(draws);
    let drawn = start.elapsed();
    let median = experiment.distribution().median;
    let finished = start.elapsed() - drawn;
    let per_draw = |time: std::time::Duration| time.as_secs_f64() * 1e9 / f64::from(draws);
    println!(
        "{:.1} ns per draw, {:.1} ns per draw to finish; median {median:?}",
        per_draw(drawn),
        per_draw(finished)
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(500))]

    #[test]
    fn every_draw_is_counted_and_every_result_finite_at_every_magnitude(
        f in any_measured(), b in any_measured(), d in any_measured(), seed: u64,
    ) {
        let Ok(model) = Model::stereo(f, b, d, NO_DOFFS) else { return Ok(()) };
        let mut experiment = MonteCarlo::new(model, seed);
        experiment.draw(300);
        let found = experiment.distribution();
        let ends = [
            found.interval_95.near, found.interval_68.near, found.median, found.interval_68.far, found.interval_95.far,
        ];
        prop_assert!(ends.iter().flatten().all(|end| end.m().is_finite() && end.m() >= 0.0));
        // In order, with whatever is infinite at the end.
        let in_order = ends.windows(2).all(|pair| match (pair[0], pair[1]) {
            (Some(nearer), Some(farther)) => nearer <= farther,
            (None, Some(_)) => false,
            (_, None) => true,
        });
        prop_assert!(in_order, "{:?}", ends);
        prop_assert_eq!(found.drawn, 300);
        if let Some(histogram) = found.histogram {
            let all = histogram.below + histogram.counts.iter().sum::<u32>() + histogram.beyond;
            prop_assert_eq!(all, 300);
            prop_assert!(histogram.low <= histogram.high && histogram.high.m().is_finite());
        } else {
            prop_assert_eq!(found.share_infinite, 1.0);
        }
    }
}
