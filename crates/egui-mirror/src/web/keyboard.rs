//! What is pressed on the keyboard: `keys` decides whose a key is, this carries it out.

use egui::accesskit::{Action, NodeId};
use wasm_bindgen::JsCast as _;
use web_sys::{Element, Event, KeyboardEvent};

use super::dom::Dom;
use super::installed::with;
use super::signals::{act, send};
use crate::element::node_id;
use crate::keys::{self, Direction, Route};
use crate::roles::Kind;

/// A key is pressed on the element of this node.
pub(crate) fn pressed(event: &Event, id: NodeId) {
    let Some(event) = event.dyn_ref::<KeyboardEvent>().filter(|event| !event.is_composing()) else {
        return;
    };
    let modifiers = modifiers(event);
    // On Windows, Alt and the number pad write characters by their code.
    if modifiers.alt && event.code().starts_with("Numpad") {
        return;
    }
    let _ = with(|mirror| {
        let dom = &mirror.dom;
        let Some(element) = dom.page().get(id) else { return };
        let key = event.key();
        if keys::is_idle(element, &key) {
            return;
        }
        match keys::route(element.kind, &key, modifiers, dom.is_shortcut(&key, modifiers)) {
            Route::Browser => (),
            Route::Egui { only } => {
                if only {
                    event.prevent_default();
                }
                // egui let go of its focus on Escape or Enter, but the person is still here.
                if dom.coming_focus() != Some(id) && key != "Escape" {
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

/// The menu of an element is asked for, with the keys of menus or by assistive technology: the pointer meets the canvas. A field has
/// the browser's own menu.
pub(crate) fn menu_asked(event: &Event) {
    let Some(place) = event.target().and_then(|target| target.dyn_into::<Element>().ok()) else {
        return;
    };
    let _ = with(|mirror| {
        let dom = &mirror.dom;
        let is_text = |id| dom.page().get(id).is_none_or(|element| element.kind.is_text());
        let Some(id) = node_id(&place.id()).filter(|id| dom.is_in_mirror(&place) && !is_text(*id)) else {
            return;
        };
        event.prevent_default();
        if dom.coming_focus() != Some(id) {
            act(dom.ctx(), id, Action::Focus, None);
        }
        stroke(dom.ctx(), egui::Key::F10, None, egui::Modifiers::SHIFT);
    });
}

/// Presses and releases a key in egui. The release is not waited for: it may happen on another element.
fn press(ctx: &egui::Context, event: &KeyboardEvent, modifiers: egui::Modifiers, kind: Kind) {
    let physical_key = egui::Key::from_name(event.code().trim_start_matches("Key").trim_start_matches("Digit"));
    let name = event.key();
    // A key may be a command by what it writes ("?"), wherever it is on the keyboard. A field has its text otherwise.
    let is_text = name.chars().count() == 1 && !kind.is_text() && !modifiers.command && !modifiers.alt;
    if is_text {
        send(ctx, [egui::Event::Text(name.clone())]);
    }
    let Some(key) = egui::Key::from_name(&name)
        .or_else(|| egui::Key::from_name(&name.to_ascii_uppercase()))
        .or(physical_key)
    else {
        return;
    };
    stroke(ctx, key, physical_key, modifiers);
}

fn stroke(ctx: &egui::Context, key: egui::Key, physical_key: Option<egui::Key>, modifiers: egui::Modifiers) {
    let stroke = |pressed| egui::Event::Key {
        key,
        physical_key,
        pressed,
        repeat: false,
        modifiers,
    };
    if modifiers.any() {
        send(ctx, [egui::Event::ModifiersChanged(modifiers)]);
    }
    send(ctx, [stroke(true), stroke(false)]);
    if modifiers.any() {
        send(ctx, [egui::Event::ModifiersChanged(egui::Modifiers::NONE)]);
    }
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
pub(crate) fn on_its_way(event: &Event) {
    let Some(event) = event.dyn_ref::<KeyboardEvent>().filter(|event| !event.is_composing()) else {
        return;
    };
    let Some(place) = event.target().and_then(|target| target.dyn_into::<Element>().ok()) else {
        return;
    };
    let key = event.key();
    let _ = with(|mirror| {
        let dom = &mirror.dom;
        let on_canvas = dom.is_canvas(&place);
        if !on_canvas && !dom.is_in_mirror(&place) {
            // A dialog closes wherever the focus is.
            if key == "Escape" && place.tag_name() == "BODY" && dom.page().has_popup() {
                press(dom.ctx(), event, modifiers(event), Kind::Other);
            }
            return;
        }
        let is_mac = dom.ctx().os() == egui::os::OperatingSystem::Mac;
        if on_canvas && keys::is_browsers(&key, modifiers(event), is_mac) {
            event.stop_immediate_propagation();
        }
        match key.as_str() {
            // It closes what is open, and does nothing else: egui would let go of the focus.
            "Escape" if !dom.page().has_popup() => event.stop_immediate_propagation(),
            "Tab" if on_canvas && !event.ctrl_key() && !event.alt_key() && !event.meta_key() => {
                tab(dom, event.shift_key());
                // And then the browser does with Tab what it does everywhere.
                event.stop_immediate_propagation();
            }
            _ => (),
        }
    });
}

/// Puts the browser's focus where its own Tab goes on in the right way.
fn tab(dom: &Dom, backwards: bool) {
    match dom.page().focus() {
        Some(id) => dom.focus_quietly(id),
        None => dom.host().focus_edge(backwards),
    }
}
