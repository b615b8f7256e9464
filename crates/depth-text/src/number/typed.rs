//! What a text can be: a number with its unit ([`Typed`]), or none ([`NumberError`]).

use crate::unit::Unit;

/// A number and the unit typed behind it, if any.
#[derive(Clone, Debug, PartialEq)]
pub struct Typed {
    /// The number: finite.
    pub number: f64,
    /// The number as it was typed, without name, unit and surrounding spaces; of several units all of it.
    pub number_text: String,
    /// The unit, of several the first.
    pub unit: Option<Unit>,
    /// The unit as it was typed; empty where there is none or where it is in the number's text.
    pub unit_text: String,
    /// The unit of a bare number behind it, such as a σ: of several units the last.
    pub last_unit: Option<Unit>,
    /// Whether it was worked out: a product, a quotient, a fraction, several units.
    pub is_computed: bool,
}

/// What ′ and ″ mean behind a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Primes {
    /// Where lengths are typed.
    FeetAndInches,
    /// Where angles are typed.
    Arcminutes,
}

/// Why a text is not one number.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NumberError {
    /// There is no number in it.
    NotANumber,
    /// It could mean several numbers, or is grouped in a way that has to be confirmed. Each reading is a text that
    /// [`read`](fn@super::read) takes without asking again; there may be none.
    Ambiguous {
        /// What it may have meant.
        readings: Vec<String>,
    },
    /// A number, but what follows is not a unit.
    UnknownUnit(String),
    /// A number beyond what a computer's floating-point numbers hold.
    TooExtreme,
}

/// Nobody types a longer number; to look through a pasted book for one would take longer than a frame.
pub const LONGEST: usize = 500;
