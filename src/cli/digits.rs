//! Numbers for programs as much as for people: ASCII, written out, nothing between the digits.

use depth_text::number;
use std::ops::Range;

/// Magnitudes that are written out; others are in scientific notation, for nobody counts that many zeros.
const WRITTEN_OUT: Range<f64> = 1e-6..1e15;

/// An `f64` has no more digits than this many behind the first.
const MOST_PLACES: i32 = 17;

/// `value` rounded to `decimals` places; negative ones round to tens, hundreds and so on.
pub(super) fn rounded(value: f64, decimals: i32) -> String {
    let magnitude = number::magnitude(value);
    let places = decimals.saturating_add(magnitude).clamp(0, MOST_PLACES);
    let scientific = format!("{value:.*e}", usize::try_from(places).unwrap_or(0));
    if value != 0.0 && !WRITTEN_OUT.contains(&value.abs()) {
        return scientific;
    }
    match usize::try_from(decimals.min(MOST_PLACES - magnitude)) {
        Ok(decimals) => format!("{value:.decimals$}"),
        // Rounded to tens or more: written as a whole number.
        Err(_) => scientific.parse::<f64>().map_or(scientific, |whole| format!("{whole:.0}")),
    }
}

/// `value` with `digits` significant digits.
pub(super) fn significant(value: f64, digits: u8) -> String {
    let behind_the_first = usize::from(digits.saturating_sub(1));
    // Rounding may add a digit in front: 9.9996 is 10.00.
    let scientific = format!("{value:.behind_the_first$e}");
    let exponent = scientific.split_once('e').and_then(|(_, exponent)| exponent.parse::<i32>().ok());
    rounded(value, i32::from(digits) - 1 - exponent.unwrap_or(0))
}

/// `value` as someone would type it: up to `digits` significant digits and no trailing zeros.
pub(super) fn plain(value: f64, digits: u8) -> String {
    let text = significant(value, digits);
    let (mantissa, exponent) = text.find('e').and_then(|at| text.split_at_checked(at)).unwrap_or((&text, ""));
    if !mantissa.contains('.') {
        return text;
    }
    format!("{}{exponent}", mantissa.trim_end_matches('0').trim_end_matches('.'))
}

/// A sentence made for the screen with its numbers in ASCII: a hyphen for the minus sign, no spaces that group digits.
/// What it quotes stays as it was typed.
pub(super) fn in_sentence(sentence: &str) -> String {
    let mut text = String::with_capacity(sentence.len());
    let mut quoted = false;
    for c in sentence.chars() {
        quoted = (quoted || c == '“') && c != '”';
        match c {
            '−' if !quoted => text.push('-'),
            '\u{2009}' | '\u{202f}' if !quoted => {}
            _ => text.push(c),
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_are_written_out() {
        for (value, digits, expected) in [
            (1.4, 4, "1.400"),
            (9.9996, 4, "10.00"),
            (9.96, 4, "9.960"),
            (99_999.9, 4, "100000"),
            (123_456.0, 4, "123500"),
            (0.000_123_456, 4, "0.0001235"),
            (-1234.56, 2, "-1200"),
            (0.0, 4, "0.000"),
            (1.5e20, 4, "1.500e20"),
            (1.5e-20, 4, "1.500e-20"),
        ] {
            assert_eq!(significant(value, digits), expected, "{value} with {digits}");
        }
        for (value, decimals, expected) in [
            (1.4, 3, "1.400"),
            (12_345.0, -1, "12340"),
            (12_355.0, -2, "12400"),
            (4.0, -3, "4"),
            (0.0, 3, "0.000"),
            (1.4, 40, "1.39999999999999991"),
            (2e20, -18, "2.00e20"),
        ] {
            assert_eq!(rounded(value, decimals), expected, "{value} to {decimals}");
        }
        for (value, expected) in [
            (700.0, "700"),
            (0.1, "0.1"),
            (0.1 * 1000.0, "100"),
            (1_234_567.5, "1234567.5"),
            (1e-300, "1e-300"),
        ] {
            assert_eq!(plain(value, 12), expected);
        }
    }

    #[test]
    fn only_numbers_that_are_not_quoted_change() {
        assert_eq!(
            in_sentence("“−1\u{2009}000” is unusual: most lie between −1\u{202f}000 and 20\u{2009}000 px."),
            "“−1\u{2009}000” is unusual: most lie between -1000 and 20000 px."
        );
    }
}
