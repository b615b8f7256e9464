//! What the pictures are drawn with: letters, small labels, dimension lines.

use crate::labels::rect_at;
use crate::{Align, Figure, Fill, Ink, Measure, Point, Rect, Stroke, Words};

/// The size of the letters.
pub(super) const LETTER: f32 = 17.0;
/// The size of small labels.
pub(super) const SMALL: f32 = 12.0;

/// What is drawn so far, and with what.
pub(super) struct Pen<'a> {
    pub(super) figure: Figure,
    pub(super) measure: &'a dyn Measure,
    pub(super) highlighted: Option<&'a str>,
}

impl Pen<'_> {
    pub(super) fn width(&self, text: &str, size: f32) -> f32 {
        self.measure.width(&Words::new(text, Ink::Muted), size)
    }

    /// `text`, broken behind its comma where it is longer than `room`.
    pub(super) fn wrapped(&self, text: &str, size: f32, room: f32) -> Vec<String> {
        match text.split_once(", ") {
            Some((first, rest)) if self.width(text, size) > room => vec![format!("{first},"), rest.to_owned()],
            _ => vec![text.to_owned()],
        }
    }

    /// A small label.
    pub(super) fn small(&mut self, text: &str, at: Point, align: Align) {
        self.figure.text(at, align, Words::new(text, Ink::Muted), SMALL);
    }

    /// The symbol of a field, with a box behind it where that field has the focus.
    pub(super) fn letter(&mut self, symbol: &str, (at, align): (Point, Align), ink: Ink) {
        let words = Words::default().then_symbol(symbol, ink, true);
        if self.highlighted == Some(symbol) {
            let text = rect_at([self.measure.width(&words, LETTER), LETTER], (at, align));
            let behind = Rect::new(text.left - 7.0, at.y - 13.0, text.right + 7.0, at.y + 13.0);
            self.figure
                .frame(behind, 6.0, Some(Fill::new(Ink::Band)), Stroke::new(Ink::Border, 1.0));
        }
        self.figure.text(at, align, words, LETTER);
    }

    /// A level dimension line with a letter in the middle of it.
    pub(super) fn level(&mut self, [from, to]: [Point; 2], symbol: &str, ink: Ink) {
        let stroke = Stroke::new(ink, 1.75);
        let middle = f32::midpoint(from.x, to.x);
        for (end, inner) in [(from, middle - 14.0), (to, middle + 14.0)] {
            self.figure.line(end, Point::new(inner, end.y), stroke);
            self.figure
                .line(Point::new(end.x, end.y - 4.0), Point::new(end.x, end.y + 4.0), stroke);
        }
        self.letter(symbol, (Point::new(middle, from.y), Align::Center), ink);
    }
}

/// Thin dots.
pub(super) const fn dotted(ink: Ink) -> Stroke {
    Stroke::dashed(ink, 1.0, [1.5, 3.0])
}
