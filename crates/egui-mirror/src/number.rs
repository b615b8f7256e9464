//! Numbers as people write them.

/// The number in a text such as "1400 px", so that it can be edited without its unit: the longest run of characters
/// that a number is made of, or the whole text if that run is no number.
pub(crate) fn bare_number(text: &str) -> &str {
    let is_part = |c: char| c.is_ascii_digit() || matches!(c, '.' | ',' | '-' | '−' | '+' | 'e' | 'E');
    let longest = text.split(|c: char| !is_part(c)).max_by_key(|run| run.len()).unwrap_or(text);
    if number(longest).is_some() { longest } else { text }
}

/// A number as people write it: with a point or a comma, with a hyphen or a minus sign.
pub(crate) fn number(text: &str) -> Option<f64> {
    text.trim()
        .replace(',', ".")
        .replace('−', "-")
        .parse::<f64>()
        .ok()
        .filter(|number| number.is_finite())
}
