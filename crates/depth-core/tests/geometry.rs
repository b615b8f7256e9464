//! The other ways to a distance: a point in space, a tilted target, the floor.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{assert_near, px};
use depth_core::angle::Angle;
use depth_core::camera::{Along, BelowAxis, GroundView, Intrinsics, PointView, RightOfAxis, foreshortened, resized_focal_length};
use depth_core::judge::{Refusal, Term, Unsolvable};
use depth_core::measured::Measured;
use depth_core::problem::{Field, Origin, Outcome, Problem};
use depth_core::quantity::Length;
use proptest::prelude::*;

/// 300 columns and 400 rows off the axis at f = 700 px, 1.4 m deep.
fn point_view() -> PointView {
    PointView {
        fx: Measured::exact(px(700.0)),
        fy: px(700.0),
        cx: px(640.0),
        cy: px(360.0),
        column: px(940.0),
        row: px(-40.0),
        along: Along::Axis(Measured::from_base(1.4, 0.0)),
        shift: Length::from_m(0.0),
    }
}

#[test]
fn a_pixel_and_the_depth_of_the_mug_make_a_point_and_a_range() {
    let point = point_view().solve().unwrap();
    assert_near(point.x.value.m(), 0.6, 1e-12);
    assert_near(point.y.value.m(), -0.8, 1e-12);
    assert_eq!(point.z, Measured::from_base(1.4, 0.0));
    // √(0.36 + 0.64 + 1.96)
    assert_near(point.range.value.m(), 2.96_f64.sqrt(), 1e-12);
}

#[test]
fn what_makes_no_point_is_named() {
    let value = |term, refusal| Err(Unsolvable::Value { term, refusal });
    let view = point_view();
    let flat = PointView {
        along: Along::Axis(Measured::from_base(0.0, 0.0)),
        ..view
    };
    assert_eq!(flat.solve(), value(Term::Distance, Refusal::Zero));
    let nowhere = PointView {
        column: px(f64::NAN),
        ..view
    };
    assert_eq!(nowhere.solve(), value(Term::Column, Refusal::NotANumber));
    let far_off = PointView {
        row: px(1e308),
        fy: px(1e-3),
        ..view
    };
    assert_eq!(far_off.solve(), value(Term::Row, Refusal::TooExtreme));
}

#[test]
fn a_target_turned_by_60_degrees_shows_half_its_width() {
    let shown = |tilt| foreshortened(Length::from_m(2.8), Angle::from_degrees(tilt));
    assert_near(shown(60.0).unwrap().m(), 1.4, 1e-12);
    assert_eq!(shown(0.0), Some(Length::from_m(2.8)));
    assert_eq!(shown(-60.0), shown(60.0));
    for away in [90.0, -90.0, 120.0, f64::NAN] {
        assert_eq!(shown(away), None);
    }
}

/// A door of 0.9 m that is 4.275 m away by its width, turned by 60°: half as wide, and so half as far.
#[test]
fn a_tilt_is_part_of_the_monocular_distance_and_of_every_width() {
    let mut door = Problem::default();
    for (field, value) in [(Field::FocalLength, 950.0), (Field::RealWidth, 0.9), (Field::ImageWidth, 200.0)] {
        door.set(field, Some(value));
    }
    door.set_sigma(Field::RealWidth, 0.009);
    door.set(Field::Tilt, Some(60.0_f64.to_radians()));
    let solution = door.solve();
    assert_near(solution.monocular.distance().unwrap().m(), 4.275 / 2.0, 1e-12);
    // 1 % of the width is 1 % of the distance, tilted or not.
    assert_near(solution.monocular_uncertainty.unwrap().sigma.m(), 0.02138, 1e-5);
    assert_near(solution.estimated_width.unwrap().m(), 0.9, 1e-12);
    assert_near(solution.estimated_width_px.unwrap().px(), 200.0, 1e-9);
    for (tilt, refusal) in [(90.0_f64.to_radians(), Refusal::TurnedAway), (f64::NAN, Refusal::NotANumber)] {
        door.set(Field::Tilt, Some(tilt));
        let field = Field::Tilt;
        assert_eq!(door.solve().monocular, Outcome::Refused { field, refusal });
    }
}

/// fx 700, b 100 mm, d 50 ± 2; w_img 150 ± 2, w_real 0.31, pixel 360 columns to the right of the middle. By hand: 1.4 ± 4 % and
/// 1.44667 ± 1.3333 % are combined to 1.44193 ± 1.2649 %, and a ray of (360, 0, 700).
#[test]
fn the_point_is_that_of_the_combined_distance_with_its_sigma() {
    let mut problem = Problem::default();
    for (field, value, sigma) in [
        (Field::FocalLength, 700.0, 0.0),
        (Field::Baseline, 0.1, 0.0),
        (Field::Disparity, 50.0, 2.0),
        (Field::ImageWidth, 150.0, 2.0),
        (Field::RealWidth, 0.31, 0.0),
    ] {
        problem.set(field, Some(value));
        problem.set_sigma(field, sigma);
    }
    let best = problem.solve().best().unwrap();
    assert_eq!(best.origin, Origin::Combined);
    let point = PointView {
        fx: problem.focal_length.unwrap().px().unwrap(),
        column: px(1000.0),
        row: px(360.0),
        along: Along::Axis(best.distance),
        ..point_view()
    };
    let point = point.solve().unwrap();
    assert_near(point.z.value.m(), 1.441_931, 1e-6);
    assert_near(point.range.value.m(), 1.621_445, 1e-6);
    for part in [point.x, point.z, point.range] {
        assert_near(part.relative(), 0.012_649_1, 1e-6);
    }
}

/// Against numerical derivatives of the whole way from the inputs, so that what is shared is counted once.
#[test]
fn the_sigmas_of_a_point_are_those_of_the_numerical_derivatives() {
    let (f, sigma_f) = (700.0, 14.0);
    let (kept, sigma_kept) = (0.1 / 50.0, 0.1 / 50.0 * 0.03);
    let at = |f: f64, kept: f64, range: Option<f64>| {
        let along = range.map_or_else(
            || Along::Axis(Measured::from_base(f * kept, 0.0)),
            |range| Along::Ray(Measured::from_base(range, 0.0)),
        );
        let view = PointView {
            fx: Measured::from_base(f, 0.0),
            fy: px(f * 1.1),
            along,
            ..point_view()
        };
        let point = view.solve().unwrap();
        [point.x, point.y, point.z, point.range].map(|part| part.value.m())
    };
    let slope = |plus: [f64; 4], minus: [f64; 4], sigma: f64| std::array::from_fn::<f64, 4, _>(|i| (plus[i] - minus[i]) * sigma);
    let fx = Measured::from_base(f, sigma_f);
    for range in [None, Some(1.6)] {
        let (along, own) = match range {
            None => (
                Along::Axis(Measured::from_base(f * kept, f * sigma_kept)),
                slope(
                    at(f, kept * 1.000_001, None),
                    at(f, kept * 0.999_999, None),
                    sigma_kept / kept / 2e-6,
                ),
            ),
            Some(r) => (
                Along::Ray(Measured::from_base(r, 0.05)),
                slope(at(f, kept, Some(r + 1e-6)), at(f, kept, Some(r - 1e-6)), 0.05 / 2e-6),
            ),
        };
        let shared = slope(at(f + 1e-3, kept, range), at(f - 1e-3, kept, range), sigma_f / 2e-3);
        let found = PointView {
            fx,
            fy: px(f * 1.1),
            along,
            ..point_view()
        }
        .solve()
        .unwrap();
        for (i, part) in [found.x, found.y, found.z, found.range].into_iter().enumerate() {
            let expected = (own[i] * own[i] + shared[i] * shared[i]).sqrt();
            assert_near(part.sigma.m() / expected, 1.0, 1e-6);
        }
    }
}

/// Z = 1.4 ± 0.05 m by tape, f to 2 %: X = (u − cx)·Z/f and R² = Z²·(1 + ρ²/f²) by hand.
#[test]
fn a_depth_by_tape_leaves_the_focal_length_its_part_in_the_sides() {
    let view = PointView {
        fx: Measured::from_base(700.0, 14.0),
        along: Along::GivenDepth(Measured::from_base(1.4, 0.05)),
        ..point_view()
    };
    let point = view.solve().unwrap();
    let r = 0.05 / 1.4;
    assert_near(point.z.sigma.m(), 0.05, 1e-12);
    assert_near(point.x.relative(), (r * r + 0.0004_f64).sqrt(), 1e-12);
    // Z²/R² is 1.96/2.96.
    assert_near(point.range.relative(), (r * r + 0.0004 * (1.0 / 2.96_f64).powi(2)).sqrt(), 1e-12);
}

#[test]
fn a_taped_range_gives_back_the_depth() {
    let forth = point_view().solve().unwrap();
    let back = PointView {
        along: Along::Ray(forth.range),
        ..point_view()
    };
    assert_near(back.solve().unwrap().z.value.m(), 1.4, 1e-12);
}

fn floor(height: f64, pitch: f64, fx: f64, (row, cy): (f64, f64)) -> GroundView {
    GroundView {
        height: Measured::from_base(height, 0.0),
        target_height: Length::from_m(0.0),
        pitch: Measured::exact(Angle::from_degrees(pitch)),
        below_axis: BelowAxis::Row {
            row: Measured::exact(px(row)),
            cy: px(cy),
            fy: Measured::exact(px(fx)),
        },
        right_of_axis: None,
    }
}

/// By hand, to three decimals: h/(sin θ + y·cos θ) = 3.23835 with y = 0.2; ahead 3.23835·(cos θ − 0.2·sin θ) = 3.07673, right
/// 3.23835·460/700 = 2.12806.
#[test]
fn a_pixel_beside_the_middle_is_farther_along_the_floor() {
    let view = GroundView {
        right_of_axis: Some(RightOfAxis {
            column: px(1100.0),
            cx: px(640.0),
            fx: Measured::exact(px(700.0)),
        }),
        ..floor(1.2, 10.0, 700.0, (500.0, 360.0))
    };
    let found = view.solve().unwrap();
    assert_near(found.ahead.value.m(), 3.076, 1e-3);
    assert_near(found.right.unwrap().value.m(), 2.128, 1e-3);
    assert_near(found.distance.value.m(), 3.740, 1e-3);
    assert_near(found.slant.value.m(), 3.928, 1e-3);
}

#[test]
fn a_camera_that_looks_straight_down_sees_ahead_and_behind() {
    for (row, ahead) in [(768.0, 0.0), (1268.0, -4.3125), (268.0, 4.3125)] {
        let found = floor(20.0, 90.0, 2318.84, (row, 768.0)).solve().unwrap();
        assert_near(found.ahead.value.m(), ahead, 1e-3);
        assert_near(found.distance.value.m(), ahead.abs(), 1e-3);
        assert_eq!(found.horizon_row, None);
    }
    assert_eq!(floor(20.0, 90.0, 2318.84, (768.0, 768.0)).solve().unwrap().distance.value.m(), 0.0);
}

#[test]
fn a_target_above_the_lens_is_met_by_a_ray_that_goes_up() {
    let inch = 0.0254;
    let up = GroundView {
        target_height: Length::from_m(60.0 * inch),
        below_axis: BelowAxis::Angle(Measured::exact(Angle::from_degrees(0.0))),
        ..floor(20.0 * inch, -25.0, 1.0, (0.0, 0.0))
    };
    // 40 in / tan 25°
    assert_near(up.solve().unwrap().distance.value.m(), 2.179, 5e-4);
    let level = GroundView {
        target_height: Length::from_m(20.0 * inch),
        ..up
    };
    let (term, refusal) = (Term::TargetHeight, Refusal::Zero);
    assert_eq!(level.solve(), Err(Unsolvable::Value { term, refusal }));
}

#[test]
fn a_ray_that_misses_says_whether_the_opposite_pitch_would_meet() {
    let meets = |view: GroundView| match view.solve() {
        Err(Unsolvable::MissesPlane {
            meets_with_opposite_pitch, ..
        }) => Some(meets_with_opposite_pitch),
        _ => None,
    };
    assert_eq!(meets(floor(20.0, -45.0, 700.0, (360.0, 360.0))), Some(true));
    assert_eq!(meets(floor(20.0, 0.0, 700.0, (300.0, 360.0))), Some(false));
    // Downwards all the same: nothing is wrong with it.
    assert_eq!(meets(floor(20.0, -5.0, 700.0, (700.0, 360.0))), None);
}

/// All five results against numerical derivatives, with a focal length that scales both slopes.
#[test]
fn the_sigmas_on_the_floor_are_those_of_the_numerical_derivatives() {
    let at = |height: f64, pitch: f64, row: f64, f: f64| {
        let view = GroundView {
            target_height: Length::from_m(0.2),
            right_of_axis: Some(RightOfAxis {
                column: px(1100.0),
                cx: px(640.0),
                fx: Measured::exact(px(700.0 * f)),
            }),
            ..floor(height, pitch, 720.0 * f, (row, 360.0))
        };
        let found = view.solve().unwrap();
        [found.distance, found.ahead, found.right.unwrap(), found.slant, found.depth].map(|part| part.value.m())
    };
    let sigmas = [0.03, 0.5, 2.0, 0.01];
    let given = [1.4, 12.0, 520.0, 1.0];
    let step = 1e-5;
    let mut squares = [0.0; 5];
    for i in 0..4 {
        let moved = |by: f64| {
            let mut inputs = given;
            inputs[i] += by;
            at(inputs[0], inputs[1], inputs[2], inputs[3])
        };
        let (plus, minus) = (moved(step), moved(-step));
        for (square, (plus, minus)) in squares.iter_mut().zip(plus.into_iter().zip(minus)) {
            *square += ((plus - minus) / (2.0 * step) * sigmas[i]).powi(2);
        }
    }
    let view = GroundView {
        height: Measured::from_base(given[0], sigmas[0]),
        target_height: Length::from_m(0.2),
        pitch: Measured::new(Angle::from_degrees(given[1]), Angle::from_degrees(sigmas[1])),
        below_axis: BelowAxis::Row {
            row: Measured::from_base(given[2], sigmas[2]),
            cy: px(360.0),
            fy: Measured::from_base(720.0, 7.2),
        },
        right_of_axis: Some(RightOfAxis {
            column: px(1100.0),
            cx: px(640.0),
            fx: Measured::from_base(700.0, 7.0),
        }),
    };
    let found = view.solve().unwrap();
    for (part, square) in [found.distance, found.ahead, found.right.unwrap(), found.slant, found.depth]
        .into_iter()
        .zip(squares)
    {
        assert_near(part.sigma.m() / square.sqrt(), 1.0, 1e-6);
    }
}

#[test]
fn only_the_ratio_of_the_widths_counts_for_a_resized_focal_length() {
    let f = resized_focal_length(px(631.3), px(1280.0), px(768.0));
    assert_near(f.unwrap().px(), 378.78, 1e-9);
    assert_eq!(resized_focal_length(px(700.0), px(0.0), px(640.0)), None);
    assert_eq!(resized_focal_length(px(-700.0), px(1280.0), px(640.0)), None);
}

proptest! {
    #[test]
    fn the_point_is_that_of_the_camera_matrix(
        n in prop::array::uniform4(1.0..2000.0_f64), (u, v) in (-100.0..3000.0_f64, -100.0..3000.0_f64), z in 0.1..100.0_f64,
    ) {
        let [fx, fy, cx, cy] = n.map(px);
        let depth = Length::from_m(z);
        let camera = Intrinsics { fx, fy, cx, cy, width: px(1.0), height: px(1.0) };
        let along = Along::Axis(Measured::exact(depth));
        let point = PointView { fx: Measured::exact(fx), fy, cx, cy, column: px(u), row: px(v), along, shift: Length::from_m(0.0) }.solve().unwrap();
        prop_assert_eq!(Some((point.x.value, point.y.value)), camera.point(px(u), px(v), depth));
        prop_assert_eq!(Some(point.range.value), camera.range(px(u), px(v), depth));
        // The range is never shorter than any of its sides.
        prop_assert!(point.range.value >= depth && point.range.value.m() >= point.x.value.m().abs());
    }

    #[test]
    fn a_resized_focal_length_is_that_of_the_resized_camera(f in 1.0..5000.0_f64, before in 1.0..5000.0_f64, after in 1.0..5000.0_f64) {
        let w = px(before);
        let camera = Intrinsics { fx: px(f), fy: px(f), cx: w, cy: w, width: w, height: w };
        let resized = camera.resized(px(after), px(after)).map(|camera| camera.fx);
        prop_assert_eq!(resized_focal_length(px(f), w, px(after)), resized);
    }
}
