//! A cell of the answer and what stands in it.

use super::line::Line;
use crate::field::Key;
use crate::report::Tone;
use crate::sentences::{Phrase, capital, needs};
use crate::style::{Style, WithSigma};
use crate::unit::Unit;
use depth_core::measured::Measured;
use depth_core::quantity::{Length, LengthUnit};

/// How numbers are written here.
pub(super) const STYLE: Style = Style::WINDOW;

/// A cell of the answer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Cell {
    /// What it is: "Stereo".
    pub title: String,
    /// Which method it belongs to.
    pub tone: Tone,
    /// How it is computed, with the symbols of the fields: "fx · b / d"; empty where nothing is.
    pub formula: String,
    /// The number, or what stands in its place.
    pub value: Value,
    /// A verdict beside the title.
    pub badge: Option<Badge>,
    /// The two small lines below it, each of which may be empty.
    pub lines: [Line; 2],
    /// What else is to be said, whole sentences.
    pub remarks: Vec<String>,
}

/// The number of a cell, or what stands in its place.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Value {
    /// A number.
    Number {
        /// The number without its unit, and without the power of ten where it has one.
        number: String,
        /// Its σ to the same decimal; `None` where there is none.
        sigma: Option<String>,
        /// The power of ten of both, " × 10⁻¹¹"; empty where they are written out.
        power: String,
        /// Its unit; `None` for a plain number.
        unit: Option<Unit>,
    },
    /// The fields that are still needed, in reading order.
    Needs(Vec<Key>),
    /// Both distances are needed.
    NeedsBoth,
    /// The last value, "1.400 m", while an input cannot be used.
    Was(String),
    /// A sentence in place of a number.
    Sentence(String),
    /// There is none, and was none.
    #[default]
    Nothing,
}

/// A verdict.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Badge {
    /// A word or two.
    pub text: &'static str,
    /// What it means.
    pub quality: Quality,
}

/// How good something is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quality {
    /// Green.
    Good,
    /// Neither.
    Fair,
    /// Red.
    Bad,
}

impl Value {
    pub(super) fn length(length: Measured<Length>, unit: LengthUnit) -> Self {
        let unit = STYLE.unit_of(length.value, unit);
        Self::of(
            Measured::new(length.value.in_unit(unit), length.sigma.in_unit(unit)),
            Some(Unit::Length(unit)),
        )
    }

    pub(super) fn of(measured: Measured<f64>, unit: Option<Unit>) -> Self {
        if measured.sigma > 0.0 {
            let WithSigma { value, sigma, power } = STYLE.with_sigma(measured.value, measured.sigma);
            return Self::Number {
                number: value,
                sigma: Some(sigma),
                power,
                unit,
            };
        }
        Self::Number {
            number: STYLE.number(Some(measured.value)),
            sigma: None,
            power: String::new(),
            unit,
        }
    }

    /// A small length to two digits in the unit of its system that suits it: "28 mm".
    pub(super) fn rounded(length: Length, unit: LengthUnit) -> Self {
        use LengthUnit::{Centimeter, Inch, Meter, Micrometer, Millimeter};
        let meters = length.m().abs();
        let unit = match unit {
            Meter | Centimeter | Millimeter | LengthUnit::Kilometer if meters < 0.001 => Micrometer,
            Meter | Centimeter | Millimeter | LengthUnit::Kilometer if meters < 1.0 => Millimeter,
            LengthUnit::Foot | LengthUnit::Yard | LengthUnit::Mile if meters < 0.3 => Inch,
            unit => unit,
        };
        Self::Number {
            number: STYLE.readable(length.in_unit(unit), 2),
            sigma: None,
            power: String::new(),
            unit: Some(Unit::Length(unit)),
        }
    }

    /// A number for a place that has no room for its σ.
    #[must_use]
    pub fn without_sigma(&self) -> Self {
        match self.clone() {
            Self::Number { number, power, unit, .. } => Self::Number {
                number,
                sigma: None,
                power,
                unit,
            },
            other => other,
        }
    }

    /// "(1.400 ± 0.016) m", "1.400 m", "needs fx, b and d", "was 1.400 m"; empty where there is nothing.
    pub fn text(&self) -> String {
        match self {
            Self::Number {
                number,
                sigma,
                power,
                unit,
            } => {
                let number = match sigma {
                    Some(sigma) => format!("({number} ± {sigma}){power}"),
                    None => format!("{number}{power}"),
                };
                unit.map_or_else(|| number.clone(), |unit| unit.behind(&number))
            }
            Self::Needs(keys) => needs(keys),
            Self::NeedsBoth => Phrase::NeedsBoth.to_string(),
            Self::Was(text) => Phrase::Was { text: text.clone() }.to_string(),
            Self::Sentence(text) => text.clone(),
            Self::Nothing => String::new(),
        }
    }

    /// What it was while it was a number, without its σ.
    pub(super) fn into_was(self) -> Option<Self> {
        match self {
            Self::Number { number, power, unit, .. } => {
                let number = format!("{number}{power}");
                Some(Self::Was(unit.map_or_else(|| number.clone(), |unit| unit.behind(&number))))
            }
            _ => None,
        }
    }
}

impl Cell {
    /// All of it as one text: "Stereo: (1.400 ± 0.016) m. 1.384…1.416 m · 75 % from d. 700 px · 0.1 m / 50 px", for assistive technology.
    pub fn text(&self) -> String {
        let badge = self.badge.map_or_else(String::new, |badge| format!(" ({})", badge.text));
        let mut text = format!("{}{badge}:", self.title);
        let lines = self.lines.iter().map(Line::text);
        for piece in std::iter::once(self.value.text()).chain(lines).filter(|piece| !piece.is_empty()) {
            text.push_str(if text.ends_with(['.', '?', ':']) { " " } else { ". " });
            text.push_str(&piece);
        }
        text
    }
}

/// A statement as a whole sentence.
pub(super) fn sentence(statement: impl ToString) -> String {
    let text = capital(&statement.to_string());
    if text.ends_with(['.', '?', '!']) { text } else { text + "." }
}
