//! The line below a picture.

use crate::{Ink, Measure, Words};

/// The size of a line below a picture, points.
const NOTE_SIZE: f32 = 12.0;

/// Whether a line below a picture `width` wide has room for `text`.
pub fn fits(text: &str, width: f32, measure: &dyn Measure) -> bool {
    measure.width(&Words::new(text, Ink::Muted), NOTE_SIZE) <= width
}

/// `sentences` as a line below a picture `width` wide: on a phone a word less keeps them on one line, or the last is left out.
pub fn fitted(sentences: &[String], width: f32, measure: &dyn Measure) -> String {
    let whole = sentences.join(" ");
    let shorter = whole.replace(", drawn ", ", ");
    let fewer = || sentences.split_last().map(|(_, fewer)| fitted(fewer, width, measure));
    if fits(&whole, width, measure) {
        whole
    } else if fits(&shorter, width, measure) {
        shorter
    } else {
        fewer().unwrap_or_default()
    }
}
