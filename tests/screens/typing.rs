//! Typing: it goes into the field that was meant, however fast, and nothing moves meanwhile.

use crate::machine::Machine;
use crate::program::{B, D, DESKTOP, FX, PHONE, Program, W_IMG, W_REAL, type_sigma};
use egui::accesskit::{Action, ActionRequest, Role, TreeId};
use egui::{Event, Key, Modifiers, PointerButton, Pos2, Rect, Shape, Vec2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use std::collections::BTreeMap;

const FIELDS: [&str; 5] = [FX, B, D, W_IMG, W_REAL];

fn click(at: Pos2) -> Vec<Event> {
    let button = |pressed| Event::PointerButton {
        pos: at,
        button: PointerButton::Primary,
        pressed,
        modifiers: Modifiers::NONE,
    };
    vec![Event::PointerMoved(at), button(true), button(false)]
}

fn typed(text: &str) -> Vec<Event> {
    text.chars().map(|letter| Event::Text(letter.to_string())).collect()
}

fn key(key: Key) -> Event {
    Event::Key {
        key,
        physical_key: None,
        pressed: true,
        repeat: false,
        modifiers: Modifiers::NONE,
    }
}

/// Gives the program events all at once, as in a frame that takes long.
fn at_once(program: &mut Program, events: Vec<Event>) {
    program.harness.input_mut().events.extend(events);
    program.harness.run();
}

fn values(program: &Program) -> [String; 5] {
    FIELDS.map(|name| program.value(name))
}

#[test]
fn clicks_and_keys_of_one_frame_fill_the_fields_that_were_clicked() {
    let mut program = Program::new();
    let texts = ["1,000", "0.1", "abc", "150", "0.30"];
    // From below as well: what is drawn first takes what is typed first.
    for order in [[0, 1, 2, 3, 4], [4, 3, 2, 1, 0], [2, 0, 4, 1, 3]] {
        program.press("Reset");
        let events = order.iter().flat_map(|&index: &usize| {
            let at = program.input(FIELDS[index]).rect().center();
            [click(at), typed(texts[index])].concat()
        });
        let events = events.collect();
        at_once(&mut program, events);
        assert_eq!(values(&program), texts, "{order:?}");
    }
}

#[test]
fn keys_behind_tab_and_requests_of_one_frame_are_for_the_field_that_got_the_focus() {
    let mut program = Program::new();
    let fx = program.input(FX).rect().center();
    let tab = || vec![key(Key::Tab)];
    let events = [click(fx), typed("700"), tab(), typed("2"), tab(), typed("100")];
    at_once(&mut program, events.concat());
    assert_eq!((program.value(FX).as_str(), program.value(B).as_str()), ("700", "100"));
    assert_eq!(program.value(&format!("Uncertainty of {FX}")), "2");
    let focus = |program: &Program, name| {
        let (target_node, _) = program.input(name).accesskit_node().locate();
        vec![Event::AccessKitActionRequest(ActionRequest {
            action: Action::Focus,
            target_tree: TreeId::ROOT,
            target_node,
            data: None,
        })]
    };
    let events = [
        typed("5"),
        focus(&program, D),
        typed("50"),
        focus(&program, W_IMG),
        typed("150"),
        focus(&program, FX),
    ];
    at_once(&mut program, [events.concat(), typed("1")].concat());
    assert_eq!(program.value(D), "50");
    assert_eq!(program.value(W_IMG), "150");
    assert_eq!(program.focused(), FX);
}

#[test]
fn enter_calculates_with_what_was_typed_before_it_and_what_follows_goes_where_it_leads() {
    let mut program = Program::new();
    let d = program.input(D).rect().center();
    at_once(&mut program, [click(d), typed("50"), vec![key(Key::Enter)], typed("700")].concat());
    assert_eq!((program.value(D).as_str(), program.value(FX).as_str()), ("50", "700"));
}

/// Where each part of the form is that can be used.
fn places(program: &Program) -> BTreeMap<String, Rect> {
    let form = program.harness.get_by_role_and_label(Role::Form, "Inputs");
    let parts = form.children_recursive().filter(|node| {
        let role = node.accesskit_node().role();
        // Corrections belong to the notes.
        let is_fix = node
            .accesskit_node()
            .label()
            .is_some_and(|name| name.starts_with("Use ") || name.starts_with("Multiply "));
        !is_fix
            && matches!(
                role,
                Role::NumberInput | Role::TextInput | Role::Button | Role::ComboBox | Role::Heading
            )
    });
    parts
        .map(|node| {
            (
                format!("{:?} {:?}", node.accesskit_node().role(), node.accesskit_node().label()),
                node.rect(),
            )
        })
        .collect()
}

#[test]
fn no_note_moves_anything_in_the_form() {
    for size in [vec2(1280.0, 1400.0), vec2(390.0, 2600.0)] {
        let mut program = Program::on(Machine::default(), size);
        let before = places(&program);
        assert!(before.len() > 15, "{before:?}");
        for name in FIELDS {
            for text in ["1", "1,000", "abc", "0.1", "-5", "1e999", "7 parsec", ""] {
                program.type_into(name, text);
                assert_eq!(places(&program), before, "{text:?} in {name}, {size}");
            }
            type_sigma(&mut program, name, "many");
            program.type_into(name, "abc");
            assert_eq!(places(&program), before, "a value and its uncertainty in {name}, {size}");
        }
        program.press("Calculate Distance");
        assert_eq!(places(&program), before, "marked, {size}");
    }
}

/// Everything that the last frame painted in letters.
fn painted(program: &Program) -> Vec<String> {
    fn add(shape: &Shape, texts: &mut Vec<String>) {
        match shape {
            Shape::Text(text) => {
                let lines = text
                    .galley
                    .rows
                    .iter()
                    .map(|row| row.glyphs.iter().map(|glyph| glyph.chr).collect::<String>());
                texts.push(lines.map(|line| line.trim_end().to_owned()).collect::<Vec<_>>().join(" "));
            }
            Shape::Vec(shapes) => shapes.iter().for_each(|shape| add(shape, texts)),
            _ => {}
        }
    }
    let mut texts = Vec::new();
    program
        .harness
        .output()
        .shapes
        .iter()
        .for_each(|clipped| add(&clipped.shape, &mut texts));
    texts
}

fn paints(program: &Program, words: &str) -> bool {
    painted(program).iter().any(|text| text == words)
}

#[test]
fn a_note_that_is_too_long_for_its_line_is_shown_whole_while_its_field_is_used_or_pointed_at() {
    const WHOLE: &str = "“abc” is not a number. Type a number above zero, such as 700 px.";
    for size in [DESKTOP, PHONE] {
        let mut program = Program::on(Machine::default(), size);
        program.type_into(FX, "abc");
        assert!(paints(&program, WHOLE), "{size}: {:?}", painted(&program));
        program.input(D).focus();
        program.harness.run();
        assert!(!paints(&program, WHOLE), "{size}");
        assert!(
            painted(&program).iter().any(|text| text == "“abc” is not a number"),
            "{size}: {:?}",
            painted(&program)
        );
        let at = program.harness.get_by_label(WHOLE).rect().center();
        program.harness.event(Event::PointerMoved(at));
        program.harness.run();
        assert!(paints(&program, WHOLE), "{size}");
        at_once(&mut program, click(at));
        assert_eq!(program.focused(), FX, "a click on the note is one on its field");
    }
}

#[test]
fn a_note_at_a_value_and_one_at_its_uncertainty_are_both_said_always_and_shown_while_the_field_is_used() {
    let mut program = Program::new();
    program.type_into(FX, "abc");
    type_sigma(&mut program, FX, "many");
    let value = "“abc” is not a number. Type a number above zero, such as 700 px.";
    let descriptions = |program: &Program, name: &str| {
        let node = program.harness.get_by_label(name);
        let node = node.accesskit_node();
        node.data().described_by().to_vec()
    };
    for is_used in [true, false] {
        assert_eq!(paints(&program, value), is_used);
        assert!(program.says(value) && program.says("“many”"), "{}", program.text());
        let sigma = descriptions(&program, &format!("Uncertainty of {FX}"));
        let (said, _) = program.harness.get_by_label_contains("“many”").accesskit_node().locate();
        assert_eq!(sigma.len(), 1);
        assert!(format!("{said:?}").contains(&sigma[0].0.to_string()), "{said:?} {sigma:?}");
        program.input(W_REAL).focus();
        program.harness.run();
    }
}

#[test]
fn tab_goes_from_a_field_to_its_corrections_and_enter_takes_one() {
    let mut program = Program::new();
    program.type_into(FX, "1,000");
    for name in [&*format!("Uncertainty of {FX}"), "Use 1000", "Use 1.000"] {
        program.harness.key_press(Key::Tab);
        program.harness.run();
        assert_eq!(program.focused(), name);
    }
    program.harness.key_press(Key::Tab);
    program.harness.run();
    assert_eq!(program.focused(), B);
    assert!(program.harness.query_by_label("Use 1.000").is_none(), "the card is closed");
    program.input(FX).focus();
    program.harness.run();
    for _ in 0..2 {
        program.harness.key_press(Key::Tab);
        program.harness.run();
    }
    program.harness.key_press(Key::Enter);
    program.harness.run();
    assert_eq!((program.value(FX).as_str(), program.focused().as_str()), ("1000", FX));
}

#[test]
fn corrections_are_taken_by_mouse_and_the_rest_of_the_card_is_no_obstacle() {
    for size in [DESKTOP, vec2(390.0, 1400.0)] {
        let mut program = Program::on(Machine::default(), size);
        program.type_into(FX, "1,000");
        let next = program.input(B).rect();
        let fix = program.harness.get_by_label("Use 1000").rect();
        at_once(&mut program, click(next.right_center() - vec2(20.0, 0.0)));
        assert_eq!(program.focused(), B, "{size}: a click beside {fix:?} on the card");
        program.input(FX).focus();
        program.harness.run_steps(4);
        let fix = program.harness.get_by_label("Use 1000").rect().center();
        at_once(&mut program, click(fix));
        assert_eq!(program.value(FX), "1000", "{size}");
    }
}

#[test]
fn who_clicks_where_a_card_is_just_opening_means_the_field_below_it() {
    let mut program = Program::new();
    program.type_into(FX, "1,000");
    let fix: Vec2 = program.harness.get_by_label("Use 1000").rect().center().to_vec2();
    let next = program.input(B).rect();
    program.press("Reset");
    let fx = program.input(FX).rect().center();
    let at = fix.to_pos2();
    at_once(
        &mut program,
        [click(fx), typed("1,000"), click(Pos2::new(at.x, next.center().y)), typed("100")].concat(),
    );
    assert_eq!((program.value(FX).as_str(), program.value(B).as_str()), ("1,000", "100"));
}

#[test]
fn a_correction_takes_a_click_only_when_somebody_can_have_seen_it() {
    // Each frame takes longer than a correction waits, once it is on the screen.
    let outcome = |frames_seen: usize| {
        let builder = egui_kittest::Harness::builder().with_size(DESKTOP).with_step_dt(0.5);
        let mut program = Program::build(Machine::default(), builder);
        let fx = program.input(FX).rect().center();
        program.harness.input_mut().events.extend([click(fx), typed("1,000")].concat());
        while program.harness.query_by_label("Use 1000").is_none() {
            program.harness.step();
        }
        let fix = program.harness.get_by_label("Use 1000").rect();
        assert!(fix.intersects(program.input(B).rect()), "it lies over the next field");
        for _ in 0..frames_seen {
            program.harness.step();
        }
        // Nor does a browser's Tab stop at it before.
        let is_stop = program
            .harness
            .get_by_label("Use 1000")
            .accesskit_node()
            .data()
            .supports_action(Action::Focus);
        assert_eq!(is_stop, frames_seen > 0);
        let both = fix.intersect(program.input(B).rect()).center();
        at_once(&mut program, [click(both), typed("100")].concat());
        [program.value(FX), program.value(B)]
    };
    assert_eq!(outcome(0), ["1,000", "100"]);
    assert_eq!(outcome(2), ["1000100", ""]);
}

#[test]
fn a_click_counts_however_slow_the_frames_are() {
    let builder = egui_kittest::Harness::builder().with_size(DESKTOP).with_step_dt(3.0);
    let mut program = Program::build(Machine::default(), builder);
    program.type_into(FX, "700");
    let pos = program.harness.get_by_label("Reset").rect().center();
    program.harness.event(Event::PointerMoved(pos));
    program.harness.step();
    for pressed in [true, false] {
        program.harness.event(Event::PointerButton {
            pos,
            button: PointerButton::Primary,
            pressed,
            modifiers: Modifiers::NONE,
        });
        program.harness.step();
    }
    program.harness.step();
    assert_eq!(program.value(FX), "");
}
