//! What is said about an option without refusing it.

use super::ascii::in_sentence;
use super::typed::{Typed, name};
use depth_text::field::Key;
use depth_text::note::{Note, Part};
use serde::Serialize;
use std::fmt::{self, Display, Formatter};

/// What is to be said about an option without refusing it.
#[derive(PartialEq, Serialize)]
pub(super) struct Warning {
    /// The option without its dashes; none where it is about the results.
    pub(super) field: Option<String>,
    pub(super) message: String,
}

impl Warning {
    pub(super) fn new(key: Key, part: Part, sentence: &impl ToString) -> Self {
        Self {
            field: Some(name(key, part)),
            message: in_sentence(&sentence.to_string()),
        }
    }

    pub(super) fn of_option(option: &str, sentence: &impl ToString) -> Self {
        Self {
            field: Some(option.to_owned()),
            ..Self::of_results(sentence)
        }
    }

    pub(super) fn of_results(sentence: &impl ToString) -> Self {
        Self {
            field: None,
            message: in_sentence(&sentence.to_string()),
        }
    }

    /// What `note` says, at the option that was typed.
    pub(super) fn typed(note: &Note, typed: &Typed) -> Self {
        match &typed.shared_sigma {
            Some((option, keys)) if note.part == Part::Sigma && keys.contains(&note.key) => Self::of_option(option, &note.issue),
            _ => Self::of(note),
        }
    }

    pub(super) fn of(note: &Note) -> Self {
        Self::new(note.key, note.part, &note.issue)
    }
}

impl Display for Warning {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match &self.field {
            Some(field) => write!(f, "--{field}: {}", self.message),
            None => f.write_str(&self.message),
        }
    }
}
