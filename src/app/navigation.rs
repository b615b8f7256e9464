//! The bar at the top: the name of the program, a tab for each screen, the list of keys, light or dark.

use super::command::Command;
use super::context::AppContext;
use super::dialog::Dialog;
use super::saved::Screen;
use super::theme::{self, Layout};
use super::widgets::text;
use egui::accesskit::Role;
use egui::containers::menu::MenuButton;
use egui::{Button, RichText, Stroke, ThemePreference, Ui, UiBuilder, vec2};

/// Draws the contents of the bar.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let palette = theme::palette(ui);
    ui.horizontal(|ui| {
        text::heading_ui(ui, "Depth Calculator", 1, theme::strong(theme::TITLE_SIZE), palette.text);
        if cx.layout != Layout::Phone {
            ui.add_space(2.0 * theme::STEP);
            tabs_ui(ui, cx);
        }
        // A right-to-left layout would reverse the order in which Tab and screen readers reach the buttons.
        let side = cx.layout.control_height();
        ui.spacing_mut().button_padding.x = theme::STEP;
        ui.add_space((ui.available_width() - 2.0 * side - ui.spacing().item_spacing.x).max(0.0));
        let keys = Button::new("?").min_size(vec2(side, side));
        let show_keys = Command::ShowDialog(Some(Dialog::Keys));
        if ui.add(keys).accessible_name(show_keys.text()).clicked() {
            cx.commands.push(show_keys);
        }
        theme_choice_ui(ui, cx);
    });
    if cx.layout == Layout::Phone {
        tabs_ui(ui, cx);
    }
}

fn tabs_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let palette = theme::palette(ui);
    let list = UiBuilder::new().accessibility_role(Role::TabList).accessibility_label("Screens");
    ui.scope_builder(list, |ui| {
        ui.horizontal(|ui| {
            for choice in Screen::ALL {
                let command = Command::Show(choice);
                let selected = choice == cx.settings.screen;
                let text = if selected {
                    RichText::new(command.text())
                        .font(theme::strong(theme::BODY_SIZE))
                        .color(palette.text)
                } else {
                    RichText::new(command.text()).color(palette.muted)
                };
                let fill = if selected { palette.highlight } else { palette.surface };
                let tab = ui.add(
                    Button::new(text)
                        .fill(fill)
                        .stroke(Stroke::NONE)
                        .min_size(vec2(0.0, cx.layout.control_height())),
                );
                ui.accesskit_node_builder(tab.id, |node| {
                    node.set_role(Role::Tab);
                    node.set_selected(selected);
                });
                if tab.clicked() {
                    cx.commands.push(command);
                }
            }
        });
    });
}

fn theme_choice_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let height = cx.layout.control_height();
    let button = Button::new(RichText::new("◐").size(theme::ICON_SIZE)).min_size(vec2(height, height));
    let (response, _) = MenuButton::from_button(button).ui(ui, |ui| {
        ui.spacing_mut().interact_size.y = height;
        for choice in [ThemePreference::System, ThemePreference::Light, ThemePreference::Dark] {
            let command = Command::Theme(choice);
            if ui.selectable_label(cx.settings.theme == choice, command.text()).clicked() {
                cx.commands.push(command);
                ui.close();
            }
        }
    });
    let _ = response.accessible_name("Light or dark");
}
