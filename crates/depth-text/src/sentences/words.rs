//! Pieces of sentences.

use crate::field::Key;
use crate::fields;
use depth_core::setup::{Object, Pair};

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

/// `text` between quotation marks, cut where it is too long to quote. Text that runs from right to left is isolated (UAX 9): it would
/// turn the sentence that begins with it around.
pub fn quoted(text: &str) -> String {
    const LONGEST: usize = 24;
    let is_right_to_left = |c: char| matches!(c, '\u{590}'..='\u{8ff}' | '\u{fb1d}'..='\u{fdff}' | '\u{fe70}'..='\u{feff}');
    let is_isolated = text.trim().chars().take(LONGEST).any(is_right_to_left);
    let mut quoted = String::from("“");
    quoted.extend(is_isolated.then_some('\u{2068}'));
    for (count, c) in text.trim().chars().enumerate() {
        if count == LONGEST {
            quoted.push('…');
            break;
        }
        // Nor does what is quoted turn anything around.
        let turns = matches!(c, '\u{200e}' | '\u{200f}' | '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}');
        quoted.push(if c.is_control() || turns { ' ' } else { c });
    }
    quoted.extend(is_isolated.then_some('\u{2069}'));
    quoted.push('”');
    quoted
}

/// What of the object is measured, in the image and in the world, in the middle of a sentence: "the width in the image", "the real
/// width".
pub fn sizes(object: Object) -> [&'static str; 2] {
    [fields::IMAGE_WIDTH, fields::REAL_WIDTH].map(|key| key.worded(object, Pair::default()).noun)
}

/// A field in the middle of a sentence about causes: "disparity".
pub fn short_name(key: Key) -> &'static str {
    key.noun.trim_start_matches("the ")
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

#[cfg(test)]
mod tests {
    use super::quoted;

    #[test]
    fn only_text_that_runs_from_right_to_left_is_isolated() {
        assert_eq!(quoted(" far "), "“far”");
        assert_eq!(quoted("متر ٥"), "“\u{2068}متر ٥\u{2069}”");
        assert_eq!(quoted("מטר"), "“\u{2068}מטר\u{2069}”");
        assert_eq!(quoted("a".repeat(30).as_str()), format!("“{}…”", "a".repeat(24)));
    }
}
