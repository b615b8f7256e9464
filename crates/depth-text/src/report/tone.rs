//! Which method something belongs to, as its color says.

use crate::field::{Key, Section};
use depth_core::problem::Method;

/// Which method something belongs to, as its color says.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Tone {
    /// Two cameras: blue.
    Stereo,
    /// One camera and an object of known size: orange.
    Monocular,
    /// Both distances in one.
    Combined,
    /// Neither, or both.
    #[default]
    Neutral,
}

impl Tone {
    /// That of the field `key`: what both methods need is neutral.
    pub fn of(key: Key) -> Self {
        match key.section {
            Some(Section::Stereo) => Self::Stereo,
            Some(Section::Monocular) => Self::Monocular,
            _ => Self::Neutral,
        }
    }
}

impl From<Method> for Tone {
    fn from(method: Method) -> Self {
        match method {
            Method::Stereo => Self::Stereo,
            Method::Monocular => Self::Monocular,
        }
    }
}
