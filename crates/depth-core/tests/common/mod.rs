//! What several of the tests start from.
#![allow(dead_code, clippy::unwrap_used, reason = "tests, none of which needs all of it")]

use depth_core::measured::Measured;
use depth_core::problem::{Field, Problem};
use depth_core::quantity::Pixels;
use depth_core::uncertainty::Model;

pub const NO_DOFFS: Measured<Pixels> = Measured::exact(Pixels::new(0.0));

pub fn px(value: f64) -> Pixels {
    Pixels::new(value)
}

/// A mug at 1.4 m: f = 700 ± 2 px, b = 100 ± 0.5 mm, d = 50 ± 0.5 px.
pub fn mug() -> Model {
    Model::stereo(
        Measured::from_base(700.0, 2.0),
        Measured::from_base(0.1, 0.0005),
        Measured::from_base(50.0, 0.5),
        NO_DOFFS,
    )
    .unwrap()
}

/// The cameras of the mug, exact, with a disparity and an offset of the principal points.
pub fn exact_cameras(disparity: Measured<Pixels>, doffs: Measured<Pixels>) -> Model {
    Model::stereo(Measured::from_base(700.0, 0.0), Measured::from_base(0.1, 0.0), disparity, doffs).unwrap()
}

/// The same with a disparity alone, and its σ.
pub fn disparity_only(disparity: f64, sigma: f64) -> Model {
    exact_cameras(Measured::from_base(disparity, sigma), NO_DOFFS)
}

pub fn assert_near(value: f64, expected: f64, tolerance: f64) {
    assert!((value - expected).abs() <= tolerance, "{value} is not {expected} ± {tolerance}");
}

/// What is exactly known: fields with their values in the base unit, px where it is one of the image.
pub fn problem(values: &[(Field, f64)]) -> Problem {
    let mut problem = Problem::default();
    for &(field, value) in values {
        problem.set(field, Some(value));
    }
    problem
}
