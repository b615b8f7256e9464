//! Reads one number with the unit behind it.
//!
//! Asks where it would have to guess: `1,000` is a thousand in London and one in Berlin.

use crate::unit::Unit;
use depth_core::quantity::Length;

/// A number and the unit typed behind it, if any.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Typed<'a> {
    /// The number: finite.
    pub number: f64,
    /// The number as it was typed, without unit and surrounding spaces.
    pub number_text: &'a str,
    /// The unit.
    pub unit: Option<Unit>,
    /// The unit as it was typed; empty where there is none.
    pub unit_text: &'a str,
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
const LONGEST: usize = 500;

/// Reads one number, with an optional unit behind it.
///
/// Takes `700`, `1e3`, `0,1`, `0.1`, ` 10 cm`, `4in`, `−3` (Unicode minus). Asks ([`NumberError::Ambiguous`]) for `1,000`
/// and for anything with several separators.
///
/// # Errors
/// See [`NumberError`]. An empty text is [`NumberError::NotANumber`].
pub fn read(text: &str) -> Result<Typed<'_>, NumberError> {
    let text = text.trim_matches(|c: char| c.is_whitespace() || c == '\u{feff}');
    if text.len() > LONGEST {
        return Err(NumberError::NotANumber);
    }
    let (number_text, unit_text) = split_unit(text);
    let negative = number_text.starts_with(is_minus);
    let unsigned = number_text.strip_prefix(|c| is_minus(c) || c == '+').unwrap_or(number_text);
    let (mantissa, exponent) = unsigned
        .find(['e', 'E'])
        .and_then(|at| unsigned.split_at_checked(at))
        .unwrap_or((unsigned, ""));
    let exponent: String = exponent.chars().map(|c| if is_minus(c) { '-' } else { c }).collect();
    let sign = if negative { "-" } else { "" };

    let digits = match plain_digits(mantissa) {
        Ok(digits) => digits,
        Err(readings) => {
            if !mantissa.contains(|c: char| c.is_ascii_digit()) {
                return Err(NumberError::NotANumber);
            }
            let gap = if unit_text.is_empty() { "" } else { " " };
            return Err(NumberError::Ambiguous {
                readings: readings
                    .into_iter()
                    .map(|reading| format!("{sign}{reading}{exponent}{gap}{unit_text}"))
                    .collect(),
            });
        }
    };
    let number: f64 = format!("{sign}{digits}{exponent}").parse().map_err(|_| NumberError::NotANumber)?;
    let unit = match unit_text {
        "" => None,
        word => Some(unit(word).ok_or_else(|| NumberError::UnknownUnit(word.to_owned()))?),
    };
    let vanished = number == 0.0 && digits.contains(|c: char| c.is_ascii_digit() && c != '0');
    if !number.is_finite() || vanished {
        return Err(NumberError::TooExtreme);
    }
    Ok(Typed {
        number,
        number_text,
        unit,
        unit_text,
    })
}

/// The unit that `word` names, or squares of a board with their size.
fn unit(word: &str) -> Option<Unit> {
    match words_after_squares(&word.to_lowercase()) {
        Some(size) => square(size),
        None => Unit::named(word),
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
    let typed = read(size).ok()?;
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
    let followed_by_digit = |at: usize| {
        text.get(at..)
            .is_some_and(|rest| rest.trim_start_matches(is_separator).starts_with(|c: char| c.is_ascii_digit()))
    };
    let mut end = 0;
    let mut in_exponent = false;
    for (at, c) in text.char_indices() {
        let after = at + c.len_utf8();
        let belongs = match c {
            '0'..='9' => true,
            '+' | '-' | '−' => at == 0 || text.get(..at).is_some_and(|before| in_exponent && before.ends_with(['e', 'E'])),
            'e' | 'E' => {
                let exponent = text.get(after..).unwrap_or("").trim_start_matches(|c| is_minus(c) || c == '+');
                let starts = !in_exponent && at > 0 && exponent.starts_with(|c: char| c.is_ascii_digit());
                in_exponent |= starts;
                starts
            }
            '.' | ',' => !in_exponent,
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
    use depth_core::quantity::LengthUnit;

    fn number(text: &str) -> f64 {
        read(text).unwrap_or_else(|error| panic!("{text:?}: {error:?}")).number
    }

    fn readings(text: &str) -> Vec<String> {
        match read(text) {
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
            assert_eq!(read(&page), Err(NumberError::NotANumber));
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
            assert_eq!(super::unit(word), unit, "{word}");
        }
        assert_eq!(
            super::unit("squares of 23.6 mm").map(|unit| unit.to_string()).as_deref(),
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
            let typed = read(text).unwrap();
            assert_eq!((typed.number, typed.unit), (value, Some(unit)), "{text:?}");
        }
        assert_eq!(read("10 furlongs"), Err(NumberError::UnknownUnit("furlongs".into())));
        assert_eq!(readings("5' 10\""), Vec::<String>::new());
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
                assert!(read(&reading).is_ok(), "{text:?} offers {reading:?}");
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
                    read(text),
                    Err(NumberError::NotANumber | NumberError::UnknownUnit(_) | NumberError::Ambiguous { .. })
                ),
                "{text:?} gave {:?}",
                read(text)
            );
        }
        assert_eq!(read("1e400"), Err(NumberError::TooExtreme));
        assert_eq!(read("1e-400"), Err(NumberError::TooExtreme));
        assert_eq!(number("0.000"), 0.0);
    }
}
