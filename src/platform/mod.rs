//! Entry points, and what only one platform has.

#[cfg(not(target_arch = "wasm32"))]
pub mod desktop;
#[cfg(target_arch = "wasm32")]
pub mod web;

// The pure parts of the mirror, for tests on the host.
#[cfg(all(test, not(target_arch = "wasm32")))]
#[path = "web/mirror/mod.rs"]
mod mirror;
