use egui::Role;
use egui::accesskit::{Node, NodeId};

use super::{ROOT, TestTree, control};
use crate::focus::{Destination, destination};
use crate::page::Page;

#[test]
fn what_had_the_focus_is_found_again_when_its_number_goes_to_another() {
    let mut tree = TestTree::new();
    let field = tree.add(ROOT, Role::TextInput, |node| control(node, "Length"));
    let other = tree.add(ROOT, Role::TextInput, |node| control(node, "Width"));
    let before = tree.page();
    let successor = |tree: &TestTree| tree.page().successor(&before, before.get(field).unwrap());
    let name = |tree: &mut TestTree, one, two| {
        tree.nodes.get_mut(&field).unwrap().set_label(one);
        tree.nodes.get_mut(&other).unwrap().set_label(two);
    };
    name(&mut tree, "Height", "Length");
    assert_eq!(successor(&tree), Some(other));
    name(&mut tree, "Extent", "Width");
    assert_eq!(successor(&tree), Some(field), "renamed");
    tree.nodes.get_mut(&field).unwrap().set_role(Role::Label);
    assert_eq!(successor(&tree), None, "no words can have the focus");
}

#[test]
fn a_new_text_does_not_lead_the_focus_to_another_element_with_the_old_one() {
    let mut tree = TestTree::new();
    let first = tree.add(ROOT, Role::Button, |node| control(node, "Show"));
    let second = tree.add(ROOT, Role::Button, |node| control(node, "Show"));
    let before = tree.page();
    for (held, other) in [(first, second), (second, first)] {
        let mut tree = tree.clone();
        tree.nodes.get_mut(&held).unwrap().set_label("Hide");
        let held_before = before.get(held).unwrap();
        assert_eq!(tree.page().successor(&before, held_before), Some(held));
        tree.nodes.get_mut(&held).unwrap().set_hidden();
        assert_eq!(
            tree.page().successor(&before, held_before),
            None,
            "{other:?} is another, and always was"
        );
    }
}

#[test]
fn the_authors_id_says_what_had_the_focus_whatever_its_text_and_its_number_are_now() {
    let named = |node: &mut Node, id: &str, text: &str| {
        control(node, text);
        node.set_author_id(id);
    };
    let mut before = TestTree::new();
    let first = before.add(ROOT, Role::Button, |node| named(node, "send", "Send"));
    before.add(ROOT, Role::Button, |node| named(node, "clear", "Clear"));
    let mut after = TestTree::new();
    assert_eq!(after.add(ROOT, Role::Button, |node| named(node, "undo", "Send")), first);
    let third = after.add(ROOT, Role::Button, |node| named(node, "send", "Sent"));
    let (old, new) = (before.page(), after.page());
    assert_eq!(new.successor(&old, old.get(first).unwrap()), Some(third));
    after.nodes.get_mut(&third).unwrap().set_hidden();
    assert_eq!(after.page().successor(&old, old.get(first).unwrap()), None);
}

/// A form with two fields, and the ids of these.
fn form() -> (TestTree, NodeId, NodeId) {
    let mut tree = TestTree::new();
    let first = tree.add(ROOT, Role::TextInput, |node| control(node, "Width"));
    let second = tree.add(ROOT, Role::TextInput, |node| control(node, "Height"));
    (tree, first, second)
}

#[test]
fn the_browsers_focus_goes_where_egui_moves_its_own() {
    let (tree, first, second) = form();
    let (old, new) = (tree.focused(first), tree.focused(second));
    let held = old.get(first).unwrap();
    assert_eq!(destination(&old, &new, held, &[first]), Destination::FollowEgui(second));
    assert_eq!(
        destination(&old, &old, held, &[first]),
        Destination::LeadEgui(first),
        "nothing has moved"
    );
}

#[test]
fn from_what_is_gone_the_focus_goes_back_to_where_it_was_before() {
    let (mut tree, first, second) = form();
    let gone = tree.add(ROOT, Role::Button, |node| control(node, "Undo"));
    let old = tree.focused(gone);
    tree.nodes.get_mut(&gone).unwrap().set_hidden();
    let visited = [second, first, gone];
    assert_eq!(
        destination(&old, &tree.page(), old.get(gone).unwrap(), &visited),
        Destination::LeadEgui(first)
    );
}

#[test]
fn from_behind_a_modal_dialog_the_focus_goes_into_it_and_from_an_empty_page_to_the_canvas() {
    let (mut tree, first, second) = form();
    let old = tree.focused(first);
    let dialog = tree.add(ROOT, Role::Dialog, |_| ());
    let inside = tree.add(dialog, Role::Button, |node| control(node, "Close"));
    let new = Page::describe(&crate::Tree {
        modal: true,
        ..tree.input(ROOT)
    });
    let held = old.get(first).unwrap();
    assert_eq!(destination(&old, &new, held, &[second, first]), Destination::LeadEgui(inside));
    assert_eq!(destination(&old, &Page::default(), held, &[second, first]), Destination::Canvas);
}
