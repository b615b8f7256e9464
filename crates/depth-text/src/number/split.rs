//! Where a number ends and its unit begins.

use super::arithmetic::{is_operator, is_superscript};
use super::decimal::{is_minus, is_separator};

/// Splits what was typed into the number and what follows it.
pub(super) fn number_and_unit(text: &str) -> (&str, &str) {
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
