//! A bar that shows how much of something is done.

use crate::app::theme;
use egui::accesskit::Role;
use egui::{Sense, Stroke, StrokeKind, Ui, vec2};

/// Draws the bar of what is called `name`, at `percent`, 0 to 100, over the whole width. Nothing is announced while it moves: a screen reader tells
/// it when asked.
pub fn ui(ui: &mut Ui, name: &str, percent: u16) {
    let palette = theme::palette(ui);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), theme::PROGRESS_HEIGHT), Sense::hover());
    let done = rect.with_max_x(rect.left() + rect.width() * f32::from(percent) / 100.0);
    ui.painter().rect_filled(rect, theme::MARK_RADIUS, palette.highlight);
    ui.painter().rect_filled(done, theme::MARK_RADIUS, palette.blue);
    let border = Stroke::new(theme::THIN_LINE, palette.border);
    ui.painter().rect_stroke(rect, theme::MARK_RADIUS, border, StrokeKind::Inside);
    ui.accesskit_node_builder(response.id, |node| {
        node.set_role(Role::ProgressIndicator);
        node.set_label(name);
        node.set_min_numeric_value(0.0);
        node.set_max_numeric_value(100.0);
        node.set_numeric_value(f64::from(percent));
    });
}
