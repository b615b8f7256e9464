//! Numbers, ids, and places in a text.

use egui::Role;
use egui::accesskit::NodeId;

use super::{ROOT, TestTree};
use crate::caret::{characters, text_position};
use crate::element::{element_id, node_id};
use crate::number::{bare_number, number};

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
    assert_eq!(element_id(NodeId(42)), "mirror-2a", "by nothing but its number");
    assert_eq!(node_id("app"), None);
}

#[test]
fn a_caret_is_found_in_the_run_that_holds_it() {
    let mut tree = TestTree::new();
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
fn a_character_outside_the_basic_plane_is_one_character_of_two_units() {
    let at = |units| characters("a😀b", units);
    assert_eq!([at(0), at(1), at(3), at(4), at(99)], [0, 1, 2, 3, 3]);
}
