use std::collections::{BTreeMap, HashMap};

use egui::Role;
use egui::accesskit::{Live, Node, NodeId, Rect, Toggled};

use super::{ROOT, TestTree, control};
use crate::diff::{Edit, diff};
use crate::element::{Lettering, Place};
use crate::page::Page;

#[test]
fn equal_pages_need_no_edit() {
    let mut tree = TestTree::new();
    tree.add(ROOT, Role::Button, |node| control(node, "Send"));
    assert_eq!(diff(&tree.page(), &tree.page()), []);
    assert_ne!(diff(&Page::default(), &tree.page()), []);
}

#[test]
fn a_new_value_touches_nothing_but_the_value() {
    let mut tree = TestTree::new();
    let id = tree.add(ROOT, Role::TextInput, |node| node.set_value("1"));
    let before = tree.page();
    tree.nodes.get_mut(&id).unwrap().set_value("12");
    assert_eq!(diff(&before, &tree.page()), [Edit::Value(id, "12".to_owned())]);
}

#[derive(Default)]
struct Made {
    about: Option<String>,
    tag: &'static str,
    attributes: BTreeMap<&'static str, String>,
    text: String,
    value: Option<String>,
    checked: Option<Toggled>,
    place: Option<Place>,
    lettering: Option<Lettering>,
    children: Vec<NodeId>,
}

#[test]
fn a_new_text_or_another_order_makes_no_element_anew() {
    let mut tree = TestTree::new();
    let words = ["One", "Two", "Three", "Four"];
    let ids = words.map(|word| tree.add(ROOT, Role::Button, |node| control(node, word)));
    let before = tree.page();
    for (id, word) in ids.iter().zip(["Two", "Un", "", "Four"]) {
        tree.nodes.get_mut(id).unwrap().set_label(word);
    }
    let [one, two, three, four] = ids;
    tree.nodes.get_mut(&ROOT).unwrap().set_children([four, two, one, three]);
    let after = tree.page();
    let edits = diff(&before, &after);
    assert!(edits.contains(&Edit::Text(one, "Two".to_owned())));
    assert!(edits.contains(&Edit::Children(None, vec![four, two, one, three])));
    let is_anew = |edit: &Edit| matches!(edit, Edit::Create(..) | Edit::Remove(_));
    assert!(!edits.iter().any(is_anew), "{edits:?}");
}

/// What a browser would hold after the edits.
#[derive(Default)]
struct Browser {
    made: HashMap<NodeId, Made>,
    roots: Vec<NodeId>,
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
            Edit::About(id, words) => self.made.get_mut(&id).unwrap().about = words,
            Edit::Text(id, text) => {
                let made = self.made.get_mut(&id).unwrap();
                made.text = text;
                made.children.clear();
            }
            Edit::Value(id, value) => self.made.get_mut(&id).unwrap().value = Some(value),
            Edit::Checked(id, checked) => self.made.get_mut(&id).unwrap().checked = Some(checked),
            Edit::Place(id, place) => self.made.get_mut(&id).unwrap().place = Some(place),
            Edit::Lettering(id, lettering) => self.made.get_mut(&id).unwrap().lettering = lettering,
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
        assert_eq!(self.roots, page.roots());
        assert_eq!(self.made.len(), page.elements().len());
        for element in page.elements() {
            let made = &self.made[&element.id];
            assert_eq!(made.tag, element.tag);
            assert_eq!(made.attributes, element.attributes);
            assert_eq!(made.about, element.description.clone().filter(|_| element.has_about()));
            assert_eq!(made.text, element.text.clone().unwrap_or_default());
            assert_eq!(made.checked, element.checked);
            assert_eq!(made.place, Some(element.place));
            assert_eq!(made.lettering, element.lettering);
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
fn random_tree(chance: &mut Chance) -> TestTree {
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
    TestTree { nodes }
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

#[test]
fn as_few_as_possible_are_moved_and_those_that_stay_are_in_order() {
    let stay = |before: &[Option<usize>]| -> Vec<usize> {
        let stays = crate::diff::in_order(before);
        before
            .iter()
            .zip(stays)
            .filter(|(_, stays)| *stays)
            .filter_map(|(place, _)| *place)
            .collect()
    };
    let all = |places: &[usize]| places.iter().copied().map(Some).collect::<Vec<_>>();
    // The first of five goes to the end: it alone is moved.
    assert_eq!(stay(&all(&[1, 2, 3, 4, 0])), [1, 2, 3, 4]);
    assert_eq!(stay(&all(&[4, 0, 1, 2, 3])), [0, 1, 2, 3]);
    assert_eq!(stay(&[Some(0), None, Some(1), None]), [0, 1]);
    assert_eq!(stay(&[]), []);
    // Against all subsets of every order of six.
    let mut order: Vec<usize> = (0..6).collect();
    for _ in 0..720 {
        let kept_by = |subset: u32| -> Vec<usize> { (0..6).filter(|at| subset & (1 << at) != 0).map(|at| order[at]).collect() };
        let longest = (0..64).map(kept_by).filter(|kept| kept.is_sorted()).map(|kept| kept.len()).max();
        let kept = stay(&all(&order));
        assert!(kept.is_sorted());
        assert_eq!(Some(kept.len()), longest, "{order:?}");
        next_order(&mut order);
    }
}

/// The next order of these, in that of the dictionary.
fn next_order(order: &mut [usize]) {
    let Some(turn) = (1..order.len()).rev().find(|at| order[at - 1] < order[*at]) else {
        return order.reverse();
    };
    let swap = (turn..order.len()).rev().find(|at| order[*at] > order[turn - 1]).unwrap();
    order.swap(turn - 1, swap);
    order[turn..].reverse();
}
