//! The keyboard: its focus, and the keys that the program knows.

use crate::machine::Machine;
use crate::program::{B, D, FX, PHONE, Program, W_IMG, W_REAL};
use egui::accesskit::Role;
use egui::{Key, Modifiers, MouseWheelSource, MouseWheelUnit, TouchPhase, pos2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

#[test]
fn what_stands_below_is_read_and_reached_after_what_stands_above() {
    let mut program = Program::on(Machine::default(), PHONE);
    program.mug();
    program.press("Reset");
    let read: Vec<String> = program
        .harness
        .root()
        .children_recursive()
        .filter_map(|node| node.accesskit_node().label().or_else(|| node.accesskit_node().value()))
        .collect();
    let place = |words: &str| read.iter().rposition(|said| said == words).unwrap();
    assert!(place("Calculate Distance") < place("All fields are cleared."));
    assert!(place("All fields are cleared.") < place("Undo"));
    assert!(place("Undo") < place("Close") && place("Close") < read.len() - 1, "{read:?}");
    // Tab goes the same way.
    program.harness.get_by_label("Close").focus();
    program.harness.run();
    program.harness.key_press_modifiers(egui::Modifiers::SHIFT, egui::Key::Tab);
    program.harness.run();
    assert!(program.harness.get_by_label("Undo").is_focused());
}

#[test]
fn the_question_mark_lists_the_keys() {
    let mut program = Program::new();
    program.show("Learn");
    program.harness.event(egui::Event::Text("?".into()));
    program.harness.run();
    assert!(program.says("Step ten times as far"));
    program.harness.key_press(Key::Escape);
    program.harness.run();
    assert!(!program.says("Step ten times as far"));
}

fn press_key(program: &mut Program, modifiers: Modifiers, key: Key) {
    program.harness.key_press_modifiers(modifiers, key);
    program.harness.run();
}

#[test]
fn a_list_opens_by_an_arrow_and_is_gone_through_by_arrows_home_end_and_letters() {
    let mut program = Program::new();
    let list = format!("Unit of {B}");
    for modifiers in [Modifiers::NONE, Modifiers::ALT] {
        program.harness.get_by_label(&list).focus();
        program.harness.run();
        press_key(&mut program, modifiers, Key::ArrowDown);
        assert!(
            program.focused().starts_with("mm"),
            "it begins with what is chosen: {}",
            program.focused()
        );
        for (key, unit) in [
            (Key::ArrowDown, "cm"),
            (Key::End, "sq"),
            (Key::ArrowDown, "mm"),
            (Key::ArrowUp, "sq"),
            (Key::Home, "mm"),
        ] {
            press_key(&mut program, Modifiers::NONE, key);
            assert!(program.focused().starts_with(unit), "{key:?}: {}", program.focused());
        }
        press_key(&mut program, Modifiers::NONE, Key::Escape);
        assert_eq!(program.focused(), list, "the focus goes back");
    }
    press_key(&mut program, Modifiers::NONE, Key::ArrowDown);
    program.harness.event(egui::Event::Text("i".into()));
    program.harness.run();
    assert!(program.focused().starts_with("in"), "{}", program.focused());
    press_key(&mut program, Modifiers::NONE, Key::Enter);
    assert_eq!((program.unit(B).as_str(), program.focused()), ("in", list));
    // Closed, a letter chooses at once, as in the browser.
    program.harness.event(egui::Event::Text("k".into()));
    program.harness.run();
    assert_eq!(program.unit(B), "km");
}

#[test]
fn a_menu_takes_the_focus_and_gives_it_back() {
    let mut program = Program::new();
    for (button, first, last) in [
        ("Light or dark", "As the system", "Dark"),
        ("More ways", "Two photographs and a step", "Two points"),
    ] {
        program.harness.get_by_label(button).focus();
        program.harness.run();
        press_key(&mut program, Modifiers::NONE, Key::Enter);
        assert_eq!(program.focused(), first);
        press_key(&mut program, Modifiers::NONE, Key::End);
        assert_eq!(program.focused(), last);
        press_key(&mut program, Modifiers::NONE, Key::Escape);
        assert_eq!(program.focused(), button);
    }
}

#[test]
fn focus_out_of_sight_is_scrolled_into_view() {
    let mut program = Program::on(Machine::default(), PHONE);
    program.harness.get_by_label("Copy Results").focus();
    program.harness.run();
    let rect = program.harness.get_by_label("Copy Results").rect();
    assert!(rect.bottom() < PHONE.y - 60.0, "{rect:?}");
}

/// Scrolls the form as far down as it goes.
fn scroll_to_the_end(program: &mut Program) {
    program.harness.event(egui::Event::PointerMoved(pos2(200.0, 400.0)));
    program.harness.event(egui::Event::MouseWheel {
        unit: MouseWheelUnit::Point,
        delta: vec2(0.0, -5000.0),
        modifiers: Modifiers::NONE,
        phase: TouchPhase::Move,
        source: MouseWheelSource::Wheel,
    });
    program.harness.run();
    // The wheel is smoothed over some frames.
    program.harness.run_steps(60);
}

/// How far down each text of the screen is.
fn tops(program: &Program) -> Vec<(String, f32)> {
    let panel = program.harness.get_by_role(Role::TabPanel);
    let texts = panel
        .children_recursive()
        .filter(|node| node.accesskit_node().role() == Role::Label);
    texts
        .filter(|node| node.accesskit_node().raw_bounds().is_some())
        .map(|node| (node.value().unwrap_or_default(), node.rect().top()))
        .collect()
}

#[test]
fn what_is_scrolled_stays_where_it_is_while_the_focus_is_elsewhere_and_another_screen_is_looked_at() {
    for size in [PHONE, vec2(1280.0, 720.0), vec2(1920.0, 900.0)] {
        let mut program = Program::on(Machine::default(), size);
        program.mug();
        program.press("Range, tilt, zero point");
        scroll_to_the_end(&mut program);
        let before = tops(&program);
        assert!(before.iter().any(|(_, top)| *top < 0.0), "it scrolled at {size}");
        // The tab lies where what has scrolled out of the form is.
        for tab in ["Keys", "Light or dark"] {
            program.harness.get_by_label(tab).focus();
            program.harness.run_steps(20);
            assert_eq!(tops(&program), before, "the focus on {tab} at {size}");
        }
        program.show("Learn");
        if let Some(tab) = program.harness.query_by_role_and_label(Role::Tab, "Calculator") {
            tab.focus();
            tab.click();
        } else {
            program.show("Calculator");
        }
        program.harness.run_steps(20);
        assert_eq!(tops(&program), before, "back at {size}");
    }
}

/// The rings of the focus that the last frame drew, around what.
fn rings(program: &Program) -> Vec<egui::Rect> {
    let shapes = program.harness.output().shapes.iter();
    shapes
        .filter_map(|clipped| match &clipped.shape {
            egui::Shape::Rect(shape) if shape.stroke.width == 2.0 && shape.fill == egui::Color32::TRANSPARENT => Some(shape.rect),
            _ => None,
        })
        .collect()
}

#[test]
fn whatever_has_the_keyboard_shows_a_ring() {
    let mut program = Program::new();
    program.mug();
    // Of several choices the chosen one has the focus.
    program.ask("Another quantity");
    for name in [
        "Calculator",
        "Keys",
        "Another quantity",
        "Light or dark",
        "From lens, FOV or Q…",
        "Calculate Disparity",
        "Reset",
        "Coffee mug (stereo)",
        "Range, tilt, zero point",
        "More ways",
    ] {
        program.control(name).focus();
        program.harness.run();
        let around = program.control(name).rect();
        assert!(
            rings(&program)
                .iter()
                .any(|ring| ring.contains_rect(around) && around.expand(4.0).contains_rect(*ring)),
            "{name}"
        );
    }
    program.harness.input_mut().focused = false;
    program.harness.run();
    assert_eq!(rings(&program), [], "something else in the window has the keyboard");
    program.harness.input_mut().focused = true;
    program.harness.key_press(Key::Escape);
    program.harness.run();
    assert_eq!(rings(&program), [], "nothing has the keyboard");
}

/// What Tab leads through from the first field on, until `last`.
fn tab_from(program: &mut Program, first: &str, last: &str) -> Vec<String> {
    program.input(first).focus();
    program.harness.run();
    let mut order = vec![program.focused()];
    while order.last().is_some_and(|name| name != last) && order.len() < 60 {
        program.harness.key_press(Key::Tab);
        program.harness.run();
        order.push(program.focused());
    }
    order
}

#[test]
fn tab_leads_through_each_field_as_it_is_drawn_then_through_the_choices_and_then_the_buttons() {
    let mut program = Program::new();
    let order = tab_from(&mut program, FX, "Doorway (monocular)");
    let of_camera = [FX, "Uncertainty of Focal length (fx)"];
    let of_stereo = [
        B,
        "Unit of Camera baseline (b)",
        "Uncertainty of Camera baseline (b)",
        "OpenCV × 16, doffs…",
        D,
        "Uncertainty of Disparity (d)",
    ];
    let of_monocular = [
        W_IMG,
        "Uncertainty of Object width in image (w_img)",
        W_REAL,
        "Unit of Object real width (w_real)",
        "Uncertainty of Object real width (w_real)",
    ];
    let late = ["Cameras: Side by side", "Not square…", "Measured: Width", "Known sizes…"];
    let buttons = ["Calculate Distance", "Copy Results", "Reset", "Range, tilt, zero point"];
    let examples = ["Coffee mug (stereo)", "Doorway (monocular)"];
    let wanted = [&of_camera[..], &of_stereo, &of_monocular, &late, &buttons, &examples].concat();
    assert_eq!(order, wanted);
}

#[test]
fn what_is_asked_for_comes_before_the_fields_and_is_one_stop_of_tab() {
    let mut program = Program::new();
    program.input(FX).focus();
    program.harness.run();
    let back = |program: &mut Program| {
        program.harness.key_press_modifiers(egui::Modifiers::SHIFT, Key::Tab);
        program.harness.run();
        program.focused()
    };
    let before = [(); 3].map(|()| back(&mut program));
    assert_eq!(before, ["From lens, FOV or Q…", "More ways", "Distance"]);
    for (key, name) in [
        (Key::ArrowRight, "Another quantity"),
        (Key::ArrowRight, "Ground plane"),
        (Key::ArrowLeft, "Another quantity"),
    ] {
        program.harness.key_press(key);
        program.harness.run();
        assert_eq!(
            (program.focused().as_str(), program.chosen("What is asked for").as_deref()),
            (name, Some(name))
        );
    }
}

#[test]
fn the_fields_of_the_refinements_come_behind_what_opens_them() {
    let mut program = Program::new();
    program.press("Range, tilt, zero point");
    let disclosure = program.control("Range, tilt, zero point").accesskit_node();
    assert_eq!(disclosure.data().is_expanded(), Some(true));
    let order = tab_from(&mut program, W_REAL, "Tilt of the target");
    let place = |name: &str| order.iter().position(|one| one == name).unwrap();
    assert!(place("Range, tilt, zero point") < place("Principal point cx"), "{order:?}");
    assert!(place("Principal point cx") < place("Range by tape (R)"), "{order:?}");
}
