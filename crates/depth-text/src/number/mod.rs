//! Numbers as people type and read them.

mod arithmetic;
mod clean;
mod compound;
mod decimal;
mod half;
mod read;
mod split;
mod typed;
mod write;

pub(crate) use clean::{name, normalized, without_name};
pub use half::is_half_typed;
pub use read::read;
pub(crate) use read::words_after_squares;
pub(crate) use typed::LONGEST;
pub use typed::{NumberError, Primes, Typed};
pub(crate) use write::power;
pub use write::{NO_NUMBER, Notation, TYPED_DIGITS, exact, magnitude, plain, rounded_to, significant, with_minus};
