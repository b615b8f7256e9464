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
        let words = self.text.to_string();
        let close = Command::Dismiss;
        let buttons: Vec<&Command> = self.action.iter().chain([&close]).collect();
        // What is said wraps beside the buttons, which stand at the right.
        let spacing = ui.spacing().item_spacing.x;
        let padding = 2.0 * ui.spacing().button_padding.x;
        let width_of = |command: &&Command| {
            let font = theme::regular(theme::BODY_SIZE);
            let galley = ui
                .painter()
                .layout_no_wrap(command.text().to_owned(), font, egui::Color32::PLACEHOLDER);
            galley.size().x.ceil() + padding + spacing
        };
        let taken: f32 = buttons.iter().map(width_of).sum();
        let room = ui.available_width() - taken;
        ui.horizontal(|ui| {
            let palette = theme::palette(ui);
            let format = TextFormat::simple(theme::regular(theme::BODY_SIZE), palette.text);
            let mut job = symbols::job(palette, &words, &format, false);
            job.wrap.max_width = room;
            let galley = ui.painter().layout_job(job);
            let free = room - galley.size().x;
            let said = ui.label(galley);
            symbols::say(ui, &said, &words);
            text::announce(ui, &said);
            ui.add_space(free.max(0.0));
            for command in buttons {
                let button = Button::new(command.text()).min_size(vec2(0.0, cx.layout.control_height()));
                if ui.add(button).clicked() {
                    cx.commands.push(command.clone());
                }
            }
        });
    }
}
