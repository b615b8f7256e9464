//! The blue button: what most people do next.

use super::symbols;
use crate::app::theme;
use egui::text::TextFormat;
use egui::{Button, Stroke, Ui, vec2};

/// Draws it with the text `name`, in which symbols are written as the field has them, as high as the controls of `ui`. Returns whether it
/// was pressed.
pub fn ui(ui: &mut Ui, name: &str, is_enabled: bool) -> bool {
    let height = ui.spacing().interact_size.y;
    let palette = theme::palette(ui);
    let format = TextFormat::simple(theme::strong(theme::BODY_SIZE), palette.on_blue);
    let button = Button::new(symbols::job(palette, name, &format, false))
        .fill(palette.blue)
        .stroke(Stroke::NONE)
        .min_size(vec2(0.0, height));
    ui.add_enabled(is_enabled, button).accessible_name(name).clicked()
}
