//! Numbers as people type and read them.
//!
//! Reading asks where it would have to guess: `1,000` is a thousand in London and one in Berlin.

use depth_core::quantity::LengthUnit;
use std::fmt::Write as _;

/// A unit that was typed behind a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unit {
    /// px
    Pixel,
    /// A unit of length.
    Length(LengthUnit),
}

/// A number and the unit typed behind it, if any.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Typed<'a> {
    /// The number: finite.
    pub number: f64,
    /// The number as it was typed, without unit and surrounding spaces.
    pub number_text: &'a str,
    /// The unit.
    pub unit: Option<Unit>,
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

/// Reads one number, with an optional unit behind it.
///
/// Takes `700`, `1e3`, `0,1`, `0.1`, ` 10 cm`, `4in`, `−3` (Unicode minus). Asks ([`NumberError::Ambiguous`]) for `1,000`
/// and for anything with several separators.
///
/// # Errors
/// See [`NumberError`]. An empty text is [`NumberError::NotANumber`].
pub fn read(text: &str) -> Result<Typed<'_>, NumberError> {
    let text = text.trim_matches(|c: char| c.is_whitespace() || c == '\u{feff}');
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
    Ok(Typed { number, number_text, unit })
}

/// The unit that `word` names: symbols, English names in singular and plural, and the primes of inch and foot.
pub fn unit(word: &str) -> Option<Unit> {
    Some(match word.to_lowercase().as_str() {
        "px" | "pixel" | "pixels" => Unit::Pixel,
        "mm" | "millimetre" | "millimetres" | "millimeter" | "millimeters" => Unit::Length(LengthUnit::Millimeter),
        "cm" | "centimetre" | "centimetres" | "centimeter" | "centimeters" => Unit::Length(LengthUnit::Centimeter),
        "m" | "metre" | "metres" | "meter" | "meters" => Unit::Length(LengthUnit::Meter),
        "in" | "inch" | "inches" | "\"" | "″" => Unit::Length(LengthUnit::Inch),
        "ft" | "foot" | "feet" | "'" | "′" => Unit::Length(LengthUnit::Foot),
        _ => return None,
    })
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

/// What stands where there is no number.
pub const NO_NUMBER: &str = "–.–";

/// Magnitudes that are written out; others are in scientific notation.
const READABLE: std::ops::RangeInclusive<f64> = 0.001..=99_999.0;

/// `value` with `digits` significant digits, in scientific notation outside 0.001 to 99 999.
///
/// `significant(1.4, 4)` is "1.400", `significant(123456.0, 4)` is "1.235e5". Not finite: [`NO_NUMBER`].
pub fn significant(value: f64, digits: usize) -> String {
    if !value.is_finite() {
        return NO_NUMBER.to_owned();
    }
    if value == 0.0 {
        return "0".to_owned();
    }
    let scientific = format!("{value:.*e}", digits.saturating_sub(1));
    let (Ok(rounded), Some(exponent)) = (scientific.parse::<f64>(), exponent_of(&scientific)) else {
        return scientific;
    };
    if !READABLE.contains(&value.abs()) {
        return scientific;
    }
    let decimals = i32::try_from(digits).unwrap_or(i32::MAX).saturating_sub(1).saturating_sub(exponent);
    format!("{rounded:.*}", usize::try_from(decimals).unwrap_or(0))
}

/// `value` as someone would write it: up to 12 significant digits and no trailing zeros.
pub fn plain(value: f64) -> String {
    let text = significant(value, 12);
    let (mantissa, exponent) = text.find('e').and_then(|at| text.split_at_checked(at)).unwrap_or((&text, ""));
    if !mantissa.contains('.') {
        return text;
    }
    format!("{}{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
}

/// `value` with every digit it has: the shortest text that reads back as the same number.
pub fn exact(value: f64) -> String {
    if READABLE.contains(&value.abs()) || value == 0.0 {
        format!("{value}")
    } else {
        format!("{value:e}")
    }
}

/// `value` to `decimals` places; negative ones round to tens, hundreds and so on. In scientific notation, to the same place,
/// outside 0.001 to 99 999. Not finite: [`NO_NUMBER`].
pub fn to_decimals(value: f64, decimals: i32) -> String {
    if !value.is_finite() {
        return NO_NUMBER.to_owned();
    }
    let places = usize::try_from(decimals + magnitude(value)).unwrap_or(0).min(17);
    if value != 0.0 && !READABLE.contains(&value.abs()) {
        return format!("{value:.places$e}");
    }
    if decimals < 0 {
        return significant(value, places + 1);
    }
    format!("{value:.*}", usize::try_from(decimals).unwrap_or(0).min(17))
}

/// The power of ten of the first digit that `value` has with two significant digits: 0.0158 has −2, 0.0999 has −1.
pub fn magnitude(value: f64) -> i32 {
    exponent_of(&format!("{value:.1e}")).unwrap_or(0)
}

fn exponent_of(scientific: &str) -> Option<i32> {
    scientific.split_once('e')?.1.parse().ok()
}

/// `text` between quotation marks, cut where it is too long to quote.
pub fn quoted(text: &str) -> String {
    const LONGEST: usize = 24;
    let mut quoted = String::from("“");
    for (count, c) in text.trim().chars().enumerate() {
        if count == LONGEST {
            quoted.push('…');
            break;
        }
        quoted.push(if c.is_control() { ' ' } else { c });
    }
    let _ = quoted.write_char('”');
    quoted
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;

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

    #[test]
    fn four_significant_digits_and_scientific_outside_the_readable_range() {
        for (value, expected) in [
            (1.4, "1.400"),
            (4.275, "4.275"),
            (0.001, "0.001000"),
            (0.0009999, "9.999e-4"),
            (0.000_999_99, "1.000e-3"),
            (12_345.6, "12350"),
            (99_990.0, "99990"),
            (99_999.0, "100000"),
            (99_999.1, "1.000e5"),
            (123_456.0, "1.235e5"),
            (-1.23456, "-1.235"),
            (0.0, "0"),
            (f64::NAN, NO_NUMBER),
            (f64::INFINITY, NO_NUMBER),
        ] {
            assert_eq!(significant(value, 4), expected, "{value}");
        }
    }

    #[test]
    fn plain_and_exact_keep_what_was_entered() {
        assert_eq!(plain(0.1), "0.1");
        assert_eq!(plain(700.0), "700");
        assert_eq!(plain(3.3 * 0.3048), "1.00584");
        assert_eq!(plain(1e-300), "1e-300");
        assert_eq!(exact(1.372_549_019_607_843_2), "1.3725490196078431");
        assert_eq!(exact(1e200), "1e200");
    }
}
