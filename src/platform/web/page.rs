//! What the page shows outside the canvas: the elements of `index.html` by their ids.

use crate::app::PageFailure;
use wasm_bindgen::JsCast as _;

/// The element of the page with this id.
pub(super) fn element(id: &str) -> Option<web_sys::Element> {
    web_sys::window()?.document()?.get_element_by_id(id)
}

/// Whether a media query of CSS holds now.
pub(super) fn matches(query: &str) -> bool {
    let list = web_sys::window().and_then(|window| window.match_media(query).ok().flatten());
    list.is_some_and(|list| list.matches())
}

/// Hides the loading message, and sets the performance mark `first-frame`.
pub(super) fn show_program() {
    if let Some(loading) = element("loading").and_then(|element| element.dyn_into::<web_sys::HtmlElement>().ok()) {
        loading.set_hidden(true);
    }
    if let Some(canvas) = element("app") {
        canvas.remove_attribute("aria-hidden").ok();
    }
    if let Some(performance) = web_sys::window().and_then(|window| window.performance()) {
        // The mark is for measurements only.
        performance.mark("first-frame").ok();
    }
}

/// Covers the page with what happened, what to do about it, and the details for a bug report.
///
/// `assets/web/start.js` draws it, as it does for failures before the program runs and after it has stopped.
pub(super) fn show_failure(failure: PageFailure, detail: &str) {
    let event = web_sys::CustomEventInit::new();
    event.set_detail(
        &[failure.what(), failure.remedy(), detail]
            .map(wasm_bindgen::JsValue::from)
            .into_iter()
            .collect::<js_sys::Array>(),
    );
    // An event on the global object, as anything else may be what has failed.
    let page: web_sys::EventTarget = js_sys::global().unchecked_into();
    if let Ok(event) = web_sys::CustomEvent::new_with_event_init_dict("program-failed", &event) {
        page.dispatch_event(&event).ok();
    }
}

/// Tells the page whether the inputs are saved, for the message when the program has failed.
pub(super) fn note_kept(kept: bool) {
    if let Some(fatal) = element("fatal") {
        fatal.set_attribute("data-kept", if kept { "yes" } else { "no" }).ok();
    }
}
