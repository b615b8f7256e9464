//! Widgets that two screens share.

pub mod bottom_bar;
pub mod cards;
pub mod number_field;
pub mod picture;
pub mod plot;
pub mod quantity_field;
pub mod scroll;
pub mod table;
pub mod text;
