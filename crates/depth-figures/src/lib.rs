//! The pictures of Depth Calculator: pure models and pure layouts that give a [`Figure`], a list of shapes. A window paints it, a
//! printed page and a report have it as [SVG](svg), so that paper and screen show the same.
//!
//! Nothing here knows a screen toolkit. Coordinates are points (CSS pixels), x to the right and y down from the upper left corner of
//! the figure. Colors are named by what they mean ([`Ink`]).

pub mod axis;
pub mod bars;
mod below;
pub mod budget;
pub mod curve;
mod figure;
mod floor;
pub mod ground;
pub mod histogram;
mod ink;
mod labels;
pub mod letters;
mod measure;
mod numbers;
pub mod rows;
pub mod sources;
pub mod spans;
pub mod svg;
pub mod top_view;
mod words;

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "tests")]
mod checks;
#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "tests")]
mod faults;
#[cfg(test)]
#[allow(clippy::indexing_slicing, clippy::panic, reason = "tests")]
mod rows_tests;

pub use figure::{Figure, Fill, Point, Rect, Shape, Stroke};
pub use ink::Ink;
pub use measure::{InterWidths, Measure};
pub use words::{Align, Run, Words, split_symbol, symbols_in};
