//! From what fingers do to what egui understands.

use egui::{Context, Event, Id, Modifiers, PointerButton, Pos2, Sense, TextEdit, TouchId, TouchPhase};
use std::collections::VecDeque;

/// So long a finger rests that presses, in seconds.
pub(super) const HOLD: f64 = 0.5;
/// After so many passes egui knows what lies below a finger: in the first it hears that there are fingers, and only then the scroll
/// areas let themselves be dragged.
const PASSES: u8 = 2;

/// Turns what fingers do into what egui understands. To be added to a context before `Batches`.
#[derive(Debug, Default)]
pub struct Touches {
    /// The fingers on the screen, the first that came first. What the first does counts.
    fingers: Vec<TouchId>,
    pub(super) gesture: Gesture,
    /// What fingers have done that cannot be decided before a later pass.
    pub(super) waiting: VecDeque<Event>,
    /// The next pass ends the drag of the scroll area.
    pub(super) lets_go: bool,
    /// A press whose finger does not count any more is to be released, so that nothing is clicked.
    pub(super) releases: Option<Pos2>,
}

/// What the first finger does.
#[derive(Debug, Default, PartialEq)]
pub(super) enum Gesture {
    /// There is none, or more than one, or the system has taken it.
    #[default]
    None,
    /// It came down at `start`, and may mean anything.
    Held { start: Pos2, since: f64, passes: u8 },
    /// It moves the scroll area with this id, once that is found.
    Scrolling { area: Option<Id> },
    /// It is what egui takes it for, now `at`.
    Pressing { at: Pos2 },
}

/// What happens in a pass.
struct Pass<'a> {
    ctx: &'a Context,
    time: f64,
    events: Vec<Event>,
}

impl Touches {
    /// The events for this pass, where `new` have happened since the last.
    pub(super) fn next(&mut self, ctx: &Context, time: f64, new: Vec<Event>) -> Vec<Event> {
        let is_touch = |event: &Event| matches!(event, Event::Touch { .. });
        let by_finger = !self.fingers.is_empty() || !self.waiting.is_empty() || new.iter().any(is_touch);
        let (touches, others): (Vec<_>, Vec<_>) = new.into_iter().partition(is_touch);
        let mut pass = Pass {
            ctx,
            time,
            events: others.into_iter().filter(|event| !(by_finger && is_pointer(event))).collect(),
        };
        if let Some(pos) = self.releases.take() {
            pass.events.push(button(pos, false));
        }
        self.waiting.extend(touches);
        while let Some(event) = self.waiting.pop_front() {
            if !self.take(&event, &mut pass) {
                self.waiting.push_front(event);
                break;
            }
        }
        if let Gesture::Held { start, since, .. } = self.gesture
            && self.waiting.is_empty()
            && time - since >= HOLD
        {
            self.gesture = Gesture::Pressing { at: start };
            pass.events.push(button(start, true));
        }
        pass.events
    }

    /// Handles what a finger does. Returns false where that has to wait for the next pass.
    fn take(&mut self, event: &Event, pass: &mut Pass<'_>) -> bool {
        let Event::Touch { id, phase, pos, .. } = event else {
            return true;
        };
        match phase {
            TouchPhase::Start => {
                self.fingers.push(*id);
                if self.fingers.len() == 1 {
                    self.gesture = Gesture::Held {
                        start: *pos,
                        since: pass.time,
                        passes: 0,
                    };
                    pass.events.extend([event.clone(), Event::PointerMoved(*pos)]);
                } else {
                    self.cancel(pass);
                }
            }
            TouchPhase::Move if self.fingers.first() == Some(id) => return self.moved(event, *pos, pass),
            TouchPhase::Move => {}
            TouchPhase::End | TouchPhase::Cancel => {
                if self.fingers.first() == Some(id) {
                    if *phase == TouchPhase::Cancel {
                        self.cancel(pass);
                    } else if !self.lifted(*pos, pass) {
                        return false;
                    }
                    // By it egui knows the finger.
                    pass.events.push(event.clone());
                }
                self.fingers.retain(|finger| finger != id);
            }
        }
        true
    }

    fn moved(&mut self, event: &Event, pos: Pos2, pass: &mut Pass<'_>) -> bool {
        if let Gesture::Held { start, passes, .. } = self.gesture {
            let way = pos - start;
            // As far as egui lets a click wander.
            if way.length() <= pass.ctx.options(|options| options.input_options.max_click_dist) {
                return true;
            }
            if passes < PASSES {
                return false;
            }
            self.gesture = if way.y.abs() >= way.x.abs() || is_on_idle_field(pass.ctx) {
                Gesture::Scrolling {
                    area: scroll_area_below(pass.ctx),
                }
            } else {
                pass.events.push(button(start, true));
                Gesture::Pressing { at: start }
            };
        }
        match &mut self.gesture {
            Gesture::Pressing { at } => *at = pos,
            Gesture::Scrolling { .. } => {}
            Gesture::None | Gesture::Held { .. } => return true,
        }
        pass.events.extend([Event::PointerMoved(pos), event.clone()]);
        true
    }

    fn lifted(&mut self, pos: Pos2, pass: &mut Pass<'_>) -> bool {
        match self.gesture {
            Gesture::None => return true,
            Gesture::Held { start, .. } => pass.events.extend([button(start, true), button(start, false)]),
            Gesture::Pressing { .. } => pass.events.extend([Event::PointerMoved(pos), button(pos, false)]),
            Gesture::Scrolling { .. } => {
                // A scroll area that is let go does not follow what came just before.
                if pass.events.iter().any(|event| matches!(event, Event::PointerMoved(_))) {
                    return false;
                }
                self.lets_go = true;
            }
        }
        pass.events.push(Event::PointerGone);
        self.gesture = Gesture::None;
        true
    }

    /// Nothing comes of what the finger has begun.
    fn cancel(&mut self, pass: &mut Pass<'_>) {
        match std::mem::take(&mut self.gesture) {
            Gesture::None => return,
            Gesture::Held { .. } => {}
            Gesture::Scrolling { .. } => self.lets_go = true,
            // Only later: a pointer that is gone by then clicks nothing.
            Gesture::Pressing { at } => self.releases = Some(at),
        }
        pass.events.push(Event::PointerGone);
    }
}

/// Whether a platform makes this event of a finger as well, to which a program without fingers listens.
fn is_pointer(event: &Event) -> bool {
    match event {
        Event::PointerMoved(_) | Event::PointerGone => true,
        Event::PointerButton { button, .. } => *button == PointerButton::Primary,
        _ => false,
    }
}

pub(super) fn button(pos: Pos2, pressed: bool) -> Event {
    Event::PointerButton {
        pos,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    }
}

/// The innermost scroll area below the finger: what can be dragged, and neither clicked nor focused.
pub(super) fn scroll_area_below(ctx: &Context) -> Option<Id> {
    ctx.viewport(|viewport| {
        let mut from_above = viewport.hits.contains_pointer.iter().rev();
        from_above.find(|widget| widget.sense == Sense::DRAG).map(|widget| widget.id)
    })
}

/// Whether the finger is on a field that is not being edited.
fn is_on_idle_field(ctx: &Context) -> bool {
    let below: Vec<Id> = ctx.viewport(|viewport| {
        let hits = &viewport.hits;
        hits.contains_pointer.iter().chain(&hits.click).map(|widget| widget.id).collect()
    });
    let is_field = |id: &Id| TextEdit::load_state(ctx, *id).is_some();
    below.iter().any(|id| is_field(id) && !ctx.memory(|memory| memory.has_focus(*id)))
}
