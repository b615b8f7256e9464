//! Calibration files and rigs.

use crate::machine::Machine;
use crate::program::{B, D, DESKTOP, FX, Program};
use depth_calculator::app::{FileContents, OpenedFile, PlatformError};
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

pub const MIDDLEBURY: &str =
    "cam0=[700 0 320; 0 701 240; 0 0 1]\ncam1=[700 0 331.5; 0 701 240; 0 0 1]\ndoffs=11.5\nbaseline=100\nwidth=640\nheight=480\n";
pub const OPENCV_IN_SQUARES: &str = "%YAML:1.0\n---\nsquare_size: 25.\nP1: !!opencv-matrix\n   rows: 3\n   cols: 4\n   dt: d\n   data: [ 700., 0., 320., 0., 0., 700., 240., 0., 0., 0., 1., 0. ]\nP2: !!opencv-matrix\n   rows: 3\n   cols: 4\n   dt: d\n   data: [ 700., 0., 320., -2240., 0., 700., 240., 0., 0., 0., 1., 0. ]\n";

pub fn file(name: &str, text: &str) -> OpenedFile {
    OpenedFile {
        name: name.to_owned(),
        bytes: text.as_bytes().to_vec(),
    }
}

/// Opens what the person would choose.
pub fn open(program: &mut Program, chosen: Result<Vec<OpenedFile>, PlatformError>) {
    *program.machine.chosen.borrow_mut() = Some(chosen);
    program.show("Rigs");
    program.press("Calibration file…");
    program.press("Open files…");
    program.harness.run();
}

#[test]
fn a_calibration_is_shown_with_where_each_number_stands_before_anything_changes() {
    let mut program = Program::new();
    program.type_into(FX, "500");
    open(&mut program, Ok(vec![file("calib.txt", MIDDLEBURY)]));
    for said in [
        "calib.txt: a calib.txt of Middlebury",
        "640 × 480 px",
        "100 mm",
        "11.5 px",
        "baseline, line 4",
        "fx: 500 px → 700 px",
    ] {
        assert!(program.says(said), "{said}: {}", program.text());
    }
    program.press("Cancel");
    program.press("Calculator");
    assert_eq!(program.value(FX), "500");
    assert_eq!(program.value(B), "");
}

#[test]
fn the_focus_is_on_the_first_control_of_an_answer() {
    let mut program = Program::new();
    for (text, first) in [
        (MIDDLEBURY, "Camera or pair"),
        ("<!DOCTYPE html>", "Open other files…"),
        (OPENCV_IN_SQUARES, "Camera or pair"),
    ] {
        open(&mut program, Ok(vec![file("calib", text)]));
        assert_eq!(program.focused(), first, "{text}");
        program.press("Cancel");
    }
}

#[test]
fn while_files_are_over_the_window_it_says_that_they_can_be_dropped() {
    let mut program = Program::new();
    let hint = "Drop calibration files, or saved rigs, to read them";
    assert!(!program.says(hint));
    program.harness.input_mut().hovered_files.push(egui::HoveredFile::default());
    // egui draws without end then.
    program.harness.run_steps(3);
    assert!(program.says(hint));
    program.harness.input_mut().hovered_files.clear();
    program.harness.run();
    assert!(!program.says(hint));
}

#[test]
fn what_is_used_is_kept_and_can_be_undone() {
    let mut program = Program::new();
    program.type_into(FX, "500");
    program.type_into(D, "50");
    open(&mut program, Ok(vec![file("calib.txt", MIDDLEBURY)]));
    program.press("Use in calculator");
    assert_eq!((program.value(FX), program.value(B)), ("700".to_owned(), "100".to_owned()));
    assert!(program.says("1.138 m"), "700 · 0.1 / 61.5");
    assert!(program.says("“calib” is filled in."));
    program.press("Undo");
    assert_eq!(program.value(FX), "500");
    program.show("Rigs");
    assert!(
        program.harness.query_by_label_contains("A calib, 100 mm · 700 px").is_some(),
        "{}",
        program.text()
    );
    let again = Program::on(program.machine.clone(), DESKTOP);
    assert!(again.says("A calib, 100 mm · 700 px"), "after a restart");
}

#[test]
fn a_baseline_in_squares_waits_for_their_size() {
    let mut program = Program::new();
    program.type_into(D, "50");
    open(&mut program, Ok(vec![file("stereo.yml", OPENCV_IN_SQUARES)]));
    assert!(program.control("Use in calculator").accesskit_node().is_disabled());
    program.choose("The baseline is", "3.2 squares of the board");
    assert_eq!(program.value("Size of a square of the board"), "25");
    program.press("Use in calculator");
    assert!(program.says("1.120 m"), "700 · 0.08 / 50: {}", program.text());
}

#[test]
fn what_cannot_be_read_or_opened_says_why() {
    let mut program = Program::new();
    open(&mut program, Ok(vec![file("empty.yml", "")]));
    assert!(program.says("Nothing was changed."), "{}", program.text());
    program.press("Cancel");
    open(&mut program, Ok(vec![file("calib.txt", MIDDLEBURY)]));
    *program.machine.chosen.borrow_mut() = Some(Err(PlatformError::FileTooLarge { file: "video.mp4".into() }));
    program.press("Add another file…");
    assert!(program.says("“video.mp4” is larger than 16 MB"));
    assert!(program.says("calib.txt: a calib.txt of Middlebury"), "what was found stays");
    program.press("Use in calculator");
    assert_eq!(program.value(FX), "700");
}

#[test]
fn a_file_whose_other_half_is_elsewhere_takes_it_too() {
    let camera = |tx: f64| {
        format!(
            "image_width: 640\nimage_height: 480\ncamera_matrix: {{rows: 3, cols: 3, data: [700., 0., 320., 0., 700., 240., 0., 0., 1.]}}\ndistortion_model: plumb_bob\ndistortion_coefficients: {{rows: 1, cols: 5, data: [0., 0., 0., 0., 0.]}}\nrectification_matrix: {{rows: 3, cols: 3, data: [1., 0., 0., 0., 1., 0., 0., 0., 1.]}}\nprojection_matrix: {{rows: 3, cols: 4, data: [700., 0., 320., {tx}, 0., 700., 240., 0., 0., 0., 1., 0.]}}\n"
        )
    };
    let mut program = Program::new();
    open(&mut program, Ok(vec![file("left.yaml", &camera(0.0))]));
    *program.machine.chosen.borrow_mut() = Some(Ok(vec![file("right.yaml", &camera(-70.0))]));
    program.press("Add another file…");
    assert!(program.says("left.yaml, right.yaml: "), "{}", program.text());
    assert!(program.says("100 mm"));
}

#[test]
fn what_takes_long_can_be_given_up() {
    let mut program = Program::new();
    program.machine.is_slow.set(true);
    open(&mut program, Ok(vec![file("calib.txt", MIDDLEBURY)]));
    assert!(program.says("Reading calib.txt…"));
    program.press("Cancel");
    program.machine.is_slow.set(false);
    program.harness.run();
    assert!(program.harness.query_by_label_contains("calib.txt").is_none());
    open(&mut program, Ok(vec![file("calib.txt", MIDDLEBURY)]));
    assert!(program.says("calib.txt: a calib.txt of Middlebury"));
}

#[test]
fn rigs_are_typed_compared_removed_and_brought_back() {
    let mut program = Program::new();
    program.show("Rigs");
    program.press("New rig");
    program.type_into("Name", "Robot, front");
    program.type_into(FX, "700");
    program.type_into(B, "-3");
    assert!(program.says("A baseline is a distance and has no sign"), "{}", program.text());
    program.type_into(B, "12 cm");
    program.press("New rig");
    assert!(program.says("A Robot, front, 12 cm · 700 px"), "{}", program.text());
    assert!(program.harness.query_by_role_and_label(Role::Table, "Rigs side by side").is_some());
    program.press("A Robot, front, 12 cm · 700 px");
    program.press("Remove");
    assert!(program.says("“Robot, front” was removed."));
    program.press("Undo");
    assert!(program.says("A Robot, front, 12 cm · 700 px"));
    program.press("Use in calculator");
    assert_eq!((program.value(FX), program.value(B)), ("700".to_owned(), "12".to_owned()));
}

#[test]
fn undo_in_a_field_does_not_bring_the_text_of_a_rig_that_is_gone() {
    let mut program = Program::new();
    program.show("Rigs");
    for name in ["First", "Second"] {
        program.press("New rig");
        program.type_into("Name", name);
    }
    // The second one comes to the place of the first, whose field has been typed into.
    program.press("A First, no numbers yet");
    program.type_into("Name", "First of all");
    program.press("Remove");
    assert_eq!(program.value("Name"), "Second");
    program.input("Name").focus();
    program.harness.run();
    program.harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
    program.harness.run();
    assert_eq!(program.value("Name"), "Second");
}

#[test]
fn a_camera_that_everybody_knows_is_a_rig_with_its_source() {
    let mut program = Program::new();
    program.type_into(D, "20");
    program.show("Rigs");
    program.press("Add a known camera…");
    program.press("RealSense D435i, 640 × 480 px. fx 378.806 px, b 49.864 mm, front glass 4.2 mm in front of zero. One unit: librealsense, unit tests");
    assert_eq!(
        (program.value("Name"), program.value(FX)),
        ("RealSense D435i".to_owned(), "378.806".to_owned())
    );
    assert_eq!(
        (program.value(B), program.value("Width of the image")),
        ("49.864".to_owned(), "640".to_owned())
    );
    assert!(
        program.value("Source").contains("one unit: librealsense"),
        "{}",
        program.value("Source")
    );
    // Distances count from the sensor until somebody says that they count from the glass.
    assert!(program.value("Source").contains("4.2 mm in front"));
    program.press("Use in calculator");
    assert!(program.says("0.9444 m"), "{}", program.text());
}

#[test]
fn six_rigs_are_the_most_and_a_file_of_rigs_brings_them_back() {
    let mut program = Program::new();
    program.show("Rigs");
    for _ in 0..6 {
        program.press("New rig");
    }
    assert!(program.control("New rig").accesskit_node().is_disabled());
    program.type_into("Name", "The last");
    program.press("Save as JSON");
    let files = program.machine.files.borrow().clone();
    let Some((name, FileContents::Data(json))) = files.first() else {
        panic!("{files:?}")
    };
    assert_eq!(name, "depth-calculator-rigs.json");
    let mut other = Program::on(Machine::default(), DESKTOP);
    open(&mut other, Ok(vec![file("anything", json)]));
    assert!(other.says("6 rigs were added."), "{}", other.text());
    assert!(other.says("F The last"));
    open(&mut other, Ok(vec![file("anything", json)]));
    assert!(other.says("No rig was added"));
}

#[test]
fn the_arrow_keys_lead_through_the_rigs_which_are_one_stop_of_tab() {
    let mut program = Program::new();
    program.show("Rigs");
    for _ in 0..3 {
        program.press("New rig");
    }
    let name = |letter: &str| format!("{letter} Rig without a name, no numbers yet");
    program.harness.get_by_label(&name("C")).focus();
    program.harness.run();
    program.harness.key_press(egui::Key::ArrowDown);
    program.harness.run();
    assert!(program.harness.get_by_label(&name("A")).is_focused());
    assert!(program.says("Rig A"));
    program.harness.key_press(egui::Key::ArrowUp);
    program.harness.run();
    assert!(program.harness.get_by_label(&name("C")).is_focused());
}

#[test]
fn undo_of_the_calculator_is_not_at_work_behind_the_rigs() {
    let mut program = Program::new();
    program.mug();
    program.show("Rigs");
    program.harness.key_press_modifiers(egui::Modifiers::COMMAND, egui::Key::Z);
    program.harness.run();
    program.show("Calculator");
    assert_eq!(program.value(FX), "700");
}
