//! The form as typed.

use crate::entry::{Entries, Entry};
use crate::field::{Key, Section};
use crate::fields;
use depth_core::problem::{Field, Method};
use depth_core::quantity::LengthUnit;
use depth_core::setup::{Object, Pair};
use serde::{Deserialize, Serialize};

/// Everything typed into the form.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(from = "Stored")]
pub struct Inputs {
    /// What was typed, the distance included, by field.
    pub entries: Entries,
    /// What is solved for, where it is not the distance.
    pub unknown: Option<(Method, Field)>,
    /// What of the object is measured.
    #[serde(skip_serializing_if = "is_default")]
    pub object: Object,
    /// How the cameras stand.
    #[serde(skip_serializing_if = "is_default")]
    pub pair: Pair,
}

/// The form as it is stored, also by programs in which σ could be switched off.
#[derive(Debug, Default, Deserialize)]
#[serde(default)]
struct Stored {
    entries: Entries,
    with_uncertainty: Option<bool>,
    unknown: Option<(Method, Field)>,
    object: Object,
    pair: Pair,
}

impl From<Stored> for Inputs {
    /// A σ that was typed and switched off did not count: it is left out.
    fn from(stored: Stored) -> Self {
        let mut inputs = Self {
            entries: stored.entries,
            unknown: stored.unknown,
            object: stored.object,
            pair: stored.pair,
        };
        if stored.with_uncertainty == Some(false) {
            inputs.drop_hidden_sigmas();
        }
        inputs
    }
}

fn is_default<T: Default + PartialEq>(value: &T) -> bool {
    *value == T::default()
}

/// A worked example that a button fills in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Example {
    /// 700 px, 10 cm, 50 px: 1.4 m by stereo.
    CoffeeMug,
    /// 950 px, 0.9 m, 200 px: 4.275 m by its width.
    Doorway,
    /// What stands in gray in the empty form, with every σ: 1.4 m by both methods.
    Parcel,
    /// A camera 1.2 m above the floor that looks 10° down: a point 3.74 m away along the floor.
    Mast,
}

impl Example {
    /// Those that have a link of their own, of distances and of the ground plane.
    pub const ALL: [Self; 3] = [Self::CoffeeMug, Self::Doorway, Self::Mast];

    /// The name of its link.
    pub const fn name(self) -> &'static str {
        match self {
            Self::CoffeeMug => "Coffee mug (stereo)",
            Self::Doorway => "Doorway (monocular)",
            Self::Parcel => "Parcel (both)",
            Self::Mast => "Camera on a mast (ground plane)",
        }
    }

    /// The text of its link: the beginning of its name.
    pub fn short_name(self) -> &'static str {
        self.name().split(" (").next().unwrap_or_default()
    }

    /// Whether it is of the ground plane.
    pub const fn is_of_ground(self) -> bool {
        matches!(self, Self::Mast)
    }

    /// The form filled in. Source: the two worked examples of the page that this program reproduces.
    pub fn inputs(self) -> Inputs {
        let mut inputs = Inputs::default();
        match self {
            Self::Parcel => return inputs.with_examples(),
            Self::CoffeeMug => {
                inputs.entry_mut(fields::FOCAL_LENGTH).text = "700".into();
                inputs.fill(fields::BASELINE, Entry::new("10", Some(LengthUnit::Centimeter)));
                inputs.entry_mut(fields::DISPARITY).text = "50".into();
            }
            Self::Mast => {
                for (key, text, sigma) in [
                    (fields::FOCAL_LENGTH, "700", ""),
                    (fields::FY, "700", ""),
                    (fields::CX, "640", ""),
                    (fields::CY, "360", ""),
                    (fields::CAMERA_HEIGHT, "1.20", "0.05"),
                    (fields::CAMERA_PITCH, "10", "0.5"),
                    (fields::FLOOR_COLUMN, "1100", ""),
                    (fields::FLOOR_ROW, "500", ""),
                ] {
                    inputs.entry_mut(key).text = text.into();
                    inputs.set_sigma(key, sigma);
                }
            }
            Self::Doorway => {
                inputs.entry_mut(fields::FOCAL_LENGTH).text = "950".into();
                inputs.entry_mut(fields::IMAGE_WIDTH).text = "200".into();
                inputs.fill(fields::REAL_WIDTH, Entry::new("0.9", Some(LengthUnit::Meter)));
            }
        }
        inputs
    }
}

impl Inputs {
    /// The entry of the field `key`.
    pub fn entry(&self, key: impl Into<Key>) -> &Entry {
        self.entries.entry(key)
    }

    /// The entry of the field `key`, to be changed.
    pub fn entry_mut(&mut self, key: impl Into<Key>) -> &mut Entry {
        self.entries.entry_mut(key)
    }

    /// Replaces the text and the chosen unit of the field `key`; what was typed for σ stays.
    pub fn fill(&mut self, key: impl Into<Key>, value: Entry) {
        let key = key.into();
        self.entries.fill(key, value);
        self.edited(key);
    }

    /// To be called after the text of the field `key` was edited: what followed from its old value is taken out. The lens that a focal
    /// length came from does not belong to another one.
    pub fn edited(&mut self, key: impl Into<Key>) {
        if key.into() == fields::FOCAL_LENGTH {
            self.entries.remove(fields::FX_LENS);
        }
    }

    /// The field `key` in the words of what is chosen: of a height or a ball, of cameras one above the other.
    pub fn worded(&self, key: impl Into<Key>) -> Key {
        key.into().worded(self.object, self.pair)
    }

    /// Whether fy counts for more than a point in space: a height or a vertical pair is measured.
    pub fn needs_fy(&self) -> bool {
        self.object == Object::Height || self.pair == Pair::Vertical
    }

    /// σ of the field `key` as typed: a number, with a unit, or in % of the value.
    pub fn sigma(&self, key: impl Into<Key>) -> &str {
        &self.entry(key).sigma
    }

    /// Sets σ of the field `key` as typed. A blank one is none.
    pub fn set_sigma(&mut self, key: impl Into<Key>, text: impl Into<String>) {
        self.entry_mut(key).sigma = text.into();
    }

    /// Whether the field `key` is shown: an optional one is once there is something in it, it is needed, or it is solved for.
    pub fn shows(&self, key: impl Into<Key>) -> bool {
        let key = key.into();
        let entry = self.entry(key);
        let solved_for = self.unknown.is_some_and(|(_, field)| key == field);
        let needed = key == fields::FY && self.needs_fy();
        !key.is_optional || !entry.is_blank() || !entry.sigma.is_empty() || solved_for || needed
    }

    /// What was typed, and in the empty fields of both distances the examples that stand there in gray, each with its σ.
    #[must_use]
    pub fn with_examples(&self) -> Self {
        let mut example = Self {
            unknown: None,
            ..self.clone()
        };
        for key in Section::FORM.into_iter().flat_map(Section::keys) {
            let is_needed = !key.is_optional || (key == fields::FY && self.needs_fy());
            if is_needed && self.entry(key).is_blank() {
                let key = self.worded(key);
                *example.entry_mut(key) = Entry {
                    sigma: key.sigma_example.to_owned(),
                    ..Entry::new(key.example(), key.kind.length_unit())
                };
            }
        }
        example
    }

    /// Whether something is in a field of the point, the target or the ground plane.
    pub fn has_geometry(&self) -> bool {
        self.has(Section::is_geometry)
    }

    /// Whether something is in a field of the point or the target, which refine a distance.
    pub fn has_refinements(&self) -> bool {
        self.has(|section| matches!(section, Section::Point | Section::Target))
    }

    /// Whether something is in a field of two photographs or of two points.
    pub fn has_two(&self) -> bool {
        self.has(Section::is_of_two)
    }

    fn has(&self, is_of: fn(Section) -> bool) -> bool {
        Key::form().any(|key| key.section.is_some_and(is_of) && !self.entry(key).is_blank())
    }

    /// Whether nothing was typed into the form. A distance, which belongs to what is solved for, does not count.
    pub fn is_blank(&self) -> bool {
        Key::form().all(|key| self.entry(key).is_blank() && self.sigma(key).trim().is_empty())
    }

    /// Moves a unit typed behind the number into the choice beside it, and a σ into its field. What cannot be read is left as it is.
    pub fn tidy(&mut self, key: impl Into<Key>) {
        let key = key.into();
        self.entry_mut(key).tidy(key);
    }

    /// Takes out each σ that programs did not count where uncertainty was switched off: all but those of a range and of the ways of
    /// their own, and those that were typed behind their value.
    pub(crate) fn drop_hidden_sigmas(&mut self) {
        let always_counted = |key: &Key| key.section == Some(Section::Point) || key.section.is_some_and(Section::is_way_of_its_own);
        for key in Key::form().chain([fields::DISTANCE]).filter(|key| !always_counted(key)) {
            let entry = self.entry(key);
            if !entry.sigma.is_empty() && entry.parts().is_none() {
                self.entry_mut(key).sigma.clear();
            }
        }
    }

    /// Chooses `unit` for the field `key` and keeps the typed number: the person corrects the unit, the number is what they
    /// read.
    pub fn choose_unit(&mut self, key: impl Into<Key>, unit: LengthUnit) {
        let key = key.into();
        self.entry_mut(key).choose_unit(key, unit);
    }

    /// Counts the last typed digit of the field `key` up or down by `steps`; see [`Entry::step`].
    pub fn step(&mut self, key: impl Into<Key>, steps: i32) {
        let key = key.into();
        self.entry_mut(key).step(key, steps);
    }
}
