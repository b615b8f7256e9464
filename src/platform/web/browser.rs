//! The platform in a browser: storage, clipboard, the page's address and its system colors.
//!
//! Each tab keeps a state of its own, in the browser's session storage: a reload brings it back, whatever another tab has stored. A new
//! tab starts with the state that was stored last, which is in local storage; one that the browser makes by copying a tab starts with
//! that tab's.

use super::inbox::{Inbox, sentence};
use super::worker::Worker;
use depth_jobs::{Attachment, Job, Run};
use wasm_bindgen::JsValue;

use crate::app::{Event, FileContents, Licenses, Place, Platform, PlatformError};

/// The key in both storages. The number is the version of the format; one origin may serve several programs.
const STORAGE_KEY: &str = "depth-calculator/v1";

/// Stores in the browser and copies to the clipboard.
pub(super) struct Browser {
    inbox: Inbox,
    worker: Worker,
    /// Whether a screen has been shown since the page was loaded.
    has_screen: bool,
}

impl Browser {
    /// The browser, whose events are read from `inbox`.
    pub(super) fn new(inbox: Inbox) -> Self {
        Self {
            worker: Worker::new(&inbox),
            inbox,
            has_screen: false,
        }
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

    fn paste(&self, _ctx: &egui::Context) {
        let clipboard = match clipboard() {
            Ok(clipboard) => clipboard,
            Err(error) => {
                self.inbox.add(Event::Pasted(Err(error)));
                return;
            }
        };
        // The same as for copying. Some browsers know how to write, but not how to read.
        let can_read = js_sys::Reflect::has(&clipboard, &"readText".into()).unwrap_or(false);
        let promise = can_read.then(|| clipboard.read_text());
        let inbox = self.inbox.clone();
        wasm_bindgen_futures::spawn_local(async move {
            let refused = |error: &JsValue| PlatformError::PasteDenied { reason: sentence(error) };
            inbox.add(Event::Pasted(match promise {
                Some(promise) => match wasm_bindgen_futures::JsFuture::from(promise).await {
                    Ok(text) => Ok(text.as_string().unwrap_or_default()),
                    Err(error) => Err(refused(&error)),
                },
                None => Err(refused(&"It lets no page read the clipboard.".into())),
            }));
        });
    }

    fn save_file(&mut self, _ctx: &egui::Context, name: &str, contents: FileContents) {
        super::files::save(&self.inbox, name, contents);
    }

    fn open_files(&mut self, _ctx: &egui::Context) {
        super::opening::choose(&self.inbox);
    }

    fn start(&mut self, _ctx: &egui::Context, run: Run, job: Job, attachments: Vec<Attachment>) {
        self.worker.start(run, job, attachments);
    }

    fn cancel(&mut self, _ctx: &egui::Context, run: Run) {
        self.worker.cancel(run);
    }

    fn print(&mut self) -> bool {
        super::printing::print();
        true
    }

    fn today(&self) -> String {
        today()
    }

    fn address(&self) -> String {
        let address = web_sys::window()
            .and_then(|window| window.location().href().ok())
            .unwrap_or_default();
        address.split('#').next().unwrap_or_default().to_owned()
    }

    fn screen_shown(&mut self, name: &str, title: &str) {
        let window = web_sys::window();
        if let Some(document) = window.as_ref().and_then(web_sys::Window::document) {
            document.set_title(title);
        }
        if let Some(history) = window.and_then(|window| window.history().ok()) {
            let state = history.state().ok().and_then(|state| state.as_string());
            let is_first = !std::mem::replace(&mut self.has_screen, true);
            let outcome = match state {
                // The person went back or forward to it.
                Some(state) if state == name => Ok(()),
                _ if is_first => history.replace_state(&name.into(), ""),
                _ => history.push_state(&name.into(), ""),
            };
            // Some browsers allow so many a minute; the screen is shown all the same.
            outcome.ok();
        }
    }

    fn has_touch(&self) -> bool {
        super::page::matches("(pointer: coarse)")
    }

    fn events(&mut self) -> Vec<Event> {
        self.inbox.take()
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

/// The date where the person is, in the language of the program.
fn today() -> String {
    let options = js_sys::Object::new();
    for (part, form) in [("year", "numeric"), ("month", "long"), ("day", "numeric")] {
        // Setting what an object has not fails nowhere.
        js_sys::Reflect::set(&options, &part.into(), &form.into()).ok();
    }
    js_sys::Date::new_0().to_locale_date_string("en-US", &options).into()
}
