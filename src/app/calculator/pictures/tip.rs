//! A tip over a picture: a card with lines of text beside what is pointed at.

use crate::app::theme;
use crate::app::widgets::{chart, figure, symbols};
use depth_figures::Words;
use egui::{Key, Pos2, Rect, Response, Stroke, StrokeKind, Ui, pos2, vec2};

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

/// A part of a chart that a tip says something about.
pub struct Stop {
    /// Where it takes the pointer.
    pub hit: Rect,
    /// What is marked.
    pub at: Pos2,
    /// What is said.
    pub lines: Vec<Words>,
}

/// Paints the tip of the stop under the pointer, or with the keyboard of the one that the arrow keys `[on, back]` lead to.
pub fn stops_ui(ui: &Ui, response: &Response, keys: [Key; 2], stops: Vec<Stop>) {
    let key = response.id.with("stop");
    let mut chosen: usize = ui.data(|data| data.get_temp(key)).unwrap_or(0);
    if response.has_focus() {
        chart::lock_arrows(ui, response.id);
        let steps = chart::take_arrows(ui, keys);
        chosen = chosen.saturating_add_signed(steps).min(stops.len().saturating_sub(1));
        ui.data_mut(|data| data.insert_temp(key, chosen));
    }
    let pointer = response.hover_pos();
    let is_shown = |(index, stop): &(usize, Stop)| {
        let is_met = pointer.map_or(response.has_focus() && *index == chosen, |pointer| stop.hit.contains(pointer));
        is_met && !stop.lines.is_empty()
    };
    if let Some((_, stop)) = stops.into_iter().enumerate().find(is_shown) {
        let stroke = Stroke::new(theme::THIN_LINE, theme::palette(ui).text);
        ui.painter().circle_stroke(stop.at, theme::RING_RADIUS, stroke);
        paint(ui, response.rect, stop.at, &stop.lines);
    }
}
