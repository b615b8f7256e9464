//! The keys that the program knows, and the list of them that `?` shows.

use super::about;
use super::command::Command;
use super::context::AppContext;
use super::dialog::{Dialog, DialogFrame, close_button};
use super::theme;
use super::widgets::table::{Cell, row, table};
use super::widgets::text;
use egui::accesskit::Role;
use egui::text::LayoutJob;
use egui::{Event, Key, Modifiers, Ui};

const KEYS: [(&str, &str); 9] = [
    ("Tab, Shift + Tab", "Next field or button, and the one before"),
    ("Enter", "Calculate: marks what is missing and goes there"),
    ("↑ ↓", "Step the field, or the point on the curve"),
    ("Shift + ↑ ↓", "Step ten times as far"),
    ("Ctrl + Z", "Undo (⌘ Z on a Mac)"),
    ("Ctrl + Shift + Z", "Redo"),
    ("Alt + 1, Alt + 2", "Calculator, Learn"),
    ("Esc, then Tab", "Leave the program for the rest of the page"),
    ("?", "This list"),
];

/// The command of a key that was pressed while no text is edited.
pub fn pressed(ctx: &egui::Context) -> Option<Command> {
    use super::saved::Screen;
    let screen = ctx.input_mut(|input| {
        [(Key::Num1, Screen::Calculator), (Key::Num2, Screen::Learn)]
            .into_iter()
            .find_map(|(key, screen)| input.consume_key(Modifiers::ALT, key).then_some(Command::Show(screen)))
    });
    // While a field is edited, undo belongs to its text, and a question mark is text.
    if screen.is_some() || ctx.text_edit_focused() {
        return screen;
    }
    ctx.input_mut(|input| {
        if input.consume_key(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z) || input.consume_key(Modifiers::COMMAND, Key::Y) {
            Some(Command::Redo)
        } else if input.consume_key(Modifiers::COMMAND, Key::Z) {
            Some(Command::Undo)
        } else if input.events.iter().any(|event| matches!(event, Event::Text(text) if text == "?")) {
            Some(Command::ShowDialog(Some(Dialog::Keys)))
        } else {
            None
        }
    })
}

/// The list, over the screen.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let palette = theme::palette(ui);
    let frame = DialogFrame {
        id: "keys",
        title: "Keys",
        max_width: 460.0,
    };
    let response = frame.show(ui, |ui| {
        table(ui, "Keys", |ui| {
            for (keys, what) in KEYS {
                let cell = |text: &str, font, role| Cell {
                    text: LayoutJob::simple(text.to_owned(), font, palette.text, 0.0),
                    role,
                    align_right: false,
                };
                let cells = vec![
                    cell(keys, theme::strong(theme::BODY_SIZE), Role::RowHeader),
                    cell(what, theme::regular(theme::BODY_SIZE), Role::Cell),
                ];
                row(ui, cells, &[1.0, 1.6]);
            }
        });
        ui.add_space(2.0 * theme::STEP);
        ui.horizontal(|ui| {
            let closed = close_button(ui, "Close", cx.layout);
            if text::link_button(ui, about::NAME, cx.layout).clicked() {
                Some(Some(Dialog::About))
            } else {
                closed.then_some(None)
            }
        })
        .inner
    });
    let next = response.inner.or_else(|| response.should_close().then_some(None));
    cx.commands.extend(next.map(Command::ShowDialog));
}
