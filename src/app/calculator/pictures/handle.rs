//! A point of a picture that can be moved: by the pointer, the arrow keys and assistive technology.

use crate::app::theme;
use crate::app::widgets::chart;
use egui::accesskit::{Action, ActionData, Role};
use egui::{CursorIcon, Id, Key, Modifiers, Pos2, Rect, Response, Sense, Ui, Vec2, WidgetInfo};

/// A point that can be moved.
pub struct Handle {
    /// What egui knows of it.
    pub response: Response,
    /// Where the pointer has it, while it is dragged.
    pub dragged_to: Option<Pos2>,
    /// The value that assistive technology asks for.
    pub set_to: Option<f64>,
    /// How far the arrow keys or assistive technology move it, in steps.
    pub steps: i32,
}

/// What a handle is to assistive technology.
pub struct Slider<'a> {
    /// Its name.
    pub name: &'a str,
    /// Its value.
    pub value: f64,
    /// The values that it can have.
    pub range: [f64; 2],
    /// The value in words.
    pub words: &'a str,
}

/// The handle `id` at `at`, as large as a finger.
pub fn ui(ui: &Ui, id: Id, at: Pos2, slider: &Slider<'_>) -> Handle {
    let target = Rect::from_center_size(at, Vec2::splat(theme::CONTROL_HEIGHT_TOUCH));
    let mut handle = sensed(ui, id, target, Sense::click_and_drag(), slider);
    handle.response = handle.response.on_hover_cursor(CursorIcon::Grab);
    handle
}

/// The cursor `id` at `target`, with which the keyboard and assistive technology read a picture: it takes nothing from the pointer.
pub fn cursor(ui: &Ui, id: Id, target: Rect, slider: &Slider<'_>) -> Handle {
    sensed(ui, id, target, Sense::FOCUSABLE, slider)
}

fn sensed(ui: &Ui, id: Id, target: Rect, sense: Sense, slider: &Slider<'_>) -> Handle {
    let response = ui.interact(target, id, sense);
    response.widget_info(|| WidgetInfo::labeled(Role::Slider, true, slider.name));
    ui.accesskit_node_builder(id, |node| {
        node.set_numeric_value(slider.value);
        let [least, most] = slider.range;
        node.set_min_numeric_value(least);
        node.set_max_numeric_value(most);
        node.set_value(slider.words);
        for action in [Action::SetValue, Action::Increment, Action::Decrement] {
            node.add_action(action);
        }
    });
    // All are read, as reading consumes keys and requests.
    let set_to = asked_for(ui, &response);
    let steps = steps(ui, &response);
    let dragged_to = response.dragged().then(|| response.interact_pointer_pos()).flatten();
    Handle {
        response,
        dragged_to,
        set_to,
        steps,
    }
}

/// The ring around a point that is in use.
pub fn halo(ui: &Ui, at: Pos2) {
    let color = theme::palette(ui).blue;
    ui.painter()
        .circle_stroke(at, theme::HANDLE_HALO, egui::Stroke::new(theme::THIN_LINE, color));
}

impl Handle {
    /// Whether it is being pointed at, dragged or used with the keyboard.
    pub fn is_active(&self) -> bool {
        self.response.hovered() || self.response.dragged() || self.response.has_focus()
    }

    /// Whether a move is complete.
    pub fn is_settled(&self) -> bool {
        self.response.drag_stopped() || self.response.lost_focus()
    }
}

fn asked_for(ui: &Ui, handle: &Response) -> Option<f64> {
    ui.input(|input| {
        let requests = input.accesskit_action_requests(handle.id, Action::SetValue);
        let numbers = requests.filter_map(|request| match request.data {
            Some(ActionData::NumericValue(number)) => Some(number),
            _ => None,
        });
        numbers.last()
    })
}

fn steps(ui: &Ui, handle: &Response) -> i32 {
    let asked = |input: &egui::InputState, action| i32::try_from(input.num_accesskit_action_requests(handle.id, action)).unwrap_or(0);
    let mut steps = ui.input(|input| asked(input, Action::Increment) - asked(input, Action::Decrement));
    if handle.has_focus() {
        chart::lock_arrows(ui, handle.id);
        ui.input_mut(|input| {
            for (key, sign) in [(Key::ArrowRight, 1), (Key::ArrowUp, 1), (Key::ArrowLeft, -1), (Key::ArrowDown, -1)] {
                for (modifiers, size) in [(Modifiers::SHIFT, 10), (Modifiers::NONE, 1)] {
                    steps += sign * size * i32::try_from(input.count_and_consume_key(modifiers, key)).unwrap_or(0);
                }
            }
        });
    }
    steps
}
