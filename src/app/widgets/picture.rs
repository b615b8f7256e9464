//! What pictures share: an accessible name and description, and an explanation while they are empty.

use crate::app::sentences::Hint;
use crate::app::theme;
use egui::accesskit::Role;
use egui::{Align2, Response, Sense, Stroke, StrokeKind, Ui, vec2};
use std::fmt::Display;

/// Makes `response` an image with a name and a description in words.
pub fn describe(ui: &Ui, response: &Response, name: &str, description: &impl Display) {
    ui.accesskit_node_builder(response.id, |node| {
        node.set_role(Role::Image);
        node.set_label(name);
        node.set_description(description.to_string());
    });
}

/// A frame in place of a picture that has nothing to show yet, with a hint that says what it will show.
pub fn empty_ui(ui: &mut Ui, name: &str, hint: &Hint) {
    let palette = theme::palette(ui);
    let (rect, response) = ui.allocate_exact_size(vec2(ui.available_width(), theme::PICTURE_HEIGHT), Sense::hover());
    let line = Stroke::new(theme::THIN_LINE, palette.line);
    ui.painter().rect_stroke(rect, theme::CONTROL_RADIUS, line, StrokeKind::Inside);
    let mut job = egui::text::LayoutJob::simple(
        hint.to_string(),
        theme::regular(theme::SMALL_SIZE),
        palette.muted,
        (rect.width() - theme::EMPTY_PICTURE_MARGINS).min(theme::EMPTY_PICTURE_TEXT_WIDTH),
    );
    job.halign = egui::Align::Center;
    let galley = ui.painter().layout_job(job);
    let position = Align2::CENTER_CENTER.anchor_size(rect.center(), galley.size()).center_top();
    ui.painter().galley(position, galley, palette.muted);
    describe(ui, &response, name, hint);
}
