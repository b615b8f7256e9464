//! Strategies of [proptest](mod@proptest) for the numbers that find what is wrong with a formula: every magnitude, numbers that all but
//! agree, sums in which everything cancels, and whole problems of these.
//!
//! A crate of its own, so that proptest is no dependency of what is published.

use depth_core::field::Field;
use depth_core::judge::Unsolvable;
use depth_core::measured::Measured;
use depth_core::problem::Problem;
use depth_core::quantity::{LengthUnit, Quantity};
use depth_core::uncertainty::Model;
use proptest::prelude::*;
use std::fmt::Debug;
use std::ops::Range;

/// A positive number of any magnitude from 1e-300 to 1e300.
pub fn any_magnitude() -> impl Strategy<Value = f64> {
    (-300.0..300.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent))
}

/// A number of either sign and any magnitude, or 0.
pub fn any_sign_and_magnitude() -> impl Strategy<Value = f64> {
    prop_oneof![any_magnitude(), any_magnitude().prop_map(|number| -number), Just(0.0)]
}

/// Any `f64` at all, NaN and the infinities among them.
pub fn any_f64() -> impl Strategy<Value = f64> {
    any::<u64>().prop_map(f64::from_bits)
}

/// A σ as a fraction of its value: often 0, often of the value's size, sometimes of another magnitude.
pub fn any_relative_sigma() -> impl Strategy<Value = f64> {
    prop_oneof![
        Just(0.0),
        0.0..3.0_f64,
        (-200.0..5.0_f64).prop_map(|exponent| 10.0_f64.powf(exponent))
    ]
}

/// A positive number and another that is at most 32 units of the last place away from it.
pub fn all_but_equal(number: impl Strategy<Value = f64>) -> impl Strategy<Value = (f64, f64)> {
    (number, -32..=32_i64).prop_map(|(number, ulps)| (number, f64::from_bits(number.to_bits().saturating_add_signed(ulps))))
}

/// A disparity and an offset whose sum is a few units of the last place of either: all that is left is rounding.
pub fn cancelling() -> impl Strategy<Value = (f64, f64)> {
    all_but_equal(any_magnitude()).prop_map(|(disparity, offset)| (disparity, -offset))
}

/// A value with a σ of [any relative size](any_relative_sigma).
pub fn measured<Q: Quantity + Debug>(value: impl Strategy<Value = f64>) -> impl Strategy<Value = Measured<Q>> {
    (value, any_relative_sigma()).prop_map(|(value, relative)| Measured::from_base(value, value.abs() * relative))
}

/// A positive value of any magnitude; its σ is often 0, often of the value's size, sometimes anything.
pub fn any_measured<Q: Quantity + Debug>() -> impl Strategy<Value = Measured<Q>> {
    (any_magnitude(), prop_oneof![Just(0.0), 0.0..3.0_f64], any_magnitude(), 0..4)
        .prop_map(|(value, relative, anything, choice)| Measured::from_base(value, if choice == 0 { anything } else { value * relative }))
}

/// An ordinary value; its σ is often 0, often a few percent, at most three times the value.
pub fn ordinary_measured<Q: Quantity + Debug>(value: Range<f64>) -> impl Strategy<Value = Measured<Q>> {
    (value, prop_oneof![Just(0.0), 0.0..0.2, 0.0..3.0]).prop_map(|(value, relative)| Measured::from_base(value, value * relative))
}

/// A unit of length.
pub fn any_unit() -> impl Strategy<Value = LengthUnit> {
    proptest::sample::select(LengthUnit::ALL.to_vec())
}

/// A distance from inputs of every magnitude, or why there is none.
pub fn any_model() -> impl Strategy<Value = Result<Model, Unsolvable>> {
    prop_oneof![
        (any_measured(), any_measured(), any_measured(), any_measured()).prop_map(|(f, b, d, o)| Model::stereo(f, b, d, o)),
        (any_measured(), any_measured(), cancelling())
            .prop_map(|(f, b, (d, o))| { Model::stereo(f, b, Measured::from_base(d, 0.0), Measured::from_base(o, 0.0)) }),
        (any_measured(), any_measured(), any_measured()).prop_map(|(f, w, p)| Model::monocular(f, w, p)),
    ]
}

/// A stereo distance from ordinary inputs, with every σ up to three times its value; there is hardly one that cannot be
/// solved.
pub fn ordinary_model() -> impl Strategy<Value = Model> {
    (
        ordinary_measured(100.0..5000.0),
        ordinary_measured(0.01..5.0),
        ordinary_measured(0.5..500.0),
        ordinary_measured(0.1..100.0),
    )
        .prop_filter_map("a distance", |(f, b, d, o)| Model::stereo(f, b, d, o).ok())
}

/// Each input by itself: absent, ordinary, of any magnitude, or any `f64` at all; its σ likewise.
pub fn any_problem() -> impl Strategy<Value = Problem> {
    let number = || prop_oneof![3 => 0.01..5000.0_f64, 2 => any_sign_and_magnitude(), 1 => any_f64()];
    let inputs = prop::array::uniform6(proptest::option::weighted(0.8, number()));
    let sigmas = prop::array::uniform6(prop_oneof![Just(0.0), number()]);
    (inputs, sigmas).prop_map(|(inputs, sigmas)| {
        let mut problem = Problem::default();
        for ((field, input), sigma) in Field::ALL.into_iter().zip(inputs).zip(sigmas) {
            problem.set(field, input);
            problem.set_sigma(field, sigma);
        }
        problem
    })
}

/// A complete problem of any scale in which a difference hides its figures: the two distances all but agree, or disparity
/// and offset all but cancel.
pub fn delicate_problem() -> impl Strategy<Value = Problem> {
    let ordinary = (1.0..5000.0_f64, 0.01..5.0_f64, 1.0..500.0_f64);
    let offset = prop_oneof![2 => Just(None), 1 => cancelling().prop_map(Some)];
    (
        ordinary,
        all_but_equal(0.01..50.0_f64),
        offset,
        prop::array::uniform6(any_relative_sigma()),
    )
        .prop_map(|((f, b, d), (distance, other), offset, sigmas)| {
            let disparity = offset.map_or(f * b / distance, |(disparity, _)| disparity);
            let mut problem = Problem::default();
            let inputs = [f, b, disparity, offset.map_or(0.0, |(_, offset)| offset), d, d * other / f];
            for ((field, input), sigma) in Field::ALL.into_iter().zip(inputs).zip(sigmas) {
                problem.set(field, Some(input));
                problem.set_sigma(field, sigma * input.abs());
            }
            problem
        })
}
