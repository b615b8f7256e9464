//! Which events a pass of egui handles together.
//!
//! egui applies the focus of a pass to all its events, wherever the focus moves in between: what is typed behind a click, in a frame
//! that takes long, would go into the field that the click leaves, or into both. So a pass handles the events up to the first that can
//! move the focus, and the next pass goes on from there. A plugin, and not `raw_input_hook` of eframe: what `egui_mirror` adds to the
//! events has to come through here as well, and the tests have to.

use egui::accesskit::Action;
use egui::{Context, Event, Key, Plugin, RawInput, TouchId, TouchPhase, Ui};
use std::collections::VecDeque;

/// Hands the events to egui in batches. To be added to a context behind all plugins that add events.
#[derive(Debug, Default)]
pub struct Batches {
    /// Events for later passes, in order.
    waiting: VecDeque<Event>,
    /// The fingers on the screen.
    touches: Vec<TouchId>,
}

/// How long a finger rests for a menu, s: as egui has it.
const LONG_PRESS: f64 = 0.8;

impl Batches {
    /// The events for this pass, where `new` have happened since the last one.
    fn next(&mut self, new: Vec<Event>) -> Vec<Event> {
        self.waiting.extend(new);
        let mut batch = Vec::new();
        let mut types = false;
        while let Some(event) = self.waiting.pop_front() {
            let moves_focus = can_move_focus(&event);
            if moves_focus && types {
                // What was typed before is for the widget that has the focus until then.
                self.waiting.push_front(event);
                break;
            }
            types |= is_typed(&event);
            batch.push(event);
            if moves_focus {
                break;
            }
        }
        batch
    }

    /// Whether a finger was on the screen before `events` or with them.
    fn is_touched(&mut self, events: &[Event]) -> bool {
        let mut is_touched = !self.touches.is_empty();
        for event in events {
            if let Event::Touch { id, phase, .. } = event {
                is_touched = true;
                self.touches.retain(|touch| touch != id);
                if matches!(phase, TouchPhase::Start | TouchPhase::Move) {
                    self.touches.push(*id);
                }
            }
        }
        is_touched
    }
}

impl Plugin for Batches {
    fn debug_name(&self) -> &'static str {
        "batches of events"
    }

    fn input_hook(&mut self, ctx: &Context, input: &mut RawInput) {
        input.events = self.next(std::mem::take(&mut input.events));
        // A mouse clicks however long it is held: where frames are slow, its press and its release are seconds apart.
        let longest = if self.is_touched(&input.events) {
            LONG_PRESS
        } else {
            f64::INFINITY
        };
        ctx.options_mut(|options| options.input_options.max_click_duration = longest);
    }

    fn on_begin_pass(&mut self, ui: &mut Ui) {
        if !self.waiting.is_empty() {
            ui.ctx().request_repaint();
        }
    }
}

/// Whether the focus may be on another widget after this event. A press moves it into a text field, a release onto a button; Enter may
/// press one that opens a dialog.
fn can_move_focus(event: &Event) -> bool {
    match event {
        Event::PointerButton { .. } => true,
        Event::Touch { phase, .. } => matches!(phase, TouchPhase::End | TouchPhase::Cancel),
        Event::Key { key, pressed, .. } => *pressed && matches!(key, Key::Tab | Key::Escape | Key::Enter | Key::Space),
        Event::AccessKitActionRequest(request) => matches!(request.action, Action::Focus | Action::Blur | Action::Click),
        _ => false,
    }
}

/// Whether this event is for the widget that has the focus.
fn is_typed(event: &Event) -> bool {
    matches!(
        event,
        Event::Text(_) | Event::Key { pressed: true, .. } | Event::Paste(_) | Event::Copy | Event::Cut | Event::Ime(_)
    )
}

#[cfg(test)]
#[allow(clippy::indexing_slicing, reason = "tests")]
mod tests {
    use super::*;
    use egui::accesskit::{ActionRequest, NodeId, TreeId};
    use egui::{Modifiers, PointerButton, Pos2, TouchDeviceId, TouchId};
    use proptest::prelude::*;

    fn button(pressed: bool) -> Event {
        Event::PointerButton {
            pos: Pos2::ZERO,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        }
    }

    fn key(key: Key, pressed: bool) -> Event {
        Event::Key {
            key,
            physical_key: None,
            pressed,
            repeat: false,
            modifiers: Modifiers::NONE,
        }
    }

    fn text(text: &str) -> Event {
        Event::Text(text.to_owned())
    }

    fn touch(phase: TouchPhase) -> Event {
        Event::Touch {
            device_id: TouchDeviceId(0),
            id: TouchId(0),
            phase,
            pos: Pos2::ZERO,
            force: None,
        }
    }

    fn request(action: Action) -> Event {
        Event::AccessKitActionRequest(ActionRequest {
            action,
            target_tree: TreeId::ROOT,
            target_node: NodeId(1),
            data: None,
        })
    }

    /// All batches of `events`, which come at once.
    fn batches(events: Vec<Event>) -> Vec<Vec<Event>> {
        let mut batches = Batches::default();
        let first = batches.next(events);
        let mut all = vec![first];
        while !batches.waiting.is_empty() {
            all.push(batches.next(Vec::new()));
        }
        all
    }

    #[test]
    fn what_is_typed_behind_a_click_waits_for_it_and_a_click_for_what_is_typed_before() {
        let to = Event::PointerMoved(Pos2::new(3.0, 4.0));
        assert_eq!(
            batches(vec![text("7"), to.clone(), button(true), button(false), text("5"), text("0")]),
            [
                vec![text("7"), to],
                vec![button(true)],
                vec![button(false)],
                vec![text("5"), text("0")]
            ]
        );
    }

    #[test]
    fn keys_that_move_the_focus_and_requests_of_assistive_technology_are_the_last_of_their_batch() {
        for event in [
            key(Key::Tab, true),
            key(Key::Escape, true),
            key(Key::Enter, true),
            touch(TouchPhase::End),
            request(Action::Focus),
            request(Action::Click),
        ] {
            assert_eq!(batches(vec![event.clone(), text("5")]), [vec![event.clone()], vec![text("5")]]);
            assert_eq!(batches(vec![text("5"), event.clone()]), [vec![text("5")], vec![event]]);
        }
        // Whatever goes on in one place is one batch.
        let typing = vec![
            key(Key::ArrowUp, true),
            text("5"),
            key(Key::Tab, false),
            request(Action::SetValue),
            touch(TouchPhase::Move),
        ];
        assert_eq!(batches(typing.clone()), [typing]);
    }

    fn any_event() -> impl Strategy<Value = Event> {
        prop_oneof![
            "[0-9]".prop_map(Event::Text),
            (0.0..9.0_f32).prop_map(|x| Event::PointerMoved(Pos2::new(x, 0.0))),
            any::<bool>().prop_map(button),
            (
                prop::sample::select(vec![Key::Tab, Key::A, Key::Enter, Key::ArrowUp]),
                any::<bool>()
            )
                .prop_map(|(name, down)| key(name, down)),
            prop::sample::select(vec![Action::Focus, Action::SetValue, Action::Click, Action::Increment]).prop_map(request),
            prop::sample::select(vec![TouchPhase::Start, TouchPhase::End]).prop_map(touch),
            Just(Event::PointerGone),
            Just(Event::Copy),
        ]
    }

    proptest! {
        #[test]
        fn nothing_is_lost_or_overtaken_and_the_focus_stays_where_it_is_while_a_batch_is_typed(
            frames in prop::collection::vec(prop::collection::vec(any_event(), 0..12), 1..6),
        ) {
            let mut batches = Batches::default();
            let mut given: Vec<Vec<Event>> = frames.iter().map(|new| batches.next(new.clone())).collect();
            // Each pass takes at least one, so it comes to an end.
            for _ in 0..frames.concat().len() {
                given.push(batches.next(Vec::new()));
            }
            prop_assert!(batches.waiting.is_empty());
            prop_assert_eq!(given.concat(), frames.concat());
            for batch in given {
                if let Some(at) = batch.iter().position(can_move_focus) {
                    prop_assert_eq!(at, batch.len() - 1, "{:?}", batch);
                    prop_assert!(at == 0 || !batch[..at].iter().any(is_typed), "{:?}", batch);
                }
            }
        }
    }
}
