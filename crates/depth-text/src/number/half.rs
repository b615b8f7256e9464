//! Numbers that somebody is still typing.

/// Whether `text` is the beginning of a number with its unit that is not yet one: "−", "1.4e", "50 ±", "10 c". Who types is not told of a
/// mistake then.
pub fn is_half_typed(text: &str) -> bool {
    let text = text.trim();
    let digits = text.trim_end_matches(|c: char| c.is_alphabetic() || c == 'µ' || c == '°');
    let word = text.strip_prefix(digits).unwrap_or_default();
    let is_number = |text: &str| {
        text.chars()
            .all(|c| c.is_numeric() || " .,+-−±×*/'′\"″eE^()\u{2009}\u{202f}".contains(c))
    };
    if text.is_empty() || !is_number(digits) {
        return false;
    }
    if word.is_empty() {
        // A sign, a separator or an operator that something follows.
        return digits.trim_end().ends_with(['+', '-', '−', '.', ',', '±', '×', '*', '/', '(', '^']);
    }
    let has_digits = digits.chars().any(char::is_numeric);
    let is_power = matches!(word, "e" | "E");
    has_digits && (is_power || is_beginning_of_unit(word))
}

/// Whether a unit begins with `word` and goes on.
fn is_beginning_of_unit(word: &str) -> bool {
    const UNITS: [&str; 18] = [
        "px",
        "pixels",
        "nm",
        "µm",
        "mm",
        "cm",
        "km",
        "meters",
        "inches",
        "feet",
        "ft",
        "yards",
        "miles",
        "degrees",
        "radians",
        "mrad",
        "arcminutes",
        "squares",
    ];
    let word = word.to_ascii_lowercase();
    UNITS.iter().any(|unit| unit.len() > word.len() && unit.starts_with(&word))
}

#[cfg(test)]
mod tests {
    use super::is_half_typed;

    #[test]
    fn what_may_become_a_number_is_no_mistake_yet() {
        for text in [
            "-", "−", "1.", "1.4e", "1.4e-", "50 ±", "10 c", "10 k", "3 ×", "1/", "12 ar", ".", "2 sq",
        ] {
            assert!(is_half_typed(text), "{text}");
        }
        for text in ["", " ", "abc", "700", "10 cm", "7 parsec", "0", "1e999", "seven", "c", "5'11\""] {
            assert!(!is_half_typed(text), "{text}");
        }
    }
}
