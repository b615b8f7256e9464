//! Widgets that two screens share.

pub mod bottom_bar;
pub mod cards;
pub mod chart;
pub mod choice;
pub mod common;
pub mod field;
pub mod figure;
pub mod joined;
pub mod main_button;
pub mod menu;
mod note_card;
pub mod note_line;
pub mod pairs;
pub mod picture;
pub mod progress;
pub mod scroll;
pub mod search;
pub mod segments;
pub mod symbols;
pub mod table;
pub mod text;
pub mod text_menu;
pub mod unit_choice;
