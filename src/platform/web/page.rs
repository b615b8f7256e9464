//! What the page shows outside the canvas: the elements of `index.html` by their ids.

use wasm_bindgen::JsCast as _;

use super::browser::STORAGE_KEY;

/// The element of the page with this id.
pub(super) fn element(id: &str) -> Option<web_sys::Element> {
    web_sys::window()?.document()?.get_element_by_id(id)
}

/// Uncovers the canvas, and marks the moment as `first-frame` for whoever measures the start.
pub(super) fn show_program() {
    set_hidden("loading", true);
    if let Some(performance) = web_sys::window().and_then(|window| window.performance()) {
        // A missing measurement disturbs nobody.
        performance.mark("first-frame").ok();
    }
}

/// Covers everything with what happened, what to do about it, and the details for a bug report.
///
/// The first failure stays: later ones are its consequences.
pub(super) fn show_failure(what: &str, todo: &str, detail: &str) {
    let shown = element("fatal").is_some_and(|fatal| !fatal.has_attribute("hidden"));
    if shown {
        return;
    }
    set_text("fatal-what", what);
    set_text("fatal-todo", todo);
    set_text("fatal-detail", detail);
    set_hidden("fatal-more", detail.is_empty());
    offer_empty_form();
    set_hidden("loading", true);
    set_hidden("fatal", false);
}

/// Where the program has not run long, what it read at the start may be why it failed, and would be again.
fn offer_empty_form() {
    const LONG_MS: f64 = 10_000.0;
    let performance = web_sys::window().and_then(|window| window.performance());
    let ran_long = performance.is_some_and(|performance| performance.now() > LONG_MS);
    if let Some(button) = element("afresh").filter(|_| !ran_long) {
        // assets/web/start.js puts aside what is stored there.
        button.set_attribute("data-key", STORAGE_KEY).ok();
        set_hidden("afresh", false);
    }
}

fn set_text(id: &str, text: &str) {
    if let Some(element) = element(id) {
        element.set_text_content(Some(text));
    }
}

fn set_hidden(id: &str, hidden: bool) {
    let element = element(id).and_then(|element| element.dyn_into::<web_sys::HtmlElement>().ok());
    if let Some(element) = element {
        element.set_hidden(hidden);
    }
}
