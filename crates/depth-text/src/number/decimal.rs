//! One decimal number.
//!
//! Asks where it would have to guess: `1,000` is a thousand in London and one in Berlin.

use super::typed::NumberError;

/// The value of a text without a unit.
pub(super) fn value(text: &str) -> Result<f64, NumberError> {
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

pub(super) const fn is_minus(c: char) -> bool {
    matches!(c, '-' | '−')
}

/// Marks that group digits or stand before decimals in some country.
pub(super) fn is_separator(c: char) -> bool {
    matches!(c, '.' | ',' | '\'' | '’' | '_' | '·' | '٫' | '٬') || c.is_whitespace()
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
