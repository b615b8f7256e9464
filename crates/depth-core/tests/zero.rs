//! Another zero than the lens, and what is solved for wherever it is. Worked out by hand and by differences.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{assert_near, problem, px};
use depth_core::camera::{Along, PointView};
use depth_core::judge::Refusal;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Outcome};
use depth_core::quantity::Length;
use depth_core::setup::{Object, Pair};
use proptest::prelude::*;

#[test]
fn a_zero_in_front_of_the_lens_is_taken_from_every_distance_and_from_no_width() {
    let mut mug = problem(&[
        (Field::FocalLength, 700.0),
        (Field::Baseline, 0.1),
        (Field::Disparity, 50.0),
        (Field::ImageWidth, 148.0),
        (Field::RealWidth, 0.3),
    ]);
    mug.set_sigma(Field::Disparity, 0.5);
    mug.set_sigma(Field::ImageWidth, 2.0);
    let before = mug.solve();
    mug.set(Field::Zero, Some(0.0042));
    let after = mug.solve();
    let moved = |before: Length, after: Length| assert_near(before.m() - after.m(), 0.0042, 1e-12);
    for method in Method::ALL {
        moved(
            before.outcome(method).distance().unwrap(),
            after.outcome(method).distance().unwrap(),
        );
        let (before, after) = (before.uncertainty(method).unwrap(), after.uncertainty(method).unwrap());
        assert_near(before.sigma.m(), after.sigma.m(), 1e-15);
        moved(before.interval.near, after.interval.near);
        moved(before.interval.far.unwrap(), after.interval.far.unwrap());
    }
    moved(before.combined.unwrap().value, after.combined.unwrap().value);
    assert_near(before.combined.unwrap().sigma.m(), after.combined.unwrap().sigma.m(), 1e-15);
    assert_eq!(before.comparison, after.comparison);
    assert_eq!(before.estimated_width, after.estimated_width);
    assert_eq!(before.estimated_width_px, after.estimated_width_px);
    let (near, far) = (before.one_pixel_range().unwrap(), after.one_pixel_range().unwrap());
    moved(near.0, far.0);
    moved(near.1.unwrap(), far.1.unwrap());
    // A tape that starts behind the object has nothing to measure.
    mug.set(Field::Zero, Some(1.5));
    let refused = Outcome::Refused {
        field: Field::Zero,
        refusal: Refusal::BehindZero,
    };
    assert_eq!(mug.solve().stereo, refused);
}

#[test]
fn a_point_stays_where_it_is_when_zero_moves() {
    let at = |along, shift| {
        PointView {
            fx: Measured::from_base(500.0, 5.0),
            fy: px(500.0),
            cx: px(0.0),
            cy: px(0.0),
            column: px(400.0),
            row: px(300.0),
            along,
            shift: Length::from_m(shift),
        }
        .solve()
        .unwrap()
    };
    // From the lens (4, 3, 5) m; from 1 m in front of it Z is 4 m and R = √(16 + 9 + 16).
    let depth = Measured::from_base(4.0, 0.1);
    let point = at(Along::Axis(depth), -1.0);
    assert_near(point.x.value.m(), 4.0, 1e-12);
    assert_near(point.y.value.m(), 3.0, 1e-12);
    assert_near(point.z.value.m(), 4.0, 1e-12);
    assert_near(point.range.value.m(), 41.0_f64.sqrt(), 1e-12);
    // And back from the range.
    let back = at(Along::Ray(Measured::from_base(41.0_f64.sqrt(), 0.0)), -1.0);
    assert_near(back.z.value.m(), 4.0, 1e-12);
    assert_near(back.x.value.m(), 4.0, 1e-12);
    // σ by differences.
    let moved = at(Along::Axis(Measured::from_base(4.1, 0.0)), -1.0);
    let small = at(Along::Axis(Measured::from_base(4.0 + 1e-6, 0.0)), -1.0);
    let exact = at(Along::GivenDepth(Measured::from_base(4.0, 1e-6)), -1.0);
    assert!(moved.range.value > point.range.value);
    let without_f = |sigma: f64, by_f: f64| (sigma * sigma - by_f * by_f).sqrt();
    assert_near(
        without_f(exact.range.sigma.m(), 25.0 / 41.0_f64.sqrt() * 0.01) / (small.range.value.m() - point.range.value.m()),
        1.0,
        0.01,
    );
}

#[test]
fn what_is_solved_for_gives_the_distance_back_in_every_setup() {
    let base = [
        (Field::FocalLength, 900.0),
        (Field::Baseline, 0.1),
        (Field::Disparity, 180.0),
        (Field::ImageWidth, 408.0),
        (Field::RealWidth, 0.2),
    ];
    for object in Object::ALL {
        for (lens, zero, fy) in [
            (None, None, None),
            (Some(0.015), Some(0.004), None),
            (None, Some(-0.02), Some(850.0)),
        ] {
            let mut given = problem(&base);
            given.object = object;
            given.pair = if object == Object::Height {
                Pair::Vertical
            } else {
                Pair::Horizontal
            };
            given.set(Field::Lens, lens);
            given.set(Field::Zero, zero);
            given.set(Field::Fy, fy);
            for method in Method::ALL {
                let distance = given.solve().outcome(method).distance().unwrap();
                for field in method
                    .fields()
                    .into_iter()
                    .filter(|&field| field != Field::FocalLength || fy.is_none())
                {
                    let found = given.solve_for(method, field, Measured::exact(distance)).unwrap().unwrap();
                    let value = given.get(field).unwrap();
                    assert_near(found.to_base().value / value, 1.0, 1e-12);
                    // σ of the distance by differences.
                    let nudged = given.solve_for(method, field, Measured::from_base(distance.m() * (1.0 + 1e-6), 0.0));
                    let slope = (nudged.unwrap().unwrap().to_base().value - value).abs();
                    let with_sigma = given.solve_for(method, field, Measured::from_base(distance.m(), distance.m() * 1e-6));
                    assert_near(with_sigma.unwrap().unwrap().to_base().sigma / slope, 1.0, 1e-4);
                }
            }
        }
    }
}

proptest! {
    /// Wherever zero is and whatever lens there is, no distance is negative and no number is none.
    #[test]
    fn nothing_is_nearer_than_zero(
        zero in -2.0..2.0_f64, lens in 1e-3..0.5_f64, d in 1.0..500.0_f64, sigma in 0.0..100.0_f64, ball in any::<bool>(),
    ) {
        let mut problem = problem(&[
            (Field::FocalLength, 700.0), (Field::Baseline, 0.1), (Field::Disparity, d), (Field::ImageWidth, d), (Field::RealWidth, 0.1),
            (Field::Zero, zero), (Field::Lens, lens),
        ]);
        problem.object = if ball { Object::Ball } else { Object::Width };
        problem.set_sigma(Field::Disparity, sigma);
        problem.set_sigma(Field::ImageWidth, sigma);
        let solution = problem.solve();
        for method in Method::ALL {
            if let Some(distance) = solution.outcome(method).distance() {
                prop_assert!(distance.m() > 0.0);
            }
            if let Some(uncertainty) = solution.uncertainty(method) {
                prop_assert!(uncertainty.interval.near.m() >= 0.0);
                prop_assert!(uncertainty.sigma.m().is_finite());
                prop_assert!(uncertainty.interval.far.is_none_or(|far| far >= uncertainty.interval.near));
            }
        }
    }
}
