//! Fields looked up in the table: by name, by input, in order.

use crate::field::{Key, Section};
use crate::fields;
use depth_core::problem::Field;
use depth_core::setup::{Object, Pair};
use serde::{Deserialize, Deserializer};
use std::cmp::Ordering;

impl Key {
    /// The key that is written `name`, if there is one.
    pub fn named(name: &str) -> Option<Self> {
        fields::TABLE.iter().copied().find(|key| key.as_str() == name)
    }

    /// The fields of the form, in reading order.
    pub fn form() -> impl Iterator<Item = Self> {
        fields::TABLE.iter().copied().filter(|key| key.section.is_some())
    }

    /// Another field that is called `name`, as a log or a calibration file has it in front of its value; `None` where this one is too.
    pub(crate) fn another_named(self, name: &str) -> Option<Self> {
        let is_called = |key: &Self| {
            let noun = key.noun.trim_start_matches("the ");
            // D is a distance, d a disparity.
            let is_word = name.len() > 1;
            let words = [key.key, key.name, noun].into_iter();
            name == key.symbol || words.filter(|_| is_word).any(|word| word.eq_ignore_ascii_case(name))
        };
        if name.is_empty() || is_called(&self) {
            return None;
        }
        Self::form().chain([fields::DISTANCE]).find(is_called)
    }

    /// The same field in the words of what is measured by it.
    pub fn worded(self, object: Object, pair: Pair) -> Self {
        let words = match (object, pair) {
            (Object::Height, _) if self == fields::IMAGE_WIDTH => fields::IMAGE_HEIGHT,
            (Object::Height, _) if self == fields::REAL_WIDTH => fields::REAL_HEIGHT,
            (Object::Ball, _) if self == fields::IMAGE_WIDTH => fields::BALL_IN_IMAGE,
            (Object::Ball, _) if self == fields::REAL_WIDTH => fields::BALL_DIAMETER,
            (_, Pair::Vertical) if self == fields::BASELINE => fields::VERTICAL_BASELINE,
            (_, Pair::Vertical) if self == fields::DOFFS => fields::VERTICAL_DOFFS,
            (_, Pair::Vertical) if self == fields::DISPARITY => fields::VERTICAL_DISPARITY,
            _ => self,
        };
        debug_assert!(words == self, "other words make no other field");
        words
    }

    fn position(self) -> usize {
        fields::TABLE.iter().position(|&key| key == self).unwrap_or(usize::MAX)
    }
}

impl Section {
    /// Its fields, in reading order.
    pub fn keys(self) -> impl Iterator<Item = Key> {
        Key::form().filter(move |key| key.section == Some(self))
    }
}

impl From<Field> for Key {
    fn from(field: Field) -> Self {
        match field {
            Field::FocalLength => fields::FOCAL_LENGTH,
            Field::Lens => fields::FX_LENS,
            Field::Fy => fields::FY,
            Field::Baseline => fields::BASELINE,
            Field::Disparity => fields::DISPARITY,
            Field::Doffs => fields::DOFFS,
            Field::ImageWidth => fields::IMAGE_WIDTH,
            Field::RealWidth => fields::REAL_WIDTH,
            Field::Tilt => fields::TILT,
            Field::Zero => fields::ZERO,
        }
    }
}

/// In the order of the table, which is that of the form.
impl Ord for Key {
    fn cmp(&self, other: &Self) -> Ordering {
        self.position().cmp(&other.position())
    }
}

impl PartialOrd for Key {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl<'de> Deserialize<'de> for Key {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let name = String::deserialize(deserializer)?;
        Self::named(&name).ok_or_else(|| serde::de::Error::custom("no such field"))
    }
}
