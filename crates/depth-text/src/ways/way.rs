//! A way to a number: which fields it asks for, what it computes from their readings, and which field takes the result. Typed
//! units count: a pixel pitch may be in µm or mm.

use super::stored::{NotStored, Stored, Values, focal_length, needed, pair, wrong};
use crate::entry::{Entries, Entry};
use crate::field::Key;
use crate::fields::{self, BASELINE, BLUE, DISPARITY, DOFFS, FOCAL_LENGTH, FRAME_WIDTH, GREEN, LENS, RED};
use crate::note::{Fix, Issue, Note};
use crate::number::{plain, significant};
use crate::reading::{self, Reading};
use depth_core::angle::Angle;
use depth_core::camera;
use depth_core::problem::Problem;
use depth_core::quantity::{Length, LengthUnit, Pixels};
use std::f64::consts::PI;

/// One way to a number.
#[derive(Clone, Copy, Debug)]
pub struct Way {
    /// Its name in what is stored. Never changes.
    pub key: &'static str,
    /// The name people choose it by.
    pub name: &'static str,
    /// The formula, and what to watch out for.
    pub remark: &'static str,
    /// The fields it asks for.
    pub asks: &'static [Key],
    /// The field that takes the result.
    pub target: Key,
    pub(super) compute: Compute,
}

/// What else goes into the form with the result of a way.
type Also = (Key, Entry);

/// The result in the base unit of the target from the values of as many fields, in the order of [`Way::asks`] and in their base units.
#[derive(Clone, Copy, Debug)]
pub(super) enum Compute {
    One(fn(f64) -> Result<f64, Issue>),
    Two(fn(f64, f64) -> Result<f64, Issue>),
    Three(fn(f64, f64, f64) -> Result<f64, Issue>),
    /// What is stored, where it takes no more to know it.
    Stored(Stored),
    /// What is stored, by the numbers in other fields.
    StoredBy(fn(Values<'_>) -> Result<Stored, NotStored>),
}

/// What came of a way.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct WayResult {
    /// The result in the base unit of the target, px or meters; `None` while something is missing or wrong.
    pub value: Option<f64>,
    /// The horizontal field of view that a focal length means, where the width of the image is asked for.
    pub view: Option<Angle>,
    /// The distance that a disparity means to the cameras of the form, or to the only ones that store so.
    pub distance: Option<Length>,
    /// The depth that is stored.
    pub depth: Option<Length>,
    /// What the form lacks for the result.
    pub missing: Vec<Key>,
    /// What could be read of the fields it asks for.
    pub readings: Vec<Reading>,
    /// What is wrong with a field, or, at the first of them, with all of them together.
    pub notes: Vec<Note>,
}

impl Way {
    /// Reads the fields it asks for, and computes where all are there. `form` is what the form knows of the cameras, and where its
    /// distances count from.
    pub fn solve(&self, entries: &Entries, form: &Problem) -> WayResult {
        let mut result = WayResult::default();
        let mut not_finite = None;
        for &key in self.asks {
            match reading::read(key, entries.entry(key)) {
                Ok(Some(reading)) if may_be_radians(&reading) => result.notes.push(degrees_or_radians(&reading)),
                Ok(reading) => result.readings.extend(reading),
                Err(note) => {
                    not_finite = self.not_finite(key, &entries.entry(key).text);
                    if not_finite.is_none() {
                        result.notes.push(note);
                    }
                }
            }
        }
        if !self.is_of_stored() {
            self.compute(&mut result, form);
        } else if result.notes.is_empty() {
            match self.decode(&mut result, form, not_finite) {
                Ok(()) => {}
                Err(NotStored::Wrong(note)) => result.notes.push(note),
                Err(NotStored::Missing(key)) => result.missing.extend((!self.asks.contains(&key)).then_some(key)),
            }
        }
        if self.target == DISPARITY && !self.is_of_stored() {
            let disparity = result.value.map(|px| px + form.offset().value.px());
            result.distance = disparity.and_then(|px| form.depth_at(Pixels::new(px)));
        }
        result
    }

    /// The result from the readings of all fields.
    fn compute(&self, result: &mut WayResult, form: &Problem) {
        let zero = form.zero.map_or(0.0, Length::m);
        let from_lens = |reading: &Reading| {
            let is_taped = reading.key == fields::REFERENCE_DISTANCE;
            if is_taped { reading.value + zero } else { reading.value }
        };
        let values: Vec<f64> = result.readings.iter().map(from_lens).collect();
        let computed = match (self.compute, values.as_slice()) {
            (Compute::One(of), &[a]) => of(a),
            (Compute::Two(of), &[a, b]) => of(a, b),
            (Compute::Three(of), &[a, b, c]) => of(a, b, c),
            _ => return,
        };
        match computed {
            Ok(value) => {
                result.value = Some(value).filter(|value| value.is_finite());
                result.view = self.view(result);
            }
            Err(issue) => {
                let key = match issue {
                    Issue::NoBaseline if result.readings.first().is_some_and(|stations| stations.value > 0.0) => fields::BASELINE_ANGLE,
                    Issue::NoBaseline => fields::STATIONS,
                    _ => self.first(),
                };
                result.notes.push(Note::error(key, issue));
            }
        }
    }

    /// The result from what is stored; `not_finite` is what was typed for the stored number where it is none.
    fn decode(&self, result: &mut WayResult, form: &Problem, not_finite: Option<f64>) -> Result<(), NotStored> {
        let of = |key: Key| {
            let reading = result.readings.iter().find(|reading| reading.key == key);
            let of_form = || focal_length(form).filter(|_| key == FOCAL_LENGTH).map(Pixels::px);
            let typed = reading.map(|reading| reading.value).or_else(of_form);
            typed.or_else(|| not_finite.filter(|_| key == self.first()))
        };
        let number = self.number(&of)?;
        let stored = self.stored(&of)?;
        let own = self.own_camera().map(|(focal_length, baseline)| Problem {
            zero: form.zero,
            ..pair(focal_length, baseline)
        });
        let decoded = stored
            .decode(number, own.as_ref().unwrap_or(form))
            .or_else(|reason| wrong(self.first(), stored.refusal(reason)))?;
        result.value = decoded.disparity.map(Pixels::px);
        if matches!(stored, Stored::Disparity(_)) {
            result.distance = decoded.distance;
        } else {
            result.depth = decoded.distance;
            let lacks = [(FOCAL_LENGTH, focal_length(form).is_none()), (BASELINE, form.baseline.is_none())];
            result
                .missing
                .extend(lacks.into_iter().filter_map(|(key, lacks)| lacks.then_some(key)));
        }
        let warning = stored.eight_bits(number).map(|issue| Note::warning(self.first(), issue));
        result.notes.extend(warning);
        Ok(())
    }

    /// How its number is stored.
    ///
    /// # Errors
    /// What is missing for it, or wrong. Of a way that decodes nothing, its first field.
    pub fn stored(&self, of: Values<'_>) -> Result<Stored, NotStored> {
        match self.compute {
            Compute::Stored(stored) => Ok(stored),
            Compute::StoredBy(stored) => stored(of),
            _ => Err(NotStored::Missing(self.first())),
        }
    }

    /// The number that is stored: of three channels, R + 256·G + 65 536·B.
    ///
    /// # Errors
    /// The field in which it is missing, or the channel that is none.
    pub fn number(&self, of: Values<'_>) -> Result<f64, NotStored> {
        if self.first() != RED {
            return needed(of, self.first());
        }
        let channel = |key: Key| match needed(of, key)? {
            value if (0.0..=255.0).contains(&value) && value.fract() == 0.0 => Ok(value),
            _ => wrong(key, Issue::NotAChannel),
        };
        Ok(channel(RED)? + 256.0 * channel(GREEN)? + 65_536.0 * channel(BLUE)?)
    }

    /// Focal length and baseline of the only cameras that store so.
    pub fn own_camera(&self) -> Option<(Pixels, Length)> {
        match self.compute {
            Compute::Stored(stored) => stored.own_camera(),
            _ => None,
        }
    }

    const fn is_of_stored(&self) -> bool {
        matches!(self.compute, Compute::Stored(_) | Compute::StoredBy(_))
    }

    /// Infinity, or what is no number at all, where it was typed as such into the field `key` for the stored number.
    fn not_finite(&self, key: Key, text: &str) -> Option<f64> {
        let is_word = self.is_of_stored() && key == self.first() && !text.bytes().any(|byte| byte.is_ascii_digit());
        let number = text.trim().parse().ok().filter(|_| is_word);
        number.filter(|number: &f64| !number.is_finite())
    }

    fn first(&self) -> Key {
        self.asks.first().copied().unwrap_or(self.target)
    }

    /// The horizontal field of view of the result, where it is a focal length of an image of known width.
    fn view(&self, result: &WayResult) -> Option<Angle> {
        let width = result.readings.iter().find(|reading| reading.key == FRAME_WIDTH)?.value;
        let focal_length = result.value.filter(|_| self.target == FOCAL_LENGTH)?;
        let px = Pixels::new;
        Some(camera::field_of_view(px(focal_length), px(width / 2.0), px(width)))
    }

    /// What [`target`](Self::target) becomes with the result `value`.
    pub fn entry(&self, value: f64) -> Entry {
        let unit = self.target.is_length().then_some(LengthUnit::Meter);
        Entry::new(plain(value), unit)
    }

    /// The result as it is offered: "fx = 937.5 px".
    pub fn result_text(&self, value: f64) -> String {
        let unit = self.target.kind.default_unit().map_or("", |unit| unit.base().symbol());
        format!("{} = {} {unit}", self.target.symbol, significant(value, 6))
    }

    /// What goes into the form beside the result: the lens, where a focal length was computed from one, and the camera, where there is
    /// only one that stores so.
    pub fn also(&self, entries: &Entries) -> Vec<Also> {
        if self.target == FOCAL_LENGTH && self.asks.contains(&LENS) {
            return vec![(fields::FX_LENS, entries.entry(LENS).clone())];
        }
        let Some((focal_length, baseline)) = self.own_camera() else {
            return Vec::new();
        };
        let unit = LengthUnit::Millimeter;
        vec![
            (FOCAL_LENGTH, Entry::new(plain(focal_length.px()), None)),
            (BASELINE, Entry::new(plain(baseline.in_unit(unit)), Some(unit))),
            (DOFFS, Entry::default()),
            (fields::FY, Entry::default()),
        ]
    }

    /// The way among `ways` that is stored as `key`.
    pub fn named(ways: &'static [Self], key: &str) -> Option<&'static Self> {
        ways.iter().find(|way| way.key == key)
    }
}

/// Whether a field of view is so small that its number is an angle in radians: below π, a telescope's in degrees.
pub(crate) fn may_be_radians(reading: &Reading) -> bool {
    let is_view = [fields::HORIZONTAL_VIEW, fields::VERTICAL_VIEW, fields::DIAGONAL_VIEW].contains(&reading.key);
    is_view && !reading.unit_was_typed && (0.0..PI).contains(&reading.number) && reading.number > 0.0
}

/// Asks which of the two it is.
pub(crate) fn degrees_or_radians(reading: &Reading) -> Note {
    let number = reading.number_text.clone();
    let fixes = [" rad", "°"].map(|unit| {
        let value = format!("{number}{unit}");
        Fix::new(value.clone(), Entry::new(value, None))
    });
    Note::error(reading.key, Issue::DegreesOrRadians { number }).with_fixes(fixes.into())
}
