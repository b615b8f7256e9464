//! What a note says where there is room for one short line; the whole sentence stands elsewhere.

use crate::note::{Issue, Note};

impl Note {
    /// The note in one short line, for the place of the hint: "Did you mean 100 mm?", "Left and right may be swapped". Where there is
    /// nothing shorter, the first sentence of it. [`message`](Self::message) is all of it.
    pub fn headline(&self) -> String {
        match &self.issue {
            Issue::UnusualUnit { number, better, .. } | Issue::UnusualUnitOrSquares { number, better, .. } => {
                format!("Did you mean {number} {}?", better.symbol())
            }
            Issue::NegativeDisparity => "Left and right may be swapped".to_owned(),
            Issue::ZeroDisparity => "At zero the object is infinitely far away".to_owned(),
            Issue::NegativeBaseline => "A baseline has no sign".to_owned(),
            Issue::NoMatch { .. } | Issue::NoMatchUsed { .. } => "This is how OpenCV marks no match".to_owned(),
            Issue::Unusual { key } => format!("Unusual for {}", key.noun),
            _ => first_sentence(&self.message()),
        }
    }
}

/// The first sentence of several, with its mark only where that is a question.
fn first_sentence(text: &str) -> String {
    let ends = [". ", "? "].into_iter().filter_map(|end| text.find(end)).min();
    let first = ends.and_then(|at| text.get(..=at)).unwrap_or(text);
    first.trim_end_matches('.').to_owned()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::field::Key;
    use crate::form::Inputs;

    #[test]
    fn a_note_has_a_short_line() {
        for (name, text, expected) in [
            ("b", "100 m", "Did you mean 100 mm?"),
            ("d", "-12", "Left and right may be swapped"),
            ("d", "abc", "“abc” is not a number"),
            ("fx", "1,000", "“1,000” could mean 1000 or 1.000"),
            ("b", "4 px", "The baseline is a length, not a number of pixels"),
        ] {
            let mut inputs = Inputs::default();
            let Some(key) = Key::named(name) else { continue };
            inputs.entry_mut(key).text = text.to_owned();
            if text == "100 m" {
                // As it is chosen beside the field: one that was typed is believed.
                *inputs.entry_mut(key) = crate::entry::Entry::new("100", Some(depth_core::quantity::LengthUnit::Meter));
            }
            let headline = inputs.assess().note(key).map(Note::headline);
            assert_eq!(headline.as_deref(), Some(expected));
        }
    }
}
