//! What the program says about itself.

use crate::machine::Machine;
use crate::program::{DESKTOP, PHONE, Program};
use depth_calculator::app::Licenses;
use egui::accesskit::Role;
use egui::{Key, vec2};
use egui_kittest::kittest::Queryable as _;

#[test]
fn about_tells_version_and_licenses_and_closes_with_escape() {
    for size in [DESKTOP, PHONE] {
        let machine = Machine {
            commit: Some("0123456789abcdef"),
            ..Machine::default()
        };
        let mut program = Program::on(machine, size);
        program.press("Keys");
        program.press("About Depth Calculator");
        assert!(program.says(&format!("Version {}, commit 0123456789abcdef.", env!("CARGO_PKG_VERSION"))));
        assert!(program.says("MIT") && program.says("Apache") && program.says("Inter") && program.says("DejaVu"));
        assert!(!program.says("Step ten times as far"), "one dialog at a time");
        let link = program
            .harness
            .get_by_role_and_label(Role::Link, "Licenses of the fonts and of every library in it");
        assert!(link.rect().left() >= 0.0 && link.rect().right() <= size.x);
        link.click();
        program.harness.step();
        let opened = program
            .harness
            .output()
            .platform_output
            .commands
            .iter()
            .find_map(|command| match command {
                egui::OutputCommand::OpenUrl(opened) => Some(opened.url.clone()),
                _ => None,
            });
        assert_eq!(opened.as_deref(), Some("licenses.html"));
        program.harness.key_press(Key::Escape);
        program.harness.run();
        assert!(!program.says("commit 0123456789abcdef"));
        assert!(program.harness.query_by_label("Keys").is_some());
    }
}

#[test]
fn about_is_at_the_end_of_the_explanations_too_and_its_button_closes_it() {
    let mut program = Program::new();
    program.press("Learn");
    program.press("About Depth Calculator");
    assert!(program.says("built from source, commit unknown"));
    program.press("Close");
    assert!(!program.says("commit unknown"));
}

#[test]
fn a_long_text_of_licenses_is_shown_by_pages() {
    let text: String = (1..=9000).map(|line| format!("Line {line}.\n")).collect();
    let machine = Machine {
        licenses: Some(Licenses::Text(text.leak())),
        ..Machine::default()
    };
    let mut program = Program::on(machine, PHONE);
    program.press("Keys");
    program.press("About Depth Calculator");
    assert!(program.harness.query_by_role_and_label(Role::Region, "Licenses").is_some());
    assert!(
        program.says("Line 1.") && !program.says("Line 200."),
        "only what is in sight is laid out"
    );
    program.harness.key_press(Key::PageDown);
    program.harness.run();
    assert!(!program.says("Line 1.\n") && program.says("Line 30."));
    program.harness.key_press(Key::End);
    program.harness.run();
    assert!(program.says("Line 9000."));
    program.harness.key_press(Key::Home);
    program.harness.run();
    assert!(program.says("Line 1.\n"));
}

#[test]
fn about_fits_into_every_window_whatever_it_shows_of_the_licenses() {
    for size in [vec2(360.0, 480.0), PHONE, DESKTOP] {
        for licenses in [
            Licenses::Page("licenses.html"),
            Licenses::Text("A very long line. ".repeat(20).leak()),
        ] {
            let machine = Machine {
                licenses: Some(licenses),
                ..Machine::default()
            };
            let mut program = Program::on(machine, size);
            program.press("Keys");
            program.press("About Depth Calculator");
            let top = program
                .harness
                .get_by_role_and_label(Role::Heading, "About Depth Calculator")
                .rect();
            let close = program.harness.get_by_label("Close").rect();
            assert!(top.top() >= 0.0 && top.left() >= 0.0, "{size}: {top:?}");
            assert!(close.bottom() <= size.y && close.right() <= size.x, "{size}: {close:?}");
        }
    }
}
