//! What is shown while files are dragged over the window.

use crate::app::theme;
use egui::{Align2, Area, Frame, Id, Order, RichText, Sense, Stroke, Ui};

const WORDS: &str = "Drop calibration files, or saved rigs, to read them";

/// Says over everything else that files can be dropped, while some are over the window.
pub fn hint_ui(ui: &Ui) {
    if ui.input(|input| input.raw.hovered_files.is_empty()) {
        return;
    }
    let palette = theme::palette(ui);
    let all = ui.ctx().content_rect();
    let veil = Area::new(Id::unique("veil under what is dropped"))
        .order(Order::Tooltip)
        .interactable(false);
    veil.fixed_pos(all.min).fade_in(false).show(ui.ctx(), |ui| {
        let (rect, _) = ui.allocate_exact_size(all.size(), Sense::hover());
        ui.painter().rect_filled(rect, 0.0, palette.surface.gamma_multiply(0.7));
        let border = Stroke::new(2.0 * theme::FOCUS_RING_WIDTH, palette.blue);
        ui.painter().rect_stroke(
            rect.shrink(theme::GAP / 2.0),
            theme::CONTROL_RADIUS,
            border,
            egui::StrokeKind::Inside,
        );
    });
    let words = Area::new(Id::unique("what can be dropped"))
        .order(Order::Tooltip)
        .interactable(false);
    words.anchor(Align2::CENTER_CENTER, [0.0, 0.0]).fade_in(false).show(ui.ctx(), |ui| {
        let card = Frame::new()
            .fill(palette.surface)
            .stroke(Stroke::new(theme::THIN_LINE, palette.border));
        card.corner_radius(theme::CONTROL_RADIUS)
            .inner_margin(theme::DROP_MARGIN)
            .show(ui, |ui| {
                ui.label(RichText::new(WORDS).font(theme::strong(theme::BODY_SIZE)).color(palette.text));
            });
    });
}
