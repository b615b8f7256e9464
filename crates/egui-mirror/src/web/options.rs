//! What an application may choose.

use std::rc::Rc;

use egui::Modifiers;
use egui::accesskit::Node;
use web_sys::HtmlElement;

use crate::element::InputMode;

/// What an application may choose.
#[derive(Clone)]
pub struct Options {
    /// The element to build the page in; without one it is made beside the canvas, with the id `accessible-mirror`. It
    /// must have the same offset parent as the canvas, over which it is laid.
    pub host: Option<HtmlElement>,
    /// The value of HTML's `inputmode` for a text field, where its role does not say enough.
    pub input_mode: InputMode,
    /// Is this key (`KeyboardEvent.key`, with its modifiers) a shortcut of the application that egui hears of even while a text
    /// field has the focus? A field keeps all others but Enter, Escape and the function keys to itself. The browser does what it
    /// does with a shortcut as well.
    pub is_shortcut: fn(&str, Modifiers) -> bool,
    /// Called with what is clicked in the mirror, by a key or by assistive technology, while the browser handles the click: for
    /// what it allows only then. egui hears of a click in its next frame, which in Safari is too late for the clipboard. Returns
    /// whether that was all there is to do; if not, egui is told.
    pub clicked: Rc<dyn Fn(&Node) -> bool>,
}

impl Default for Options {
    fn default() -> Self {
        Self {
            host: None,
            input_mode: |_| None,
            is_shortcut: |_, _| false,
            clicked: Rc::new(|_| false),
        }
    }
}
