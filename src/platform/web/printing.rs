//! The report on paper: the page holds an element that is hidden on the screen and alone on paper (assets/web/page.css), and is filled
//! whenever the browser is about to print.

use super::leaving::{self, PageApp};
use super::listeners::on;
use super::page;
use crate::app::INTER;
use wasm_bindgen::closure::Closure;
use wasm_bindgen::{JsCast as _, JsValue};
use web_sys::{FontFace, FontFaceDescriptors, KeyboardEvent};

/// Fills in the report before the browser prints, and leaves the key for printing to the browser.
pub(super) fn listen(runner: &eframe::WebRunner, ctx: &egui::Context, canvas: &web_sys::HtmlCanvasElement) {
    let Some(window) = web_sys::window() else { return };
    let (runner, ctx, canvas) = (runner.clone(), ctx.clone(), canvas.clone());
    let mut has_fonts = false;
    on(&window, "beforeprint", move |_| {
        if !has_fonts {
            has_fonts = true;
            if add_fonts().is_err() {
                log::warn!("The report is printed in another font than the program's.");
            }
        }
        // What was typed last counts.
        leaving::keep(&runner, &ctx, &canvas);
        if let Some(page) = runner.app_mut::<PageApp>() {
            fill_in(&page.app.report_body());
        }
    });
    leave_key_to_browser(&window);
}

/// Gives the page the fonts that the pictures of the report are laid out for. They are in the program already.
fn add_fonts() -> Result<(), JsValue> {
    let Some(document) = web_sys::window().and_then(|window| window.document()) else {
        return Ok(());
    };
    for (weight, file) in INTER {
        let descriptors = FontFaceDescriptors::new();
        descriptors.set_weight(weight);
        let face = FontFace::new_with_u8_array_and_descriptors("Inter", file, &descriptors)?;
        document.fonts().add(&face)?;
    }
    Ok(())
}

fn fill_in(report: &str) {
    if let Some(element) = page::element("report") {
        element.set_inner_html(report);
    }
}

/// The browser prints by itself on Ctrl + P. The program, which has a command with that key, would print once more, and eframe would keep
/// the key from the browser. Both listen farther down: events come to the window first.
fn leave_key_to_browser(window: &web_sys::Window) {
    let listener = Closure::<dyn FnMut(KeyboardEvent)>::new(|event: KeyboardEvent| {
        let is_print = (event.ctrl_key() || event.meta_key()) && !event.alt_key() && event.key().eq_ignore_ascii_case("p");
        if is_print {
            event.stop_immediate_propagation();
        }
    });
    let added = window.add_event_listener_with_callback_and_bool("keydown", listener.as_ref().unchecked_ref(), true);
    if added.is_err() {
        log::warn!("The page cannot listen to keydown.");
    }
    listener.forget();
}

/// Opens the dialog of the browser as soon as the program, which asks for it in the middle of a frame, can be asked for its report.
pub(super) fn print() {
    wasm_bindgen_futures::spawn_local(async {
        if let Some(window) = web_sys::window()
            && window.print().is_err()
        {
            log::warn!("The browser does not print.");
        }
    });
}
