//! The module that a browser runs beside the page. `assets/web/worker.js` starts it, hands it what the page asks, and has it do a piece
//! of work at a time.

#[cfg(target_arch = "wasm32")]
fn main() {}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This program runs in a browser only.");
}

#[cfg(target_arch = "wasm32")]
mod web {
    use depth_jobs::engine::Engine;
    use depth_jobs::{PROTOCOL, Report};
    use wasm_bindgen::JsValue;
    use wasm_bindgen::prelude::wasm_bindgen;

    /// Does the work that a page asks for.
    #[wasm_bindgen]
    #[derive(Default)]
    pub struct Worker {
        engine: Engine,
        is_greeted: bool,
    }

    #[wasm_bindgen]
    impl Worker {
        /// One without work.
        #[wasm_bindgen(constructor)]
        pub fn new() -> Self {
            Self::default()
        }

        /// Takes a request: its header, and its attachments as an array of `Uint8Array`.
        ///
        /// # Errors
        /// What is wrong with the header.
        pub fn receive(&mut self, header: &str, attachments: &js_sys::Array) -> Result<(), JsValue> {
            let request = serde_json::from_str(header).map_err(|error| JsValue::from_str(&error.to_string()))?;
            let attachments = attachments.iter().map(|bytes| js_sys::Uint8Array::new(&bytes).to_vec());
            self.engine.receive(request, attachments.collect());
            Ok(())
        }

        /// Does a piece of work. Returns whether any is left.
        pub fn step(&mut self) -> bool {
            self.engine.step()
        }

        /// The header of the next report; nothing where there is none.
        pub fn report(&mut self) -> Option<String> {
            let report = if std::mem::replace(&mut self.is_greeted, true) {
                self.engine.report()?
            } else {
                Report::Ready { protocol: PROTOCOL }
            };
            serde_json::to_string(&report).ok()
        }
    }
}
