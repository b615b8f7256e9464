use egui::accesskit::Live;
use egui_mirror::Mirror;
use wasm_bindgen::{JsCast as _, JsValue};

#[derive(Default)]
struct Hello {
    name: String,
}

impl eframe::App for Hello {
    fn ui(&mut self, ui: &mut egui::Ui, _frame: &mut eframe::Frame) {
        let label = ui.label("Your name");
        ui.text_edit_singleline(&mut self.name).labelled_by(label.id);
        let greeting = ui.label(format!("Hello {}", self.name));
        // Read aloud when it changes.
        ui.accesskit_node_builder(greeting.id, |node| node.set_live(Live::Polite));
    }
}

/// Starts the program on `<canvas id="app">`.
pub async fn start() -> Result<(), JsValue> {
    let document = web_sys::window().and_then(|window| window.document());
    let canvas = document.and_then(|document| document.get_element_by_id("app")).ok_or("no canvas")?;
    let canvas: web_sys::HtmlCanvasElement = canvas.dyn_into()?;
    let mirrored = canvas.clone();
    let create: eframe::AppCreator<'static> = Box::new(move |creation| {
        Mirror::install(&creation.egui_ctx, &mirrored).map_err(|error| format!("{error:?}"))?;
        Ok(Box::new(Hello::default()))
    });
    eframe::WebRunner::new().start(canvas, eframe::WebOptions::default(), create).await
}
