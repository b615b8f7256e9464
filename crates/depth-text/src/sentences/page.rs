//! The headings and the foot of the report.

use crate::report::Mode;
use std::fmt::{self, Display, Formatter};

/// A heading or a sentence of the report.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the facts of a sentence have the names of what they are")]
pub enum Page {
    /// What it is about.
    Title(Mode),
    /// The table.
    Table,
    /// The budget.
    WhereUncertaintyComesFrom,
    /// What cannot be used or is not there.
    WhatIsMissing,
    /// The fields.
    Form,
    /// What ± is, and what is counted once.
    EveryValue { has_sigma: bool, is_combined: bool },
    /// In front of the link.
    OpenAgain,
}

impl Display for Page {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Title(Mode::Distance) => "Distance of an object",
            Self::Title(Mode::Quantity) => "A quantity for a given distance",
            Self::Title(Mode::Ground) => "Point on the floor",
            Self::Title(Mode::TwoShots) => "Distance from two photographs",
            Self::Title(Mode::TwoPoints) => "Length between two points",
            Self::Table => "Key input parameters and outputs",
            Self::WhereUncertaintyComesFrom => "Where the uncertainty comes from",
            Self::WhatIsMissing => "What is missing or cannot be used",
            Self::Form => "What was entered",
            Self::EveryValue { has_sigma: false, .. } => "Without ± an input counts as exact.",
            Self::EveryValue { is_combined: false, .. } => "Every value ± 1 σ (k = 1). Without ± an input counts as exact.",
            Self::EveryValue { is_combined: true, .. } => {
                "Every value ± 1 σ (k = 1). The focal length enters both methods; the combined distance counts it once."
            }
            Self::OpenAgain => "Open again:",
        })
    }
}
