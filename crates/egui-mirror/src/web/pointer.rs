//! What pointers do on the page: `gate` decides, this carries it out.

use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Element, Event, EventTarget};

use super::gate::Verdict;
use super::installed::with;

/// What is listened to, before anybody else hears of it.
pub(crate) const EVENTS: [&str; 12] = [
    "pointerover",
    "pointermove",
    "pointerdown",
    "pointerup",
    "pointercancel",
    "pointerout",
    "mousedown",
    "touchstart",
    "touchcancel",
    "click",
    "wheel",
    "dragenter",
];

/// A pointer, or what a browser makes of one, is somewhere on the page.
pub(crate) fn heard(event: &Event) {
    let Some(target) = event.target().and_then(|target| target.dyn_into::<Element>().ok()) else {
        return;
    };
    let judged = with(|mirror| (mirror.gate.judge(event, &target), mirror.dom.canvas().clone()));
    // Not while the page is lent: the canvas may answer with a frame, which changes it.
    let Some((verdict, canvas)) = judged else { return };
    match verdict {
        Verdict::Leave => (),
        Verdict::HandOn => {
            let _ = hand_on(event, &canvas);
        }
        Verdict::HandOnPress(id) => {
            let _ = hand_on(event, &canvas);
            // Not before: the copy is another press, on the canvas.
            let _ = with(|mirror| mirror.gate.note_handed_on(id));
        }
        Verdict::Prevent => event.prevent_default(),
        Verdict::Keep => event.stop_propagation(),
    }
}

/// Has `target` hear of an event that happened elsewhere. A browser does not send one twice: this is a copy.
fn hand_on(event: &Event, target: &EventTarget) -> Result<(), JsValue> {
    let constructor: js_sys::Function = js_sys::Reflect::get(event, &"constructor".into())?.dyn_into()?;
    let copy = js_sys::Reflect::construct(&constructor, &js_sys::Array::of2(&event.type_().into(), event))?;
    if !target.dispatch_event(copy.unchecked_ref())? {
        event.prevent_default();
    }
    Ok(())
}
