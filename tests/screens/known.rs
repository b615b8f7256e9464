//! What is known of cameras and objects: by their names, and by what a data sheet states.

use crate::program::{B, D, FX, Program, W_IMG, W_REAL};
use egui_kittest::kittest::Queryable as _;

const CARD: &str = "Bank or ID card, long side. (85.6 ± 0.1) mm. ISO/IEC 7810, ID-1";

/// The figures of a person with a bank card, 310 px wide at 700 px.
#[test]
fn a_bank_card_is_found_by_typing_and_gives_a_distance() {
    let mut program = Program::new();
    program.type_into(FX, "700");
    program.type_into(W_IMG, "310");
    program.press("Known sizes…");
    assert!(program.says("21 of 21"));
    program.type_into("Search the known sizes", "id card long");
    assert!(program.says("1 of 21"));
    program.press(CARD);
    assert_eq!(program.value(W_REAL), "85.6");
    assert_eq!(program.value(&format!("Uncertainty of {W_REAL}")), "0.1");
    assert!(program.says("193.3") || program.says("0.1933"), "{}", program.text());
    assert!(program.says("Bank or ID card, long side is filled in, from: ISO/IEC 7810, ID-1."));
    program.press("Undo");
    assert_eq!(program.value(W_REAL), "");
}

#[test]
fn a_person_is_measured_from_top_to_bottom_and_a_ball_across() {
    let mut program = Program::new();
    for (size, group) in [("woman", "Height"), ("tennis", "Diameter of ball"), ("euro coin", "Width")] {
        program.press("Known sizes…");
        program.type_into("Search the known sizes", size);
        program.harness.key_press(egui::Key::Enter);
        program.harness.run();
        assert_eq!(
            program.chosen("Measured").as_deref(),
            Some(format!("Measured: {group}").as_str()),
            "{size}"
        );
    }
    program.press("Known sizes…");
    program.type_into("Search the known sizes", "unicorn");
    assert!(program.says("None of 21 has all these words."));
    program.press("Cancel");
    program.press("Known sizes…");
    assert!(program.says("21 of 21"), "what was searched is forgotten");
}

#[test]
fn a_known_camera_gives_a_distance_in_one_step_and_is_kept() {
    let mut program = Program::new();
    program.type_into(D, "20");
    program.press("From lens, FOV or Q…");
    program.press("Known cameras…");
    program.type_into("Search the known cameras", "d435i 640x480");
    program.harness.key_press(egui::Key::Enter);
    program.harness.run();
    assert_eq!((program.value(FX), program.value(B)), ("378.806".to_owned(), "49.864".to_owned()));
    assert!(program.says("0.9444 m"), "{}", program.text());
    program.show("Rigs");
    assert!(program.says("RealSense D435i, 49.864 mm · 378.806 px"), "{}", program.text());
    program.press("Add a known camera…");
    program.type_into("Search the known cameras", "kitti");
    program.harness.key_press(egui::Key::Enter);
    program.harness.run();
    assert!(program.says("537.166 mm · 718.856 px"), "{}", program.text());
}

/// Logitech's webcam, whose diagonal view is 78°.
#[test]
fn what_is_stated_of_a_camera_says_everything_else() {
    let mut program = Program::new();
    program.press("From lens, FOV or Q…");
    program.press("Camera facts…");
    program.type_into("Width of the image", "1920");
    program.type_into("Height of the image", "1080");
    program.type_into("Diagonal field of view", "78");
    program.press("Use fx = 1360.18 px");
    assert_eq!(program.value(FX), "1360.18190022");
    program.press("From lens, FOV or Q…");
    program.press("Camera facts…");
    assert_eq!(program.value("Diagonal field of view"), "78", "what was typed is there again");
    program.type_into("Horizontal field of view", "60");
    assert!(
        program.says("These exclude one another") && program.says("fx follows Horizontal field of view"),
        "{}",
        program.text()
    );
    program.press("Clear");
    assert_eq!(program.value("Width of the image"), "");
    assert!(!program.says("exclude one another"));
}

#[test]
fn what_comes_from_a_data_sheet_takes_the_place_of_an_older_fy_and_of_a_lens() {
    let mut program = Program::new();
    program.radio("Measured: Height");
    program.type_into("Focal length along the columns (fy)", "900");
    program.press("From lens, FOV or Q…");
    program.press("Camera facts…");
    for (field, text) in [
        ("Width of the image", "1000"),
        ("Height of the image", "800"),
        ("Focal length of the lens", "50"),
        ("In focus at", "0.55"),
        ("Pixel pitch", "5"),
    ] {
        program.type_into(field, text);
    }
    // The image is sharp 55 mm behind the lens.
    program.press("Use fx = 11\u{2009}000.0 px");
    assert_eq!(program.value("Focal length along the columns (fy)"), "");
    assert!(
        !program.has_input("Lens that fx came from"),
        "the whole distance to the image is in fx"
    );
}

#[test]
fn what_follows_leads_back_also_under_water() {
    let mut program = Program::new();
    program.press("From lens, FOV or Q…");
    program.press("Camera facts…");
    program.type_into("Width of the image", "1280");
    program.type_into("Height of the image", "720");
    program.type_into("Horizontal field of view", "90");
    program.press("Where the camera is: Under water");
    let placeholder = |program: &Program, name: &str| {
        let field = program.harness.get_by_label(name);
        let node = egui_kittest::kittest::NodeT::accesskit_node(&field).data().clone();
        node.placeholder().map(str::to_owned)
    };
    assert_eq!(placeholder(&program, "Focal length fx").as_deref(), Some("640"));
    program.type_into("Focal length fx", "640");
    assert!(!program.says("exclude one another"), "{}", program.text());
    program.press("Use fx = 853.120 px");
}

#[test]
fn escape_closes_each_dialog_and_a_search_is_forgotten() {
    let mut program = Program::new();
    let opens: [&[&str]; 3] = [
        &["Known sizes…"],
        &["From lens, FOV or Q…", "Known cameras…"],
        &["From lens, FOV or Q…", "Camera facts…"],
    ];
    for path in opens {
        for _ in 0..2 {
            path.iter().for_each(|name| program.press(name));
            assert!(program.harness.query_by_role(egui::accesskit::Role::Dialog).is_some(), "{path:?}");
            for search in ["Search the known sizes", "Search the known cameras"] {
                if program.harness.query_by_label(search).is_some() {
                    assert_eq!(program.value(search), "");
                    assert_eq!(program.focused(), search);
                    program.type_into(search, "zed");
                }
            }
            program.harness.key_press(egui::Key::Escape);
            program.harness.run();
            program.harness.run_steps(2);
            assert!(program.harness.query_by_role(egui::accesskit::Role::Dialog).is_none(), "{path:?}");
        }
    }
}

#[test]
fn a_correction_in_a_dialog_leads_back_to_its_field() {
    let mut program = Program::new();
    program.press("From lens, FOV or Q…");
    program.press("Camera facts…");
    program.type_into("Horizontal field of view", "1.2");
    program.press("Use 1.2 rad");
    assert_eq!(program.focused(), "Horizontal field of view");
}

#[test]
fn a_lens_goes_with_the_focal_length_that_came_from_it() {
    let mut program = Program::new();
    program.press("From lens, FOV or Q…");
    program.press("Camera facts…");
    for (field, text) in [
        ("Width of the image", "1600"),
        ("Height of the image", "800"),
        ("Focal length of the lens", "8"),
        ("Width of the sensor", "9.6"),
        ("Height of the sensor", "7.2"),
    ] {
        program.type_into(field, text);
    }
    assert!(program.says("it has 1200 rows, of which the image has 800"), "{}", program.text());
    program.press("Use fx = 1333.33 px");
    assert_eq!(program.value("Lens that fx came from"), "8");
}

#[test]
fn a_rig_says_what_its_focal_length_sees_and_takes_what_a_data_sheet_states() {
    let mut program = Program::new();
    program.show("Rigs");
    program.press("New rig");
    program.type_into("Width of the image", "1280");
    program.type_into("Height of the image", "720");
    program.type_into(FX, "640");
    program.press("Camera facts…");
    let view = program.harness.get_by_label("Horizontal field of view");
    assert_eq!(egui_kittest::kittest::NodeT::accesskit_node(&view).data().placeholder(), Some("90"));
    program.type_into("Focal length fx", "");
    program.type_into("Vertical field of view", "60");
    program.press("Use fx = 623.538 px");
    assert_eq!(program.value(FX), "623.538290725");
    assert_eq!(program.value("Source"), "Vertical field of view 60°");
    program.press("Undo");
    assert_eq!((program.value(FX), program.value("Source")), ("640".to_owned(), String::new()));
    program.press("Calculator");
    program.press("From lens, FOV or Q…");
    program.press("Camera facts…");
    assert_eq!(program.value("Vertical field of view"), "", "that of a rig is its own");
}

#[test]
fn another_mode_of_the_sensor_stands_beside_the_first() {
    let mut program = Program::new();
    program.show("Rigs");
    program.press("New rig");
    program.press("Another mode…");
    assert!(program.says("Fill in the width and the height of the image and fx of the rig first."));
    program.press("Cancel");
    for (field, text) in [("Width of the image", "1280"), ("Height of the image", "800"), (FX, "631.343")] {
        program.type_into(field, text);
    }
    program.press("Another mode…");
    program.type_into("Width after resizing or binning", "768");
    program.type_into("Width of the part that is kept", "800");
    assert!(
        program.says("The part that is kept reaches out of the resized image"),
        "{}",
        program.text()
    );
    program.type_into("Width of the part that is kept", "640");
    assert!(program.says("fx: 631.343 → 378.806 px"), "{}", program.text());
    program.press("Add as another rig");
    assert_eq!(program.value(FX), "378.8058");
    assert!(program.says("Rig without a name, 640 × 480"), "{}", program.text());
}
