//! Fingers: what the browser may make of them, and what eframe hears.

use wasm_bindgen::JsCast as _;

use super::leaving::run_frame;
use super::listeners::{on, on_its_way};

/// Has eframe hear of fingers as touches alone. From their pointers it would make a mouse besides, of which egui could not tell that it is
/// a finger. To be called behind all who must hear of these pointers, such as the accessible mirror.
pub(super) fn leave_to_touch_events() {
    let Some(window) = web_sys::window() else { return };
    for event in ["pointerdown", "pointerup"] {
        on_its_way(&window, event, |event| {
            let is_finger = |pointer: &web_sys::PointerEvent| pointer.pointer_type() == "touch";
            if event.dyn_ref().is_some_and(is_finger) {
                event.stop_immediate_propagation();
            }
        });
    }
}

/// The passes in which a tap is carried out: the press, the release, and what comes of that.
const PASSES: usize = 3;

/// Carries out what a finger does when it is lifted while the browser still handles that: only then may a page open the keyboard of an
/// iPhone, or use its clipboard. To be called when eframe listens already.
pub(super) fn listen(canvas: web_sys::HtmlCanvasElement) {
    let Some(document) = web_sys::window().and_then(|window| window.document()) else {
        return;
    };
    let page = document.clone();
    on(&document, "touchend", move |event| {
        let target: Option<web_sys::Element> = event.target().and_then(|target| target.dyn_into().ok());
        // What lies around the program, such as the offer of a new version, is not its own.
        if !target.is_some_and(|target| canvas.parent_element().is_some_and(|around| around.contains(Some(&target)))) {
            return;
        }
        // eframe edits text only while the canvas, or the field behind it, has the focus.
        let has_focus = page.active_element().is_some_and(|active| {
            let canvas: &web_sys::Element = &canvas;
            active == *canvas || canvas.next_element_sibling() == Some(active)
        });
        if !has_focus {
            let options = web_sys::FocusOptions::new();
            options.set_prevent_scroll(true);
            canvas.focus_with_options(&options).ok();
        }
        for _ in 0..PASSES {
            run_frame(&canvas);
        }
    });
}

/// Whether the default of the event that the browser is sending right now stays. A finger may still become a part of a pinch, which zooms
/// the page: that is the default of `touchstart` and `touchmove`. No mouse is made of the finger all the same, as the default of
/// `touchend` is prevented. And in the middle of a gesture of its own a browser complains where its default is to be prevented.
pub(super) fn is_left_to_browser() -> bool {
    let window = web_sys::window();
    let event: Option<web_sys::Event> = window.and_then(|window| window.event().dyn_into().ok());
    event.is_some_and(|event| !event.cancelable() || matches!(event.type_().as_str(), "touchstart" | "touchmove"))
}
