//! Why a cell has no number: an input that cannot be used.

use super::cell::{Cell, Value};
use super::line::Line;
use crate::assess::Assessment;
use crate::note::{Issue, Note};
use crate::number::with_minus;
use crate::sentences::Phrase;
use crate::style::Style;
use crate::unit::Unit;

/// What a cell says in place of its number because of `note`: which input must change, and why; and what the number was.
pub(super) fn refused(cell: Cell, assessment: &Assessment, note: &Note, was: Option<Value>) -> Cell {
    let key = note.key;
    let unit = assessment.reading(key).and_then(|reading| reading.unit).or(key.kind.default_unit());
    let symbol = key.symbol;
    let what = match note.issue {
        Issue::Zero { .. } | Issue::Negative { .. } | Issue::ZeroDisparity | Issue::NegativeDisparity | Issue::NegativeBaseline => {
            Phrase::MustBePositive {
                symbol,
                zero: unit.map_or_else(|| "0".to_owned(), |unit| unit.behind("0")),
            }
        }
        Issue::DisparityWithDoffs => Phrase::SumMustBePositive,
        Issue::NotANumber { .. }
        | Issue::UnknownUnit { .. }
        | Issue::UnitDoesNotFit { .. }
        | Issue::SeveralSeparators { .. }
        | Issue::UnusualSeparators { .. }
        | Issue::TwoReadings { .. } => Phrase::CannotBeRead { symbol },
        _ => Phrase::CannotBeUsed { symbol },
    };
    Cell {
        value: was.and_then(Value::into_was).unwrap_or_default(),
        lines: [Line::of(what, &[key]).refusal(), Line::of(why(assessment, note, unit), &[])],
        remarks: vec![note.message()],
        ..cell
    }
}

/// Why it cannot be used, in a few words.
fn why(assessment: &Assessment, note: &Note, unit: Option<Unit>) -> String {
    let typed = assessment.reading(note.key).map(|reading| Style::WINDOW.typed(reading));
    match (&note.issue, typed) {
        (Issue::NegativeDisparity, Some(typed)) => Phrase::BehindTheCameras { typed: with_minus(&typed) }.to_string(),
        (Issue::ZeroDisparity, _) => Phrase::InfinitelyFar {
            zero: unit.map_or_else(|| "0".to_owned(), |unit| unit.behind("0")),
        }
        .to_string(),
        (Issue::DisparityWithDoffs, _) => Phrase::SignOfDoffs.to_string(),
        (Issue::NegativeBaseline, _) => Phrase::NoSign.to_string(),
        _ => first_sentence(&note.message()),
    }
}

/// The first sentence of several.
fn first_sentence(text: &str) -> String {
    text.split_once(". ")
        .map_or_else(|| text.to_owned(), |(first, _)| format!("{first}."))
}
