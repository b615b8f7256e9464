//! What was typed last is kept when the page is left.
//!
//! Browsers say that a page is hidden or left (`visibilitychange`, `pagehide`), and may never give it a frame again. What was typed since
//! the last frame waits in two places: with eframe, which gives it to nobody, and in the accessible mirror. So eframe is made to run a
//! frame at once ([`run_frame`]). It does so whenever a pointer is pressed on the canvas: a press is made up, and taken out again before
//! egui sees it.

use egui::{Event, PointerButton, RawInput, ViewportId};

use super::listeners::on;
use crate::app::App;

/// The application in a page that may be left at any time.
pub(super) struct PageApp {
    pub(super) app: App,
    /// The page is being left: a frame is run for what was typed last.
    is_leaving: bool,
    /// Events for the next frame: the page has lost the focus, and what came after.
    later: Vec<Event>,
}

impl PageApp {
    pub(super) const fn new(app: App) -> Self {
        Self {
            app,
            is_leaving: false,
            later: Vec::new(),
        }
    }
}

impl eframe::App for PageApp {
    fn as_any_mut(&mut self) -> Option<&mut dyn std::any::Any> {
        Some(self)
    }

    fn logic(&mut self, ctx: &egui::Context, frame: &mut eframe::Frame) {
        self.app.logic(ctx, frame);
    }

    fn ui(&mut self, ui: &mut egui::Ui, frame: &mut eframe::Frame) {
        self.app.ui(ui, frame);
    }

    fn raw_input_hook(&mut self, ctx: &egui::Context, input: &mut RawInput) {
        input.events.retain(|event| !is_made_up(event));
        let viewport = input.viewports.entry(ViewportId::ROOT).or_default();
        if self.is_leaving {
            viewport.occluded = Some(false);
        } else if viewport.occluded == Some(true) {
            // Without a frame the events stay where they are.
            return;
        }
        input.events.splice(0..0, self.later.drain(..));
        // What was typed before the page lost the focus is for the field that had it.
        if let Some(lost) = input
            .events
            .iter()
            .position(|event| *event == Event::WindowFocused(false))
            .filter(|lost| *lost > 0)
        {
            self.later = input.events.split_off(lost);
            input.focused = true;
            ctx.request_repaint();
        }
    }
}

/// The button of a press that is made up: nothing in the program uses it.
const BUTTON: (i16, PointerButton) = (4, PointerButton::Extra2);

fn is_made_up(event: &Event) -> bool {
    matches!(event, Event::PointerButton { button, .. } if *button == BUTTON.1)
}

/// Keeps what was typed whenever the page is hidden or left.
pub(super) fn listen(runner: &eframe::WebRunner, ctx: &egui::Context, canvas: &web_sys::HtmlCanvasElement) {
    let Some(window) = web_sys::window() else { return };
    let keep = {
        let (runner, ctx, canvas) = (runner.clone(), ctx.clone(), canvas.clone());
        move || keep(&runner, &ctx, &canvas)
    };
    if let Some(document) = window.document() {
        let (hidden, keep) = (document.clone(), keep.clone());
        on(&document, "visibilitychange", move |_| {
            if hidden.hidden() {
                keep();
            }
        });
    }
    on(&window, "pagehide", move |_| keep());
}

/// Has eframe run a frame now, without painting it.
pub(super) fn run_frame(canvas: &web_sys::HtmlCanvasElement) {
    let press = web_sys::PointerEventInit::new();
    press.set_button(BUTTON.0);
    if let Ok(press) = web_sys::PointerEvent::new_with_event_init_dict("pointerdown", &press) {
        canvas.dispatch_event(&press).ok();
    }
}

/// Runs a frame for what was typed since the last, and saves. There is no program before the first frame and after a failure.
pub(super) fn keep(runner: &eframe::WebRunner, ctx: &egui::Context, canvas: &web_sys::HtmlCanvasElement) {
    let set_leaving = |is_leaving| {
        let page = runner.app_mut::<PageApp>();
        page.map(|mut page| page.is_leaving = is_leaving).is_some()
    };
    if !set_leaving(true) {
        return;
    }
    run_frame(canvas);
    set_leaving(false);
    if let Some(mut page) = runner.app_mut::<PageApp>() {
        page.app.finish(ctx);
    }
}
