//! From what was typed to what it means: [`Inputs`] to [`Assessment`]. Each text is parsed once, here.

use crate::entry::Entry;
use crate::field::{Key, Section};
use crate::fields;
use crate::form::Inputs;
use crate::geometry::Geometry;
use crate::note::{Fix, Issue, Note, Part, Severity};
use crate::problem::{self, Offset};
use crate::reading::{self, Reading};
use crate::unit::Unit;
use depth_core::agreement::Suspect;
use depth_core::judge;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Problem, Solution, Solved};
use depth_core::quantity::Length;
use depth_core::setup::Object;

/// What the form means.
#[derive(Clone, Debug, PartialEq)]
pub struct Assessment {
    /// Everything that could be computed.
    pub solution: Solution,
    /// What to say at the fields, in reading order, at most one for each value and one for each σ.
    pub notes: Vec<Note>,
    /// What is still missing, in reading order: said only when the distance is asked for.
    pub missing: Vec<Note>,
    /// What was solved for, where it was not the distance.
    pub unknown: Option<Unknown>,
    /// What could be read, in reading order; also what was refused afterwards.
    pub readings: Vec<Reading>,
    /// The point in space and the ground plane.
    pub geometry: Geometry,
}

/// A quantity that was solved for.
#[derive(Clone, Debug, PartialEq)]
pub struct Unknown {
    /// The equation.
    pub method: Method,
    /// The quantity.
    pub field: Field,
    /// Its value with σ, or what is lacking.
    pub outcome: Result<Solved, Issue>,
    /// The distance that was given, where it can be used.
    pub distance: Option<Measured<Length>>,
    /// What else was given, each with its σ; the quantity is not in it.
    pub given: Problem,
}

impl Assessment {
    /// What was read in the field `key`.
    pub fn reading(&self, key: impl Into<Key>) -> Option<&Reading> {
        let key = key.into();
        self.readings.iter().find(|reading| reading.key == key)
    }

    /// The note at the value of the field `key`.
    pub fn note(&self, key: impl Into<Key>) -> Option<&Note> {
        self.note_at(key.into(), Part::Value)
    }

    /// The note at the σ of the field `key`.
    pub fn sigma_note(&self, key: impl Into<Key>) -> Option<&Note> {
        self.note_at(key.into(), Part::Sigma)
    }

    /// The distance by `method`; `None` also where it was given and something else solved for, so that it would only be repeated.
    pub fn distance(&self, method: Method) -> Option<Length> {
        let is_given = self.unknown.as_ref().is_some_and(|unknown| unknown.method == method);
        self.solution.outcome(method).distance().filter(|_| !is_given)
    }

    /// The field `key` in the words of [what is measured](Key::worded).
    pub fn worded(&self, key: impl Into<Key>) -> Key {
        let problem = &self.solution.problem;
        key.into().worded(problem.object, problem.pair)
    }

    /// Whether the field `key` is what is solved for.
    pub fn is_solved_for(&self, key: Key) -> bool {
        self.unknown.as_ref().is_some_and(|unknown| key == unknown.field)
    }

    /// Why there is no distance of `method` though its fields are filled in: the error at the first of them that has one.
    pub fn refusal(&self, method: Method) -> Option<&Note> {
        let is_of_method = |key: Key| {
            method
                .fields()
                .into_iter()
                .chain(method.optional_fields())
                .any(|field| key == field)
        };
        let mut errors = self
            .notes
            .iter()
            .filter(|note| note.severity == Severity::Error && note.part == Part::Value);
        errors.find(|note| is_of_method(note.key))
    }

    /// What to look at where both distances disagree, likeliest first.
    pub fn suspects(&self) -> Vec<Suspect> {
        let mut suspects = self.solution.suspects();
        let unit = |field: Field| self.reading(field).and_then(|reading| reading.unit);
        // Of all slips of the unit that would explain a disagreement, only one from the unit in use can have happened.
        suspects.retain(|suspect| match suspect {
            Suspect::Unit { source, taken, .. } => unit(*source) == Some(Unit::Length(*taken)),
            _ => true,
        });
        suspects
    }

    fn note_at(&self, key: Key, part: Part) -> Option<&Note> {
        self.notes.iter().find(|note| (note.key, note.part) == (key, part))
    }
}

/// Asks about a bare angle that looks like radians: below a right angle, with decimals that nobody measures in degrees. A tilt of a
/// degree or two makes no difference at all.
fn in_radians(reading: &Reading) -> Option<Note> {
    let Reading { key, number, .. } = *reading;
    let decimals = reading.number_text.split_once(['.', ',']).map_or("", |(_, decimals)| decimals);
    let is_small = number != 0.0 && number.abs() < std::f64::consts::FRAC_PI_2;
    let is_bare_angle = reading.unit == Some(Unit::DEGREE) && !reading.unit_was_typed;
    let is_fine = decimals.len() >= 3 && decimals.bytes().all(|digit| digit.is_ascii_digit());
    if !(is_bare_angle && is_small && is_fine) {
        return None;
    }
    let text = reading.number_text.clone();
    let fixes = [" rad", "°"].map(|unit| {
        let value = format!("{text}{unit}");
        Fix::new(value.clone(), Entry::new(value, None))
    });
    Some(Note::warning(key, Issue::AngleInRadians { key, number: text }).with_fixes(fixes.into()))
}

/// Why `issue` says that an input is missing, where one of `notes` refused it.
fn refused_instead(issue: Issue, notes: &[Note]) -> Issue {
    let Issue::MissingForUnknown { key: missing } = issue else {
        return issue;
    };
    let at = |note: &&Note| (note.key, note.severity) == (missing, Severity::Error);
    notes.iter().find(at).map_or(issue, |note| note.issue.clone())
}

impl Inputs {
    /// Reads every field and solves.
    pub fn assess(&self) -> Assessment {
        let mut notes = Vec::new();
        let mut readings = self.read_fields(&mut notes);
        let mut problem = self.read_problem(&mut readings, &mut notes);
        let unknown = self.unknown.map(|(method, field)| {
            let distance = self.read_distance(&mut readings, &mut notes);
            let outcome = problem::solve_for(method, field, &problem, distance);
            if let Err(Issue::SigmaOutOfProportion { key }) = outcome {
                notes.push(Note::of_sigma(key, Issue::SigmaOutOfProportion { key }));
            }
            let mut given = problem;
            given.set(field, None);
            Unknown {
                given,
                method,
                field,
                // What was refused is not missing.
                outcome: outcome.map_err(|issue| refused_instead(issue, &notes)),
                distance,
            }
        });
        if let Some(Unknown {
            method,
            field,
            outcome: Ok(found),
            ..
        }) = &unknown
        {
            problem::take(&mut problem, *method, *field, *found);
            notes.extend(problem::judge_solved(&problem, *field));
        }
        let mut solution = problem.solve();
        self.note_refusals(&solution, &readings, &mut notes);
        let given = unknown.as_ref().filter(|unknown| unknown.outcome.is_ok());
        let given = given.and_then(|unknown| Some((unknown.method, unknown.distance?)));
        if let Some((method, distance)) = given {
            problem::forget_echo(&mut solution, method, distance);
        }
        let is_usable = |reading: &&Reading| !notes.iter().any(|note| note.key == reading.key && note.severity == Severity::Error);
        let usable: Vec<&Reading> = readings.iter().filter(is_usable).collect();
        let (geometry, more) = Geometry::new(&usable, &solution, given);
        notes.extend(more);
        let is_used = |reading: &&Reading| match reading.key.section {
            Some(Section::Target) => solution.monocular.distance().is_some(),
            Some(Section::Ground) => geometry.ground.is_some(),
            _ => false,
        };
        notes.extend(readings.iter().filter(is_used).filter_map(in_radians));
        if self.object == Object::Ball && solution.problem.tilt.is_some() {
            notes.push(Note::warning(fields::TILT, Issue::BallHasNoTilt));
        }
        // An error takes the place of a warning.
        notes.sort_by_key(|note| (note.key, note.part, note.severity != Severity::Error));
        notes.dedup_by_key(|note| (note.key, note.part));
        Assessment {
            solution,
            notes,
            missing: self.missing(),
            unknown,
            readings,
            geometry,
        }
    }

    /// The problem that `readings` are, each with the σ that counts. What cannot be used is left out, and noted.
    fn read_problem(&self, readings: &mut [Reading], notes: &mut Vec<Note>) -> Problem {
        let mut problem = Problem {
            object: self.object,
            pair: self.pair,
            ..Problem::default()
        };
        let mixed = problem::mixed_units(readings, self.unknown.map(|(_, field)| field.into()));
        let is_mixed = |key: Key| mixed.iter().any(|note| note.key == key);
        for reading in readings
            .iter()
            .filter(|reading| !self.is_solved_for(reading.key) && !is_mixed(reading.key))
        {
            problem::set(&mut problem, reading);
        }
        notes.extend(mixed);
        for key in Key::form().map(|key| self.worded(key)) {
            let reading = readings.iter().find(|reading| reading.key == key);
            notes.extend(problem::judge(&mut problem, key, self.entry(key), reading, self.offset()));
            if !self.takes_sigma(key) {
                continue;
            }
            let unit = reading.map_or_else(|| self.entry(key).chosen_unit(key), |reading| reading.sigma_unit);
            // A σ in % is of a value that can be used; of doffs that was left out, of zero.
            let value = match key.input {
                Some(_) if key == fields::DOFFS && self.entry(key).is_blank() => Some(0.0),
                Some(_) => problem::get(&problem, key),
                None => reading.map(|reading| reading.value),
            };
            match reading::read_sigma(key, self.entry(key), unit, value) {
                Ok(sigma) => {
                    problem::set_sigma(&mut problem, key, sigma.as_ref().map(|sigma| sigma.value));
                    if let Some(reading) = readings.iter_mut().find(|reading| reading.key == key) {
                        *reading = reading.clone().with_sigma(sigma);
                    }
                }
                Err(note) => {
                    problem::spoil_sigma(&mut problem, key);
                    notes.push(note);
                }
            }
        }
        let errors = notes
            .iter()
            .filter(|note| (note.severity, note.part) == (Severity::Error, Part::Value));
        for key in errors.map(|note| note.key) {
            problem::spoil(&mut problem, key);
        }
        problem
    }

    /// What can be read of the fields of the form, and notes on the rest but for what is solved for.
    fn read_fields(&self, notes: &mut Vec<Note>) -> Vec<Reading> {
        let mut readings = Vec::new();
        for key in Key::form().map(|key| self.worded(key)) {
            match reading::read(key, self.entry(key)) {
                Ok(reading) => readings.extend(reading),
                Err(note) if !self.is_solved_for(key) => notes.push(note),
                Err(_) => {}
            }
        }
        readings
    }

    /// D with its σ, m; `None` where nothing was typed or what was is noted.
    fn read_distance(&self, readings: &mut Vec<Reading>, notes: &mut Vec<Note>) -> Option<Measured<Length>> {
        let key = fields::DISTANCE;
        let entry = self.entry(key);
        let reading = match reading::read(key, entry) {
            Ok(reading) => reading?,
            Err(note) => {
                notes.push(note);
                return None;
            }
        };
        if let Err(refusal) = judge::positive(reading.value) {
            notes.push(problem::refused(key, entry, refusal, Some(&reading), self.offset()));
            readings.push(reading);
            return None;
        }
        let sigma = if self.takes_sigma(key) {
            reading::read_sigma(key, entry, reading.sigma_unit, Some(reading.value))
        } else {
            Ok(None)
        };
        let sigma = match sigma {
            Ok(sigma) => sigma,
            Err(note) => {
                notes.push(note);
                readings.push(reading);
                return None;
            }
        };
        let distance = Measured::from_base(reading.value, sigma.as_ref().map_or(0.0, |sigma| sigma.value));
        readings.push(reading.with_sigma(sigma));
        Some(distance)
    }

    /// Adds what a complete but useless method has to say, and what a σ out of all proportion is.
    fn note_refusals(&self, solution: &Solution, readings: &[Reading], notes: &mut Vec<Note>) {
        for (key, refusal) in problem::refusals(solution) {
            let key = self.worded(key);
            notes.retain(|note| (note.key, note.part, note.severity) != (key, Part::Value, Severity::Warning));
            if !notes.iter().any(|note| (note.key, note.part) == (key, Part::Value)) {
                let reading = readings.iter().find(|reading| reading.key == key);
                notes.push(problem::refused(key, self.entry(key), refusal, reading, self.offset()));
            }
        }
        if let Some(field) = solution.unusable_sigma
            && !notes.iter().any(|note| (note.key, note.part) == (field.into(), Part::Sigma))
        {
            let key = self.worded(field);
            notes.push(Note::of_sigma(key, Issue::SigmaOutOfProportion { key }));
        }
    }

    pub(crate) fn is_solved_for(&self, key: Key) -> bool {
        self.unknown.is_some_and(|(_, field)| key == field)
    }

    /// Whether a σ of the field `key` counts: where there is one, and it is not solved for.
    pub(crate) fn takes_sigma(&self, key: Key) -> bool {
        key.has_sigma && !self.is_solved_for(key)
    }

    fn offset(&self) -> Offset {
        Offset {
            is_given: !self.entry(fields::DOFFS).is_blank(),
            is_unknown: self.is_solved_for(fields::DOFFS),
        }
    }
}
