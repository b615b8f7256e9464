//! Where the keyboard focus can be, and where it goes when the page changes.

use egui::accesskit::NodeId;

use crate::element::Element;
use crate::page::Page;

impl Page {
    /// Can the browser's focus be put on it?
    pub(crate) fn can_take_focus(&self, id: NodeId) -> bool {
        self.get(id).is_some_and(|element| element.attribute("tabindex").is_some()) && self.can_be_reached(id)
    }

    /// What the Tab key stops at, in its order.
    pub(crate) fn tab_stops(&self) -> impl DoubleEndedIterator<Item = NodeId> {
        let is_stop = |element: &&Element| element.attribute("tabindex") == Some("0");
        let stops = self.elements().iter().filter(is_stop).map(|element| element.id);
        stops.filter(|id| self.can_be_reached(*id))
    }

    /// The first stop of the Tab key inside the dialog that keeps everything else from being used.
    pub(crate) fn first_stop_in_dialog(&self) -> Option<NodeId> {
        let mut elements = self.elements().iter();
        let dialog = elements.find(|element| element.attribute("aria-modal").is_some())?;
        self.tab_stops().find(|stop| self.contains(dialog.id, *stop))
    }

    /// What is now what `before` was: the element with its name, or else the one with its node. egui numbers most widgets
    /// by their position, so when something appears above them, they can get another number and theirs another widget.
    pub(crate) fn successor(&self, before: &Element) -> Option<NodeId> {
        let is_it = |element: &&Element| {
            element.tag == before.tag && element.name == before.name && !before.name.is_empty() && self.can_take_focus(element.id)
        };
        let same_node = self.get(before.id);
        let successor = same_node.filter(is_it).or_else(|| self.elements().iter().find(is_it));
        let is_same_kind = |element: &&Element| element.tag == before.tag && self.can_take_focus(element.id);
        successor.or_else(|| same_node.filter(is_same_kind)).map(|element| element.id)
    }
}

/// Where the browser's focus belongs after a change of the page.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Destination {
    /// On this element, where egui's focus is by now.
    FollowEgui(NodeId),
    /// On this element, and egui's focus too.
    LeadEgui(NodeId),
    /// On the canvas: there is nothing else left.
    Canvas,
}

/// Where the focus belongs that was on `held` in the page `old`. It had been on `visited` before, the latest last.
pub(crate) fn destination(old: &Page, new: &Page, held: &Element, visited: &[NodeId]) -> Destination {
    if let Some(id) = new
        .focus()
        .filter(|id| Some(*id) != old.focus() && *id != held.id && new.can_take_focus(*id))
    {
        return Destination::FollowEgui(id);
    }
    let mut latest_first = visited.iter().rev().copied();
    // Back to where the person was, or into the dialog that is open.
    new.successor(held)
        .or_else(|| latest_first.find(|id| new.can_take_focus(*id)))
        .or_else(|| new.first_stop_in_dialog())
        .map_or(Destination::Canvas, Destination::LeadEgui)
}
