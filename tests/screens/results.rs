//! The results, the pictures and the table, and what can be done with them.

use crate::machine::Machine;
use crate::program::{B, D, DESKTOP, FX, PHONE, Program, W_IMG, W_REAL};
use egui::accesskit::Role;
use egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

#[test]
fn typing_the_mug_gives_its_distance_without_pressing_anything() {
    let mut program = Program::new();
    assert!(program.says("–.– m"));
    program.mug();
    assert!(program.says("1.400 m"), "{}", program.text());
    assert!(program.says("1.373 … 1.429 m"));
    assert!(program.says("D = 700 px · 100 mm / 50 px = 1.400 m"));
}

#[test]
fn both_results_are_shown_as_soon_as_both_can_be_had() {
    let mut program = Program::new();
    program.mug();
    assert!(program.harness.query_by_role_and_label(Role::Region, "Monocular").is_none());
    program.type_into(W_IMG, "150");
    program.type_into(W_REAL, "0,3");
    assert!(program.harness.query_by_role_and_label(Role::Region, "Stereo").is_some());
    assert!(program.harness.query_by_role_and_label(Role::Region, "Monocular").is_some());
    assert!(program.says("agree with what you entered"));
}

#[test]
fn the_unit_of_the_results_is_that_of_every_result() {
    let mut program = Program::new();
    program.mug();
    program.choose("Unit of the results", "millimeters");
    assert!(program.says("1400 mm"));
    assert!(program.says("1373 … 1429 mm"));
    assert!(program.says("D = 700 px · 100 mm / 50 px = 1400 mm"));
    let row = program
        .harness
        .get_by_role_and_label(Role::Table, "Key input parameters and outputs");
    let cells: Vec<_> = row.children_recursive().filter_map(|node| node.value()).collect();
    assert!(cells.iter().any(|cell| cell == "1400"), "{cells:?}");
    program.choose("Unit of the results", "feet");
    for other in [" m ", " m,", " m.", " meters", "(meters)", " mm "] {
        let text = program.text().replace("100 mm", "");
        // In the table the inputs have the units that they were typed in, or would be.
        let results = text.lines().filter(|line| !matches!(*line, "millimeters" | "meters"));
        let results = results.collect::<Vec<_>>().join("\n");
        assert!(!results.contains(other), "{other:?} in {text}");
    }
}

#[test]
fn copy_puts_the_report_on_the_clipboard_and_says_so() {
    let mut program = Program::new();
    program.mug();
    program.press("Copy Results");
    let copied = program.machine.clipboard.borrow().clone().unwrap();
    assert!(
        copied.contains("Camera baseline (b): 100 mm") && copied.contains("1.400 m (unrounded 1.4 m)"),
        "{copied}"
    );
    assert!(program.says("Results copied"));
}

#[test]
fn a_refused_clipboard_and_a_blocked_storage_are_said() {
    let mut program = Program::on(
        Machine {
            broken: true,
            ..Machine::default()
        },
        DESKTOP,
    );
    assert!(program.says("This browser has no storage for pages. The program works, but forgets"));
    program.mug();
    assert!(program.says("1.400 m"));
    program.press("Copy Results");
    assert!(program.says("copies only from pages that arrive over https"));
}

#[test]
fn dragging_the_point_on_the_curve_changes_the_disparity_in_one_undo_step() {
    let mut program = Program::new();
    program.mug();
    let from = program.harness.get_by_role(Role::Slider).rect().center();
    program.harness.drag_at(from);
    program.harness.run();
    for step in 1..=4 {
        program
            .harness
            .hover_at(from + vec2(15.0 * f32::from(u8::try_from(step).unwrap()), 0.0));
        program.harness.run();
    }
    program.harness.drop_at(from + vec2(60.0, 0.0));
    program.harness.run();
    let dragged: f64 = program.value(D).parse().unwrap();
    assert!(dragged > 55.0, "{dragged}");
    program.harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    program.harness.run();
    assert_eq!(program.value(D), "50");
}

#[test]
fn the_point_on_the_curve_follows_the_arrow_keys() {
    let mut program = Program::new();
    program.mug();
    program.harness.get_by_role(Role::Slider).focus();
    program.harness.run();
    program.harness.key_press(Key::ArrowRight);
    program.harness.run();
    assert_eq!(program.value(D), "51");
}

#[test]
fn the_table_has_nine_rows_and_a_header() {
    let program = Program::new();
    let table = program
        .harness
        .get_by_role_and_label(Role::Table, "Key input parameters and outputs");
    let roles: Vec<Role> = table.children_recursive().map(|node| node.accesskit_node().role()).collect();
    assert_eq!(roles.iter().filter(|&&role| role == Role::Row).count(), 10);
    assert_eq!(roles.iter().filter(|&&role| role == Role::ColumnHeader).count(), 4);
    assert_eq!(roles.iter().filter(|&&role| role == Role::RowHeader).count(), 9);
}

#[test]
fn pictures_explain_themselves_when_empty_and_carry_their_numbers_when_full() {
    let mut program = Program::new();
    for said in [
        "both methods side by side",
        "once focal length and baseline are known",
        "as soon as a distance is known",
    ] {
        assert!(program.says(said), "{said}");
    }
    program.mug();
    assert!(program.says("Bar chart. Stereo distance 1.400 m."));
    assert!(program.says("At 50 px the distance is 1.400 m"));
    assert!(program.says("drawn midway between the cameras"));
}

#[test]
fn one_distance_can_be_solved_for_any_input() {
    let mut program = Program::new();
    program.type_into(FX, "700");
    program.type_into(B, "100");
    program.press("Solve for another quantity");
    program.type_into("Distance (D)", "1.4");
    assert!(program.says("50.00 px"), "{}", program.text());
    program.choose("Solve for", "Distance (D)");
    assert!(program.harness.query_by_role_and_label(Role::NumberInput, "Distance (D)").is_none());
}

#[test]
fn assistive_technology_sets_the_point_on_the_curve() {
    let mut program = Program::new();
    program.mug();
    let slider = program.harness.get_by_role(Role::Slider);
    let node = slider.accesskit_node();
    assert_eq!((node.min_numeric_value(), node.max_numeric_value()), (Some(0.0), Some(100.0)));
    let request = egui::accesskit::ActionRequest {
        action: egui::accesskit::Action::SetValue,
        target_tree: egui::accesskit::TreeId::ROOT,
        target_node: node.locate().0,
        data: Some(egui::accesskit::ActionData::NumericValue(70.0)),
    };
    program.harness.event(egui::Event::AccessKitActionRequest(request));
    program.harness.run();
    assert_eq!(program.value(D), "70");
    assert!(program.says("1.000 m"));
}

/// A result is in the unit of the results, and what was given is no result.
#[test]
fn what_is_solved_for_is_the_one_result_and_in_the_unit_of_the_results() {
    let mut program = Program::new();
    program.type_into(FX, "700");
    program.type_into(D, "50");
    program.press("Solve for another quantity");
    program.choose("Solve for", "Stereo: Camera baseline (b)");
    program.type_into("Distance (D)", "1.4");
    assert!(program.says("0.1000 m"), "{}", program.text());
    assert!(
        program.harness.query_by_role_and_label(Role::Region, "Stereo").is_none(),
        "it was given"
    );
    program.choose("Unit of the results", "feet");
    assert!(program.says("0.3281 ft") && !program.says("0.1000 m"), "{}", program.text());
    program.press("Copy Results");
    let copied = program.machine.clipboard.borrow().clone().unwrap();
    assert!(copied.contains("Camera baseline (b) of the stereo distance: 0.3281 ft"), "{copied}");
    assert!(!copied.contains("Stereo distance, D"), "{copied}");
    // And the width, in whatever unit its field has.
    program.choose("Solve for", "Monocular: Object real width (w_real)");
    program.type_into(W_IMG, "150");
    assert!(program.says("0.9843 ft"), "{}", program.text());
}

/// Where something is wrong it is said at its field and once among the results, in whatever the program solves for.
#[test]
fn what_is_wrong_is_said_at_the_field_and_once_among_the_results() {
    let count = |program: &Program, words: &str| {
        let text = program.text();
        // A label is in the tree twice, as a node and as its text.
        let mut lines: Vec<&str> = text.lines().collect();
        lines.dedup();
        lines.iter().filter(|line| line.contains(words)).count()
    };
    let zero = "A disparity of zero means";
    let mut program = Program::new();
    program.mug();
    program.type_into(D, "0");
    assert_eq!(count(&program, zero), 2, "{}", program.text());
    program.press("Copy Results");
    let copied = program.machine.clipboard.borrow().clone().unwrap();
    assert_eq!(copied.matches(zero).count(), 1, "{copied}");
    assert!(
        copied.contains("Stereo distance, D = fx · b / d: none; see the note on the disparity"),
        "{copied}"
    );
    // What both methods need.
    program.type_into(W_IMG, "150");
    program.type_into(W_REAL, "0.3");
    program.type_into(FX, "-700");
    assert_eq!(count(&program, "The focal length cannot be negative"), 2, "{}", program.text());
    // And where another quantity is solved for.
    program.type_into(FX, "700");
    program.press("Solve for another quantity");
    program.choose("Solve for", "Stereo: Camera baseline (b)");
    program.type_into("Distance (D)", "1.4");
    assert_eq!(count(&program, zero), 1, "{}", program.text());
    assert_eq!(count(&program, "None; see the note on the disparity"), 1, "{}", program.text());
    program.type_into(D, "50");
    program.type_into("Distance (D)", "-1");
    assert_eq!(count(&program, "The distance cannot be negative"), 1, "{}", program.text());
    // What is missing is named where the result would be, and said at the field once somebody asks.
    program.type_into("Distance (D)", "");
    assert_eq!(count(&program, "Needs D"), 1, "{}", program.text());
    assert_eq!(count(&program, "The distance is missing"), 0, "{}", program.text());
    program.press("Calculate Distance");
    assert_eq!(program.focused(), "Distance (D)");
    assert_eq!(count(&program, "The distance is missing"), 1, "{}", program.text());
}

/// What sums up the results says which of them it is, and that they disagree.
#[test]
fn what_sums_up_the_results_is_the_combined_distance_or_says_that_they_disagree() {
    let mut program = Program::on(Machine::default(), PHONE);
    program.two_distances();
    let bar = "Combined\nCombined\n1.442 m";
    assert!(program.says(bar), "{}", program.text());
    assert!(
        program.says("the object 1.442 m away by both methods combined"),
        "{}",
        program.text()
    );
    assert_eq!(program.cell("Intermediate values", "Object distance (D, combined)"), "1.442 m");
    assert_eq!(
        program.cell("Key input parameters and outputs", "Object distance (D, combined)"),
        "1.442"
    );
    program.type_into(W_REAL, "3.1");
    assert!(!program.says(bar));
    assert!(program.says("14.47 m\n14.47 m\nThey disagree"), "{}", program.text());
    assert!(program.says("the object 1.400 m away by stereo"), "{}", program.text());
}

/// An input is shown in the unit that it was typed in, also in a picture.
#[test]
fn pictures_have_the_inputs_as_they_were_typed() {
    let mut program = Program::new();
    program.mug();
    program.choose("Unit of the results", "feet");
    assert!(
        program.says("Two cameras 100 mm apart; the object 4.593 ft away"),
        "{}",
        program.text()
    );
}
