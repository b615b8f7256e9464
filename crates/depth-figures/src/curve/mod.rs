//! "Distance against disparity" and "Disparity against distance": the hyperbola of a pair of cameras, with the current point on it.
//!
//! Disparities are those that enter the formula, with doffs in them; what a person types is without.

mod drawing;
mod labels;
mod layout;
mod model;
mod place;
#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::indexing_slicing, clippy::panic, reason = "tests")]
mod tests;
mod tip;

pub use layout::{Crosshair, Curve, Shown};
pub use model::{Axes, CurveModel, CurvePoint, Kind};
