//! What has happened in the browser, for the program.

use std::cell::RefCell;
use std::rc::Rc;

use wasm_bindgen::{JsCast as _, JsValue};

use crate::app::Event;

/// The events that the program has not handled yet. Clones share one list, as each listener of the browser has a clone of its own.
#[derive(Clone)]
pub(super) struct Inbox {
    events: Rc<RefCell<Vec<Event>>>,
    ctx: egui::Context,
}

impl Inbox {
    /// An empty inbox, which requests a repaint of `ctx` for each event.
    pub(super) fn new(ctx: &egui::Context) -> Self {
        Self {
            events: Rc::default(),
            ctx: ctx.clone(),
        }
    }

    /// Adds `event` and requests a repaint.
    pub(super) fn add(&self, event: Event) {
        self.events.borrow_mut().push(event);
        self.ctx.request_repaint();
        super::rest::wake();
    }

    /// Takes out all events, in order.
    pub(super) fn take(&self) -> Vec<Event> {
        self.events.take()
    }
}

/// The message of an exception of the browser, with a full stop.
pub(super) fn sentence(error: &JsValue) -> String {
    let mut text = match error.dyn_ref::<js_sys::Error>() {
        Some(error) => String::from(error.message()),
        None => error.as_string().unwrap_or_else(|| format!("{error:?}")),
    };
    if !text.ends_with(['.', '!', '?']) {
        text.push('.');
    }
    text
}
