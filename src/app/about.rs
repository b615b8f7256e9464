//! What the program is, and under which licenses it and everything in it may be used.

use super::command::Command;
use super::context::AppContext;
use super::dialog::{Dialog, DialogFrame, close_button_ui};
use super::platform::Licenses;
use super::theme;
use super::widgets::text;
use egui::Ui;

/// The dialog, over the screen.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let frame = DialogFrame {
        id: "about",
        title: Command::ShowDialog(Some(Dialog::About)).text(),
        max_width: theme::ABOUT_WIDTH,
    };
    let close = Command::ShowDialog(None);
    let response = frame.ui(ui, |ui| {
        ui.add_space(theme::STEP);
        let paragraphs = [
            &version(cx.platform.commit().as_deref()),
            "You may use, change and share it under the MIT or the Apache 2.0 license, as you like.",
            "Its fonts are Inter (SIL Open Font License 1.1) and DejaVu (a license of its own).",
        ];
        for paragraph in paragraphs {
            let said = ui.label(paragraph);
            // The dialog opens with the focus behind it.
            text::announce(ui, &said);
        }
        match cx.platform.licenses() {
            Licenses::Page(address) => {
                ui.hyperlink_to("Licenses of the fonts and of every library in it", address);
            }
            #[cfg(not(target_arch = "wasm32"))]
            Licenses::Text(licenses) => full_text_ui(ui, licenses),
        }
        ui.add_space(2.0 * theme::STEP);
        close_button_ui(ui, close.text(), cx.layout)
    });
    if response.inner || response.should_close() {
        cx.commands.push(close);
    }
}

/// Version and commit, to name in a bug report.
fn version(commit: Option<&str>) -> String {
    let source = commit.map_or_else(
        || "built from source, commit unknown".to_owned(),
        |commit| format!("commit {commit}"),
    );
    format!("Version {}, {source}.", env!("CARGO_PKG_VERSION"))
}

/// The text of the licenses: thousands of lines, of which only the visible ones are laid out. Nothing in it is focusable, so Page Up,
/// Page Down, Home and End scroll it.
#[cfg(not(target_arch = "wasm32"))]
fn full_text_ui(ui: &mut Ui, licenses: &'static str) {
    use egui::accesskit::Role;
    use egui::{Key, Label, Modifiers, RichText, ScrollArea, TextStyle, UiBuilder, vec2};

    ui.add_space(2.0 * theme::STEP);
    text::heading_ui(
        ui,
        "Licenses of the program, its fonts and every library in it",
        3,
        theme::strong(theme::BODY_SIZE),
        theme::palette(ui).text,
    );
    // Whatever the rest of the dialog leaves.
    let height = (ui.ctx().content_rect().height() - theme::ABOUT_FRAME_HEIGHT).max(theme::LICENSES_MIN_HEIGHT);
    let turned: f32 = [
        (Key::PageDown, -0.9),
        (Key::PageUp, 0.9),
        (Key::End, -f32::MAX),
        (Key::Home, f32::MAX),
    ]
    .into_iter()
    .filter(|(key, _)| ui.input_mut(|input| input.consume_key(Modifiers::NONE, *key)))
    .map(|(_, pages)| (pages * height).clamp(-1e7, 1e7))
    .sum();
    let region = UiBuilder::new().accessibility_role(Role::Region).accessibility_label("Licenses");
    ui.scope_builder(region, |ui| {
        ui.style_mut()
            .text_styles
            .insert(TextStyle::Body, theme::regular(theme::SMALL_SIZE));
        ui.spacing_mut().item_spacing.y = 0.0;
        let line_height = ui.text_style_height(&TextStyle::Body);
        ScrollArea::both().max_height(height).auto_shrink([false, false]).show_rows(
            ui,
            line_height,
            licenses.lines().count(),
            |ui, rows| {
                ui.scroll_with_delta(vec2(0.0, turned));
                for line in licenses.lines().skip(rows.start).take(rows.len()) {
                    ui.add(Label::new(RichText::new(line)).extend());
                }
            },
        );
    });
}

#[cfg(test)]
mod tests {
    use super::version;

    #[test]
    fn the_version_names_the_commit_or_says_that_it_is_unknown() {
        let number = env!("CARGO_PKG_VERSION");
        assert_eq!(version(Some("0123456789ab+")), format!("Version {number}, commit 0123456789ab+."));
        assert_eq!(version(None), format!("Version {number}, built from source, commit unknown."));
    }
}
