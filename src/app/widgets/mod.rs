//! Pieces that two screens share.

pub mod cards;
pub mod foot;
pub mod number_field;
pub mod picture;
pub mod quantity_field;
pub mod scroll;
pub mod table;
pub mod text;
