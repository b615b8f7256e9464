//! The cards of the results: which there are, and their titles.

use crate::core::problem::Method;
use depth_text::field::{Key, Section};
use depth_text::names::Named as _;

/// A card of the results. It is also the source of the card's egui id, so that neither layout nor language changes that.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Card {
    /// The quantity that was solved for, where it is not the distance.
    Solved(Key),
    /// No method has a distance yet.
    NoResult,
    /// The distance by one method, or why there is none.
    Distance(Method),
    /// The distances of both methods, combined.
    Combined,
    /// The share of each input in the variance of a distance.
    Budget(Method),
    /// The simulated distribution of a distance.
    Simulation(Method),
    /// The point in space, and its range.
    Range,
    /// A tilted target.
    Tilt,
    /// The ground plane.
    Ground,
    /// Two photographs and a step.
    TwoShots,
    /// Two points.
    TwoPoints,
    /// Both distances as bars.
    Bars,
    /// Distance against disparity.
    Curve,
    /// The estimated widths, and the distances.
    Intermediate,
    /// The scene from above.
    TopView,
    /// The table of inputs and outputs.
    Table,
}

impl Card {
    /// Its title, which is also its accessible name.
    pub fn title(self) -> &'static str {
        match self {
            Self::Solved(key) => key.name,
            Self::NoResult => "Result",
            Self::Distance(method) => method.name(),
            Self::Combined => "Combined",
            Self::Budget(Method::Stereo) => "What makes stereo uncertain",
            Self::Budget(Method::Monocular) => "What makes monocular uncertain",
            Self::Simulation(Method::Stereo) => "Stereo, simulated",
            Self::Simulation(Method::Monocular) => "Monocular, simulated",
            Self::Range => "Depth or range",
            Self::Tilt => "Tilted target",
            Self::Ground => "Ground plane, a third method",
            Self::TwoShots => Section::TwoShots.name(),
            Self::TwoPoints => Section::TwoPoints.name(),
            Self::Bars => "Stereo against monocular",
            Self::Curve => "Distance against disparity",
            Self::Intermediate => "Intermediate values",
            Self::TopView => "Top view, to scale",
            Self::Table => "Key input parameters and outputs",
        }
    }
}
