//! Columns that scroll on their own and keep in view what has the focus.

use egui::{Id, ScrollArea, Ui};

/// A column that scrolls. What has the focus is scrolled into view when the focus comes to it, and when the column becomes
/// lower, as it does when the keyboard of a phone opens: egui does neither by itself.
pub fn column(ui: &mut Ui, id: &str, add_contents: impl FnOnce(&mut Ui)) {
    ScrollArea::vertical().id_salt(id).auto_shrink([false, false]).show(ui, |ui| {
        add_contents(ui);
        reveal_focus(ui);
    });
}

/// What scrolls when it would be higher than `height`, and keeps in view what has the focus.
pub fn up_to(ui: &mut Ui, height: f32, add_contents: impl FnOnce(&mut Ui)) {
    ScrollArea::vertical().max_height(height).show(ui, |ui| {
        add_contents(ui);
        reveal_focus(ui);
    });
}

/// What had the focus in the frame before, and what could be seen of the column.
#[derive(Clone, Copy, Default)]
struct Before {
    focused: Option<Id>,
    height: f32,
}

fn reveal_focus(ui: &Ui) {
    const ROOM: f32 = 12.0;
    let visible = ui.clip_rect().y_range();
    let now = Before {
        focused: ui.memory(|memory| memory.focused()),
        height: visible.span(),
    };
    let key = ui.scope_id().with("before");
    let before = ui.data_mut(|data| std::mem::replace(data.get_temp_mut_or_default::<Before>(key), now));
    if now.focused == before.focused && now.height >= before.height {
        return;
    }
    let Some(response) = now.focused.and_then(|id| ui.ctx().read_response(id)) else {
        return;
    };
    let is_inside = response.layer_id == ui.layer_id() && ui.min_rect().contains(response.rect.center());
    let rect = response.rect.expand(ROOM);
    if is_inside && !(visible.contains(rect.top()) && visible.contains(rect.bottom())) {
        ui.scroll_to_rect(rect, None);
    }
}
