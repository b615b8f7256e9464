//! eframe's hidden text field, which has the browser's focus while text is edited on the canvas.

use wasm_bindgen::JsCast as _;
use web_sys::{HtmlCanvasElement, HtmlElement, HtmlInputElement};

use crate::element::Element;

/// What phones and screen readers are told of it.
const ATTRIBUTES: [&str; 4] = ["aria-label", "inputmode", "role", "aria-hidden"];

/// The hidden text field.
pub(crate) struct Agent {
    element: HtmlElement,
    /// Its attributes, as they were set last.
    said: [Option<String>; 4],
}

impl Agent {
    /// The one that belongs to a canvas. The elements of the mirror are what Tab stops at, not this.
    pub(crate) fn find(canvas: &HtmlCanvasElement) -> Option<Self> {
        let element: HtmlInputElement = canvas.next_element_sibling()?.dyn_into().ok()?;
        element.set_tab_index(-1);
        Some(Self {
            element: element.into(),
            said: [const { None }; 4],
        })
    }

    pub(crate) fn element(&self) -> &HtmlElement {
        &self.element
    }

    /// Says that `field` is edited in it.
    pub(crate) fn describe(&mut self, field: Option<&Element>) {
        let attribute = |name: &str| field.and_then(|field| field.attributes.get(name).cloned());
        let says = [
            field.map(|field| field.name.clone()).filter(|name| !name.is_empty()),
            attribute("inputmode"),
            attribute("role"),
            // Without a field to edit it is a receiver of keys, which has nothing to say.
            field.is_none().then(|| "true".to_owned()),
        ];
        for ((name, value), said) in ATTRIBUTES.iter().zip(&says).zip(&self.said) {
            if value != said {
                let _ = match value {
                    Some(value) => self.element.set_attribute(name, value),
                    None => self.element.remove_attribute(name),
                };
            }
        }
        self.said = says;
    }
}
