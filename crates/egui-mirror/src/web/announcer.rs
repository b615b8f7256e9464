//! Says aloud what the application calls live.

use std::cell::RefCell;

use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{Document, HtmlElement, Node};

use super::signals::TYPING;
use super::timer::Timer;
use crate::announce::{Announcement, Urgency, said};
use crate::page::Page;

/// Polite words wait until nothing has changed for so long: a result that changes with every key is said once.
pub(crate) const PAUSE_MS: i32 = 400;
/// Then they are removed again, so that nobody comes across words that are no longer true.
const KEEP_MS: i32 = 5000;

/// The elements that browsers watch, there from the start and empty, and what they are to say next.
pub(crate) struct Announcer {
    polite: HtmlElement,
    assertive: HtmlElement,
    waiting: RefCell<Vec<Announcement>>,
    timer: Timer,
}

impl Announcer {
    /// Makes its elements, at the end of `host`. `on_time` must call [`Self::say_waiting`].
    pub(crate) fn new(document: &Document, host: &Node, on_time: fn()) -> Result<Self, JsValue> {
        let region = |urgency: &str| -> Result<HtmlElement, JsValue> {
            let region: HtmlElement = document.create_element("div")?.dyn_into()?;
            region.set_attribute("aria-live", urgency)?;
            host.append_child(&region)?;
            Ok(region)
        };
        Ok(Self {
            polite: region("polite")?,
            assertive: region("assertive")?,
            waiting: RefCell::default(),
            timer: Timer::new(on_time),
        })
    }

    /// Has these said soon, with what waits already.
    pub(crate) fn announce(&self, announcements: Vec<Announcement>) {
        if announcements.is_empty() {
            return;
        }
        let mut waiting = self.waiting.borrow_mut();
        waiting.retain(|old| announcements.iter().all(|new| new.id != old.id));
        waiting.extend(announcements);
        drop(waiting);
        self.timer.start(if self.is_all_polite() { PAUSE_MS } else { 0 });
    }

    fn is_all_polite(&self) -> bool {
        self.waiting.borrow().iter().all(|one| one.urgency == Urgency::Polite)
    }

    /// Says what waits and is still so; when nothing waits, falls silent.
    pub(crate) fn say_waiting(&self, page: &Page) {
        // What is said of a number that is half typed may not be so of the whole.
        if TYPING.get().is_some() && self.is_all_polite() {
            self.timer.start(PAUSE_MS);
            return;
        }
        let mut waiting = self.waiting.take();
        // What is no longer so is not said: the error of a number that was only half typed.
        waiting.retain(|one| page.get(one.id).is_some_and(|element| said(page, element) == one.words));
        for (region, urgency) in [(&self.polite, Urgency::Polite), (&self.assertive, Urgency::Assertive)] {
            let words: Vec<&str> = waiting
                .iter()
                .filter(|one| one.urgency == urgency)
                .map(|one| one.words.as_str())
                .collect();
            let ends = |words: &&str| words.ends_with(['.', '!', '?']);
            let sentences: Vec<String> = words
                .iter()
                .map(|one| if ends(one) { (*one).to_owned() } else { format!("{one}.") })
                .collect();
            let words = sentences.join(" ");
            // The same words twice are a change only if something differs.
            let again = !words.is_empty() && region.text_content().as_deref() == Some(words.as_str());
            region.set_text_content(Some(&if again { format!("{words}\u{a0}") } else { words }));
        }
        if !waiting.is_empty() {
            self.timer.start(KEEP_MS);
        }
    }
}
