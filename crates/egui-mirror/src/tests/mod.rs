//! The pure part, tested without a browser.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "tests")]

mod announce;
mod describe;
mod diff;
mod focus;
mod keys;
mod parts;

use std::collections::HashMap;

use egui::Role;
use egui::accesskit::{Action, Node, NodeId};

use crate::page::{Nodes, Page};

const ROOT: NodeId = NodeId(0);

/// A tree for tests: nodes are made in order and numbered from 1; the root is 0.
#[derive(Clone)]
struct TestTree {
    nodes: Nodes,
}

impl TestTree {
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

    /// What a page is described from, with one CSS pixel to a unit and nothing modal.
    fn input(&self, focus: NodeId) -> crate::Tree<'_> {
        crate::Tree {
            nodes: &self.nodes,
            root: ROOT,
            focus,
            scale: 1.0,
            modal: false,
            input_mode: |_| None,
        }
    }

    fn focused(&self, focus: NodeId) -> Page {
        Page::describe(&self.input(focus))
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

#[test]
fn the_readme_shows_the_example_that_compiles() {
    let example = include_str!("../../examples/hello/web.rs").replace("\r\n", "\n");
    let readme = include_str!("../../README.md").replace("\r\n", "\n");
    assert!(readme.contains(&format!("```rust,ignore\n{example}```\n")));
}
