//! The two formulas, each with a sentence below it.

use super::pen::Pen;
use crate::{Align, Ink, Point, Words};

/// The size of the formulas.
const FORMULA: f32 = 19.0;
/// The size of the sentence below a formula.
const SENTENCE: f32 = 13.0;

impl Pen<'_> {
    /// Both formulas, side by side where there is room. Returns where they end.
    pub(super) fn formulas(&mut self, top: f32, has_doffs: bool) -> f32 {
        let text = |words: Words, text: &str| words.then_strong(text, Ink::Text);
        let symbol = |words: Words, symbol: &str, ink: Ink| words.then_symbol(symbol, ink, true);
        let stereo = text(symbol(text(Words::default(), "D = "), "fx", Ink::Text), " · ");
        let stereo = text(symbol(stereo, "b", Ink::Stereo), " / ");
        let stereo = if has_doffs {
            let sum = symbol(text(stereo, "("), "d", Ink::Stereo);
            text(symbol(text(sum, " + "), "doffs", Ink::Stereo), ")")
        } else {
            symbol(stereo, "d", Ink::Stereo)
        };
        let monocular = text(symbol(text(Words::default(), "D = "), "w_real", Ink::MonocularText), " · ");
        let monocular = symbol(text(symbol(monocular, "fx", Ink::Text), " / "), "w_img", Ink::MonocularText);
        let sentences = [
            "Stereo: the nearer the object, the larger the shift.",
            "Monocular: the nearer the object, the wider its image.",
        ];
        let width = self.figure.width;
        let column = width / 2.0 - 8.0;
        let fits = sentences.iter().all(|sentence| self.width(sentence, SENTENCE) <= column);
        let room = if fits { column } else { width };
        let mut at = Point::new(0.0, top);
        let mut bottom = top;
        for (formula, sentence) in [stereo, monocular].into_iter().zip(sentences) {
            self.figure.text(at, Align::Left, formula, FORMULA);
            let mut y = at.y + 24.0;
            for line in self.wrapped(sentence, SENTENCE, room) {
                self.figure
                    .text(Point::new(at.x, y), Align::Left, Words::new(line, Ink::Muted), SENTENCE);
                y += 18.0;
            }
            bottom = y - 4.0;
            at = if fits {
                Point::new(width / 2.0 + 8.0, top)
            } else {
                Point::new(0.0, y + 20.0)
            };
        }
        bottom
    }
}
