//! Photographs: the ways from EXIF to a focal length. What is expected was computed by hand where it is said how.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;
mod judge;
mod photo;

use common::{pinhole, said};
use depth_files::{Basis, Format, Found, PhotoWarning, Warning, read};
use photo::Value::{Long, Rational, Short};
use photo::{DISTANCE, FILM, FOCAL_LENGTH, PLANE_UNIT, PLANE_X, PLANE_Y, Photo, TAKEN_X, TAKEN_Y, ZOOM, phone};

const PLANE: [u16; 3] = [PLANE_X, PLANE_Y, PLANE_UNIT];

fn found(photo: &Photo) -> Found {
    let found = read(&[&photo.jpeg()]).unwrap();
    assert_eq!(judge::judge(&Ok(found.clone())), Ok(()));
    found
}

fn refused(bytes: &[u8]) -> String {
    read(&[bytes]).unwrap_err().to_string()
}

fn names(found: &Found) -> Vec<&str> {
    found.cameras.iter().map(|camera| camera.name.as_str()).collect()
}

fn near(value: f64, expected: f64) {
    assert!((value - expected).abs() <= 1e-4 * expected, "{value} instead of {expected}");
}

/// What is said of the photograph, without what is said of every file.
fn photo_warnings(found: &Found) -> Vec<&PhotoWarning> {
    let all = found.warnings.iter().filter_map(|warning| match warning {
        Warning::Photo(warning) => Some(warning),
        _ => None,
    });
    all.collect()
}

fn says(found: &Found, of: impl Fn(&PhotoWarning) -> bool) -> bool {
    photo_warnings(found).into_iter().any(of)
}

#[test]
fn an_equivalent_on_film_is_two_focal_lengths_at_4_to_3_and_one_at_3_to_2() {
    let one = found(&phone().without(&PLANE));
    assert_eq!((one.format, one.format.name(), one.baseline), (Format::Exif, "exif", None));
    assert_eq!(
        names(&one),
        ["35 mm equivalent 26 mm by the diagonal", "35 mm equivalent 26 mm by the width"]
    );
    // 26 mm · 5040 px / 43.2666 mm, and 26 mm · 4032 px / 36 mm.
    near(one.cameras[0].fx.px(), 3028.66);
    near(one.cameras[1].fx.px(), 2912.0);
    let [_, fy, cx, cy] = pinhole(&one.cameras[0]);
    assert_eq!((fy, cx, cy), (one.cameras[0].fx.px(), 2016.0, 1512.0));
    assert_eq!((one.cameras[0].size, one.cameras[0].basis), (Some([4032, 3024]), Basis::Raw));
    assert!(
        said(&one).contains("at 4032 × 3024 fx by the diagonal is 4.0 % larger"),
        "{}",
        said(&one)
    );
    let one = found(&phone().without(&PLANE).without(&[TAKEN_X, TAKEN_Y]).sized(6000, 4000));
    assert_eq!(names(&one), ["35 mm equivalent 26 mm"]);
    near(one.cameras[0].fx.px(), 26.0 / 36.0 * 6000.0);
    assert!(!says(&one, |warning| matches!(warning, PhotoWarning::FilmExtents { .. })));
}

#[test]
fn an_upright_photo_has_its_longer_side_along_the_film() {
    let upright = phone().without(&PLANE).without(&[TAKEN_X, TAKEN_Y]).sized(3024, 4032);
    let one = found(&upright);
    near(one.cameras[0].fx.px(), 3028.66);
    near(one.cameras[1].fx.px(), 2912.0);
    assert_eq!(one.cameras[0].size, Some([3024, 4032]));
}

#[test]
fn the_lens_and_the_size_of_a_pixel_are_a_focal_length_in_every_unit() {
    // 1.22 µm: 25 400/1.22 = 20 819.67 pixels for an inch; 4.25 mm / 1.22 µm = 3483.6 px.
    for (unit, resolution) in [
        (Some(2), Rational(2_081_967, 100)),
        (None, Rational(2_081_967, 100)),
        (Some(1), Rational(2_081_967, 100)),
        (Some(3), Rational(8_196_721, 1000)),
        (Some(4), Rational(819_672, 1000)),
        (Some(5), Rational(819_672, 1_000_000)),
    ] {
        let mut photo = phone().without(&PLANE).with(PLANE_X, resolution);
        if let Some(unit) = unit {
            photo = photo.with(PLANE_UNIT, Short(unit));
        }
        let one = found(&photo.with(FILM, Short(30)));
        assert_eq!(names(&one)[0], "FocalPlaneXResolution: 4.25 mm at 1.22 µm");
        near(one.cameras[0].fx.px(), 3483.61);
        assert!(one.cameras[0].origin.how.contains("FocalPlaneXResolution per "));
        assert!(says(&one, |warning| matches!(warning, PhotoWarning::Agreement { .. })));
    }
}

#[test]
fn pixels_that_are_not_square_have_a_focal_length_of_their_own_down() {
    // A Canon of 2008: 5184000/894 and 3456000/597 pixels for an inch, with 50 mm.
    let canon = |x, y| {
        let plane = phone().with(PLANE_X, x).with(PLANE_Y, y).with(FOCAL_LENGTH, Rational(50, 1));
        found(&plane.without(&[FILM, TAKEN_X, TAKEN_Y]).sized(5184, 3456))
    };
    let one = canon(Rational(5_184_000, 894), Rational(3_456_000, 597));
    let [fx, fy, ..] = pinhole(&one.cameras[0]);
    near(fx, 11_414.69);
    near(fy, 11_395.84);
    let one = canon(Rational(5_184_000, 894), Rational(3_456_000, 894));
    let [fx, fy, ..] = pinhole(&one.cameras[0]);
    assert!(fx == fy && one.ignored[0].contains("FocalPlaneYResolution"), "{:?}", one.ignored);
}

#[test]
fn the_error_of_a_way_is_its_rounding_and_what_is_nominal() {
    let one = found(&phone());
    let relative = |at: usize| one.cameras[at].sigma.unwrap()[0].px() / one.cameras[at].fx.px();
    // 0.01 mm/√12 of 4.25 mm, and twice 1 %.
    near(relative(0), (0.01 / 12_f64.sqrt() / 4.25).hypot(0.01).hypot(0.01));
    // 0.5 mm/√3 of 26 mm, and 1 %.
    near(relative(1), (0.5 / 3_f64.sqrt() / 26.0).hypot(0.01));
    for (numerator, denominator, sigma_mm) in [
        (50, 1, 0.288_675),
        (350, 10, 0.028_867_5),
        (600, 100, 0.028_867_5),
        (4_250_000, 1_000_000, 0.002_886_75),
        (6_765, 1_000, 0.000_288_675),
        (807_365, 524_263, 0.002_886_75),
    ] {
        // As large a pixel as is plausible for it.
        let lens = f64::from(numerator) / f64::from(denominator);
        let photo = phone().with(FOCAL_LENGTH, Rational(numerator, denominator)).without(&[FILM]);
        let one = found(&photo);
        let relative = one.cameras[0].sigma.unwrap()[0].px() / one.cameras[0].fx.px();
        near(relative, (sigma_mm / lens).hypot(0.01).hypot(0.01));
    }
}

#[test]
fn ways_that_contradict_each_other_are_said_with_their_numbers_and_film_is_trusted() {
    // Scaled to a half by a program that left FocalPlaneXResolution, and wrote the new size.
    let small = phone().sized(2016, 1512).with(TAKEN_X, Long(2016)).with(TAKEN_Y, Long(1512));
    let one = found(&small);
    assert_eq!(names(&one)[0], "35 mm equivalent 26 mm by the diagonal");
    assert_eq!(names(&one)[2], "FocalPlaneXResolution: 4.25 mm at 1.4 µm");
    near(one.cameras[0].fx.px(), 1514.33);
    let words = said(&one);
    assert!(
        words.contains("leads to fx 1514 px, but “FocalPlaneXResolution: 4.25 mm at 1.4 µm” to 3036 px"),
        "{words}"
    );
    assert!(words.contains("The first is trusted"), "{words}");
    let one = found(&phone());
    assert_eq!(names(&one)[0], "FocalPlaneXResolution: 4.25 mm at 1.4 µm");
    assert!(!says(&one, |warning| matches!(warning, PhotoWarning::Contradiction { .. })));
    assert!(
        said(&one).contains("“FocalPlaneXResolution: 4.25 mm at 1.4 µm” and “35 mm equivalent 26 mm by the diagonal” agree"),
        "{}",
        said(&one)
    );
}

#[test]
fn a_photo_that_was_resized_is_scaled_and_one_that_was_cropped_is_not() {
    let whole = found(&phone());
    let half = found(&phone().sized(2016, 1512));
    for (whole, half) in whole.cameras.iter().zip(&half.cameras) {
        assert_eq!(whole.name, half.name);
        near(half.fx.px(), whole.fx.px() / 2.0);
        assert_eq!(half.size, Some([2016, 1512]));
    }
    assert!(said(&half).contains("it was resized, and fx is scaled with it"), "{}", said(&half));
    assert!(said(&half).contains("fx is 2 times as large"), "{}", said(&half));
    let cropped = found(&phone().sized(3024, 3024));
    for (whole, cropped) in whole.cameras.iter().zip(&cropped.cameras) {
        assert_eq!(whole.fx, cropped.fx);
        assert_eq!((cropped.cx.px(), cropped.size), (1512.0, Some([3024, 3024])));
    }
    // 1008 columns were cut off, nobody knows where: 1008/√12 = 290.99, beside 1 % of 3024.
    near(cropped.cameras[0].sigma.unwrap()[2].px(), 290.985_f64.hypot(30.24));
    near(cropped.cameras[0].sigma.unwrap()[3].px(), 30.24);
    assert!(said(&cropped).contains("it was cropped"), "{}", said(&cropped));
    // Rounded to whole pixels, and turned by a program that left the tags.
    for (width, height) in [(1000, 750), (1023, 767), (1512, 2016)] {
        let one = found(&phone().sized(width, height));
        assert!(
            says(&one, |warning| matches!(warning, PhotoWarning::Resized { .. })),
            "{width} × {height}"
        );
    }
    let turned = found(&phone().sized(3024, 4032));
    assert_eq!(turned.cameras[0].fx, whole.cameras[0].fx);
    assert!(!says(&turned, |warning| matches!(
        warning,
        PhotoWarning::Resized { .. } | PhotoWarning::Cropped { .. }
    )));
}

#[test]
fn a_photo_that_viewers_turn_has_the_size_that_people_see() {
    for orientation in 1..=8 {
        let photo = phone().with(PLANE_Y, Rational(180_000, 10)).oriented(orientation);
        let one = found(&photo);
        let is_turned = orientation > 4;
        let camera = &one.cameras[0];
        assert_eq!(camera.size, Some(if is_turned { [3024, 4032] } else { [4032, 3024] }));
        assert_eq!(camera.fx < camera.fy, is_turned, "fx goes with the columns that are seen");
        assert_eq!(camera.cx.px(), if is_turned { 1512.0 } else { 2016.0 });
        assert_eq!(
            said(&one).contains(&format!("Orientation {orientation}: the size is 3024 × 4032")),
            is_turned
        );
    }
}

#[test]
fn a_digital_zoom_multiplies_what_lens_and_sensor_say_and_is_said() {
    let one = found(&phone().with(ZOOM, Rational(2, 1)).with(FILM, Short(52)));
    near(one.cameras[0].fx.px(), 2.0 * 3035.7);
    near(one.cameras[1].fx.px(), 2.0 * 3028.66);
    assert!(said(&one).contains("DigitalZoomRatio is 2: fx by FocalPlaneXResolution is multiplied"));
    assert!(says(&one, |warning| matches!(warning, PhotoWarning::Agreement { .. })));
    // Where the equivalent is that of the lens without the zoom.
    let one = found(&phone().with(ZOOM, Rational(2, 1)));
    let words = said(&one);
    assert!(
        words.contains("The first is trusted, but they differ by the digital zoom, 2, which may be missing in the first."),
        "{words}"
    );
    let one = found(&phone().without(&PLANE).with(ZOOM, Rational(2, 1)));
    near(one.cameras[0].fx.px(), 3028.66);
    assert!(said(&one).contains("DigitalZoomRatio is 2. "), "{}", said(&one));
    for none in [Rational(0, 1), Rational(1, 1), Rational(0, 0), Rational(5, 0)] {
        let one = found(&phone().with(ZOOM, none));
        assert!(!says(&one, |warning| matches!(warning, PhotoWarning::DigitalZoom { .. })));
    }
}

#[test]
fn a_lens_that_was_focused_near_is_said_with_how_much_it_is() {
    // 4.25 mm at 0.1 m: 100/(100 − 4.25) = 1.0444.
    let one = found(&phone().with(DISTANCE, Rational(10, 100)));
    assert!(
        said(&one).contains("focused at 0.1 m") && said(&one).contains("4.4 % larger"),
        "{}",
        said(&one)
    );
    for far in [Rational(3, 1), Rational(u32::MAX, 1), Rational(0, 1), Rational(4, 1000)] {
        let one = found(&phone().with(DISTANCE, far));
        assert!(!says(&one, |warning| matches!(warning, PhotoWarning::Near { .. })));
    }
}

#[test]
fn a_very_wide_lens_may_be_a_fisheye() {
    let is_wide = |film| {
        let one = found(&phone().without(&PLANE).with(FILM, Short(film)));
        says(&one, |warning| matches!(warning, PhotoWarning::Wide { .. }))
    };
    assert!(is_wide(15) && !is_wide(24));
}

#[test]
fn what_no_camera_has_is_left_out_and_said() {
    for absurd in [Rational(72, 1), Rational(1_000_000, 1)] {
        let one = found(&phone().with(PLANE_X, absurd));
        assert_eq!(one.cameras.len(), 2);
        assert!(one.ignored[0].contains("which no sensor has"), "{:?}", one.ignored);
    }
    // A plausible pixel and an absurd lens.
    let one = found(&phone().with(FOCAL_LENGTH, Rational(4, 10_000)));
    assert!(
        one.cameras.len() == 2 && one.ignored[0].contains("no lens has"),
        "{:?}",
        one.ignored
    );
    let one = found(&phone().with(FILM, Short(1)));
    assert!(one.cameras.len() == 1 && one.ignored[0].contains("1 mm"), "{:?}", one.ignored);
}

#[test]
fn zeros_are_unknown() {
    for unknown in [Rational(0, 0), Rational(0, 1), Rational(4, 0)] {
        let one = found(&phone().with(FOCAL_LENGTH, unknown.clone()));
        assert_eq!(one.cameras.len(), 2, "by film");
        let one = found(&phone().with(PLANE_X, unknown));
        assert_eq!(one.cameras.len(), 2, "by film");
    }
    let one = found(&phone().with(FILM, Short(0)));
    assert_eq!(names(&one), ["FocalPlaneXResolution: 4.25 mm at 1.4 µm"]);
    let one = found(&phone().with(TAKEN_X, Long(0)));
    assert_eq!(one.cameras.len(), 3, "as large as it is");
}

#[test]
fn both_byte_orders_say_the_same() {
    let big = phone();
    let little = Photo {
        is_big_endian: false,
        ..phone()
    };
    assert_eq!(found(&big), found(&little));
}

#[test]
fn what_always_holds_is_always_said() {
    let one = found(&phone());
    assert!(
        said(&one).contains("nominal focal length of such a camera (Example Phone 1)"),
        "{}",
        said(&one)
    );
    for camera in &one.cameras {
        let warning = Warning::NoPrincipalPoint {
            camera: camera.name.clone(),
        };
        assert!(one.warnings.contains(&warning));
    }
    // A way alone keeps what is said of it and of the photograph.
    let alone = one.choose_named(&["width"]).unwrap();
    assert_eq!(names(&alone), ["35 mm equivalent 26 mm by the width"]);
    assert!(said(&alone).contains("nominal") && !said(&alone).contains("by the diagonal: the file"));
    // Those of one camera are not several cameras, nor does a lens for the moon have its focal length in millimeters.
    assert!(!said(&one).contains("There are 3 cameras"));
    let moon = found(&phone().without(&PLANE).with(FILM, Short(3000)));
    assert!(!said(&moon).contains("is it in mm"), "{}", said(&moon));
    // The make is not said twice.
    let mut canon = phone().without(&PLANE).without(&[FILM, FOCAL_LENGTH]);
    canon.first = vec![
        (0x010f, photo::Value::Text("NIKON CORPORATION")),
        (0x0110, photo::Value::Text("NIKON D90")),
    ];
    assert!(refused(&canon.jpeg()).contains("by NIKON D90, "), "{}", refused(&canon.jpeg()));
}
