//! A listener that ends when it is dropped.

use wasm_bindgen::{JsCast as _, JsValue, closure::Closure};
use web_sys::{AddEventListenerOptions, Event, EventTarget};

/// Hears of events until it is dropped.
pub(crate) struct Listener {
    target: EventTarget,
    name: &'static str,
    capture: bool,
    /// Not `FnMut`: a copy of an event, sent while that is being heard, is heard as well.
    closure: Closure<dyn Fn(Event)>,
}

impl Listener {
    /// Calls `heard` for every event `name` that reaches `target`, with `capture` before anything inside the target hears of it.
    pub(crate) fn new(target: &EventTarget, name: &'static str, capture: bool, heard: fn(&Event)) -> Result<Self, JsValue> {
        let closure = Closure::new(move |event: Event| heard(&event));
        let options = AddEventListenerOptions::new();
        options.set_capture(capture);
        // For touches and wheels on a window, browsers take that for granted unless told.
        options.set_passive(false);
        target.add_event_listener_with_callback_and_add_event_listener_options(name, closure.as_ref().unchecked_ref(), &options)?;
        Ok(Self {
            target: target.clone(),
            name,
            capture,
            closure,
        })
    }
}

impl Drop for Listener {
    fn drop(&mut self) {
        let function = self.closure.as_ref().unchecked_ref();
        let _ = self
            .target
            .remove_event_listener_with_callback_and_bool(self.name, function, self.capture);
    }
}
