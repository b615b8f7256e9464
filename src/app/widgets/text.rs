//! Headings, captions, notes and badges, with their accessible roles.

use crate::app::theme::{self, Palette};
use depth_text::note::Severity;
use egui::accesskit::{Invalid, Live, Role};
use egui::{FontId, Id, Response, RichText, Ui};

/// A heading of `level` 1 to 6.
pub fn heading_ui(ui: &mut Ui, text: &str, level: usize, font: FontId, color: egui::Color32) -> Response {
    let response = ui.label(RichText::new(text).font(font).color(color));
    ui.accesskit_node_builder(response.id, |node| {
        node.set_role(Role::Heading);
        node.set_level(level);
        node.set_label(text);
    });
    response
}

/// The heading of a card.
pub fn card_heading_ui(ui: &mut Ui, text: &str) -> Response {
    let muted = theme::palette(ui).muted;
    heading_ui(ui, text, 2, theme::strong(theme::CARD_HEADING_SIZE), muted)
}

/// A caption: small and muted.
pub fn caption_ui(ui: &mut Ui, text: impl Into<String>) -> Response {
    let muted = theme::palette(ui).muted;
    ui.label(RichText::new(text).size(theme::SMALL_SIZE).color(muted))
}

/// Makes `response` a polite live region: a screen reader announces it when its text changes.
pub fn announce(ui: &Ui, response: &Response) {
    ui.accesskit_node_builder(response.id, |node| node.set_live(Live::Polite));
}

/// An error or a warning below the field `about`: a live region, and the description of that field.
pub fn note_ui(ui: &mut Ui, severity: Severity, sentence: &str, about: Id) -> Response {
    let color = note_color(ui, severity);
    let said = ui.label(RichText::new(note(sentence)).size(theme::SMALL_SIZE).color(color));
    describe_by_note(ui, &said, severity, about);
    said
}

/// The words of a note that says `sentence`.
pub fn note(sentence: &str) -> String {
    format!("⚠ {sentence}")
}

/// The color of a note.
pub fn note_color(ui: &Ui, severity: Severity) -> egui::Color32 {
    let palette = theme::palette(ui);
    match severity {
        Severity::Error => palette.red,
        Severity::Warning => palette.amber,
    }
}

/// Makes the note `said` a live region and the description of the field `about`.
pub fn describe_by_note(ui: &Ui, said: &Response, severity: Severity, about: Id) {
    announce(ui, said);
    ui.accesskit_node_builder(about, |node| {
        node.set_described_by(vec![said.id.accesskit_id()]);
        if severity == Severity::Error {
            node.set_invalid(Invalid::True);
        }
    });
}

/// A button that looks like a link, for secondary actions.
pub fn link_button_ui(ui: &mut Ui, name: &str, layout: theme::Layout) -> Response {
    let blue = theme::palette(ui).blue;
    let link = egui::Button::new(RichText::new(name).size(theme::SMALL_SIZE).underline().color(blue)).frame(false);
    ui.add(link.min_size(egui::vec2(0.0, layout.inline_control_height())))
}

/// A small rounded label in the color of a method.
pub fn badge_ui(ui: &mut Ui, text: &str, front: egui::Color32, back: egui::Color32) -> Response {
    egui::Frame::new()
        .fill(back)
        .corner_radius(theme::BADGE_RADIUS)
        .inner_margin(theme::BADGE_MARGIN)
        .show(ui, |ui| {
            ui.label(RichText::new(text).font(theme::strong(theme::SMALL_SIZE)).color(front))
        })
        .inner
}

/// The text and background color of a method's badge.
pub const fn badge_colors(palette: &Palette, method: crate::core::problem::Method) -> (egui::Color32, egui::Color32) {
    match method {
        crate::core::problem::Method::Stereo => (palette.blue, palette.blue_tint),
        crate::core::problem::Method::Monocular => (palette.orange_text, palette.orange_tint),
    }
}
