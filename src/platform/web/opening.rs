//! Files that the page is given: chosen in the dialog of the browser, or dropped.

use super::inbox::{Inbox, sentence};
use super::listeners::{on, on_its_way};
use super::page;
use crate::app::{Event, OpenedFile, PlatformError};
use depth_jobs::{LARGEST_FILE, MOST_FILES, is_photograph};
use wasm_bindgen::{JsCast as _, JsValue};
use wasm_bindgen_futures::JsFuture;
use web_sys::{File, FileList, HtmlInputElement};

/// Files may be dropped anywhere on the page, whatever lies over the canvas there. Without this a browser would show them in its place.
pub(super) fn listen(inbox: &Inbox) {
    let Some(window) = web_sys::window() else { return };
    for event in ["dragenter", "dragover"] {
        on_its_way(&window, event, |event| event.prevent_default());
    }
    let inbox = inbox.clone();
    on_its_way(&window, "drop", move |event| {
        event.prevent_default();
        event.stop_propagation();
        // eframe would read them too, however large they are; what it has to hear is that they are no longer over the page.
        if let (Some(canvas), Ok(left)) = (page::element("app"), web_sys::DragEvent::new("dragleave")) {
            let _ = canvas.dispatch_event(&left);
        }
        let data = event.dyn_ref::<web_sys::DragEvent>().and_then(web_sys::DragEvent::data_transfer);
        if let Some(files) = data.and_then(|data| data.files()) {
            read(&inbox, &files, Event::Dropped);
        }
    });
}

/// Has the person choose files.
pub(super) fn choose(inbox: &Inbox) {
    if let Err(error) = try_choose(inbox) {
        let reason = sentence(&error);
        inbox.add(Event::Opened(Err(PlatformError::NoFileDialog { reason })));
    }
}

/// The dialog belongs to an input of the page, which nobody sees; the one of the last time is gone then.
fn try_choose(inbox: &Inbox) -> Result<(), JsValue> {
    const ID: &str = "calibration-files";
    let document = web_sys::window().and_then(|window| window.document()).ok_or(JsValue::NULL)?;
    if let Some(last) = document.get_element_by_id(ID) {
        last.remove();
    }
    let input: HtmlInputElement = document.create_element("input")?.unchecked_into();
    input.set_id(ID);
    input.set_type("file");
    input.set_multiple(true);
    input.set_hidden(true);
    document.body().ok_or(JsValue::NULL)?.append_child(&input)?;
    let (inbox, chosen) = (inbox.clone(), input.clone());
    on(&input, "change", move |_| {
        if let Some(files) = chosen.files() {
            read(&inbox, &files, Event::Opened);
        }
        chosen.remove();
    });
    input.click();
    Ok(())
}

/// Reads `files`, one after the other, and tells what came of it.
fn read(inbox: &Inbox, files: &FileList, event: fn(Result<Vec<OpenedFile>, PlatformError>) -> Event) {
    // A list of the browser is emptied when its event has been handled.
    let files: Vec<File> = (0..files.length()).filter_map(|at| files.get(at)).collect();
    let inbox = inbox.clone();
    wasm_bindgen_futures::spawn_local(async move { inbox.add(event(read_all(&files).await)) });
}

async fn read_all(files: &[File]) -> Result<Vec<OpenedFile>, PlatformError> {
    let bytes: f64 = files.iter().map(|file| file.size()).sum();
    if files.len() > MOST_FILES || files.len() > 1 && bytes > largest() {
        return Err(PlatformError::TooManyFiles);
    }
    let mut opened = Vec::new();
    for file in files {
        opened.push(read_one(file).await?);
    }
    Ok(opened)
}

/// As a browser counts bytes.
const fn largest() -> f64 {
    #[allow(clippy::cast_precision_loss, reason = "16 MB: all whole numbers up to 2⁵³ are exact")]
    let largest = LARGEST_FILE as f64;
    largest
}

async fn read_one(file: &File) -> Result<OpenedFile, PlatformError> {
    let name = file.name();
    match read_slices(file).await {
        Ok(Some(bytes)) => Ok(OpenedFile { name, bytes }),
        Ok(None) => Err(PlatformError::FileTooLarge { file: name }),
        Err(error) => Err(PlatformError::FileNotOpened {
            file: name,
            reason: sentence(&error),
        }),
    }
}

/// So much of a file is asked for at once, in bytes: there is never more of it than that beside what has been read.
const SLICE: f64 = 1_048_576.0;

/// What is in `file`, of a large photograph as much as is read; `None` of another that is larger.
async fn read_slices(file: &File) -> Result<Option<Vec<u8>>, JsValue> {
    let (size, mut begin) = (file.size().min(largest()), 0.0);
    let mut bytes = Vec::new();
    while begin < size {
        let end = size.min(begin + SLICE);
        let slice = file.slice_with_f64_and_f64(begin, end)?;
        let buffer = JsFuture::from(slice.array_buffer()).await?;
        bytes.extend(js_sys::Uint8Array::new(&buffer).to_vec());
        if file.size() > largest() && !is_photograph(&bytes) {
            return Ok(None);
        }
        begin = end;
    }
    Ok(Some(bytes))
}
