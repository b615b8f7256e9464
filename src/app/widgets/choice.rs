//! A choice among a few that are all in sight.

use crate::app::theme;
use depth_text::names::Named;
use egui::accesskit::{Role, Toggled};
use egui::{Button, RichText, Ui, vec2};

/// Draws the choice of one of `all`, named `group`. Returns whether another one was chosen.
pub fn ui<T: Copy + PartialEq + Named>(ui: &mut Ui, group: &str, all: &[T], chosen: &mut T) -> bool {
    let before = *chosen;
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(theme::STEP, theme::STEP);
        ui.spacing_mut().button_padding.x = theme::CHOICE_PADDING;
        let height = if ui.spacing().interact_size.y >= theme::CONTROL_HEIGHT_TOUCH {
            theme::CONTROL_HEIGHT_TOUCH
        } else {
            theme::CHOICE_HEIGHT
        };
        ui.spacing_mut().interact_size.y = height;
        for &one in all {
            let is_chosen = *chosen == one;
            let button = Button::selectable(is_chosen, RichText::new(one.name()).size(theme::SMALL_SIZE));
            let response = ui.add(button.min_size(vec2(0.0, height)));
            let name = format!("{group}: {}", one.name());
            ui.accesskit_node_builder(response.id, |node| {
                node.set_role(Role::RadioButton);
                node.set_toggled(if is_chosen { Toggled::True } else { Toggled::False });
                node.set_label(name);
            });
            if response.clicked() {
                *chosen = one;
            }
        }
    });
    *chosen != before
}
