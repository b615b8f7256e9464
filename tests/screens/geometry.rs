//! Range, tilt and ground plane.

use crate::program::Program;
use egui::accesskit::Role;
use egui_kittest::kittest::Queryable as _;

#[test]
fn depth_and_range_differ_away_from_the_middle() {
    let mut program = Program::new();
    program.mug();
    program.press("Range, tilt, ground plane");
    for (field, value) in [
        ("Principal point cx", "0"),
        ("Column of the pixel (u)", "700"),
        ("Row of the pixel (v)", "0"),
    ] {
        program.type_into(field, value);
    }
    // The row of the principal point is asked for twice, here and for the ground plane: one value.
    let rows: Vec<_> = program
        .harness
        .get_all_by_role_and_label(Role::NumberInput, "Principal point cy")
        .collect();
    rows[0].focus();
    drop(rows);
    program.harness.run();
    program.harness.event(egui::Event::Text("0".into()));
    program.harness.run();
    // 45° off the axis: R = √2 · Z.
    assert!(program.says("1.980 m"), "{}", program.text());
}
