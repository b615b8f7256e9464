//! Floor 5: entry points, and what only one platform has.

#[cfg(not(target_arch = "wasm32"))]
pub mod desktop;
#[cfg(target_arch = "wasm32")]
pub mod web;

// The mirror's pure parts are tested where tests run.
#[cfg(all(test, not(target_arch = "wasm32")))]
#[path = "web/mirror/mod.rs"]
mod mirror;
