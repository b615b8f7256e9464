//! A small egui program on the web with an accessible page beside its canvas.

#[cfg(target_arch = "wasm32")]
mod web;

#[cfg(target_arch = "wasm32")]
fn main() {
    wasm_bindgen_futures::spawn_local(async {
        if let Err(error) = web::start().await {
            wasm_bindgen::throw_val(error);
        }
    });
}

#[cfg(not(target_arch = "wasm32"))]
fn main() {
    eprintln!("This runs in a browser only: build it with --target wasm32-unknown-unknown.");
}
