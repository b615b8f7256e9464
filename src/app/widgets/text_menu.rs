//! The menu that a text field opens where it is right-clicked or pressed for long.

use super::menu;
use crate::app::command::Command;
use egui::Response;
use egui::text::{CCursor, CCursorRange};
use egui::text_edit::TextEditState;

/// Shows the menu of the field `response`, whose text is `text`, while it is open.
pub fn ui(response: &Response, text: &mut String, commands: &mut Vec<Command>) {
    let ctx = response.ctx.clone();
    let state = TextEditState::load(&ctx, response.id);
    let selected = state.as_ref().and_then(|state| state.cursor.char_range()).map(|range| {
        let sorted = range.as_sorted_char_range();
        sorted.start.0..sorted.end.0
    });
    let selection = selected.filter(|range| !range.is_empty());
    menu::context_ui(response, |items| {
        let taken = |text: &str| -> String {
            match &selection {
                Some(range) => text.chars().skip(range.start).take(range.len()).collect(),
                None => text.to_owned(),
            }
        };
        let has_text = !text.is_empty();
        if items.item_ui("Cut", has_text) {
            items.ui.copy_text(taken(text));
            *text = match &selection {
                Some(range) => text.chars().take(range.start).chain(text.chars().skip(range.end)).collect(),
                None => String::new(),
            };
            commands.push(Command::Settle);
        }
        if items.item_ui("Copy", has_text) {
            items.ui.copy_text(taken(text));
        }
        if items.item_ui("Paste", true) {
            response.request_focus();
            commands.push(Command::Paste);
        }
        if items.item_ui("Select all", has_text) {
            response.request_focus();
            let mut state = state.clone().unwrap_or_default();
            let all = CCursorRange::two(CCursor::default(), CCursor::new(text.chars().count()));
            state.cursor.set_char_range(Some(all));
            state.store(items.ui.ctx(), response.id);
        }
    });
}
