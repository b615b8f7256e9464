//! The uncertainty of one distance: golden figures, the definition of the interval, and every magnitude an f64 can have.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{NO_DOFFS, assert_near, disparity_only, exact_cameras, mug};
use depth_core::field::Field;
use depth_core::judge::{Refusal, Term, Unsolvable};
use depth_core::measured::Measured;
use depth_core::quantity::{Length, Pixels};
use depth_core::stereo;
use depth_core::uncertainty::{FIRST_ORDER_LIMIT, Model};
use depth_generators::{any_model, ordinary_model};
use proptest::prelude::*;

fn mug_by_its_width() -> Model {
    Model::monocular(
        Measured::from_base(700.0, 2.0),
        Measured::from_base(0.30, 0.01),
        Measured::from_base(150.0, 2.0),
    )
    .unwrap()
}

#[test]
fn the_mug_is_1400_mm_away_give_or_take_16() {
    let distance = mug().depth_with_sigma();
    assert_near(distance.value.m(), 1.4, 1e-15);
    assert_near(distance.sigma.m(), 0.016, 0.0005);
    let interval = mug().interval();
    assert_near(interval.near.m(), 1.3840, 5e-5);
    assert_near(interval.far.unwrap().m(), 1.4163, 5e-5);
}

#[test]
fn the_mug_by_its_width_is_1400_mm_away_give_or_take_50() {
    let distance = mug_by_its_width().depth_with_sigma();
    assert_near(distance.value.m(), 1.4, 1e-15);
    assert_near(distance.sigma.m(), 0.050, 0.0005);
    let interval = mug_by_its_width().interval();
    assert_near(interval.near.m(), 1.3498, 5e-5);
    assert_near(interval.far.unwrap().m(), 1.4507, 5e-5);
}

#[test]
fn the_disparity_is_responsible_for_three_quarters_of_the_variance() {
    let budget = mug().variance_budget();
    let sources: Vec<Field> = budget.iter().map(|share| share.source).collect();
    assert_eq!(sources, [Field::FocalLength, Field::Baseline, Field::Disparity]);
    assert_near(budget[2].share, 0.75, 0.005);
    let budget = mug_by_its_width().variance_budget();
    assert_eq!(budget[1].source, Field::RealWidth);
    assert_near(budget[1].share, 0.86, 0.005);
}

#[test]
fn the_variance_of_doffs_adds_to_that_of_the_disparity() {
    let model = exact_cameras(Measured::from_base(50.0, 0.3), Measured::from_base(40.0, 0.4));
    // 3-4-5: together 0.5 px on 90 px.
    assert_near(model.depth().m(), 70.0 / 90.0, 1e-15);
    assert_near(model.relative_sigma(), 0.5 / 90.0, 1e-15);
    let budget = model.variance_budget();
    assert_eq!(budget[3].source, Field::Doffs);
    assert_near(budget[3].share, 0.64, 1e-12);
}

#[test]
fn exact_inputs_give_an_exact_distance() {
    let model = disparity_only(50.0, 0.0);
    let interval = model.interval();
    assert_eq!(model.depth_with_sigma(), Measured::from_base(1.4, 0.0));
    assert_eq!((interval.near, interval.far), (Length::from_m(1.4), Some(Length::from_m(1.4))));
    assert_eq!(model.variance_budget().shares(), []);
    assert_eq!(model.relative_bias(), Some(0.0));
}

#[test]
fn with_only_the_disparity_uncertain_the_interval_is_that_of_d_plus_and_minus_sigma() {
    for (d, sigma) in [(50.0, 0.5), (50.0, 25.0), (3.0, 2.9)] {
        let at = |d| stereo::depth(Pixels::new(700.0), Length::from_m(0.1), Pixels::new(d)).m();
        let interval = disparity_only(d, sigma).interval();
        assert_near(interval.near.m() / at(d + sigma), 1.0, 1e-12);
        assert_near(interval.far.unwrap().m() / at(d - sigma), 1.0, 1e-12);
    }
}

#[test]
fn there_is_no_upper_bound_once_sigma_reaches_the_disparity() {
    assert!(disparity_only(2.0, 1.999).interval().far.is_some());
    assert_eq!(disparity_only(2.0, 2.0).interval().far, None);
    let interval = disparity_only(2.0, 5.0).interval();
    assert_eq!(interval.far, None);
    assert_near(interval.near.m(), 70.0 / 7.0, 1e-12);
}

#[test]
fn nothing_is_nearer_than_the_camera_however_uncertain_the_focal_length() {
    let model = Model::stereo(
        Measured::from_base(700.0, 900.0),
        Measured::from_base(0.1, 0.0),
        Measured::from_base(50.0, 0.0),
        NO_DOFFS,
    );
    assert_eq!(model.unwrap().interval().near, Length::from_m(0.0));
}

/// ∫ g(x)·φ(x) dx over ±8 by the trapezium rule, which converges exponentially for a smooth integrand.
fn normal_mean(g: impl Fn(f64) -> f64) -> f64 {
    let step = 0.001;
    (-8000..=8000)
        .map(|i| f64::from(i) * step)
        .map(|x| g(x) * (-x * x / 2.0).exp() * step)
        .sum::<f64>()
        / (2.0 * std::f64::consts::PI).sqrt()
}

#[test]
fn the_bias_is_that_of_the_mean_of_the_reciprocal() {
    for rx in [0.01, 0.05, 0.1] {
        let exact = normal_mean(|x| 1.0 / (1.0 + rx * x)) - 1.0;
        let bias = disparity_only(50.0, 50.0 * rx).relative_bias().unwrap();
        // The rest of the series is 3·rx⁴ + 15·rx⁶ + …
        assert!(exact > bias && exact - bias < 4.0 * rx.powi(4), "{rx}: {bias} for {exact}");
    }
    assert_near(disparity_only(50.0, 5.0).bias().unwrap().m(), 0.014, 1e-12);
    assert_eq!(disparity_only(50.0, 20.0).bias(), None);
}

#[test]
fn first_order_is_trusted_up_to_ten_per_cent() {
    assert!(disparity_only(10.0, 1.0).first_order_is_good());
    assert!(!disparity_only(10.0, 1.001).first_order_is_good());
    // What the doc says of the ends there.
    let interval = disparity_only(10.0, 1.0).interval();
    let sigmas = |z: f64| (z / 7.0 - 1.0).abs() / FIRST_ORDER_LIMIT;
    assert_near(sigmas(interval.far.unwrap().m()), 1.11, 0.005);
    assert_near(sigmas(interval.near.m()), 0.91, 0.005);
}

#[test]
fn an_input_that_cannot_be_used_is_named() {
    let make = |f, b, d, o| Model::stereo(f, b, d, o);
    let value = |field, refusal| {
        Err(Unsolvable::Value {
            term: Term::Input(field),
            refusal,
        })
    };
    let sigma = |field| Err(Unsolvable::Sigma { term: Term::Input(field) });
    let (f, b, d, o) = (
        Measured::from_base(700.0, 0.0),
        Measured::from_base(0.1, 0.0),
        Measured::from_base(50.0, 0.0),
        NO_DOFFS,
    );
    let nan = Measured::from_base(f64::NAN, 0.0);
    assert_eq!(make(nan, b, d, o), value(Field::FocalLength, Refusal::NotANumber));
    assert_eq!(
        make(f, Measured::from_base(-0.1, 0.0), d, o),
        value(Field::Baseline, Refusal::Negative)
    );
    assert_eq!(make(f, b, Measured::from_base(0.0, 0.0), o), value(Field::Disparity, Refusal::Zero));
    assert_eq!(
        make(f, b, d, Measured::from_base(-50.0, 0.0)),
        value(Field::Disparity, Refusal::Zero)
    );
    assert_eq!(make(f, b, d, nan), value(Field::Doffs, Refusal::NotANumber));
    assert_eq!(make(f, b, Measured::from_base(50.0, -1.0), o), sigma(Field::Disparity));
    assert_eq!(make(f, b, d, Measured::from_base(0.0, f64::NAN)), sigma(Field::Doffs));
    let (huge, long) = (Measured::from_base(1e300, 0.0), Measured::from_base(1e300, 0.0));
    assert_eq!(
        make(huge, long, d, o),
        Err(Unsolvable::Value {
            term: Term::Distance,
            refusal: Refusal::TooExtreme
        })
    );
    assert!(
        make(f, b, Measured::from_base(-10.0, 0.0), Measured::from_base(60.0, 0.0)).is_ok(),
        "doffs may make up for it"
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn every_result_is_finite_at_every_magnitude(model in any_model()) {
        let Ok(model) = model else { return Ok(()) };
        let distance = model.depth_with_sigma();
        let interval = model.interval();
        prop_assert!(distance.value.m().is_normal() && distance.sigma.m().is_finite() && distance.sigma.m() >= 0.0);
        prop_assert!(model.relative_sigma().is_finite() && model.own_relative_sigma().is_finite());
        prop_assert!(0.0 <= interval.near.m() && interval.near <= model.depth());
        prop_assert!(interval.far.is_none_or(|far| far.m().is_finite() && far >= model.depth()));
        prop_assert!(model.bias().is_none_or(|bias| bias.m().is_finite()));
        for share in &model.variance_budget() {
            prop_assert!((0.0..=1.0 + 1e-12).contains(&share.share), "{:?}", share);
        }
    }

    /// Of relative uncertainties that are too small for all digits as well.
    #[test]
    fn shares_add_to_one_whatever_the_uncertainty(exponent in -20_i32..0, other in -20_i32..0) {
        let relative = |exponent: i32| Measured::from_base(1.0, 1e-300 * 10_f64.powi(exponent));
        let model = Model::stereo(relative(exponent), Measured::from_base(1.0, 0.0), relative(other), Measured::from_base(0.0, 0.0)).unwrap();
        let sum: f64 = model.variance_budget().iter().map(|share| share.share).sum();
        prop_assert!((sum - 1.0).abs() < 1e-12, "{}", sum);
    }

    #[test]
    fn shares_add_to_one_or_there_is_no_uncertainty(model in any_model()) {
        let Ok(model) = model else { return Ok(()) };
        let sum: f64 = model.variance_budget().iter().map(|share| share.share).sum();
        let expected = if model.relative_sigma() == 0.0 { 0.0 } else { 1.0 };
        prop_assert!((sum - expected).abs() < 1e-12, "{}", sum);
    }

    /// Fieller's definition: an end θ is where the difference k − θ·x is exactly its own standard deviation.
    #[test]
    fn the_ends_are_where_the_inputs_are_contradicted_by_one_sigma(model in ordinary_model()) {
        let k = model.focal_length().value * model.length().1.value.m();
        let rk = model.focal_length().relative().hypot(model.length().1.relative());
        let x = model.divisor().to_base();
        let interval = model.interval();
        let contradiction = |theta: f64| (k - theta * x.value).abs() / (k * rk).hypot(theta * x.sigma);
        if let Some(far) = interval.far && far != interval.near && x.relative() < 0.999 {
            prop_assert!((contradiction(far.m()) - 1.0).abs() < 1e-9, "far {}", contradiction(far.m()));
        }
        if interval.near.m() > 0.0 && interval.near != model.depth() && rk < 0.999 {
            prop_assert!((contradiction(interval.near.m()) - 1.0).abs() < 1e-6, "near {}", contradiction(interval.near.m()));
        }
        prop_assert_eq!(interval.far.is_none(), x.relative() >= 1.0);
    }

    #[test]
    fn more_uncertainty_never_narrows_the_interval(model in ordinary_model(), more in 0.0..2.0_f64) {
        let (f, (_, b), d) = (model.focal_length(), model.length(), model.divisor());
        let f = Measured::from_base(f.value, f.sigma);
        let wider = Model::stereo(f, b, Measured::from_base(d.value, d.sigma * (1.0 + more)), NO_DOFFS).unwrap().interval();
        let interval = model.interval();
        prop_assert!(wider.near.m() <= interval.near.m() * (1.0 + 1e-12));
        if let Some(far) = wider.far {
            prop_assert!(interval.far.is_some_and(|narrower| narrower.m() <= far.m() * (1.0 + 1e-12)));
        }
    }
}
