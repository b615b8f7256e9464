//! A bar below a screen, which is read after it.

use egui::{Id, Rect, Ui, UiBuilder};

/// The rest of a `Ui`, divided into a screen and a bar below it. The bar is drawn, read and reached by Tab after the screen; egui's own
/// panels at the bottom come before what they leave room for.
pub struct BottomBar {
    id: Id,
    /// Where the height of the bar is remembered.
    kept: Id,
    /// How high the bar was when it last had these contents.
    height: f32,
    above: Rect,
    below: Rect,
}

impl BottomBar {
    /// Divides what `ui` has left, by how high the bar was when `contents` was last the same: a pass with another height would push what
    /// is scrolled to its end.
    pub fn new(ui: &Ui, id: &str, contents: impl egui::AsIdSalt) -> Self {
        let id = Id::unique(id);
        let kept = id.with(contents);
        let height: f32 = ui.data(|data| data.get_temp(kept)).unwrap_or(0.0);
        let whole = ui.available_rect_before_wrap();
        let (above, below) = whole.split_top_bottom_at_y((whole.bottom() - height).max(whole.top()));
        Self {
            id,
            kept,
            height,
            above,
            below,
        }
    }

    /// Draws the screen.
    pub fn above_ui(&self, ui: &mut Ui, add_contents: impl FnOnce(&mut Ui)) {
        // A scope with an id of its own: else every widget would get another id, and another node for a screen reader, when a bar
        // appears or disappears.
        let place = UiBuilder::new().scope_id(self.id.with("above")).max_rect(self.above);
        ui.scope_builder(place, add_contents);
    }

    /// Draws the bar, after the screen. It is as high as its contents.
    pub fn below_ui(&self, ui: &mut Ui, add_contents: impl FnOnce(&mut Ui)) {
        let place = UiBuilder::new().scope_id(self.id.with("below")).max_rect(self.below);
        let drawn = ui.scope_builder(place, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            add_contents(ui);
        });
        let height = drawn.response.rect.height();
        if height != self.height {
            ui.data_mut(|data| data.insert_temp(self.kept, height));
            ui.ctx().request_discard("the bar at the bottom has another height");
        }
    }
}
