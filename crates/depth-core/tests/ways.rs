//! Every way that people count: angles, lengths on the sensor, heights, balls, vertical pairs, near lenses, a step, two points, and
//! another zero. The figures are worked out by hand, and where the comment says so with other formulas.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{assert_near, problem};
use depth_core::angle::{Angle, AngleUnit};
use depth_core::in_image::InImage;
use depth_core::judge::Refusal;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Outcome, Problem};
use depth_core::quantity::{Length, LengthUnit};
use depth_core::setup::{Object, Pair};
use depth_core::stereo;

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

/// The ends of the interval are the distances at α + σ and α − σ, however wide the angle.
#[test]
fn the_interval_of_a_wide_angle_is_exact() {
    for (degrees, sigma, near, far) in [
        (60.0, 6.0, 0.3080, 0.3925),
        (100.0, 10.0, 0.1400, 0.2000),
        (150.0, 7.5, 0.0398, 0.0679),
        (175.0, 8.75, 0.0, 0.02414),
    ] {
        let wide = by_angle(Field::ImageWidth, degrees, sigma, AngleUnit::Degree, (Field::RealWidth, 0.4));
        let interval = wide.solve().monocular_uncertainty.unwrap().interval;
        assert_near(interval.near.m(), near, 1e-4);
        assert_near(interval.far.unwrap().m(), far, 1e-4);
    }
    let vague = by_angle(Field::ImageWidth, 1.0, 2.0, AngleUnit::Degree, (Field::RealWidth, 0.4));
    assert_eq!(vague.solve().monocular_uncertainty.unwrap().interval.far, None);
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
fn a_baseline_that_is_not_square_counts_with_the_sine() {
    let effective = |degrees| stereo::effective_baseline(Length::from_m(100.0), Angle::from_degrees(degrees)).map(Length::m);
    assert_near(effective(60.0).unwrap(), 86.602_54, 1e-5);
    assert_near(effective(90.0).unwrap(), 100.0, 1e-12);
    assert_near(effective(120.0).unwrap(), 86.602_54, 1e-5);
    assert_eq!((effective(0.0), effective(180.0), effective(-30.0)), (None, None, None));
}

#[test]
fn an_fy_with_a_sigma_of_its_own_is_not_shared_with_fx() {
    let mut both = problem(&[
        (Field::FocalLength, 700.0),
        (Field::Fy, 700.0),
        (Field::Baseline, 0.1),
        (Field::Disparity, 3.5),
        (Field::ImageWidth, 70.0),
        (Field::RealWidth, 2.0),
    ]);
    both.object = Object::Height;
    for (field, sigma) in [(Field::Fy, 70.0), (Field::ImageWidth, 0.5), (Field::Disparity, 0.1)] {
        both.set_sigma(field, sigma);
    }
    // 20 m to 1/35 and to √(0.1² + (0.5/70)²).
    let (r1, r2) = (1.0 / 35.0, 0.1_f64.hypot(0.5 / 70.0));
    let expected = 20.0 * r1 * r2 / f64::hypot(r1, r2);
    assert_near(both.solve().combined.unwrap().sigma.m(), expected, 1e-9);
    // Without one it has that of fx, and they share it.
    both.set_sigma(Field::Fy, 0.0);
    both.set_sigma(Field::FocalLength, 70.0);
    let (r1, r2) = (1.0 / 35.0, 0.5 / 70.0);
    let expected = 20.0 * (r1 * r2 / f64::hypot(r1, r2)).hypot(0.1);
    assert_near(both.solve().combined.unwrap().sigma.m(), expected, 1e-9);
}
