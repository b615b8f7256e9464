//! Numbers as programs print them.

/// The number that `text` is: `861.`, `.5`, `7.5e+002`, `-0.0`, `752.0f`; also `nan` and `inf` in the spellings of YAML and Python.
pub(crate) fn number(text: &str) -> Option<f64> {
    let text = text.trim();
    let lower = text.to_ascii_lowercase();
    match lower.trim_start_matches(['+', '-']) {
        ".nan" | "nan" => return Some(f64::NAN),
        ".inf" | "inf" | "infinity" => return Some(if lower.starts_with('-') { f64::NEG_INFINITY } else { f64::INFINITY }),
        _ => {}
    }
    // Rust reads words that are no numbers of a file.
    if !text.contains(|character: char| character.is_ascii_digit()) {
        return None;
    }
    let text = text.strip_suffix(['f', 'F']).unwrap_or(text);
    text.parse().ok()
}

/// A number to four digits, for a sentence.
pub(crate) fn brief(number: f64) -> f64 {
    format!("{number:.3e}").parse().unwrap_or(number)
}

/// How many numbers a line holds that holds nothing else, and the first `N` of them, in the order of [`numbers`].
pub(crate) fn first_numbers<const N: usize>(line: &str) -> Option<(usize, [f64; N])> {
    let mut first = [0.0; N];
    let mut count = 0;
    for part in parts(line) {
        let number = number(part)?;
        if let Some(place) = first.get_mut(count) {
            *place = number;
        }
        count += 1;
    }
    Some((count, first))
}

/// The numbers in a line that holds nothing else: with blanks, commas or semicolons between them, in brackets or not.
pub(crate) fn numbers(line: &str) -> Option<Vec<f64>> {
    parts(line).map(number).collect()
}

fn parts(line: &str) -> impl Iterator<Item = &str> {
    let parts = line.split(|character: char| character.is_whitespace() || "[](){},;".contains(character));
    parts.filter(|part| !part.is_empty())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{number, numbers};

    #[test]
    fn numbers_are_read_as_programs_print_them() {
        for (text, value) in [
            ("861.", 861.0),
            (".5", 0.5),
            ("7.5e+002", 750.0),
            ("-0.", 0.0),
            ("640.0f", 640.0),
            (" 7 ", 7.0),
        ] {
            assert_eq!(number(text), Some(value), "{text}");
        }
        assert!(number(".NaN").unwrap().is_nan() && number("-.inf").unwrap() == f64::NEG_INFINITY);
        for text in ["", "fx", "1,0", "e", "f", "--1", "0x10"] {
            assert_eq!(number(text), None, "{text}");
        }
        assert_eq!(numbers("[3980 0 1244.75; 0, 1]"), Some(vec![3980.0, 0.0, 1244.75, 0.0, 1.0]));
        assert_eq!(numbers("1 two"), None);
    }
}
