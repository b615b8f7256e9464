//! Lines of a cell in parts, so that a window can color what belongs to a field and light that field up.

use crate::assess::Assessment;
use crate::field::Key;
use crate::reading::Reading;
use crate::style::Style;
use crate::unit::Unit;
use depth_core::quantity::LengthUnit;

const STYLE: Style = Style::WINDOW;

/// Digits of a length that was typed in another unit than that of the results.
const CONVERTED_DIGITS: usize = 5;

/// A piece of a line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// Text that belongs to nothing.
    Text(String),
    /// The symbol or the number of a field.
    Field(Key, String),
}

impl Part {
    /// The words of it.
    pub fn text(&self) -> &str {
        match self {
            Self::Text(text) | Self::Field(_, text) => text,
        }
    }
}

/// A small line of a cell; may be empty.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Line {
    /// Its pieces from left to right.
    pub parts: Vec<Part>,
    /// Whether it says that there is no answer, which is red.
    pub is_refusal: bool,
}

impl Line {
    /// A line in which the symbols of `keys` belong to their fields.
    pub(super) fn of(text: impl ToString, keys: &[Key]) -> Self {
        let find = |symbol: &str| keys.iter().copied().find(|key| key.symbol == symbol);
        let parts = words(&text.to_string())
            .into_iter()
            .map(|(word, is_symbol)| match find(word).filter(|_| is_symbol) {
                Some(key) => Part::Field(key, word.to_owned()),
                None => Part::Text(word.to_owned()),
            })
            .collect();
        Self {
            parts: joined(parts),
            is_refusal: false,
        }
    }

    /// The same as what says that there is no answer.
    pub(super) fn refusal(self) -> Self {
        Self { is_refusal: true, ..self }
    }

    /// The same with `text` in front.
    pub(super) fn after(mut self, text: &str) -> Self {
        self.parts.insert(0, Part::Text(text.to_owned()));
        Self {
            parts: joined(self.parts),
            ..self
        }
    }

    /// The same without the unit `unit` behind the numbers of fields.
    pub(super) fn without(mut self, unit: &str) -> Self {
        for part in &mut self.parts {
            if let Part::Field(_, number) = part {
                number.truncate(number.trim_end_matches(unit).len());
            }
        }
        self
    }

    /// All of it as one text.
    pub fn text(&self) -> String {
        self.parts.iter().map(Part::text).collect()
    }
}

/// `formula` with the numbers of `keys` in place of their symbols, lengths in `unit`; `None` while one is missing. `solved` is the number
/// in place of a symbol that no field has, such as an α that was worked out.
pub(super) fn numbers(formula: &str, keys: &[Key], assessment: &Assessment, unit: LengthUnit, solved: &[(&str, String)]) -> Option<Line> {
    let mut parts: Vec<Part> = Vec::new();
    for (word, is_symbol) in words(formula) {
        if let Some((_, number)) = solved.iter().find(|(symbol, _)| *symbol == word) {
            parts.push(Part::Text(number.clone()));
            continue;
        }
        let Some(key) = keys.iter().copied().find(|key| is_symbol && key.symbol == word) else {
            parts.push(Part::Text(word.to_owned()));
            continue;
        };
        let number = number_in(assessment.reading(key)?, unit);
        let before = parts.last_mut();
        let positive = number.strip_prefix(['-', '−']);
        match (before, positive) {
            // No two signs in a row.
            (Some(Part::Text(before)), Some(positive)) if before.ends_with("+ ") || before.ends_with("− ") => {
                let sign = if before.ends_with("+ ") { "− " } else { "+ " };
                let kept = before.trim_end_matches(['+', '−', ' ']).to_owned();
                *before = format!("{kept} {sign}");
                parts.push(Part::Field(key, positive.to_owned()));
            }
            _ => parts.push(Part::Field(key, number)),
        }
    }
    Some(Line {
        parts: joined(parts),
        is_refusal: false,
    })
}

/// A number as it was typed, or a length that was typed in another unit in that of the results, so that the sum comes out.
fn number_in(reading: &Reading, unit: LengthUnit) -> String {
    match reading.unit {
        Some(typed @ (Unit::Length(_) | Unit::Square(_))) if reading.key.is_length() && typed != Unit::Length(unit) => {
            let unit = Unit::Length(unit);
            unit.behind(&STYLE.readable(unit.from_base(reading.value), CONVERTED_DIGITS))
        }
        _ => STYLE.typed(reading),
    }
}

/// `text` in words that could be symbols and what stands between them.
fn words(text: &str) -> Vec<(&str, bool)> {
    let is_of_symbol = |c: char| c.is_alphanumeric() || c == '_';
    let mut words = Vec::new();
    let mut rest = text;
    while let Some(first) = rest.chars().next() {
        let is_symbol = is_of_symbol(first);
        let end = rest.find(|c| is_of_symbol(c) != is_symbol).unwrap_or(rest.len());
        let (word, after) = rest.split_at_checked(end).unwrap_or((rest, ""));
        words.push((word, is_symbol));
        rest = after;
    }
    words
}

/// The same with texts that follow each other in one.
fn joined(parts: Vec<Part>) -> Vec<Part> {
    let mut joined: Vec<Part> = Vec::new();
    for part in parts {
        match (joined.last_mut(), part) {
            (Some(Part::Text(before)), Part::Text(text)) => before.push_str(&text),
            (_, part) => joined.push(part),
        }
    }
    joined
}
