//! The program under test, used by accessible name.

use crate::machine::Machine;
use depth_calculator::app::App;
use egui::accesskit::Role;
use egui::{Key, Modifiers, Vec2, vec2};
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use egui_kittest::{Harness, HarnessBuilder};

pub const DESKTOP: Vec2 = vec2(1280.0, 900.0);
pub const PHONE: Vec2 = vec2(390.0, 844.0);

pub struct Program {
    pub harness: Harness<'static, App>,
    pub machine: Machine,
}

impl Program {
    pub fn on(machine: Machine, size: Vec2) -> Self {
        Self::build(machine, Harness::builder().with_size(size))
    }

    pub fn build(machine: Machine, builder: HarnessBuilder<App>) -> Self {
        let platform = machine.clone();
        let mut harness = builder
            // A simulation goes on for twenty frames.
            .with_max_steps(30)
            .build_eframe(move |cc| App::new(cc, Box::new(platform)));
        harness.run();
        Self { harness, machine }
    }

    pub fn new() -> Self {
        Self::on(Machine::default(), DESKTOP)
    }

    /// The field of this name that is typed into.
    pub fn input<'a>(&'a self, name: &'a str) -> egui_kittest::Node<'a> {
        self.harness
            .get_all_by_label(name)
            .find(|node| matches!(node.accesskit_node().role(), Role::NumberInput | Role::TextInput))
            .unwrap()
    }

    pub fn type_into(&mut self, field: &str, text: &str) {
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

    pub fn value(&self, field: &str) -> String {
        self.input(field).value().unwrap_or_default()
    }

    pub fn unit(&self, field: &str) -> String {
        self.harness
            .get_by_role_and_label(Role::ComboBox, &format!("Unit of {field}"))
            .value()
            .unwrap_or_default()
    }

    pub fn press(&mut self, button: &str) {
        self.harness.get_by_label(button).scroll_to_me();
        self.harness.run();
        // A dialog that has grown is put in the middle in the frame after.
        self.harness.run_steps(2);
        self.harness.get_by_label(button).click();
        self.harness.run();
    }

    pub fn choose(&mut self, combo: &str, option: &str) {
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
    pub fn text(&self) -> String {
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

    pub fn says(&self, what: &str) -> bool {
        self.text().contains(what)
    }

    /// The value in the row `name` of a table of names and values.
    pub fn cell(&self, table: &str, name: &str) -> String {
        let table = self.harness.get_by_role_and_label(Role::Table, table);
        let texts = table.children_recursive().filter_map(|node| {
            let node = node.accesskit_node();
            node.value().or_else(|| node.label()).filter(|text| !text.is_empty())
        });
        let texts: Vec<String> = texts.collect();
        let behind = texts.iter().skip_while(|text| *text != name).find(|text| *text != name);
        behind.cloned().unwrap_or_default()
    }

    pub fn focused(&self) -> String {
        self.harness
            .root()
            .children_recursive()
            .find(|node| node.is_focused())
            .and_then(|node| node.accesskit_node().label())
            .unwrap_or_default()
    }

    pub fn mug(&mut self) {
        self.type_into(FX, "700");
        self.type_into(B, "100");
        self.type_into(D, "50");
    }

    /// The mug by both methods, each with a σ: 1.400 m and 1.447 m, 1.442 m combined.
    pub fn two_distances(&mut self) {
        self.mug();
        self.type_into(W_IMG, "150");
        self.type_into(W_REAL, "0.31");
        self.press("Add uncertainty");
        type_sigma(self, D, "2");
        type_sigma(self, W_IMG, "2");
    }
}

pub const FX: &str = "Focal length (fx)";
pub const B: &str = "Camera baseline (b)";
pub const D: &str = "Disparity (d)";
pub const W_IMG: &str = "Object width in image (w_img)";
pub const W_REAL: &str = "Object real width (w_real)";

/// Types one standard deviation beside a field.
pub fn type_sigma(program: &mut Program, field: &str, text: &str) {
    let name = format!("Uncertainty of {field}");
    program.harness.get_by_label(&name).scroll_to_me();
    program.harness.run();
    program.harness.get_by_label(&name).focus();
    program.harness.run();
    program.harness.get_by_label(&name).type_text(text);
    program.harness.run();
}
