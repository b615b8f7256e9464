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

    /// What is now what `held` was in the page `old`.
    ///
    /// The author's id decides, where there is one. Else it is the element of the same node, even if it has another name now. But
    /// egui numbers widgets to which nobody gave an id by their position: when something appears above them, they get another
    /// number, and theirs another widget. So where the name has changed and another element has just got it, it is that one.
    pub(crate) fn successor(&self, old: &Self, held: &Element) -> Option<NodeId> {
        if held.author_id.is_some() {
            let is_it = |element: &&Element| element.author_id == held.author_id && self.can_take_focus(element.id);
            return self.elements().iter().find(is_it).map(|element| element.id);
        }
        let fits = |element: &&Element| element.tag == held.tag && element.author_id.is_none() && self.can_take_focus(element.id);
        let same_node = self.get(held.id).filter(fits);
        if same_node.is_some_and(|element| element.name == held.name) {
            return Some(held.id);
        }
        let has_name = |element: &Element| element.tag == held.tag && element.name == held.name && !held.name.is_empty();
        let had_name = |element: &Element| old.get(element.id).is_some_and(has_name);
        let mut newcomers = self.elements().iter().filter(|element| has_name(element) && !had_name(element));
        newcomers.find(fits).or(same_node).map(|element| element.id)
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
    // A dialog begins with its first control, each time that it opens.
    let is_opened = new.first_stop_in_dialog().filter(|_| old.first_stop_in_dialog().is_none());
    if let Some(id) = is_opened {
        return Destination::LeadEgui(id);
    }
    let mut latest_first = visited.iter().rev().copied();
    // Back to where the person was, or into the dialog that is open.
    new.successor(old, held)
        .or_else(|| latest_first.find(|id| new.can_take_focus(*id)))
        .or_else(|| new.first_stop_in_dialog())
        // Where nothing is left of where the person was, at the beginning: the canvas says nothing.
        .or_else(|| new.tab_stops().next())
        .map_or(Destination::Canvas, Destination::LeadEgui)
}
