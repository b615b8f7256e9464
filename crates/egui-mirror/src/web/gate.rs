//! Who gets the pointer: the canvas, though the mirror lies over it.
//!
//! When a finger explores the screen with TalkBack or VoiceOver, these ask the browser what is at a point, and Chromium, Firefox
//! and WebKit answer with what a pointer would meet there. So the mirror lies over the canvas, and pointers can meet it. Whoever
//! explores sends the page no pointer. A finger that does, or a mouse that moves, is meant for the canvas: from then on the
//! mirror lets pointers through, until the mouse has left the page, or some time after the finger was lifted. What comes of the
//! first meeting, a finger's press above all, is handed to the canvas.
//!
//! Chromium makes up a whole press, in all like one of a mouse, when assistive technology presses something. But that pointer has
//! not come from anywhere: nothing was said of it being over the element. It is left to be a click.

use std::cell::{Cell, RefCell};

use wasm_bindgen::JsCast as _;
use web_sys::{Element, Event, HtmlElement, PointerEvent};

use super::timer::Timer;

/// So long after the last finger was lifted, the next may explore. Between touches that follow each other the browser decides
/// by itself.
const LIFTED_MS: i32 = 3000;

/// Lets pointers through the mirror while there are any.
pub(crate) struct Gate {
    host: HtmlElement,
    is_open: Cell<bool>,
    /// The element of the mirror that a pointer has come over, and not gone on from since.
    met: RefCell<Option<Element>>,
    /// The pointer whose press was handed to the canvas: all that comes of it is not for the mirror.
    handed_on: Cell<Option<i32>>,
    timer: Timer,
}

/// What is to be done with an event besides.
pub(crate) enum Verdict {
    /// Nothing.
    Leave,
    /// Let the canvas have it.
    HandOn,
    /// Let the canvas have it, and all that comes of this pointer's press.
    HandOnPress(i32),
    /// Let the browser make nothing of it.
    Prevent,
    /// Let nobody on the page but the mirror hear of it.
    Keep,
}

impl Gate {
    /// Lets pointers through `host`. `on_time` must call [`Self::close`].
    pub(crate) fn new(host: &HtmlElement, on_time: fn()) -> Self {
        Self {
            host: host.clone(),
            is_open: Cell::new(false),
            met: RefCell::default(),
            handed_on: Cell::new(None),
            timer: Timer::new(on_time),
        }
    }

    fn set_open(&self, open: bool) {
        self.timer.stop();
        if self.is_open.replace(open) != open {
            let _ = self.host.style().set_property("pointer-events", if open { "none" } else { "auto" });
        }
    }

    /// The mirror meets pointers again.
    pub(crate) fn close(&self) {
        self.set_open(false);
    }

    /// All that comes of this pointer's press, now that the canvas has got it, is not for the mirror.
    pub(crate) fn note_handed_on(&self, pointer: i32) {
        self.handed_on.set(Some(pointer));
    }

    /// Does a click in the mirror come of a press that the canvas has got?
    pub(crate) fn is_click_of_canvas(&self) -> bool {
        self.handed_on.take().is_some()
    }

    /// Decides about an event that happened to `target`, somewhere on the page.
    pub(crate) fn judge(&self, event: &Event, target: &Element) -> Verdict {
        let in_mirror = self.host.contains(Some(target));
        let pointer = event.dyn_ref::<PointerEvent>();
        let id = pointer.map(PointerEvent::pointer_id);
        let is_mouse = pointer.is_some_and(|pointer| pointer.pointer_type() == "mouse");
        let is_finger = pointer.is_some_and(|pointer| pointer.pointer_type() == "touch");
        match event.type_().as_str() {
            "pointerover" => {
                self.met.replace(in_mirror.then(|| target.clone()));
                if in_mirror && !is_mouse {
                    self.set_open(true);
                }
            }
            "pointermove" if in_mirror && is_mouse => self.set_open(true),
            "dragenter" if in_mirror => self.set_open(true),
            // From one element to another is not out of the page.
            "pointerout" if !is_finger && pointer.is_some_and(|pointer| pointer.related_target().is_none()) => self.set_open(false),
            // A script's own, such as a copy of one that was handed on: no pointer is there.
            "pointerdown" if !in_mirror && !event.is_trusted() => (),
            "pointerdown" if !in_mirror => {
                self.timer.stop();
                self.handed_on.set(None);
            }
            "pointerdown" => {
                self.handed_on.set(None);
                if let Some(id) = id.filter(|_| self.met.take().as_ref() == Some(target)) {
                    self.set_open(true);
                    return Verdict::HandOnPress(id);
                }
            }
            "pointerup" | "pointercancel" if in_mirror && self.handed_on.get() != id => return Verdict::Keep,
            "pointerup" | "pointercancel" if !is_mouse => {
                self.timer.start(LIFTED_MS);
                // Of a pen's press a click may come, of a finger's none: see `touchstart`.
                if is_finger {
                    self.handed_on.set(None);
                }
            }
            // Else the keyboard would go to the element.
            "mousedown" if in_mirror && self.handed_on.get().is_some() => return Verdict::Prevent,
            // Whether the browser may make a mouse or a pinch of it is for the canvas to say.
            "touchstart" if in_mirror && self.handed_on.get().is_some() => return Verdict::HandOn,
            // eframe hears of a move and an end wherever they happen, of this on the canvas alone.
            "touchcancel" if in_mirror => return Verdict::HandOn,
            "click" if !in_mirror => self.handed_on.set(None),
            "wheel" if in_mirror => {
                self.set_open(true);
                return Verdict::HandOn;
            }
            _ => (),
        }
        Verdict::Leave
    }
}
