//! A choice among a few that are all in sight.

use crate::app::theme;
use depth_text::names::Named;
use egui::accesskit::{Role, Toggled};
use egui::{Align, Button, EventFilter, Id, Key, Layout, Modifiers, Rect, Response, RichText, Sense, Stroke, Ui, UiBuilder, Vec2, vec2};

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
    // At the end of the line. As wide whatever is chosen, so that a choice moves nothing.
    let widths: Vec<f32> = all.iter().map(|one| width_of(ui, one.name())).collect();
    let total: f32 = widths.iter().sum();
    let line = Rect::from_center_size(line.center(), vec2(line.width(), height));
    let line = line.with_min_x((line.right() - total + theme::CHOICE_PADDING).max(line.left()));
    let place = UiBuilder::new()
        .id_salt(group)
        .accessibility_role(Role::RadioGroup)
        .accessibility_label(group)
        .max_rect(line.with_max_x(line.right() + theme::CHOICE_PADDING))
        .layout(Layout::left_to_right(Align::Center));
    let mut ui = ui.new_child(place);
    ui.spacing_mut().item_spacing.x = 0.0;
    ui.spacing_mut().button_padding = vec2(theme::CHOICE_PADDING, 0.0);
    ui.spacing_mut().interact_size.y = height;
    // Only what was chosen when it was drawn can get the focus, so it comes a frame after the key.
    let coming = ui.scope_id().with("the focus comes");
    let comes = ui.data_mut(|data| data.remove_temp::<bool>(coming)).is_some();
    let mut focused = None;
    for (place, (&one, width)) in all.iter().zip(widths).enumerate() {
        let is_chosen = before == one;
        let sense = if is_chosen { Sense::click() } else { Sense::CLICK };
        let response = button_ui(&mut ui, one.name(), (is_chosen, sense), vec2(width, height));
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

fn width_of(ui: &Ui, name: &str) -> f32 {
    let font = theme::strong(theme::SMALL_SIZE);
    let galley = ui.painter().layout_no_wrap(name.to_owned(), font, theme::palette(ui).text);
    (galley.size().x + 2.0 * theme::CHOICE_PADDING).ceil()
}

fn button_ui(ui: &mut Ui, name: &str, (is_chosen, sense): (bool, Sense), size: Vec2) -> Response {
    let palette = theme::palette(ui);
    let text = if is_chosen {
        RichText::new(name).font(theme::strong(theme::SMALL_SIZE)).color(palette.text)
    } else {
        RichText::new(name).size(theme::SMALL_SIZE).color(palette.muted)
    };
    let button = Button::new(text).frame_when_inactive(false);
    let response = ui.add(button.min_size(size).sense(sense));
    if is_chosen {
        // Not by its weight alone.
        let under = response.rect.shrink2(vec2(theme::CHOICE_PADDING, 0.0));
        let line = Stroke::new(theme::STRONG_LINE, palette.text);
        ui.painter()
            .hline(under.x_range(), under.center().y + 0.65 * theme::SMALL_SIZE, line);
    }
    response
}

/// How far the arrow keys lead on from the widget `id`, which has the focus.
pub fn steps(ui: &Ui, id: Id) -> isize {
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
