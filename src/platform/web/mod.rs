//! The web page: starts the program on the canvas of `index.html`.
//!
//! Before this runs, `assets/web/start.js` has checked the browser and fetched the program.

mod browser;
mod files;
mod inbox;
mod leaving;
mod listeners;
mod opening;
mod page;
mod printing;
mod rest;
mod touch;
mod worker;

use std::rc::Rc;

use wasm_bindgen::JsCast as _;

use crate::app::{App, Copyable, PageFailure};
use browser::Browser;
use inbox::Inbox;
use leaving::PageApp;

/// Starts the program on `<canvas id="app">` and returns at once; the browser calls it from then on.
///
/// Any failure, now or later, is shown in place of the canvas.
pub fn main() {
    // Fails only when a logger is installed already.
    eframe::WebLogger::init(log::LevelFilter::Warn).ok();
    // Before `WebRunner::new`, whose own hook calls the previous one.
    std::panic::set_hook(Box::new(|panic| {
        page::show_failure(PageFailure::Stopped, &panic.to_string());
    }));
    let runner = eframe::WebRunner::new();
    wasm_bindgen_futures::spawn_local(async move {
        if let Err(reason) = start(&runner).await {
            page::show_failure(PageFailure::NotDrawing, &reason);
        }
    });
}

async fn start(runner: &eframe::WebRunner) -> Result<(), String> {
    let canvas = page::element("app")
        .ok_or("The page has no element with the id \"app\".")?
        .dyn_into::<web_sys::HtmlCanvasElement>()
        .map_err(|_element| "The element with the id \"app\" is not a canvas.")?;
    let (mirrored, running, touched) = (canvas.clone(), runner.clone(), canvas.clone());
    runner
        .start(
            canvas,
            options(),
            Box::new(move |creation| {
                creation.egui_ctx.add_plugin(FirstFrame::default());
                creation.egui_ctx.add_plugin(rest::Rest);
                let (ctx, clicked) = (creation.egui_ctx.clone(), running.clone());
                let options = egui_mirror::Options {
                    is_shortcut,
                    clicked: Rc::new(move |node| Copyable::by_author_id(node.author_id()).is_some_and(|what| copy(&clicked, &ctx, what))),
                    ..egui_mirror::Options::default()
                };
                if let Err(error) = egui_mirror::Mirror::install_with(&creation.egui_ctx, &mirrored, options) {
                    log::error!("The page works, but not with a screen reader: {}", inbox::sentence(&error));
                }
                let inbox = Inbox::new(&creation.egui_ctx);
                listeners::listen(&creation.egui_ctx, &inbox);
                opening::listen(&inbox);
                leaving::listen(&running, &creation.egui_ctx, &mirrored);
                touch::leave_to_touch_events();
                printing::listen(&running, &creation.egui_ctx, &mirrored);
                Ok(Box::new(PageApp::new(App::new(creation, Box::new(Browser::new(inbox))))))
            }),
        )
        .await
        .map_err(|error| inbox::sentence(&error))?;
    // Behind the listeners of eframe, which are there by now.
    touch::listen(touched);
    Ok(())
}

/// Whether a key shows another screen, also from a field. On a Mac, where Alt writes another character, these write nothing.
fn is_shortcut(key: &str, modifiers: egui::Modifiers) -> bool {
    modifiers.alt && !modifiers.ctrl && key.len() == 1 && key.starts_with(|c: char| c.is_ascii_digit())
}

/// Copies while the browser still handles the click. Returns whether the program was free to do it.
fn copy(runner: &eframe::WebRunner, ctx: &egui::Context, what: Copyable) -> bool {
    let page = runner.app_mut::<PageApp>();
    page.map(|mut page| page.app.copy(ctx, what)).is_some()
}

fn options() -> eframe::WebOptions {
    eframe::WebOptions {
        // assets/web/start.js has looked for it.
        webgl_context_option: eframe::WebGlContextOption::WebGl2,
        // Ctrl and the wheel, a pinch on a touch pad, or two fingers on the screen zoom the page as usual.
        should_prevent_default: Box::new(|event| match event {
            egui::Event::MouseWheel { modifiers, .. } => !modifiers.ctrl,
            egui::Event::Zoom(_) => false,
            _ => !touch::is_left_to_browser(),
        }),
        ..eframe::WebOptions::default()
    }
}

/// Hides the loading message after the first frame.
#[derive(Default)]
struct FirstFrame {
    drawn: bool,
}

impl egui::Plugin for FirstFrame {
    fn debug_name(&self) -> &'static str {
        "first frame"
    }

    fn output_hook(&mut self, _ctx: &egui::Context, _output: &mut egui::FullOutput) {
        if !self.drawn {
            self.drawn = true;
            page::show_program();
        }
    }
}
