//! Text in pieces: ink, weight, and true subscripts.

use crate::Ink;
use depth_text::field::Key;
use depth_text::fields;

/// A piece of text that is drawn in one way.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Run {
    /// The text.
    pub text: String,
    /// Its color.
    pub ink: Ink,
    /// Whether it is in the heavier weight.
    pub is_strong: bool,
    /// Whether it is a subscript: smaller, and lower.
    pub is_subscript: bool,
}

/// A line of text.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Words {
    /// Its pieces, from left to right.
    pub runs: Vec<Run>,
}

/// Which end of a text stands where it is put.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Align {
    /// The left end.
    Left,
    /// The middle.
    Center,
    /// The right end.
    Right,
}

impl Words {
    /// Text in one ink.
    pub fn new(text: impl Into<String>, ink: Ink) -> Self {
        Self::default().then(text, ink)
    }

    /// The same in the heavier weight.
    pub fn strong(text: impl Into<String>, ink: Ink) -> Self {
        Self::default().then_strong(text, ink)
    }

    /// The symbol of a quantity as the field writes it, its subscript as a subscript: "w_img", "fx", "cy".
    pub fn symbol(symbol: &str, ink: Ink) -> Self {
        Self::default().then_symbol(symbol, ink, false)
    }

    /// These words, and then `text`.
    #[must_use]
    pub fn then(self, text: impl Into<String>, ink: Ink) -> Self {
        self.push(text.into(), ink, false, false)
    }

    /// These words, and then `text` in the heavier weight.
    #[must_use]
    pub fn then_strong(self, text: impl Into<String>, ink: Ink) -> Self {
        self.push(text.into(), ink, true, false)
    }

    /// These words, and then the symbol of a quantity; see [`Self::symbol`].
    #[must_use]
    pub fn then_symbol(self, symbol: &str, ink: Ink, is_strong: bool) -> Self {
        let (letter, below) = split_symbol(symbol);
        let words = self.push(letter.to_owned(), ink, is_strong, false);
        if below.is_empty() {
            words
        } else {
            words.push(below.to_owned(), ink, is_strong, true)
        }
    }

    /// The text without its looks.
    pub fn text(&self) -> String {
        self.runs.iter().map(|run| run.text.as_str()).collect()
    }

    fn push(mut self, text: String, ink: Ink, is_strong: bool, is_subscript: bool) -> Self {
        self.runs.push(Run {
            text,
            ink,
            is_strong,
            is_subscript,
        });
        self
    }
}

/// The letter of a symbol and what stands below it: "w" and "img", "f" and "x", "d" and nothing.
pub fn split_symbol(symbol: &str) -> (&str, &str) {
    if let Some(parts) = symbol.split_once('_') {
        return parts;
    }
    let is_indexed = symbol.len() == 2 && symbol.starts_with(['f', 'c']) && symbol.ends_with(['x', 'y']);
    if is_indexed { symbol.split_at(1) } else { (symbol, "") }
}

/// `text` cut where symbols of fields stand in it, each part with the field whose symbol it is.
pub fn symbols_in(text: &str) -> Vec<(&str, Option<Key>)> {
    let is_word = |c: char| c.is_alphanumeric() || c == '_';
    let mut parts = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let inside = is_word(first);
        let end = rest.find(|c| is_word(c) != inside).unwrap_or(rest.len());
        let (part, behind) = rest.split_at(end);
        let key = Key::form().chain([fields::DISTANCE]).find(|key| inside && key.symbol == part);
        parts.push((part, key));
        rest = behind;
    }
    parts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_text_falls_into_symbols_and_what_is_between_them() {
        let parts = symbols_in("D = w_real·fx / w_img, bad");
        let symbols: Vec<&str> = parts.iter().filter(|(_, key)| key.is_some()).map(|(part, _)| *part).collect();
        assert_eq!(symbols, ["D", "w_real", "fx", "w_img"]);
        assert_eq!(
            parts.iter().map(|(part, _)| *part).collect::<String>(),
            "D = w_real·fx / w_img, bad"
        );
    }

    #[test]
    fn subscripts_are_those_of_the_field() {
        for (symbol, parts) in [
            ("fx", ("f", "x")),
            ("w_img", ("w", "img")),
            ("d", ("d", "")),
            ("doffs", ("doffs", "")),
            ("cy", ("c", "y")),
        ] {
            assert_eq!(split_symbol(symbol), parts);
        }
    }
}
