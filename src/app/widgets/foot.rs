//! What stands below a screen and is read after it.

use egui::{Id, Rect, Ui, UiBuilder};

/// The rest of a `Ui`, divided: what is at the bottom is drawn, read and reached by Tab after what is above it, as it stands.
/// egui's own panels at the bottom come before what they leave room for.
pub struct Foot {
    id: Id,
    /// How high the foot was last time.
    height: f32,
    above: Rect,
    below: Rect,
}

impl Foot {
    /// Divides what `ui` has left, by how high the foot was last time.
    pub fn of(ui: &Ui, id: &str) -> Self {
        let id = Id::unique(id);
        let height: f32 = ui.data(|data| data.get_temp(id)).unwrap_or(0.0);
        let whole = ui.available_rect_before_wrap();
        let (above, below) = whole.split_top_bottom_at_y((whole.bottom() - height).max(whole.top()));
        Self { id, height, above, below }
    }

    /// Draws what is above.
    pub fn above(&self, ui: &mut Ui, add_contents: impl FnOnce(&mut Ui)) {
        // Ids of their own: else everything would be another thing to egui, and to a screen reader, when a bar comes or goes.
        let place = UiBuilder::new().scope_id(self.id.with("above")).max_rect(self.above);
        ui.scope_builder(place, add_contents);
    }

    /// Draws the foot, afterwards. It is as high as it needs.
    pub fn below(&self, ui: &mut Ui, add_contents: impl FnOnce(&mut Ui)) {
        let place = UiBuilder::new().scope_id(self.id.with("below")).max_rect(self.below);
        let drawn = ui.scope_builder(place, |ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            add_contents(ui);
        });
        let height = drawn.response.rect.height();
        // A window may be lower than that.
        if height != self.height {
            ui.data_mut(|data| data.insert_temp(self.id, height));
            ui.ctx().request_discard("what stands below has another height");
        }
    }
}
