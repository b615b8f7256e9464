//! Reads one number with the unit behind it.

use super::clean::{normalized, without_brackets, without_name};
use super::typed::{LONGEST, NumberError, Primes, Typed};
use super::{arithmetic, compound, split};
use crate::unit::Unit;
use depth_core::quantity::Length;

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
    let as_typed = text;
    let text = normalized(text);
    let is_translated = text != as_typed;
    let text = without_name(text.trim());
    if let Some(typed) = compound::read(text, primes) {
        return checked(typed);
    }
    let (number_text, unit_text) = split::number_and_unit(text);
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
        last_unit: unit,
        is_computed: is_computed || is_translated,
    })
}

fn checked(typed: Typed) -> Result<Typed, NumberError> {
    if typed.number.is_finite() {
        Ok(typed)
    } else {
        Err(NumberError::TooExtreme)
    }
}

/// The unit that `word` names, or squares of a board with their size.
fn unit(word: &str, primes: Primes) -> Option<Unit> {
    match words_after_squares(&word.to_ascii_lowercase()) {
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
