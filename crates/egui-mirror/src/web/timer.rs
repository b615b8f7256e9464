//! A timeout of the browser that can be started anew.

use std::cell::Cell;

use wasm_bindgen::{JsCast as _, closure::Closure};

/// Calls a function once, some time after it was started last.
pub(crate) struct Timer {
    id: Cell<Option<i32>>,
    closure: Closure<dyn FnMut()>,
}

impl Timer {
    /// A timer that is not running.
    pub(crate) fn new(on_time: fn()) -> Self {
        Self {
            id: Cell::new(None),
            closure: Closure::new(on_time),
        }
    }

    /// Starts it, or starts it anew.
    pub(crate) fn start(&self, milliseconds: i32) {
        self.stop();
        let function = self.closure.as_ref().unchecked_ref();
        let id = web_sys::window().and_then(|window| {
            window
                .set_timeout_with_callback_and_timeout_and_arguments_0(function, milliseconds)
                .ok()
        });
        self.id.set(id);
    }

    /// Stops it, if it runs.
    pub(crate) fn stop(&self) {
        if let (Some(id), Some(window)) = (self.id.take(), web_sys::window()) {
            window.clear_timeout_with_handle(id);
        }
    }
}
