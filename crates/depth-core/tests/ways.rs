//! Every way that people count: angles, lengths on the sensor, heights, balls, vertical pairs, near lenses, a step, two points, and
//! another zero. The figures are worked out by hand, and where the comment says so with other formulas.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{assert_near, px};
use depth_core::angle::{Angle, AngleUnit};
use depth_core::camera::{Along, PointView};
use depth_core::in_image::InImage;
use depth_core::judge::{Refusal, Term, Unsolvable};
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Outcome, Problem};
use depth_core::quantity::{Length, LengthUnit};
use depth_core::setup::{Object, Pair};
use depth_core::stereo;
use depth_core::two_points::{StereoPoint, TwoPoints};
use depth_core::two_shots::TwoShots;
use proptest::prelude::*;

fn problem(values: &[(Field, f64)]) -> Problem {
    let mut problem = Problem::default();
    for &(field, value) in values {
        problem.set(field, Some(value));
    }
    problem
}

fn by_angle(field: Field, value: f64, sigma: f64, unit: AngleUnit, length: (Field, f64)) -> Problem {
    let mut problem = problem(&[length]);
    let angle = Measured::new(Angle::new(value, unit), Angle::new(sigma, unit));
    problem.set_in_image(field, InImage::Angle(angle));
    problem
}

fn stereo_of(problem: &Problem) -> f64 {
    problem.solve().stereo.distance().unwrap().m()
}

fn monocular_of(problem: &Problem) -> f64 {
    problem.solve().monocular.distance().unwrap().m()
}

#[test]
fn an_angle_and_a_size_need_no_focal_length() {
    let inches = Length::new(10.0, LengthUnit::Inch).m();
    for (unit, sigma, distance, by_sigma) in [
        (AngleUnit::Milliradian, 0.05, 338.667, 22.58),
        (AngleUnit::NatoMil, 0.05, 344.96, 23.0),
    ] {
        let target = by_angle(Field::ImageWidth, 0.75, sigma, unit, (Field::RealWidth, inches));
        let solution = target.solve();
        assert_near(solution.monocular.distance().unwrap().m(), distance, 0.01);
        assert_near(solution.monocular_uncertainty.unwrap().sigma.m(), by_sigma, 0.01);
    }
    // The width of the sun, half a degree: it looks 114.59 times as far away as it is wide.
    let sun = by_angle(Field::ImageWidth, 0.5, 0.0, AngleUnit::Degree, (Field::RealWidth, 1.0));
    assert_near(monocular_of(&sun), 114.590_8, 1e-3);
    // 90° is as wide as twice the distance.
    let wide = by_angle(Field::ImageWidth, 90.0, 0.0, AngleUnit::Degree, (Field::RealWidth, 1.0));
    assert_near(monocular_of(&wide), 0.5, 1e-12);
    // Two eyes.
    let eyes = by_angle(Field::Disparity, 0.5, 0.0, AngleUnit::Arcminute, (Field::Baseline, 0.065));
    assert_near(stereo_of(&eyes), 446.9, 0.1);
}

#[test]
fn every_unit_of_angle_is_a_part_of_the_circle() {
    for (unit, of_circle) in [
        (AngleUnit::Degree, 360.0),
        (AngleUnit::Arcminute, 21_600.0),
        (AngleUnit::Arcsecond, 1_296_000.0),
        (AngleUnit::Radian, std::f64::consts::TAU),
        (AngleUnit::Milliradian, 6_283.185_307_179_586),
        (AngleUnit::MinuteOfAngle, 21_600.0),
        (AngleUnit::NatoMil, 6400.0),
    ] {
        let circle = Angle::new(of_circle, unit);
        assert_near(circle.radians(), std::f64::consts::TAU, 1e-12);
        assert_near(circle.in_unit(unit), of_circle, 1e-9 * of_circle);
    }
}

#[test]
fn an_angle_does_not_share_the_focal_length_with_the_other_method() {
    let mut both = by_angle(Field::ImageWidth, 0.2, 0.004, AngleUnit::Radian, (Field::RealWidth, 0.3));
    for (field, value) in [(Field::FocalLength, 700.0), (Field::Baseline, 0.1), (Field::Disparity, 50.0)] {
        both.set(field, Some(value));
    }
    both.set_sigma(Field::FocalLength, 14.0);
    both.set_sigma(Field::Disparity, 0.5);
    let solution = both.solve();
    // 2 % and 1 % against 2 %: ln of the ratio over √(0.02² + 0.01² + 0.0201²).
    let (z1, z2) = (1.4, 0.3 / (2.0 * 0.1_f64.tan()));
    let r2 = 0.004 * (1.0 + 0.1_f64.tan().powi(2)) / (2.0 * 0.1_f64.tan());
    let expected = (z1 / z2).ln().abs() / (0.02_f64.powi(2) + 0.01_f64.powi(2) + r2 * r2).sqrt();
    assert_near(solution.comparison.unwrap().agreement.unwrap().z, expected, 1e-9);
    assert!(!solution.best().unwrap().has_focal_length);
}

#[test]
fn lengths_on_the_film_go_with_a_focal_length_in_a_length() {
    let mut pair = Problem::default();
    let mm = |value| Measured::exact(Length::new(value, LengthUnit::Millimeter));
    pair.set_in_image(Field::FocalLength, InImage::OnSensor(mm(152.44)));
    pair.set_in_image(Field::Disparity, InImage::OnSensor(mm(36.25)));
    pair.set(Field::Baseline, Some(Length::new(576.66, LengthUnit::Foot).m()));
    // 576.66 ft · 152.44/36.25
    let distance = pair.solve().stereo.distance().unwrap().in_unit(LengthUnit::Foot);
    assert_near(distance, 2424.99, 0.01);
    // The focal length of the camera is the principal distance: nothing is added to it.
    pair.lens = Some(Length::from_m(0.15244));
    assert_near(pair.solve().stereo.distance().unwrap().in_unit(LengthUnit::Foot), distance, 1e-9);
    // Without the size of a pixel, pixels and lengths have nothing to do with each other.
    pair.set_in_image(Field::Disparity, InImage::from_px(50.0));
    let refused = Outcome::Refused {
        field: Field::Disparity,
        refusal: Refusal::OtherUnit,
    };
    assert_eq!(pair.solve().stereo, refused);
}

#[test]
fn heights_and_vertical_pairs_count_in_rows() {
    let mut person = problem(&[(Field::FocalLength, 600.0), (Field::ImageWidth, 100.0), (Field::RealWidth, 1.8)]);
    assert_near(monocular_of(&person), 10.8, 1e-12);
    person.object = Object::Height;
    // fy is fx where it is not given.
    assert_near(monocular_of(&person), 10.8, 1e-12);
    person.set(Field::Fy, Some(853.0));
    assert_near(monocular_of(&person), 15.354, 1e-12);
    // It is as well known as fx, with which it scales.
    person.set_sigma(Field::FocalLength, 6.0);
    assert_near(person.solve().monocular_uncertainty.unwrap().sigma.m(), 0.153_54, 1e-9);
    // An fy that cannot be used is no fx.
    person.set(Field::Fy, Some(-853.0));
    assert!(matches!(person.solve().monocular, Outcome::Refused { field: Field::Fy, .. }));

    let mut pair = problem(&[(Field::Fy, 768.4), (Field::Baseline, 0.025), (Field::Disparity, 20.0)]);
    pair.pair = Pair::Vertical;
    assert_near(stereo_of(&pair), 0.9605, 1e-12);
    assert_near(pair.solve().one_pixel_range().unwrap().0.m(), 19.21 / 21.0, 1e-12);
}

#[test]
fn the_outline_of_a_near_ball_is_wider_than_its_diameter() {
    let mut ball = problem(&[(Field::FocalLength, 1000.0), (Field::ImageWidth, 408.248), (Field::RealWidth, 0.2)]);
    ball.object = Object::Ball;
    assert_near(monocular_of(&ball), 0.5, 1e-6);
    // Half of the cone's angle has the sine R/D.
    let mut by_cone = by_angle(
        Field::ImageWidth,
        2.0 * (0.1_f64 / 0.5).asin(),
        0.0,
        AngleUnit::Radian,
        (Field::RealWidth, 0.2),
    );
    by_cone.object = Object::Ball;
    assert_near(monocular_of(&by_cone), 0.5, 1e-12);
    // Far away it is a disk.
    ball.set(Field::ImageWidth, Some(1.0));
    assert_near(monocular_of(&ball), 200.0, 1e-4);
    // Its σ by differences: of w_img, of f and of the diameter.
    for (field, step) in [(Field::ImageWidth, 1e-3), (Field::FocalLength, 1e-3), (Field::RealWidth, 1e-6)] {
        let mut ball = ball;
        ball.set(Field::ImageWidth, Some(408.248));
        let value = ball.get(field).unwrap();
        let at = |value| {
            let mut moved = ball;
            moved.set(field, Some(value));
            monocular_of(&moved)
        };
        let slope = (at(value + step) - at(value - step)).abs() / 2.0;
        ball.set_sigma(field, step);
        assert_near(ball.solve().monocular_uncertainty.unwrap().sigma.m() / slope, 1.0, 1e-6);
    }
}

#[test]
fn a_lens_that_is_focused_near_adds_its_own_focal_length() {
    // 15 mm on pixels of 16 µm: 937.5 px. 100 mm · 937.5/350 + 15 mm.
    let mut object = problem(&[
        (Field::FocalLength, 937.5),
        (Field::ImageWidth, 350.0),
        (Field::RealWidth, 0.1),
        (Field::Lens, 0.015),
    ]);
    assert_near(monocular_of(&object), 0.282_857, 1e-6);
    // The thin lens: an image at 1/(1/f − 1/D), 100 mm there are 350 pixels of 16 µm.
    let image = 1.0 / (1.0 / 0.015 - 1.0 / monocular_of(&object));
    assert_near(0.1 * image / monocular_of(&object) / 16e-6, 350.0, 1e-9);
    // What the width should be does not change with it.
    assert_near(object.solve().estimated_width.unwrap().m(), 0.1, 1e-12);
    assert_near(object.solve().estimated_width_px.unwrap().px(), 350.0, 1e-9);
    let pair = problem(&[
        (Field::FocalLength, 4000.0),
        (Field::Baseline, 0.02),
        (Field::Disparity, 400.0),
        (Field::Lens, 0.016),
    ]);
    assert_near(stereo_of(&pair), 0.216, 1e-12);
    // An angle does not depend on the lens.
    object.set_in_image(Field::ImageWidth, InImage::Angle(Measured::from_base(0.2, 0.0)));
    assert_near(monocular_of(&object), 0.05 / 0.1_f64.tan(), 1e-12);
}

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

#[test]
fn a_baseline_that_is_not_square_counts_with_the_sine() {
    let effective = |degrees| stereo::effective_baseline(Length::from_m(100.0), Angle::from_degrees(degrees)).map(Length::m);
    assert_near(effective(60.0).unwrap(), 86.602_54, 1e-5);
    assert_near(effective(90.0).unwrap(), 100.0, 1e-12);
    assert_near(effective(120.0).unwrap(), 86.602_54, 1e-5);
    assert_eq!((effective(0.0), effective(180.0), effective(-30.0)), (None, None, None));
}

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
    assert_near(solution.dx.m(), 0.247_979, 1e-6);
    assert_near(solution.dy.m(), -0.018_55, 1e-6);
}

#[test]
fn the_sigma_of_a_length_between_two_points_is_what_its_inputs_move() {
    let base = pair_of_points(0.0);
    let length = |pair: TwoPoints| pair.solve().unwrap().distance.value.m();
    let sigma = |pair: TwoPoints| pair.solve().unwrap().distance.sigma.m();
    let step = 1e-4;
    let cases: [(TwoPoints, TwoPoints); 3] = [
        (
            TwoPoints {
                doffs: Measured::from_base(step, 0.0),
                ..base
            },
            TwoPoints {
                doffs: Measured::from_base(0.0, step),
                ..base
            },
        ),
        (
            TwoPoints {
                baseline: Measured::from_base(0.075 + 1e-6, 0.0),
                ..base
            },
            TwoPoints {
                baseline: Measured::from_base(0.075, 1e-6),
                ..base
            },
        ),
        (
            TwoPoints {
                fx: Measured::from_base(452.9 + step, 0.0),
                fy: px(452.9 + step),
                ..base
            },
            TwoPoints {
                fx: Measured::from_base(452.9, step),
                ..base
            },
        ),
    ];
    for (moved, uncertain) in cases {
        assert_near((length(moved) - length(base)).abs() / sigma(uncertain), 1.0, 1e-3);
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
