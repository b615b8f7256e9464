//! What pictures share: an accessible name and description, and an explanation while they are empty.

use super::cards;
use crate::app::sentences::Hint;
use crate::app::theme;
use egui::accesskit::Role;
use egui::{Align2, Response, Sense, Ui};
use std::fmt::{Debug, Display};
use std::hash::Hash;

/// Makes `response` an image with a name and a description in words.
pub fn describe(ui: &Ui, response: &Response, name: &str, description: &impl Display) {
    ui.accesskit_node_builder(response.id, |node| {
        node.set_role(Role::Image);
        node.set_label(name);
        node.set_description(description.to_string());
        // egui says it of what can have the focus.
        let [min, max] = [response.rect.min, response.rect.max];
        node.set_bounds(egui::accesskit::Rect::new(min.x.into(), min.y.into(), max.x.into(), max.y.into()));
    });
}

/// A card in place of a picture that has nothing to show yet, with a hint that says what it will show.
pub fn empty_card_ui(ui: &mut Ui, id: impl Hash + Debug, title: &str, height: f32, hint: &Hint) {
    let frame = cards::Frame {
        title,
        caption: "",
        height: Some(height),
    };
    let size = cards::inner_size(ui, height);
    frame.ui(ui, id, |ui| {
        let palette = theme::palette(ui);
        let (rect, response) = ui.allocate_exact_size(size, Sense::hover());
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
        describe(ui, &response, title, hint);
    });
}
