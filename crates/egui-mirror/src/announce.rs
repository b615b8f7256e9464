//! What a person has to be told about a change of the page.

use egui::accesskit::{Live, NodeId};

use crate::element::Element;
use crate::page::Page;

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
    match &element.description {
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
    if old.elements().is_empty() {
        return Vec::new();
    }
    // What is wrong with a field that comes with it, as on another screen, is heard by whoever comes to that field.
    let comes_with_field = |element: &Element| element.describes.is_some_and(|field| old.get(field).is_none());
    let all = new
        .elements()
        .iter()
        .filter(|element| !comes_with_field(element))
        .filter_map(|element| {
            // egui numbers most widgets by their position, so what has this number now may have been something else.
            let before = old
                .get(element.id)
                .filter(|before| before.is_same_element(element) && before.live == element.live);
            let urgency = match (element.role(), element.live) {
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
