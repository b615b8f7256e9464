//! Two distances together: golden figures, the table of special cases, simulated errors, and each typical blunder.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{NO_DOFFS, assert_near};
use depth_core::agreement::{Comparison, Suspect, Verdict, combine, suspects};
use depth_core::field::Field;
use depth_core::measured::Measured;
use depth_core::quantity::{Length, LengthUnit, Pixels, Quantity};
use depth_core::uncertainty::Model;
use depth_generators::{any_magnitude, any_relative_sigma};
use proptest::prelude::*;

fn stereo(f: Measured<Pixels>, b: Measured<Length>, d: Measured<Pixels>) -> Model {
    Model::stereo(f, b, d, NO_DOFFS).unwrap()
}

fn monocular(f: Measured<Pixels>, w: Measured<Length>, p: Measured<Pixels>) -> Model {
    Model::monocular(f, w, p).unwrap()
}

const F: Measured<Pixels> = Measured::new(Pixels::new(700.0), Pixels::new(2.0));
const B: Measured<Length> = Measured::new(Length::from_m(0.1), Length::from_m(0.0005));
const D: Measured<Pixels> = Measured::new(Pixels::new(50.0), Pixels::new(0.5));
const W: Measured<Length> = Measured::new(Length::from_m(0.30), Length::from_m(0.01));
const P: Measured<Pixels> = Measured::new(Pixels::new(150.0), Pixels::new(2.0));

/// Two models of a distance each, with the relative σ that they have of their own and the one that they share.
fn pair(z: [f64; 2], r: [f64; 2], rf: f64) -> (Model, Model) {
    let f = Measured::from_base(1.0, rf);
    (
        stereo(f, Measured::from_base(z[0], z[0] * r[0]), Measured::from_base(1.0, 0.0)),
        monocular(f, Measured::from_base(z[1], z[1] * r[1]), Measured::from_base(1.0, 0.0)),
    )
}

#[test]
fn the_two_distances_of_the_mug_together_are_1400_mm_give_or_take_15() {
    let combined = combine(&stereo(F, B, D), &monocular(F, W, P)).unwrap();
    assert_near(combined.value.m(), 1.4, 1e-12);
    assert_near(combined.sigma.m(), 0.01547, 5e-6);
}

#[test]
fn the_combination_stays_between_where_the_optimal_weights_do_not() {
    // Peelle's puzzle: with the covariance in the weights these two give 1.315.
    let (first, second) = pair([1.4, 1.7], [0.1, 0.3], 0.5);
    let combined = combine(&first, &second).unwrap();
    // By hand: weights 0.9 and 0.1 of the logarithms.
    assert_near(combined.value.m(), 1.4_f64.powf(0.9) * 1.7_f64.powf(0.1), 1e-12);
    assert_near(combined.relative(), (0.009_f64 + 0.25).sqrt(), 1e-12);
}

#[test]
fn a_distance_without_uncertainty_of_its_own_cannot_be_weighed() {
    for r in [[0.0, 0.1], [0.1, 0.0], [0.0, 0.0]] {
        let (first, second) = pair([1.4, 1.7], r, 0.05);
        assert_eq!(combine(&first, &second), None, "{r:?}");
        let comparison = Comparison::of(&first, &second);
        assert_eq!(comparison.agreement, None, "{r:?}");
        assert_near(comparison.ratio.unwrap(), 14.0 / 17.0, 1e-15);
    }
}

/// By hand: r 3 % and 4 % make a z of ln(Z₁/Z₂)/5 % and, combined, 2.4 %, times z where that is above 1.
#[test]
fn what_differs_by_more_than_its_sigma_has_a_larger_one_and_beyond_three_there_is_nothing_to_combine() {
    for (z, widened) in [(0.5, 1.0), (1.0, 1.0), (1.5, 1.5), (2.5, 2.5), (2.999, 2.999)] {
        let (first, second) = pair([(0.05_f64 * z).exp(), 1.0], [0.03, 0.04], 0.1);
        let combined = combine(&first, &second).unwrap();
        let expected = ((0.024 * widened) * (0.024 * widened) + 0.01_f64).sqrt();
        assert_near(combined.relative(), expected, 1e-9);
        // The weights stay: 0.64 and 0.36 of the logarithms.
        assert_near(combined.value.m(), (0.05 * z * 0.64).exp(), 1e-12);
    }
    let (first, second) = pair([(0.05_f64 * 3.001).exp(), 1.0], [0.03, 0.04], 0.1);
    assert_eq!(combine(&first, &second), None);
}

#[test]
fn distances_that_contradict_each_other_are_not_combined_whatever_has_a_sigma() {
    for r in [[0.005, 0.007], [0.0, 0.3], [0.3, 0.0], [0.0, 0.0]] {
        let (first, second) = pair([1.4, 14.0], r, 0.05);
        assert_eq!(combine(&first, &second), None, "{r:?}");
        assert!(Comparison::of(&first, &second).contradict(), "{r:?}");
        let blunders = suspects(&first, &second);
        assert!(
            blunders.iter().any(|suspect| matches!(suspect, Suspect::Unit { .. })),
            "{r:?}: {blunders:?}"
        );
    }
    let (first, second) = pair([1.4, 1.5], [0.0, 0.0], 0.05);
    assert!(!Comparison::of(&first, &second).contradict());
}

/// Standard normal numbers for the simulation: Box–Muller on a generator of its own, so that nothing is shared with what
/// is tested.
fn normal_numbers() -> impl FnMut() -> f64 {
    let mut state = 0x1234_5678_9abc_def1_u64;
    let mut uniform = move || {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (f64::from(u32::try_from(state >> 32).unwrap()) + 0.5) / 4_294_967_296.0
    };
    move || (-2.0 * uniform().ln()).sqrt() * (2.0 * std::f64::consts::PI * uniform()).cos()
}

#[test]
fn the_combined_sigma_is_that_of_simulated_measurements() {
    let n = 100_000;
    let mut normal = normal_numbers();
    let mut measure = |quantity: Measured<f64>| quantity.value + quantity.sigma * normal();
    let claimed = combine(&stereo(F, B, D), &monocular(F, W, P)).unwrap().relative();
    let logs: Vec<f64> = (0..n)
        .filter_map(|_| {
            let f = Measured::from_base(measure(F.to_base()), F.sigma.px());
            let first = stereo(
                f,
                Measured::from_base(measure(B.to_base()), B.sigma.m()),
                Measured::from_base(measure(D.to_base()), D.sigma.px()),
            );
            let second = monocular(
                f,
                Measured::from_base(measure(W.to_base()), W.sigma.m()),
                Measured::from_base(measure(P.to_base()), P.sigma.px()),
            );
            // More than 3 σ apart there is none; the weighted mean does not depend on the difference.
            Some(combine(&first, &second)?.value.m().ln())
        })
        .collect();
    let n = u32::try_from(logs.len()).unwrap();
    let mean = logs.iter().sum::<f64>() / f64::from(n);
    let sigma = (logs.iter().map(|log| (log - mean).powi(2)).sum::<f64>() / f64::from(n)).sqrt();
    // The σ of a sample σ is 1/√(2n): 0.22 %. Four of them, and 0.5 % for what first order leaves out.
    assert_near(claimed / sigma, 1.0, 4.0 * 0.0022 + 0.005);
}

#[test]
fn the_verdict_follows_the_difference_in_sigmas() {
    // r 3 % and 4 % make 5 % together; the shared 20 % must not count.
    for (sigmas, verdict) in [
        (0.5, Verdict::Agree),
        (1.9, Verdict::Agree),
        (2.1, Verdict::Doubtful),
        (2.9, Verdict::Doubtful),
        (3.1, Verdict::Disagree),
    ] {
        let (first, second) = pair([(0.05_f64 * sigmas).exp(), 1.0], [0.03, 0.04], 0.2);
        let agreement = Comparison::of(&first, &second).agreement.unwrap();
        assert_near(agreement.z, sigmas, 1e-9);
        assert_eq!(agreement.verdict, verdict);
        assert_eq!(suspects(&first, &second).is_empty(), verdict == Verdict::Agree);
    }
}

/// The suspects when one input of the mug is off by a factor.
fn suspects_of(b: f64, d: f64, w: f64, p: f64) -> Vec<Suspect> {
    fn times<Q: Quantity>(quantity: Measured<Q>, factor: f64) -> Measured<Q> {
        let Measured { value, sigma } = quantity.to_base();
        Measured::from_base(value * factor, sigma * factor)
    }
    suspects(&stereo(F, times(B, b), times(D, d)), &monocular(F, times(W, w), times(P, p)))
}

#[test]
fn a_raw_disparity_is_recognized() {
    assert_eq!(suspects_of(1.0, 16.0, 1.0, 1.0)[0], Suspect::RawDisparity { scale: 16.0 });
    assert_eq!(suspects_of(1.0, 15.5, 1.0, 1.0)[0], Suspect::RawDisparity { scale: 16.0 });
    assert_eq!(suspects_of(1.0, 256.0, 1.0, 1.0)[0], Suspect::RawDisparity { scale: 256.0 });
    let is_raw = |suspect: &Suspect| matches!(suspect, Suspect::RawDisparity { .. });
    assert!(
        !suspects_of(1.0, 1.0 / 16.0, 1.0, 1.0).iter().any(is_raw),
        "too far is no raw disparity"
    );
}

#[test]
fn every_slip_of_the_unit_is_recognized_in_either_length() {
    for taken in LengthUnit::ALL {
        for meant in LengthUnit::COMMON.into_iter().filter(|&meant| meant != taken) {
            let factor = Length::new(1.0, taken).m() / Length::new(1.0, meant).m();
            for (source, mut found) in [
                (Field::Baseline, suspects_of(factor, 1.0, 1.0, 1.0)),
                (Field::RealWidth, suspects_of(1.0, 1.0, factor, 1.0)),
            ] {
                // The same ratio can come of a slip from a unit that is not in use.
                found.retain(|suspect| !matches!(suspect, Suspect::Unit { taken: other, .. } if *other != taken));
                let slip = Suspect::Unit { source, taken, meant };
                let place = found.iter().position(|&suspect| suspect == slip);
                // Or of a scale of 32 near 30.48, of a size of 2 near 1.76.
                assert!(place.is_some_and(|place| place < 2), "{slip:?} in {found:?}");
            }
        }
    }
}

#[test]
fn a_resized_image_is_recognized() {
    let resized = |source, times| Suspect::Resized { source, times };
    assert!(suspects_of(1.0, 2.0, 1.0, 1.0)[..2].contains(&resized(Field::Disparity, 2.0)));
    assert!(suspects_of(1.0, 0.5, 1.0, 1.0)[..2].contains(&resized(Field::Disparity, 0.5)));
    assert!(suspects_of(1.0, 1.0, 1.0, 2.0)[..2].contains(&resized(Field::ImageWidth, 2.0)));
}

#[test]
fn without_a_typical_factor_the_exact_and_the_vaguest_inputs_are_suspected() {
    let found = suspects(
        &stereo(F, Measured::from_base(0.14, 0.0), D),
        &monocular(F, Measured::from_base(0.30, 0.0), P),
    );
    assert_eq!(
        found,
        [
            Suspect::NoSigma(Field::Baseline),
            Suspect::NoSigma(Field::RealWidth),
            Suspect::LargestSigma(Field::ImageWidth),
        ]
    );
    // The focal length cancels: however vague, it is no suspect.
    let vague = Measured::from_base(700.0, 300.0);
    let found = suspects(&stereo(vague, Measured::from_base(0.14, 0.0005), D), &monocular(vague, W, P));
    assert_eq!(found, [Suspect::LargestSigma(Field::RealWidth)]);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn the_combination_lies_between_and_is_never_vaguer_than_the_better_one_unless_they_differ(
        z in [any_magnitude(), any_magnitude()], r in [any_relative_sigma(), any_relative_sigma()], rf in any_relative_sigma(),
    ) {
        let (first, second) = pair(z, r, rf);
        let Some(combined) = combine(&first, &second) else {
            let own = first.own_relative_sigma().min(second.own_relative_sigma());
            prop_assert!(own == 0.0 || Comparison::of(&first, &second).contradict());
            return Ok(());
        };
        prop_assert!(!Comparison::of(&first, &second).contradict());
        prop_assert!(combined.value.m() >= z[0].min(z[1]) && combined.value.m() <= z[0].max(z[1]));
        prop_assert!(combined.sigma.m().is_finite() && combined.sigma.m() >= 0.0);
        let better = first.relative_sigma().min(second.relative_sigma());
        // A σ may be too small to be represented but by the smallest number there is.
        let most = combined.value.m() * better * (1.0 + 1e-12) + f64::from_bits(1);
        let widened = Comparison::of(&first, &second).agreement.is_some_and(|agreement| agreement.z > 1.0);
        prop_assert!(widened || combined.sigma.m() <= most, "{} {}", combined.sigma.m(), most);
        // Nothing depends on which comes first.
        let swapped = combine(&second, &first).unwrap();
        prop_assert!((swapped.value.m() / combined.value.m() - 1.0).abs() < 1e-9, "{} {}", swapped.value.m(), combined.value.m());
    }

    #[test]
    fn the_comparison_is_finite_at_every_magnitude(
        z in [any_magnitude(), any_magnitude()], r in [any_relative_sigma(), any_relative_sigma()], rf in any_relative_sigma(),
    ) {
        let (first, second) = pair(z, r, rf);
        let comparison = Comparison::of(&first, &second);
        prop_assert!(comparison.agreement.is_none_or(|agreement| agreement.z.is_finite() && agreement.z >= 0.0));
        prop_assert!(comparison.ratio.is_none_or(|ratio| ratio.is_normal()));
        let own = first.own_relative_sigma().min(second.own_relative_sigma());
        prop_assert_eq!(comparison.agreement.is_none(), own == 0.0);
    }
}
