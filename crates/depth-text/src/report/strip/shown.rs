//! What the answer is made of.

use crate::assess::Assessment;
use crate::form::Inputs;
use depth_core::quantity::LengthUnit;

/// What the strip is made of.
#[derive(Clone, Copy, Debug)]
pub struct Shown<'a> {
    /// What was typed.
    pub inputs: &'a Inputs,
    /// What it means.
    pub assessment: &'a Assessment,
    /// The unit of the results.
    pub unit: LengthUnit,
    /// What was last valid, for as long as something is unreadable or refused.
    pub was: Option<&'a Assessment>,
}
