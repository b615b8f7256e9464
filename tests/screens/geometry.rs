//! What refines a distance (range, tilt, zero point), and the ground plane.

use crate::program::{D, FX, Program, W_IMG, W_REAL};

#[test]
fn depth_and_range_differ_away_from_the_middle() {
    let mut program = Program::new();
    program.mug();
    program.press("Range, tilt, zero point");
    for (field, value) in [
        ("Principal point cx", "0"),
        ("Principal point cy", "0"),
        ("Column of the pixel (u)", "700"),
        ("Row of the pixel (v)", "0"),
    ] {
        program.type_into(field, value);
    }
    // 45° off the axis: R = √2 · Z.
    assert_eq!(program.cell("R, range from the lens"), "1.980", "{}", program.text());
    // And back: 1.98 m by tape.
    program.type_into("Range by tape (R)", "1.979899");
    assert_eq!(program.cell("Z, depth along the axis"), "1.400", "{}", program.text());
    // Without a distance the range alone gives it.
    program.type_into(D, "");
    assert_eq!(program.cell("Z, depth along the axis"), "1.400");
}

/// The first error may be in a part that is hidden.
#[test]
fn calculate_goes_to_a_wrong_field_in_a_hidden_part() {
    for (field, text) in [
        ("Tilt of the target", "abc"),
        ("Tilt of the target", "95"),
        ("Range by tape (R)", "5 kg"),
    ] {
        let mut program = Program::new();
        program.mug();
        program.press("Range, tilt, zero point");
        program.type_into(field, text);
        program.press("Range, tilt, zero point");
        assert!(!program.has_input(field));
        program.press("Range, tilt, zero point (filled in)");
        program.press("Range, tilt, zero point");
        program.press("Calculate Distance");
        assert_eq!(program.focused(), field);
    }
}

/// The card shows what both distances say together, named, with σ.
#[test]
fn the_point_is_at_the_combined_distance_where_there_is_one() {
    let mut program = Program::new();
    program.two_distances();
    program.press("Range, tilt, zero point");
    for (field, value) in [
        ("Principal point cx", "640"),
        ("Principal point cy", "360"),
        ("Column of the pixel (u)", "1000"),
        ("Row of the pixel (v)", "360"),
    ] {
        program.type_into(field, value);
    }
    assert_eq!(program.cell("Object distance (D, combined)"), "1.442 ± 0.018");
    assert_eq!(program.cell("R, range from the lens"), "1.621 ± 0.021", "{}", program.text());
}

/// The units that were dropped once: 120 cm were taken for 120 m.
#[test]
fn the_floor_has_units_a_column_and_a_pitch_with_a_sign() {
    let mut program = Program::new();
    program.ask("Ground plane");
    program.type_into(FX, "700");
    for (field, value) in [
        ("Principal point cx", "640"),
        ("Principal point cy", "360"),
        ("Height of the camera", "120 cm"),
        ("Pitch of the camera, downwards", "10"),
        ("Row of the point on the floor", "500"),
    ] {
        program.type_into(field, value);
    }
    assert!(program.says("3.076 m"), "{}", program.text());
    program.type_into("Column of the point on the floor", "1100");
    for words in ["3.740 m", "2.128 m", "3.928 m"] {
        assert!(program.says(words), "{words}: {}", program.text());
    }
    program.type_into("Pitch of the camera, downwards", "-45");
    assert!(program.says("Pitch is counted downwards here"), "{}", program.text());
    program.press("Use 45");
    assert!(!program.says("Pitch is counted downwards here"));
}

#[test]
fn a_tilt_counts_and_is_named_also_when_its_field_is_hidden() {
    let mut program = Program::new();
    program.type_into(FX, "950");
    program.type_into(W_IMG, "200");
    program.type_into(W_REAL, "0.9");
    assert!(program.says("4.275 m"));
    program.press("Range, tilt, zero point");
    program.type_into("Tilt of the target", "60");
    assert!(program.answer("Monocular").contains("2.138 m"), "{}", program.text());
    assert!(program.says("4.275 m"), "what it would be without the tilt: {}", program.text());
    program.press("Range, tilt, zero point");
    assert!(
        program.says("2.138 m") && program.answer("Monocular").contains("cos 60°"),
        "{}",
        program.answer("Monocular")
    );
    assert!(program.says("(filled in)"));
}
