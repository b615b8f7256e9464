//! Several units in one number: 5'11", 5 ft 11 in, 1° 30′.

use super::arithmetic;
use super::typed::{Primes, Typed};
use crate::unit::Unit;
use depth_core::angle::AngleUnit;
use depth_core::quantity::LengthUnit;

/// A text of at least two numbers, each with a smaller unit of the same kind behind it, as one number of the first unit; `None` for
/// any other text. A last number of one or two digits may do without the unit behind feet in primes: 5'11.
pub(super) fn read(text: &str, primes: Primes) -> Option<Typed> {
    let mut parts: Vec<(f64, Unit)> = Vec::new();
    let mut first_unit_text = "";
    let mut rest = text;
    while !rest.is_empty() {
        let (number_text, behind) = rest.split_at_checked(number_length(rest))?;
        let (unit_text, after) = behind.split_at_checked(unit_length(behind))?;
        let (number, _) = arithmetic::value(number_text.trim()).ok()?;
        let unit = match (unit_text.trim(), parts.as_slice()) {
            ("", [(_, feet)]) if is_inches(number_text, first_unit_text) && after.is_empty() => {
                let inches = Unit::named("″", primes == Primes::Arcminutes)?;
                (inches.is_length() == feet.is_length()).then_some(inches)?
            }
            ("", _) => return None,
            (word, _) => Unit::named(word, primes == Primes::Arcminutes)?,
        };
        match parts.last() {
            Some((_, before)) => {
                // Between groups of digits an apostrophe is no prime: 1'500 mm.
                if is_apostrophe(first_unit_text) && parts.len() == 1 && !is_prime_or_inch(unit_text.trim(), unit) {
                    return None;
                }
                let is_smaller = unit.base() == before.base() && unit.to_base(1.0) < before.to_base(1.0) && unit != Unit::Pixel;
                // 5'13" is no way to write a length.
                let fits = unit.to_base(number) < before.to_base(1.0);
                if !is_smaller || !fits || number < 0.0 || number_text.trim().starts_with('+') {
                    return None;
                }
            }
            None => first_unit_text = unit_text.trim(),
        }
        parts.push((number, unit));
        rest = after;
    }
    let ((first, unit), more) = parts.split_first()?;
    if more.is_empty() {
        return None;
    }
    let sum: f64 = more.iter().map(|(number, unit)| unit.to_base(*number)).sum();
    let sign = if text.starts_with(['-', '−']) { -1.0 } else { 1.0 };
    Some(Typed {
        number: first + sign * unit.from_base(sum),
        number_text: text.to_owned(),
        unit: Some(*unit),
        unit_text: String::new(),
        last_unit: parts.last().map(|(_, unit)| *unit),
        is_computed: true,
    })
}

/// Whether feet or minutes were marked by a sign that stands between groups of digits too.
fn is_apostrophe(unit: &str) -> bool {
    matches!(unit, "'" | "’")
}

/// Whether a unit behind an apostrophe makes that a prime: inches, a double prime, or nothing.
fn is_prime_or_inch(word: &str, unit: Unit) -> bool {
    word.is_empty() || unit == Unit::Length(LengthUnit::Inch) || unit == Unit::Angle(AngleUnit::Arcsecond)
}

/// Whether a number behind feet stands for inches without saying so: one or two digits, no group of three.
fn is_inches(number_text: &str, feet: &str) -> bool {
    let digits = number_text.trim();
    matches!(feet, "'" | "′" | "’" | "ft" | "feet" | "foot") && digits.len() <= 2 && digits.bytes().all(|digit| digit.is_ascii_digit())
}

/// The length of the number at the beginning of `text`, a fraction and the spaces around it included.
fn number_length(text: &str) -> usize {
    let belongs = |(at, c): &(usize, char)| {
        c.is_ascii_digit() || c.is_whitespace() || matches!(c, '.' | ',' | '/') || (*at == 0 && matches!(c, '-' | '−'))
    };
    length(text, belongs)
}

/// The length of the unit at the beginning of `text`: a word, or a sign alone.
fn unit_length(text: &str) -> usize {
    let first = text.chars().next();
    if first.is_some_and(char::is_alphabetic) || first == Some('µ') {
        return length(text, |(_, c)| c.is_alphabetic() || *c == 'µ');
    }
    let sign = if text.starts_with("''") {
        2
    } else {
        first.map_or(0, char::len_utf8)
    };
    sign.min(text.len())
}

fn length(text: &str, belongs: impl Fn(&(usize, char)) -> bool) -> usize {
    let end = text.char_indices().find(|at| !belongs(at));
    end.map_or(text.len(), |(at, _)| at)
}
