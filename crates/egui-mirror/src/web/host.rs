//! What the page is built in: an element of the size of the canvas, over it.

use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Document, Element, FocusOptions, HtmlCanvasElement, HtmlElement, Node};

/// Over the canvas, where assistive technology looks for what is under a finger; `gate` says who gets the pointer all the
/// same, and what touches mean is for the canvas to say as well. The opacity is not zero, because what has none counts as not
/// displayed to WebDriver; a thousandth is less than half a step of an 8-bit color, so nothing of it reaches the screen.
/// `visibility` and `display` would take the page from the accessibility tree as well, and a page clipped to nothing or moved
/// aside would not say where on the screen its elements are.
const STYLE: &str = "position:absolute;margin:0;padding:0;border:0;overflow:clip;contain:strict;touch-action:none;\
    opacity:0.001;font:16px sans-serif;color:#808080;background:none";

/// The element around the page.
pub(crate) struct Host {
    element: HtmlElement,
    /// What contains the elements of the page.
    content: HtmlElement,
    /// Empty places before and after the content: Tab goes on from there.
    edges: [HtmlElement; 2],
    is_own: bool,
}

impl Host {
    /// Builds in the element `given`, or else in a new one right behind `before`.
    pub(crate) fn new(document: &Document, given: Option<HtmlElement>, before: &Node) -> Result<Self, JsValue> {
        let make = |tag: &str| -> Result<HtmlElement, JsValue> { Ok(document.create_element(tag)?.dyn_into()?) };
        let is_own = given.is_none();
        let element = match given {
            Some(given) => given,
            None => {
                let parent = before.parent_node().ok_or("the canvas is in no document")?;
                let element = make("div")?;
                element.set_id("accessible-mirror");
                parent.insert_before(&element, before.next_sibling().as_ref())?;
                element
            }
        };
        element.style().set_css_text(STYLE);
        let content = make("div")?;
        let edges = [make("span")?, make("span")?];
        for edge in &edges {
            edge.set_tab_index(-1);
        }
        let [first, last] = &edges;
        for part in [first, &content, last] {
            element.append_child(part)?;
        }
        Ok(Self {
            element,
            content,
            edges,
            is_own,
        })
    }

    pub(crate) fn element(&self) -> &HtmlElement {
        &self.element
    }

    pub(crate) fn content(&self) -> &HtmlElement {
        &self.content
    }

    /// Lays it over the area that egui paints.
    pub(crate) fn lay_over(&self, canvas: &HtmlCanvasElement) {
        let padding = |side: &str| {
            let style = web_sys::window().and_then(|window| window.get_computed_style(canvas).ok()?);
            let text = style.and_then(|style| style.get_property_value(side).ok()).unwrap_or_default();
            text.trim_end_matches("px").parse::<f64>().unwrap_or(0.0)
        };
        let (left, right) = (padding("padding-left"), padding("padding-right"));
        let (top, bottom) = (padding("padding-top"), padding("padding-bottom"));
        let sides = [
            ("left", f64::from(canvas.offset_left() + canvas.client_left()) + left),
            ("top", f64::from(canvas.offset_top() + canvas.client_top()) + top),
            ("width", f64::from(canvas.client_width()) - left - right),
            ("height", f64::from(canvas.client_height()) - top - bottom),
        ];
        for (side, pixels) in sides {
            let _ = self.element.style().set_property(side, &format!("{pixels}px"));
        }
    }

    /// Does the element lie, wholly or in part, where it cannot be seen on the canvas?
    pub(crate) fn hides(&self, element: &Element) -> bool {
        let (element, host) = (element.get_bounding_client_rect(), self.element.get_bounding_client_rect());
        element.top() < host.top() || element.bottom() > host.bottom() || element.left() < host.left() || element.right() > host.right()
    }

    /// Focuses the empty place before or after all elements, for the browser to go on from, into the mirror.
    pub(crate) fn focus_edge(&self, after: bool) {
        let [first, last] = &self.edges;
        focus(if after { last } else { first });
    }
}

impl Drop for Host {
    fn drop(&mut self) {
        if self.is_own {
            self.element.remove();
        } else {
            self.element.set_text_content(None);
        }
    }
}

/// Focuses an element where it is, without scrolling to it.
pub(crate) fn focus(element: &HtmlElement) {
    let options = FocusOptions::new();
    options.set_prevent_scroll(true);
    let _ = element.focus_with_options(&options);
}
