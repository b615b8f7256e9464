//! Every way that people count, in the window.

use crate::program::{B, D, FX, Program, W_IMG, W_REAL};
use egui::accesskit::{Role, Toggled};
use egui::{Key, Modifiers};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

const FY: &str = "Focal length along the columns (fy)";
const LENS: &str = "Lens that fx came from";

#[test]
fn a_height_goes_with_fy_and_a_ball_to_its_center() {
    let mut program = Program::new();
    program.type_into(FX, "600");
    program.type_into(W_IMG, "100");
    program.type_into(W_REAL, "1.8");
    assert!(program.says("10.80 m"));
    assert!(program.harness.query_by_label(FY).is_none(), "asked for only where it counts");
    let is_chosen = |program: &Program, name: &str| {
        let node = program.harness.get_by_role_and_label(Role::RadioButton, name);
        node.accesskit_node().toggled() == Some(Toggled::True)
    };
    assert!(is_chosen(&program, "Measured: Width"));
    program.press("Measured: Height");
    // Not only the sentences below the fields: the names too.
    assert!(program.harness.query_by_label(W_IMG).is_none());
    assert_eq!(program.value("Object height in image (w_img)"), "100");
    assert_eq!(program.value("Object real height (w_real)"), "1.8");
    assert!(is_chosen(&program, "Measured: Height") && !is_chosen(&program, "Measured: Width"));
    assert!(program.says("10.80 m"), "fy is fx where it is not known");
    program.type_into(FY, "853");
    assert!(program.says("15.35 m") && program.says("w_real · fy / w_img"), "{}", program.text());
    program.press("Measured: Diameter of ball");
    program.type_into(FX, "1000");
    program.type_into("Ball width in image (w_img)", "408.2");
    program.type_into("Ball real diameter (w_real)", "0.2");
    assert!(program.says("0.5001 m") && program.says("through its center"));
}

#[test]
fn cameras_one_above_the_other_count_in_rows() {
    let mut program = Program::new();
    program.type_into(FX, "768.4");
    program.type_into(B, "25");
    program.type_into(D, "20");
    program.press("Cameras: One above the other");
    assert!(program.says("0.9605 m") && program.says("y upper"));
}

#[test]
fn an_angle_is_typed_with_its_unit_and_needs_no_focal_length() {
    let mut program = Program::new();
    program.type_into(W_REAL, "10 in");
    program.type_into(W_IMG, "0.75 mrad ± 0.05 mrad");
    assert!(
        program.says("338.7 m") || program.says("339 m ± 23") || program.says("339 m"),
        "{}",
        program.text()
    );
    program.type_into(W_IMG, "0.75 mil");
    assert!(program.says("345") && program.says("1/6400 of the circle"), "{}", program.text());
    // It stays as it was typed.
    program.type_into(D, "50");
    assert_eq!(program.value(W_IMG), "0.75 mil");
    program.type_into(W_IMG, "150");
    assert!(!program.says("345"), "a bare number is in pixels again");
}

#[test]
fn what_is_worked_out_is_shown_as_read() {
    let mut program = Program::new();
    program.type_into(FX, "fx = 1280/2 px");
    assert!(program.says("= 640 px"), "{}", program.text());
    program.type_into(B, "1 1/8 in");
    assert!(program.says("= 1.125 in"));
    program.type_into(D, "2*25");
    assert_eq!((program.value(B), program.unit(B)), ("1 1/8".to_owned(), "in".to_owned()));
    assert!(
        program.answer("Stereo").contains("640 px · 0.028\u{2009}575 m / 50 px"),
        "{}",
        program.answer("Stereo")
    );
    program.type_into(W_REAL, "5'11\"");
    assert!(program.says("= 5.916\u{2009}67 ft"), "{}", program.text());
    // Several units were no slip: another unit converts them.
    program.choose("Unit of Object real width (w_real)", "cm");
    assert_eq!(program.value(W_REAL), "180.34");
}

#[test]
fn a_lens_that_fx_came_from_is_noted_until_fx_is_another() {
    let mut program = Program::new();
    program.press("From lens, FOV or Q…");
    program.choose("What is known", "Lens and pixel size");
    program.type_into("Focal length of the lens", "15");
    program.type_into("Pixel pitch", "16");
    program.press("Use fx = 937.500 px");
    assert_eq!((program.value(FX), program.value(LENS)), ("937.5".to_owned(), "15".to_owned()));
    program.type_into(W_IMG, "350");
    program.type_into(W_REAL, "100 mm");
    assert!(program.says("0.2829 m") && program.says("of the lens"), "{}", program.text());
    // A calibrated one.
    program.type_into(FX, "940");
    assert!(program.harness.query_by_label(LENS).is_none());
    assert!(program.says("0.2686 m"), "{}", program.text());
}

#[test]
fn a_baseline_that_is_not_square_is_worked_out_by_its_helper() {
    let mut program = Program::new();
    program.press("Not square…");
    program.type_into("Distance between the cameras", "100");
    program.type_into("Angle to the line of sight", "60");
    program.press("Use b = 86.6025 m");
    assert_eq!(program.unit(B), "m");
    assert!(program.value(B).starts_with("86.6025"));
}

#[test]
fn another_zero_moves_every_distance() {
    let mut program = Program::new();
    program.mug();
    program.press("Range, tilt, zero point");
    program.type_into("The tape starts in front of the lens", "4.2");
    assert!(program.says("1.396 m") && program.says("− zero"), "{}", program.text());
    program.type_into("The tape starts in front of the lens", "2 m");
    assert!(program.says("The tape would start beyond the object"));
}

#[test]
fn two_photographs_and_two_points_have_forms_and_answers_of_their_own() {
    let mut program = Program::new();
    program.ask("Two photographs and a step");
    program.type_into("Width in the first photograph", "1162 ± 3");
    program.type_into("Width in the second photograph", "1429 ± 3");
    program.type_into("Step between them", "419.1 mm");
    assert!(
        program.answer("From the first place").contains("(2.243 ± 0.032) m"),
        "{}",
        program.text()
    );
    assert!(program.answer("From the second place").contains("(1.824 ± 0.032) m"));
    program.ask("Two points");
    for (field, text) in [
        (FX, "452.9"),
        (B, "75"),
        ("Column of the first point", "138"),
        ("Row of the first point", "219"),
        ("Disparity of the first point", "36 ± 0.5"),
        ("Column of the second point", "264"),
        ("Row of the second point", "216"),
        ("Disparity of the second point", "30 ± 0.5"),
    ] {
        program.type_into(field, text);
    }
    let needs = "needs Principal point cx: go to the field and Principal point cy: go to the field";
    assert!(
        program.answer("Between the points").contains(needs),
        "{}",
        program.answer("Between the points")
    );
    program.type_into("Principal point cx", "298.85");
    program.type_into("Principal point cy", "245.52");
    assert!(program.answer("Between the points").contains("(0.312 ± 0.011) m"));
    assert!(program.answer("Farther away").contains("(0.189 ± 0.023) m"));
}

#[test]
fn long_and_short_distances_take_the_next_unit_or_a_power_of_ten() {
    let mut program = Program::new();
    program.type_into(FX, "1000");
    program.type_into(D, "1");
    for (baseline, distance) in [
        ("384.4 km", "384\u{2009}400 km"),
        ("12.5 m", "12\u{2009}500 m"),
        ("0.6 nm", "0.6000 µm"),
        ("1.4e-14 m", "1.400 × 10⁻¹¹ m"),
        ("2e8 km", "2.000 × 10¹⁴ m"),
    ] {
        program.type_into(B, baseline);
        assert!(program.says(distance), "{baseline}: {}", program.text());
    }
}

#[test]
fn a_choice_is_one_stop_of_tab_and_the_arrows_lead_through_it() {
    let mut program = Program::new();
    program.harness.get_by_label("Calculate Distance").focus();
    program.harness.run();
    for before in ["Known sizes…", "Measured: Width"] {
        program.harness.key_press_modifiers(Modifiers::SHIFT, Key::Tab);
        program.harness.run();
        // The helpers come between and behind the choices, as they stand.
        assert_eq!(program.focused(), before);
    }
    for (key, name) in [
        (Key::ArrowRight, "Measured: Height"),
        (Key::ArrowDown, "Measured: Diameter of ball"),
        (Key::ArrowRight, "Measured: Width"),
        (Key::ArrowLeft, "Measured: Diameter of ball"),
        (Key::ArrowUp, "Measured: Height"),
    ] {
        program.harness.key_press(key);
        program.harness.run();
        assert_eq!(program.focused(), name);
        let node = program.harness.get_by_role_and_label(Role::RadioButton, name);
        assert_eq!(node.accesskit_node().toggled(), Some(Toggled::True), "{name}");
    }
    program.harness.key_press_modifiers(Modifiers::SHIFT, Key::Tab);
    program.harness.run();
    assert_eq!(program.focused(), "Not square…");
    program.harness.key_press_modifiers(Modifiers::SHIFT, Key::Tab);
    program.harness.run();
    assert_eq!(program.focused(), "Cameras: Side by side");
}
