//! What charts share: their menu, and the arrow keys.

use super::menu;
use crate::app::command::Command;
use egui::response::Flags;
use egui::{EventFilter, Id, Response, Ui};

/// The menu of the chart `response`, named `title`: to save it as a picture.
pub fn menu_ui(response: &Response, title: &'static str, commands: &mut Vec<Command>) {
    let mut anywhere = response.clone();
    // On a point that can be moved, too, which takes the click for itself.
    if response.contains_pointer() && response.ctx.input(|input| input.pointer.secondary_clicked()) {
        anywhere.flags.insert(Flags::CLICKED);
    }
    menu::context_ui(&anywhere, |items| {
        if items.item_ui("Save as PNG", true) {
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
