use egui::{Modifiers, Role};

use super::{ROOT, TestTree, control};
use crate::keys::{Route, is_browsers, is_idle, route};
use crate::roles::Kind;

#[test]
fn tab_and_the_keys_of_the_browser_stay_with_the_browser() {
    let kinds = [
        Kind::Button,
        Kind::Check,
        Kind::Line,
        Kind::Lines,
        Kind::Stepper,
        Kind::Range,
        Kind::Other,
    ];
    let ctrl = Modifiers {
        ctrl: true,
        command: true,
        ..Modifiers::NONE
    };
    for kind in kinds {
        assert_eq!(route(kind, "Tab", Modifiers::NONE, false), Route::Browser);
        assert_eq!(route(kind, "Tab", Modifiers::SHIFT, false), Route::Browser);
        // It asks for a menu a moment later.
        assert_eq!(route(kind, "F10", Modifiers::SHIFT, false), Route::Browser);
        for key in ["f", "r", "l", "t", "+", "-", "0", "F5", "F12"] {
            let modifiers = if key.starts_with('F') { Modifiers::NONE } else { ctrl };
            assert_ne!(route(kind, key, modifiers, false), Route::Egui { only: true }, "{kind:?} {key}");
        }
    }
}

#[test]
fn the_canvas_does_not_keep_the_browsers_keys() {
    const CTRL: Modifiers = Modifiers::CTRL;
    const CMD: Modifiers = Modifiers::MAC_CMD;
    for key in ["p", "P", "s", "o", ","] {
        assert!(is_browsers(key, CTRL, false) && is_browsers(key, CMD, true), "{key}");
        assert!(!is_browsers(key, Modifiers::NONE, false), "{key} alone is typed");
        assert!(!is_browsers(key, CTRL, true), "{key} moves the caret on a Mac");
    }
    assert!(is_browsers("ArrowLeft", Modifiers::ALT, false));
    assert!(!is_browsers("ArrowLeft", Modifiers::ALT, true), "by a word");
    assert!(!is_browsers("ArrowLeft", CTRL, false), "by a word");
    assert!(!is_browsers("c", CTRL, false), "eframe leaves it to the browser by itself");
}

#[test]
fn a_field_types_and_edits_by_itself_and_only_enter_and_escape_reach_egui() {
    let ctrl = Modifiers {
        ctrl: true,
        command: true,
        ..Modifiers::NONE
    };
    for (key, modifiers) in [
        ("a", Modifiers::NONE),
        ("Backspace", Modifiers::NONE),
        ("v", ctrl),
        ("z", ctrl),
        ("ArrowLeft", ctrl),
    ] {
        assert_eq!(route(Kind::Line, key, modifiers, false), Route::Browser, "{key}");
    }
    assert_eq!(route(Kind::Line, "Enter", Modifiers::NONE, false), Route::Egui { only: true });
    assert_eq!(route(Kind::Line, "2", Modifiers::NONE, false), Route::Browser);
    assert_eq!(
        route(Kind::Range, "ArrowUp", Modifiers::SHIFT, false),
        Route::Egui { only: true },
        "a larger step"
    );
    assert_eq!(route(Kind::Lines, "Enter", Modifiers::NONE, false), Route::Browser, "a new line");
    assert_eq!(route(Kind::Lines, "Escape", Modifiers::NONE, false), Route::Egui { only: false });
    assert_eq!(route(Kind::Other, " ", Modifiers::NONE, false), Route::Click);
    assert_eq!(
        route(Kind::Button, " ", Modifiers::NONE, false),
        Route::Browser,
        "which clicks by itself"
    );
}

#[test]
fn a_shortcut_of_the_application_reaches_egui_from_a_field_too() {
    for kind in [Kind::Line, Kind::Lines, Kind::Stepper, Kind::Button] {
        // Into a field some browsers would write it.
        let only = kind != Kind::Button;
        assert_eq!(route(kind, "2", Modifiers::ALT, true), Route::Egui { only }, "{kind:?}");
        assert_eq!(
            route(kind, "Tab", Modifiers::NONE, true),
            Route::Browser,
            "Tab is the browser's, always"
        );
    }
    assert_eq!(route(Kind::Line, "2", Modifiers::ALT, false), Route::Browser);
}

#[test]
fn an_arrow_moves_the_focus_only_where_people_expect_it() {
    let mut tree = TestTree::new();
    let roles = [
        Role::Button,
        Role::CheckBox,
        Role::Tab,
        Role::RadioButton,
        Role::MenuItem,
        Role::Slider,
    ];
    let ids = roles.map(|role| tree.add(ROOT, role, |node| control(node, "One")));
    let opener = tree.add(ROOT, Role::Button, |node| {
        control(node, "More");
        node.set_has_popup(egui::accesskit::HasPopup::Menu);
    });
    let page = tree.page();
    let idle = ids.map(|id| is_idle(page.get(id).unwrap(), "ArrowDown"));
    assert_eq!(idle, [true, true, false, false, false, false]);
    assert!(!is_idle(page.get(opener).unwrap(), "ArrowDown"));
    assert!(!is_idle(page.get(ids[0]).unwrap(), "Home"));
}
