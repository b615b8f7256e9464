//! The accessible page: pure data, without a browser.

use std::collections::HashMap;

use egui::accesskit::{Node, NodeId};

use crate::element::Element;

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
                words.push_str(match self.get(*child).map_or("", |child| child.tag) {
                    "tr" => ". ",
                    "td" | "th" => ": ",
                    _ => " ",
                });
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

    /// Keeps what a screen reader would say of a field in which the browser's focus is, or to which it comes now, whenever it changes, as
    /// `old` has it: its description, as news is said by a live region, and while it `is_typed_in` whether it is valid. Returns whether that
    /// is not so any more.
    #[cfg(any(test, target_arch = "wasm32"))]
    pub(crate) fn keep_description(&mut self, old: &Self, id: NodeId, is_typed_in: bool) -> bool {
        let (Some(before), Some(element)) = (old.get(id), self.get_mut(id)) else {
            return false;
        };
        if !element.kind.is_text() || !before.is_same_element(element) {
            return false;
        }
        let mut is_kept = element.description != before.description;
        element.description.clone_from(&before.description);
        let validity = is_typed_in.then_some("aria-invalid");
        for name in ["aria-describedby", "aria-errormessage"].into_iter().chain(validity) {
            let value = before.attributes.get(name);
            if element.attributes.get(name) != value {
                is_kept = true;
                match value {
                    Some(value) => _ = element.attributes.insert(name, value.clone()),
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
