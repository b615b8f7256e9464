//! Columns that scroll on their own and keep in view what has the focus.

use egui::{Id, ScrollArea, Ui};

/// A column that scrolls. When the focus moves to something in it that is out of sight, it is scrolled into view: egui
/// does not do so by itself.
pub fn column(ui: &mut Ui, id: &str, add_contents: impl FnOnce(&mut Ui)) {
    ScrollArea::vertical().id_salt(id).auto_shrink([false, false]).show(ui, |ui| {
        add_contents(ui);
        reveal_focus(ui);
    });
}

fn reveal_focus(ui: &Ui) {
    const ROOM: f32 = 12.0;
    let key = ui.scope_id().with("focused before");
    let focused = ui.memory(|memory| memory.focused());
    let before = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<Option<Id>>(key), focused));
    let Some(response) = focused.filter(|_| focused != before).and_then(|id| ui.ctx().read_response(id)) else {
        return;
    };
    let is_inside = response.layer_id == ui.layer_id() && ui.min_rect().contains(response.rect.center());
    let rect = response.rect.expand(ROOM);
    if is_inside && !(ui.clip_rect().y_range().contains(rect.top()) && ui.clip_rect().y_range().contains(rect.bottom())) {
        ui.scroll_to_rect(rect, None);
    }
}
