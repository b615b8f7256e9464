//! What was read of a camera, and what is wrong with it.

use crate::field::Key;
use crate::note::{Issue, Note};
use crate::reading::Reading;
use depth_core::in_image::InImage;
use depth_core::judge::{Refusal, Unsolvable};
use depth_core::measured::Measured;
use depth_core::problem::{Method, Solution};
use depth_core::quantity::{Length, Pixels, Quantity};

/// The σ of a distance, as a part of it, from which on it says little; of a ground distance as a part of the slant.
pub(super) const LARGEST_SIGMA: f64 = 0.3;

/// What was read, and what follows from it.
pub(super) struct Camera<'a> {
    pub(super) readings: &'a [&'a Reading],
    pub(super) solution: &'a Solution,
    pub(super) given: Option<(Method, Measured<Length>)>,
}

impl Camera<'_> {
    pub(super) fn reading(&self, key: Key) -> Option<&Reading> {
        self.readings.iter().copied().find(|reading| reading.key == key)
    }

    pub(super) fn pixels(&self, key: Key) -> Option<Pixels> {
        self.reading(key).map(|reading| Pixels::new(reading.value))
    }

    pub(super) fn measured<Q: Quantity>(&self, key: Key) -> Option<Measured<Q>> {
        self.reading(key)
            .map(|reading| Measured::from_base(reading.value, reading.sigma.unwrap_or(0.0)))
    }

    pub(super) fn fx(&self) -> Option<Measured<Pixels>> {
        self.solution.problem.focal_length?.px()
    }

    /// fy with the relative σ of fx.
    pub(super) fn fy_with_sigma(&self) -> Option<Measured<Pixels>> {
        let fy = self.fy()?.px();
        let own = self.solution.problem.fy.map_or(0.0, InImage::relative);
        let relative = if own > 0.0 {
            own
        } else {
            self.fx().map_or(0.0, Measured::relative)
        };
        Some(Measured::from_base(fy, fy * relative))
    }

    pub(super) fn fy(&self) -> Option<Pixels> {
        self.solution.problem.fy.and_then(InImage::px).or(self.fx()).map(|fy| fy.value)
    }
}

/// What is wrong with the value of `key`.
pub(super) fn refused(camera: &Camera<'_>, key: Key, error: Unsolvable) -> Note {
    let issue = match error {
        Unsolvable::Value {
            refusal: Refusal::Zero, ..
        } => Issue::Zero { key },
        Unsolvable::Value {
            refusal: Refusal::Negative,
            ..
        } => Issue::Negative { key },
        _ => Issue::TooExtreme {
            key,
            text: camera.reading(key).map_or_else(String::new, |reading| reading.number_text.clone()),
        },
    };
    Note::error(key, issue)
}
