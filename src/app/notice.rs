//! The notice bar: a sentence about what just happened, with what can be done about it.

use super::command::Command;
use super::context::AppContext;
use super::sentences::NoticeText;
use super::theme;
use super::widgets::{symbols, text};
use egui::text::TextFormat;
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
            let words = self.text.to_string();
            let palette = theme::palette(ui);
            let format = TextFormat::simple(theme::regular(theme::BODY_SIZE), palette.text);
            let said = ui.label(symbols::job(palette, &words, &format, false));
            symbols::say(ui, &said, &words);
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
