//! Who gets a key that is pressed on an element of the mirror: the browser or egui.

use egui::Modifiers;

use crate::element::Element;
use crate::roles::Kind;

/// What is done with a key.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Route {
    /// The browser does what it does with that key on such an element.
    Browser,
    /// egui is told.
    Egui {
        /// Keep the browser from acting on it as well.
        only: bool,
    },
    /// One step up or down.
    Step(Direction),
    /// The same as a click.
    Click,
}

/// The direction of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Direction {
    /// To a larger value.
    Up,
    /// To a smaller value.
    Down,
}

/// Does the browser do something of its own with `key`, pressed anywhere on the page, that eframe would keep it from doing
/// while the canvas has the focus? Saving, printing, opening and its settings, and going back and forth in the history.
pub(crate) fn is_browsers(key: &str, modifiers: Modifiers, is_mac: bool) -> bool {
    let command = if is_mac { modifiers.mac_cmd } else { modifiers.ctrl };
    match key.to_ascii_lowercase().as_str() {
        "p" | "s" | "o" | "," => command && !modifiers.alt,
        // On a Mac this moves by words.
        "arrowleft" | "arrowright" => modifiers.alt && !modifiers.ctrl && !modifiers.shift && !is_mac,
        _ => false,
    }
}

/// Does `key` do nothing on this element? With an arrow egui would move the focus to what lies in that direction, which is where nobody
/// expects it but among tabs, radio buttons and the entries of a menu.
pub(crate) fn is_idle(element: &Element, key: &str) -> bool {
    key.starts_with("Arrow")
        && matches!(element.kind, Kind::Button | Kind::Check)
        && element.role().is_none()
        && element.attribute("type") != Some("radio")
        && element.attribute("aria-haspopup").is_none()
}

/// Decides about `key`, in the words of `KeyboardEvent.key`. `is_shortcut`: the application wants it, whatever is focused.
pub(crate) fn route(kind: Kind, key: &str, modifiers: Modifiers, is_shortcut: bool) -> Route {
    const SHARED: Route = Route::Egui { only: false };
    const EGUI: Route = Route::Egui { only: true };
    // Tab is the browser's, always: that is why nobody is caught.
    if matches!(
        key,
        "Tab" | "Shift" | "Control" | "Alt" | "Meta" | "CapsLock" | "Dead" | "Process" | "Unidentified"
    ) {
        return Route::Browser;
    }
    // A browser says afterwards that a menu is asked for, as for the key of menus.
    if key == "F10" && modifiers.shift {
        return Route::Browser;
    }
    let is_function_key = key.len() > 1 && key.starts_with('F') && key.get(1..).is_some_and(|n| n.parse::<u8>().is_ok());
    // With Alt some browsers would write the letter into a field.
    let is_written = kind.is_text() && modifiers.alt && !modifiers.ctrl && !modifiers.mac_cmd && key.chars().count() == 1;
    if is_shortcut && is_written {
        return EGUI;
    }
    if is_function_key || is_shortcut {
        return SHARED;
    }
    let chord = modifiers.ctrl || modifiers.alt || modifiers.mac_cmd;
    if chord {
        return match key.to_ascii_lowercase().as_str() {
            "enter" => SHARED,
            // Copy, paste, undo and moving by words belong to the field.
            _ if kind.is_text() => Route::Browser,
            _ => SHARED,
        };
    }
    match (kind, key) {
        (_, "Escape") => SHARED,
        (Kind::Lines, _) => Route::Browser,
        // A larger step, if it is one.
        (Kind::Range, "ArrowUp" | "ArrowDown" | "ArrowLeft" | "ArrowRight") if modifiers.shift => EGUI,
        (Kind::Stepper | Kind::Range, "ArrowUp") | (Kind::Range, "ArrowRight") => Route::Step(Direction::Up),
        (Kind::Stepper | Kind::Range, "ArrowDown") | (Kind::Range, "ArrowLeft") => Route::Step(Direction::Down),
        (Kind::Range, "Home" | "End" | "PageUp" | "PageDown") => Route::Browser,
        (Kind::Line | Kind::Stepper, "Enter") => EGUI,
        (Kind::Line | Kind::Stepper, "ArrowUp" | "ArrowDown" | "PageUp" | "PageDown") => SHARED,
        (Kind::Line | Kind::Stepper, _) => Route::Browser,
        (Kind::Button, "Enter" | " ") | (Kind::Check, " ") => Route::Browser,
        (Kind::Check | Kind::Other, "Enter") | (Kind::Other, " ") => Route::Click,
        (_, "ArrowUp" | "ArrowDown" | "ArrowLeft" | "ArrowRight" | "Home" | "End" | "PageUp" | "PageDown") => EGUI,
        (_, "Backspace") => EGUI,
        _ => SHARED,
    }
}
