//! [`Problem`] (what is known) to [`Solution`] (everything that follows from it). Every screen, the command line, links and
//! reports go through this one step, so that they cannot disagree.

mod check;
mod estimated;
mod inputs;
mod inverse;
mod solution;
mod solve;

pub use crate::agreement::Comparison;
pub use crate::field::{Field, better_unit};
pub use crate::judge::Refusal;
pub use crate::method::Method;
pub use crate::uncertainty::Uncertainty;
pub use inputs::Problem;
pub use inverse::Solved;
pub use solution::{BestDistance, Origin, Outcome, Solution};
