//! What people type instead of working it out: a product, a quotient, a whole number with a fraction, a power of ten.

use super::decimal;
use super::typed::NumberError;

/// The value of a text without a unit, and whether it was worked out.
///
/// # Errors
/// See [`NumberError`]; the readings of an ambiguous one are without a unit.
pub(super) fn value(text: &str) -> Result<(f64, bool), NumberError> {
    if let Some(value) = mixed(text) {
        return Ok((value, true));
    }
    let mut factors = Vec::new();
    let mut rest = text;
    let mut divides = false;
    while let Some(at) = rest.find(is_operator) {
        let (before, sign) = rest.split_at_checked(at).unwrap_or((rest, ""));
        factors.push((divides, before.trim()));
        divides = sign.starts_with('/');
        let mut chars = sign.chars();
        chars.next();
        rest = chars.as_str();
    }
    factors.push((divides, rest.trim()));
    match factors.as_slice() {
        [(_, power)] if power_of_ten(power).is_some() => {
            let exponent = power_of_ten(power).unwrap_or_default();
            return decimal::value(&format!("1e{exponent}")).map(|value| (value, false));
        }
        [(_, one)] => return decimal::value(one).map(|value| (value, false)),
        // A power of ten is how a number is written, not worked out.
        [(_, digits), (false, power)] if power_of_ten(power).is_some() => {
            let exponent = power_of_ten(power).unwrap_or_default();
            let has_exponent = digits.contains(['e', 'E']);
            decimal::value(digits)?;
            if !has_exponent {
                return decimal::value(&format!("{digits}e{exponent}")).map(|value| (value, false));
            }
        }
        _ => {}
    }
    let mut value = 1.0;
    for (divides, text) in factors {
        let number = match power_of_ten(text) {
            Some(exponent) => decimal::value(&format!("1e{exponent}"))?,
            // What could mean several numbers is not worked with.
            None => decimal::value(text).map_err(|error| match error {
                NumberError::Ambiguous { .. } => NumberError::Ambiguous { readings: Vec::new() },
                other => other,
            })?,
        };
        value = if divides { value / number } else { value * number };
    }
    Ok((value, true))
}

pub(super) const fn is_operator(c: char) -> bool {
    matches!(c, '*' | '×' | '/' | 'x' | 'X')
}

pub(super) fn is_superscript(c: char) -> bool {
    SUPERSCRIPTS.contains(c)
}

const SUPERSCRIPTS: &str = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻⁺";

/// The exponent of "10^-11" and "10⁻¹¹".
fn power_of_ten(text: &str) -> Option<String> {
    let exponent = text.strip_prefix("10")?;
    let written: String = match exponent.strip_prefix('^') {
        Some(exponent) => exponent.replace('−', "-"),
        None => exponent.chars().map(lowered).collect::<Option<_>>()?,
    };
    let digits = written.trim_start_matches(['-', '+']);
    (!digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit())).then_some(written)
}

fn lowered(superscript: char) -> Option<char> {
    let place = SUPERSCRIPTS.chars().position(|c| c == superscript)?;
    "0123456789-+".chars().nth(place)
}

/// "1 1/8" and "1-1/8": a whole number and a fraction below one.
fn mixed(text: &str) -> Option<f64> {
    let (left, denominator) = text.split_once('/')?;
    let (whole, numerator) = left.trim().rsplit_once([' ', '-', '\u{a0}'])?;
    let negative = whole.starts_with(['-', '−']);
    let whole = whole.trim_start_matches(['-', '−']).trim();
    let number = |digits: &str| {
        let digits = digits.trim();
        let is_whole = !digits.is_empty() && digits.bytes().all(|digit| digit.is_ascii_digit());
        is_whole.then(|| digits.parse::<f64>().ok()).flatten()
    };
    let (whole, numerator, denominator) = (number(whole)?, number(numerator)?, number(denominator)?);
    let value = whole + numerator / denominator;
    (numerator < denominator || denominator == 0.0).then_some(if negative { -value } else { value })
}
