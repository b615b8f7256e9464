//! A choice among a few that are all in sight.

use crate::app::theme;
use depth_text::names::Named;
use egui::accesskit::{Role, Toggled};
use egui::{Align, Button, EventFilter, Id, Key, Layout, Modifiers, Rect, RichText, Sense, Ui, UiBuilder, vec2};

/// Draws the choice of one of `all`, named `group`, in `line`: one stop of the key Tab, among them by the arrow keys. Returns whether
/// another one was chosen.
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
    // Only what was chosen when it was drawn can get the focus, so it comes a frame after the key.
    let coming = ui.scope_id().with("the focus comes");
    let comes = ui.data_mut(|data| data.remove_temp::<bool>(coming)).is_some();
    let mut focused = None;
    for (place, &one) in all.iter().enumerate() {
        let is_chosen = before == one;
        let sense = if is_chosen { Sense::click() } else { Sense::CLICK };
        let button = Button::selectable(is_chosen, RichText::new(one.name()).size(theme::SMALL_SIZE));
        let response = ui.add(button.min_size(vec2(0.0, height)).sense(sense));
        let name = format!("{group}: {}", one.name());
        ui.accesskit_node_builder(response.id, |node| {
            node.set_role(Role::RadioButton);
            node.set_toggled(if is_chosen { Toggled::True } else { Toggled::False });
            node.set_label(name);
        });
        if response.clicked() {
            *chosen = one;
        }
        if is_chosen && comes {
            response.request_focus();
        }
        if response.has_focus() {
            focused = Some((place, response.id));
        }
    }
    if let Some((place, id)) = focused
        && let steps = steps(&ui, id)
        && steps != 0
        && let Some(next) = (place + all.len()).checked_add_signed(steps)
        && let Some(&one) = all.get(next % all.len())
    {
        *chosen = one;
        ui.data_mut(|data| data.insert_temp(coming, true));
    }
    *chosen != before
}

/// How far the arrow keys lead on from the widget `id`, which has the focus.
fn steps(ui: &Ui, id: Id) -> isize {
    let arrows = EventFilter {
        horizontal_arrows: true,
        vertical_arrows: true,
        ..Default::default()
    };
    ui.memory_mut(|memory| memory.set_focus_lock_filter(id, arrows));
    ui.input_mut(|input| {
        let mut pressed = |key| input.consume_key(Modifiers::NONE, key);
        let on = pressed(Key::ArrowRight) | pressed(Key::ArrowDown);
        let back = pressed(Key::ArrowLeft) | pressed(Key::ArrowUp);
        isize::from(on) - isize::from(back)
    })
}
