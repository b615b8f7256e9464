//! Text in and out: what people type, what it means, and what is said about it.
//!
//! ```text
//! Entry (as typed) -> Reading (parsed once) | Note (a sentence) -> Problem -> Solution -> report, link
//! ```
//!
//! [`fields`] is the table of everything that can be typed, [`sentences`] has everything that is said.

pub mod assess;
pub mod camera_sheet;
pub mod choices;
pub mod entry;
pub mod export;
pub mod field;
pub mod fields;
pub mod form;
pub mod geometry;
pub mod link;
mod lookup;
mod missing;
pub mod names;
pub mod note;
pub mod number;
mod problem;
pub mod q_matrix;
pub mod reading;
pub mod report;
pub mod sentences;
mod step;
pub mod style;
pub mod unit;
mod variants;
pub mod version1;
pub mod ways;
