//! Standard deviations, and what follows from them.

use crate::machine::Machine;
use crate::program::{B, D, DESKTOP, FX, Program, W_IMG, W_REAL, type_sigma};
use egui::accesskit::Role;
use egui_kittest::Harness;
use egui_kittest::kittest::NodeT as _;
use egui_kittest::kittest::Queryable as _;

fn mug_with_uncertainty() -> Program {
    let mut program = Program::new();
    program.mug();
    for (field, sigma) in [(FX, "2"), (B, "0.5"), (D, "0.5")] {
        type_sigma(&mut program, field, sigma);
    }
    program
}

#[test]
fn an_answer_has_a_sigma_only_once_one_is_typed() {
    let mut program = Program::new();
    program.mug();
    assert_eq!(program.value(&format!("Uncertainty of {D}")), "", "there to be typed into");
    assert!(
        !program.answer("Stereo").contains("1.400 ±") && !program.says("variance"),
        "{}",
        program.answer("Stereo")
    );
}

#[test]
fn the_mug_with_uncertainty_reads_as_in_the_specification() {
    let mut program = mug_with_uncertainty();
    assert!(
        program.answer("Stereo").contains("(1.400 ± 0.016) m"),
        "{}",
        program.answer("Stereo")
    );
    assert!(program.answer("Stereo").contains("1.384…1.416 m · 75 % from d"));
    assert!(
        program.says("Disparity d 75 %, Camera baseline b 19 %, Focal length fx 6 %."),
        "{}",
        program.text()
    );
    program.type_into(W_IMG, "150");
    program.type_into(W_REAL, "0.30");
    type_sigma(&mut program, W_IMG, "2");
    type_sigma(&mut program, W_REAL, "0.01");
    let monocular = program.answer("Monocular");
    assert!(
        monocular.contains("(1.400 ± 0.050) m") && monocular.contains("1.350…1.451 m"),
        "{monocular}"
    );
    let combined = program.answer("Combined");
    assert!(combined.contains("(1.400 ± 0.015) m") && combined.contains("Agree"), "{combined}");
}

#[test]
fn asking_for_something_else_keeps_the_uncertainties() {
    let mut program = mug_with_uncertainty();
    program.ask("Ground plane");
    assert!(!program.says("0.016"), "{}", program.text());
    program.ask("Distance");
    assert!(program.answer("Stereo").contains("(1.400 ± 0.016) m"));
}

#[test]
fn a_bad_uncertainty_is_named_and_the_distance_stays() {
    let mut program = Program::new();
    program.mug();
    type_sigma(&mut program, D, "-1");
    assert!(program.says("is negative, which an uncertainty cannot be"));
    assert!(program.says("1.400 m"));
}

#[test]
fn typical_matching_errors_are_offered_with_their_source() {
    let mut program = Program::new();
    program.mug();
    program.press("OpenCV × 16, doffs…");
    program.choose("Typical matching errors", "± 0.25 px");
    program.press("Cancel");
    assert_eq!(program.value(&format!("Uncertainty of {D}")), "0.25");
    assert!(program.answer("Stereo").contains("100 % from d"), "{}", program.answer("Stereo"));
}

#[test]
fn where_first_order_fails_a_simulation_stands_beside_it() {
    let mut program = Program::new();
    program.mug();
    program.type_into(D, "1");
    type_sigma(&mut program, D, "0.8");
    program.harness.run_steps(30);
    assert!(program.says("uncertain by more than 10 %"));
    assert!(program.says("100\u{a0}000 draws"), "{}", program.text());
    // About one draw in nine has no positive disparity.
    assert!(program.says("11 %") && program.says("27…∞ m"), "{}", program.text());
}

/// A program with frames of `frame_s` seconds whose clock has gone on by 20 ms with each batch of draws, in the frame in which the
/// simulation begins.
fn at_the_start_of_a_simulation(frame_s: f32) -> Program {
    let machine = Machine {
        tick: 0.02,
        ..Machine::default()
    };
    let mut program = Program::build(machine, Harness::builder().with_size(DESKTOP).with_step_dt(frame_s));
    program.mug();
    program.type_into(D, "1");
    let sigma = format!("Uncertainty of {D}");
    program.harness.get_by_label(&sigma).focus();
    program.harness.run();
    program.harness.get_by_label(&sigma).type_text("0.8");
    program
}

/// The frames until the simulation is done, and what was told of its progress in each.
fn progress(mut program: Program) -> Vec<f64> {
    let mut told = Vec::new();
    for _ in 0..60 {
        program.harness.step();
        if program.says("100\u{a0}000 draws") {
            assert!(program.harness.query_by_role(Role::ProgressIndicator).is_none());
            return told;
        }
        let bars = program.harness.query_all_by_role(Role::ProgressIndicator);
        let values: Vec<f64> = bars.filter_map(|bar| bar.accesskit_node().numeric_value()).collect();
        for value in &values {
            assert!(
                program.says(&format!("Drawing 100\u{a0}000 times: {value} %")),
                "{}",
                program.text()
            );
        }
        told.extend(values);
    }
    panic!("{}", program.text());
}

#[test]
fn a_simulation_takes_a_share_of_each_frame_and_tells_how_far_it_is() {
    let told = progress(at_the_start_of_a_simulation(1.0 / 60.0));
    assert_eq!(told, (1..20).map(|batches| f64::from(batches * 5)).collect::<Vec<_>>());
    // Where frames take a quarter of a second, five batches fit into the share of one.
    let told = progress(at_the_start_of_a_simulation(0.25));
    assert_eq!(told.last(), Some(&75.0), "{told:?}");
    assert!(told.len() <= 4, "{told:?}");
}

/// What was pasted from a log.
#[test]
fn a_sigma_and_a_unit_typed_behind_the_value_fill_all_three() {
    let mut program = Program::new();
    program.mug();
    program.type_into(D, "50 ± 0.5 px");
    assert!(program.says("1.400 ± 0.014 m") || program.says("± 0.014"), "{}", program.text());
    program.harness.key_press(egui::Key::Tab);
    program.harness.run();
    assert_eq!(program.value(D), "50");
    assert_eq!(program.value("Uncertainty of Disparity (d)"), "0.5");
    program.type_into(B, "10 ± 0.05 cm");
    program.harness.key_press(egui::Key::Tab);
    program.harness.run();
    assert_eq!((program.value(B).as_str(), program.unit(B).as_str()), ("10", "cm"));
    assert_eq!(program.value("Uncertainty of Camera baseline (b)"), "0.05");
}
