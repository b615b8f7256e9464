//! What was typed into one field ([`Entry`]) and into several ([`Entries`]).

use crate::field::{Key, Kind};
use crate::number::{self, Primes};
use crate::unit::Unit;
use depth_core::quantity::LengthUnit;
use serde::{Deserialize, Deserializer, Serialize, Serializer};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// One field as typed.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default)]
pub struct Entry {
    /// The text in the field.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub text: String,
    /// The unit chosen beside it; `None` where none was chosen or there is no choice.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub unit: Option<LengthUnit>,
    /// Whether [`unit`](Self::unit) was typed behind the number, which nobody does by mistake.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub unit_was_typed: bool,
    /// σ as typed: a number, with a unit, or in % of the value.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub sigma: String,
}

static BLANK: Entry = Entry {
    text: String::new(),
    unit: None,
    unit_was_typed: false,
    sigma: String::new(),
};

impl Entry {
    /// `text` with `unit`, without σ.
    pub fn new(text: impl Into<String>, unit: Option<LengthUnit>) -> Self {
        Self {
            text: text.into(),
            unit,
            unit_was_typed: false,
            sigma: String::new(),
        }
    }

    /// Whether there is no text in the field; there may be a σ.
    pub fn is_blank(&self) -> bool {
        self.text.trim().is_empty()
    }

    /// Value and σ, where both were typed into the field: "50 ± 0.5 px", "1.2 m ± 2 cm", "(1.400 ± 0.016) m".
    pub(crate) fn parts(&self) -> Option<(String, String)> {
        // What is no number need not be searched for two.
        if self.text.len() > 2 * number::LONGEST {
            return None;
        }
        let mut signs = ["±", "+/-", "+-"].into_iter();
        let (value, sigma) = signs.find_map(|sign| self.text.split_once(sign))?;
        let value = number::without_name(value);
        let (value, sigma) = (value.trim(), sigma.trim());
        let in_brackets = value.strip_prefix('(').zip(sigma.rsplit_once(')'));
        if let Some((value, (sigma, unit))) = in_brackets {
            let with_unit = |number: &str| {
                let number = number.trim();
                let unit = if number.ends_with('%') { "" } else { unit.trim() };
                format!("{number} {unit}").trim_end().to_owned()
            };
            return Some((with_unit(value), with_unit(sigma)));
        }
        // A unit behind both is that of both.
        let primes = Primes::FeetAndInches;
        let unit = match (number::read(value, primes), number::read(sigma, primes)) {
            (Ok(value), Ok(sigma)) if value.unit.is_none() => sigma.unit_text,
            _ => String::new(),
        };
        let value = format!("{value} {unit}").trim_end().to_owned();
        Some((value, sigma.to_owned()))
    }

    /// The value as typed, without a σ behind it.
    pub fn value_text(&self) -> Cow<'_, str> {
        self.parts().map_or(Cow::Borrowed(&self.text), |(value, _)| Cow::Owned(value))
    }

    /// The σ as typed, without the sign in front of it: behind the value, as that was typed last, or in its own field.
    pub fn sigma_text(&self) -> Cow<'_, str> {
        match self.parts() {
            Some((_, sigma)) if !sigma.is_empty() => Cow::Owned(sigma),
            _ => Cow::Borrowed(self.sigma.trim().trim_start_matches('±').trim()),
        }
    }

    /// Leaves out a σ behind the value: that in its own field holds.
    pub fn drop_sigma_behind(&mut self) {
        if let Some((value, _)) = self.parts() {
            self.text = value;
        }
    }

    /// The unit of a bare number in the field `key`.
    pub fn chosen_unit(&self, key: Key) -> Option<Unit> {
        let chosen = self.unit.filter(|_| key.is_length()).map(Unit::Length);
        chosen.or(key.kind.default_unit())
    }

    /// Moves a unit typed behind the number into the choice beside it, and a σ into its field, without a unit that is that of the value.
    /// What cannot be read is left as it is.
    pub fn tidy(&mut self, key: Key) {
        self.tidy_value(key);
        self.tidy_sigma(key);
    }

    /// Leaves out the unit behind a σ where a bare one has the same.
    fn tidy_sigma(&mut self, key: Key) {
        let primes = key.kind.primes();
        let is_bare = self.is_blank() || number::read(&self.text, primes).is_ok_and(|value| value.unit.is_none());
        let Some(unit) = self.chosen_unit(key).filter(|_| is_bare) else {
            return;
        };
        let text = self.sigma.trim().trim_start_matches('±').trim();
        match number::read(text, primes) {
            Ok(sigma) if sigma.unit == Some(unit) && !sigma.unit_text.is_empty() => self.sigma = sigma.number_text,
            _ => {}
        }
    }

    fn tidy_value(&mut self, key: Key) {
        if let Some((value, sigma)) = self.parts().filter(|_| key.has_sigma) {
            self.text = value;
            if !sigma.is_empty() {
                self.sigma = sigma;
            }
        }
        if key.kind == Kind::Text {
            return;
        }
        let Ok(typed) = number::read(&self.text, key.kind.primes()) else {
            return;
        };
        let Some(unit) = typed.unit.filter(|&unit| key.kind.reads(unit)) else {
            // What a log printed around it.
            if !typed.is_computed && typed.unit.is_none() {
                self.text = typed.number_text;
            }
            return;
        };
        let chosen = unit.length().filter(|_| key.is_length());
        // Of several units each stands with its number. And nothing is lost where the field has this unit and no choice.
        if !typed.unit_text.is_empty() && (chosen.is_some() || key.kind.default_unit() == Some(unit)) {
            self.unit = chosen;
            self.unit_was_typed = true;
            self.text = typed.number_text;
        }
    }

    /// Chooses `unit` for the field `key` and keeps the typed number, without squares of a board behind it. Several units are
    /// converted: they were no slip.
    pub fn choose_unit(&mut self, key: Key, unit: LengthUnit) {
        if let Ok(typed) = number::read(&self.text, key.kind.primes())
            && typed.unit_text.is_empty()
            && let Some(before) = typed.unit.filter(|before| before.is_length())
        {
            self.text = number::plain(Unit::Length(unit).from_base(before.to_base(typed.number)));
        }
        if let Some((number, _)) = self.text.split_once("square") {
            self.text = number.trim().to_owned();
        }
        self.tidy(key);
        self.unit = Some(unit);
        self.unit_was_typed = false;
    }

    /// Makes the typed number one of squares of a board, whose size is then asked for.
    pub fn choose_squares(&mut self, key: Key) {
        self.tidy(key);
        self.text = format!("{} squares of ", self.text.trim());
    }

    /// Everything that was typed or chosen; `None` where that is nothing.
    fn content(&self, key: Key) -> Option<(&str, Option<LengthUnit>, &str)> {
        let unit = self.unit.filter(|&unit| key.kind.length_unit() != Some(unit));
        let content = (self.text.as_str(), unit, self.sigma.as_str());
        (content != ("", None, "")).then_some(content)
    }
}

/// What was typed, by field. A field into which nothing was typed is the same as one that was never touched.
#[derive(Clone, Debug, Default)]
pub struct Entries(BTreeMap<Key, Entry>);

impl Entries {
    /// The entry of the field `key`.
    pub fn entry(&self, key: impl Into<Key>) -> &Entry {
        self.0.get(&key.into()).unwrap_or(&BLANK)
    }

    /// The entry of the field `key`, to be changed.
    pub fn entry_mut(&mut self, key: impl Into<Key>) -> &mut Entry {
        self.0.entry(key.into()).or_default()
    }

    /// Replaces the text and the chosen unit by those of `value`; what was typed for σ stays.
    pub fn fill(&mut self, key: impl Into<Key>, value: Entry) {
        let entry = self.entry_mut(key);
        entry.text = value.text;
        entry.unit = value.unit;
        entry.unit_was_typed = value.unit_was_typed;
    }

    /// Takes the entry of the field `key` out, if there is one.
    pub fn remove(&mut self, key: Key) -> Option<Entry> {
        self.0.remove(&key)
    }

    /// Whether nothing was typed anywhere; units may have been chosen.
    pub fn is_blank(&self) -> bool {
        self.0.values().all(|entry| entry.is_blank() && entry.sigma.trim().is_empty())
    }

    fn content(&self) -> impl Iterator<Item = (Key, (&str, Option<LengthUnit>, &str))> {
        self.0.iter().filter_map(|(&key, entry)| Some((key, entry.content(key)?)))
    }
}

impl PartialEq for Entries {
    fn eq(&self, other: &Self) -> bool {
        self.content().eq(other.content())
    }
}

impl Eq for Entries {}

impl Serialize for Entries {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let touched = self.0.iter().filter(|(key, entry)| entry.content(**key).is_some());
        serializer.collect_map(touched)
    }
}

impl<'de> Deserialize<'de> for Entries {
    /// Fields that this version does not have are left out.
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let stored = BTreeMap::<String, Entry>::deserialize(deserializer)?;
        let known = stored.into_iter().filter_map(|(name, entry)| Some((Key::named(&name)?, entry)));
        Ok(Self(known.collect()))
    }
}
