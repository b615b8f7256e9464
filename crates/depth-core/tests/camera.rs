//! Where a camera's numbers come from: OpenCV's and the makers' figures, exact geometry, every magnitude.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{assert_near, px};
use depth_core::angle::Angle;
use depth_core::camera::{
    BelowAxis, GroundSolution, GroundView, Intrinsics, RightOfAxis, diagonal, field_of_view, focal_length_from_field_of_view,
    focal_length_from_pixel_pitch, focal_length_from_reference_photo, focal_length_from_sensor_width, foreshortened, pixel_size,
};
use depth_core::judge::{Refusal, Term, Unsolvable};
use depth_core::measured::Measured;
use depth_core::quantity::{Length, LengthUnit};
use depth_generators::any_sign_and_magnitude;
use proptest::prelude::*;

fn mm(value: f64) -> Length {
    Length::new(value, LengthUnit::Millimeter)
}

fn degrees(value: f64) -> Angle {
    Angle::from_degrees(value)
}

/// K = [700 0 610; 0 705 350], 1280 × 720.
fn measured_camera() -> Intrinsics {
    Intrinsics {
        fx: px(700.0),
        fy: px(705.0),
        cx: px(610.0),
        cy: px(350.0),
        width: px(1280.0),
        height: px(720.0),
    }
}

#[test]
fn opencv_gives_the_same_calibration_values() {
    let camera = measured_camera();
    assert_near(camera.horizontal_view().degrees(), 84.815_373, 5e-7);
    assert_near(camera.vertical_view().degrees(), 54.093_788, 5e-7);
    let sensor = camera.on_sensor(mm(4.8), mm(2.7)).unwrap();
    assert_near(sensor.lens.in_unit(LengthUnit::Millimeter), 2.625, 1e-12);
    assert_near(sensor.principal_x.in_unit(LengthUnit::Millimeter), 2.2875, 1e-12);
    assert_near(sensor.principal_y.in_unit(LengthUnit::Millimeter), 1.3125, 1e-12);
    assert_near(sensor.aspect_ratio, 1.007_142_9, 5e-8);
    // And back.
    let f = focal_length_from_sensor_width(mm(2.625), mm(4.8), px(1280.0)).unwrap();
    assert_near(f.px(), 700.0, 1e-10);
    let f = focal_length_from_pixel_pitch(mm(2.625), mm(4.8 / 1280.0)).unwrap();
    assert_near(f.px(), 700.0, 1e-10);
}

#[test]
fn makers_fields_of_view_give_their_focal_lengths() {
    // OAK-D (stated), OAK-D Lite, OAK-D S2, OAK-D Pro W rectified, OAK-D LR (computed): to the digits given.
    for (view, width, focal_length, tolerance) in [
        (71.9, 1280.0, 882.5, 0.5),
        (73.0, 640.0, 432.5, 0.1),
        (80.0, 1280.0, 762.7, 0.1),
        (97.0, 1280.0, 566.0, 0.5),
        (82.0, 1280.0, 736.0, 0.5),
    ] {
        let f = focal_length_from_field_of_view(degrees(view), px(width)).unwrap();
        assert_near(f.px(), focal_length, tolerance);
    }
}

#[test]
fn a_right_angle_of_view_is_twice_the_focal_length_wide() {
    let f = focal_length_from_field_of_view(degrees(90.0), px(1280.0)).unwrap();
    assert_near(f.px(), 640.0, 1e-10);
    // 3-4-5.
    let f = focal_length_from_field_of_view(degrees(90.0), diagonal(px(640.0), px(480.0))).unwrap();
    assert_near(f.px(), 400.0, 1e-10);
    let camera = Intrinsics {
        fx: px(400.0),
        width: px(640.0),
        height: px(480.0),
        ..measured_camera()
    };
    assert_near(camera.diagonal_view().degrees(), 90.0, 1e-12);
    for impossible in [0.0, -10.0, 180.0, 200.0, f64::NAN] {
        assert_eq!(focal_length_from_field_of_view(degrees(impossible), px(640.0)), None);
    }
}

#[test]
fn one_photograph_at_a_known_distance_gives_the_focal_length() {
    // The mug: 150 px wide at 1.4 m, 300 mm wide.
    let f = focal_length_from_reference_photo(px(150.0), Length::from_m(1.4), mm(300.0)).unwrap();
    assert_near(f.px(), 700.0, 1e-10);
}

#[test]
fn a_resized_camera_keeps_its_rays() {
    let camera = measured_camera();
    let half = camera.resized(px(640.0), px(360.0)).unwrap();
    assert_eq!((half.fx, half.fy), (px(350.0), px(352.5)));
    assert_eq!((half.cx, half.cy), (px(304.75), px(174.75)));
    assert_eq!(camera.resized(px(0.0), px(360.0)), None);
    // The middle of an image stays its middle.
    let centered = Intrinsics {
        cx: px(639.5),
        cy: px(359.5),
        ..camera
    };
    let third = centered.resized(px(426.0), px(240.0)).unwrap();
    assert_near(third.cx.px(), 212.5, 1e-12);
    assert_near(third.cy.px(), 119.5, 1e-12);
}

#[test]
fn a_cropped_camera_only_moves_its_principal_point() {
    let camera = measured_camera();
    let crop = camera.cropped(px(100.0), px(50.0), px(800.0), px(600.0)).unwrap();
    let expected = Intrinsics {
        cx: px(510.0),
        cy: px(300.0),
        width: px(800.0),
        height: px(600.0),
        ..camera
    };
    assert_eq!(crop, expected);
}

#[test]
fn a_pixel_and_a_depth_make_a_point_and_a_range() {
    let camera = Intrinsics {
        fx: px(500.0),
        fy: px(1000.0),
        cx: px(100.0),
        cy: px(100.0),
        ..measured_camera()
    };
    // X = 2, Y = −1, Z = 2: a ray of length 3.
    let (u, v, depth) = (px(600.0), px(-400.0), Length::from_m(2.0));
    let (x, y) = camera.point(u, v, depth).unwrap();
    assert_eq!((x, y), (Length::from_m(2.0), Length::from_m(-1.0)));
    assert_near(camera.range(u, v, depth).unwrap().m(), 3.0, 1e-15);
    assert_eq!(camera.range(camera.cx, camera.cy, depth), Some(depth));
    assert_near(pixel_size(px(700.0), Length::from_m(1.4)).unwrap().m(), 0.002, 1e-15);
    assert_eq!(pixel_size(px(0.0), depth), None);
}

#[test]
fn a_tilted_target_reads_too_long() {
    assert_near(foreshortened(Length::from_m(2.0), degrees(60.0)).unwrap().m(), 1.0, 1e-12);
    assert_eq!(foreshortened(Length::from_m(2.0), degrees(90.0)), None);
    // Exact projection of both edges of a target turned about its middle.
    for (width, depth, tilt) in [(0.1, 2.0, 30.0_f64), (0.3, 2.0, 45.0), (0.2, 1.0, -60.0)] {
        let (sin, cos) = tilt.to_radians().sin_cos();
        let edge = |side: f64| side * width / 2.0 * cos / (depth + side * width / 2.0 * sin);
        let apparent = width / (edge(1.0) - edge(-1.0));
        let corrected = foreshortened(Length::from_m(apparent), degrees(tilt)).unwrap().m();
        let second_order = (width * sin / (2.0 * depth)).powi(2);
        assert_near(corrected / depth, 1.0 - second_order, 1e-12);
    }
}

/// Row `v` ± `sigma` of a camera with f = 705 px and cy = 350.
fn row(v: f64, sigma: f64) -> BelowAxis {
    BelowAxis::Row {
        row: Measured::from_base(v, sigma),
        cy: px(350.0),
        fy: Measured::from_base(705.0, 0.0),
    }
}

fn floor_view() -> GroundView {
    GroundView {
        height: Measured::from_base(1.5, 0.02),
        pitch: Measured::from_base(10.0_f64.to_radians(), 0.5_f64.to_radians()),
        target_height: Length::from_m(0.0),
        below_axis: row(400.0, 1.5),
        right_of_axis: None,
    }
}

#[test]
fn the_ray_of_a_row_meets_the_floor_where_geometry_says() {
    // Looking 45° down along the axis: as far as high.
    let view = GroundView {
        pitch: Measured::from_base(45.0_f64.to_radians(), 0.0),
        below_axis: row(350.0, 0.0),
        ..floor_view()
    };
    assert_near(view.solve().unwrap().distance.value.m(), 1.5, 1e-12);
    // In general: turn the ray (0, t, 1) down by the pitch and cut it at the height.
    for (pitch, row) in [(0.0_f64, 360.0), (10.0, 400.0), (10.0, 300.0), (-5.0, 700.0), (30.0, 0.0)] {
        let (sin, cos) = pitch.to_radians().sin_cos();
        let t = (row - 350.0) / 705.0;
        let expected = 1.5 * (cos - t * sin) / (t * cos + sin);
        let view = GroundView {
            pitch: Measured::from_base(pitch.to_radians(), 0.0),
            below_axis: self::row(row, 0.0),
            ..floor_view()
        };
        assert_near(view.solve().unwrap().distance.value.m() / expected, 1.0, 1e-12);
    }
}

#[test]
fn the_floors_sigma_is_that_of_the_numerical_derivatives() {
    let view = floor_view();
    let at = |height: f64, pitch: f64, row: f64| {
        let moved = GroundView {
            height: Measured::from_base(view.height.value.m() + height, 0.0),
            pitch: Measured::from_base(view.pitch.value.radians() + pitch, 0.0),
            below_axis: self::row(400.0 + row, 0.0),
            ..view
        };
        moved.solve().unwrap().distance.value.m()
    };
    let step = 1e-5;
    let slopes = [
        (at(step, 0.0, 0.0) - at(-step, 0.0, 0.0)) * view.height.sigma.m(),
        (at(0.0, step, 0.0) - at(0.0, -step, 0.0)) * view.pitch.sigma.radians(),
        (at(0.0, 0.0, step) - at(0.0, 0.0, -step)) * 1.5,
    ];
    let sigma = slopes.iter().map(|slope| (slope / (2.0 * step)).powi(2)).sum::<f64>().sqrt();
    assert_near(view.solve().unwrap().distance.sigma.m() / sigma, 1.0, 1e-7);
    // The published slope for the pitch alone.
    let only_pitch = GroundView {
        height: Measured::from_base(1.5, 0.0),
        below_axis: row(400.0, 0.0),
        ..view
    };
    let found = only_pitch.solve().unwrap().distance;
    let slope = (found.value.m() * found.value.m() + 1.5 * 1.5) / 1.5;
    assert_near(found.sigma.m() / (slope * view.pitch.sigma.radians()), 1.0, 1e-12);
}

#[test]
fn above_the_horizon_there_is_no_floor() {
    let view = floor_view();
    let horizon = view.horizon_row().unwrap().px();
    assert_near(horizon, 350.0 - 705.0 * 10.0_f64.to_radians().tan(), 1e-10);
    let at = |v| GroundView {
        below_axis: row(v, 0.0),
        ..view
    };
    let missed = |horizon: f64, meets_with_opposite_pitch| {
        Err(Unsolvable::MissesPlane {
            horizon: Some(px(horizon)),
            meets_with_opposite_pitch,
        })
    };
    assert_eq!(at(horizon - 0.01).solve(), missed(horizon, false));
    assert!(at(horizon + 0.01).solve().unwrap().distance.value.m() > 1e4);
    let level = GroundView {
        pitch: Measured::from_base(0.0, 0.0),
        ..at(350.0)
    };
    assert_eq!(level.solve(), missed(350.0, false), "the horizon itself");
    // 80° and atan(250/705) make 99.525°: behind the camera, h/tan 99.525°.
    let down = GroundView {
        pitch: Measured::from_base(80.0_f64.to_radians(), 0.0),
        ..at(600.0)
    };
    assert_near(down.solve().unwrap().ahead.value.m(), -0.2517, 1e-4);
    let flat = GroundView {
        height: Measured::from_base(0.0, 0.0),
        ..view
    };
    assert_eq!(
        flat.solve(),
        Err(Unsolvable::Value {
            term: Term::CameraHeight,
            refusal: Refusal::Zero
        })
    );
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn a_field_of_view_and_its_focal_length_are_inverses(view in 0.01..179.0_f64, width in 10.0..10_000.0_f64) {
        let f = focal_length_from_field_of_view(degrees(view), px(width)).unwrap();
        let back = field_of_view(f, px(width / 2.0), px(width));
        prop_assert!((back.degrees() - view).abs() < 1e-10 * view.max(1.0), "{}", back.degrees());
    }

    #[test]
    fn a_ray_keeps_its_direction_through_resizing_and_cropping(
        u in 0.0..1280.0_f64, v in 0.0..720.0_f64, width in 100.0..4000.0_f64, height in 100.0..4000.0_f64,
        left in 0.0..500.0_f64, top in 0.0..500.0_f64,
    ) {
        let camera = measured_camera();
        let (sx, sy) = (width / 1280.0, height / 720.0);
        let resized = camera.resized(px(width), px(height)).unwrap();
        let seen = resized.cropped(px(left), px(top), px(50.0), px(50.0)).unwrap();
        // In corner-origin coordinates a resized pixel is just scaled.
        let moved = (px((u + 0.5) * sx - 0.5 - left), px((v + 0.5) * sy - 0.5 - top));
        let depth = Length::from_m(2.0);
        let before = camera.point(px(u), px(v), depth).unwrap();
        let after = seen.point(moved.0, moved.1, depth).unwrap();
        prop_assert!((before.0.m() - after.0.m()).abs() < 1e-10 && (before.1.m() - after.1.m()).abs() < 1e-10);
    }

    #[test]
    fn every_result_is_finite_at_every_magnitude(
        n in prop::array::uniform6(any_sign_and_magnitude()), z in any_sign_and_magnitude(), u in any_sign_and_magnitude(),
    ) {
        let [fx, fy, cx, cy, width, height] = n.map(px);
        let camera = Intrinsics { fx, fy, cx, cy, width, height };
        let depth = Length::from_m(z);
        for angle in [camera.horizontal_view(), camera.vertical_view(), camera.diagonal_view()] {
            prop_assert!(angle.degrees().is_finite());
        }
        prop_assert!(camera.point(px(u), px(z), depth).is_none_or(|(x, y)| x.m().is_finite() && y.m().is_finite()));
        prop_assert!(camera.range(px(u), px(z), depth).is_none_or(|range| range.m().is_finite()));
        prop_assert!(camera.resized(px(u), px(z)).is_none_or(|new| new.cx.px().is_finite() && new.fx.px().is_finite()));
        let on_sensor = camera.on_sensor(depth, depth);
        prop_assert!(on_sensor.is_none_or(|sensor| sensor.lens.m().is_finite() && sensor.aspect_ratio.is_finite()));
        prop_assert!(pixel_size(px(u), depth).is_none_or(|size| size.m().is_finite()));
        prop_assert!(diagonal(px(u), px(z)).px().is_finite());
        for f in [
            focal_length_from_field_of_view(Angle::from_radians(u), px(z)),
            focal_length_from_pixel_pitch(Length::from_m(u), depth),
            focal_length_from_sensor_width(Length::from_m(u), depth, px(n[0])),
            focal_length_from_reference_photo(px(n[0]), depth, Length::from_m(u)),
        ].into_iter().flatten() {
            prop_assert!(f.px().is_normal() && f.px() > 0.0);
        }
        let view = GroundView {
            height: Measured::from_base(n[0], n[1]),
            pitch: Measured::from_base(n[2], n[3]),
            target_height: Length::from_m(u),
            below_axis: BelowAxis::Row { row: Measured::from_base(n[4], n[5]), cy: px(u), fy: Measured::from_base(z, n[1]) },
            right_of_axis: Some(RightOfAxis { column: px(n[2]), cx: px(n[3]), fx: Measured::from_base(n[4], n[5]) }),
        };
        prop_assert!(view.horizon_row().is_none_or(|row| row.px().is_finite()));
        if let Ok(GroundSolution { distance, ahead, right, slant, .. }) = view.solve() {
            prop_assert!(distance.value.m() >= 0.0 && slant.value.m() >= 0.0);
            for part in [Some(distance), Some(ahead), right, Some(slant)].into_iter().flatten() {
                prop_assert!(part.value.m().is_finite());
                prop_assert!(part.sigma.m().is_finite() && part.sigma.m() >= 0.0);
            }
        }
    }
}
