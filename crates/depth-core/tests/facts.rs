//! What data sheets say of a camera, and its focal length: figures of vendors and standards, and there and back.
#![allow(clippy::unwrap_used, reason = "tests")]

use depth_core::angle::Angle;
use depth_core::camera::{FilmExtent, Projection, diagonal, focal_length_from_field_of_view, focused_image_distance, focused_lens};
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

proptest! {
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
