//! The menu key: Shift + F10 opens the menu of what has the focus, as a click of the right button in its middle would.

use egui::{Context, Event, Id, Key, Modifiers, Plugin, PointerButton, RawInput};

/// To be added to a context behind `Batches`: what has the focus is then what has it when the keys are heard. In a browser `egui_mirror`
/// presses these keys for the key of menus, too.
#[derive(Debug)]
pub struct MenuKey;

/// What had the focus when a menu was last opened with keys; none where it was the pointer.
pub fn opened_from(ctx: &Context) -> Option<Id> {
    ctx.data(|data| data.get_temp(key()))
}

fn key() -> Id {
    Id::unique("opened by the menu key from")
}

fn is_pressed(event: &Event) -> bool {
    matches!(event, Event::Key { key: Key::F10, pressed: true, modifiers, .. } if modifiers.matches_exact(Modifiers::SHIFT))
}

/// Whether the pointer may open a menu with it.
fn may_open(event: &Event) -> bool {
    matches!(
        event,
        Event::Touch { .. }
            | Event::PointerButton {
                button: PointerButton::Secondary,
                ..
            }
    )
}

impl Plugin for MenuKey {
    fn debug_name(&self) -> &'static str {
        "menu key"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        if input.events.iter().any(may_open) {
            ctx.data_mut(|data| data.remove::<Id>(key()));
        }
        let Some(at) = input.events.iter().position(is_pressed) else {
            return;
        };
        let Some(focused) = ctx.memory(|memory| memory.focused()) else {
            return;
        };
        let Some(pos) = ctx.read_response(focused).map(|response| response.rect.center()) else {
            return;
        };
        ctx.data_mut(|data| data.insert_temp(key(), focused));
        let click = [true, false].map(|pressed| Event::PointerButton {
            pos,
            button: PointerButton::Secondary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        let clicked = [Event::PointerMoved(pos)].into_iter().chain(click);
        input.events.splice(at..=at, clicked).for_each(drop);
    }
}
