//! The browser as the machine that the program runs on.

use std::cell::{Cell, RefCell};
use std::rc::Rc;

use wasm_bindgen::{JsCast as _, JsValue};

use crate::app::Platform;

/// Where the state is stored. The number is the version of the form; one origin may serve several programs.
const STORAGE_KEY: &str = "depth-calculator/v1";

thread_local! {
    /// Another tab has stored something. The browser says so through an event.
    static FOREIGN_CHANGE: Cell<bool> = const { Cell::new(false) };
}

/// Notes that another tab has stored something.
pub(super) fn note_foreign_change() {
    FOREIGN_CHANGE.set(true);
}

/// Stores in the browser's local storage and copies to the clipboard.
#[derive(Default)]
pub(super) struct Browser {
    /// The outcome of the last copy. Shared, because the browser answers later.
    copied: Rc<RefCell<Option<Result<(), String>>>>,
}

impl Platform for Browser {
    fn load(&self) -> Result<Option<String>, String> {
        storage()?
            .get_item(STORAGE_KEY)
            .map_err(|error| format!("This browser does not let the page read what it stored: {}", sentence(&error)))
    }

    fn save(&mut self, text: &str) -> Result<(), String> {
        storage()?
            .set_item(STORAGE_KEY, text)
            .map_err(|error| format!("This browser could not store your inputs: {}", sentence(&error)))
    }

    fn copy(&mut self, ctx: &egui::Context, text: String) {
        self.copied.replace(None);
        let clipboard = match clipboard() {
            Ok(clipboard) => clipboard,
            Err(reason) => {
                self.copied.replace(Some(Err(reason)));
                return;
            }
        };
        // Called here and not in the task: browsers allow it only while they handle a click or a key.
        let promise = clipboard.write_text(&text);
        let copied = Rc::clone(&self.copied);
        let ctx = ctx.clone();
        wasm_bindgen_futures::spawn_local(async move {
            let outcome = wasm_bindgen_futures::JsFuture::from(promise).await;
            copied.replace(Some(match outcome {
                Ok(_undefined) => Ok(()),
                Err(error) => Err(format!("This browser refused to copy: {}", sentence(&error))),
            }));
            ctx.request_repaint();
        });
    }

    fn copied(&mut self) -> Option<Result<(), String>> {
        self.copied.take()
    }

    fn stored_elsewhere(&mut self) -> bool {
        FOREIGN_CHANGE.take()
    }

    fn link(&mut self) -> Option<String> {
        let location = web_sys::window()?.location();
        let fragment = location.hash().ok()?;
        if fragment.is_empty() {
            return None;
        }
        // A reload must not undo what was typed since; this leaves no entry in the history.
        location.replace("#").ok()?;
        Some(fragment)
    }
}

fn storage() -> Result<web_sys::Storage, String> {
    web_sys::window()
        .ok_or("There is no browser window.")?
        .local_storage()
        .map_err(|error| format!("This browser does not let the page store anything: {}", sentence(&error)))?
        .ok_or_else(|| "This browser has no storage for pages.".to_owned())
}

fn clipboard() -> Result<web_sys::Clipboard, String> {
    let clipboard = web_sys::window().ok_or("There is no browser window.")?.navigator().clipboard();
    // Typed as always there, but browsers leave it out of pages that did not arrive securely.
    if clipboard.is_undefined() {
        return Err("This browser copies only from pages that arrive over https or from this computer.".to_owned());
    }
    Ok(clipboard)
}

/// What an exception of the browser says, with a full stop.
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
