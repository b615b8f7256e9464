//! A choice among a few that are all in sight.

use crate::app::theme::{self, Layout};
use depth_text::names::Named;
use egui::accesskit::{Role, Toggled};
use egui::{Button, RichText, Ui, vec2};

/// Draws the choice of one of `all`, named `group`. Returns whether another one was chosen.
pub fn ui<T: Copy + PartialEq + Named>(ui: &mut Ui, group: &str, all: &[T], chosen: &mut T, layout: Layout) -> bool {
    let before = *chosen;
    ui.spacing_mut().item_spacing.x = theme::STEP;
    for &one in all {
        let is_chosen = *chosen == one;
        let button = Button::selectable(is_chosen, RichText::new(one.name()).size(theme::SMALL_SIZE));
        let response = ui.add(button.min_size(vec2(0.0, layout.heading_control_height())));
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
    *chosen != before
}
