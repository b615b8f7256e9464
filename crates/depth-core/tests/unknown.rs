//! Each unknown of the two equations: golden figures, round trips, and σ against numerical derivatives.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

use depth_core::field::Field;
use depth_core::judge::{Refusal, Term, Unsolvable};
use depth_core::measured::Measured;
use depth_core::quantity::Quantity;
use depth_core::unknown::{MonocularEquation, StereoEquation};
use depth_generators::any_measured;
use proptest::prelude::*;

/// The unknown in its base unit.
type Solved = Result<(Term, Measured<f64>), Unsolvable>;

/// The term of that place, but for the unknown.
fn term<Q: Quantity>(given: &[Measured<f64>], i: usize, unknown: usize) -> Option<Measured<Q>> {
    (i != unknown).then_some(Measured::from_base(given[i].value, given[i].sigma))
}

/// Stereo from [f, b, d, δ, Z] and monocular from [f, w, p, Z], with one left out.
fn stereo(given: [Measured<f64>; 5], unknown: usize) -> Solved {
    StereoEquation {
        focal_length: term(&given, 0, unknown),
        baseline: term(&given, 1, unknown),
        disparity: term(&given, 2, unknown),
        doffs: term(&given, 3, unknown),
        distance: term(&given, 4, unknown),
    }
    .solve()
    .map(|found| (found.term(), found.to_base()))
}

fn monocular(given: [Measured<f64>; 4], unknown: usize) -> Solved {
    MonocularEquation {
        focal_length: term(&given, 0, unknown),
        real_width: term(&given, 1, unknown),
        image_width: term(&given, 2, unknown),
        distance: term(&given, 3, unknown),
    }
    .solve()
    .map(|found| (found.term(), found.to_base()))
}

/// The OpenCV measurement: f 700 px, b 100 mm, d 50 px, doffs 40 px give 0.77778 m.
fn measured_pair() -> [Measured<f64>; 5] {
    [
        Measured::from_base(700.0, 2.0),
        Measured::from_base(0.1, 0.0005),
        Measured::from_base(50.0, 0.5),
        Measured::from_base(40.0, 0.3),
        Measured::from_base(0.777_777_777_777_777_8, 0.01),
    ]
}

fn mug() -> [Measured<f64>; 4] {
    [
        Measured::from_base(700.0, 2.0),
        Measured::from_base(0.30, 0.01),
        Measured::from_base(150.0, 2.0),
        Measured::from_base(1.4, 0.02),
    ]
}

fn each_follows_from_the_others<const N: usize>(
    given: [Measured<f64>; N],
    terms: [Term; N],
    solve: fn([Measured<f64>; N], usize) -> Solved,
) {
    for (unknown, term) in terms.into_iter().enumerate() {
        let (found, value) = solve(given, unknown).unwrap();
        assert_eq!(found, term);
        assert!((value.value / given[unknown].value - 1.0).abs() < 1e-12, "{term:?} {value:?}");
    }
}

#[test]
fn each_term_of_the_measured_pair_follows_from_the_others() {
    let terms = [
        Term::Input(Field::FocalLength),
        Term::Input(Field::Baseline),
        Term::Input(Field::Disparity),
        Term::Input(Field::Doffs),
        Term::Distance,
    ];
    each_follows_from_the_others(measured_pair(), terms, stereo);
}

#[test]
fn each_term_of_the_mug_follows_from_the_others() {
    let terms = [
        Term::Input(Field::FocalLength),
        Term::Input(Field::RealWidth),
        Term::Input(Field::ImageWidth),
        Term::Distance,
    ];
    each_follows_from_the_others(mug(), terms, monocular);
}

/// √Σ(∂x/∂i·σ_i)² with central differences of the solution itself.
fn numerical_sigma<const N: usize>(given: [Measured<f64>; N], unknown: usize, solve: fn([Measured<f64>; N], usize) -> Solved) -> f64 {
    let at = |i: usize, step: f64| {
        let mut moved = given;
        moved[i].value += step;
        solve(moved, unknown).unwrap().1.value
    };
    let variance: f64 = (0..N)
        .filter(|&i| i != unknown)
        .map(|i| {
            let step = given[i].value * 1e-5;
            ((at(i, step) - at(i, -step)) / (2.0 * step) * given[i].sigma).powi(2)
        })
        .sum();
    variance.sqrt()
}

#[test]
fn sigma_is_that_of_the_numerical_derivatives() {
    for unknown in 0..5 {
        let sigma = stereo(measured_pair(), unknown).unwrap().1.sigma;
        assert!(
            (sigma / numerical_sigma(measured_pair(), unknown, stereo) - 1.0).abs() < 1e-7,
            "stereo {unknown}"
        );
    }
    for unknown in 0..4 {
        let sigma = monocular(mug(), unknown).unwrap().1.sigma;
        assert!(
            (sigma / numerical_sigma(mug(), unknown, monocular) - 1.0).abs() < 1e-7,
            "monocular {unknown}"
        );
    }
}

#[test]
fn exactly_one_unknown_is_wanted() {
    assert_eq!(StereoEquation::default().solve(), Err(Unsolvable::NotOneUnknown));
    assert_eq!(stereo(measured_pair(), 5), Err(Unsolvable::NotOneUnknown));
    assert_eq!(MonocularEquation::default().solve(), Err(Unsolvable::NotOneUnknown));
    assert_eq!(monocular(mug(), 4), Err(Unsolvable::NotOneUnknown));
}

#[test]
fn a_term_that_cannot_be_used_is_named() {
    let value = |term, refusal| Err(Unsolvable::Value { term, refusal });
    let mut given = measured_pair();
    given[4] = Measured::from_base(0.0, 0.0);
    assert_eq!(stereo(given, 1), value(Term::Distance, Refusal::Zero));
    let mut given = measured_pair();
    given[3] = Measured::from_base(-50.0, 0.0);
    assert_eq!(stereo(given, 4), value(Term::Input(Field::Disparity), Refusal::Zero));
    let mut given = mug();
    given[2].sigma = -1.0;
    assert_eq!(
        monocular(given, 0),
        Err(Unsolvable::Sigma {
            term: Term::Input(Field::ImageWidth)
        })
    );
    let mut given = mug();
    given[0] = Measured::from_base(1e300, 0.0);
    given[1] = Measured::from_base(1e300, 0.0);
    assert_eq!(monocular(given, 3), value(Term::Distance, Refusal::TooExtreme));
}

#[test]
fn doffs_larger_than_the_shift_makes_the_disparity_negative() {
    let mut given = measured_pair();
    given[3] = Measured::from_base(100.0, 0.0);
    let (_, disparity) = stereo(given, 2).unwrap();
    assert!((disparity.value + 10.0).abs() < 1e-10);
}

fn ordinary(range: std::ops::Range<f64>) -> impl Strategy<Value = Measured<f64>> {
    (range, 0.0..0.5_f64).prop_map(|(value, relative)| Measured::from_base(value, value * relative))
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn stereo_terms_come_back(
        f in ordinary(100.0..5000.0), b in ordinary(0.01..5.0), d in ordinary(0.5..500.0), o in ordinary(0.0..100.0),
    ) {
        let (_, z) = stereo([f, b, d, o, f], 4).unwrap();
        let given = [f, b, d, o, z];
        // A disparity and doffs are differences: their rounding is that of the whole.
        let whole = d.value + o.value;
        for (unknown, scale) in [f.value, b.value, whole, whole, z.value].into_iter().enumerate() {
            let (_, found) = stereo(given, unknown).unwrap();
            prop_assert!((found.value - given[unknown].value).abs() < 1e-12 * scale, "{} {:?}", unknown, found);
        }
    }

    #[test]
    fn monocular_terms_come_back_or_are_refused_at_every_magnitude(
        given in prop::array::uniform4(any_measured()),
    ) {
        let Ok((_, z)) = monocular(given, 3) else { return Ok(()) };
        prop_assert!(z.value.is_normal() && z.sigma.is_finite());
        let given = [given[0], given[1], given[2], z];
        for unknown in 0..3 {
            if let Ok((_, found)) = monocular(given, unknown) {
                prop_assert!((found.value / given[unknown].value - 1.0).abs() < 1e-12, "{} {:?}", unknown, found);
                prop_assert!(found.sigma.is_finite() && found.sigma >= 0.0);
            }
        }
    }

    #[test]
    fn stereo_is_finite_or_refused_at_every_magnitude(
        given in prop::array::uniform5(any_measured()), unknown in 0..5_usize,
    ) {
        if let Ok((_, found)) = stereo(given, unknown) {
            prop_assert!(found.value.is_finite() && found.sigma.is_finite() && found.sigma >= 0.0);
        }
    }
}
