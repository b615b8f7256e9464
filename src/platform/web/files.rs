//! Files that the page gives out: the browser downloads them.

use super::inbox::{Inbox, sentence};
use crate::app::{Event, FileContents, Place, PlatformError};
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{Clamped, JsCast as _, JsValue};
use web_sys::{Blob, BlobPropertyBag, CanvasRenderingContext2d, HtmlAnchorElement, HtmlCanvasElement, ImageData, Url};

/// Starts the download of a file named `name`. A browser says nothing of it later: that it has started is the outcome.
pub(super) fn save(inbox: &Inbox, name: &str, contents: FileContents) {
    let outcome = match contents {
        FileContents::Page(html) => text(&html, "text/html;charset=utf-8").and_then(|page| download(&page, name)),
        FileContents::Data(json) => text(&json, "application/json").and_then(|data| download(&data, name)),
        FileContents::Picture(picture) => match save_picture(inbox, name, &picture) {
            // The outcome comes when the picture is encoded.
            Ok(()) => return,
            Err(error) => Err(error),
        },
    };
    inbox.add(outcome_of(outcome, name));
}

fn outcome_of(outcome: Result<(), JsValue>, name: &str) -> Event {
    Event::Saved(match outcome {
        Ok(()) => Ok(Place::Downloads(name.to_owned())),
        Err(error) => Err(PlatformError::NoDownload { reason: sentence(&error) }),
    })
}

fn text(text: &str, kind: &str) -> Result<Blob, JsValue> {
    let options = BlobPropertyBag::new();
    options.set_type(kind);
    Blob::new_with_str_sequence_and_options(&js_sys::Array::of1(&text.into()), &options)
}

/// Has the browser encode the picture: it can do that, and a library for it would have to be loaded by every visitor.
fn save_picture(inbox: &Inbox, name: &str, picture: &egui::ColorImage) -> Result<(), JsValue> {
    let document = web_sys::window().and_then(|window| window.document()).ok_or(JsValue::NULL)?;
    let canvas: HtmlCanvasElement = document.create_element("canvas")?.unchecked_into();
    let [width, height] = picture.size.map(|pixels| u32::try_from(pixels).unwrap_or(u32::MAX));
    canvas.set_width(width);
    canvas.set_height(height);
    let context: CanvasRenderingContext2d = canvas.get_context("2d")?.ok_or(JsValue::NULL)?.unchecked_into();
    let colors: Vec<u8> = picture
        .pixels
        .iter()
        .flat_map(|pixel| [pixel.r(), pixel.g(), pixel.b(), u8::MAX])
        .collect();
    let pixels = ImageData::new_with_u8_clamped_array_and_sh(Clamped(&colors), width, height)?;
    context.put_image_data(&pixels, 0.0, 0.0)?;
    let (inbox, name) = (inbox.clone(), name.to_owned());
    let encoded = Closure::once_into_js(move |png: Option<Blob>| {
        inbox.add(match png {
            Some(png) => outcome_of(download(&png, &name), &name),
            None => Event::Saved(Err(PlatformError::NoPicture)),
        });
    });
    canvas.to_blob(encoded.unchecked_ref())
}

/// Follows a link to `file` that is no part of the page, as there is no other way to start a download.
fn download(file: &Blob, name: &str) -> Result<(), JsValue> {
    let window = web_sys::window().ok_or(JsValue::NULL)?;
    let document = window.document().ok_or(JsValue::NULL)?;
    let link: HtmlAnchorElement = document.create_element("a")?.unchecked_into();
    let address = Url::create_object_url_with_blob(file)?;
    link.set_href(&address);
    link.set_download(name);
    link.click();
    // Some browsers read it only after the click has been handled.
    let forget = Closure::once_into_js(move || {
        Url::revoke_object_url(&address).ok();
    });
    window.set_timeout_with_callback_and_timeout_and_arguments_0(forget.unchecked_ref(), 60_000)?;
    Ok(())
}
