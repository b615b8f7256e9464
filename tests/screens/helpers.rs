//! The helpers that turn other numbers into a focal length or a disparity.

use crate::program::{B, D, FX, Program};
use egui::accesskit::Role;
use egui_kittest::kittest::{NodeT as _, Queryable as _};

/// The button for the helper of the disparity.
const HELPER: &str = "OpenCV × 16, doffs…";

#[test]
fn a_raw_value_of_opencv_becomes_a_disparity() {
    let mut program = Program::new();
    program.press(HELPER);
    program.choose("What is known", "OpenCV StereoBM or StereoSGBM");
    program.type_into("Stored value", "-16");
    program.type_into("minDisparity", "0");
    assert!(program.says("found nothing"));
    program.type_into("Stored value", "800");
    program.press("Use d = 50.0000 px");
    assert_eq!(program.value(D), "50");
}

#[test]
fn a_number_of_kitti_becomes_a_disparity_and_says_how_far_away_that_is() {
    let mut program = Program::new();
    program.press(HELPER);
    program.choose("What is known", "KITTI, 16-bit image");
    program.type_into("Stored value", "12345");
    assert!(!program.says("fx and b of the form"), "there are none: {}", program.text());
    program.press("Cancel");
    program.type_into(FX, "700");
    program.type_into(B, "100");
    program.press(HELPER);
    assert!(
        program.says("d = 48.2227 px; with fx and b of the form that is 1.452 m."),
        "{}",
        program.text()
    );
    program.press("Use d = 48.2227 px");
    assert_eq!(program.value(D), "48.22265625");
    assert!(program.says("1.452 m"), "{}", program.text());
}

#[test]
fn a_stored_depth_is_shown_at_once_and_becomes_a_disparity_with_the_cameras_of_the_form() {
    let mut program = Program::new();
    program.press(HELPER);
    program.choose("What is known", "Depth: steps in a meter");
    program.type_into("Stored value", "7000");
    program.choose("Common depth scales", "5000: TUM RGB-D, ICL-NUIM");
    assert_eq!(program.value("Steps in a meter"), "5000");
    assert!(
        program.says("Z = 1.400 m. Fill in the focal length and the baseline to get the disparity that this would be."),
        "{}",
        program.text()
    );
    program.press("Cancel");
    program.type_into(FX, "700");
    program.type_into(B, "100");
    program.press(HELPER);
    assert!(
        program.says("Z = 1.400 m; with fx and b of the form that would be d = 50.0000 px."),
        "{}",
        program.text()
    );
    program.press("Use d = 50.0000 px");
    assert_eq!(program.value(D), "50");
}

#[test]
fn a_network_that_needs_a_focal_length_asks_for_it() {
    let mut program = Program::new();
    program.press(HELPER);
    program.choose("What is known", "Network: Metric3D");
    program.type_into("Output of the network", "2");
    assert!(program.says("Fill in the focal length to get the depth."), "{}", program.text());
    program.press("Cancel");
    program.type_into(FX, "700");
    program.press(HELPER);
    assert!(program.says("Z = 1.400 m. Fill in the baseline to get"), "{}", program.text());
}

#[test]
fn a_file_of_16_bits_that_was_read_with_8_is_named_at_the_stored_value() {
    let mut program = Program::new();
    program.press(HELPER);
    program.choose("What is known", "KITTI, 16-bit image");
    program.type_into("Stored value", "200");
    assert!(program.says("Were 16 bits read as 8? 200 is small for 16"), "{}", program.text());
    // Some pixels are that far away.
    program.press("Use d = 0.781\u{2009}250 px");
    assert_eq!(program.value(D), "0.78125");
}

#[test]
fn the_first_kinect_brings_its_camera() {
    let mut program = Program::new();
    program.type_into(FX, "700");
    program.press(HELPER);
    program.choose("What is known", "doffs as a calibration file gives it");
    program.type_into("doffs", "40");
    program.press("Use doffs = 40.0000 px");
    program.press(HELPER);
    program.choose("What is known", "Kinect, the first one");
    program.type_into("Stored value", "800");
    assert!(program.says("with its own fx and b that is 1.200 m."), "{}", program.text());
    program.press("Use d = 36.2500 px");
    assert_eq!(
        (program.value(FX), program.value(B), program.unit(B), program.value(D)),
        ("580".into(), "75".into(), "mm".into(), "36.25".into())
    );
    assert!(program.says("1.200 m"), "{}", program.text());
}

#[test]
fn a_q_matrix_fills_in_camera_and_rig_once_its_unit_is_told() {
    let mut program = Program::new();
    program.press("From lens, FOV or Q…");
    program.choose("What is known", "A Q matrix");
    program.harness.get_by_label("Q matrix").focus();
    program.harness.run();
    program
        .harness
        .get_by_label("Q matrix")
        .type_text("[[1. 0. 0. -610.] [0. 1. 0. -350.] [0. 0. 0. 700.] [0. 0. 0.01 0.4]]");
    program.harness.run();
    assert!(program.says("carries no unit"));
    program.press("100 mm");
    assert_eq!(
        (program.value(FX), program.value(B), program.unit(B)),
        ("700".into(), "100".into(), "mm".into())
    );
    assert_eq!(program.value("Principal point offset (doffs)"), "40");
    program.type_into(D, "50");
    assert!(program.says("0.7778 m"), "{}", program.text());
}

/// What is in the form can be taken to OpenCV, whatever is in the field for a matrix.
#[test]
fn a_q_matrix_of_the_form_is_copied_in_the_form_of_opencv() {
    let mut program = Program::new();
    program.mug();
    program.press("From lens, FOV or Q…");
    program.choose("What is known", "A Q matrix");
    assert!(program.says("it needs cx and cy"), "{}", program.text());
    program.press("Cancel");
    program.press("Range, tilt, zero point");
    program.type_into("Principal point cx", "640");
    program.type_into("Principal point cy", "360");
    program.press("From lens, FOV or Q…");
    for typed in ["", "1 2 3"] {
        program.harness.get_by_label("Q matrix").focus();
        program.harness.run();
        program.harness.get_by_label("Q matrix").type_text(typed);
        program.harness.run();
        program.machine.clipboard.borrow_mut().take();
        program.press("Copy Q matrix");
        let copied = program.machine.clipboard.borrow().clone().unwrap();
        assert!(
            copied.contains("Q: !!opencv-matrix") && copied.contains("0., 0., 10., 0. ]"),
            "{copied}"
        );
        let q = depth_text::q_matrix::read(&copied).unwrap();
        assert_eq!((q.focal_length.px(), q.baseline, q.cx.px(), q.cy.px()), (700.0, 0.1, 640.0, 360.0));
    }
}

#[test]
fn units_are_said_and_not_only_painted() {
    let mut program = Program::new();
    program.press("From lens, FOV or Q…");
    let description = |program: &Program, name: &str| {
        let field = program.harness.get_by_role_and_label(Role::NumberInput, name);
        field.accesskit_node().data().description().unwrap_or_default().to_owned()
    };
    assert!(description(&program, "Pixel pitch").contains("In micrometers."));
    // Said by the choice beside it.
    assert_eq!(program.unit("Focal length of the lens"), "mm");
    assert!(description(&program, D).contains("In pixels."));
}

#[test]
fn a_mistake_in_a_helper_is_said_at_its_field() {
    let mut program = Program::new();
    program.press("From lens, FOV or Q…");
    program.type_into("Pixel pitch", "three");
    let field = program.harness.get_by_role_and_label(Role::NumberInput, "Pixel pitch");
    let data = field.accesskit_node();
    assert!(data.data().invalid().is_some());
    assert_eq!(data.data().described_by().len(), 1);
    let note = program
        .harness
        .get_by_label("“three” is not a number. Type a number above zero, such as 3 µm.");
    assert_eq!(note.accesskit_node().live(), egui::accesskit::Live::Polite);
}

#[test]
fn what_can_be_below_zero_is_not_given_a_keyboard_without_minus() {
    let mut program = Program::new();
    program.press(HELPER);
    let field = program.harness.get_by_label("x in the right image");
    assert_eq!(field.accesskit_node().role(), Role::TextInput);
}
