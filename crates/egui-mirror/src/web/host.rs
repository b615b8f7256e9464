//! What the page is built in: an element of the size of the canvas, over it.

use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Document, Element, FocusOptions, HtmlCanvasElement, HtmlElement, Node};

/// The size of its text, in CSS pixels, where nothing is known of the painted one.
pub(crate) const FONT_SIZE: f64 = 16.0;

/// Over the canvas, where assistive technology looks for what is under a finger; `gate` says who gets the pointer all the
/// same, and what one finger means is for the canvas to say as well; two zoom the page, where the canvas lets them. Its text has no
/// color, so that nothing is seen of it but what the browser marks, as when it searches in the page. It has an opacity, because what has
/// none counts as not displayed to WebDriver. `visibility` and `display` would take the page from the accessibility tree as well, and a
/// page clipped to nothing or moved aside would not say where on the screen its elements are. Colors that a person has chosen for
/// everything are not for what is not seen. A caret that cannot be seen does not blink either, which has the browser draw the page.
const STYLE: &str = "position:absolute;margin:0;padding:0;border:0;overflow:hidden;contain:strict;touch-action:pinch-zoom;\
    font:16px sans-serif;color:#808080;-webkit-text-fill-color:transparent;caret-color:transparent;\
    caret-animation:manual;background:none;\
    forced-color-adjust:none";

/// So far from the edges of what can be scrolled lies the page: a browser that searches in it scrolls to what it finds, wherever that is,
/// and the host has egui scroll there instead.
const MARGIN: f64 = 30_000.0;

/// The element around the page.
pub(crate) struct Host {
    element: HtmlElement,
    /// What contains the elements of the page.
    content: HtmlElement,
    /// What contains their descriptions.
    abouts: HtmlElement,
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
        let place = format!("position:absolute;left:{MARGIN}px;top:{MARGIN}px;width:{MARGIN}px;height:{MARGIN}px");
        content.style().set_css_text(&place);
        let abouts = make("div")?;
        abouts.set_hidden(true);
        let edges = [make("span")?, make("span")?];
        for edge in &edges {
            edge.set_tab_index(-1);
        }
        let [first, last] = &edges;
        for part in [first, &content, last] {
            element.append_child(part)?;
        }
        // Beside the page, as nobody reads them there.
        let parent = element.parent_node().ok_or("the element of the mirror is in no document")?;
        parent.insert_before(&abouts, element.next_sibling().as_ref())?;
        Ok(Self {
            element,
            content,
            abouts,
            edges,
            is_own,
        })
    }

    pub(crate) fn element(&self) -> &HtmlElement {
        &self.element
    }

    pub(crate) fn abouts(&self) -> &HtmlElement {
        &self.abouts
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
        self.scroll_back();
    }

    /// How far the browser has scrolled the page away from the canvas, right and down.
    pub(crate) fn scrolled(&self) -> (f64, f64) {
        let (left, top) = (f64::from(self.element.scroll_left()), f64::from(self.element.scroll_top()));
        (left - MARGIN, top - MARGIN)
    }

    /// Lays the page over the canvas again.
    pub(crate) fn scroll_back(&self) {
        if self.scrolled() != (0.0, 0.0) {
            self.element.scroll_to_with_x_and_y(MARGIN, MARGIN);
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
        self.abouts.remove();
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
