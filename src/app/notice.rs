//! The notice bar: a sentence about what just happened, with what can be done about it.

use super::command::Command;
use super::context::AppContext;
use super::sentences::NoticeText;
use super::widgets::text;
use egui::{Button, Ui, vec2};

/// What the notice bar says.
#[derive(Debug)]
pub struct Notice {
    /// Its text.
    pub text: NoticeText,
    /// The command of its button, such as Undo.
    pub action: Option<Command>,
}

impl Notice {
    /// Draws the contents of the bar.
    pub fn ui(&self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        ui.horizontal_wrapped(|ui| {
            let said = ui.label(self.text.to_string());
            text::announce(ui, &said);
            let button = |name: &str| Button::new(name).min_size(vec2(0.0, cx.layout.control_height()));
            if let Some(action) = &self.action
                && ui.add(button(action.text())).clicked()
            {
                cx.commands.push(action.clone());
            }
            let close = Command::Dismiss;
            if ui.add(button(close.text())).clicked() {
                cx.commands.push(close);
            }
        });
    }
}
