//! The program under test, used by accessible name.

use crate::machine::Machine;
use depth_calculator::app::App;
use egui::accesskit::{Role, Toggled};
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

    /// Asks for something else: one of those in sight, or one of the menu.
    pub fn ask(&mut self, way: &str) {
        if self.harness.query_by_role_and_label(Role::RadioButton, way).is_none() {
            let more = self.harness.get_by_label_contains("More ways").accesskit_node().label();
            self.press(&more.unwrap_or_default());
        }
        self.control(way).scroll_to_me();
        self.harness.run();
        self.control(way).click();
        self.harness.run();
    }

    /// The button, tab or choice of this name.
    pub fn control<'a>(&'a self, name: &'a str) -> egui_kittest::Node<'a> {
        let is_control =
            |node: &egui_kittest::Node<'a>| matches!(node.accesskit_node().role(), Role::RadioButton | Role::Button | Role::Tab);
        self.harness.get_all_by_label(name).find(is_control).unwrap()
    }

    /// Whether there is a field of this name that is typed into.
    pub fn has_input(&self, name: &str) -> bool {
        let mut nodes = self.harness.query_all_by_label(name);
        nodes.any(|node| {
            matches!(
                node.accesskit_node().role(),
                Role::NumberInput | Role::TextInput | Role::SearchInput
            )
        })
    }

    /// The field of this name that is typed into.
    pub fn input<'a>(&'a self, name: &'a str) -> egui_kittest::Node<'a> {
        self.harness
            .get_all_by_label(name)
            .find(|node| {
                matches!(
                    node.accesskit_node().role(),
                    Role::NumberInput | Role::TextInput | Role::SearchInput
                )
            })
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

    /// Shows a screen by its key: a phone has no tabs in sight.
    pub fn show(&mut self, screen: &str) {
        let keys = [("Calculator", Key::Num1), ("Rigs", Key::Num2), ("Learn", Key::Num3)];
        let (_, key) = keys.into_iter().find(|(name, _)| *name == screen).unwrap();
        self.harness.key_press_modifiers(Modifiers::ALT, key);
        self.harness.run();
    }

    pub fn choose(&mut self, combo: &str, option: &str) {
        self.harness.get_by_role_and_label(Role::ComboBox, combo).scroll_to_me();
        self.harness.run();
        self.harness.get_by_role_and_label(Role::ComboBox, combo).click();
        self.harness.run();
        // A long list scrolls.
        self.entry(option).scroll_to_me();
        self.harness.run();
        self.entry(option).click();
        self.harness.run();
    }

    /// The entry of this name in the list that is open.
    fn entry<'a>(&'a self, name: &'a str) -> egui_kittest::Node<'a> {
        let mut named = self.harness.get_all_by_label_contains(name);
        named.find(|node| node.accesskit_node().role() == Role::Button).unwrap()
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

    /// The number in the row `name` of the table, with its σ where it has one: "1.400" or "1.400 ± 0.016".
    pub fn cell(&self, name: &str) -> String {
        let table = self.harness.get_by_role_and_label(Role::Table, "Key input parameters and outputs");
        for row in table.children_recursive().filter(|node| node.accesskit_node().role() == Role::Row) {
            let cells = row.children().map(|cell| texts(&cell).concat()).collect::<Vec<_>>();
            // Behind the name there are the number, its σ where it has one, and the unit.
            if let [first, value, rest @ ..] = cells.as_slice()
                && first == name
            {
                let sigma = rest.first().filter(|text| text.starts_with(|c: char| c.is_ascii_digit()));
                return sigma.map_or_else(|| value.clone(), |sigma| format!("{value} ± {sigma}"));
            }
        }
        String::new()
    }

    /// What the cell `title` of the answer says, from its title to its last line.
    pub fn answer(&self, title: &str) -> String {
        texts(&self.harness.get_by_role_and_label(Role::Region, title)).concat()
    }

    /// What the bar at the foot of a phone says: it is read behind all cards.
    pub fn bar(&self) -> String {
        let nodes: Vec<_> = self.harness.root().children_recursive().collect();
        let is_in_card = |node: &egui_kittest::Node<'_>| {
            std::iter::successors(node.parent(), |node| node.parent()).any(|node| node.accesskit_node().role() == Role::Region)
        };
        let behind = nodes.iter().rposition(is_in_card).map_or(0, |last| last + 1);
        let said = nodes.iter().skip(behind).map(|node| node.accesskit_node());
        let said = said.filter(|node| node.role() != Role::TextRun);
        said.filter_map(|node| node.value().or_else(|| node.label()))
            .collect::<Vec<_>>()
            .join(" ")
    }

    /// The radio button of this name that is chosen in the group, or none.
    pub fn chosen(&self, group: &str) -> Option<String> {
        let group = self.harness.get_by_role_and_label(Role::RadioGroup, group);
        let chosen = group
            .children_recursive()
            .find(|node| node.accesskit_node().toggled() == Some(Toggled::True));
        chosen.and_then(|node| node.accesskit_node().label())
    }

    /// Chooses one of a group of radio buttons.
    pub fn radio(&mut self, name: &str) {
        self.harness.get_by_role_and_label(Role::RadioButton, name).click();
        self.harness.run();
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
        type_sigma(self, D, "2");
        type_sigma(self, W_IMG, "2");
    }
}

/// The texts in `node` in reading order, each once; of a link to a field its name.
fn texts(node: &egui_kittest::Node<'_>) -> Vec<String> {
    let parts = node.children_recursive().filter_map(|node| {
        let node = node.accesskit_node();
        match node.role() {
            Role::TextRun => None,
            Role::Link => node.label(),
            _ => node.value().or_else(|| node.label()),
        }
    });
    parts.collect()
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
