//! The cards: which there are, and their titles.

use crate::core::problem::Method;

/// A card. It is also the source of the card's egui id, so that neither layout nor language changes that.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Card {
    /// What the letters mean, while nothing is known.
    Letters,
    /// The example that stands in the empty form.
    Example,
    /// Where the uncertainty comes from.
    Budget,
    /// What else is to be said about the answers.
    Remarks,
    /// How a way to a distance works, and what it is good for.
    How,
    /// The simulated distribution of a distance.
    Simulation(Method),
    /// Both distances on one axis.
    Bars,
    /// What of an answer's uncertainty goes where one input is exact.
    Gains,
    /// Distance against disparity.
    Curve,
    /// Disparity against distance.
    InverseCurve,
    /// The scene from above.
    TopView,
    /// The camera, the ray and the floor from the side, and the point in the image.
    SideView,
    /// The point in the image, a picture in the card from the side.
    Image,
    /// The floor from above.
    Floor,
    /// The table of inputs and outputs.
    Table,
}

impl Card {
    /// Its title, which is also its accessible name.
    pub const fn title(self) -> &'static str {
        match self {
            Self::Letters => "What the letters mean",
            Self::Example => "Example in gray",
            Self::Budget => "Where the uncertainty comes from",
            Self::Remarks => "Remarks",
            Self::How => "How it works",
            Self::Simulation(Method::Stereo) => "Stereo, simulated",
            Self::Simulation(Method::Monocular) => "Monocular, simulated",
            Self::Bars => "Stereo against monocular",
            Self::Gains => "If one input were exact",
            Self::Curve => "Distance against disparity",
            Self::InverseCurve => "Disparity against distance",
            Self::TopView | Self::Floor => "Top view",
            Self::SideView => "Side view",
            Self::Image => "In the image",
            Self::Table => "Key input parameters and outputs",
        }
    }
}
