//! Numbers as people type and read them.

mod read;
mod write;

pub(crate) use read::words_after_squares;
pub use read::{NumberError, Typed, read};
pub use write::{NO_NUMBER, Notation, TYPED_DIGITS, exact, magnitude, plain, rounded_to, significant, with_minus};
