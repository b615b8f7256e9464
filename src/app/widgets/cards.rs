//! Cards: a title, a caption at the other end of its line, and contents. Their heights do not depend on what is in them wherever that
//! may change while somebody types.

use super::text;
use crate::app::theme;
use egui::text::LayoutJob;
use egui::{Id, Rect, Ui, UiBuilder, accesskit::Role, vec2};
use std::fmt::Debug;
use std::hash::Hash;

/// A card.
#[derive(Clone, Copy, Debug)]
pub struct Frame<'a> {
    /// Its heading, which is also its accessible name.
    pub title: &'a str,
    /// At the other end of its line, where it fits; may be empty.
    pub caption: &'a str,
    /// How high it is; `None` for as high as its contents.
    pub height: Option<f32>,
}

impl Frame<'_> {
    /// Draws the card over the full width, as a region that assistive technology can jump to. `id` is what the card is, whatever its
    /// title and its place.
    pub fn ui<R>(&self, ui: &mut Ui, id: impl Hash + Debug, add_contents: impl FnOnce(&mut Ui) -> R) -> R {
        let builder = UiBuilder::new()
            .scope_id(Id::unique(("card", id)))
            .accessibility_role(Role::Region)
            .accessibility_label(self.title);
        let card = |ui: &mut Ui| {
            ui.set_width(ui.available_width());
            if let Some(height) = self.height {
                let inside = height - 2.0 * f32::from(theme::CARD_PADDING) - 2.0 * theme::THIN_LINE;
                ui.set_min_height(inside);
                ui.set_max_height(inside);
            }
            ui.spacing_mut().item_spacing = vec2(2.0 * theme::STEP, theme::STEP);
            self.heading_ui(ui);
            add_contents(ui)
        };
        ui.scope_builder(builder, |ui| theme::card(theme::palette(ui)).show(ui, card).inner)
            .inner
    }

    fn heading_ui(&self, ui: &mut Ui) {
        let full = ui.available_width();
        let (line, _) = ui.allocate_exact_size(vec2(full, theme::CARD_HEADING_HEIGHT), egui::Sense::hover());
        let layout = egui::Layout::left_to_right(egui::Align::Center);
        let mut left = ui.new_child(UiBuilder::new().id_salt("title").max_rect(line).layout(layout));
        let heading = text::card_heading_ui(&mut left, self.title);
        if !self.caption.is_empty() {
            let room = line.with_min_x(heading.rect.right() + 2.0 * theme::STEP);
            let layout = egui::Layout::right_to_left(egui::Align::Center);
            let mut right = ui.new_child(UiBuilder::new().id_salt("caption").max_rect(room).layout(layout));
            let muted = theme::palette(ui).muted;
            let job = |size| LayoutJob::simple_singleline(self.caption.to_owned(), theme::regular(size), muted);
            if let Some(caption) = text::fitted(ui, theme::SMALL_SIZE, room.width(), job) {
                right.add(egui::Label::new(caption));
            }
        }
        ui.add_space(theme::BELOW_CARD_HEADING - ui.spacing().item_spacing.y);
    }
}

/// The room for the contents of a card that is `height` high and as wide as `ui` allows.
pub fn figure_height(height: f32) -> f32 {
    height - 2.0 * f32::from(theme::CARD_PADDING) - 2.0 * theme::THIN_LINE - theme::CARD_HEADING_HEIGHT - theme::BELOW_CARD_HEADING
}

/// The size of the contents of a card that is `height` high, as wide as `ui` allows.
pub fn inner_size(ui: &Ui, height: f32) -> egui::Vec2 {
    let width = ui.available_width() - 2.0 * f32::from(theme::CARD_PADDING) - 2.0 * theme::THIN_LINE;
    vec2(width, figure_height(height))
}

/// Cells of equal width side by side, `gap` apart, each drawn by `add_cell` in a `Ui` of its width.
pub fn row_ui<T: Copy + Hash + Debug>(ui: &mut Ui, cells: &[T], gap: f32, mut add_cell: impl FnMut(&mut Ui, T)) {
    let count = f32::from(u16::try_from(cells.len()).unwrap_or(u16::MAX).max(1));
    let width = (ui.available_width() - gap * (count - 1.0)) / count;
    let place = ui.available_rect_before_wrap();
    let mut bottom = place.top();
    let mut left = place.left();
    for &cell in cells {
        let rect = Rect::from_min_size(egui::pos2(left, place.top()), vec2(width, place.height()));
        let builder = UiBuilder::new()
            .id_salt(cell)
            .max_rect(rect)
            .layout(egui::Layout::top_down(egui::Align::Min));
        let mut inside = ui.new_child(builder);
        add_cell(&mut inside, cell);
        bottom = bottom.max(inside.min_rect().bottom());
        left += width + gap;
    }
    let taken = Rect::from_min_max(place.min, egui::pos2(place.right(), bottom));
    ui.advance_cursor_after_rect(taken);
}
