//! What people and their tools do with the page, told to egui.

use std::cell::{Cell, RefCell};

use egui::accesskit::{Action, ActionData, ActionRequest, NodeId, TreeId};
use wasm_bindgen::{JsCast as _, JsValue, closure::Closure};
use web_sys::{AddEventListenerOptions, Element, Event, EventTarget, HtmlInputElement, HtmlTextAreaElement, KeyboardEvent};

use crate::dom::Dom;
use crate::keys::{self, Direction, Route};
use crate::model::{self, node_id};
use crate::plugin::with;
use crate::pointer;
use crate::roles::Kind;

thread_local! {
    pub(crate) static SIGNALS: Signals = Signals::default();
}

/// What the listeners leave for the next frame. They may be called in the middle of a change to the page, so this
/// is apart from it.
#[derive(Default)]
pub(crate) struct Signals {
    /// For egui's next frame.
    pub(crate) queue: RefCell<Vec<egui::Event>>,
    /// The element of the mirror that has the browser's focus.
    pub(crate) focused: Cell<Option<NodeId>>,
    /// The elements that had it, the latest last.
    pub(crate) visited: RefCell<Vec<NodeId>>,
    /// The focus is being moved because egui moved its own.
    pub(crate) quiet: Cell<bool>,
    /// Escape was pressed: the next Tab goes to what follows the application.
    pub(crate) leaving: Cell<bool>,
    /// The field in which an input method is composing text.
    pub(crate) composing: Cell<Option<NodeId>>,
    /// Fields that were typed into since the last frame.
    pub(crate) touched: RefCell<Vec<NodeId>>,
    /// The caret of the focused field may have moved.
    pub(crate) caret_moved: Cell<bool>,
}

/// How many elements are remembered to go back to.
const MEMORY: usize = 16;

/// Asks egui to do something with a node in its next frame.
pub(crate) fn act(ctx: &egui::Context, id: NodeId, action: Action, data: Option<ActionData>) {
    let request = ActionRequest {
        action,
        target_tree: TreeId::ROOT,
        target_node: id,
        data,
    };
    SIGNALS.with(|signals| signals.queue.borrow_mut().push(egui::Event::AccessKitActionRequest(request)));
    ctx.request_repaint();
}

/// A listener that ends when it is dropped.
pub(crate) struct Listener {
    target: EventTarget,
    name: &'static str,
    capture: bool,
    /// Not `FnMut`: a copy of an event, sent while that is being heard, is heard as well.
    closure: Closure<dyn Fn(Event)>,
}

impl Listener {
    fn new(target: &EventTarget, name: &'static str, capture: bool, heard: fn(&Event)) -> Result<Self, JsValue> {
        let closure = Closure::new(move |event: Event| heard(&event));
        let options = AddEventListenerOptions::new();
        options.set_capture(capture);
        // For touches and wheels on a window, browsers take that for granted unless told.
        options.set_passive(false);
        target.add_event_listener_with_callback_and_add_event_listener_options(name, closure.as_ref().unchecked_ref(), &options)?;
        Ok(Self {
            target: target.clone(),
            name,
            capture,
            closure,
        })
    }
}

impl Drop for Listener {
    fn drop(&mut self) {
        let function = self.closure.as_ref().unchecked_ref();
        let _ = self
            .target
            .remove_event_listener_with_callback_and_bool(self.name, function, self.capture);
    }
}

/// Listens to all that can happen to the page.
pub(crate) fn listen(dom: &Dom) -> Result<Vec<Listener>, JsValue> {
    let window = web_sys::window().ok_or("there is no window")?;
    let host = dom.host();
    let pointers = pointer::EVENTS.map(|name| Listener::new(&window, name, true, pointer::heard));
    let others = [
        Listener::new(host, "focusin", false, focus_came),
        Listener::new(host, "focusout", false, |_| focus_went()),
        Listener::new(host, "click", false, clicked),
        Listener::new(host, "input", false, typed),
        Listener::new(host, "change", false, typed),
        Listener::new(host, "keydown", false, key_pressed),
        Listener::new(host, "compositionstart", false, |event| {
            SIGNALS.with(|signals| signals.composing.set(target(event)));
        }),
        Listener::new(host, "compositionend", false, |event| {
            SIGNALS.with(|signals| signals.composing.set(None));
            typed(event);
        }),
        Listener::new(dom.document(), "selectionchange", false, |_| caret_moved()),
        // Before eframe's own listener on the canvas, which keeps every Tab from the browser.
        Listener::new(&window, "keydown", true, key_on_its_way),
        Listener::new(&window, "pointerdown", true, |_| SIGNALS.with(|signals| signals.leaving.set(false))),
        Listener::new(&window, "resize", false, |_| {
            let _ = with(Dom::lay_over_canvas);
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
    let quiet = SIGNALS.with(|signals| {
        signals.focused.set(Some(id));
        let mut visited = signals.visited.borrow_mut();
        visited.retain(|other| *other != id);
        visited.push(id);
        if visited.len() > MEMORY {
            visited.remove(0);
        }
        signals.quiet.get()
    });
    if quiet {
        return;
    }
    let _ = with(|dom| {
        if dom.page().focus != Some(id) {
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
    SIGNALS.with(|signals| {
        signals.focused.set(None);
        signals.composing.set(None);
    });
    let _ = with(|dom| dom.ctx().request_repaint());
}

fn caret_moved() {
    let is_editing = SIGNALS.with(|signals| {
        let focused = signals.focused.get();
        signals.caret_moved.set(focused.is_some());
        focused
    });
    let _ = with(|dom| {
        if is_editing
            .and_then(|id| dom.page().get(id))
            .is_some_and(|element| element.kind.is_text())
        {
            dom.ctx().request_repaint();
        }
    });
}

fn clicked(event: &Event) {
    let Some(id) = target(event) else { return };
    let _ = with(|dom| {
        let Some(element) = dom.page().get(id).filter(|element| !element.kind.is_text()) else {
            return;
        };
        // A box must not tick itself, nor a link be followed: that is for egui to do.
        event.prevent_default();
        if dom.gate().is_click_of_canvas() {
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
    let _ = with(|dom| {
        let Some(element) = dom.page().get(id) else { return };
        // A field says "change" once more when it is left: nothing new, unless egui has yet to hear of something else that
        // stood there since.
        let is_settled = SIGNALS.with(|signals| !signals.touched.borrow().contains(&id));
        if is_settled && element.value.as_ref() == Some(&now) && element.kind != Kind::Other {
            return;
        }
        SIGNALS.with(|signals| signals.touched.borrow_mut().push(id));
        dom.ctx().request_repaint();
        if !element.allowed.set_value {
            return;
        }
        let is_focused = SIGNALS.with(|signals| signals.focused.get()) == Some(id);
        let data = match element.kind {
            Kind::Line | Kind::Lines => Some(ActionData::Value(now.into())),
            // egui's number field is a text field while it has the focus, with its own way to read numbers.
            Kind::Stepper if is_focused => Some(ActionData::Value(now.into())),
            Kind::Stepper | Kind::Range => model::number(&now).map(ActionData::NumericValue),
            Kind::Button | Kind::Check | Kind::Other => None,
        };
        let Some(data) = data else { return };
        if is_focused && dom.page().focus != Some(id) {
            act(dom.ctx(), id, Action::Focus, None);
        }
        act(dom.ctx(), id, Action::SetValue, Some(data));
    });
    caret_moved();
}

fn key_pressed(event: &Event) {
    let Some(event) = event.dyn_ref::<KeyboardEvent>().filter(|event| !event.is_composing()) else {
        return;
    };
    let Some(id) = target(event) else { return };
    let modifiers = modifiers(event);
    // On Windows, Alt and the number pad write characters by their code.
    if modifiers.alt && event.code().starts_with("Numpad") {
        return;
    }
    let _ = with(|dom| {
        let Some(element) = dom.page().get(id) else { return };
        match keys::route(element.kind, &event.key(), modifiers) {
            Route::Browser => (),
            Route::Egui { only } => {
                if only {
                    event.prevent_default();
                }
                // egui let go of its focus on Escape or Enter, but the person is still here.
                if dom.page().focus != Some(id) && event.key() != "Escape" {
                    act(dom.ctx(), id, Action::Focus, None);
                }
                press(dom.ctx(), event, modifiers, element.kind);
            }
            Route::Step(direction) if element.allowed.step => {
                event.prevent_default();
                let action = match direction {
                    Direction::Up => Action::Increment,
                    Direction::Down => Action::Decrement,
                };
                act(dom.ctx(), id, action, None);
            }
            Route::Click if element.allowed.click => {
                event.prevent_default();
                act(dom.ctx(), id, Action::Click, None);
            }
            Route::Step(_) | Route::Click => press(dom.ctx(), event, modifiers, element.kind),
        }
    });
}

/// Presses and releases a key in egui. The release is not waited for: it may happen on another element.
fn press(ctx: &egui::Context, event: &KeyboardEvent, modifiers: egui::Modifiers, kind: Kind) {
    let physical_key = egui::Key::from_name(event.code().trim_start_matches("Key").trim_start_matches("Digit"));
    let name = event.key();
    // A key may be a command by what it writes ("?"), wherever it is on the keyboard. A field has its text otherwise.
    let is_text = name.chars().count() == 1 && !kind.is_text() && !modifiers.command && !modifiers.alt;
    if is_text {
        let text = egui::Event::Text(name.clone());
        SIGNALS.with(|signals| signals.queue.borrow_mut().push(text));
        ctx.request_repaint();
    }
    let Some(key) = egui::Key::from_name(&name)
        .or_else(|| egui::Key::from_name(&name.to_uppercase()))
        .or(physical_key)
    else {
        return;
    };
    let stroke = |pressed| egui::Event::Key {
        key,
        physical_key,
        pressed,
        repeat: false,
        modifiers,
    };
    SIGNALS.with(|signals| {
        let mut queue = signals.queue.borrow_mut();
        if modifiers.any() {
            queue.push(egui::Event::ModifiersChanged(modifiers));
        }
        queue.extend([stroke(true), stroke(false)]);
        if modifiers.any() {
            queue.push(egui::Event::ModifiersChanged(egui::Modifiers::NONE));
        }
    });
    ctx.request_repaint();
}

fn modifiers(event: &KeyboardEvent) -> egui::Modifiers {
    egui::Modifiers {
        alt: event.alt_key(),
        ctrl: event.ctrl_key(),
        shift: event.shift_key(),
        mac_cmd: event.meta_key(),
        command: event.ctrl_key() || event.meta_key(),
    }
}

/// Tab, Escape and the keys of the browser, before anybody else hears of them.
fn key_on_its_way(event: &Event) {
    let Some(event) = event.dyn_ref::<KeyboardEvent>().filter(|event| !event.is_composing()) else {
        return;
    };
    let Some(place) = event.target().and_then(|target| target.dyn_into::<Element>().ok()) else {
        return;
    };
    let key = event.key();
    let _ = with(|dom| {
        let on_canvas = dom.is_canvas(&place);
        if !on_canvas && !dom.host().contains(Some(&place)) {
            return;
        }
        let leaving = SIGNALS.with(|signals| signals.leaving.get());
        let is_mac = dom.ctx().os() == egui::os::OperatingSystem::Mac;
        if on_canvas && keys::is_browsers(&key, modifiers(event), is_mac) {
            event.stop_immediate_propagation();
        }
        match key.as_str() {
            "Shift" => (),
            "Escape" => SIGNALS.with(|signals| signals.leaving.set(!dom.page().has_popup())),
            "Tab" if !event.ctrl_key() && !event.alt_key() && !event.meta_key() => {
                let backwards = event.shift_key();
                if leaving {
                    dom.focus_outermost(!backwards);
                } else if on_canvas {
                    match dom.page().focus {
                        Some(id) => dom.focus_quietly(id),
                        None => dom.focus_edge(backwards),
                    }
                }
                if on_canvas {
                    // And then the browser does with Tab what it does everywhere.
                    event.stop_immediate_propagation();
                }
                SIGNALS.with(|signals| signals.leaving.set(false));
            }
            _ => SIGNALS.with(|signals| signals.leaving.set(false)),
        }
    });
}
