//! Scroll areas that keep the focused widget in view.

use crate::app::theme;
use egui::{Id, ScrollArea, Ui};

/// A column that scrolls. The focused widget is scrolled into view when it gets the focus, and when the column becomes lower, as when
/// the keyboard of a phone opens: egui does neither by itself.
pub fn column_ui(ui: &mut Ui, id: &str, add_contents: impl FnOnce(&mut Ui)) {
    // The room for the bar is there whether there is a bar or not: it is between the columns.
    let width = ui.available_width();
    ui.set_max_width(width + theme::SCROLL_GUTTER);
    ScrollArea::vertical().id_salt(id).auto_shrink([false, false]).show(ui, |ui| {
        ui.set_max_width(width);
        ui.add_space(theme::SCREEN_TOP);
        add_contents(ui);
        reveal_focus(ui);
    });
}

/// A scroll area at most `height` points high, and not so low that nothing can be seen in it, which keeps the focused widget in view.
pub fn up_to_ui<R>(ui: &mut Ui, height: f32, add_contents: impl FnOnce(&mut Ui) -> R) -> R {
    let height = height.max(theme::SCROLL_LEAST);
    // A dialog is only as high as what it had to show before, and would grow from frame to frame.
    let area = ScrollArea::vertical().max_height(height).min_scrolled_height(height);
    area.show(ui, |ui| {
        let contents = add_contents(ui);
        reveal_focus(ui);
        contents
    })
    .inner
}

/// The focused widget and the visible height of the column in the last pass.
#[derive(Clone, Copy, Default)]
struct Before {
    focused: Option<Id>,
    height: f32,
    /// The frame in which it last had to be revealed.
    revealed: u64,
}

fn reveal_focus(ui: &Ui) {
    let shown = ui.clip_rect();
    let visible = shown.y_range();
    let (focused, height) = (ui.memory(|memory| memory.focused()), visible.span());
    let key = ui.scope_id().with("before");
    let before: Before = ui.data(|data| data.get_temp(key)).unwrap_or_default();
    let frame = ui.ctx().cumulative_frame_nr();
    let is_new = focused != before.focused || height < before.height;
    // In each pass of that frame: what an earlier one asked for is thrown away with it.
    let revealed = if is_new { frame } else { before.revealed };
    ui.data_mut(|data| data.insert_temp(key, Before { focused, height, revealed }));
    if revealed != frame {
        return;
    }
    let Some(response) = focused.and_then(|id| ui.ctx().read_response(id)) else {
        return;
    };
    // What has scrolled out at the top lies where the navigation is: that is seen, and what has scrolled out is not.
    let seen = response.interact_rect;
    let is_elsewhere = seen.is_positive() && !shown.contains_rect(seen);
    let is_inside = response.layer_id == ui.layer_id() && ui.min_rect().contains(response.rect.center()) && !is_elsewhere;
    let rect = response.rect.expand(theme::FOCUS_SCROLL_MARGIN);
    if is_inside && !(visible.contains(rect.top()) && visible.contains(rect.bottom())) {
        ui.scroll_to_rect(rect, None);
    }
}
