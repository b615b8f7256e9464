//! The keys that the program knows, and the list of them that `?` shows.

use super::command::{Command, Scope};
use super::context::AppContext;
use super::dialog::{Dialog, DialogFrame, close_button_ui};
use super::saved::Screen;
use super::theme;
use super::widgets::table::{Cell, row_ui, table_ui};
use super::widgets::text;
use egui::accesskit::Role;
use egui::text::LayoutJob;
use egui::{Context, Ui};

/// The command whose keys were pressed.
pub fn pressed(ctx: &Context) -> Option<Command> {
    let scopes: &[Scope] = if ctx.text_edit_focused() {
        &[Scope::Everywhere]
    } else {
        &[Scope::Everywhere, Scope::OutsideText]
    };
    // Redo before Undo: Ctrl + Z also matches while Shift is held.
    let commands = [
        Command::Redo,
        Command::Undo,
        Command::SaveReport,
        Command::OpenFiles,
        Command::ShowDialog(Some(Dialog::Keys)),
    ];
    let mut all = Screen::ALL.map(Command::Show).into_iter().chain(commands);
    ctx.input_mut(|input| all.find(|command| command.take_keys(input, scopes)))
}

/// The keys and what they do. Those without a command belong to egui, or to whatever has the focus.
fn rows() -> Vec<(String, String)> {
    let keys = |keys: &str, what: &str| (keys.to_owned(), what.to_owned());
    let of = |commands: &[Command]| {
        let names: Vec<String> = commands
            .iter()
            .filter_map(|command| Some(command.shortcuts().first()?.name()))
            .collect();
        let what: Vec<&str> = commands.iter().map(Command::explanation).collect();
        (names.join(", "), what.join(", "))
    };
    let mut rows = vec![
        keys("Tab, Shift + Tab", "Next field or button, and the one before"),
        of(&[Command::Calculate]),
        keys("↑ ↓", "Step the field, or the point on the curve"),
        keys("Shift + ↑ ↓", "Step ten times as far"),
        of(&[Command::Undo]),
        of(&[Command::Redo]),
        of(&[Command::SaveReport]),
        of(&[Command::OpenFiles]),
        of(&Screen::ALL.map(Command::Show)),
        keys("Shift + F10", "The menu of what has the focus: of a chart, to save it"),
        keys("Esc", "Close what is open: a list, a menu, a dialog"),
        of(&[Command::ShowDialog(Some(Dialog::Keys))]),
    ];
    // A command may have keys on a desktop only.
    rows.retain(|(keys, _)| !keys.is_empty());
    rows
}

/// The list, over the screen.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let palette = theme::palette(ui);
    let frame = DialogFrame {
        id: "keys",
        title: "Keys",
        max_width: theme::KEYS_WIDTH,
    };
    let about = Command::ShowDialog(Some(Dialog::About));
    let close = Command::ShowDialog(None);
    let response = frame.ui(ui, |ui| {
        let table = table_ui(ui, "What they do", |ui| {
            for (keys, what) in rows() {
                let cell = |text, font, role| Cell {
                    text: LayoutJob::simple(text, font, palette.text, 0.0),
                    role,
                    align_right: false,
                };
                let cells = vec![
                    cell(keys, theme::strong(theme::BODY_SIZE), Role::RowHeader),
                    cell(what, theme::regular(theme::BODY_SIZE), Role::Cell),
                ];
                row_ui(ui, cells, &[1.0, 1.6]);
            }
        });
        // The dialog opens with the focus behind it.
        text::announce(ui, &table);
        ui.add_space(2.0 * theme::STEP);
        ui.horizontal(|ui| {
            let closed = close_button_ui(ui, close.text(), cx.layout);
            if text::link_button_ui(ui, about.text(), cx.layout).clicked() {
                Some(about)
            } else {
                closed.then(|| close.clone())
            }
        })
        .inner
    });
    let next = response.inner.clone().or_else(|| response.should_close().then_some(close));
    cx.commands.extend(next);
}

#[cfg(test)]
mod tests {
    use super::*;
    use egui::{Event, Key, Modifiers, RawInput};

    #[test]
    fn keys_give_their_command_and_redo_is_not_taken_for_undo() {
        let given_by = |event: Event| {
            let mut command = None;
            let input = RawInput {
                events: vec![event],
                ..RawInput::default()
            };
            let mut output = Context::default().run_ui(input, |ui| command = pressed(ui.ctx()));
            output.textures_delta.clear();
            command
        };
        let key = |modifiers, key| Event::Key {
            key,
            physical_key: None,
            pressed: true,
            repeat: false,
            modifiers,
        };
        for (event, command) in [
            (key(Modifiers::COMMAND, Key::Z), Some(Command::Undo)),
            (key(Modifiers::COMMAND | Modifiers::SHIFT, Key::Z), Some(Command::Redo)),
            (key(Modifiers::COMMAND, Key::Y), Some(Command::Redo)),
            (key(Modifiers::COMMAND, Key::P), Some(Command::SaveReport)),
            (key(Modifiers::ALT, Key::Num1), Some(Command::Show(Screen::Calculator))),
            (key(Modifiers::COMMAND, Key::O), Some(Command::OpenFiles)),
            (key(Modifiers::ALT, Key::Num2), Some(Command::Show(Screen::Rigs))),
            (key(Modifiers::ALT, Key::Num3), Some(Command::Show(Screen::Learn))),
            (Event::Text("?".to_owned()), Some(Command::ShowDialog(Some(Dialog::Keys)))),
            (key(Modifiers::NONE, Key::Z), None),
            (key(Modifiers::NONE, Key::Enter), None),
        ] {
            assert_eq!(given_by(event.clone()), command, "{event:?}");
        }
    }

    #[test]
    fn the_list_names_the_keys_of_the_commands() {
        let rows = rows();
        for (keys, what) in [
            ("Enter", "Calculate: marks what is missing and goes there"),
            ("Ctrl + Z", "Undo (⌘ Z on a Mac)"),
            ("Ctrl + Shift + Z", "Redo"),
            ("Ctrl + P", "Save report (HTML)"),
            ("Ctrl + O", "Open calibration files"),
            ("Alt + 1, Alt + 2, Alt + 3", "Calculator, Rigs, Learn"),
            ("?", "This list"),
        ] {
            assert!(rows.contains(&(keys.to_owned(), what.to_owned())), "{keys}: {rows:?}");
        }
    }
}
