//! What has to be done to a page so that it becomes another one.

use egui::accesskit::{NodeId, Toggled};

use crate::element::{Element, Lettering, Place};
use crate::page::Page;

/// One step, to be carried out in order.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Edit {
    /// Remove the element, with all that it still contains.
    Remove(NodeId),
    /// Make an element, not yet in the page.
    Create(NodeId, &'static str),
    /// Set an attribute, or take it away.
    Attribute(NodeId, &'static str, Option<String>),
    /// Set what the page says about the element to those who come to it, or take it away.
    About(NodeId, Option<String>),
    /// Set the text inside the element; it has no children.
    Text(NodeId, String),
    /// Set what stands in an input.
    Value(NodeId, String),
    /// Set the state of a box.
    Checked(NodeId, Toggled),
    /// Move the element.
    Place(NodeId, Place),
    /// Lay the text of the element over the painted text, or where the browser lays it.
    Lettering(NodeId, Option<Lettering>),
    /// Put these elements, in this order, into the element, or into the page itself.
    Children(Option<NodeId>, Vec<NodeId>),
}

/// The steps from `old` to `new`: none if they are equal.
pub(crate) fn diff(old: &Page, new: &Page) -> Vec<Edit> {
    let mut edits = Vec::new();
    for element in old.elements() {
        if !new.get(element.id).is_some_and(|now| now.is_same_element(element)) {
            edits.push(Edit::Remove(element.id));
        }
    }
    let mut structure = Vec::new();
    for element in new.elements() {
        let id = element.id;
        let before = old.get(id).filter(|before| before.is_same_element(element));
        if before.is_none() {
            edits.push(Edit::Create(id, element.tag));
        }
        for (name, value) in &element.attributes {
            if before.and_then(|before| before.attributes.get(name)) != Some(value) {
                edits.push(Edit::Attribute(id, name, Some(value.clone())));
            }
        }
        for name in before.iter().flat_map(|before| before.attributes.keys()) {
            if !element.attributes.contains_key(name) {
                edits.push(Edit::Attribute(id, name, None));
            }
        }
        let about = |element: &Element| element.description.clone().filter(|_| element.has_about());
        if before.and_then(about) != about(element) {
            edits.push(Edit::About(id, about(element)));
        }
        if before.and_then(|before| before.text.as_ref()) != element.text.as_ref() {
            edits.push(Edit::Text(id, element.text.clone().unwrap_or_default()));
        }
        if let Some(value) = &element.value
            && before.and_then(|before| before.value.as_ref()) != Some(value)
        {
            edits.push(Edit::Value(id, value.clone()));
        }
        if let Some(checked) = element.checked
            && before.and_then(|before| before.checked) != Some(checked)
        {
            edits.push(Edit::Checked(id, checked));
        }
        if before.map(|before| before.place) != Some(element.place) {
            edits.push(Edit::Place(id, element.place));
        }
        // Another text has another width in the font of the browser.
        let is_lettered = before.map_or(element.lettering.is_none(), |before| {
            before.lettering == element.lettering && (element.lettering.is_none() || before.text == element.text)
        });
        if !is_lettered {
            edits.push(Edit::Lettering(id, element.lettering));
        }
        let was = before.map_or(&[][..], |before| &before.children);
        if was != element.children || remade(old, new, was) {
            structure.push(Edit::Children(Some(id), element.children.clone()));
        }
    }
    if old.roots != new.roots || remade(old, new, &old.roots) {
        structure.push(Edit::Children(None, new.roots.clone()));
    }
    edits.append(&mut structure);
    edits
}

/// Which of these may stay where they are while the others are moved, by the places that they had: as many as can be, in rising order.
/// `None`: it was elsewhere. Source: patience sorting finds a longest increasing subsequence, Fredman 1975.
pub(crate) fn in_order(before: &[Option<usize>]) -> Vec<bool> {
    // For each length, the run of that length that ends earliest: where in `before` it ends, and what comes before each end.
    let mut ends: Vec<(usize, usize)> = Vec::new();
    let mut previous: Vec<Option<usize>> = Vec::new();
    for (at, place) in before.iter().enumerate() {
        let Some(place) = *place else {
            previous.push(None);
            continue;
        };
        let length = ends.partition_point(|(end, _)| *end < place);
        previous.push(length.checked_sub(1).and_then(|shorter| ends.get(shorter)).map(|(_, at)| *at));
        match ends.get_mut(length) {
            Some(end) => *end = (place, at),
            None => ends.push((place, at)),
        }
    }
    let mut stays = vec![false; before.len()];
    let mut last = ends.last().map(|(_, at)| *at);
    while let Some(at) = last {
        if let Some(stay) = stays.get_mut(at) {
            *stay = true;
        }
        last = previous.get(at).copied().flatten();
    }
    stays
}

/// Has one of these become another kind of element?
fn remade(old: &Page, new: &Page, ids: &[NodeId]) -> bool {
    ids.iter().any(|id| match (old.get(*id), new.get(*id)) {
        (Some(was), Some(now)) => !was.is_same_element(now),
        _ => true,
    })
}
