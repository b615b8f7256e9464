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
    /// The whole text, line ends included.
    fn export(&self, results: &Results<'_>) -> String;
}
