//! What charts share: their menu, and the arrow keys.

use super::menu;
use crate::app::command::Command;
use egui::response::Flags;
use egui::{EventFilter, Id, Key, Modifiers, Popup, Response, Ui};

/// The menu of the chart `response`, named `title`: to save it as a picture.
pub fn menu_ui(response: &Response, title: &'static str, commands: &mut Vec<Command>) {
    let mut anywhere = response.clone();
    // On a point that can be moved, too, which takes the click for itself.
    if response.contains_pointer() && response.ctx.input(|input| input.pointer.secondary_clicked()) {
        anywhere.flags.insert(Flags::CLICKED);
    }
    Popup::context_menu(&anywhere).show(|ui| {
        menu::style(ui);
        if menu::item_ui(ui, "Save as PNG", true) {
            // All of it has to be seen to be a picture.
            response.scroll_to_me(None);
            commands.push(Command::SavePicture(title, response.id));
        }
    });
}

/// Keeps the arrow keys for the widget `id`, which has the focus.
pub fn lock_arrows(ui: &Ui, id: Id) {
    let arrows = EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        ..Default::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, arrows));
}

/// How far the keys `on` and `back` lead. Takes them out of the input.
pub fn take_arrows(ui: &Ui, [on, back]: [Key; 2]) -> isize {
    ui.input_mut(|input| {
        let mut pressed = |key| isize::try_from(input.count_and_consume_key(Modifiers::NONE, key)).unwrap_or(0);
        pressed(on) - pressed(back)
    })
}
