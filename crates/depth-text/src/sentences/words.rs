//! Pieces of sentences.

use std::fmt::Write as _;

/// `text` with a capital first letter.
pub fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars
        .next()
        .map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
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
