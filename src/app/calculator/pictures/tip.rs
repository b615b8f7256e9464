//! A tip over a picture: a card with lines of text beside what is pointed at.

use crate::app::theme;
use crate::app::widgets::{figure, symbols};
use depth_figures::Words;
use egui::{Pos2, Rect, Stroke, StrokeKind, Ui, pos2, vec2};

/// Draws a tip with `lines` above `at`, or below where there is no room, inside `frame`.
pub fn paint(ui: &Ui, frame: Rect, at: Pos2, lines: &[Words]) {
    let palette = theme::palette(ui);
    let layout = |words: &Words| {
        let job = symbols::of_words(words, theme::SMALL_SIZE, |ink| figure::color(palette, ink));
        ui.painter().layout_job(job)
    };
    let galleys: Vec<_> = lines.iter().map(layout).collect();
    let width = galleys.iter().map(|galley| galley.size().x).fold(0.0, f32::max);
    let count = f32::from(u16::try_from(galleys.len()).unwrap_or(u16::MAX));
    let size = vec2(width, count * theme::TIP_LINE) + 2.0 * theme::TIP_PADDING;
    let left = (at.x - size.x / 2.0).clamp(frame.left(), (frame.right() - size.x).max(frame.left()));
    let above = at.y - theme::TIP_DISTANCE - size.y;
    let top = if above >= frame.top() { above } else { at.y + theme::TIP_DISTANCE };
    let rect = Rect::from_min_size(pos2(left, top), size);
    let border = Stroke::new(theme::THIN_LINE, palette.border);
    ui.painter()
        .rect(rect, theme::CONTROL_RADIUS, palette.surface, border, StrokeKind::Inside);
    for (index, galley) in (0u16..).zip(galleys) {
        let y = rect.top() + theme::TIP_PADDING.y + f32::from(index) * theme::TIP_LINE + (theme::TIP_LINE - galley.size().y) / 2.0;
        ui.painter()
            .galley(pos2(rect.left() + theme::TIP_PADDING.x, y), galley, palette.text);
    }
}
