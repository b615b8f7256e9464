//! Pieces of sentences.

use crate::field::Key;
use depth_core::problem::Field;
use std::fmt::Write as _;

/// `text` with a capital first letter.
pub fn capital(text: &str) -> String {
    let mut chars = text.chars();
    chars
        .next()
        .map_or_else(String::new, |first| first.to_uppercase().chain(chars).collect())
}

/// What is still needed: "needs b and d"; empty where nothing is.
pub fn needs(missing: &[Key]) -> String {
    let symbols: Vec<&str> = missing.iter().map(|key| key.symbol).collect();
    match symbols.as_slice() {
        [] => String::new(),
        [one] => format!("needs {one}"),
        [first @ .., last] => format!("needs {} and {last}", first.join(", ")),
    }
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

/// A field in the middle of a sentence about causes: "disparity".
pub fn short_name(field: Field) -> &'static str {
    Key::from(field).noun.trim_start_matches("the ")
}

/// A share of a whole, "75 %".
pub fn percent(share: f64) -> String {
    let percent = share * 100.0;
    if percent > 0.0 && percent < 0.5 {
        "under 1 %".to_owned()
    } else {
        format!("{percent:.0} %")
    }
}
