#![doc = include_str!("../README.md")]
//!
//! # How it is built
//!
//! A pure part, the same on every platform: `roles` chooses an element for a role, `aria` its attributes, `element` makes one of a
//! node and `describe` a [`Page`] of the tree; `diff` finds what has changed, `announce` what of that is to be read aloud, `focus`
//! where the keyboard focus goes, and `keys` who gets a key. A thin part, in the folder `web`, carries this out in the browser.

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
pub use element::{Allowed, Element, InputMode, Lettering, Place, element_id};
pub use page::{Nodes, Page};
pub use roles::Kind;
#[cfg(target_arch = "wasm32")]
pub use web::{Mirror, Options};
