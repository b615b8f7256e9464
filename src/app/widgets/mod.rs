//! Widgets that two screens share.

pub mod bottom_bar;
pub mod cards;
pub mod choice;
pub mod field;
mod note_line;
pub mod picture;
pub mod plot;
pub mod progress;
pub mod scroll;
pub mod table;
pub mod text;
pub mod unit_choice;
