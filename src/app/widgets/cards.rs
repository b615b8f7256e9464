//! Cards, alone and side by side in rows of equal height.

use super::text::card_heading_ui;
use crate::app::theme;
use egui::{Id, Ui, UiBuilder, accesskit::Role, vec2};
use std::fmt::Debug;
use std::hash::Hash;

/// A card over the full width, with a heading, as a region that assistive technology can jump to. `id` is what the card is, whatever
/// its title and its place.
pub fn card_ui(ui: &mut Ui, id: impl Hash + Debug, title: &str, add_contents: impl FnOnce(&mut Ui)) {
    let builder = UiBuilder::new()
        .id_salt(id)
        .accessibility_role(Role::Region)
        .accessibility_label(title);
    ui.scope_builder(builder, |ui| {
        theme::card(theme::palette(ui)).show(ui, |ui| {
            ui.set_width(ui.available_width());
            card_heading_ui(ui, title);
            ui.add_space(theme::STEP);
            add_contents(ui);
        });
    });
}

/// The cards that stand side by side. Their heights are remembered by what they are.
#[derive(Clone, Copy, Debug)]
pub struct Row(Id);

/// A row of cells of equal width and height. `add_cell` draws one of `cells` in a `Ui` of its width and may use
/// [`fill_height_ui`] at the end of its card to reach the height of its tallest neighbor.
pub fn row_ui<T: Copy + Hash + Debug>(ui: &mut Ui, cells: &[T], gap: f32, mut add_cell: impl FnMut(&mut Ui, T, Row)) {
    let row = Row(Id::unique(("row of cards", cells)));
    let count = f32::from(u16::try_from(cells.len()).unwrap_or(u16::MAX).max(1));
    let width = ((ui.available_width() - gap * (count - 1.0)) / count).floor();
    ui.horizontal_top(|ui| {
        ui.spacing_mut().item_spacing.x = gap;
        for &cell in cells {
            ui.allocate_ui_with_layout(vec2(width, 0.0), egui::Layout::top_down(egui::Align::Min), |ui| {
                ui.spacing_mut().item_spacing = vec2(2.0 * theme::STEP, theme::STEP);
                ui.set_width(width);
                add_cell(ui, cell, row);
            });
        }
    });
}

/// Stretches the content of a card to the tallest content of the cards that share `row`.
///
/// Heights are those of the previous pass; when they change the pass is done again, so nothing jumps.
pub fn fill_height_ui(ui: &mut Ui, row: Row) {
    #[derive(Clone, Copy, Default)]
    struct Tallest {
        pass: u64,
        before: f32,
        now: f32,
    }
    let height = ui.min_rect().height();
    let pass = ui.ctx().cumulative_pass_nr();
    let (tallest, changed) = ui.data_mut(|data| {
        let tallest = data.get_temp_mut_or_default::<Tallest>(row.0);
        if tallest.pass != pass {
            *tallest = Tallest {
                pass,
                before: tallest.now,
                now: 0.0,
            };
        }
        tallest.now = tallest.now.max(height);
        (*tallest, tallest.now > tallest.before + 0.5)
    });
    if changed {
        ui.ctx().request_discard("a card grew");
    }
    let lacking = tallest.before - height;
    if lacking > 0.0 {
        ui.advance_cursor_after_rect(egui::Rect::from_min_size(ui.min_rect().left_bottom(), vec2(0.0, lacking)));
    }
}
