#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "tests")]

use std::collections::{BTreeMap, HashMap};

use egui::accesskit::{Action, Affine, Live, Node, NodeId, Rect, Toggled};
use egui::{Modifiers, Role};

use crate::diff::{Edit, Urgency, announcements, diff};
use crate::keys::{Route, is_browsers, route};
use crate::model::{Nodes, Page, Place, bare_number, element_id, node_id, number, text_position};
use crate::roles::Kind;

const ROOT: NodeId = NodeId(0);

/// A tree for tests: nodes are made in order and numbered from 1; the root is 0.
#[derive(Clone)]
struct Tree {
    nodes: Nodes,
}

impl Tree {
    fn new() -> Self {
        Self {
            nodes: HashMap::from([(ROOT, Node::new(Role::Window))]),
        }
    }

    fn add(&mut self, parent: NodeId, role: Role, set: impl FnOnce(&mut Node)) -> NodeId {
        let id = NodeId(u64::try_from(self.nodes.len()).unwrap());
        let mut node = Node::new(role);
        set(&mut node);
        self.nodes.insert(id, node);
        self.nodes.get_mut(&parent).unwrap().push_child(id);
        id
    }

    fn page(&self) -> Page {
        self.focused(ROOT)
    }

    fn focused(&self, focus: NodeId) -> Page {
        Page::describe(&self.nodes, ROOT, focus, 1.0, false, |_| None)
    }
}

fn label(node: &mut Node, words: &str) {
    node.set_value(words);
}

fn control(node: &mut Node, words: &str) {
    node.set_label(words);
    node.add_action(Action::Focus);
    node.add_action(Action::Click);
}

fn tags(page: &Page) -> Vec<&str> {
    page.elements.iter().map(|element| element.tag).collect()
}

fn attribute<'a>(page: &'a Page, id: NodeId, name: &str) -> Option<&'a str> {
    page.get(id)?.attributes.get(name).map(String::as_str)
}

#[test]
fn reading_order_is_the_order_of_children_through_containers_without_meaning() {
    let mut tree = Tree::new();
    let first = tree.add(ROOT, Role::GenericContainer, |_| ());
    let second = tree.add(ROOT, Role::Pane, |_| ());
    tree.add(second, Role::Label, |node| label(node, "last"));
    tree.add(first, Role::Heading, |node| label(node, "first"));
    let named = tree.add(first, Role::GenericContainer, |node| node.set_label("a group"));
    tree.add(named, Role::Label, |node| label(node, "inside"));
    assert_eq!(
        tree.page().to_string(),
        "h2 text: \"first\" at: 0 0 1 1\ndiv aria-label=\"a group\" role=\"group\" at: 0 0 1 1\n  \
         span text: \"inside\" at: 0 0 1 1\nspan text: \"last\" at: 0 0 1 1\n"
    );
}

#[test]
fn a_label_says_its_value_once_although_its_text_runs_say_it_too() {
    let mut tree = Tree::new();
    let id = tree.add(ROOT, Role::Label, |node| label(node, "Baseline"));
    tree.add(id, Role::TextRun, |node| node.set_value("Baseline"));
    assert_eq!(tree.page().to_string(), "span text: \"Baseline\" at: 0 0 1 1\n");
}

#[test]
fn a_field_is_named_by_its_label_and_described_by_its_error() {
    let mut tree = Tree::new();
    let name = tree.add(ROOT, Role::Label, |node| label(node, "Focal length"));
    let error = NodeId(3);
    let field = tree.add(ROOT, Role::NumberInput, |node| {
        node.set_labelled_by([name]);
        node.set_described_by([error, NodeId(99)]);
        node.set_invalid(egui::accesskit::Invalid::True);
        node.set_value("abc");
    });
    tree.add(ROOT, Role::Label, |node| label(node, "not a number"));
    let page = tree.page();
    assert_eq!(page.get(field).unwrap().name, "Focal length");
    assert_eq!(attribute(&page, field, "aria-labelledby"), Some("mirror-1"));
    assert_eq!(
        attribute(&page, field, "aria-describedby"),
        Some("mirror-3"),
        "a relation to nothing is left out"
    );
    assert_eq!(attribute(&page, field, "aria-invalid"), Some("true"));
    assert_eq!(attribute(&page, field, "inputmode"), Some("decimal"));
}

#[test]
fn the_author_chooses_the_keyboard_of_a_text_field() {
    let mut tree = Tree::new();
    let field = tree.add(ROOT, Role::TextInput, |node| node.set_class_name("digits"));
    let page = Page::describe(&tree.nodes, ROOT, ROOT, 1.0, false, |node| node.class_name().map(|_| "numeric"));
    assert_eq!(attribute(&page, field, "inputmode"), Some("numeric"));
    assert_eq!(attribute(&tree.page(), field, "inputmode"), None);
}

#[test]
fn tables_and_lists_are_made_of_their_own_elements() {
    let mut tree = Tree::new();
    let table = tree.add(ROOT, Role::Table, |node| node.set_label("Results"));
    for row in 0..2 {
        let row_id = tree.add(table, Role::Row, |_| ());
        let inner = tree.add(row_id, Role::GenericContainer, |_| ());
        tree.add(inner, if row == 0 { Role::ColumnHeader } else { Role::RowHeader }, |node| {
            label(node, "a")
        });
        tree.add(inner, Role::Cell, |node| label(node, "b"));
    }
    let list = tree.add(ROOT, Role::List, |_| ());
    tree.add(list, Role::ListItem, |node| label(node, "c"));
    let page = tree.page();
    assert_eq!(tags(&page), ["table", "tr", "th", "td", "tr", "th", "td", "ul", "li"]);
    let scopes: Vec<_> = page.elements.iter().filter_map(|element| element.attributes.get("scope")).collect();
    assert_eq!(scopes, ["col", "row"]);
}

#[test]
fn a_picture_has_a_name_and_a_description() {
    let mut tree = Tree::new();
    let id = tree.add(ROOT, Role::Image, |node| {
        node.set_label("Distance against disparity");
        node.set_description("Falls from 10 m to 1 m");
    });
    let page = tree.page();
    let said = ["role", "aria-label", "aria-description"].map(|name| attribute(&page, id, name).unwrap());
    assert_eq!(said, ["img", "Distance against disparity", "Falls from 10 m to 1 m"]);
}

#[test]
fn places_are_css_pixels_relative_to_the_element_around() {
    let mut tree = Tree::new();
    tree.nodes.get_mut(&ROOT).unwrap().set_transform(Affine::scale(3.0));
    let group = tree.add(ROOT, Role::Group, |node| node.set_label("group"));
    let bounds = |x0, y0| Rect {
        x0,
        y0,
        x1: x0 + 10.0,
        y1: y0 + 20.0,
    };
    let one = tree.add(group, Role::Button, |node| node.set_bounds(bounds(100.0, 50.0)));
    let two = tree.add(group, Role::Button, |node| node.set_bounds(bounds(120.0, 50.0)));
    // Three physical pixels to a point, two to a CSS pixel.
    let page = Page::describe(&tree.nodes, ROOT, ROOT, 0.5, false, |_| None);
    let place = |id| page.get(id).unwrap().place;
    assert_eq!(
        place(group),
        Place {
            left: 150.0,
            top: 75.0,
            width: 45.0,
            height: 30.0
        },
        "as large as what it contains"
    );
    assert_eq!(
        place(one),
        Place {
            left: 0.0,
            top: 0.0,
            width: 15.0,
            height: 30.0
        }
    );
    assert_eq!(
        place(two),
        Place {
            left: 30.0,
            top: 0.0,
            width: 15.0,
            height: 30.0
        }
    );
}

#[test]
fn a_combo_box_knows_its_open_list_and_the_buttons_in_it_are_options() {
    let mut tree = Tree::new();
    let combo = tree.add(ROOT, Role::ComboBox, |node| {
        control(node, "Unit");
        node.set_value("metres");
    });
    let closed = tree.page();
    assert_eq!(attribute(&closed, combo, "aria-expanded"), Some("false"));
    assert_eq!(
        closed.get(combo).unwrap().text.as_deref(),
        Some("metres"),
        "its content is its value"
    );
    let area = tree.add(combo, Role::GenericContainer, |_| ());
    let list = tree.add(area, Role::ListBox, |_| ());
    let inner = tree.add(list, Role::GenericContainer, |_| ());
    let option = tree.add(inner, Role::Button, |node| {
        control(node, "metres");
        node.set_toggled(Toggled::True);
    });
    let open = tree.page();
    assert_eq!(attribute(&open, combo, "aria-expanded"), Some("true"));
    assert_eq!(attribute(&open, combo, "aria-controls"), Some(element_id(list).as_str()));
    assert_eq!(attribute(&open, list, "aria-label"), Some("Unit"));
    assert_eq!(open.roots, [combo, list], "a list is not inside the button that opens it");
    assert_eq!(
        (attribute(&open, option, "role"), attribute(&open, option, "aria-selected")),
        (Some("option"), Some("true"))
    );
    assert!(open.has_popup() && !closed.has_popup());
}

#[test]
fn a_modal_dialog_shuts_out_the_rest_and_is_named_by_its_heading() {
    let mut tree = Tree::new();
    let behind = tree.add(ROOT, Role::Button, |node| control(node, "Ask"));
    let dialog = tree.add(ROOT, Role::Dialog, |_| ());
    let heading = tree.add(dialog, Role::Heading, |node| label(node, "Really?"));
    let inside = tree.add(dialog, Role::Button, |node| control(node, "Close"));
    let page = Page::describe(&tree.nodes, ROOT, ROOT, 1.0, true, |_| None);
    assert!(!page.can_be_reached(behind) && page.can_be_reached(inside));
    assert_eq!(page.first_stop_in_dialog(), Some(inside));
    assert_eq!(attribute(&page, dialog, "aria-labelledby"), Some(element_id(heading).as_str()));
    assert!(tree.page().can_be_reached(behind), "a dialog that is not modal shuts out nothing");
}

#[test]
fn what_had_the_focus_is_found_again_when_its_number_goes_to_another() {
    let mut tree = Tree::new();
    let field = tree.add(ROOT, Role::TextInput, |node| control(node, "Disparity"));
    let other = tree.add(ROOT, Role::TextInput, |node| control(node, "Baseline"));
    let before = tree.page();
    let swap = |tree: &mut Tree, one, two| {
        tree.nodes.get_mut(&field).unwrap().set_label(one);
        tree.nodes.get_mut(&other).unwrap().set_label(two);
    };
    swap(&mut tree, "Focal length", "Disparity");
    assert_eq!(tree.page().heir(before.get(field).unwrap()), Some(other));
    swap(&mut tree, "Parallax", "Baseline");
    assert_eq!(tree.page().heir(before.get(field).unwrap()), Some(field), "renamed");
    tree.nodes.get_mut(&field).unwrap().set_role(Role::Label);
    assert_eq!(tree.page().heir(before.get(field).unwrap()), None, "no words can have the focus");
}

#[test]
fn what_is_disabled_stays_in_the_page_but_is_no_stop_and_takes_no_click() {
    let mut tree = Tree::new();
    let id = tree.add(ROOT, Role::Button, |node| {
        control(node, "Reset");
        node.set_disabled();
    });
    let page = tree.page();
    assert_eq!(
        (attribute(&page, id, "aria-disabled"), attribute(&page, id, "tabindex")),
        (Some("true"), Some("-1"))
    );
    assert!(!page.get(id).unwrap().allowed.click);
}

#[test]
fn a_password_is_never_in_the_page() {
    let mut tree = Tree::new();
    let id = tree.add(ROOT, Role::PasswordInput, |node| node.set_value("••••"));
    assert_eq!(tree.page().get(id).unwrap().value, None);
}

#[test]
fn a_hidden_node_is_not_in_the_page() {
    let mut tree = Tree::new();
    tree.add(ROOT, Role::Button, Node::set_hidden);
    assert!(tree.page().elements.is_empty());
}

#[test]
fn equal_pages_need_no_edit() {
    let mut tree = Tree::new();
    tree.add(ROOT, Role::Button, |node| control(node, "Compute"));
    assert_eq!(diff(&tree.page(), &tree.page()), []);
    assert_ne!(diff(&Page::default(), &tree.page()), []);
}

#[test]
fn a_new_value_touches_nothing_but_the_value() {
    let mut tree = Tree::new();
    let id = tree.add(ROOT, Role::TextInput, |node| node.set_value("1"));
    let before = tree.page();
    tree.nodes.get_mut(&id).unwrap().set_value("12");
    assert_eq!(diff(&before, &tree.page()), [Edit::Value(id, "12".to_owned())]);
}

/// What is announced when one tree has become the other.
fn announced(old: &Tree, new: &Tree) -> Vec<(Urgency, String)> {
    let all = announcements(&old.page(), &new.page());
    all.into_iter().map(|one| (one.urgency, one.words)).collect()
}

fn live(node: &mut Node, words: &str) {
    label(node, words);
    node.set_live(Live::Polite);
}

#[test]
fn what_appears_is_announced_once_but_not_at_the_start_and_no_alert() {
    let mut started = Tree::new();
    started.add(ROOT, Role::Button, |node| control(node, "Go"));
    let mut tree = started.clone();
    tree.add(ROOT, Role::Label, |node| live(node, "not a number"));
    tree.add(ROOT, Role::Alert, |node| live(node, "the browser announces alerts"));
    tree.add(ROOT, Role::Label, |node| {
        live(node, "nobody wants this");
        node.set_live(Live::Off);
    });
    assert_eq!(announced(&Tree::new(), &tree), [], "the start");
    assert_eq!(announced(&started, &tree), [(Urgency::Polite, "not a number".to_owned())]);
    assert_eq!(announced(&tree, &tree), []);
}

#[test]
fn what_changes_is_announced_with_what_it_is_about() {
    let mut before = Tree::new();
    let result = before.add(ROOT, Role::Label, |node| live(node, "1.400 m"));
    let node = before.nodes.get_mut(&result).unwrap();
    node.set_description("Stereo distance");
    let mut after = before.clone();
    after.nodes.get_mut(&result).unwrap().set_value("0.700 m");
    assert_eq!(
        announced(&before, &after),
        [(Urgency::Polite, "Stereo distance: 0.700 m".to_owned())]
    );
    after.nodes.get_mut(&result).unwrap().clear_live();
    assert_eq!(announced(&before, &after), [], "what is not live any more");
}

#[test]
fn an_error_is_announced_also_where_its_number_was_another_widget_before() {
    let mut before = Tree::new();
    let id = before.add(ROOT, Role::Heading, |node| label(node, "Stereo"));
    let mut after = Tree::new();
    assert_eq!(after.add(ROOT, Role::Label, |node| live(node, "not a number")), id);
    after.add(ROOT, Role::Heading, |node| label(node, "Stereo"));
    assert_eq!(announced(&before, &after), [(Urgency::Polite, "not a number".to_owned())]);
    // The same words under the same number, which were no news before.
    let mut silent = after.clone();
    silent.nodes.get_mut(&id).unwrap().clear_live();
    assert_eq!(announced(&silent, &after), [(Urgency::Polite, "not a number".to_owned())]);
}

#[test]
fn all_that_is_news_at_once_is_announced() {
    let mut before = Tree::new();
    before.add(ROOT, Role::Button, |node| control(node, "Coffee mug"));
    let mut after = before.clone();
    after.add(ROOT, Role::Label, |node| live(node, "1.400 m"));
    after.add(ROOT, Role::Label, |node| live(node, "The example is filled in."));
    let words: Vec<String> = announced(&before, &after).into_iter().map(|(_, words)| words).collect();
    assert_eq!(words, ["1.400 m", "The example is filled in."]);
}

#[test]
fn numbers_are_read_as_people_write_them() {
    assert_eq!(number(" 1,5 "), Some(1.5));
    assert_eq!(number("−2e3"), Some(-2000.0));
    assert_eq!(number("NaN"), None);
    assert_eq!(number("inf"), None);
    assert_eq!(bare_number("1400 px"), "1400");
    assert_eq!(bare_number("f = −1,5 mm"), "−1,5");
    assert_eq!(bare_number("none"), "none");
}

#[test]
fn an_element_leads_back_to_its_node() {
    for id in [0, 1, u64::MAX].map(NodeId) {
        assert_eq!(node_id(&element_id(id)), Some(id));
    }
    assert_eq!(node_id("app"), None);
}

#[test]
fn a_caret_is_found_in_the_run_that_holds_it() {
    let mut tree = Tree::new();
    let field = tree.add(ROOT, Role::MultilineTextInput, |_| ());
    let first = tree.add(field, Role::TextRun, |node| node.set_character_lengths([1, 1, 1]));
    let second = tree.add(field, Role::TextRun, |node| node.set_character_lengths([2, 1]));
    let at = |index| text_position(&tree.nodes, field, index).map(|position| (position.node, position.character_index));
    assert_eq!(
        [at(0), at(2), at(3), at(5), at(99)],
        [
            Some((first, 0)),
            Some((first, 2)),
            Some((second, 0)),
            Some((second, 2)),
            Some((second, 2))
        ]
    );
}

#[test]
fn tab_and_the_keys_of_the_browser_stay_with_the_browser() {
    let kinds = [
        Kind::Button,
        Kind::Check,
        Kind::Line,
        Kind::Lines,
        Kind::Stepper,
        Kind::Range,
        Kind::Other,
    ];
    let ctrl = Modifiers {
        ctrl: true,
        command: true,
        ..Modifiers::NONE
    };
    for kind in kinds {
        assert_eq!(route(kind, "Tab", Modifiers::NONE), Route::Browser);
        assert_eq!(route(kind, "Tab", Modifiers::SHIFT), Route::Browser);
        for key in ["f", "r", "l", "t", "+", "-", "0", "F5", "F12"] {
            let modifiers = if key.starts_with('F') { Modifiers::NONE } else { ctrl };
            assert_ne!(route(kind, key, modifiers), Route::Egui { only: true }, "{kind:?} {key}");
        }
    }
}

#[test]
fn the_canvas_does_not_keep_the_browsers_keys() {
    const CTRL: Modifiers = Modifiers::CTRL;
    const CMD: Modifiers = Modifiers::MAC_CMD;
    for key in ["p", "P", "s", "o", ","] {
        assert!(is_browsers(key, CTRL, false) && is_browsers(key, CMD, true), "{key}");
        assert!(!is_browsers(key, Modifiers::NONE, false), "{key} alone is typed");
        assert!(!is_browsers(key, CTRL, true), "{key} moves the caret on a Mac");
    }
    assert!(is_browsers("ArrowLeft", Modifiers::ALT, false));
    assert!(!is_browsers("ArrowLeft", Modifiers::ALT, true), "by a word");
    assert!(!is_browsers("ArrowLeft", CTRL, false), "by a word");
    assert!(!is_browsers("c", CTRL, false), "eframe leaves it to the browser by itself");
}

#[test]
fn a_field_types_and_edits_by_itself_and_only_enter_and_escape_reach_egui() {
    let ctrl = Modifiers {
        ctrl: true,
        command: true,
        ..Modifiers::NONE
    };
    for (key, modifiers) in [
        ("a", Modifiers::NONE),
        ("Backspace", Modifiers::NONE),
        ("v", ctrl),
        ("z", ctrl),
        ("ArrowLeft", ctrl),
    ] {
        assert_eq!(route(Kind::Line, key, modifiers), Route::Browser, "{key}");
    }
    assert_eq!(route(Kind::Line, "Enter", Modifiers::NONE), Route::Egui { only: true });
    assert_eq!(
        route(Kind::Line, "2", Modifiers::ALT),
        Route::Egui { only: false },
        "another screen"
    );
    assert_eq!(route(Kind::Line, "2", Modifiers::NONE), Route::Browser);
    assert_eq!(
        route(Kind::Range, "ArrowUp", Modifiers::SHIFT),
        Route::Egui { only: true },
        "a larger step"
    );
    assert_eq!(route(Kind::Lines, "Enter", Modifiers::NONE), Route::Browser, "a new line");
    assert_eq!(route(Kind::Lines, "Escape", Modifiers::NONE), Route::Egui { only: false });
    assert_eq!(route(Kind::Other, " ", Modifiers::NONE), Route::Click);
    assert_eq!(route(Kind::Button, " ", Modifiers::NONE), Route::Browser, "which clicks by itself");
}

/// What a browser would hold after the edits.
#[derive(Default)]
struct Browser {
    made: HashMap<NodeId, Made>,
    roots: Vec<NodeId>,
}

#[derive(Default)]
struct Made {
    tag: &'static str,
    attributes: BTreeMap<&'static str, String>,
    text: String,
    value: Option<String>,
    checked: Option<Toggled>,
    place: Option<Place>,
    children: Vec<NodeId>,
}

impl Browser {
    fn detach(&mut self, id: NodeId) {
        self.roots.retain(|child| *child != id);
        for made in self.made.values_mut() {
            made.children.retain(|child| *child != id);
        }
    }

    fn carry_out(&mut self, edit: Edit) {
        match edit {
            Edit::Remove(id) => {
                self.detach(id);
                self.made.remove(&id).unwrap();
            }
            Edit::Create(id, tag) => {
                let before = self.made.insert(id, Made { tag, ..Made::default() });
                assert!(before.is_none(), "made twice");
            }
            Edit::Attribute(id, name, Some(value)) => {
                self.made.get_mut(&id).unwrap().attributes.insert(name, value);
            }
            Edit::Attribute(id, name, None) => {
                self.made.get_mut(&id).unwrap().attributes.remove(name).unwrap();
            }
            Edit::Text(id, text) => {
                let made = self.made.get_mut(&id).unwrap();
                made.text = text;
                made.children.clear();
            }
            Edit::Value(id, value) => self.made.get_mut(&id).unwrap().value = Some(value),
            Edit::Checked(id, checked) => self.made.get_mut(&id).unwrap().checked = Some(checked),
            Edit::Place(id, place) => self.made.get_mut(&id).unwrap().place = Some(place),
            Edit::Children(parent, children) => {
                for (position, child) in children.into_iter().enumerate() {
                    assert!(self.made.contains_key(&child));
                    self.detach(child);
                    let list = match parent {
                        Some(id) => &mut self.made.get_mut(&id).unwrap().children,
                        None => &mut self.roots,
                    };
                    list.insert(position.min(list.len()), child);
                }
            }
        }
    }

    fn assert_holds(&self, page: &Page) {
        assert_eq!(self.roots, page.roots);
        assert_eq!(self.made.len(), page.elements.len());
        for element in &page.elements {
            let made = &self.made[&element.id];
            assert_eq!(made.tag, element.tag);
            assert_eq!(made.attributes, element.attributes);
            assert_eq!(made.text, element.text.clone().unwrap_or_default());
            assert_eq!(made.checked, element.checked);
            assert_eq!(made.place, Some(element.place));
            assert_eq!(made.children, element.children, "children of {element:?}");
            if element.value.is_some() {
                assert_eq!(made.value, element.value);
            }
        }
    }
}

/// The random numbers of Lehmer, as in `MINSTD`: the same in every run.
struct Chance(u64);

impl Chance {
    fn below(&mut self, n: usize) -> usize {
        self.0 = self.0 * 48271 % 0x7fff_ffff;
        usize::try_from(self.0).unwrap() % n
    }
}

/// Grows a tree of random roles whose nodes keep their numbers and properties from one tree to the next, or not.
fn random_tree(chance: &mut Chance) -> Tree {
    const ROLES: [Role; 14] = [
        Role::Label,
        Role::Button,
        Role::TextInput,
        Role::CheckBox,
        Role::Group,
        Role::GenericContainer,
        Role::Table,
        Role::Row,
        Role::Cell,
        Role::List,
        Role::ListItem,
        Role::ComboBox,
        Role::ListBox,
        Role::Dialog,
    ];
    let mut nodes = HashMap::from([(ROOT, Node::new(Role::Window))]);
    let mut parents = vec![ROOT];
    for _ in 0..chance.below(40) {
        let id = NodeId(1 + u64::try_from(chance.below(40)).unwrap());
        if nodes.contains_key(&id) {
            continue;
        }
        let usual = ROLES[usize::try_from(id.0).unwrap() % ROLES.len()];
        let mut node = Node::new(if chance.below(8) == 0 {
            ROLES[chance.below(ROLES.len())]
        } else {
            usual
        });
        match chance.below(4) {
            0 => node.set_label(format!("name {}", chance.below(3))),
            1 => node.set_value(format!("value {}", chance.below(3))),
            2 => node.set_live(Live::Polite),
            _ => node.set_labelled_by([NodeId(1 + u64::try_from(chance.below(40)).unwrap())]),
        }
        if chance.below(2) == 0 {
            let x0 = f64::from(u16::try_from(chance.below(3)).unwrap());
            node.set_bounds(Rect {
                x0,
                y0: 0.0,
                x1: x0 + 10.0,
                y1: 10.0,
            });
            node.set_toggled(Toggled::True);
        }
        let parent = parents[chance.below(parents.len())];
        nodes.get_mut(&parent).unwrap().push_child(id);
        nodes.insert(id, node);
        parents.push(id);
    }
    Tree { nodes }
}

#[test]
fn the_edits_lead_from_any_page_to_any_other() {
    let mut chance = Chance(2026);
    let mut browser = Browser::default();
    let mut page = Page::default();
    let mut edits = 0;
    for _ in 0..2000 {
        let next = random_tree(&mut chance).page();
        for edit in diff(&page, &next) {
            edits += 1;
            browser.carry_out(edit);
        }
        browser.assert_holds(&next);
        page = next;
    }
    assert!(edits > 10_000, "the walk was too short to mean anything: {edits}");
}
