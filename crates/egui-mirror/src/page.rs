//! The accessible page: pure data, without a browser.

use std::collections::HashMap;

use egui::accesskit::{Node, NodeId};

use crate::element::Element;
#[cfg(any(test, target_arch = "wasm32"))]
use crate::element::node_id;

/// The nodes of an AccessKit tree.
pub type Nodes = HashMap<NodeId, Node>;

/// All elements of the page, in reading order.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Page {
    elements: Vec<Element>,
    index: HashMap<NodeId, usize>,
    pub(crate) roots: Vec<NodeId>,
    pub(crate) focus: Option<NodeId>,
}

impl Page {
    /// All elements, in reading order: each before what is inside it.
    #[must_use]
    pub fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// The elements that lie in no other one, in reading order.
    #[must_use]
    pub fn roots(&self) -> &[NodeId] {
        &self.roots
    }

    /// The element that has egui's keyboard focus.
    #[must_use]
    pub fn focus(&self) -> Option<NodeId> {
        self.focus
    }

    /// The element that stands for a node.
    #[must_use]
    pub fn get(&self, id: NodeId) -> Option<&Element> {
        self.elements.get(*self.index.get(&id)?)
    }

    pub(crate) fn get_mut(&mut self, id: NodeId) -> Option<&mut Element> {
        self.elements.get_mut(*self.index.get(&id)?)
    }

    /// Adds an element behind all others in reading order.
    pub(crate) fn push(&mut self, element: Element) {
        self.index.insert(element.id, self.elements.len());
        self.elements.push(element);
    }

    /// All words of an element and of what lies inside it.
    #[must_use]
    pub fn words(&self, id: NodeId) -> String {
        let Some(element) = self.get(id) else { return String::new() };
        let own = element.text.as_deref().unwrap_or(&element.name);
        let mut words = own.to_owned();
        for child in &element.children {
            let inner = self.words(*child);
            if !words.is_empty() && !inner.is_empty() {
                words.push(' ');
            }
            words.push_str(&inner);
        }
        words
    }

    /// Does the element lie inside the other one, or is it the same?
    #[must_use]
    pub fn contains(&self, outer: NodeId, id: NodeId) -> bool {
        outer == id
            || self
                .get(outer)
                .is_some_and(|outer| outer.children.iter().any(|child| self.contains(*child, id)))
    }

    /// Is the element in the page, and not behind a modal dialog?
    #[must_use]
    pub fn can_be_reached(&self, id: NodeId) -> bool {
        let mut roots = self.roots.iter().copied();
        roots.any(|root| self.contains(root, id) && self.get(root).is_some_and(|root| root.attribute("inert").is_none()))
    }

    /// Keeps what a screen reader would say of the element that has the browser's focus whenever it changes, as `old` has it: its
    /// description as long as it has the focus, as news is said by a live region, and while it `is_typed_in` whether it is valid. Returns
    /// whether that is not so any more.
    #[cfg(any(test, target_arch = "wasm32"))]
    pub(crate) fn keep_description(&mut self, old: &Self, id: NodeId, is_typed_in: bool) -> bool {
        let Some(before) = old.get(id).cloned() else { return false };
        // What is gone describes nothing any more.
        let is_there = |other: &&str| node_id(other).is_none_or(|other| self.get(other).is_some());
        let present = |ids: &String| ids.split(' ').filter(is_there).collect::<Vec<_>>().join(" ");
        let before_of = |name: &str| before.attributes.get(name);
        let kept_of = |name: &str| before_of(name).map(present).filter(|ids| !ids.is_empty());
        let [description, message] = ["aria-describedby", "aria-errormessage"].map(kept_of);
        let validity = before_of("aria-invalid").cloned();
        let Some(element) = self.get_mut(id) else { return false };
        if !element.kind.is_text() || !before.is_same_element(element) {
            return false;
        }
        let kept = [("aria-describedby", description), ("aria-errormessage", message)];
        let kept = kept.into_iter().chain(is_typed_in.then_some(("aria-invalid", validity)));
        let mut is_kept = false;
        for (name, value) in kept {
            if element.attributes.get(name) != value.as_ref() {
                is_kept = true;
                match value {
                    Some(value) => _ = element.attributes.insert(name, value),
                    None => _ = element.attributes.remove(name),
                }
            }
        }
        is_kept
    }

    /// Is something open that Escape would close: a menu, a list of options, a dialog?
    #[cfg(any(test, target_arch = "wasm32"))]
    pub(crate) fn has_popup(&self) -> bool {
        let mut roles = self.elements.iter().map(Element::role);
        roles.any(|role| matches!(role, Some("listbox" | "menu" | "dialog" | "alertdialog")))
    }
}
