//! How wide text is.

use crate::Words;

/// A font, as far as a layout needs it.
pub trait Measure {
    /// The width of `words` at `size`, points.
    fn width(&self, words: &Words, size: f32) -> f32;
}

/// The size of a subscript, as a part of that of the text.
pub const SUBSCRIPT_SIZE: f32 = 0.72;
/// How far a subscript stands below the text, as a part of that size.
pub const SUBSCRIPT_DROP: f32 = 0.2;

/// The average widths of Inter's signs, for a page whose font nobody can ask: a little more than the text takes.
#[derive(Clone, Copy, Debug)]
pub struct InterWidths;

impl Measure for InterWidths {
    fn width(&self, words: &Words, size: f32) -> f32 {
        let of = |letter: char| match letter {
            'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '\'' | '|' | '\u{2009}' | '\u{202f}' => 0.29,
            ' ' | 'f' | 'r' | 't' | '(' | ')' | '[' | ']' | '/' | 'I' => 0.36,
            'm' | 'w' | 'M' | 'W' | '…' => 0.88,
            letter if letter.is_uppercase() => 0.69,
            '0'..='9' | '±' | '=' | '+' | '−' | '×' => 0.64,
            _ => 0.58,
        };
        let run = |run: &crate::Run| {
            let size = if run.is_subscript { size * SUBSCRIPT_SIZE } else { size };
            run.text.chars().map(of).sum::<f32>() * size * if run.is_strong { 1.05 } else { 1.0 }
        };
        words.runs.iter().map(run).sum()
    }
}
