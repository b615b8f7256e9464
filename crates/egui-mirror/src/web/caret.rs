//! The selection in a field of the browser.

use wasm_bindgen::JsCast as _;
use web_sys::{HtmlElement, HtmlInputElement, HtmlTextAreaElement};

use crate::caret::characters;

/// The selection in a field: where it began and where it ends, in characters.
pub(crate) fn selection(element: &HtmlElement) -> Option<(usize, usize)> {
    let (text, start, end, direction) = if let Some(input) = element.dyn_ref::<HtmlInputElement>() {
        (
            input.value(),
            input.selection_start().ok()??,
            input.selection_end().ok()??,
            input.selection_direction().ok()?,
        )
    } else {
        let area = element.dyn_ref::<HtmlTextAreaElement>()?;
        (
            area.value(),
            area.selection_start().ok()??,
            area.selection_end().ok()??,
            area.selection_direction().ok()?,
        )
    };
    let (start, end) = (characters(&text, start), characters(&text, end));
    Some(if direction.as_deref() == Some("backward") {
        (end, start)
    } else {
        (start, end)
    })
}

/// Takes away the caret of the document, now that something in it has got the focus. Firefox puts one beside what is no field, and tells
/// assistive technology of the field before it whenever something around it changes. A field has a caret of its own; what is selected stays.
pub(crate) fn forget_caret() {
    let selection = web_sys::window().and_then(|window| window.get_selection().ok().flatten());
    if let Some(selection) = selection.filter(|selection| selection.is_collapsed() && selection.range_count() > 0) {
        let _ = selection.remove_all_ranges();
    }
}
