//! What data sheets say of a camera, and its focal length: figures of vendors and standards, and there and back.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, reason = "tests")]

use depth_core::angle::Angle;
use depth_core::camera::{
    CameraAnswer, CameraFacts, CameraProblem, CameraRemark, Cause, Fact, FilmExtent, Projection, Sensor, SensorRemark, Side, diagonal,
    focal_length_from_field_of_view, focused_image_distance, focused_lens,
};
use depth_core::quantity::{Length, Pixels};
use proptest::prelude::*;

#[test]
fn a_fisheye_of_120_degrees_over_3_63_mm() {
    // In micrometers of the sensor: the figures do not depend on the unit.
    for (projection, expected) in [
        (Projection::Equisolid, 1815.0),
        (Projection::Equidistant, 1733.0),
        (Projection::Pinhole, 1048.0),
    ] {
        let f = projection
            .focal_length(Angle::from_degrees(120.0), Pixels::new(3630.0))
            .unwrap()
            .px();
        assert!((f - expected).abs() < 0.6, "{projection:?}: {f}");
    }
}

#[test]
fn three_views_of_one_sensor_that_exclude_one_another() {
    // OV9282 at 1280 × 800.
    let diagonal = diagonal(Pixels::new(1280.0), Pixels::new(800.0));
    for (degrees, extent, expected) in [
        (71.86, Pixels::new(1280.0), 883.2),
        (83.76, diagonal, 841.7),
        (56.74, Pixels::new(800.0), 740.7),
    ] {
        let view = Angle::from_degrees(degrees);
        let f = Projection::Pinhole.focal_length(view, extent).unwrap();
        assert!((f.px() - expected).abs() < 0.06, "{f:?}");
        assert_eq!(focal_length_from_field_of_view(view, extent), Some(f), "the same formula");
    }
}

#[test]
fn twenty_six_millimeters_of_film_by_the_diagonal_and_by_the_width() {
    let size = [Pixels::new(4032.0), Pixels::new(3024.0)];
    let f = |extent: FilmExtent| extent.focal_length(Length::from_m(0.026), size).unwrap().px();
    assert!((f(FilmExtent::Diagonal) - 3029.0).abs() < 0.6, "{}", f(FilmExtent::Diagonal));
    assert!((f(FilmExtent::Width) - 2912.0).abs() < 1e-9);
}

#[test]
fn no_lens_sees_what_its_projection_cannot() {
    let view = |projection: Projection, degrees: f64| projection.focal_length(Angle::from_degrees(degrees), Pixels::new(100.0));
    assert_eq!(view(Projection::Pinhole, 180.0), None);
    assert_eq!(view(Projection::Orthographic, 200.0), None);
    assert_eq!(view(Projection::Stereographic, 360.0), None);
    assert!(view(Projection::Equidistant, 360.0).is_some());
    assert_eq!(view(Projection::Equisolid, -10.0), None);
    // An image larger than what the lens can see.
    assert_eq!(Projection::Orthographic.view(Pixels::new(10.0), Pixels::new(100.0)), None);
    assert_eq!(focused_image_distance(Length::from_m(0.05), Length::from_m(0.05)), None);
}

fn stated(size: [f64; 2], facts: &[Fact]) -> CameraFacts {
    CameraFacts {
        size: size.map(Pixels::new),
        facts: facts.to_vec(),
        sensor: Sensor::default(),
        focused_at: None,
        projection: Projection::Pinhole,
        is_under_water: false,
    }
}

fn millimeters(value: f64) -> Option<Length> {
    Some(Length::from_m(value / 1000.0))
}

/// Golden: `cv2.calibrationMatrixValues` of OpenCV 4.6.0, with the principal point in the middle of the image.
#[test]
fn views_and_lens_are_those_of_opencv() {
    for (f, size, aperture, expected) in [
        (
            [700.0, 700.0],
            [1280.0, 720.0],
            [4.8, 2.7],
            [84.87245957707, 54.432223114614956, 2.625],
        ),
        (
            [631.343, 630.2],
            [1280.0, 720.0],
            [3.84, 2.16],
            [90.78028021909604, 59.474095702772956, 1.894_028_999_999_999_7],
        ),
        (
            [1733.74, 1735.2],
            [1920.0, 1080.0],
            [7.2, 4.05],
            [57.94802262776904, 34.572630334113, 6.501525],
        ),
        (
            [378.806, 378.806],
            [640.0, 480.0],
            [1.92, 1.44],
            [80.37954502512359, 64.71421565032014, 1.136418],
        ),
    ] {
        let [fx, fy] = f.map(Pixels::new);
        let [width, height] = aperture.map(millimeters);
        let facts = CameraFacts {
            sensor: Sensor {
                width,
                height,
                ..Sensor::default()
            },
            ..stated(size, &[Fact::Fx(fx), Fact::Fy(fy)])
        };
        let answer = facts.solve().unwrap();
        let found = [
            answer.views[0].unwrap().degrees(),
            answer.views[1].unwrap().degrees(),
            answer.lens.unwrap().m() * 1000.0,
        ];
        for (found, expected) in found.into_iter().zip(expected) {
            assert!((found / expected - 1.0).abs() < 1e-12, "{found} is not {expected}");
        }
        assert_eq!(answer.remarks, []);
    }
}

#[test]
fn three_views_are_named_with_what_each_says_and_the_first_is_followed() {
    let view = Angle::from_degrees;
    let facts = [
        Fact::HorizontalView(view(71.86)),
        Fact::DiagonalView(view(83.76)),
        Fact::VerticalView(view(56.74)),
    ];
    let answer = stated([1280.0, 800.0], &facts).solve().unwrap();
    assert!((answer.fx.px() - 883.2).abs() < 0.06);
    let [
        CameraRemark::Contradiction {
            is_of_fy: false, facts, ..
        },
    ] = &answer.remarks[..]
    else {
        panic!("{:?}", answer.remarks)
    };
    let said: Vec<f64> = facts.iter().map(|(_, f)| (f.px() * 10.0).round() / 10.0).collect();
    assert_eq!(said, [883.2, 841.7, 740.7]);
}

/// What explains a contradiction, each from the figures of the reference: OV9282's nominal views, a fisheye of 120° over 3.63 mm, rows that
/// were cut, 26 mm counted in both ways.
#[test]
fn a_contradiction_has_a_cause_only_where_one_explains_it() {
    let cause = |facts: &CameraFacts| {
        let answer = facts.solve().unwrap();
        let found = answer.remarks.into_iter().find_map(|remark| match remark {
            CameraRemark::Contradiction { cause, .. } => Some(cause),
            _ => None,
        });
        found.unwrap()
    };
    let view = Angle::from_degrees;
    let two = [Fact::HorizontalView(view(71.86)), Fact::DiagonalView(view(83.76))];
    assert_eq!(cause(&stated([1280.0, 800.0], &two)), None, "by chance a fisheye would fit");
    let fisheye = CameraFacts {
        sensor: Sensor {
            diagonal: millimeters(3.63),
            ..Sensor::default()
        },
        ..stated(
            [2904.0, 2178.0],
            &[Fact::DiagonalView(view(120.0)), Fact::Lens(Length::from_m(0.001_815))],
        )
    };
    assert_eq!(cause(&fisheye), Some(Cause::Fisheye(Projection::Equisolid)));
    let cut = [Fact::HorizontalView(view(61.927_51)), Fact::VerticalView(view(48.455_48))];
    let Some(Cause::Cut {
        at: 1,
        side: Side::Height,
        before,
        now,
    }) = cause(&stated([1600.0, 800.0], &cut))
    else {
        panic!("rows were cut")
    };
    assert!((before.px() - 1200.0).abs() < 0.01 && now == Pixels::new(800.0), "{before:?}");
    let film = [FilmExtent::Diagonal, FilmExtent::Width].map(|extent| Fact::Film(extent, Length::from_m(0.026)));
    assert_eq!(cause(&stated([4032.0, 3024.0], &film)), Some(Cause::Film));
}

#[test]
fn what_is_of_the_whole_picture_says_what_a_part_of_it_would_be() {
    let whole = |size: [f64; 2], fact: Fact| {
        let answer = stated(size, &[fact]).solve().unwrap();
        answer.remarks.into_iter().find_map(|remark| match remark {
            CameraRemark::Whole { focal_length, .. } => Some(focal_length.px().round()),
            _ => None,
        })
    };
    let film = Fact::Film(FilmExtent::Diagonal, Length::from_m(0.026));
    // 26/43.267·√(1920² + 1440²).
    assert_eq!(whole([1920.0, 1080.0], film), Some(1442.0));
    assert_eq!(whole([4032.0, 3024.0], film), None);
    let webcam = Fact::DiagonalView(Angle::from_degrees(78.0));
    // ½·√(853.3² + 480²)/tan 39°.
    assert_eq!(whole([640.0, 480.0], webcam), Some(605.0));
    assert_eq!(whole([1920.0, 1080.0], webcam), None);
}

#[test]
fn binning_and_units_of_a_sensor_are_asked_for() {
    let sensor = |pitch: f64, sides: [f64; 2]| {
        let [width, height] = sides.map(millimeters);
        Sensor {
            pitch: Some(Length::from_m(pitch)),
            width,
            height,
            diagonal: None,
        }
    };
    let remarks = |sensor: Sensor, size: [f64; 2]| sensor.pitch(size.map(Pixels::new)).unwrap().1;
    assert!(matches!(
        remarks(sensor(3e-6, [3.84, 2.4]), [640.0, 400.0])[..],
        [SensorRemark::Multiple { times: 2.0, .. }]
    ));
    assert!(matches!(
        remarks(sensor(3e-3, [3.84, 2.4]), [1280.0, 800.0])[..],
        [SensorRemark::Pitch(_), ..]
    ));
    let one = |width: Option<Length>, height: Option<Length>| Sensor {
        width,
        height,
        ..Sensor::default()
    };
    assert_eq!(remarks(one(None, millimeters(7.2)), [1600.0, 800.0]), [SensorRemark::OnlyHeight]);
    assert_eq!(remarks(one(millimeters(5.6), None), [1080.0, 1920.0]), [SensorRemark::Standing]);
    assert_eq!(remarks(one(millimeters(5.6), None), [1920.0, 1080.0]), []);
}

#[test]
fn what_was_cut_or_turned_or_does_not_fit_is_said_of_a_sensor() {
    let lens = Fact::Lens(Length::from_m(0.008));
    let with = |size: [f64; 2], sensor: Sensor| {
        CameraFacts {
            sensor,
            ..stated(size, &[lens])
        }
        .solve()
    };
    let sides = Sensor {
        width: millimeters(9.6),
        height: millimeters(7.2),
        ..Sensor::default()
    };
    let views = |answer: &CameraAnswer| [0, 1].map(|at: usize| (answer.views[at].unwrap().degrees() * 100.0).round() / 100.0);
    let cut = with([1600.0, 800.0], sides).unwrap();
    assert!((cut.fx.px() - 4000.0 / 3.0).abs() < 1e-9 && cut.fx == cut.fy);
    assert_eq!(views(&cut), [61.93, 33.40]);
    assert!(matches!(
        cut.remarks[..],
        [CameraRemark::Sensor(SensorRemark::Cut { side: Side::Height, .. })]
    ));
    // A phone that is held upright.
    let upright = with([1200.0, 1600.0], sides).unwrap();
    assert!((upright.fx.px() - 4000.0 / 3.0).abs() < 1e-9);
    assert_eq!(upright.remarks, [CameraRemark::Sensor(SensorRemark::Turned)]);
    let other = Sensor {
        diagonal: millimeters(6.0),
        ..sides
    };
    assert!(matches!(
        with([1600.0, 1200.0], other).unwrap().remarks[..],
        [CameraRemark::Sensor(SensorRemark::Diagonal { .. })]
    ));
    let short = Sensor { height: None, ..other };
    assert_eq!(with([1600.0, 1200.0], short), Err(CameraProblem::ShortDiagonal));
    assert_eq!(with([1600.0, 1200.0], Sensor::default()), Err(CameraProblem::NoPitch(0)));
    // A lens beside something else says how large a pixel is.
    let both = stated([1280.0, 720.0], &[Fact::Fx(Pixels::new(1000.0)), lens]).solve().unwrap();
    assert!((both.pitch.unwrap().m() - 8e-6).abs() < 1e-18 && both.fx.px() == 1000.0);
    assert!((both.sensor[0].unwrap().m() - 0.01024).abs() < 1e-15, "{both:?}");
}

proptest! {
    #[test]
    fn every_fact_that_follows_leads_back(fx in 200.0_f64..5000.0, width in 100.0_f64..8000.0, height in 100.0_f64..8000.0, pitch in 0.5e-6_f64..20e-6) {
        let sensor = Sensor { pitch: Some(Length::from_m(pitch)), ..Sensor::default() };
        let solve = |fact: Fact| CameraFacts { sensor, ..stated([width, height], &[fact]) }.solve().unwrap();
        let all = solve(Fact::Fx(Pixels::new(fx)));
        let [across, down, diagonal] = all.views.map(Option::unwrap);
        let [by_diagonal, by_width] = all.film.map(Option::unwrap);
        for fact in [
            Fact::Fy(all.fy),
            Fact::HorizontalView(across),
            Fact::VerticalView(down),
            Fact::DiagonalView(diagonal),
            Fact::Film(FilmExtent::Diagonal, by_diagonal),
            Fact::Film(FilmExtent::Width, by_width),
            Fact::Lens(all.lens.unwrap()),
            Fact::P00(2.0 * all.fx.px() / width),
            Fact::P11(2.0 * all.fy.px() / height),
        ] {
            let back = solve(fact).fx.px();
            prop_assert!((back / fx - 1.0).abs() < 1e-12, "{fact:?}: {back}");
        }
    }

    #[test]
    fn a_view_leads_to_a_focal_length_and_back(at in 0..5_usize, degrees in 1.0_f64..170.0, extent in 10.0_f64..10_000.0) {
        let projection = Projection::ALL.into_iter().nth(at).unwrap();
        let extent = Pixels::new(extent);
        let f = projection.focal_length(Angle::from_degrees(degrees), extent).unwrap();
        let back = projection.view(f, extent).unwrap();
        // An arc sine near 1 loses half of the digits.
        let tolerance = if degrees > 160.0 { 1e-6 } else { 1e-12 };
        prop_assert!((back.degrees() / degrees - 1.0).abs() < tolerance, "{} {}", back.degrees(), degrees);
    }

    #[test]
    fn film_and_focus_go_both_ways(equivalent in 0.005_f64..1.0, width in 100.0_f64..10_000.0, height in 100.0_f64..10_000.0, s in 1.5_f64..1e5) {
        let size = [Pixels::new(width), Pixels::new(height)];
        for extent in [FilmExtent::Diagonal, FilmExtent::Width] {
            let f = extent.focal_length(Length::from_m(equivalent), size).unwrap();
            prop_assert!((extent.equivalent(f, size).unwrap().m() / equivalent - 1.0).abs() < 1e-12);
        }
        let v = focused_image_distance(Length::from_m(equivalent), Length::from_m(s)).unwrap();
        prop_assert!((focused_lens(v, Length::from_m(s)).unwrap().m() / equivalent - 1.0).abs() < 1e-12);
    }
}
