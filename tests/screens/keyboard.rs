//! The keyboard: its focus, and the keys that the program knows.

use crate::machine::Machine;
use crate::program::{PHONE, Program};
use egui::Key;
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
    program.press("Learn");
    program.harness.event(egui::Event::Text("?".into()));
    program.harness.run();
    assert!(program.says("Step ten times as far"));
    program.harness.key_press(Key::Escape);
    program.harness.run();
    assert!(!program.says("Step ten times as far"));
}

#[test]
fn focus_out_of_sight_is_scrolled_into_view() {
    let mut program = Program::on(Machine::default(), PHONE);
    program.harness.get_by_label("Copy Results").focus();
    program.harness.run();
    let rect = program.harness.get_by_label("Copy Results").rect();
    assert!(rect.bottom() < PHONE.y - 60.0, "{rect:?}");
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
    for name in [
        "Learn",
        "Keys",
        "Light or dark",
        "from lens, FOV or Q…",
        "Calculate Distance",
        "Reset",
        "Coffee mug (stereo)",
        "Add uncertainty",
    ] {
        program.harness.get_by_label(name).focus();
        program.harness.run();
        let around = program.harness.get_by_label(name).rect();
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
