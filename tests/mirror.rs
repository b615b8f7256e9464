//! The accessible page that the web program builds beside its canvas: all that egui says of each screen is in it.
#![allow(clippy::unwrap_used, clippy::panic, clippy::indexing_slicing, missing_docs, reason = "tests")]

use depth_calculator::app::{App, Event, FileContents, Licenses, Place, Platform, PlatformError};
use egui::accesskit::{Affine, Node, NodeId, Rect, Toggled, TreeUpdate};
use egui::{Role, Vec2, vec2};
use egui_kittest::Harness;
use egui_kittest::kittest::{NodeT as _, Queryable as _};
use egui_mirror::{Element, Nodes, Page, Tree, element_id};
use std::collections::{HashMap, HashSet};
use std::sync::{Arc, Mutex};

const DESKTOP: Vec2 = vec2(1280.0, 900.0);
/// Physical pixels in a CSS pixel.
const SCALE: f32 = 1.5;

/// A machine that keeps nothing.
struct Machine;

impl Platform for Machine {
    fn load(&self) -> Result<Option<String>, PlatformError> {
        Ok(None)
    }
    fn save(&mut self, _text: &str) -> Result<(), PlatformError> {
        Ok(())
    }
    fn set_aside(&mut self) -> Result<Option<Place>, PlatformError> {
        Ok(None)
    }
    fn copy(&mut self, _ctx: &egui::Context, _text: String) {}
    fn save_file(&mut self, _ctx: &egui::Context, _name: &str, _contents: FileContents) {}
    fn open_files(&mut self, _ctx: &egui::Context) {}
    fn start(&mut self, _ctx: &egui::Context, _run: depth_jobs::Run, _job: depth_jobs::Job, _attachments: Vec<depth_jobs::Attachment>) {}
    fn cancel(&mut self, _ctx: &egui::Context, _run: depth_jobs::Run) {}
    fn print(&mut self) -> bool {
        false
    }
    fn today(&self) -> String {
        "November 25, 2026".to_owned()
    }
    fn address(&self) -> String {
        "https://example.org/".to_owned()
    }
    fn events(&mut self) -> Vec<Event> {
        Vec::new()
    }
    fn seconds(&self) -> f64 {
        0.0
    }
    fn commit(&self) -> Option<String> {
        None
    }
    fn licenses(&self) -> Licenses {
        Licenses::Page("licenses.html")
    }
}

/// Keeps the AccessKit tree of the last pass, as `egui_mirror::Mirror` takes it in a browser.
#[derive(Clone, Default)]
struct Last(Arc<Mutex<Option<TreeUpdate>>>);

impl egui::Plugin for Last {
    fn debug_name(&self) -> &'static str {
        "last AccessKit tree"
    }

    fn output_hook(&mut self, _ctx: &egui::Context, output: &mut egui::FullOutput) {
        self.0.lock().unwrap().clone_from(&output.platform_output.accesskit_update);
    }
}

struct Program {
    harness: Harness<'static, App>,
    last: Last,
}

impl Program {
    fn new() -> Self {
        let last = Last::default();
        let plugin = last.clone();
        let mut harness = Harness::builder()
            .with_size(DESKTOP)
            .with_pixels_per_point(SCALE)
            // A simulation goes on for twenty frames.
            .with_max_steps(30)
            .build_eframe(move |cc| {
                cc.egui_ctx.add_plugin(plugin);
                App::new(cc, Box::new(Machine))
            });
        harness.run();
        Self { harness, last }
    }

    fn press(&mut self, name: &str) {
        self.harness.get_by_label(name).click();
        self.harness.run();
    }

    fn type_into(&mut self, field: &str, text: &str) {
        for text in ["", text] {
            let field = self
                .harness
                .get_all_by_label(field)
                .find(|node| matches!(node.accesskit_node().role(), Role::TextInput | Role::NumberInput))
                .unwrap();
            // egui types into what has the focus.
            if text.is_empty() {
                field.focus()
            } else {
                field.type_text(text)
            }
            self.harness.run();
        }
    }

    /// Compares the page with the tree, and returns what the page says.
    fn compare(&self, screen: &str) -> String {
        let update = self.last.0.lock().unwrap().clone().unwrap();
        let nodes: Nodes = update.nodes.into_iter().collect();
        let tree = Tree {
            nodes: &nodes,
            root: update.tree.unwrap().root,
            focus: update.focus,
            scale: 1.0 / f64::from(SCALE),
            modal: self.harness.ctx.memory(|memory| memory.top_modal_layer().is_some()),
            input_mode: |_| None,
        };
        let page = Page::describe(&tree);
        let differences = Comparison::of(&tree, &page).differences;
        assert!(differences.is_empty(), "{screen}:\n{}", differences.join("\n"));
        page.to_string()
    }
}

/// What a node of each role is in HTML: the element, and the explicit roles that it may have. Others are containers without a
/// meaning of their own.
fn html(role: Role) -> Option<(&'static str, &'static [&'static str])> {
    Some(match role {
        Role::Label => ("span", &[""]),
        Role::Heading => ("h", &[""]),
        Role::Button => ("button", &["", "option", "menuitem", "menuitemcheckbox"]),
        Role::Tab => ("button", &["tab"]),
        Role::TabList => ("div", &["tablist"]),
        Role::ComboBox => ("button", &["combobox"]),
        Role::TextInput | Role::NumberInput => ("input", &[""]),
        Role::MultilineTextInput => ("textarea", &[""]),
        Role::Slider | Role::CheckBox | Role::RadioButton => ("input", &[""]),
        Role::Image => ("div", &["img"]),
        Role::Table => ("table", &["table"]),
        Role::Row => ("tr", &["row"]),
        Role::Cell => ("td", &["cell"]),
        Role::RowHeader => ("th", &["rowheader"]),
        Role::ColumnHeader => ("th", &["columnheader"]),
        Role::List => ("ul", &["list"]),
        Role::ListItem => ("li", &["listitem"]),
        Role::Link => ("a", &["link"]),
        Role::Form => ("div", &["form"]),
        Role::Region => ("div", &["region"]),
        Role::Dialog => ("div", &["dialog"]),
        Role::ListBox => ("div", &["listbox"]),
        Role::Menu => ("div", &["menu"]),
        Role::Status => ("div", &["status"]),
        _ => return None,
    })
}

fn corners(page: &Page) -> HashMap<NodeId, (f64, f64)> {
    let mut corners: HashMap<NodeId, (f64, f64)> = page.roots().iter().map(|root| (*root, (0.0, 0.0))).collect();
    for element in page.elements() {
        let corner = corners.get_mut(&element.id).unwrap();
        *corner = (corner.0 + element.place.left, corner.1 + element.place.top);
        let corner = *corner;
        corners.extend(element.children.iter().map(|child| (*child, corner)));
    }
    corners
}

/// Where the page says something else than the tree.
struct Comparison<'a> {
    tree: &'a Tree<'a>,
    page: &'a Page,
    /// Where the upper left corner of each element is on the canvas, in CSS pixels.
    corners: HashMap<NodeId, (f64, f64)>,
    /// The nodes that have an element, in the order of the tree.
    met: Vec<NodeId>,
    differences: Vec<String>,
}

impl<'a> Comparison<'a> {
    fn of(tree: &'a Tree<'a>, page: &'a Page) -> Self {
        let mut comparison = Self {
            tree,
            page,
            corners: corners(page),
            met: Vec::new(),
            differences: Vec::new(),
        };
        comparison.walk(tree.root, Affine::scale(tree.scale));
        comparison.compare_order();
        comparison.compare_dialogs();
        comparison
    }

    fn walk(&mut self, id: NodeId, outer: Affine) {
        let Some(node) = self.tree.nodes.get(&id).filter(|node| !node.is_hidden()) else {
            return;
        };
        let transform = node.transform().map_or(outer, |own| outer * *own);
        if let Some((tag, roles)) = html(node.role()) {
            let name = self.name(node);
            match self.page.get(id) {
                Some(element) => {
                    self.met.push(id);
                    self.compare_element(node, element, &name);
                    let is_tag = element.tag == tag || tag == "h" && ["h1", "h2", "h3", "h4"].contains(&element.tag);
                    let is_role = roles.contains(&element.attribute("role").unwrap_or_default());
                    self.expect(is_tag && is_role, element, || format!("should be <{tag}>, one of {roles:?}"));
                    if let Some(bounds) = node.bounds() {
                        self.compare_place(element, transform.transform_rect_bbox(bounds));
                    }
                }
                // A container that nobody named is nothing to anybody.
                None if name.is_empty() && matches!(node.role(), Role::Region | Role::List) => {}
                None => self.differences.push(format!("{:?} {name:?} is missing", node.role())),
            }
        }
        for child in node.children() {
            self.walk(*child, transform);
        }
    }

    fn expect(&mut self, holds: bool, element: &Element, should: impl FnOnce() -> String) {
        if !holds {
            self.differences.push(format!("{element:?} {}", should()));
        }
    }

    /// What egui says the node is called.
    fn name(&self, node: &Node) -> String {
        let labels = node.labelled_by().iter().filter_map(|id| self.tree.nodes.get(id)?.value());
        let of_labels = labels.collect::<Vec<_>>().join(" ");
        let is_input = matches!(
            node.role(),
            Role::TextInput | Role::NumberInput | Role::MultilineTextInput | Role::ComboBox
        );
        let value = node.value().filter(|_| !is_input).unwrap_or_default();
        match node.label() {
            Some(label) => label.to_owned(),
            None if of_labels.is_empty() => value.to_owned(),
            None => of_labels,
        }
    }

    fn compare_element(&mut self, node: &Node, element: &Element, name: &str) {
        let attribute = |name| element.attribute(name);
        // What is named by what has opened it or by its heading has no name of its own in the tree.
        let is_named = !name.is_empty() || !matches!(node.role(), Role::ListBox | Role::Menu | Role::Dialog);
        self.expect(!is_named || element.name == name, element, || format!("should be called {name:?}"));
        let labels: Vec<String> = node.labelled_by().iter().map(|id| element_id(*id)).collect();
        let has_name = attribute("aria-label") == Some(name)
            || element.text.as_deref() == Some(name)
            || !labels.is_empty() && attribute("aria-labelledby") == Some(labels.join(" ").as_str());
        self.expect(name.is_empty() || has_name, element, || {
            format!("should say that it is called {name:?}")
        });
        if matches!(node.role(), Role::TextInput | Role::NumberInput | Role::MultilineTextInput) {
            self.expect(element.value.as_deref() == node.value(), element, || {
                format!("should hold {:?}", node.value())
            });
        }
        // What is wrong with a field comes first.
        let wrong: Vec<String> = node.described_by().iter().map(|id| self.page.words(*id)).collect();
        let always = node.description().filter(|words| *words != name);
        let all: Vec<&str> = wrong
            .iter()
            .map(String::as_str)
            .chain(always)
            .filter(|words| !words.is_empty())
            .collect();
        let description = Some(all.join(" ")).filter(|words| !words.is_empty());
        self.expect(element.description == description, element, || {
            format!("should be described as {description:?}")
        });
        for (state, on) in [("aria-invalid", node.invalid().is_some()), ("aria-disabled", node.is_disabled())] {
            self.expect((attribute(state) == Some("true")) == on, element, || {
                format!("{state} should be {on}")
            });
        }
        if let Some(on) = node.toggled() {
            let state = ["aria-pressed", "aria-checked", "aria-selected"].into_iter().find_map(attribute);
            let said = element
                .checked
                .map(|checked| checked == Toggled::True)
                .or(state.map(|state| state == "true"));
            self.expect(said == Some(on == Toggled::True), element, || format!("should be {on:?}"));
        } else {
            let chosen = node.is_selected() == Some(true);
            self.expect((attribute("aria-selected") == Some("true")) == chosen, element, || {
                format!("selected should be {chosen}")
            });
        }
    }

    /// Compares where an element lies on the canvas, to a pixel, with where its node does.
    fn compare_place(&mut self, element: &Element, wanted: Rect) {
        let (left, top) = self.corners[&element.id];
        let place = [left, top, left + element.place.width, top + element.place.height];
        let edges = [wanted.x0, wanted.y0, wanted.x1, wanted.y1];
        let is_there = place.iter().zip(edges).all(|(is, wanted)| (is - wanted).abs() <= 1.01);
        self.expect(is_there, element, || format!("lies at {place:?} instead of {edges:?}"));
    }

    /// What hangs below a control, its menu for one, follows it; otherwise the order is the same.
    fn compare_order(&mut self) {
        let order = self.page.elements().iter().map(|element| element.id);
        let met: HashSet<NodeId> = self.met.iter().copied().collect();
        let order: Vec<NodeId> = order.filter(|id| met.contains(id)).collect();
        if order != self.met {
            self.differences.push("the order is another one".to_owned());
        }
    }

    fn compare_dialogs(&mut self) {
        let is_dialog = |element: &Element| element.attribute("role") == Some("dialog");
        let dialog = self.page.elements().iter().find(|element| is_dialog(element));
        for element in self.page.elements() {
            let is_outside = dialog.is_some_and(|dialog| !self.page.contains(dialog.id, element.id));
            if self.page.can_be_reached(element.id) == is_outside {
                self.differences
                    .push(format!("{element:?} is {}behind a dialog", if is_outside { "not " } else { "" }));
            }
        }
    }
}

#[test]
fn the_accessible_page_says_all_that_egui_says_of_the_calculator_and_of_a_mistake_in_it() {
    let mut program = Program::new();
    program.compare("empty");
    program.press("Coffee mug (stereo)");
    program.type_into("Uncertainty of Disparity (d)", "0.5");
    program.type_into("Camera baseline (b)", "ten");
    let page = program.compare("with a mistake");
    assert!(page.contains("aria-invalid=\"true\""), "{page}");
}

#[test]
fn the_accessible_page_says_all_that_egui_says_of_an_open_list() {
    let mut program = Program::new();
    program.press("Unit of Camera baseline (b)");
    let page = program.compare("an open list");
    assert!(
        page.contains("aria-label=\"Unit of Camera baseline (b)\" role=\"listbox\""),
        "{page}"
    );
}

#[test]
fn the_accessible_page_says_all_that_egui_says_of_a_dialog_and_of_nothing_behind_it() {
    let mut program = Program::new();
    program.press("OpenCV × 16, doffs…");
    let page = program.compare("a dialog");
    assert!(page.contains("aria-modal=\"true\"") && page.contains("inert=\"\""), "{page}");
}

#[test]
fn the_accessible_page_says_all_that_egui_says_of_the_explanations() {
    let mut program = Program::new();
    program.press("Learn");
    program.compare("the explanations");
}
