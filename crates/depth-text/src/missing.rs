//! What the distances still need.

use crate::field::Key;
use crate::fields;
use crate::form::Inputs;
use crate::note::{Issue, Note};
use crate::reading;
use crate::unit::Unit;
use depth_core::problem::{Field, Method};
use depth_core::setup::{Object, Pair};

impl Inputs {
    /// What is still missing of each method that was touched (or, if none was, of both), field by field with a sentence.
    ///
    /// A field with something unreadable in it is not missing: it has a note of its own.
    pub fn missing(&self) -> Vec<Note> {
        let touched = |method: &Method| self.is_begun(*method);
        let mut missing: Vec<Note> = Vec::new();
        let any_touched = Method::ALL.iter().any(touched);
        for method in Method::ALL.into_iter().filter(touched) {
            for key in self.missing_for(method) {
                if !missing.iter().any(|note| note.key == key) {
                    missing.push(Note::error(key, Issue::Missing { key, method }));
                }
            }
        }
        if !any_touched {
            missing.push(if self.lacks(Field::FocalLength) {
                Note::error(fields::FOCAL_LENGTH, Issue::MissingFocalLength)
            } else {
                Note::error(fields::BASELINE, Issue::MissingMethod)
            });
        }
        if self.unknown.is_some() && self.entry(fields::DISTANCE).is_blank() {
            let key = fields::DISTANCE;
            missing.push(Note::error(key, Issue::MissingForUnknown { key }));
        }
        missing.sort_by_key(|note| note.key);
        missing
    }

    /// What the distance of `method` still needs, in reading order of its formula.
    pub fn missing_for(&self, method: Method) -> Vec<Key> {
        let lacking = method.fields().into_iter().filter(|&field| self.is_missing_for(method, field));
        lacking.map(|field| self.worded(field)).collect()
    }

    /// Whether `method` needs `field` and nothing is in it, nor in what takes its place: fy, or an angle, which needs no focal length.
    fn is_missing_for(&self, method: Method, field: Field) -> bool {
        if field != Field::FocalLength {
            return self.lacks(field);
        }
        let (extent, in_rows) = match method {
            Method::Stereo => (fields::DISPARITY, self.pair == Pair::Vertical),
            Method::Monocular => (fields::IMAGE_WIDTH, self.object == Object::Height),
        };
        let reading = reading::read(extent, self.entry(extent)).ok().flatten();
        let by_angle = !self.is_solved_for(extent) && reading.is_some_and(|reading| matches!(reading.unit, Some(Unit::Angle(_))));
        self.lacks(field) && !by_angle && (!in_rows || self.lacks(Field::Fy))
    }

    /// Whether something is in a field that only `method` needs.
    pub fn is_begun(&self, method: Method) -> bool {
        method.own_fields().into_iter().any(|field| !self.lacks(field))
    }

    /// Whether nothing is in `field` and it is not what is solved for.
    pub fn lacks(&self, field: Field) -> bool {
        self.entry(field).is_blank() && !self.is_solved_for(field.into())
    }
}
