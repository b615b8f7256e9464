//! The answer as data: three cells that stand side by side, the same whatever is known.

mod cell;
mod distance;
mod ground;
mod line;
mod mode;
mod quantity;
mod refusal;
mod shown;
mod two;

pub use cell::{Badge, Cell, Quality, Value};
pub use line::{Line, Part};
pub use mode::Mode;
pub(super) use quantity::extent_of;
pub use quantity::formula as quantity_formula;
pub use shown::Shown;

/// The answer: three cells side by side.
#[derive(Clone, Debug, PartialEq)]
pub struct Strip {
    /// From left to right.
    pub cells: [Cell; 3],
}

impl Strip {
    /// The answer to what `mode` asks for.
    pub fn new(mode: Mode, shown: &Shown<'_>) -> Self {
        Self {
            cells: match mode {
                Mode::Distance => distance::cells(shown),
                Mode::Quantity => quantity::cells(shown),
                Mode::Ground => ground::cells(shown),
                Mode::TwoShots => two::shots(shown),
                Mode::TwoPoints => two::points(shown),
            },
        }
    }
}
