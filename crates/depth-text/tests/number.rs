//! What is read as a number, and what is asked about.
#![allow(clippy::unwrap_used, clippy::panic, missing_docs, reason = "tests")]

use depth_core::angle::AngleUnit;
use depth_core::quantity::{Length, LengthUnit};
use depth_text::number::Primes::{Arcminutes, FeetAndInches};
use depth_text::number::{NumberError, read};
use depth_text::unit::Unit;

fn number(text: &str) -> f64 {
    read(text, FeetAndInches)
        .unwrap_or_else(|error| panic!("{text:?}: {error:?}"))
        .number
}

/// The unit behind a number.
fn unit_of(word: &str) -> Option<Unit> {
    read(&format!("3 {word}"), FeetAndInches).ok()?.unit
}

fn readings(text: &str) -> Vec<String> {
    match read(text, FeetAndInches) {
        Err(NumberError::Ambiguous { readings }) => readings,
        other => panic!("{text:?} should be asked about, was {other:?}"),
    }
}

#[test]
fn a_pasted_book_is_not_searched_for_a_number() {
    for page in [
        "1 ".repeat(5000),
        "7".repeat(10_000),
        "1,1.1'".repeat(1700),
        "word ".repeat(2000),
        " ".repeat(10_000),
    ] {
        assert_eq!(read(&page, FeetAndInches), Err(NumberError::NotANumber));
    }
}

#[test]
fn squares_of_a_board_have_a_size() {
    let of = |millimeters| Some(Unit::Square(Length::new(millimeters, LengthUnit::Millimeter)));
    for (word, unit) in [
        ("squares of 23.6 mm", of(23.6)),
        ("square of 1in", of(25.4)),
        ("squares 25 mm", of(25.0)),
        ("squares", None),
        ("squares of", None),
        ("squares of 25", None),
        ("squares of 0 mm", None),
        ("squares of -3 mm", None),
        ("squares of squares of 3 mm", None),
    ] {
        assert_eq!(unit_of(word), unit, "{word}");
    }
    assert_eq!(
        unit_of("squares of 23.6 mm").map(|unit| unit.to_string()).as_deref(),
        Some("squares of 23.6 mm")
    );
}

#[test]
fn decimal_point_comma_exponent_and_spaces_are_read() {
    for (text, expected) in [
        ("700", 700.0),
        ("1e3", 1000.0),
        ("1E-3", 0.001),
        ("1e−3", 0.001),
        ("0,1", 0.1),
        ("0.1", 0.1),
        (".5", 0.5),
        (",5", 0.5),
        ("5.", 5.0),
        ("  42\u{a0}", 42.0),
        ("+7", 7.0),
        ("−3", -3.0),
        ("-3,5", -3.5),
        ("1.000", 1.0),
        ("0,125", 0.125),
        ("1,0000", 1.0),
        ("1234,567", 1234.567),
        ("12,5", 12.5),
    ] {
        assert_eq!(number(text), expected, "{text:?}");
    }
}

#[test]
fn a_unit_may_follow_with_or_without_a_space() {
    use LengthUnit::{Centimeter, Foot, Inch, Meter, Millimeter};
    for (text, value, unit) in [
        ("10 cm", 10.0, Unit::Length(Centimeter)),
        ("4in", 4.0, Unit::Length(Inch)),
        ("0.1 m", 0.1, Unit::Length(Meter)),
        ("1e2mm", 100.0, Unit::Length(Millimeter)),
        ("3'", 3.0, Unit::Length(Foot)),
        ("4\"", 4.0, Unit::Length(Inch)),
        ("2 Feet", 2.0, Unit::Length(Foot)),
        ("50px", 50.0, Unit::Pixel),
        ("12,5 mm", 12.5, Unit::Length(Millimeter)),
    ] {
        let typed = read(text, FeetAndInches).unwrap();
        assert_eq!((typed.number, typed.unit), (value, Some(unit)), "{text:?}");
    }
    assert_eq!(read("10 furlongs", FeetAndInches), Err(NumberError::UnknownUnit("furlongs".into())));
}

#[test]
fn products_quotients_and_fractions_are_worked_out() {
    use LengthUnit::{Foot, Inch, Meter};
    for (text, value, unit) in [
        ("1/3", 1.0 / 3.0, None),
        ("2*50", 100.0, None),
        ("1280/2", 640.0, None),
        ("1280 / 2 px", 640.0, Some(Unit::Pixel)),
        ("3 × 1.5 m", 4.5, Some(Unit::Length(Meter))),
        ("9/8in", 1.125, Some(Unit::Length(Inch))),
        ("1 1/8 in", 1.125, Some(Unit::Length(Inch))),
        ("1-1/8\"", 1.125, Some(Unit::Length(Inch))),
        ("1⅛ in", 1.125, Some(Unit::Length(Inch))),
        ("½ ft", 0.5, Some(Unit::Length(Foot))),
        ("-1 1/2", -1.5, None),
    ] {
        let typed = read(text, FeetAndInches).unwrap_or_else(|error| panic!("{text:?}: {error:?}"));
        assert_eq!((typed.number, typed.unit, typed.is_computed), (value, unit, true), "{text:?}");
    }
    for text in ["1/0", "1 1/0", "0/0", "1e300*1e300"] {
        assert_eq!(read(text, FeetAndInches), Err(NumberError::TooExtreme), "{text:?}");
    }
    for text in [
        "1280x720",
        "10-5",
        "2024-01-05",
        "1/",
        "/3",
        "1//3",
        "*5",
        "km/h",
        "1 9/8",
        "1,000/2",
    ] {
        assert!(read(text, FeetAndInches).is_err(), "{text:?} gave {:?}", read(text, FeetAndInches));
    }
}

#[test]
fn a_power_of_ten_is_a_way_to_write_a_number() {
    for (text, value) in [
        ("1.400 × 10⁻¹¹", 1.4e-11),
        ("1.4*10^-11", 1.4e-11),
        ("2 x 10^8", 2e8),
        ("10^3", 1000.0),
        ("3·10", f64::NAN),
    ] {
        if value.is_nan() {
            assert!(read(text, FeetAndInches).is_err());
            continue;
        }
        let typed = read(text, FeetAndInches).unwrap_or_else(|error| panic!("{text:?}: {error:?}"));
        assert_eq!((typed.number, typed.is_computed), (value, false), "{text:?}");
    }
}

#[test]
fn digits_and_separators_of_other_scripts_are_read_and_shown_as_read() {
    for (text, value) in [
        ("384\u{2009}400", 384_400.0),
        ("384\u{202f}400.5", 384_400.5),
        ("14\u{2009}286.012\u{2009}345\u{2009}6", 14_286.012_345_6),
        ("0.012\u{2009}30", 0.012_3),
        ("−0,001\u{202f}234", -0.001_234),
        ("٧٠٠", 700.0),
        ("۱۲٫۵", 12.5),
        ("١٬٢٣٤٫٥", 1234.5),
        ("７００", 700.0),
    ] {
        let typed = read(text, FeetAndInches).unwrap_or_else(|error| panic!("{text:?}: {error:?}"));
        assert_eq!((typed.number, typed.is_computed), (value, true), "{text:?}");
    }
}

#[test]
fn several_units_make_one_number() {
    for (text, primes, value, unit) in [
        ("5'11\"", FeetAndInches, 1.8034, LengthUnit::Foot.into()),
        ("5′ 11″", FeetAndInches, 1.8034, LengthUnit::Foot.into()),
        ("5'11", FeetAndInches, 1.8034, LengthUnit::Foot.into()),
        ("5 ft 11 in", FeetAndInches, 1.8034, LengthUnit::Foot.into()),
        ("5 ft 11", FeetAndInches, 1.8034, LengthUnit::Foot.into()),
        ("6′ 2″", FeetAndInches, 1.8796, LengthUnit::Foot.into()),
        ("5' 11 1/2\"", FeetAndInches, 1.8161, LengthUnit::Foot.into()),
        ("1 m 80 cm", FeetAndInches, 1.8, LengthUnit::Meter.into()),
        ("1° 30′", Arcminutes, 1.5_f64.to_radians(), Unit::DEGREE),
        ("1°30'36\"", Arcminutes, 1.51_f64.to_radians(), Unit::DEGREE),
        ("-1° 30′", Arcminutes, (-1.5_f64).to_radians(), Unit::DEGREE),
    ] {
        let typed = read(text, primes).unwrap_or_else(|error| panic!("{text:?}: {error:?}"));
        assert!(
            (unit.to_base(typed.number) - value).abs() < 1e-12 && typed.unit == Some(unit) && typed.is_computed,
            "{text:?}: {typed:?}"
        );
    }
    for text in [
        "5 in 3 ft",
        "5 ft -3 in",
        "5 ft 3 px",
        "5 ft 3°",
        "5'13\"",
        "1'500 mm",
        "1’200 mm",
        "2'540,5 mm",
        "1'000",
        "5 px 3 px",
    ] {
        assert!(read(text, FeetAndInches).is_err(), "{text:?} gave {:?}", read(text, FeetAndInches));
    }
}

#[test]
fn what_a_log_prints_around_a_number_is_taken_away() {
    for (text, value, unit) in [
        ("fx = 718.856 px", 718.856, Some(Unit::Pixel)),
        ("700 [px]", 700.0, Some(Unit::Pixel)),
        ("700 (px)", 700.0, Some(Unit::Pixel)),
        ("[700 px]", 700.0, Some(Unit::Pixel)),
        ("\"fx\": 718.856,", 718.856, None),
        ("K[0][0]: 721.5", 721.5, None),
        ("δ = −3", -3.0, None),
        ("baseline=0,54 m", 0.54, Some(Unit::Length(LengthUnit::Meter))),
    ] {
        let typed = read(text, FeetAndInches).unwrap_or_else(|error| panic!("{text:?}: {error:?}"));
        assert_eq!((typed.number, typed.unit), (value, unit), "{text:?}");
    }
    for text in ["12:30", "fx =", "= 5", "fx = abc", "a = b = 3"] {
        assert!(read(text, FeetAndInches).is_err(), "{text:?} gave {:?}", read(text, FeetAndInches));
    }
}

#[test]
fn primes_are_feet_and_inches_in_a_length_and_minutes_and_seconds_in_an_angle() {
    let unit = |text: &str, primes| read(text, primes).unwrap().unit.unwrap();
    assert_eq!(unit("0.5′", Arcminutes), AngleUnit::Arcminute.into());
    assert_eq!(unit("20\"", Arcminutes), AngleUnit::Arcsecond.into());
    assert_eq!(unit("6′", FeetAndInches), LengthUnit::Foot.into());
    for (word, expected) in [
        ("mil", AngleUnit::NatoMil.into()),
        ("mrad", AngleUnit::Milliradian.into()),
        ("MOA", AngleUnit::MinuteOfAngle.into()),
        ("arcmin", AngleUnit::Arcminute.into()),
        ("arcsec", AngleUnit::Arcsecond.into()),
        ("yd", LengthUnit::Yard.into()),
        ("um", LengthUnit::Micrometer.into()),
        ("nm", LengthUnit::Nanometer.into()),
        ("mi", LengthUnit::Mile.into()),
        ("km", LengthUnit::Kilometer.into()),
    ] {
        assert_eq!(unit(&format!("2 {word}"), FeetAndInches), expected, "{word}");
    }
}

#[test]
fn a_comma_before_three_digits_is_asked_about() {
    assert_eq!(readings("1,000"), ["1000", "1.000"]);
    assert_eq!(readings("-12,345 mm"), ["-12345 mm", "-12.345 mm"]);
    assert_eq!(readings("999,000e2"), ["999000e2", "999.000e2"]);
}

#[test]
fn several_separators_are_asked_about() {
    assert_eq!(readings("1,000,000"), ["1000000"]);
    assert_eq!(readings("1.234,5"), ["1234.5"]);
    assert_eq!(readings("1,234.5"), ["1234.5"]);
    assert_eq!(readings("1 000"), ["1000"]);
    assert_eq!(readings("1'234'567,8"), ["1234567.8"]);
    assert!(readings("1.2.3").is_empty());
    assert!(readings("1,2.3,4").is_empty());
    assert!(readings("10 20").is_empty());
}

#[test]
fn every_reading_offered_is_itself_read_without_asking() {
    for text in ["1,000", "1,000,000 mm", "1.234,5", "1 000 px", "-1,234.5e2 ft"] {
        for reading in readings(text) {
            assert!(read(&reading, FeetAndInches).is_ok(), "{text:?} offers {reading:?}");
        }
    }
}

#[test]
fn what_is_not_a_finite_number_is_refused() {
    for text in [
        "", " ", "abc", "nan", "NaN", "inf", "-inf", "e3", "-", ".", ",", "--5", "m", "0x10", "1e", "∞",
    ] {
        assert!(
            matches!(
                read(text, FeetAndInches),
                Err(NumberError::NotANumber | NumberError::UnknownUnit(_) | NumberError::Ambiguous { .. })
            ),
            "{text:?} gave {:?}",
            read(text, FeetAndInches)
        );
    }
    assert_eq!(read("1e400", FeetAndInches), Err(NumberError::TooExtreme));
    assert_eq!(read("1e-400", FeetAndInches), Err(NumberError::TooExtreme));
    assert_eq!(number("0.000"), 0.0);
}
