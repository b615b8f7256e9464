//! What people and their tools do with the elements of the page, told to egui.

use egui::accesskit::{Action, ActionData, NodeId};
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Element, Event, HtmlInputElement, HtmlTextAreaElement};

use super::announcer::PAUSE_MS;
use super::caret::forget_caret;
use super::dom::Dom;
use super::installed::with;
use super::listener::Listener;
use super::signals::{self, ARRIVED, CARET_MOVED, COMPOSING, FOCUSED, QUIET, TOUCHED, TYPING, act};
use super::{keyboard, pointer};
use crate::element::node_id;
use crate::number::number;
use crate::roles::Kind;

/// Listens to all that can happen to the page.
pub(crate) fn listen(dom: &Dom) -> Result<Vec<Listener>, JsValue> {
    let window = web_sys::window().ok_or("there is no window")?;
    let host = dom.host().element();
    let pointers = pointer::EVENTS.map(|name| Listener::new(&window, name, true, pointer::heard));
    let others = [
        Listener::new(host, "focusin", false, focus_came),
        Listener::new(host, "focusout", false, |_| focus_went()),
        // Not on the host: all in it would count as something to click, and a screen reader would call charts and texts clickable.
        Listener::new(&window, "click", false, clicked),
        Listener::new(host, "scroll", false, |_| scrolled()),
        Listener::new(host, "input", false, typed),
        Listener::new(host, "change", false, typed),
        Listener::new(host, "keydown", false, |event| {
            if let Some(id) = target(event) {
                keyboard::pressed(event, id);
            }
        }),
        // On the window, as a click: else a screen reader would call all in the host clickable.
        Listener::new(&window, "contextmenu", false, keyboard::menu_asked),
        Listener::new(host, "compositionstart", false, |event| COMPOSING.set(target(event))),
        Listener::new(host, "compositionend", false, |event| {
            COMPOSING.set(None);
            typed(event);
        }),
        Listener::new(dom.document(), "selectionchange", false, |_| {
            caret_moved();
            found();
        }),
        // Before eframe's own listener on the canvas, which keeps every Tab from the browser.
        Listener::new(&window, "keydown", true, keyboard::on_its_way),
        Listener::new(&window, "resize", false, |_| {
            let _ = with(|mirror| mirror.dom.lay_over_canvas());
        }),
    ];
    pointers.into_iter().chain(others).collect()
}

/// The node whose element an event happened to.
fn target(event: &Event) -> Option<NodeId> {
    let mut element = event.target()?.dyn_into::<Element>().ok();
    while let Some(now) = element {
        if let Some(id) = node_id(&now.id()) {
            return Some(id);
        }
        element = now.parent_element();
    }
    None
}

fn focus_came(event: &Event) {
    let Some(id) = target(event) else { return };
    signals::focus_is_on(id);
    forget_caret();
    if QUIET.get() {
        return;
    }
    let _ = with(|mirror| {
        let dom = &mirror.dom;
        if dom.coming_focus() != Some(id) {
            act(dom.ctx(), id, Action::Focus, None);
        }
        if dom.is_out_of_sight(id) {
            act(dom.ctx(), id, Action::ScrollIntoView, None);
        }
        dom.ctx().request_repaint();
    });
    caret_moved();
}

fn focus_went() {
    FOCUSED.set(None);
    COMPOSING.set(None);
    TYPING.set(None);
    let _ = with(|mirror| mirror.dom.ctx().request_repaint());
}

/// The browser has scrolled the page to something in it, as to what has got the focus, or to what it found there: that is for egui to do.
fn scrolled() {
    let _ = with(|mirror| {
        let dom = &mirror.dom;
        if dom.host().scrolled() == (0.0, 0.0) {
            return;
        }
        let wanted = ARRIVED.get().or_else(|| dom.selected()).or_else(|| dom.in_the_middle());
        dom.host().scroll_back();
        if let Some(id) = wanted {
            act(dom.ctx(), id, Action::ScrollIntoView, None);
        }
    });
}

/// What a search in the page has found may be selected, and out of sight.
fn found() {
    let _ = with(|mirror| {
        let dom = &mirror.dom;
        if let Some(id) = dom.selected().filter(|id| dom.is_out_of_sight(*id)) {
            act(dom.ctx(), id, Action::ScrollIntoView, None);
        }
    });
}

fn caret_moved() {
    let focused = FOCUSED.get();
    CARET_MOVED.set(focused.is_some());
    let _ = with(|mirror| {
        let element = focused.and_then(|id| mirror.dom.page().get(id));
        if element.is_some_and(|element| element.kind.is_text()) {
            mirror.dom.ctx().request_repaint();
        }
    });
}

fn clicked(event: &Event) {
    let Some(id) = target(event) else { return };
    let _ = with(|mirror| {
        let dom = &mirror.dom;
        let Some(element) = dom.page().get(id).filter(|element| !element.kind.is_text()) else {
            return;
        };
        // A check box must not tick itself, nor a link be followed: that is for egui to do.
        event.prevent_default();
        if mirror.gate.is_click_of_canvas() {
            return;
        }
        if element.allowed.click && !dom.is_done_at_once(id) {
            act(dom.ctx(), id, Action::Click, None);
        }
    });
}

fn typed(event: &Event) {
    let Some(id) = target(event) else { return };
    let Some(now) = event.target().and_then(|target| {
        let input = target.dyn_ref::<HtmlInputElement>().map(HtmlInputElement::value);
        input.or_else(|| target.dyn_ref::<HtmlTextAreaElement>().map(HtmlTextAreaElement::value))
    }) else {
        return;
    };
    let _ = with(|mirror| {
        let dom = &mirror.dom;
        let Some(element) = dom.page().get(id) else { return };
        // A field says "change" once more when it is left: nothing new, unless egui has yet to hear of something else that
        // stood there since.
        let is_settled = TOUCHED.with_borrow(|touched| !touched.contains(&id));
        if is_settled && element.value.as_ref() == Some(&now) && element.kind != Kind::Other {
            return;
        }
        TOUCHED.with_borrow_mut(|touched| touched.push(id));
        TYPING.set(Some(id));
        mirror.pause.start(PAUSE_MS);
        dom.ctx().request_repaint();
        if !element.allowed.set_value {
            return;
        }
        let is_focused = FOCUSED.get() == Some(id);
        let data = match element.kind {
            Kind::Line | Kind::Lines => Some(ActionData::Value(now.into())),
            // egui's number field is a text field while it has the focus, with its own way to read numbers.
            Kind::Stepper if is_focused => Some(ActionData::Value(now.into())),
            Kind::Stepper | Kind::Range => number(&now).map(ActionData::NumericValue),
            Kind::Button | Kind::Check | Kind::Other => None,
        };
        let Some(data) = data else { return };
        if is_focused && dom.coming_focus() != Some(id) {
            act(dom.ctx(), id, Action::Focus, None);
        }
        act(dom.ctx(), id, Action::SetValue, Some(data));
    });
    caret_moved();
}
