//! The form: numbers and units typed into fields, what is said of them, and the buttons below.

use crate::program::{B, D, FX, Program, W_IMG, W_REAL};
use depth_text::field::Key as FieldKey;
use egui::accesskit::Role;
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

#[test]
fn the_doorway_button_gives_its_distance_and_can_be_undone() {
    let mut program = Program::new();
    program.type_into(FX, "123");
    program.press("Doorway (monocular)");
    assert!(program.says("4.275 m"));
    assert_eq!(program.value(FX), "950");
    program.press("Undo");
    assert_eq!(program.value(FX), "123");
    assert_eq!(program.value(W_IMG), "");
}

#[test]
fn a_typed_unit_switches_the_unit_beside_the_field() {
    let mut program = Program::new();
    program.type_into(B, "10 cm");
    assert_eq!(program.unit(B), "cm");
    program.type_into(W_REAL, "4in");
    assert_eq!(
        (program.value(B).as_str(), program.unit(B).as_str()),
        ("10", "cm"),
        "leaving the field tidies it"
    );
    assert_eq!(program.unit(W_REAL), "in");
}

#[test]
fn changing_the_unit_by_hand_keeps_the_number() {
    let mut program = Program::new();
    program.mug();
    program.choose("Unit of Camera baseline (b)", "centimeters");
    assert_eq!(program.value(B), "100");
    assert!(program.says("14.00 m"));
}

#[test]
fn arrows_step_a_field_and_shift_ten_times() {
    let mut program = Program::new();
    program.type_into(D, "50");
    program.harness.key_press(Key::ArrowUp);
    program.harness.run();
    assert_eq!(program.value(D), "51");
    program.harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowDown);
    program.harness.run();
    assert_eq!(program.value(D), "41");
}

#[test]
fn an_ambiguous_number_is_asked_about_and_one_click_answers() {
    let mut program = Program::new();
    program.type_into(FX, "1,000");
    assert!(program.says("could mean 1000 or 1.000"));
    program.press("Use 1000");
    assert_eq!(program.value(FX), "1000");
    assert!(!program.says("could mean"));
}

#[test]
fn a_slip_of_the_unit_is_corrected_by_one_click() {
    let mut program = Program::new();
    program.type_into(FX, "700");
    program.type_into(B, "0.1");
    program.type_into(D, "50");
    assert!(
        program.answer("Stereo").contains("0.001\u{2009}400 m"),
        "an unusual value is used all the same"
    );
    program.press("Use 0.1 m");
    assert!(program.says("1.400 m"));
    assert_eq!(program.unit(B), "m");
}

#[test]
fn bad_input_is_named_at_its_field_and_the_other_method_stays() {
    let mut program = Program::new();
    program.press("Doorway (monocular)");
    for (text, said) in [
        ("abc", "“abc” is not a number"),
        ("0", "infinitely far away"),
        ("−5", "swapped"),
        ("1e999", "no distance that a computer can represent"),
    ] {
        program.type_into(D, text);
        assert!(program.says(said), "{text}: {}", program.text());
        assert!(program.says("4.275 m"));
        assert!(!program.says("NaN") && !program.says("inf "));
    }
}

#[test]
fn calculate_marks_what_is_missing_and_goes_to_the_first_problem() {
    let mut program = Program::new();
    program.press("Calculate Distance");
    assert_eq!(program.focused(), FX);
    program.type_into(D, "50");
    program.harness.key_press(Key::Enter);
    program.harness.run();
    assert_eq!(program.focused(), FX);
    assert!(program.says("The focal length is missing for the stereo distance."));
    assert!(program.says("The baseline is missing for the stereo distance."));
    assert!(
        !program.says("The real width is missing"),
        "a method that was not touched is no problem"
    );
}

#[test]
fn reset_clears_everything_and_can_be_undone_and_redone() {
    let mut program = Program::new();
    program.mug();
    program.press("Reset");
    assert_eq!(program.value(D), "");
    assert!(program.answer("Stereo").contains("needs Focal length (fx)"), "{}", program.text());
    program.press("Undo");
    assert!(program.says("1.400 m"));
    program.press("Redo");
    assert_eq!(program.value(D), "");
}

#[test]
fn an_error_makes_nothing_else_in_the_form_another_thing() {
    let mut program = Program::new();
    program.mug();
    let ids = |program: &Program| -> Vec<egui::accesskit::NodeId> {
        let in_form = program.harness.get_by_role_and_label(Role::Form, "Inputs");
        let parts = ["Stereo", "Monocular", B, D, "Reset", "Coffee mug (stereo)"];
        let found = parts.iter().map(|name| {
            let mut nodes = in_form.children_recursive();
            let node = nodes.find(|node| {
                let node = node.accesskit_node();
                node.role() != Role::TextRun && node.label().or_else(|| node.value()).as_deref() == Some(name)
            });
            node.unwrap().accesskit_node().locate().0
        });
        found.collect()
    };
    let before = ids(&program);
    program.type_into(FX, "seven");
    let field = program.harness.get_by_role_and_label(Role::NumberInput, FX);
    assert!(field.accesskit_node().data().invalid().is_some());
    assert_eq!(ids(&program), before);
}

#[test]
fn every_field_of_the_table_that_has_a_section_is_in_one_of_the_forms_and_in_the_accessible_tree() {
    let mut program = Program::new();
    program.press("Range, tilt, zero point");
    // They are shown once a helper has filled them in.
    let hidden = [depth_text::fields::FX_LENS, depth_text::fields::DOFFS];
    let mut left: Vec<FieldKey> = FieldKey::form().filter(|key| !hidden.contains(key)).collect();
    for way in [
        "Distance",
        "Another quantity",
        "Ground plane",
        "Two photographs and a step",
        "Two points",
    ] {
        program.ask(way);
        let (here, elsewhere) = left.iter().partition(|key| program.has_input(key.name));
        left = elsewhere;
        check_fields(&program, here);
    }
    assert!(left.is_empty(), "{left:?}");
}

fn check_fields(program: &Program, keys: Vec<FieldKey>) {
    for key in keys {
        let field = program.input(key.name);
        let node = field.accesskit_node();
        let description = node.data().description().unwrap_or_default().to_owned();
        assert!(description.starts_with(key.hint), "{}: {description}", key.name);
        if key.is_length() {
            assert_eq!(program.unit(key.name), key.kind.length_unit().unwrap().symbol());
        }
        let sigma = format!("Uncertainty of {}", key.name);
        assert_eq!(program.harness.query_by_label(&sigma).is_some(), key.has_sigma, "{sigma}");
    }
}
