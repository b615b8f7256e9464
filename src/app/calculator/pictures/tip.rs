//! A tip over a picture: a card with lines of text beside what is pointed at.

use super::handle::{self, Slider};
use crate::app::theme;
use crate::app::widgets::{figure, symbols};
use depth_figures::Words;
use egui::{Pos2, Rect, Response, Stroke, StrokeKind, Ui, pos2, vec2};

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

/// Where a cursor stands before anybody has moved it.
#[derive(Clone, Copy)]
pub enum Start {
    /// On the first of its stops.
    First,
    /// On the last.
    Last,
}

/// Paints the tip of the stop under the pointer, or with the keyboard of the one on which the cursor of the chart `title` stands: a
/// slider from stop to stop, whose value is what the tip says.
pub fn cursor_ui(ui: &Ui, response: &Response, title: &str, start: Start, mut stops: Vec<Stop>) {
    stops.retain(|stop| !stop.lines.is_empty());
    let Some(last) = stops.len().checked_sub(1) else { return };
    let id = response.id.with("cursor");
    let stands: Option<usize> = ui.data(|data| data.get_temp(id));
    let first = match start {
        Start::First => 0,
        Start::Last => last,
    };
    let now = stands.unwrap_or(first).min(last);
    let Some(stop) = stops.get(now) else { return };
    let words: Vec<String> = stop.lines.iter().map(Words::text).collect();
    let slider = Slider {
        name: &format!("Data cursor: {title}"),
        value: index(now),
        range: [0.0, index(last)],
        words: &words.join(", "),
    };
    let handle = handle::cursor(ui, id, stop.hit, &slider);
    let next = match handle.set_to {
        Some(value) => stops
            .iter()
            .enumerate()
            .map(|(at, _)| at)
            .find(|at| index(*at) >= value.round())
            .unwrap_or(last),
        None => now.saturating_add_signed(isize::try_from(handle.steps).unwrap_or(0)).min(last),
    };
    if next != now {
        ui.data_mut(|data| data.insert_temp(id, next));
        ui.ctx().request_repaint();
    }
    let shown = match response.hover_pos() {
        Some(pointer) => stops.iter().find(|stop| stop.hit.contains(pointer)),
        None => handle.response.has_focus().then(|| stops.get(next)).flatten(),
    };
    if let Some(stop) = shown {
        let stroke = Stroke::new(theme::THIN_LINE, theme::palette(ui).text);
        ui.painter().circle_stroke(stop.at, theme::RING_RADIUS, stroke);
        paint(ui, response.rect, stop.at, &stop.lines);
    }
}

fn index(at: usize) -> f64 {
    u32::try_from(at).map_or(f64::INFINITY, f64::from)
}
