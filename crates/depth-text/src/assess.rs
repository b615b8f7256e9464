//! From what was typed to what it means: [`Inputs`] to [`Assessment`]. Each text is parsed once, here.

use crate::field::{Key, Section};
use crate::fields;
use crate::form::Inputs;
use crate::geometry::Geometry;
use crate::note::{Issue, Note, Part, Severity};
use crate::problem::{self, Offset};
use crate::reading::{self, Reading};
use crate::unit::Unit;
use depth_core::agreement::Suspect;
use depth_core::judge;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Problem, Solution};
use depth_core::quantity::{Length, LengthUnit};

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
    /// Its value with σ in px or meters, or what is lacking.
    pub outcome: Result<Measured<f64>, Issue>,
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
                .chain([method.optional_field()])
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

impl Inputs {
    /// Reads every field and solves.
    pub fn assess(&self) -> Assessment {
        let mut notes = Vec::new();
        let readings = self.read_fields(&mut notes);
        let reading = |key: Key| readings.iter().find(|reading| reading.key == key);
        let unit = |key: Key| reading(key).map_or_else(|| self.entry(key).chosen_unit(key), |reading| reading.unit);
        let mut problem = Problem::default();
        for reading in readings.iter().filter(|reading| !self.is_solved_for(reading.key)) {
            problem::set(&mut problem, reading);
        }
        let mut sigmas = Vec::new();
        for key in Key::form() {
            notes.extend(problem::judge(&mut problem, key, self.entry(key), reading(key), self.offset()));
            if self.counts_sigma(key) {
                // A σ in % is of a value that can be used.
                let value = match key.input {
                    Some(_) => problem::get(&problem, key),
                    None => reading(key).map(|reading| reading.value),
                };
                match reading::read_sigma(key, self.entry(key), unit(key), value) {
                    Ok(sigma) => {
                        problem::set_sigma(&mut problem, key, sigma);
                        sigmas.extend(sigma.map(|sigma| (key, sigma)));
                    }
                    Err(note) => {
                        problem::spoil_sigma(&mut problem, key);
                        notes.push(note);
                    }
                }
            }
        }
        let errors = notes
            .iter()
            .filter(|note| (note.severity, note.part) == (Severity::Error, Part::Value));
        for key in errors.map(|note| note.key) {
            problem::spoil(&mut problem, key);
        }
        let unknown = self.unknown.map(|(method, field)| {
            let outcome = problem::solve_for(method, field, &problem, || self.read_distance());
            Unknown { method, field, outcome }
        });
        if let Some(Unknown {
            field, outcome: Ok(found), ..
        }) = &unknown
        {
            problem::take(&mut problem, *field, *found);
        }
        let solution = problem.solve();
        self.note_refusals(&solution, &readings, &mut notes);
        let readings = with_sigmas(readings, &sigmas, unknown.is_some());
        let usable = |reading: &&Reading| !notes.iter().any(|note| note.key == reading.key && note.severity == Severity::Error);
        let usable: Vec<Reading> = readings.iter().filter(usable).cloned().collect();
        let (geometry, note) = Geometry::new(&usable, &solution);
        notes.extend(note);
        notes.sort_by_key(|note| (note.key, note.part));
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

    /// What can be read of the fields of the form, and notes on the rest but for what is solved for.
    fn read_fields(&self, notes: &mut Vec<Note>) -> Vec<Reading> {
        let mut readings = Vec::new();
        for key in Key::form() {
            match reading::read(key, self.entry(key)) {
                Ok(reading) => readings.extend(reading),
                Err(note) if !self.is_solved_for(key) => notes.push(note),
                Err(_) => {}
            }
        }
        readings
    }

    /// D with its σ, m, or what is wrong with it.
    fn read_distance(&self) -> Result<Measured<Length>, Issue> {
        let key = fields::DISTANCE;
        let entry = self.entry(key);
        let text = || entry.text.clone();
        let reading = match reading::read(key, entry) {
            Ok(Some(reading)) => reading,
            Ok(None) => return Err(Issue::MissingDistance),
            Err(note) if matches!(note.issue, Issue::PixelsForLength { .. }) => return Err(Issue::DistanceInPixels),
            Err(_) => return Err(Issue::NotADistance { text: text() }),
        };
        if judge::positive(reading.value).is_err() {
            return Err(Issue::NotADistance { text: text() });
        }
        let sigma = if self.with_uncertainty {
            reading::read_sigma(key, entry, reading.unit, Some(reading.value)).map_err(|note| note.issue)?
        } else {
            None
        };
        Ok(problem::distance(&Reading { sigma, ..reading }))
    }

    /// Adds what a complete but useless method has to say, and what a σ out of all proportion is.
    fn note_refusals(&self, solution: &Solution, readings: &[Reading], notes: &mut Vec<Note>) {
        for (key, refusal) in problem::refusals(solution) {
            notes.retain(|note| (note.key, note.part, note.severity) != (key, Part::Value, Severity::Warning));
            if !notes.iter().any(|note| (note.key, note.part) == (key, Part::Value)) {
                let reading = readings.iter().find(|reading| reading.key == key);
                notes.push(problem::refused(key, self.entry(key), refusal, reading, self.offset()));
            }
        }
        if let Some(field) = solution.unusable_sigma
            && !notes.iter().any(|note| (note.key, note.part) == (field.into(), Part::Sigma))
        {
            notes.push(Note::of_sigma(field.into(), Issue::SigmaOutOfProportion));
        }
    }

    /// What is still missing of each method that was touched (or, if none was, of both), field by field with a sentence.
    ///
    /// A field with something unreadable in it is not missing: it has a note of its own.
    pub fn missing(&self) -> Vec<Note> {
        let blank = |field: &Field| self.lacks(*field);
        let touched = |method: &Method| self.is_begun(*method);
        let mut missing: Vec<Note> = Vec::new();
        let any_touched = Method::ALL.iter().any(touched);
        for method in Method::ALL.into_iter().filter(touched) {
            for key in method.fields().iter().filter(|field| blank(field)).map(|&field| Key::from(field)) {
                if !missing.iter().any(|note| note.key == key) {
                    missing.push(Note::error(key, Issue::Missing { key, method }));
                }
            }
        }
        if !any_touched {
            missing.push(if blank(&Field::FocalLength) {
                Note::error(fields::FOCAL_LENGTH, Issue::MissingFocalLength)
            } else {
                Note::error(fields::BASELINE, Issue::MissingMethod)
            });
        }
        missing.sort_by_key(|note| note.key);
        missing
    }

    /// Whether something is in a field that only `method` needs.
    pub fn is_begun(&self, method: Method) -> bool {
        method.own_fields().into_iter().any(|field| !self.lacks(field))
    }

    /// Whether nothing is in `field` and it is not what is solved for.
    pub fn lacks(&self, field: Field) -> bool {
        self.entry(field).is_blank() && !self.is_solved_for(field.into())
    }

    fn is_solved_for(&self, key: Key) -> bool {
        self.unknown.is_some_and(|(_, field)| key == field)
    }

    /// Whether what was typed for σ of the field `key` counts. Those of the ground plane and of a range always do, as they are
    /// always shown.
    pub fn counts_sigma(&self, key: Key) -> bool {
        let is_shown = self.with_uncertainty || matches!(key.section, Some(Section::Point | Section::Ground));
        key.has_sigma && is_shown && !self.is_solved_for(key)
    }

    fn offset(&self) -> Offset {
        Offset {
            is_given: !self.entry(fields::DOFFS).is_blank(),
            is_unknown: self.is_solved_for(fields::DOFFS),
        }
    }
}

/// The readings with the σ that count: where something is solved for, those of the inputs of the distance do not.
fn with_sigmas(readings: Vec<Reading>, sigmas: &[(Key, f64)], is_inverse: bool) -> Vec<Reading> {
    let sigma = |key: Key| {
        let (_, sigma) = *sigmas.iter().find(|(other, _)| *other == key)?;
        (sigma > 0.0 && !(is_inverse && key.input.is_some())).then_some(sigma)
    };
    readings
        .into_iter()
        .map(|reading| Reading {
            sigma: sigma(reading.key),
            ..reading
        })
        .collect()
}

impl Assessment {
    /// The unit of length that holds in the field `key`: typed, chosen, or the field's own; `None` for other kinds.
    pub fn length_unit(&self, key: impl Into<Key>, inputs: &Inputs) -> Option<LengthUnit> {
        let key = key.into();
        let unit = self
            .reading(key)
            .map_or_else(|| inputs.entry(key).chosen_unit(key), |reading| reading.unit);
        unit.and_then(Unit::length)
    }
}
