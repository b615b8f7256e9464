//! An accessible mirror for [eframe](egui) on the web.
//!
//! eframe paints on a canvas, and a canvas is a blank picture to a screen reader, to the browser's search, to a braille
//! display and to a test that drives the page. egui describes every frame as an AccessKit tree, which eframe drops on
//! the web. `Mirror` is an [`egui::Plugin`] that takes the tree and keeps beside the canvas a real, invisible HTML
//! page that says the same: buttons are buttons, fields are fields, tables are tables, each at the place where it is
//! painted. What a person does with them goes back to egui as AccessKit actions and key presses.
//!
//! ```no_run
//! # #[cfg(target_arch = "wasm32")]
//! # fn example(cc: &eframe::CreationContext<'_>, canvas: &web_sys::HtmlCanvasElement) {
//! if let Err(error) = Mirror::install(&cc.egui_ctx, canvas) {
//!     log::error!("no accessible mirror: {error:?}");
//! }
//! # }
//! ```
//!
//! # The parts
//!
//! A pure part, the same on every platform: `roles` chooses an element for a role, `aria` its attributes, `element` makes one of a
//! node and `describe` a [`Page`] of the tree; `diff` finds what has changed, `announce` what of that is to be read aloud, `focus`
//! where the keyboard focus goes, and `keys` who gets a key. A thin part, in the folder `web`, carries this out in the browser.
//!
//! # Focus and keys
//!
//! While the canvas or eframe's hidden text field has the browser's focus (somebody clicked or touched), everything is
//! as eframe made it, and the canvas names the focused element to assistive technology (`aria-activedescendant`).
//! The key Tab leads into the mirror. There the elements themselves have the focus, one after the other in the
//! browser's own order, and egui's focus follows; so the order ends, and the next Tab is in the rest of the page: nobody
//! is caught. Escape and then Tab leaves at once, whichever element has the focus. In the mirror text is typed into real
//! fields, with the browser's own caret, input methods, dictation and on-screen keyboard, and egui shows what they hold.
//!
//! # What an author can say
//!
//! Everything is said in AccessKit, with `Context::accesskit_node_builder`: a role (`Heading` with a level, `Table`, `Status`, …), a
//! description, `set_live` for what is to be read aloud when it appears or changes (behind its description, which says what it
//! is about), `set_invalid`, `set_described_by`. A text field
//! with the role `NumberInput` gets the number keyboard of a phone.

#[cfg(any(test, target_arch = "wasm32"))]
mod announce;
mod aria;
#[cfg(any(test, target_arch = "wasm32"))]
mod caret;
mod describe;
#[cfg(any(test, target_arch = "wasm32"))]
mod diff;
mod element;
#[cfg(any(test, target_arch = "wasm32"))]
mod focus;
#[cfg(any(test, target_arch = "wasm32"))]
mod keys;
mod number;
mod page;
mod roles;
mod text;

#[cfg(test)]
mod tests;
#[cfg(target_arch = "wasm32")]
mod web;

pub use describe::Tree;
pub use element::{Allowed, Element, InputMode, Place, element_id};
pub use page::{Nodes, Page};
pub use roles::Kind;
#[cfg(target_arch = "wasm32")]
pub use web::{Mirror, Options};
