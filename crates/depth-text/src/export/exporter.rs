//! What every format has in common.

use crate::assess::Assessment;
use crate::form::Inputs;
use depth_core::quantity::LengthUnit;

/// What is exported.
#[derive(Clone, Copy, Debug)]
pub struct Results<'a> {
    /// What was typed.
    pub inputs: &'a Inputs,
    /// What it means.
    pub assessment: &'a Assessment,
    /// The unit of the distances.
    pub unit: LengthUnit,
}

/// A format in which results leave the program.
pub trait Exporter {
    /// Why results cannot be given out in this format; [`Infallible`](std::convert::Infallible) where they always can.
    type Error;

    /// The whole text, line ends included.
    ///
    /// # Errors
    /// See [`Error`](Self::Error).
    fn export(&self, results: &Results<'_>) -> Result<String, Self::Error>;
}
