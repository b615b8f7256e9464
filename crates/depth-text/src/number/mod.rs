//! Numbers as people type and read them.

mod arithmetic;
mod clean;
mod compound;
mod read;
mod write;

pub(crate) use clean::{normalized, without_name};
pub(crate) use read::{LONGEST, words_after_squares};
pub use read::{NumberError, Primes, Typed, read};
pub(crate) use write::power;
pub use write::{NO_NUMBER, Notation, TYPED_DIGITS, exact, magnitude, plain, rounded_to, significant, with_minus};
