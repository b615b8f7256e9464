//! What is said about an option without refusing it.

use super::ascii::in_sentence;
use super::options::name;
use depth_text::field::Key;
use depth_text::note::{Note, Part};
use serde::Serialize;
use std::fmt::{self, Display, Formatter};

/// What is to be said about an option without refusing it.
#[derive(Serialize)]
pub(super) struct Warning {
    /// The option without its dashes.
    pub(super) field: String,
    pub(super) message: String,
}

impl Warning {
    pub(super) fn new(key: Key, part: Part, sentence: &impl ToString) -> Self {
        Self {
            field: name(key, part),
            message: in_sentence(&sentence.to_string()),
        }
    }

    pub(super) fn of(note: &Note) -> Self {
        Self::new(note.key, note.part, &note.issue)
    }
}

impl Display for Warning {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        write!(f, "--{}: {}", self.field, self.message)
    }
}
