//! Headings, captions, notes and badges, with their accessible roles.

use super::symbols;
use crate::app::theme;
use depth_text::note::Severity;
use egui::accesskit::{Invalid, Live, Role};
use egui::text::{LayoutJob, TextFormat};
use egui::{FontId, Galley, Id, Response, RichText, Ui};
use std::sync::Arc;

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
    let color = theme::palette(ui).text;
    heading_ui(ui, text, 2, theme::strong(theme::CARD_HEADING_SIZE), color)
}

/// A caption: small and muted.
pub fn caption_ui(ui: &mut Ui, text: impl Into<String>) -> Response {
    let palette = theme::palette(ui);
    let text = text.into();
    let format = TextFormat::simple(theme::regular(theme::SMALL_SIZE), palette.muted);
    let response = ui.label(symbols::job(palette, &text, &format, false));
    symbols::say(ui, &response, &text);
    response
}

/// A paragraph of small text.
pub fn paragraph_ui(ui: &mut Ui, text: &str) -> Response {
    let muted = theme::palette(ui).muted;
    let format = TextFormat {
        line_height: Some(theme::PARAGRAPH_LINE),
        ..TextFormat::simple(theme::regular(theme::LINK_SIZE), muted)
    };
    let palette = theme::palette(ui);
    // A number stays with what it counts.
    let unbroken = text.replace(" %", "\u{a0}%");
    let response = ui.label(symbols::job(palette, &unbroken, &format, false));
    symbols::say(ui, &response, text);
    response
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

/// A line as large as fits into `width`, up to `size`; `None` where it would be too small to be read.
pub fn fitted(ui: &Ui, size: f32, width: f32, job: impl Fn(f32) -> LayoutJob) -> Option<Arc<Galley>> {
    let whole = ui.painter().layout_job(job(size));
    if whole.size().x <= width {
        return Some(whole);
    }
    let smaller = (size * width / whole.size().x * 2.0).floor() / 2.0;
    (smaller >= theme::SMALLEST_SIZE).then(|| ui.painter().layout_job(job(smaller)))
}

/// A link in the text of the form, with a target `height` high.
pub fn link_ui(ui: &mut Ui, name: &str, height: f32) -> Response {
    link_of_size(ui, name, theme::LINK_SIZE, height)
}

/// A link at the end of a label, quieter than that; `height` is that of the line.
pub fn quiet_link_ui(ui: &mut Ui, name: &str, height: f32) -> Response {
    link_of_size(ui, name, theme::SMALL_SIZE, height)
}

fn link_of_size(ui: &mut Ui, name: &str, size: f32, height: f32) -> Response {
    let blue = theme::palette(ui).blue;
    ui.scope(|ui| {
        ui.spacing_mut().button_padding = egui::Vec2::ZERO;
        ui.spacing_mut().interact_size.y = height;
        let link = egui::Button::new(RichText::new(name).size(size).color(blue)).frame(false);
        let response = ui.add(link.min_size(egui::vec2(0.0, height)));
        if response.hovered() {
            let line = response.rect.center().y + 0.55 * size;
            ui.painter()
                .hline(response.rect.x_range(), line, egui::Stroke::new(theme::THIN_LINE, blue));
        }
        response.on_hover_cursor(egui::CursorIcon::PointingHand)
    })
    .inner
}

/// A button that looks like a link, for secondary actions.
pub fn link_button_ui(ui: &mut Ui, name: &str, layout: theme::Layout) -> Response {
    let blue = theme::palette(ui).blue;
    let link = egui::Button::new(RichText::new(name).size(theme::SMALL_SIZE).underline().color(blue)).frame(false);
    ui.add(link.min_size(egui::vec2(0.0, layout.inline_control_height())))
}

/// A small rounded label.
pub fn badge_ui(ui: &mut Ui, text: &str, front: egui::Color32, back: egui::Color32) -> Response {
    let galley = ui
        .painter()
        .layout_no_wrap(text.to_owned(), theme::strong(theme::SMALL_SIZE), front);
    let size = egui::vec2(galley.size().x + 2.0 * theme::BADGE_PADDING, theme::BADGE_HEIGHT);
    let (rect, response) = ui.allocate_exact_size(size, egui::Sense::hover());
    ui.painter().rect_filled(rect, theme::BADGE_HEIGHT / 2.0, back);
    ui.painter().galley(rect.center() - galley.size() / 2.0, galley, front);
    response.widget_info(|| egui::WidgetInfo::labeled(Role::Label, true, text));
    response
}
