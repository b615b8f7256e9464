//! The entries of a menu.

use crate::app::theme;
use egui::{Button, Ui, vec2};

/// Makes `ui` the inside of a menu.
pub fn style(ui: &mut Ui) {
    ui.set_min_width(theme::MENU_WIDTH);
    ui.spacing_mut().item_spacing.y = 0.0;
}

/// An entry named `name`, which closes the menu. Returns whether it was chosen.
pub fn item_ui(ui: &mut Ui, name: &str, is_enabled: bool) -> bool {
    let size = vec2(ui.available_width(), ui.spacing().interact_size.y.min(theme::CONTROL_HEIGHT_TOUCH));
    let button = Button::new(name).frame_when_inactive(false).min_size(size);
    let is_chosen = ui.add_enabled(is_enabled, button).clicked();
    if is_chosen {
        ui.close();
    }
    is_chosen
}
