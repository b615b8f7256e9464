//! The page in the browser.
//!
//! From the bottom up: `signals` are what listeners leave for egui's next frame; `elements`, `host`, `agent` and `caret` are the
//! parts of the DOM; `dom` makes them what egui says; `announcer` reads aloud, `gate` lets pointers through to the canvas;
//! `installed` holds all this where listeners find it; `events`, `keyboard` and `pointer` are the listeners; `plugin` is egui's
//! side.

mod agent;
mod announcer;
mod caret;
mod dom;
mod elements;
mod events;
mod gate;
mod host;
mod installed;
mod keyboard;
mod lettering;
mod listener;
mod options;
mod plugin;
mod pointer;
mod signals;
mod timer;

pub use options::Options;
pub use plugin::Mirror;
