use egui::Role;
use egui::accesskit::{Live, Node};

use super::{ROOT, TestTree, control, label};
use crate::announce::{Urgency, announcements};

/// What is announced when one tree has become the other.
fn announced(old: &TestTree, new: &TestTree) -> Vec<(Urgency, String)> {
    let all = announcements(&old.page(), &new.page());
    all.into_iter().map(|one| (one.urgency, one.words)).collect()
}

fn live(node: &mut Node, words: &str) {
    label(node, words);
    node.set_live(Live::Polite);
}

#[test]
fn what_appears_is_announced_once_but_not_at_the_start_and_no_alert() {
    let mut started = TestTree::new();
    started.add(ROOT, Role::Button, |node| control(node, "Go"));
    let mut tree = started.clone();
    tree.add(ROOT, Role::Label, |node| live(node, "not a number"));
    tree.add(ROOT, Role::Alert, |node| live(node, "the browser announces alerts"));
    tree.add(ROOT, Role::Label, |node| {
        live(node, "nobody wants this");
        node.set_live(Live::Off);
    });
    assert_eq!(announced(&TestTree::new(), &tree), [], "the start");
    assert_eq!(announced(&started, &tree), [(Urgency::Polite, "not a number".to_owned())]);
    assert_eq!(announced(&tree, &tree), []);
}

#[test]
fn what_changes_is_announced_with_what_it_is_about() {
    let mut before = TestTree::new();
    let result = before.add(ROOT, Role::Label, |node| live(node, "1.4 kg"));
    let node = before.nodes.get_mut(&result).unwrap();
    node.set_description("Total weight");
    let mut after = before.clone();
    after.nodes.get_mut(&result).unwrap().set_value("0.7 kg");
    assert_eq!(announced(&before, &after), [(Urgency::Polite, "Total weight: 0.7 kg".to_owned())]);
    after.nodes.get_mut(&result).unwrap().clear_live();
    assert_eq!(announced(&before, &after), [], "what is not live any more");
}

#[test]
fn an_error_is_announced_also_where_its_number_was_another_widget_before() {
    let mut before = TestTree::new();
    let id = before.add(ROOT, Role::Heading, |node| label(node, "Weights"));
    let mut after = TestTree::new();
    assert_eq!(after.add(ROOT, Role::Label, |node| live(node, "not a number")), id);
    after.add(ROOT, Role::Heading, |node| label(node, "Weights"));
    assert_eq!(announced(&before, &after), [(Urgency::Polite, "not a number".to_owned())]);
    // The same words under the same number, which were no news before.
    let mut silent = after.clone();
    silent.nodes.get_mut(&id).unwrap().clear_live();
    assert_eq!(announced(&silent, &after), [(Urgency::Polite, "not a number".to_owned())]);
}

#[test]
fn all_that_is_news_at_once_is_announced() {
    let mut before = TestTree::new();
    before.add(ROOT, Role::Button, |node| control(node, "Example"));
    let mut after = before.clone();
    after.add(ROOT, Role::Label, |node| live(node, "1.4 kg"));
    after.add(ROOT, Role::Label, |node| live(node, "The example is filled in."));
    let words: Vec<String> = announced(&before, &after).into_iter().map(|(_, words)| words).collect();
    assert_eq!(words, ["1.4 kg", "The example is filled in."]);
}

#[test]
fn what_is_wrong_with_a_field_that_comes_with_it_is_not_announced() {
    let mut other = TestTree::new();
    other.add(ROOT, Role::Button, |node| control(node, "Learn"));
    let screen = |error: Option<&str>| {
        let mut tree = other.clone();
        let field = tree.add(ROOT, Role::TextInput, |node| node.set_label("Height"));
        if let Some(error) = error {
            let note = tree.add(ROOT, Role::Label, |node| live(node, error));
            tree.nodes.get_mut(&field).unwrap().set_described_by(vec![note]);
        }
        tree
    };
    assert_eq!(announced(&other, &screen(Some("not a number"))), []);
    assert_eq!(
        announced(&screen(None), &screen(Some("not a number"))),
        [(Urgency::Polite, "not a number".to_owned())]
    );
}
