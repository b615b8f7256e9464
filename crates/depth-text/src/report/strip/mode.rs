//! What can be asked for.

use crate::field::Section;
use serde::{Deserialize, Serialize};

/// What is asked for.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Mode {
    /// The distance of an object.
    #[default]
    Distance,
    /// Another quantity of the same equations.
    Quantity,
    /// A point on the floor.
    Ground,
    /// Two photographs and a step.
    TwoShots,
    /// The length between two points.
    TwoPoints,
}

impl Mode {
    /// All of them, in reading order.
    pub const ALL: [Self; 5] = [Self::Distance, Self::Quantity, Self::Ground, Self::TwoShots, Self::TwoPoints];

    /// Those that are always in sight.
    pub const FIRST: [Self; 3] = [Self::Distance, Self::Quantity, Self::Ground];
    /// The others.
    pub const MORE: [Self; 2] = [Self::TwoShots, Self::TwoPoints];

    /// The mode in which the fields of `section` are shown and in no other.
    pub const fn of_section(section: Section) -> Option<Self> {
        match section {
            Section::Ground => Some(Self::Ground),
            Section::TwoShots => Some(Self::TwoShots),
            Section::TwoPoints => Some(Self::TwoPoints),
            _ => None,
        }
    }

    /// Whether it is about the distance of stereo and of a known size.
    pub const fn is_of_distance(self) -> bool {
        matches!(self, Self::Distance | Self::Quantity)
    }

    /// The cell of the [`Strip`](super::Strip) that is the answer, of which the others are parts or checks.
    pub const fn headline(self) -> usize {
        match self {
            Self::Distance | Self::Ground => 2,
            Self::Quantity | Self::TwoShots | Self::TwoPoints => 0,
        }
    }

    /// What it is chosen by.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Distance => "Distance",
            Self::Quantity => "Another quantity",
            Self::Ground => Section::Ground.name(),
            Self::TwoShots => Section::TwoShots.name(),
            Self::TwoPoints => Section::TwoPoints.name(),
        }
    }

    /// Its name where there is little room.
    pub const fn short_name(self) -> &'static str {
        match self {
            Self::Quantity => "Quantity",
            Self::Ground => "Ground",
            Self::TwoShots => "Two photos",
            _ => self.name(),
        }
    }
}
