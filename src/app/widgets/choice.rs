//! A choice among a few that are all in sight.

use crate::app::theme;
use depth_text::names::Named;
use egui::accesskit::{Role, Toggled};
use egui::{Align, Button, Layout, Rect, RichText, Ui, UiBuilder, vec2};

/// Draws the choice of one of `all`, named `group`, in `line`. Returns whether another one was chosen.
pub fn ui<T: Copy + PartialEq + Named>(ui: &mut Ui, line: Rect, group: &str, all: &[T], chosen: &mut T) -> bool {
    let before = *chosen;
    let is_for_fingers = ui.spacing().interact_size.y >= theme::CONTROL_HEIGHT_TOUCH;
    let height = if is_for_fingers {
        theme::CONTROL_HEIGHT_TOUCH
    } else {
        theme::CHOICE_HEIGHT
    };
    let line = Rect::from_center_size(line.center(), vec2(line.width(), height));
    let place = UiBuilder::new()
        .id_salt(group)
        .accessibility_role(Role::RadioGroup)
        .accessibility_label(group)
        .max_rect(line)
        .layout(Layout::left_to_right(Align::Center));
    let mut ui = ui.new_child(place);
    ui.spacing_mut().item_spacing.x = theme::CHOICE_GAP;
    ui.spacing_mut().button_padding.x = theme::CHOICE_PADDING;
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
    *chosen != before
}
