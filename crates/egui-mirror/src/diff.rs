//! What has to be done to a page so that it becomes another one, and what a person has to be told about it.

use egui::accesskit::{Live, NodeId, Toggled};

use crate::model::{Element, Page, Place};

/// One step, to be carried out in order.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Edit {
    /// Take the element away, with all that it still contains.
    Remove(NodeId),
    /// Make an element, not yet in the page.
    Create(NodeId, &'static str),
    /// Set an attribute, or take it away.
    Attribute(NodeId, &'static str, Option<String>),
    /// Set the text inside the element; it has no children.
    Text(NodeId, String),
    /// Set what stands in an input.
    Value(NodeId, String),
    /// Set the state of a box.
    Checked(NodeId, Toggled),
    /// Move the element.
    Place(NodeId, Place),
    /// Put these elements, in this order, into the element, or into the page itself.
    Children(Option<NodeId>, Vec<NodeId>),
}

/// The steps from `old` to `new`: none if they are equal.
pub(crate) fn diff(old: &Page, new: &Page) -> Vec<Edit> {
    let mut edits = Vec::new();
    for element in &old.elements {
        if !new.get(element.id).is_some_and(|now| is_same_element(now, element)) {
            edits.push(Edit::Remove(element.id));
        }
    }
    let mut structure = Vec::new();
    for element in &new.elements {
        let id = element.id;
        let before = old.get(id).filter(|before| is_same_element(before, element));
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

/// Can one become the other by changing its attributes? A box that becomes a text field would keep its tick.
fn is_same_element(one: &Element, other: &Element) -> bool {
    one.tag == other.tag && one.attributes.get("type") == other.attributes.get("type")
}

/// Has one of these become another kind of element?
fn remade(old: &Page, new: &Page, ids: &[NodeId]) -> bool {
    ids.iter().any(|id| match (old.get(*id), new.get(*id)) {
        (Some(was), Some(now)) => !is_same_element(was, now),
        _ => true,
    })
}

/// How urgently something is to be said.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Urgency {
    /// When the person is idle.
    Polite,
    /// At once.
    Assertive,
}

/// Something to be said aloud.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Announcement {
    /// Whose words they are: newer words of the same element replace older ones that nobody has heard yet.
    pub(crate) id: NodeId,
    pub(crate) urgency: Urgency,
    pub(crate) words: String,
}

/// The words of an element, behind what they are about: its description.
pub(crate) fn said(page: &Page, element: &Element) -> String {
    let words = page.words(element.id);
    match element.attributes.get("aria-description") {
        Some(about) if !words.is_empty() => format!("{about}: {words}"),
        _ => words,
    }
}

/// What is to be said aloud because it has appeared or changed.
///
/// A live region is announced by the browser when it changes, but not when it comes into the page with its words
/// already in it, and not what it is about. So what the application calls live is said by elements that have always been
/// there. The roles that are live by themselves (`alert`, `status`, …) are left to the browser, but for the words that a
/// `status` comes with.
pub(crate) fn announcements(old: &Page, new: &Page) -> Vec<Announcement> {
    // Nobody wants the whole page read out at its start.
    if old.elements.is_empty() {
        return Vec::new();
    }
    let all = new.elements.iter().filter_map(|element| {
        // egui numbers most widgets by their position, so what has this number now may have been something else.
        let before = old
            .get(element.id)
            .filter(|before| is_same_element(before, element) && before.live == element.live);
        let urgency = match (element.attributes.get("role").map(String::as_str), element.live) {
            (_, Some(Live::Off)) => return None,
            (Some("status"), _) if before.is_none() => Urgency::Polite,
            (Some("alert" | "alertdialog" | "status" | "log" | "timer" | "marquee"), _) => return None,
            (_, Some(Live::Assertive)) => Urgency::Assertive,
            (_, Some(Live::Polite)) => Urgency::Polite,
            _ => return None,
        };
        let words = said(new, element);
        let is_news = before.is_none_or(|before| said(old, before) != words);
        (is_news && !words.is_empty()).then_some(Announcement {
            id: element.id,
            urgency,
            words,
        })
    });
    all.collect()
}
