//! Two photographs and the step between them, and the length between two points.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{assert_near, px};
use depth_core::judge::{Refusal, Term, Unsolvable};
use depth_core::measured::Measured;
use depth_core::quantity::{Length, LengthUnit};
use depth_core::two_points::{StereoPoint, TwoPoints, TwoPointsSolution};
use depth_core::two_shots::TwoShots;
use proptest::prelude::*;

#[test]
fn two_photographs_and_a_step_give_both_distances() {
    let mm = |value| Measured::exact(Length::new(value, LengthUnit::Millimeter));
    let shots = TwoShots {
        far_width: Measured::from_base(1162.0, 3.0),
        near_width: Measured::from_base(1429.0, 3.0),
        step: mm(419.1),
        focal_length: None,
    };
    let solution = shots.solve().unwrap();
    let in_mm = |length: Length| length.in_unit(LengthUnit::Millimeter);
    assert_near(in_mm(solution.far.value), 2243.05, 0.01);
    assert_near(in_mm(solution.near.value), 1823.95, 0.01);
    assert_near(in_mm(solution.far.sigma), 32.48, 0.01);
    assert_near(in_mm(solution.near.sigma), 32.48, 0.01);
    assert_eq!(solution.size, None);
    // p₁·Z₁/f = p₂·Z₂/f
    let with_f = TwoShots {
        focal_length: Some(Measured::from_base(3000.0, 0.0)),
        ..shots
    };
    let size = with_f.solve().unwrap().size.unwrap();
    assert_near(size.value.m(), 1429.0 * 1.823_951 / 3000.0, 1e-5);
    // σ of each by differences, pixel by pixel.
    let of = |far: f64, near: f64| {
        let moved = TwoShots {
            far_width: Measured::from_base(far, 0.0),
            near_width: Measured::from_base(near, 0.0),
            ..with_f
        };
        let solution = moved.solve().unwrap();
        [solution.far.value.m(), solution.near.value.m(), solution.size.unwrap().value.m()]
    };
    let (by_far, by_near, at) = (of(1162.0 + 1e-3, 1429.0), of(1162.0, 1429.0 + 1e-3), of(1162.0, 1429.0));
    for (index, sigma) in [solution.far.sigma.m(), solution.near.sigma.m(), size.sigma.m()]
        .into_iter()
        .enumerate()
    {
        let slopes = [by_far, by_near].map(|moved| (moved[index] - at[index]) / 1e-3 * 3.0);
        assert_near(sigma / slopes[0].hypot(slopes[1]), 1.0, 1e-4);
    }
    let swapped = TwoShots {
        far_width: shots.near_width,
        near_width: shots.far_width,
        ..shots
    };
    let refused = |refusal| {
        Err(Unsolvable::Value {
            term: Term::NearWidth,
            refusal,
        })
    };
    assert_eq!(swapped.solve(), refused(Refusal::Negative));
    let same = TwoShots {
        near_width: shots.far_width,
        ..shots
    };
    assert_eq!(same.solve(), refused(Refusal::Zero));
}

fn pair_of_points(sigma: f64) -> TwoPoints {
    let at = |u, v, d| StereoPoint {
        column: px(u),
        row: px(v),
        disparity: Measured::from_base(d, sigma),
    };
    TwoPoints {
        fx: Measured::from_base(452.9, 0.0),
        fy: px(452.9),
        is_vertical: false,
        baseline: Measured::from_base(0.075, 0.0),
        doffs: Measured::from_base(0.0, 0.0),
        cx: px(298.85),
        cy: px(245.52),
        from: at(138.0, 219.0, 36.0),
        to: at(264.0, 216.0, 30.0),
    }
}

#[test]
fn two_stereo_points_are_a_length_apart() {
    let solution = pair_of_points(0.5).solve().unwrap();
    assert_near(solution.distance.value.m(), 0.3122, 5e-5);
    assert_near(solution.distance.sigma.m(), 0.0112, 5e-5);
    // 33.9675/30 − 33.9675/36
    assert_near(solution.dz.value.m(), 0.188_708, 1e-6);
    assert_near(solution.dx.value.m(), 0.247_979, 1e-6);
    assert_near(solution.dy.value.m(), -0.018_55, 1e-6);
}

#[test]
fn the_sigmas_between_two_points_are_what_their_inputs_move() {
    let all = |pair: TwoPoints| {
        let TwoPointsSolution { distance, dx, dy, dz } = pair.solve().unwrap();
        [distance, dx, dy, dz]
    };
    let step = 1e-4;
    let base = pair_of_points(0.0);
    // Each input moved by `by`, with a σ.
    let cases: [fn(&mut TwoPoints, f64, f64); 5] = [
        |pair, by, sigma| pair.from.disparity = Measured::from_base(36.0 + by, sigma),
        |pair, by, sigma| pair.to.disparity = Measured::from_base(30.0 + by, sigma),
        |pair, by, sigma| pair.doffs = Measured::from_base(by, sigma),
        |pair, by, sigma| pair.baseline = Measured::from_base(0.075 + 0.01 * by, 0.01 * sigma),
        |pair, by, sigma| {
            pair.fx = Measured::from_base(452.9 + by, sigma);
            pair.fy = px(452.9 + by);
        },
    ];
    for change in cases {
        let with = |by: f64, sigma: f64| {
            let mut pair = base;
            change(&mut pair, by, sigma);
            all(pair)
        };
        for ((moved, base), uncertain) in with(step, 0.0).into_iter().zip(all(base)).zip(with(0.0, step)) {
            let change = (moved.value.m() - base.value.m()).abs();
            assert_near(change, uncertain.sigma.m(), 1e-3 * uncertain.sigma.m() + 1e-12);
        }
    }
}

proptest! {
    /// A vertical pair is a horizontal one on its side.
    #[test]
    fn a_pair_on_its_side_sees_the_same_length(u in 0.0..600.0_f64, v in 0.0..480.0_f64, d in 5.0..60.0_f64) {
        let mut upright = pair_of_points(0.3);
        upright.fy = px(500.0);
        upright.to = StereoPoint { column: px(u), row: px(v), disparity: Measured::from_base(d, 0.3) };
        let turned = |point: StereoPoint| StereoPoint { column: point.row, row: point.column, ..point };
        let lying = TwoPoints {
            fx: Measured::from_base(500.0, 0.0),
            fy: px(452.9),
            is_vertical: true,
            cx: upright.cy,
            cy: upright.cx,
            from: turned(upright.from),
            to: turned(upright.to),
            ..upright
        };
        let (a, b) = (upright.solve().unwrap(), lying.solve().unwrap());
        prop_assert!((a.distance.value.m() / b.distance.value.m() - 1.0).abs() < 1e-9);
        prop_assert!((a.distance.sigma.m() / b.distance.sigma.m() - 1.0).abs() < 1e-9);
    }
}
