//! The platform in a browser: storage, clipboard, the page's address and its system colors.
//!
//! Each tab keeps a state of its own, in the browser's session storage: a reload brings it back, whatever another tab has stored. A new
//! tab starts with the state that was stored last, which is in local storage; one that the browser makes by copying a tab starts with
//! that tab's.

use std::cell::RefCell;
use std::rc::Rc;

use wasm_bindgen::{JsCast as _, JsValue};

use crate::app::{Event, Licenses, Place, Platform, PlatformError, SystemColors};

/// The key in both storages. The number is the version of the format; one origin may serve several programs.
const STORAGE_KEY: &str = "depth-calculator/v1";

/// The events that the program has not handled yet. Clones share one list, as each listener of the browser has a clone of its own.
#[derive(Clone)]
pub(super) struct Inbox {
    events: Rc<RefCell<Vec<Event>>>,
    ctx: egui::Context,
}

impl Inbox {
    /// An empty inbox, which requests a repaint of `ctx` for each event.
    pub(super) fn new(ctx: &egui::Context) -> Self {
        Self {
            events: Rc::default(),
            ctx: ctx.clone(),
        }
    }

    /// Adds `event` and requests a repaint.
    pub(super) fn add(&self, event: Event) {
        self.events.borrow_mut().push(event);
        self.ctx.request_repaint();
    }
}

/// Stores in the browser and copies to the clipboard.
pub(super) struct Browser {
    inbox: Inbox,
}

impl Browser {
    /// The browser, whose events are read from `inbox`.
    pub(super) const fn new(inbox: Inbox) -> Self {
        Self { inbox }
    }
}

impl Platform for Browser {
    fn load(&self) -> Result<Option<String>, PlatformError> {
        if let Some(text) = own_text() {
            return Ok(Some(text).filter(|text| !text.is_empty()));
        }
        let last = storage()?
            .get_item(STORAGE_KEY)
            .map_err(|error| PlatformError::StorageNotRead { reason: sentence(&error) })?;
        keep_own(last.as_deref().unwrap_or_default());
        Ok(last)
    }

    fn save(&mut self, text: &str) -> Result<(), PlatformError> {
        keep_own(text);
        let outcome = storage().and_then(|storage| {
            storage
                .set_item(STORAGE_KEY, text)
                .map_err(|error| PlatformError::StorageNotWritten { reason: sentence(&error) })
        });
        super::page::note_kept(outcome.is_ok());
        outcome
    }

    fn set_aside(&mut self) -> Result<Option<Place>, PlatformError> {
        let outcome =
            storage().and_then(|storage| set_aside(&storage).map_err(|error| PlatformError::NotSetAside { reason: sentence(&error) }));
        super::page::note_kept(outcome.is_ok());
        outcome
    }

    fn copy(&mut self, _ctx: &egui::Context, text: String) {
        let clipboard = match clipboard() {
            Ok(clipboard) => clipboard,
            Err(error) => {
                self.inbox.add(Event::Copied(Err(error)));
                return;
            }
        };
        // Called here and not in the task: browsers allow it only soon after a click or a key, and some only while they handle it.
        let promise = clipboard.write_text(&text);
        let inbox = self.inbox.clone();
        wasm_bindgen_futures::spawn_local(async move {
            let outcome = wasm_bindgen_futures::JsFuture::from(promise).await;
            inbox.add(Event::Copied(match outcome {
                Ok(_undefined) => Ok(()),
                Err(error) => Err(PlatformError::CopyDenied { reason: sentence(&error) }),
            }));
        });
    }

    fn events(&mut self) -> Vec<Event> {
        self.inbox.events.take()
    }

    fn seconds(&self) -> f64 {
        let performance = web_sys::window().and_then(|window| window.performance());
        // Without a clock simulations take a frame as long as they like, once.
        performance.map_or(0.0, |performance| performance.now() / 1000.0)
    }

    fn commit(&self) -> Option<String> {
        let document = web_sys::window()?.document()?;
        let commit = document.query_selector("meta[name=commit]").ok()??.get_attribute("content")?;
        (!commit.is_empty()).then_some(commit)
    }

    fn licenses(&self) -> Licenses {
        Licenses::Page("licenses.html")
    }
}

fn storage() -> Result<web_sys::Storage, PlatformError> {
    web_sys::window()
        .ok_or(PlatformError::NoWindow)?
        .local_storage()
        .map_err(|error| PlatformError::StorageDenied { reason: sentence(&error) })?
        .ok_or(PlatformError::NoStorage)
}

/// The storage of this tab alone, unless the browser denies it.
fn own_storage() -> Option<web_sys::Storage> {
    web_sys::window()?.session_storage().ok()?
}

/// What this tab has stored. Empty where it started with nothing, and has nothing yet.
fn own_text() -> Option<String> {
    own_storage()?.get_item(STORAGE_KEY).ok()?
}

/// Stores `text` as the state of this tab.
fn keep_own(text: &str) {
    if let Some(storage) = own_storage()
        && storage.set_item(STORAGE_KEY, text).is_err()
    {
        // Better the state that any tab stored last than an old one of this.
        storage.remove_item(STORAGE_KEY).ok();
    }
}

/// Moves what this tab has stored, and what was stored last, to keys that nothing has. `assets/web/start.js` does the same.
fn set_aside(storage: &web_sys::Storage) -> Result<Option<Place>, JsValue> {
    let own = own_text().filter(|text| !text.is_empty());
    let last = storage.get_item(STORAGE_KEY)?;
    let mut key = None;
    if let Some(text) = &own {
        key = Some(copy_aside(storage, text)?);
    }
    if let Some(text) = last.filter(|text| own.as_ref() != Some(text)) {
        key = Some(copy_aside(storage, &text)?);
    }
    storage.remove_item(STORAGE_KEY)?;
    keep_own("");
    Ok(key.map(Place::Storage))
}

/// Stores `text` under a key that nothing has, and returns that.
fn copy_aside(storage: &web_sys::Storage, text: &str) -> Result<String, JsValue> {
    let mut key = format!("{STORAGE_KEY}/set aside");
    let mut number = 1;
    while storage.get_item(&key)?.is_some() {
        number += 1;
        key = format!("{STORAGE_KEY}/set aside {number}");
    }
    storage.set_item(&key, text)?;
    Ok(key)
}

fn clipboard() -> Result<web_sys::Clipboard, PlatformError> {
    let clipboard = web_sys::window().ok_or(PlatformError::NoWindow)?.navigator().clipboard();
    // `web-sys` has no type for it, but browsers leave it undefined on pages that are not a secure context.
    if clipboard.is_undefined() {
        return Err(PlatformError::NoClipboard);
    }
    Ok(clipboard)
}

/// The part behind the `#` of the page's address, once.
pub(super) fn link() -> Option<String> {
    let location = web_sys::window()?.location();
    let fragment = location.hash().ok()?;
    if fragment.is_empty() {
        return None;
    }
    // Removed from the address, so that a reload does not apply it again; `replace` adds no entry to the history.
    location.replace("#").ok()?;
    Some(fragment)
}

/// The system colors, where the browser uses forced colors; read from the computed style of a temporary element.
pub(super) fn system_colors() -> Option<SystemColors> {
    if !super::page::matches("(forced-colors: active)") {
        return None;
    }
    let window = web_sys::window()?;
    let document = window.document()?;
    let probe: web_sys::HtmlElement = document.create_element("span").ok()?.dyn_into().ok()?;
    document.body()?.append_child(&probe).ok()?;
    let color = |name: &str| {
        // With `forced-color-adjust: auto` the computed color would be that of the text.
        probe.style().set_css_text(&format!("forced-color-adjust:none;color:{name}"));
        let style = window.get_computed_style(&probe).ok()??;
        style.get_property_value("color").ok()
    };
    let colors = SystemColors::from_css(color);
    probe.remove();
    colors
}

/// The message of an exception of the browser, with a full stop.
pub(super) fn sentence(error: &JsValue) -> String {
    let mut text = match error.dyn_ref::<js_sys::Error>() {
        Some(error) => String::from(error.message()),
        None => error.as_string().unwrap_or_else(|| format!("{error:?}")),
    };
    if !text.ends_with(['.', '!', '?']) {
        text.push('.');
    }
    text
}
