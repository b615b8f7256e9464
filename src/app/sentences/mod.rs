//! Every sentence of the application itself, as the `Display` of an enum with its facts: of the notice bar ([`NoticeText`]), of what the
//! machine refuses ([`PlatformError`]), what helps to enter and to understand ([`Hint`]), and what a picture shows, in words
//! ([`Description`]).
//!
//! All of them are shown by the snapshots in `tests/sentences/snapshots`. What is said of inputs and results is in
//! `depth_text::sentences`.

mod description;
mod hint;
mod notice;
#[cfg(any(target_arch = "wasm32", test))]
mod page_failure;
mod platform_error;

pub use description::{Description, TopView};
pub use hint::Hint;
pub use notice::{FreshStart, NoticeText};
#[cfg(target_arch = "wasm32")]
pub use page_failure::PageFailure;
pub use platform_error::{Place, PlatformError};

#[cfg(test)]
pub(crate) mod snapshot;
