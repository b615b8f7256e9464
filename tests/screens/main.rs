//! The screens, driven by accessible name as a screen reader would.
#![allow(
    clippy::unwrap_used,
    clippy::expect_used,
    clippy::panic,
    clippy::indexing_slicing,
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    missing_docs,
    reason = "tests"
)]

mod about;
mod counted;
mod files;
mod form;
mod geometry;
mod helpers;
mod images;
mod keyboard;
mod known;
mod learn;
mod llvmpipe;
mod machine;
mod program;
mod results;
mod rigs;
mod snapshots;
mod still;
mod storage;
mod strip;
mod typing;
mod uncertainty;
mod window;
