//! How long the program needs no frame, for the page, which rests as long (assets/web/rest.js).

use wasm_bindgen::{JsCast as _, JsValue};

/// Tells the page how long egui needs no frame, unless something happens.
#[derive(Default)]
pub(super) struct Rest;

impl egui::Plugin for Rest {
    fn debug_name(&self) -> &'static str {
        "rest"
    }

    fn output_hook(&mut self, _ctx: &egui::Context, output: &mut egui::FullOutput) {
        if let Some(viewport) = output.viewport_output.get(&egui::ViewportId::ROOT) {
            rest_for(1000.0 * viewport.repaint_delay.as_secs_f64());
        }
    }
}

/// Has the page go on: something has come that no event of the browser tells of.
pub(super) fn wake() {
    rest_for(0.0);
}

fn rest_for(milliseconds: f64) {
    let function = js_sys::Reflect::get(&js_sys::global(), &JsValue::from_str("restFor"));
    if let Some(function) = function.ok().and_then(|function| function.dyn_into::<js_sys::Function>().ok()) {
        // It throws nothing.
        function.call1(&JsValue::NULL, &JsValue::from_f64(milliseconds)).ok();
    }
}
