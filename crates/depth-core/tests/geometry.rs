//! The other ways to a distance: a point in space, a tilted target, the floor.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{assert_near, px};
use depth_core::angle::Angle;
use depth_core::camera::{GroundView, Intrinsics, PointView, TiltedTarget, resized_focal_length};
use depth_core::judge::{Refusal, Term, Unsolvable};
use depth_core::measured::Measured;
use depth_core::quantity::Length;
use proptest::prelude::*;

/// 300 columns and 400 rows off the axis at f = 700 px, 1.4 m deep.
fn point_view() -> PointView {
    PointView {
        fx: px(700.0),
        fy: px(700.0),
        cx: px(640.0),
        cy: px(360.0),
        column: px(940.0),
        row: px(-40.0),
        depth: Length::from_m(1.4),
    }
}

#[test]
fn a_pixel_and_the_depth_of_the_mug_make_a_point_and_a_range() {
    let point = point_view().solve().unwrap();
    assert_near(point.x.m(), 0.6, 1e-12);
    assert_near(point.y.m(), -0.8, 1e-12);
    assert_eq!(point.z, Length::from_m(1.4));
    // √(0.36 + 0.64 + 1.96)
    assert_near(point.range.m(), 2.96_f64.sqrt(), 1e-12);
}

#[test]
fn what_makes_no_point_is_named() {
    let value = |term, refusal| Err(Unsolvable::Value { term, refusal });
    let view = point_view();
    let flat = PointView {
        depth: Length::from_m(0.0),
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
fn a_target_turned_by_60_degrees_seems_twice_as_far() {
    let target = |tilt| TiltedTarget {
        apparent: Length::from_m(2.8),
        tilt: Angle::from_degrees(tilt),
    };
    let solution = target(60.0).solve().unwrap();
    assert_near(solution.depth.m(), 1.4, 1e-12);
    assert_near(solution.excess, 1.0, 1e-12);
    assert_eq!(target(0.0).solve().unwrap().depth, Length::from_m(2.8));
    assert_eq!(target(0.0).solve().unwrap().excess, 0.0);
    assert_eq!(target(-60.0).solve(), target(60.0).solve());
    for away in [90.0, -90.0, 120.0] {
        let tilt = Angle::from_degrees(away);
        assert_eq!(target(away).solve(), Err(Unsolvable::TurnedAway { tilt }));
    }
    let refusal = Refusal::NotANumber;
    assert_eq!(target(f64::NAN).solve(), Err(Unsolvable::Value { term: Term::Tilt, refusal }));
}

#[test]
fn the_floor_is_solved_with_its_horizon() {
    let view = GroundView {
        height: Measured::new(Length::from_m(1.2), Length::from_m(0.01)),
        pitch: Measured::exact(Angle::from_degrees(45.0)),
        row: Measured::exact(px(350.0)),
        fy: px(700.0),
        cy: px(350.0),
    };
    let floor = view.solve().unwrap();
    assert_eq!(Ok(floor.distance), view.distance());
    assert_near(floor.distance.value.m(), 1.2, 1e-12);
    assert_near(floor.distance.sigma.m(), 0.01, 1e-12);
    // cy − f·tan 45°
    assert_near(floor.horizon_row.unwrap().px(), -350.0, 1e-9);
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
        let point = PointView { fx, fy, cx, cy, column: px(u), row: px(v), depth }.solve().unwrap();
        prop_assert_eq!(Some((point.x, point.y)), camera.point(px(u), px(v), depth));
        prop_assert_eq!(Some(point.range), camera.range(px(u), px(v), depth));
        // The range is never shorter than any of its sides.
        prop_assert!(point.range >= depth && point.range.m() >= point.x.m().abs());
    }

    #[test]
    fn a_resized_focal_length_is_that_of_the_resized_camera(f in 1.0..5000.0_f64, before in 1.0..5000.0_f64, after in 1.0..5000.0_f64) {
        let w = px(before);
        let camera = Intrinsics { fx: px(f), fy: px(f), cx: w, cy: w, width: w, height: w };
        let resized = camera.resized(px(after), px(after)).map(|camera| camera.fx);
        prop_assert_eq!(resized_focal_length(px(f), w, px(after)), resized);
    }
}
