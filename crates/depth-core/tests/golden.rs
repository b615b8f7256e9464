//! Golden numbers from independent sources, and properties that hold for every input.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use depth_core::in_image::InImage;
use depth_core::measured::Measured;
use depth_core::problem::Problem;
use depth_core::quantity::{Length, LengthUnit, Pixels};
use depth_core::{monocular, stereo};
use depth_generators::{any_magnitude, any_unit};
use proptest::prelude::*;

fn close(got: f64, expected: f64, relative: f64) -> bool {
    (got / expected - 1.0).abs() <= relative
}

/// The two worked examples of the web page that this program reproduces.
#[test]
fn the_examples_of_the_page() {
    assert_eq!(stereo::depth(Pixels::new(700.0), Length::from_m(0.1), Pixels::new(50.0)).m(), 1.4);
    assert_eq!(
        monocular::depth(Pixels::new(950.0), Length::from_m(0.9), Pixels::new(200.0)).m(),
        4.275
    );
}

/// `cv2.reprojectImageTo3D` of OpenCV 4.14 with the Q of `stereoRectify` for T = (−100, 0, 0): with cx 610 and 650 a
/// disparity of 50 px gives Z = 777.78, which is f·b/(d + 40); here the disparity with its offset.
#[test]
fn opencv_reprojects_the_same_depth() {
    let depth = stereo::depth(Pixels::new(700.0), Length::from_m(100.0), Pixels::new(90.0)).m();
    assert!(close(depth, 777.777_777_777_777_8, 1e-15), "{depth}");
}

/// Middlebury 2014, Motorcycle (imperfect): f 3997.684 px, baseline 193.001 mm, doffs 131.111 px; their conversion of a
/// disparity of 100 px to depth, Z = baseline·f/(d + doffs), in mm, done with a pocket calculator.
#[test]
fn middlebury_converts_disparity_to_the_same_depth() {
    let depth = stereo::depth(
        Pixels::new(3997.684),
        Length::new(193.001, LengthUnit::Millimeter),
        Pixels::new(231.111),
    );
    assert!(close(depth.in_unit(LengthUnit::Millimeter), 3338.46, 1e-5), "{depth:?}");
}

/// A foot is 0.3048 m and an inch 25.4 mm by definition (international yard and pound agreement, 1959).
#[test]
fn units_are_those_of_the_1959_agreement() {
    assert_eq!(Length::new(1.0, LengthUnit::Foot).m(), 0.3048);
    assert_eq!(Length::new(1.0, LengthUnit::Inch).m(), 0.0254);
    assert_eq!(Length::new(100.0, LengthUnit::Millimeter).m(), 0.1);
    assert_eq!(Length::new(10.0, LengthUnit::Centimeter).m(), 0.1);
}

fn problem(focal_length: f64, baseline: f64, disparity: f64, image_width: f64, real_width: f64) -> Problem {
    Problem {
        focal_length: Some(InImage::from_px(focal_length)),
        baseline: Some(Measured::from_base(baseline, 0.0)),
        disparity: Some(InImage::from_px(disparity)),
        image_width: Some(InImage::from_px(image_width)),
        real_width: Some(Measured::from_base(real_width, 0.0)),
        ..Problem::default()
    }
}

/// A negative width would make the other one negative too.
#[test]
fn a_width_that_cannot_be_used_predicts_nothing() {
    let solution = problem(700.0, 0.1, 50.0, -150.0, -0.3).solve();
    assert_eq!(solution.stereo.distance(), Some(Length::from_m(1.4)));
    assert_eq!((solution.estimated_width, solution.estimated_width_px), (None, None));
}

proptest! {
    #[test]
    fn stereo_and_its_inverse_cancel(f in 1.0..1e5f64, b in 1e-4..1e2f64, d in 1e-2..1e4f64) {
        let (f, b) = (Pixels::new(f), Length::from_m(b));
        let back = stereo::disparity(f, b, stereo::depth(f, b, Pixels::new(d))).px();
        prop_assert!(close(back, d, 1e-14));
    }

    #[test]
    fn monocular_and_its_inverses_cancel(f in 1.0..1e5f64, w in 1e-4..1e2f64, p in 1e-2..1e4f64) {
        let (f, w, p) = (Pixels::new(f), Length::from_m(w), Pixels::new(p));
        let z = monocular::depth(f, w, p);
        prop_assert!(close(monocular::width_in_image(f, w, z).px(), p.px(), 1e-14));
        prop_assert!(close(monocular::real_width(f, p, z).m(), w.m(), 1e-14));
    }

    #[test]
    fn units_round_trip(value in any_magnitude(), unit in any_unit()) {
        let back = Length::new(value, unit).in_unit(unit);
        prop_assert!(close(back, value, 1e-15));
    }

    #[test]
    fn a_larger_disparity_is_never_farther(f in 1.0..1e5f64, b in 1e-4..1e2f64, d in 1e-2..1e4f64, more in 1.0..100.0f64) {
        let (f, b) = (Pixels::new(f), Length::from_m(b));
        prop_assert!(stereo::depth(f, b, Pixels::new(d * more)).m() <= stereo::depth(f, b, Pixels::new(d)).m());
    }

    #[test]
    fn distances_scale_with_the_scene(f in 1.0..1e5f64, b in 1e-4..1e2f64, d in 1e-2..1e4f64, scale in 1e-3..1e3f64) {
        let depth = |b: f64| stereo::depth(Pixels::new(f), Length::from_m(b), Pixels::new(d)).m();
        prop_assert!(close(depth(b * scale), depth(b) * scale, 1e-14));
    }

    /// A result is refused only where it would not be a finite, normal number; none is ever NaN or infinite.
    #[test]
    fn solutions_are_normal_or_absent(
        f in any_magnitude(), b in any_magnitude(), d in any_magnitude(), p in any_magnitude(), w in any_magnitude(),
    ) {
        let solution = problem(f, b, d, p, w).solve();
        let logarithm = f.log10() + b.log10() - d.log10();
        if (-307.0..307.0).contains(&logarithm) {
            prop_assert!(solution.stereo.distance().is_some(), "{f} {b} {d}");
        }
        for value in [
            solution.stereo.distance().map(Length::m),
            solution.monocular.distance().map(Length::m),
            solution.estimated_width.map(Length::m),
            solution.estimated_width_px.map(Pixels::px),
        ].into_iter().flatten() {
            prop_assert!(value.is_normal() && value > 0.0);
        }
    }
}
