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
    /// Where they come from.
    pub provenance: Provenance<'a>,
}

/// Where results come from: given by the caller, as an exporter has no clock and no address. What is empty is left out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Provenance<'a> {
    /// The version of the program: "0.1.0".
    pub version: &'a str,
    /// The day: "November 25, 2026".
    pub date: &'a str,
    /// The link that opens the same form again.
    pub link: &'a str,
}

/// What the program is called in what leaves it.
pub const PROGRAM: &str = "Depth Calculator";

impl Provenance<'_> {
    /// Program and version: "Depth Calculator 0.1.0".
    pub fn program(&self) -> String {
        format!("{PROGRAM} {}", self.version).trim_end().to_owned()
    }

    /// Program, version and day with `separator` between: "Depth Calculator 0.1.0, November 25, 2026".
    pub(super) fn line(&self, separator: &str) -> String {
        if self.date.is_empty() {
            return self.program();
        }
        format!("{}{separator}{}", self.program(), self.date)
    }
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
