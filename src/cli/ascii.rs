//! Sentences for programs as much as for people.

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
    fn only_numbers_that_are_not_quoted_change() {
        assert_eq!(
            in_sentence("“−1\u{2009}000” is unusual: most lie between −1\u{202f}000 and 20\u{2009}000 px."),
            "“−1\u{2009}000” is unusual: most lie between -1000 and 20000 px."
        );
    }
}
