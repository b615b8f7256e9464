//! The screens, driven by accessible name as a screen reader would.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    missing_docs,
    reason = "tests"
)]

use depth_calculator::app::{App, Licenses, Platform};
use egui::accesskit::Role;
use egui::{Key, Modifiers, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use std::cell::{Cell, RefCell};
use std::rc::Rc;

/// A machine whose storage and clipboard can be looked at.
#[derive(Clone, Default)]
struct Machine {
    stored: Rc<RefCell<Option<String>>>,
    /// What has been set aside, and whether there is room for more.
    set_aside: Rc<RefCell<Vec<String>>>,
    is_full: Rc<Cell<bool>>,
    clipboard: Rc<RefCell<Option<String>>>,
    copied: Rc<RefCell<Option<Result<(), String>>>>,
    link: Rc<RefCell<Option<String>>>,
    broken: bool,
    commit: Option<&'static str>,
    licenses: Option<Licenses>,
}

impl Platform for Machine {
    fn load(&self) -> Result<Option<String>, String> {
        if self.broken {
            Err("Storage is switched off.".into())
        } else {
            Ok(self.stored.borrow().clone())
        }
    }
    fn save(&mut self, text: &str) -> Result<(), String> {
        if self.broken {
            return Err("Storage is switched off.".into());
        }
        *self.stored.borrow_mut() = Some(text.to_owned());
        Ok(())
    }
    fn set_aside(&mut self) -> Result<Option<String>, String> {
        if self.broken || self.is_full.get() {
            return Err("Storage is full.".into());
        }
        self.set_aside.borrow_mut().extend(self.stored.take());
        Ok(Some("on the shelf".to_owned()))
    }
    fn copy(&mut self, ctx: &egui::Context, text: String) {
        *self.clipboard.borrow_mut() = Some(text);
        *self.copied.borrow_mut() = Some(if self.broken {
            Err("The clipboard was refused.".into())
        } else {
            Ok(())
        });
        ctx.request_repaint();
    }
    fn commit(&self) -> Option<String> {
        self.commit.map(str::to_owned)
    }
    fn licenses(&self) -> Licenses {
        self.licenses.unwrap_or(Licenses::Page("licenses.html"))
    }
    fn events(&mut self) -> Vec<depth_calculator::app::Event> {
        use depth_calculator::app::Event;
        let link = self.link.borrow_mut().take().map(Event::Link);
        let copied = self.copied.borrow_mut().take().map(Event::Copied);
        link.into_iter().chain(copied).collect()
    }
}

const DESKTOP: Vec2 = vec2(1280.0, 900.0);
const PHONE: Vec2 = vec2(390.0, 844.0);

struct Program {
    harness: Harness<'static, App>,
    machine: Machine,
}

impl Program {
    fn on(machine: Machine, size: Vec2) -> Self {
        let platform = machine.clone();
        let mut harness = Harness::builder()
            .with_size(size)
            // A simulation goes on for twenty frames.
            .with_max_steps(30)
            .build_eframe(move |cc| App::new(cc, Box::new(platform)));
        harness.run();
        Self { harness, machine }
    }

    fn new() -> Self {
        Self::on(Machine::default(), DESKTOP)
    }

    /// The field of this name that is typed into.
    fn input<'a>(&'a self, name: &'a str) -> egui_kittest::Node<'a> {
        self.harness
            .get_all_by_label(name)
            .find(|node| matches!(node.accesskit_node().role(), Role::NumberInput | Role::TextInput))
            .unwrap()
    }

    fn type_into(&mut self, field: &str, text: &str) {
        self.input(field).focus();
        self.harness.run();
        self.harness.key_press_modifiers(Modifiers::COMMAND, Key::A);
        self.harness.run();
        if text.is_empty() {
            self.harness.key_press(Key::Backspace);
        } else {
            self.input(field).type_text(text);
        }
        self.harness.run();
    }

    fn value(&self, field: &str) -> String {
        self.harness
            .get_by_role_and_label(Role::NumberInput, field)
            .value()
            .unwrap_or_default()
    }

    fn unit(&self, field: &str) -> String {
        self.harness
            .get_by_role_and_label(Role::ComboBox, &format!("Unit of {field}"))
            .value()
            .unwrap_or_default()
    }

    fn press(&mut self, button: &str) {
        self.harness.get_by_label(button).scroll_to_me();
        self.harness.run();
        self.harness.get_by_label(button).click();
        self.harness.run();
    }

    fn choose(&mut self, combo: &str, option: &str) {
        self.harness.get_by_role_and_label(Role::ComboBox, combo).scroll_to_me();
        self.harness.run();
        self.harness.get_by_role_and_label(Role::ComboBox, combo).click();
        self.harness.run();
        self.harness
            .get_all_by_label_contains(option)
            .find(|node| node.accesskit_node().role() == Role::Button)
            .unwrap()
            .click();
        self.harness.run();
    }

    /// Everything that can be read on the screen.
    fn text(&self) -> String {
        let mut said = String::new();
        for node in self.harness.root().children_recursive() {
            let node = node.accesskit_node();
            for text in [node.label(), node.value(), node.description()].into_iter().flatten() {
                said.push_str(&text);
                said.push('\n');
            }
        }
        said
    }

    fn says(&self, what: &str) -> bool {
        self.text().contains(what)
    }

    fn focused(&self) -> String {
        self.harness
            .root()
            .children_recursive()
            .find(|node| node.is_focused())
            .and_then(|node| node.accesskit_node().label())
            .unwrap_or_default()
    }

    fn mug(&mut self) {
        self.type_into(FX, "700");
        self.type_into(B, "100");
        self.type_into(D, "50");
    }
}

const FX: &str = "Focal length (fx)";
const B: &str = "Camera baseline (b)";
const D: &str = "Disparity (d)";
const W_IMG: &str = "Object width in image (w_img)";
const W_REAL: &str = "Object real width (w_real)";

#[test]
fn typing_the_mug_gives_its_distance_without_pressing_anything() {
    let mut program = Program::new();
    assert!(program.says("–.– m"));
    program.mug();
    assert!(program.says("1.400 m"), "{}", program.text());
    assert!(program.says("1.373 … 1.429 m"));
    assert!(program.says("D = 700 px · 0.1 m / 50 px = 1.400 m"));
}

#[test]
fn the_doorway_button_gives_its_distance_and_can_be_undone() {
    let mut program = Program::new();
    program.type_into(FX, "123");
    program.press("Doorway (monocular)");
    assert!(program.says("4.275 m"));
    assert_eq!(program.value(FX), "950");
    program.press("Undo");
    assert_eq!(program.value(FX), "123");
    assert_eq!(program.value(W_IMG), "");
}

#[test]
fn both_results_are_shown_as_soon_as_both_can_be_had() {
    let mut program = Program::new();
    program.mug();
    assert!(program.harness.query_by_role_and_label(Role::Region, "Monocular").is_none());
    program.type_into(W_IMG, "150");
    program.type_into(W_REAL, "0,3");
    assert!(program.harness.query_by_role_and_label(Role::Region, "Stereo").is_some());
    assert!(program.harness.query_by_role_and_label(Role::Region, "Monocular").is_some());
    assert!(program.says("agree with what you entered"));
}

#[test]
fn a_typed_unit_switches_the_unit_beside_the_field() {
    let mut program = Program::new();
    program.type_into(B, "10 cm");
    assert_eq!(program.unit(B), "cm");
    program.type_into(W_REAL, "4in");
    assert_eq!(
        (program.value(B).as_str(), program.unit(B).as_str()),
        ("10", "cm"),
        "leaving the field tidies it"
    );
    assert_eq!(program.unit(W_REAL), "in");
}

#[test]
fn changing_the_unit_by_hand_keeps_the_number() {
    let mut program = Program::new();
    program.mug();
    program.choose("Unit of Camera baseline (b)", "centimetres");
    assert_eq!(program.value(B), "100");
    assert!(program.says("14.00 m"));
}

#[test]
fn the_unit_of_the_result_can_be_chosen_and_the_table_stays_in_metres() {
    let mut program = Program::new();
    program.mug();
    program.choose("Unit of the results", "millimetres");
    assert!(program.says("1400 mm"));
    assert!(program.says("1373 … 1429 mm"));
    let row = program
        .harness
        .get_by_role_and_label(Role::Table, "Key input parameters and outputs");
    let cells: Vec<_> = row.children_recursive().filter_map(|node| node.value()).collect();
    assert!(cells.iter().any(|cell| cell == "1.400"), "{cells:?}");
}

#[test]
fn arrows_step_a_field_and_shift_ten_times() {
    let mut program = Program::new();
    program.type_into(D, "50");
    program.harness.key_press(Key::ArrowUp);
    program.harness.run();
    assert_eq!(program.value(D), "51");
    program.harness.key_press_modifiers(Modifiers::SHIFT, Key::ArrowDown);
    program.harness.run();
    assert_eq!(program.value(D), "41");
}

#[test]
fn an_ambiguous_number_is_asked_about_and_one_click_answers() {
    let mut program = Program::new();
    program.type_into(FX, "1,000");
    assert!(program.says("could mean 1000 or 1.000"));
    program.press("Use 1000");
    assert_eq!(program.value(FX), "1000");
    assert!(!program.says("could mean"));
}

#[test]
fn a_slip_of_the_unit_is_corrected_by_one_click() {
    let mut program = Program::new();
    program.type_into(FX, "700");
    program.type_into(B, "0.1");
    program.type_into(D, "50");
    assert!(program.says("0.001400 m"), "an unusual value is used all the same");
    program.press("Use 0.1 m");
    assert!(program.says("1.400 m"));
    assert_eq!(program.unit(B), "m");
}

#[test]
fn bad_input_is_named_at_its_field_and_the_other_method_stays() {
    let mut program = Program::new();
    program.press("Doorway (monocular)");
    for (text, said) in [
        ("abc", "“abc” is not a number"),
        ("0", "infinitely far away"),
        ("−5", "swapped"),
        ("1e999", "no distance that a computer can represent"),
    ] {
        program.type_into(D, text);
        assert!(program.says(said), "{text}: {}", program.text());
        assert!(program.says("4.275 m"));
        assert!(!program.says("NaN") && !program.says("inf "));
    }
}

#[test]
fn calculate_marks_what_is_missing_and_goes_to_the_first_problem() {
    let mut program = Program::new();
    program.press("Calculate Distance");
    assert_eq!(program.focused(), FX);
    program.type_into(D, "50");
    program.harness.key_press(Key::Enter);
    program.harness.run();
    assert_eq!(program.focused(), FX);
    assert!(program.says("The focal length is missing for the stereo distance."));
    assert!(program.says("The baseline is missing for the stereo distance."));
    assert!(
        !program.says("The real width is missing"),
        "a method that was not touched is no problem"
    );
}

#[test]
fn reset_clears_everything_and_can_be_undone_and_redone() {
    let mut program = Program::new();
    program.mug();
    program.press("Reset");
    assert_eq!(program.value(D), "");
    assert!(program.says("–.– m"));
    program.press("Undo");
    assert!(program.says("1.400 m"));
    program.press("Redo");
    assert_eq!(program.value(D), "");
}

#[test]
fn copy_puts_the_report_on_the_clipboard_and_says_so() {
    let mut program = Program::new();
    program.mug();
    program.press("Copy Results");
    let copied = program.machine.clipboard.borrow().clone().unwrap();
    assert!(
        copied.contains("Camera baseline (b): 100 mm") && copied.contains("1.400 m (unrounded 1.4 m)"),
        "{copied}"
    );
    assert!(program.says("Results copied"));
}

#[test]
fn a_refused_clipboard_and_a_blocked_storage_are_said() {
    let mut program = Program::on(
        Machine {
            broken: true,
            ..Machine::default()
        },
        DESKTOP,
    );
    assert!(program.says("Storage is switched off."));
    program.mug();
    assert!(program.says("1.400 m"));
    program.press("Copy Results");
    assert!(program.says("The clipboard was refused."));
}

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

#[test]
fn what_was_entered_survives_a_restart() {
    let machine = Machine::default();
    let mut program = Program::on(machine.clone(), DESKTOP);
    program.mug();
    program.choose("Unit of the results", "feet");
    let again = Program::on(machine, DESKTOP);
    assert_eq!(
        (again.value(FX).as_str(), again.value(B).as_str(), again.value(D).as_str()),
        ("700", "100", "50")
    );
    assert!(again.says("4.593 ft"));
}

#[test]
fn a_corrupt_or_older_state_starts_fresh_and_says_so() {
    for text in ["{\"version\":0}", "not json", "{\"version\":1,\"inputs\":{\"focal_length\":7}}"] {
        let machine = Machine::default();
        *machine.stored.borrow_mut() = Some(text.to_owned());
        let program = Program::on(machine, DESKTOP);
        assert!(program.says("starts fresh"), "{text}");
        assert_eq!(program.value(FX), "");
    }
}

#[test]
fn a_followed_link_sets_only_what_it_names_and_can_be_undone() {
    let machine = Machine::default();
    let mut program = Program::on(machine.clone(), DESKTOP);
    program.mug();
    *machine.link.borrow_mut() = Some("#d=25".into());
    program.harness.run();
    assert!(program.says("2.800 m"));
    program.press("Undo");
    assert!(program.says("1.400 m"));
}

#[test]
fn dragging_the_point_on_the_curve_changes_the_disparity_in_one_undo_step() {
    let mut program = Program::new();
    program.mug();
    let from = program.harness.get_by_role(Role::Slider).rect().center();
    program.harness.drag_at(from);
    program.harness.run();
    for step in 1..=4 {
        program
            .harness
            .hover_at(from + vec2(15.0 * f32::from(u8::try_from(step).unwrap()), 0.0));
        program.harness.run();
    }
    program.harness.drop_at(from + vec2(60.0, 0.0));
    program.harness.run();
    let dragged: f64 = program.value(D).parse().unwrap();
    assert!(dragged > 55.0, "{dragged}");
    program.harness.key_press_modifiers(Modifiers::COMMAND, Key::Z);
    program.harness.run();
    assert_eq!(program.value(D), "50");
}

#[test]
fn the_point_on_the_curve_follows_the_arrow_keys() {
    let mut program = Program::new();
    program.mug();
    program.harness.get_by_role(Role::Slider).focus();
    program.harness.run();
    program.harness.key_press(Key::ArrowRight);
    program.harness.run();
    assert_eq!(program.value(D), "51");
}

#[test]
fn the_table_has_nine_rows_and_a_header() {
    let program = Program::new();
    let table = program
        .harness
        .get_by_role_and_label(Role::Table, "Key input parameters and outputs");
    let roles: Vec<Role> = table.children_recursive().map(|node| node.accesskit_node().role()).collect();
    assert_eq!(roles.iter().filter(|&&role| role == Role::Row).count(), 10);
    assert_eq!(roles.iter().filter(|&&role| role == Role::ColumnHeader).count(), 4);
    assert_eq!(roles.iter().filter(|&&role| role == Role::RowHeader).count(), 9);
}

#[test]
fn pictures_explain_themselves_when_empty_and_carry_their_numbers_when_full() {
    let mut program = Program::new();
    for said in [
        "both methods side by side",
        "once focal length and baseline are known",
        "as soon as a distance is known",
    ] {
        assert!(program.says(said), "{said}");
    }
    program.mug();
    assert!(program.says("Stereo distance 1.400 m, Monocular distance –.– m"));
    assert!(program.says("At 50 px the distance is 1.400 m"));
    assert!(program.says("drawn midway between the cameras"));
}

#[test]
fn learn_loads_the_examples() {
    for (link, distance) in [("coffee mug", "1.400 m"), ("doorway", "4.275 m")] {
        let mut program = Program::new();
        program.press("Learn");
        program.press(&format!("Load the {link} into the calculator"));
        assert!(program.says(distance), "{link}");
    }
}

#[test]
fn an_example_of_the_explanations_sets_only_what_it_names_and_can_be_undone() {
    let mut program = Program::new();
    program.mug();
    program.press("Learn");
    program.press("Load the doorway into the calculator");
    assert_eq!((program.value(FX), program.value(B)), ("950".to_owned(), "100".to_owned()));
    assert!(program.says("4.275 m") && program.says("1.900 m"));
    program.press("Undo");
    assert_eq!((program.value(FX), program.value(W_IMG)), ("700".to_owned(), String::new()));
}

#[test]
fn what_stands_below_is_read_and_reached_after_what_stands_above() {
    let mut program = Program::on(Machine::default(), PHONE);
    program.mug();
    program.press("Reset");
    let read: Vec<String> = program
        .harness
        .root()
        .children_recursive()
        .filter_map(|node| node.accesskit_node().label().or_else(|| node.accesskit_node().value()))
        .collect();
    let place = |words: &str| read.iter().rposition(|said| said == words).unwrap();
    assert!(place("Calculate Distance") < place("All fields are cleared."));
    assert!(place("All fields are cleared.") < place("Undo"));
    assert!(place("Undo") < place("Close") && place("Close") < read.len() - 1, "{read:?}");
    // Tab goes the same way.
    program.harness.get_by_label("Close").focus();
    program.harness.run();
    program.harness.key_press_modifiers(egui::Modifiers::SHIFT, egui::Key::Tab);
    program.harness.run();
    assert!(program.harness.get_by_label("Undo").is_focused());
}

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
            assert!(rect.height() >= 40.0 && rect.width() >= 40.0, "{role:?} {name:?} is {rect:?}");
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

/// Types one standard deviation beside a field.
fn type_sigma(program: &mut Program, field: &str, text: &str) {
    let name = format!("Uncertainty of {field}");
    program.harness.get_by_label(&name).scroll_to_me();
    program.harness.run();
    program.harness.get_by_label(&name).focus();
    program.harness.run();
    program.harness.get_by_label(&name).type_text(text);
    program.harness.run();
}

fn mug_with_uncertainty() -> Program {
    let mut program = Program::new();
    program.mug();
    program.press("Add uncertainty");
    for (field, sigma) in [(FX, "2"), (B, "0.5"), (D, "0.5")] {
        type_sigma(&mut program, field, sigma);
    }
    program
}

#[test]
fn a_newcomer_sees_no_uncertainty() {
    let mut program = Program::new();
    program.mug();
    assert!(program.harness.query_by_label_contains("Uncertainty of").is_none());
    assert!(!program.says("±") && !program.says("variance"));
}

#[test]
fn the_mug_with_uncertainty_reads_as_in_the_specification() {
    let mut program = mug_with_uncertainty();
    assert!(program.says("1.400 m ± 0.016"), "{}", program.text());
    assert!(program.says("1.384 … 1.416 m · mostly from disparity (75 %)"));
    assert!(program.says("Shares of the variance: disparity 75 %, baseline 19 %, focal length 6 %."));
    program.type_into(W_IMG, "150");
    program.type_into(W_REAL, "0.30");
    type_sigma(&mut program, W_IMG, "2");
    type_sigma(&mut program, W_REAL, "0.01");
    assert!(program.says("1.400 m ± 0.050") && program.says("1.350 … 1.451 m"));
    assert!(program.says("1.400 m ± 0.015") && program.says("They agree"));
}

#[test]
fn hiding_uncertainty_keeps_what_was_typed() {
    let mut program = mug_with_uncertainty();
    program.press("Hide uncertainty");
    assert!(!program.says("± 0.016"));
    program.press("Add uncertainty");
    assert!(program.says("1.400 m ± 0.016"));
}

#[test]
fn a_bad_uncertainty_is_named_and_the_distance_stays() {
    let mut program = Program::new();
    program.mug();
    program.press("Add uncertainty");
    type_sigma(&mut program, D, "-1");
    assert!(program.says("is negative, which an uncertainty cannot be"));
    assert!(program.says("1.400 m"));
}

#[test]
fn typical_matching_errors_are_offered_with_their_source() {
    let mut program = Program::new();
    program.mug();
    program.press("Add uncertainty");
    program.choose("Typical matching errors", "± 0.25 px");
    assert!(program.says("mostly from disparity (100 %)"));
}

#[test]
fn where_first_order_fails_a_simulation_stands_beside_it() {
    let mut program = Program::new();
    program.mug();
    program.type_into(D, "1");
    program.press("Add uncertainty");
    type_sigma(&mut program, D, "0.8");
    program.harness.run_steps(30);
    assert!(program.says("known to worse than 10 %"));
    assert!(program.says("100000 draws"), "{}", program.text());
    // About one draw in nine has no positive disparity.
    assert!(program.says("11 %") && program.says("no upper bound"));
}

#[test]
fn one_distance_can_be_solved_for_any_input() {
    let mut program = Program::new();
    program.type_into(FX, "700");
    program.type_into(B, "100");
    program.press("Solve for another quantity");
    program.type_into("Distance (D)", "1.4");
    assert!(program.says("50.00 px"), "{}", program.text());
    program.choose("Solve for", "Distance (D)");
    assert!(program.harness.query_by_role_and_label(Role::NumberInput, "Distance (D)").is_none());
}

#[test]
fn a_raw_value_of_opencv_becomes_a_disparity() {
    let mut program = Program::new();
    program.press("OpenCV ×16, doffs…");
    program.choose("What is known", "OpenCV StereoBM or StereoSGBM");
    program.type_into("Stored value", "-16");
    program.type_into("minDisparity", "0");
    assert!(program.says("found nothing"));
    program.type_into("Stored value", "800");
    program.press("Use d = 50.0000 px");
    assert_eq!(program.value(D), "50");
}

#[test]
fn a_q_matrix_fills_in_camera_and_rig_once_its_unit_is_told() {
    let mut program = Program::new();
    program.press("from lens, FOV or Q…");
    program.choose("What is known", "A Q matrix");
    program.harness.get_by_label("Q matrix").focus();
    program.harness.run();
    program
        .harness
        .get_by_label("Q matrix")
        .type_text("[[1. 0. 0. -610.] [0. 1. 0. -350.] [0. 0. 0. 700.] [0. 0. 0.01 0.4]]");
    program.harness.run();
    assert!(program.says("carries no unit"));
    program.press("100.000 mm");
    assert_eq!(
        (program.value(FX), program.value(B), program.unit(B)),
        ("700".into(), "100".into(), "mm".into())
    );
    assert_eq!(program.value("Principal point offset (doffs)"), "40");
    program.type_into(D, "50");
    assert!(program.says("0.7778 m"), "{}", program.text());
}

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

#[test]
fn the_question_mark_lists_the_keys() {
    let mut program = Program::new();
    program.press("Learn");
    program.harness.event(egui::Event::Text("?".into()));
    program.harness.run();
    assert!(program.says("Step ten times as far"));
    program.harness.key_press(Key::Escape);
    program.harness.run();
    assert!(!program.says("Step ten times as far"));
}

#[test]
fn focus_out_of_sight_is_scrolled_into_view() {
    let mut program = Program::on(Machine::default(), PHONE);
    program.harness.get_by_label("Copy Results").focus();
    program.harness.run();
    let rect = program.harness.get_by_label("Copy Results").rect();
    assert!(rect.bottom() < PHONE.y - 60.0, "{rect:?}");
}

/// The rings of the focus that the last frame drew, around what.
fn rings(program: &Program) -> Vec<egui::Rect> {
    let shapes = program.harness.output().shapes.iter();
    shapes
        .filter_map(|clipped| match &clipped.shape {
            egui::Shape::Rect(shape) if shape.stroke.width == 2.0 && shape.fill == egui::Color32::TRANSPARENT => Some(shape.rect),
            _ => None,
        })
        .collect()
}

#[test]
fn whatever_has_the_keyboard_shows_a_ring() {
    let mut program = Program::new();
    program.mug();
    for name in [
        "Learn",
        "Keys",
        "Light or dark",
        "from lens, FOV or Q…",
        "Calculate Distance",
        "Reset",
        "Coffee mug (stereo)",
        "Add uncertainty",
    ] {
        program.harness.get_by_label(name).focus();
        program.harness.run();
        let around = program.harness.get_by_label(name).rect();
        assert!(
            rings(&program)
                .iter()
                .any(|ring| ring.contains_rect(around) && around.expand(4.0).contains_rect(*ring)),
            "{name}"
        );
    }
    program.harness.input_mut().focused = false;
    program.harness.run();
    assert_eq!(rings(&program), [], "something else in the window has the keyboard");
    program.harness.input_mut().focused = true;
    program.harness.key_press(Key::Escape);
    program.harness.run();
    assert_eq!(rings(&program), [], "nothing has the keyboard");
}

#[test]
fn an_error_makes_nothing_else_in_the_form_another_thing() {
    let mut program = Program::new();
    program.mug();
    let ids = |program: &Program| -> Vec<egui::accesskit::NodeId> {
        let headings = ["Stereo", "Monocular"].map(|name| program.harness.get_by_role_and_label(Role::Heading, name));
        let labels = [B, D, "Reset", "Coffee mug (stereo)"].map(|name| program.harness.get_all_by_label(name).next().unwrap());
        let all = headings.iter().chain(&labels);
        all.map(|node| node.accesskit_node().locate().0).collect()
    };
    let before = ids(&program);
    program.type_into(FX, "seven");
    let field = program.harness.get_by_role_and_label(Role::NumberInput, FX);
    assert!(field.accesskit_node().data().invalid().is_some());
    assert_eq!(ids(&program), before);
}

#[test]
fn assistive_technology_sets_the_point_on_the_curve() {
    let mut program = Program::new();
    program.mug();
    let slider = program.harness.get_by_role(Role::Slider);
    let node = slider.accesskit_node();
    assert_eq!((node.min_numeric_value(), node.max_numeric_value()), (Some(0.0), Some(100.0)));
    let request = egui::accesskit::ActionRequest {
        action: egui::accesskit::Action::SetValue,
        target_tree: egui::accesskit::TreeId::ROOT,
        target_node: node.locate().0,
        data: Some(egui::accesskit::ActionData::NumericValue(70.0)),
    };
    program.harness.event(egui::Event::AccessKitActionRequest(request));
    program.harness.run();
    assert_eq!(program.value(D), "70");
    assert!(program.says("1.000 m"));
}

#[test]
fn units_are_said_and_not_only_painted() {
    let mut program = Program::new();
    program.press("from lens, FOV or Q…");
    let description = |program: &Program, name: &str| {
        let field = program.harness.get_by_role_and_label(Role::NumberInput, name);
        field.accesskit_node().data().description().unwrap_or_default().to_owned()
    };
    assert_eq!(description(&program, "Focal length of the lens"), "In millimeters.");
    assert_eq!(description(&program, "Pixel pitch"), "In micrometers.");
    assert!(description(&program, D).contains("In pixels."));
}

#[test]
fn a_mistake_in_a_helper_is_said_at_its_field() {
    let mut program = Program::new();
    program.press("from lens, FOV or Q…");
    program.type_into("Pixel pitch", "three");
    let field = program.harness.get_by_role_and_label(Role::NumberInput, "Pixel pitch");
    let data = field.accesskit_node();
    assert!(data.data().invalid().is_some());
    assert_eq!(data.data().described_by().len(), 1);
    let note = program.harness.get_by_label("⚠ Type one number with a decimal point or comma.");
    assert_eq!(note.accesskit_node().live(), egui::accesskit::Live::Polite);
}

#[test]
fn what_can_be_below_zero_is_not_given_a_keyboard_without_minus() {
    let mut program = Program::new();
    program.press("OpenCV ×16, doffs…");
    let field = program.harness.get_by_label("x in the right image");
    assert_eq!(field.accesskit_node().role(), Role::TextInput);
}

#[test]
fn a_state_that_cannot_be_read_is_set_aside_and_its_place_is_named() {
    let machine = Machine::default();
    *machine.stored.borrow_mut() = Some("{\"version\":999}".into());
    let mut program = Program::on(machine.clone(), DESKTOP);
    assert!(program.says("starts fresh. The old text is kept on the shelf."));
    program.mug();
    assert_eq!(*machine.set_aside.borrow(), ["{\"version\":999}"]);
    assert!(machine.stored.borrow().as_deref().unwrap().contains("700"));
}

#[test]
fn a_state_that_cannot_be_set_aside_is_not_overwritten_either() {
    let machine = Machine::default();
    *machine.stored.borrow_mut() = Some("{\"version\":999}".into());
    machine.is_full.set(true);
    let mut program = Program::on(machine.clone(), DESKTOP);
    assert!(program.says("starts fresh. Storage is full. The program works, but forgets"));
    program.mug();
    assert_eq!(machine.stored.borrow().as_deref(), Some("{\"version\":999}"));

    machine.is_full.set(false);
    program.type_into(D, "100");
    assert!(program.says("The old text is kept on the shelf."));
    assert_eq!(*machine.set_aside.borrow(), ["{\"version\":999}"]);
    assert!(machine.stored.borrow().as_deref().unwrap().contains("700"));
}
