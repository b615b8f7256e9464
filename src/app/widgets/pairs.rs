//! Fields side by side.

use crate::app::theme;
use depth_text::field::Key;
use egui::{Align, Layout, Ui, vec2};

/// Draws `keys` with `field_ui`, two side by side where there is room for that.
pub fn ui(ui: &mut Ui, keys: &[Key], mut field_ui: impl FnMut(&mut Ui, Key)) {
    let gap = 2.0 * theme::STEP;
    let columns = if ui.available_width() >= theme::PAIR_WIDTH { 2 } else { 1 };
    let width = if columns == 2 {
        ((ui.available_width() - gap) / 2.0).floor()
    } else {
        ui.available_width()
    };
    for row in keys.chunks(columns) {
        ui.horizontal_top(|ui| {
            ui.spacing_mut().item_spacing.x = gap;
            for &key in row {
                ui.allocate_ui_with_layout(vec2(width, 0.0), Layout::top_down(Align::Min), |ui| {
                    ui.set_width(width);
                    field_ui(ui, key);
                });
            }
        });
        ui.add_space(theme::FIELD_GAP);
    }
}
