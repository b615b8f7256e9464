//! Reads one number with the unit behind it.
//!
//! Asks where it would have to guess: `1,000` is a thousand in London and one in Berlin.

use super::arithmetic::{self, is_operator, is_superscript};
use super::clean::{normalized, without_brackets, without_name};
use super::compound;
use crate::unit::Unit;
use depth_core::quantity::Length;

/// A number and the unit typed behind it, if any.
#[derive(Clone, Debug, PartialEq)]
pub struct Typed {
    /// The number: finite.
    pub number: f64,
    /// The number as it was typed, without name, unit and surrounding spaces; of several units all of it.
    pub number_text: String,
    /// The unit, of several the first.
    pub unit: Option<Unit>,
    /// The unit as it was typed; empty where there is none or where it is in the number's text.
    pub unit_text: String,
    /// Whether it was worked out: a product, a quotient, a fraction, several units.
    pub is_computed: bool,
}

/// What ′ and ″ mean behind a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Primes {
    /// Where lengths are typed.
    FeetAndInches,
    /// Where angles are typed.
    Arcminutes,
}

/// Why a text is not one number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NumberError {
    /// There is no number in it.
    NotANumber,
    /// It could mean several numbers, or is grouped in a way that has to be confirmed. Each reading is a text that
    /// [`read`] takes without asking again; there may be none.
    Ambiguous {
        /// What it may have meant.
        readings: Vec<String>,
    },
    /// A number, but what follows is not a unit.
    UnknownUnit(String),
    /// A number beyond what a computer's floating-point numbers hold.
    TooExtreme,
}

/// Nobody types a longer number; to look through a pasted book for one would take longer than a frame.
pub const LONGEST: usize = 500;

/// Reads one number, with an optional unit behind it.
///
/// Takes `700`, `1e3`, `0,1`, `0.1`, ` 10 cm`, `4in`, `−3` (Unicode minus), `1/3`, `2*50`, `1 1/8 in`, `5'11"`, `1.4 × 10⁻¹¹ m`,
/// `fx = 700 [px]`, and digits of Arabic and Persian. Asks ([`NumberError::Ambiguous`]) for `1,000` and for anything with several
/// separators.
///
/// # Errors
/// See [`NumberError`]. An empty text is [`NumberError::NotANumber`].
pub fn read(text: &str, primes: Primes) -> Result<Typed, NumberError> {
    let text = text.trim_matches(|c: char| c.is_whitespace() || c == '\u{feff}');
    if text.len() > LONGEST {
        return Err(NumberError::NotANumber);
    }
    let text = normalized(text);
    let text = without_name(text.trim());
    if let Some(typed) = compound::read(text, primes) {
        return checked(typed);
    }
    let (number_text, unit_text) = split_unit(text);
    let unit_text = without_brackets(unit_text);
    let (number, is_computed) = arithmetic::value(number_text).map_err(|error| match error {
        NumberError::Ambiguous { readings } => {
            let gap = if unit_text.is_empty() { "" } else { " " };
            NumberError::Ambiguous {
                readings: readings.into_iter().map(|reading| format!("{reading}{gap}{unit_text}")).collect(),
            }
        }
        other => other,
    })?;
    let unit = match unit_text {
        "" => None,
        word => Some(unit(word, primes).ok_or_else(|| NumberError::UnknownUnit(word.to_owned()))?),
    };
    checked(Typed {
        number,
        number_text: number_text.to_owned(),
        unit,
        unit_text: unit_text.to_owned(),
        is_computed,
    })
}

fn checked(typed: Typed) -> Result<Typed, NumberError> {
    if typed.number.is_finite() {
        Ok(typed)
    } else {
        Err(NumberError::TooExtreme)
    }
}

/// The value of one number without a unit.
pub(super) fn factor(text: &str) -> Result<f64, NumberError> {
    let negative = text.starts_with(is_minus);
    let unsigned = text.strip_prefix(|c| is_minus(c) || c == '+').unwrap_or(text);
    let (mantissa, exponent) = unsigned
        .find(['e', 'E'])
        .and_then(|at| unsigned.split_at_checked(at))
        .unwrap_or((unsigned, ""));
    let exponent: String = exponent.chars().map(|c| if is_minus(c) { '-' } else { c }).collect();
    let sign = if negative { "-" } else { "" };
    let digits = plain_digits(mantissa).map_err(|readings| {
        if !mantissa.contains(|c: char| c.is_ascii_digit()) {
            return NumberError::NotANumber;
        }
        let readings = readings.into_iter().map(|reading| format!("{sign}{reading}{exponent}"));
        NumberError::Ambiguous {
            readings: readings.collect(),
        }
    })?;
    let number: f64 = format!("{sign}{digits}{exponent}").parse().map_err(|_| NumberError::NotANumber)?;
    let vanished = number == 0.0 && digits.contains(|c: char| c.is_ascii_digit() && c != '0');
    if !number.is_finite() || vanished {
        return Err(NumberError::TooExtreme);
    }
    Ok(number)
}

/// The unit that `word` names, or squares of a board with their size.
fn unit(word: &str, primes: Primes) -> Option<Unit> {
    match words_after_squares(&word.to_lowercase()) {
        Some(size) => square(size),
        None => Unit::named(word, primes == Primes::Arcminutes),
    }
}

/// What follows "squares" or "squares of"; `None` where `unit` is another unit.
pub(crate) fn words_after_squares(unit: &str) -> Option<&str> {
    let rest = unit.strip_prefix("squares").or_else(|| unit.strip_prefix("square"))?;
    let rest = rest.trim_start();
    Some(rest.strip_prefix("of").unwrap_or(rest).trim())
}

/// Squares of this size, which has its unit.
fn square(size: &str) -> Option<Unit> {
    let typed = read(size, Primes::FeetAndInches).ok()?;
    let meters = typed.unit.filter(|unit| matches!(unit, Unit::Length(_)))?.to_base(typed.number);
    Unit::square(Length::from_m(meters))
}

const fn is_minus(c: char) -> bool {
    matches!(c, '-' | '−')
}

/// Marks that group digits or stand before decimals in some country.
fn is_separator(c: char) -> bool {
    matches!(c, '.' | ',' | '\'' | '’' | '_' | '·' | '٫' | '٬') || c.is_whitespace()
}

/// Splits what was typed into the number and what follows it.
fn split_unit(text: &str) -> (&str, &str) {
    let rest = |at: usize| text.get(at..).unwrap_or_default();
    let is_digit = |c: char| c.is_ascii_digit();
    let followed_by_digit = |at: usize| rest(at).trim_start_matches(is_separator).starts_with(is_digit);
    // Only behind "10", as in 1280x720 the letter is no operator.
    let is_factor = |at: usize| {
        let behind = rest(at);
        let operand = behind.strip_prefix(is_operator).unwrap_or_default().trim_start();
        let is_power = operand
            .strip_prefix("10")
            .is_some_and(|power| power.starts_with(|c| c == '^' || is_superscript(c)));
        let is_letter = behind.starts_with(['x', 'X']);
        is_power || (!is_letter && operand.starts_with(is_digit))
    };
    let before = |at: usize| text.get(..at).unwrap_or_default();
    let mut end = 0;
    let mut in_exponent = false;
    for (at, c) in text.char_indices() {
        let after = at + c.len_utf8();
        let belongs = match c {
            '0'..='9' => true,
            '+' | '-' | '−' => {
                let is_sign = at == 0 || before(at).ends_with('^') || (in_exponent && before(at).ends_with(['e', 'E']));
                // 1-1/8
                is_sign || (c == '-' && before(at).ends_with(is_digit) && is_fraction(rest(after)))
            }
            '^' => before(at).ends_with("10"),
            c if is_superscript(c) => before(at).ends_with("10") || before(at).ends_with(is_superscript),
            c if is_operator(c) => {
                let is_factor = at > 0 && is_factor(at);
                in_exponent &= !is_factor;
                is_factor
            }
            'e' | 'E' => {
                let exponent = rest(after).trim_start_matches(|c| is_minus(c) || c == '+');
                let starts = !in_exponent && at > 0 && exponent.starts_with(is_digit);
                in_exponent |= starts;
                starts
            }
            '.' | ',' => !in_exponent,
            c if c.is_whitespace() && is_factor(after) => true,
            c if is_separator(c) => !in_exponent && followed_by_digit(after),
            _ => false,
        };
        if !belongs {
            break;
        }
        end = after;
    }
    let (number, unit) = text.split_at_checked(end).unwrap_or((text, ""));
    (number.trim(), unit.trim())
}

/// Whether `text` begins with a fraction of two whole numbers.
fn is_fraction(text: &str) -> bool {
    let rest = text.trim_start_matches(|c: char| c.is_ascii_digit());
    rest.len() < text.len()
        && rest
            .strip_prefix('/')
            .is_some_and(|denominator| denominator.starts_with(|c: char| c.is_ascii_digit()))
}

/// The digits of an unsigned decimal number with a point for its decimals, or the readings to choose from.
fn plain_digits(mantissa: &str) -> Result<String, Vec<String>> {
    let separators: Vec<char> = mantissa.chars().filter(|&c| is_separator(c)).collect();
    let parts: Vec<&str> = mantissa.split(is_separator).collect();
    let thousands = |groups: &[&str]| {
        groups
            .split_first()
            .is_some_and(|(first, rest)| (1..=3).contains(&first.len()) && !first.starts_with('0') && rest.iter().all(|g| g.len() == 3))
    };
    match separators.as_slice() {
        [] | ['.'] => Ok(mantissa.to_owned()),
        [','] if thousands(&parts) => Err(vec![parts.concat(), parts.join(".")]),
        [','] => Ok(parts.join(".")),
        all => {
            let mut readings = Vec::new();
            if let (Some((last, groups)), Some((decimals, whole))) = (all.split_last(), parts.split_last()) {
                if all.iter().all(|c| c == last) {
                    if thousands(&parts) {
                        readings.push(parts.concat());
                    }
                } else if matches!(last, '.' | ',')
                    && groups.windows(2).all(|pair| matches!(pair, [a, b] if a == b))
                    && groups.first() != Some(last)
                    && thousands(whole)
                {
                    readings.push(format!("{}.{decimals}", whole.concat()));
                }
            }
            Err(readings)
        }
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;
    use crate::number::Primes::{Arcminutes, FeetAndInches};
    use depth_core::angle::AngleUnit;
    use depth_core::quantity::LengthUnit;

    fn number(text: &str) -> f64 {
        read(text, FeetAndInches)
            .unwrap_or_else(|error| panic!("{text:?}: {error:?}"))
            .number
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
            assert_eq!(super::unit(word, FeetAndInches), unit, "{word}");
        }
        assert_eq!(
            super::unit("squares of 23.6 mm", FeetAndInches)
                .map(|unit| unit.to_string())
                .as_deref(),
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
        for text in ["1/0", "0/0", "1e300*1e300"] {
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
            ("3·10", f64::NAN),
            ("384\u{2009}400", 384_400.0),
            ("384\u{202f}400.5", 384_400.5),
            ("٧٠٠", 700.0),
            ("۱۲٫۵", 12.5),
            ("١٬٢٣٤٫٥", 1234.5),
            ("７００", 700.0),
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
    fn several_units_make_one_number() {
        for (text, primes, value, unit) in [
            ("5'11\"", FeetAndInches, 1.8034, LengthUnit::Foot.into()),
            ("5′ 11″", FeetAndInches, 1.8034, LengthUnit::Foot.into()),
            ("5'11", FeetAndInches, 1.8034, LengthUnit::Foot.into()),
            ("5 ft 11 in", FeetAndInches, 1.8034, LengthUnit::Foot.into()),
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
        for text in ["5 in 3 ft", "5 ft -3 in", "5 ft 3 px", "5 ft 3°", "5 ft 3", "1'000", "5 px 3 px"] {
            assert!(read(text, FeetAndInches).is_err(), "{text:?} gave {:?}", read(text, FeetAndInches));
        }
    }

    #[test]
    fn what_a_log_prints_around_a_number_is_taken_away() {
        for (text, value, unit) in [
            ("fx = 718.856 px", 718.856, Some(Unit::Pixel)),
            ("700 [px]", 700.0, Some(Unit::Pixel)),
            ("700 (px)", 700.0, Some(Unit::Pixel)),
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
}
