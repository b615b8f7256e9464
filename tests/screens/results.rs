//! The results, the pictures and the table, and what can be done with them.

use crate::machine::Machine;
use crate::program::{B, D, DESKTOP, FX, PHONE, Program, W_IMG, W_REAL};
use egui::accesskit::{Action, Role};
use egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

/// The point on the curve.
const POINT: &str = "Disparity of the point, in pixels";

#[test]
fn typing_the_mug_gives_its_distance_without_pressing_anything() {
    let mut program = Program::new();
    assert!(program.answer("Stereo").contains("needs Focal length (fx)"), "{}", program.text());
    program.mug();
    let stereo = program.answer("Stereo");
    for words in ["fx · b / d", "1.400 m", "1.373…1.429 m", "700 px · 0.1 m / 50 px"] {
        assert!(stereo.contains(words), "{words}: {stereo}");
    }
}

#[test]
fn both_results_are_shown_as_soon_as_both_can_be_had() {
    let mut program = Program::new();
    program.mug();
    let needs = "needs Object width in image (w_img): go to the field and Object real width (w_real): go to the field";
    assert!(program.answer("Monocular").contains(needs), "{}", program.answer("Monocular"));
    assert!(program.answer("Combined").contains("needs both distances"));
    program.type_into(W_IMG, "150");
    program.type_into(W_REAL, "0,3");
    for method in ["Stereo", "Monocular"] {
        assert!(program.answer(method).contains("1.400 m"), "{}", program.answer(method));
    }
    let combined = program.answer("Combined");
    assert!(
        combined.contains("needs ± in both"),
        "whether they agree is known by their σ: {combined}"
    );
}

#[test]
fn the_unit_of_the_results_is_that_of_every_result() {
    let mut program = Program::new();
    program.mug();
    program.choose("Unit of the results", "millimeters");
    assert!(program.says("1400 mm"));
    assert!(program.answer("Stereo").contains("1373…1429 mm"));
    assert!(
        program.answer("Stereo").contains("700 px · 100 mm / 50 px"),
        "{}",
        program.answer("Stereo")
    );
    let row = program
        .harness
        .get_by_role_and_label(Role::Table, "Key input parameters and outputs");
    let cells: Vec<_> = row.children_recursive().filter_map(|node| node.value()).collect();
    assert!(cells.iter().any(|cell| cell == "1400"), "{cells:?}");
    program.choose("Unit of the results", "feet");
    for other in [" m ", " m,", " m.", " meters", "(meters)", " mm "] {
        let text = program.text().replace("100 mm", "").replace("= 0.1 m,", "");
        // In the table and at the fields the inputs have the units that they were typed in, or would be.
        let is_of_input =
            |line: &&str| matches!(*line, "millimeters" | "meters") || line.contains("In millimeters.") || line.contains("In meters.");
        let results = text.lines().filter(|line| !is_of_input(line));
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
        copied.starts_with("Stereo: 1.400 m, D = fx·b/d, fx = 700 px, b = 100 mm, d = 50 px"),
        "{copied}"
    );
    assert!(program.says("Copied to the clipboard: the answers, the table, and a link that opens them again."));
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
    assert!(program.says("copies and pastes only on pages that arrive over https"));
}

#[test]
fn dragging_the_point_on_the_curve_changes_the_disparity_in_one_undo_step() {
    let mut program = Program::new();
    program.mug();
    let from = program.harness.get_by_label(POINT).rect().center();
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
    program.harness.get_by_label(POINT).focus();
    program.harness.run();
    program.harness.key_press(Key::ArrowRight);
    program.harness.run();
    assert_eq!(program.value(D), "51");
}

#[test]
fn charts_are_read_by_a_cursor_with_keys_and_are_no_stops_themselves() {
    let mut program = Program::new();
    program.two_distances();
    program.harness.run_steps(60);
    let charts: Vec<bool> = program
        .harness
        .get_all_by_role(Role::Image)
        .map(|chart| chart.accesskit_node().data().supports_action(Action::Focus))
        .collect();
    assert!(charts.len() >= 3 && !charts.contains(&true), "{charts:?}");
    let name = "Data cursor: Stereo against monocular";
    let value = |program: &Program| program.harness.get_by_role_and_label(Role::Slider, name).value().unwrap();
    assert!(value(&program).starts_with("Stereo, "), "{}", value(&program));
    program.harness.get_by_role_and_label(Role::Slider, name).focus();
    program.harness.run();
    for (key, row) in [
        (Key::ArrowUp, "Stereo"),
        (Key::ArrowDown, "Monocular"),
        (Key::ArrowDown, "Combined"),
        (Key::ArrowDown, "Combined"),
        (Key::ArrowUp, "Monocular"),
    ] {
        program.harness.key_press(key);
        program.harness.run();
        assert!(value(&program).starts_with(row), "{} after {key:?}", value(&program));
    }
}

#[test]
fn the_table_has_nine_rows_in_two_parts_one_for_both_methods_combined_and_a_header() {
    let mut program = Program::new();
    program.two_distances();
    let table = program
        .harness
        .get_by_role_and_label(Role::Table, "Key input parameters and outputs");
    let roles: Vec<Role> = table.children_recursive().map(|node| node.accesskit_node().role()).collect();
    // The header, and the title of the second part.
    assert_eq!(roles.iter().filter(|&&role| role == Role::Row).count(), 1 + 5 + 1 + 4 + 1);
    assert_eq!(roles.iter().filter(|&&role| role == Role::ColumnHeader).count(), 4);
    assert_eq!(roles.iter().filter(|&&role| role == Role::RowHeader).count(), 5 + 1 + 4 + 1);
    // Under each header a cell, an empty one where nothing is to be said: by their number a screen reader knows the header of a cell.
    let rows = table.children_recursive().filter(|node| node.accesskit_node().role() == Role::Row);
    let cells: Vec<usize> = rows.map(|row| row.children().count()).collect();
    assert_eq!(cells, [4; 12]);
    let names: Vec<String> = table.children_recursive().filter_map(|node| node.value()).collect();
    assert!(names.iter().any(|name| name == "Intermediate values"), "{names:?}");
}

#[test]
fn a_picture_explains_the_letters_before_anything_is_known_and_the_others_carry_their_numbers() {
    let mut program = Program::new();
    assert!(program.says("the box is w_img wide, and shifted by the disparity d."));
    program.mug();
    assert!(program.says("Bar chart. Stereo distance 1.400 m."));
    assert!(program.harness.query_by_label("What the letters mean").is_none());
    assert!(program.says("At 50 px the distance is 1.400 m"));
    assert!(program.says("drawn midway between the cameras"));
}

#[test]
fn one_distance_can_be_solved_for_any_input() {
    let mut program = Program::new();
    program.type_into(FX, "700");
    program.type_into(B, "100");
    program.press("Another quantity");
    program.type_into("Distance (D)", "1.4");
    assert!(program.says("50.00 px"), "{}", program.text());
    assert_eq!(program.chosen("Solve for").as_deref(), Some("Disparity"));
    program.ask("Distance");
    assert!(program.harness.query_by_role_and_label(Role::NumberInput, "Distance (D)").is_none());
    assert_eq!(program.chosen("What is asked for").as_deref(), Some("Distance"));
}

#[test]
fn assistive_technology_sets_the_point_on_the_curve() {
    let mut program = Program::new();
    program.mug();
    let slider = program.harness.get_by_label(POINT);
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
    program.press("Another quantity");
    program.radio("Baseline");
    program.type_into("Distance (D)", "1.4");
    assert!(program.says("0.1000 m"), "{}", program.text());
    assert!(
        program.harness.query_by_role_and_label(Role::Region, "Stereo").is_none(),
        "it was given"
    );
    program.ask("Distance");
    program.choose("Unit of the results", "feet");
    program.ask("Another quantity");
    program.radio("Baseline");
    assert!(program.says("0.3281 ft") && !program.says("0.1000 m"), "{}", program.text());
    program.press("Copy Results");
    let copied = program.machine.clipboard.borrow().clone().unwrap();
    assert!(
        copied.starts_with("Camera baseline: 0.3281 ft, b = D·d/fx, fx = 700 px"),
        "{copied}"
    );
    assert!(!copied.contains("D = fx"), "{copied}");
    // And the width, in whatever unit its field has.
    program.radio("Real size");
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
    assert_eq!(count(&program, zero), 1, "{}", program.text());
    assert!(
        program.answer("Stereo").contains("No distance: d must be above 0 px."),
        "{}",
        program.answer("Stereo")
    );
    program.press("Copy Results");
    let copied = program.machine.clipboard.borrow().clone().unwrap();
    assert_eq!(copied.matches(zero).count(), 1, "{copied}");
    // What both methods need.
    program.type_into(W_IMG, "150");
    program.type_into(W_REAL, "0.3");
    program.type_into(FX, "-700");
    // At the field, and in the cell of each of them.
    assert_eq!(count(&program, "The focal length cannot be negative"), 3, "{}", program.text());
    for method in ["Stereo", "Monocular"] {
        assert!(
            program.answer(method).contains("No distance: fx must be above 0 px."),
            "{}",
            program.answer(method)
        );
    }
    // And where another quantity is solved for.
    program.type_into(FX, "700");
    program.press("Another quantity");
    program.radio("Baseline");
    program.type_into("Distance (D)", "1.4");
    assert_eq!(count(&program, zero), 1, "{}", program.text());
    assert!(
        program.answer("Camera baseline").contains("d must be above 0 px."),
        "{}",
        program.answer("Camera baseline")
    );
    program.type_into(D, "50");
    program.type_into("Distance (D)", "-1");
    assert_eq!(count(&program, "The distance cannot be negative"), 2, "{}", program.text());
    // What is missing is named where the result would be, and said at the field once somebody asks.
    program.type_into("Distance (D)", "");
    assert!(
        program.answer("Camera baseline").contains("needs Distance (D)"),
        "{}",
        program.answer("Camera baseline")
    );
    assert_eq!(count(&program, "The distance is missing"), 0, "{}", program.text());
    program.press("Calculate Camera baseline");
    assert_eq!(program.focused(), "Distance (D)");
    assert_eq!(count(&program, "The distance is missing"), 1, "{}", program.text());
}

/// What sums up the results says which of them it is, and that they disagree.
#[test]
fn what_sums_up_the_results_is_the_combined_distance_or_says_that_they_disagree() {
    let mut program = Program::on(Machine::default(), PHONE);
    program.two_distances();
    let bar = program.bar();
    assert!(bar.starts_with("Combined Agree (1.442 ± 0.018) m"), "{bar}");
    assert!(
        bar.contains("Stereo (1.400 ± 0.056) m") && bar.contains("Monocular (1.447 ± 0.019) m"),
        "{bar}"
    );
    assert!(
        program.says("the object 1.442 m away by both methods combined"),
        "{}",
        program.text()
    );
    assert_eq!(program.cell("Object distance (D, combined)"), "1.442 ± 0.018");
    program.type_into(W_REAL, "3.1");
    let bar = program.bar();
    assert!(bar.starts_with("Combined Disagree Monocular is 10 times as far"), "{bar}");
    assert_eq!(program.cell("Object distance (D, combined)"), "none");
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
