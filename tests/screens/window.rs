//! Windows of every width, light and dark, and how little the program does in them.

use crate::machine::Machine;
use crate::program::{PHONE, Program, W_IMG};
use depth_text::report::strip::Mode;
use egui::accesskit::{Action, Role};
use egui::{Key, Modifiers, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};

#[test]
fn on_a_phone_the_result_stays_in_sight_and_targets_fit_a_finger() {
    let mut program = Program::on(Machine::default(), PHONE);
    program.mug();
    let bottom = program
        .harness
        .get_all_by_value("1.400 m")
        .map(|node| node.rect())
        .find(|rect| rect.bottom() > 780.0 && rect.bottom() <= PHONE.y);
    assert!(bottom.is_some(), "the bar at the bottom shows the result");
    for node in program.harness.root().children_recursive() {
        let role = node.accesskit_node().role();
        if matches!(role, Role::Button | Role::ComboBox | Role::NumberInput | Role::Tab | Role::Slider) {
            let rect = node.rect();
            let name = node.accesskit_node().label();
            // A link at the end of a label has the height of its line: 24 at least (WCAG 2.2, 2.5.8).
            let is_link = name
                .as_deref()
                .is_some_and(|name| name.ends_with('…') || name == "Save report (HTML)");
            let least = if is_link { 24.0 } else { 40.0 };
            assert!(rect.height() >= least && rect.width() >= 40.0, "{role:?} {name:?} is {rect:?}");
            assert!(rect.left() >= 0.0 && rect.right() <= PHONE.x, "{name:?} is cut off: {rect:?}");
        }
    }
}

#[test]
fn nothing_is_cut_off_at_any_width() {
    for width in [360.0, 390.0, 768.0, 1079.0, 1280.0, 1920.0, 2560.0] {
        let mut program = Program::on(Machine::default(), vec2(width, 900.0));
        program.mug();
        program.type_into(W_IMG, "1,000");
        for node in program.harness.root().children_recursive() {
            if node.accesskit_node().raw_bounds().is_none() {
                continue;
            }
            let rect = node.rect();
            let name = node.accesskit_node().label().or_else(|| node.value());
            assert!(rect.left() >= -0.5 && rect.right() <= width + 0.5, "at {width}: {name:?} {rect:?}");
        }
    }
}

/// The texts of the screen, and where they are. What is pressed by a finger is larger than its text, and may reach into a line beside it.
fn texts(program: &Program) -> Vec<(String, egui::Rect)> {
    let mut texts = Vec::new();
    for node in program.harness.root().children_recursive() {
        let inner = node.accesskit_node();
        let text = inner.label().or_else(|| node.value()).unwrap_or_default();
        let is_text = matches!(inner.role(), Role::Label | Role::Heading | Role::Link) || text == "Save report (HTML)";
        if is_text && !text.is_empty() && inner.raw_bounds().is_some() {
            texts.push((text, node.rect().shrink(1.0)));
        }
    }
    texts.retain(|(_, rect)| rect.is_positive());
    texts
}

#[test]
fn no_text_lies_on_another() {
    for width in [360.0, 768.0, 1280.0] {
        for mode in Mode::ALL {
            // As high as all that is there: what scrolls lies below the bar.
            let mut program = Program::on(Machine::default(), vec2(width, 4000.0));
            program.two_distances();
            program.ask(mode.name());
            let texts = texts(&program);
            for (index, (text, rect)) in texts.iter().enumerate() {
                for (other, place) in texts.iter().skip(index + 1) {
                    let is_inside = rect.contains_rect(*place) || place.contains_rect(*rect);
                    assert!(
                        is_inside || !rect.intersects(*place),
                        "{mode:?} at {width}: {text:?} {rect:?} and {other:?} {place:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn the_theme_can_be_switched() {
    let mut program = Program::new();
    for (choice, dark) in [("Dark", true), ("Light", false)] {
        program.press("Light or dark");
        program.harness.get_by_label(choice).click();
        program.harness.run();
        assert_eq!(program.harness.ctx.global_style().visuals.dark_mode, dark, "{choice}");
    }
}

#[test]
fn nothing_is_computed_while_nothing_happens() {
    let mut program = Program::new();
    program.mug();
    program.harness.run();
    assert!(
        !program.harness.ctx.has_requested_repaint(),
        "{:?}",
        program.harness.ctx.repaint_causes()
    );
}

#[test]
fn everything_is_within_the_narrowest_and_lowest_windows() {
    for size in [vec2(320.0, 640.0), vec2(320.0, 256.0), vec2(320.0, 200.0), vec2(640.0, 400.0)] {
        for screen in ["Calculator", "Rigs", "Learn"] {
            let mut program = Program::on(Machine::default(), size);
            let keys = [("Rigs", Key::Num2), ("Learn", Key::Num3)];
            if let Some((_, key)) = keys.into_iter().find(|(name, _)| *name == screen) {
                program.harness.key_press_modifiers(Modifiers::ALT, key);
                program.harness.run();
            }
            let wide: Vec<String> = program
                .harness
                .root()
                .children_recursive()
                .filter(|node| node.accesskit_node().data().supports_action(Action::Focus))
                .filter(|node| node.rect().left() < 0.0 || node.rect().right() > size.x)
                .map(|node| format!("{:?} {:?}", node.accesskit_node().label(), node.rect()))
                .collect();
            assert!(wide.is_empty(), "{screen} in {size}: {wide:#?}");
        }
    }
}

#[test]
fn what_gets_the_focus_is_whole_in_a_low_window() {
    for size in [vec2(320.0, 256.0), vec2(320.0, 200.0), vec2(640.0, 400.0)] {
        let mut program = Program::on(Machine::default(), size);
        let mut hidden = Vec::new();
        for _ in 0..50 {
            program.harness.key_press(Key::Tab);
            program.harness.run();
            let root = program.harness.root();
            let Some(node) = root.children_recursive().find(|node| node.is_focused()) else {
                continue;
            };
            let rect = node.rect();
            if rect.top() < 0.0 || rect.bottom() > size.y || rect.left() < 0.0 || rect.right() > size.x {
                hidden.push(format!("{:?} {rect:?}", node.accesskit_node().label()));
            }
        }
        assert!(hidden.is_empty(), "{size}: {hidden:#?}");
    }
}
