//! What leaves the program as a file, and the report.

use crate::machine::Machine;
use crate::program::{DESKTOP, Program};
use depth_calculator::app::FileContents;
use egui::accesskit::Role;
use egui::{Color32, ColorImage, Event, Key, Modifiers, PointerButton, ViewportCommand, vec2};
use egui_kittest::kittest::Queryable as _;
use std::sync::Arc;

const CURVE: &str = "Distance against disparity";
/// Whatever is not the chart.
const WINDOW: Color32 = Color32::RED;

/// Lets the program run until it has asked for a picture of the window, and gives it one. Returns whether a menu was open then.
fn give_picture(program: &mut Program) -> Option<bool> {
    for _ in 0..60 {
        program.harness.step();
        let commands = program
            .harness
            .output()
            .viewport_output
            .values()
            .flat_map(|viewport| viewport.commands.clone());
        let asked: Vec<_> = commands
            .filter_map(|command| match command {
                ViewportCommand::Screenshot(callback) => Some(callback),
                _ => None,
            })
            .collect();
        if let Some(callback) = asked.into_iter().next() {
            let shows_menu = program.harness.query_by_label("Save as PNG").is_some();
            let [width, height] = [DESKTOP.x as usize, DESKTOP.y as usize];
            callback.complete(Arc::new(ColorImage::filled([width, height], WINDOW)));
            return Some(shows_menu);
        }
    }
    None
}

fn ask_for_picture(program: &mut Program) {
    ask_for_menu(program);
    program.harness.get_by_label("Save as PNG").click();
}

fn ask_for_menu(program: &mut Program) {
    program.harness.get_by_role_and_label(Role::Image, CURVE).scroll_to_me();
    program.harness.run();
    // Beside the point that can be moved, which may be in the middle.
    let pos = program.harness.get_by_role_and_label(Role::Image, CURVE).rect().center() + vec2(100.0, 40.0);
    right_click(program, pos);
}

fn right_click(program: &mut Program, pos: egui::Pos2) {
    program.harness.hover_at(pos);
    program.harness.run();
    for pressed in [true, false] {
        program.harness.event(Event::PointerButton {
            pos,
            button: PointerButton::Secondary,
            pressed,
            modifiers: Modifiers::NONE,
        });
    }
    program.harness.run();
}

#[test]
fn a_chart_has_its_menu_on_the_points_that_can_be_moved_too() {
    let mut program = Program::new();
    program.two_distances();
    let count = program.harness.get_all_by_role(Role::Slider).count();
    assert!(count >= 3, "a point on the curve, the object and a camera in the top view");
    for index in 0..count {
        let point = |program: &Program| {
            program
                .harness
                .get_all_by_role(Role::Slider)
                .nth(index)
                .map(|node| node.rect().center())
        };
        program.harness.get_all_by_role(Role::Slider).nth(index).unwrap().scroll_to_me();
        program.harness.run();
        let pos = point(&program).unwrap();
        right_click(&mut program, pos);
        assert!(program.harness.query_by_label("Save as PNG").is_some(), "at {pos:?}");
        program.harness.key_press(Key::Escape);
        program.harness.run();
    }
}

#[test]
fn the_menu_key_opens_the_menu_of_a_chart_and_the_focus_goes_into_it_and_back() {
    let mut program = Program::new();
    program.two_distances();
    for point in ["Disparity of the point, in pixels", "Data cursor: Stereo against monocular"] {
        program.harness.get_by_role_and_label(Role::Slider, point).scroll_to_me();
        program.harness.get_by_role_and_label(Role::Slider, point).focus();
        program.harness.run();
        program.harness.key_press_modifiers(Modifiers::SHIFT, Key::F10);
        program.harness.run();
        assert!(program.harness.query_by_label("Save as PNG").is_some(), "{point}");
        assert_eq!(program.focused(), "Save as PNG");
        program.harness.key_press(Key::Escape);
        program.harness.run();
        assert!(program.harness.query_by_label("Save as PNG").is_none());
        assert_eq!(program.focused(), point);
    }
    program.harness.key_press_modifiers(Modifiers::SHIFT, Key::F10);
    program.harness.run();
    program.harness.key_press(Key::Enter);
    assert_eq!(give_picture(&mut program), Some(false));
    // Opened by the pointer, it takes the focus from nothing.
    program.harness.run();
    ask_for_menu(&mut program);
    assert!(program.harness.query_by_label("Save as PNG").is_some());
    assert_ne!(program.focused(), "Save as PNG");
}

#[test]
fn a_chart_is_saved_as_large_as_it_is_drawn_and_without_its_menu() {
    let mut program = Program::new();
    program.mug();
    ask_for_picture(&mut program);
    assert_eq!(give_picture(&mut program), Some(false), "asked for, with no menu open");
    program.harness.run();
    let drawn = program.harness.get_by_role_and_label(Role::Image, CURVE).rect();
    let files = program.machine.files.borrow().clone();
    let [(name, FileContents::Picture(picture))] = files.as_slice() else {
        panic!("{files:?}");
    };
    assert_eq!(name, "distance-against-disparity.png");
    assert_eq!(picture.size, [drawn.width().round() as usize, drawn.height().round() as usize]);
    assert!(picture.pixels.iter().all(|pixel| *pixel == WINDOW));
    assert!(program.says("Saved in the file distance-against-disparity.png."));
}

#[test]
fn a_window_that_gives_no_picture_is_not_waited_for_for_ever() {
    let mut program = Program::new();
    program.mug();
    ask_for_picture(&mut program);
    program.harness.run_steps(200);
    assert!(program.machine.files.borrow().is_empty());
    assert!(program.says("The window gave no picture of the chart"));
}

#[test]
fn what_cannot_be_saved_is_said() {
    let mut program = Program::on(
        Machine {
            broken: true,
            ..Machine::default()
        },
        DESKTOP,
    );
    program.harness.key_press_modifiers(Modifiers::COMMAND, Key::P);
    program.harness.run();
    assert!(program.says("There is no home folder to store anything in."));
}

/// The report after `prepare`.
fn report(prepare: impl FnOnce(&mut Program)) -> String {
    let mut program = Program::new();
    prepare(&mut program);
    program.harness.key_press_modifiers(Modifiers::COMMAND, Key::P);
    program.harness.run();
    let files = program.machine.files.borrow().clone();
    match files.as_slice() {
        [(name, FileContents::Page(html))] if name == "depth-calculator-report.html" => html.clone(),
        other => panic!("{other:?}"),
    }
}

#[test]
fn the_report_has_the_answer_its_pictures_the_table_and_a_link() {
    let report = report(Program::mug);
    for part in [
        "1.400",
        "Key input parameters and outputs",
        "November 25, 2026",
        "https://example.org/#fx=700&amp;b=100mm&amp;d=50",
        &format!("<title>{CURVE}</title>"),
        "<title>Stereo against monocular</title>",
        "<title>Top view</title>",
    ] {
        assert!(report.contains(part), "{part} is not in {report}");
    }
    assert!(!report.contains("<script"), "{report}");
}

#[test]
fn the_report_of_the_ground_plane_has_all_pictures_of_the_screen() {
    let report = report(|program| {
        program.press("Ground plane");
        program.press("Camera on a mast (ground plane)");
    });
    for title in ["Side view", "In the image", "Top view"] {
        assert!(report.contains(&format!("<title>{title}</title>")), "{title} is not in {report}");
    }
}

#[test]
fn with_nothing_typed_the_report_is_the_form_and_says_what_is_missing() {
    let report = report(|_| {});
    assert!(report.contains("Focal length"), "{report}");
    assert!(!report.contains("<figure>"), "{report}");
}

#[test]
fn where_there_is_paper_the_report_is_printed() {
    let machine = Machine {
        has_paper: true,
        ..Machine::default()
    };
    let mut program = Program::on(machine.clone(), DESKTOP);
    program.harness.key_press_modifiers(Modifiers::COMMAND, Key::P);
    program.harness.run();
    assert_eq!((machine.printed.get(), machine.files.borrow().len()), (1, 0));
}
