//! The one reader of what is typed into a field: text to a number in the base unit ([`Reading`]), or a [`Note`].
//!
//! A unit that was typed is converted or refused, never dropped, and a σ that cannot be read is a note, never zero.

use crate::choices::sensor_of_type;
use crate::entry::Entry;
use crate::field::{Key, Kind};
use crate::fields;
use crate::note::{Fix, Issue, Note};
use crate::number::{self, Notation, NumberError, Typed, plain, words_after_squares};
use crate::unit::Unit;
use depth_core::quantity::LengthUnit;

/// What a field means.
#[derive(Clone, Debug, PartialEq)]
pub struct Reading {
    /// The field.
    pub key: Key,
    /// The number as typed.
    pub number: f64,
    /// The number as it was typed, without its unit; where it was worked out, the result.
    pub number_text: String,
    /// Whether it was worked out: a product, a quotient, a fraction, several units.
    pub is_computed: bool,
    /// The unit that holds: the one typed behind the number, else the one chosen beside it, else that of the field;
    /// `None` where there are no units.
    pub unit: Option<Unit>,
    /// That unit as it was typed behind the number; empty where it was not.
    pub unit_text: String,
    /// The unit of a bare σ: of several units the last.
    pub sigma_unit: Option<Unit>,
    /// Whether that unit was typed, now or before the field was left.
    pub unit_was_typed: bool,
    /// The value in the base unit: pixels, meters, radians, or the number itself.
    pub value: f64,
    /// σ in the base unit, where one was typed and can be used.
    pub sigma: Option<f64>,
    /// That σ as it was typed; `None` where it was in %.
    pub sigma_typed: Option<SigmaText>,
    /// Whether a σ was typed, be it 0.
    pub sigma_was_typed: bool,
}

/// A number that was typed for a σ, and its unit, which may be another one than that of the value.
#[derive(Clone, Debug, PartialEq)]
pub struct SigmaText {
    /// The number as typed.
    pub number: String,
    /// Its unit; `None` where there are no units.
    pub unit: Option<Unit>,
}

/// A σ that was typed.
#[derive(Clone, Debug, PartialEq)]
pub struct Sigma {
    /// In the base unit.
    pub value: f64,
    /// As typed; `None` where it was in %.
    pub typed: Option<SigmaText>,
}

impl Reading {
    /// The same with the σ that was read for it. One of 0 is none.
    #[must_use]
    pub fn with_sigma(self, sigma: Option<Sigma>) -> Self {
        let sigma = sigma.filter(|sigma| sigma.value > 0.0);
        Self {
            sigma: sigma.as_ref().map(|sigma| sigma.value),
            sigma_typed: sigma.and_then(|sigma| sigma.typed),
            ..self
        }
    }

    /// The σ in the unit of the value: as it was typed where it was typed in that unit, else with at most three digits: "0.5", and for
    /// 1 % of 50 "0.5" as well. `None` without one.
    pub fn sigma_text(&self) -> Option<String> {
        let sigma = self.sigma?;
        let as_typed = self
            .sigma_typed
            .as_ref()
            .filter(|typed| typed.unit == self.unit && typed.number.len() <= LONGEST_SIGMA);
        Some(match as_typed {
            Some(typed) => typed.number.clone(),
            None => Notation::SHORT.plain(self.unit.map_or(sigma, |unit| unit.from_base(sigma)), 3),
        })
    }

    /// "10 cm": the number as typed, with its unit.
    pub fn text(&self) -> String {
        match self.unit {
            // In the unit in which their size was typed.
            Some(Unit::Square(_)) if !self.unit_text.is_empty() => format!("{} {}", self.number_text, self.unit_text),
            Some(unit) => unit.behind(&self.number_text),
            None => self.number_text.clone(),
        }
    }

    /// The unit in which [`value`](Self::value) is; `None` where there are no units.
    pub fn base_unit(&self) -> Option<Unit> {
        self.unit.map(Unit::base)
    }
}

/// A σ that nobody could read is written with fewer digits.
const LONGEST_SIGMA: usize = 12;

/// The correction that gives the number of `reading` the opposite sign and leaves its unit.
pub(crate) fn with_opposite_sign(reading: &Reading) -> Fix {
    let number = reading.number_text.trim();
    let number = match number.strip_prefix(['-', '−']) {
        Some(positive) => positive.to_owned(),
        None => format!("-{}", number.trim_start_matches('+')),
    };
    let other_unit = reading.unit.filter(|&unit| Some(unit) != reading.key.kind.default_unit());
    let value = other_unit.map_or_else(|| number.clone(), |unit| unit.behind(&number));
    let entry = match reading.unit {
        Some(Unit::Length(unit)) => Entry {
            unit_was_typed: reading.unit_was_typed,
            ..Entry::new(number, Some(unit))
        },
        _ => Entry::new(value.clone(), None),
    };
    Fix::new(value, entry)
}

/// Reads the value in `entry` of the field `key`; `None` where nothing was typed. The σ is left to [`read_sigma`].
///
/// # Errors
/// What is wrong with it, with corrections where there are some.
pub fn read(key: Key, entry: &Entry) -> Result<Option<Reading>, Note> {
    if entry.is_blank() {
        return Ok(None);
    }
    let text = entry.value_text();
    if let Some(note) = sensor_type(key, entry) {
        return Err(note);
    }
    if !key.has_sigma && text != entry.text {
        return Err(Note::error(key, Issue::NoSigma { key }));
    }
    if let Some(other) = number::name(&text).and_then(|name| key.another_named(name)) {
        return Err(Note::error(key, Issue::OtherName { key, other }));
    }
    let typed = number::read(&text, key.kind.primes()).map_err(|error| unreadable(key, entry, error))?;
    let unit = match typed.unit {
        None => entry.chosen_unit(key),
        Some(unit) if key.kind.reads(unit) => Some(unit),
        Some(unit) => return Err(Note::error(key, wrong_unit(key, entry, &typed, unit))),
    };
    if key.kind == Kind::Count && typed.number.fract() != 0.0 {
        let text = entry.text.clone();
        return Err(Note::error(key, Issue::NotWhole { key, text }));
    }
    let value = unit.map_or(typed.number, |unit| unit.to_base(typed.number));
    // A number that only the change of unit pushes out of range is too extreme, not zero.
    if !value.is_normal() && value.to_bits() != typed.number.to_bits() {
        let text = entry.text.clone();
        return Err(Note::error(key, Issue::TooExtreme { key, text }));
    }
    Ok(Some(Reading {
        key,
        number: typed.number,
        number_text: if typed.is_computed {
            plain(typed.number)
        } else {
            typed.number_text
        },
        is_computed: typed.is_computed,
        unit,
        sigma_unit: typed.last_unit.or(unit),
        unit_text: typed.unit_text,
        unit_was_typed: typed.unit.is_some() || entry.unit_was_typed,
        value,
        sigma: None,
        sigma_typed: None,
        sigma_was_typed: !entry.sigma_text().is_empty(),
    }))
}

/// Reads the value in `entry` of a field that has to be above zero; `None` where nothing was typed.
///
/// # Errors
/// What is wrong with it.
pub fn read_positive(key: Key, entry: &Entry) -> Result<Option<Reading>, Note> {
    match read(key, entry)? {
        Some(reading) if reading.value == 0.0 => Err(Note::error(key, Issue::Zero { key })),
        Some(reading) if reading.value < 0.0 => Err(Note::error(key, Issue::Negative { key })),
        reading => Ok(reading),
    }
}

/// Reads the σ in `entry` of the field `key`; `None` where there is none, or where it is in % of a value
/// that is not known.
///
/// A bare σ has the unit of the value, `unit`; one in % is of `value`, in the base unit.
///
/// # Errors
/// What is wrong with it.
pub fn read_sigma(key: Key, entry: &Entry, unit: Option<Unit>, value: Option<f64>) -> Result<Option<Sigma>, Note> {
    let text = entry.sigma_text();
    let text = number::normalized(text.trim());
    let text = text.as_ref();
    if text.is_empty() {
        return Ok(None);
    }
    let quote = || text.to_owned();
    let wrong = |issue: Issue| Err(Note::of_sigma(key, issue));
    let (number_text, percent) = text.strip_suffix('%').map_or((text, false), |number| (number, true));
    let typed = match number::read(number_text, key.kind.primes()) {
        Ok(typed) => typed,
        Err(NumberError::Ambiguous { .. }) => return wrong(Issue::SigmaTwoReadings { key, text: quote() }),
        Err(NumberError::UnknownUnit(_)) => return wrong(Issue::SigmaUnknownUnit { key, text: quote() }),
        Err(NumberError::NotANumber | NumberError::TooExtreme) => return wrong(Issue::SigmaNotANumber { key, text: quote() }),
    };
    if typed.number < 0.0 {
        return wrong(Issue::SigmaNegative { key, text: quote() });
    }
    let sigma = match (typed.unit, percent, value) {
        (Some(_), true, _) => return wrong(Issue::SigmaUnitAndPercent { key, text: quote() }),
        (None, true, None) => return Ok(None),
        (None, true, Some(0.0)) if typed.number > 0.0 => return wrong(Issue::SigmaPercentOfZero { key, text: quote() }),
        (None, true, Some(value)) => typed.number / 100.0 * value.abs(),
        (Some(sigma), false, _) if key.kind.reads(sigma) && unit.is_none_or(|unit| unit.base() == sigma.base()) => {
            sigma.to_base(typed.number)
        }
        (Some(_), false, _) => return wrong(Issue::SigmaWrongUnit { key, text: quote() }),
        (None, false, _) => unit.map_or(typed.number, |unit| unit.to_base(typed.number)),
    };
    if sigma.is_finite() {
        let number = if typed.is_computed {
            plain(typed.number)
        } else {
            typed.number_text
        };
        let unit = typed.unit.or(unit);
        Ok(Some(Sigma {
            value: sigma,
            typed: (!percent).then_some(SigmaText { number, unit }),
        }))
    } else {
        wrong(Issue::SigmaTooLarge { key, text: quote() })
    }
}

/// Reads value and σ of the field `key`; `None` where there is no value.
///
/// # Errors
/// What is wrong with either.
pub fn read_with_sigma(key: Key, entry: &Entry) -> Result<Option<Reading>, Note> {
    let reading = read(key, entry)?;
    let unit = reading
        .as_ref()
        .map_or_else(|| entry.chosen_unit(key), |reading| reading.sigma_unit);
    let sigma = read_sigma(key, entry, unit, reading.as_ref().map(|reading| reading.value))?;
    // One of 0 is there, too.
    let value = sigma.as_ref().map(|sigma| sigma.value);
    Ok(reading.map(|reading| Reading {
        sigma: value,
        ..reading.with_sigma(sigma)
    }))
}

/// That the type of a sensor was typed for its size, with what is meant.
fn sensor_type(key: Key, entry: &Entry) -> Option<Note> {
    let at = [fields::SENSOR_WIDTH, fields::SENSOR_HEIGHT, fields::SENSOR_DIAGONAL]
        .iter()
        .position(|one| *one == key)?;
    let is_in_inches = entry.unit == Some(LengthUnit::Inch);
    let text = if is_in_inches {
        format!("{} in", entry.text.trim())
    } else {
        entry.text.clone()
    };
    let (diagonal_mm, format) = sensor_of_type(&text)?;
    let sides = format.map(|format| [format.width_mm, format.height_mm]);
    let meant = sides.and_then(|sides| sides.get(at).copied()).or((at == 2).then_some(diagonal_mm));
    let fix = meant.map(|mm| {
        let number = Notation::SHORT.plain(mm, 4);
        Fix::new(format!("{number} mm"), Entry::new(number, Some(LengthUnit::Millimeter)))
    });
    Some(Note::error(key, Issue::SensorType { text, diagonal_mm }).with_fixes(fix.into_iter().collect()))
}

fn wrong_unit(key: Key, entry: &Entry, typed: &Typed, unit: Unit) -> Issue {
    match (key.kind, unit) {
        (Kind::Pixels | Kind::FocalLength | Kind::Extent, unit) if unit.is_length() => Issue::LengthForPixels {
            key,
            text: entry.text.clone(),
            unit,
        },
        (Kind::Length(_) | Kind::Pitch, Unit::Pixel) => Issue::PixelsForLength { key },
        _ => Issue::UnitDoesNotFit {
            key,
            unit: typed.unit_text.clone(),
        },
    }
}

fn unreadable(key: Key, entry: &Entry, error: NumberError) -> Note {
    let text = entry.text.clone();
    let readings = match error {
        NumberError::NotANumber => return Note::error(key, Issue::NotANumber { key, text }),
        NumberError::TooExtreme => return Note::error(key, Issue::TooExtreme { key, text }),
        NumberError::UnknownUnit(unit) if key.is_length() && words_after_squares(&unit).is_some() => {
            return Note::error(key, Issue::SizeOfSquares { text });
        }
        NumberError::UnknownUnit(unit) => return Note::error(key, Issue::UnknownUnit { key, unit }),
        NumberError::Ambiguous { readings } => readings,
    };
    // No reading is one that the field refuses.
    let unsigned = |reading: String| match reading.strip_prefix(['-', '−']) {
        Some(rest) if !key.signed => rest.to_owned(),
        _ => reading,
    };
    let readings: Vec<String> = readings.into_iter().map(unsigned).collect();
    let issue = match readings.as_slice() {
        [] => Issue::SeveralSeparators { text },
        [one] => Issue::UnusualSeparators {
            text,
            reading: one.clone(),
        },
        [many, few, ..] => Issue::TwoReadings {
            text,
            many: many.clone(),
            few: few.clone(),
        },
    };
    let fixes = readings
        .into_iter()
        .map(|reading| Fix::new(reading.clone(), Entry::new(reading, entry.unit)));
    Note::error(key, issue).with_fixes(fixes.collect())
}
