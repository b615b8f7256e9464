//! What the application says about what just happened: the sentences of the notice bar.

use std::fmt::{self, Display, Formatter};

/// A sentence of the notice bar, with its facts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Sentence {
    /// The results are on the clipboard.
    Copied,
    /// Another tab or window has stored something.
    StoredElsewhere,
    /// The fields were cleared.
    Cleared,
    /// There was nothing to clear.
    NothingToClear,
    /// An example was opened.
    FilledByExample,
    /// A link was followed.
    FilledByLink,
    /// A Q matrix was taken over.
    FilledByQMatrix,
    /// An edit was undone.
    Undone,
    /// There is no edit to undo.
    NothingToUndo,
    /// An edit was done again.
    Redone,
    /// There is no edit to do again.
    NothingToRedo,
    /// What is stored cannot be read.
    Unreadable,
    /// What could not be read is still in the way, or storage cannot be used at all: for this reason.
    Forgetful { reason: String },
    /// There was no room to set aside what could not be read, and now there is.
    RoomAgain,
    /// What could not be read was set aside, for this reason and to this place.
    SetAside { reason: String, place: String },
    /// What is typed could not be stored, for this reason.
    NotStored { reason: String },
}

impl Display for Sentence {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Copied => f.write_str("Results copied to the clipboard."),
            Self::StoredElsewhere => f.write_str(
                "Another tab changed what is stored. Both go on; what is changed last is what a reload brings back. To keep these numbers, change something here, or copy them.",
            ),
            Self::Cleared => f.write_str("All fields are cleared."),
            Self::NothingToClear => f.write_str("There was nothing to clear."),
            Self::FilledByExample => f.write_str("The example is filled in."),
            Self::FilledByLink => f.write_str("The link filled in the fields that it names."),
            Self::FilledByQMatrix => f.write_str("The Q matrix filled in focal length, baseline and doffs."),
            Self::Undone => f.write_str("Undone."),
            Self::NothingToUndo => f.write_str("There is nothing to undo."),
            Self::Redone => f.write_str("Done again."),
            Self::NothingToRedo => f.write_str("There is nothing to do again."),
            Self::Unreadable => {
                f.write_str("What was stored last time could not be read, or is of another version, so the program starts fresh.")
            }
            Self::Forgetful { reason } => write!(
                f,
                "{reason} The program works, but forgets what you enter when it is closed: copy your results to keep them."
            ),
            Self::RoomAgain => f.write_str("There is room again for what you enter."),
            Self::SetAside { reason, place } => write!(f, "{reason} The old text is kept {place}."),
            Self::NotStored { reason } => write!(
                f,
                "{reason} What you enter now may be gone after a restart: copy your results to keep them."
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::Sentence;

    #[test]
    fn every_notice_is_as_it_was_written() {
        let reason = || "Storage is full.".to_owned();
        let place = "in the file old.json".to_owned();
        let all = [
            Sentence::Copied,
            Sentence::StoredElsewhere,
            Sentence::Cleared,
            Sentence::NothingToClear,
            Sentence::FilledByExample,
            Sentence::FilledByLink,
            Sentence::FilledByQMatrix,
            Sentence::Undone,
            Sentence::NothingToUndo,
            Sentence::Redone,
            Sentence::NothingToRedo,
            Sentence::Unreadable,
            Sentence::Forgetful { reason: reason() },
            Sentence::RoomAgain,
            Sentence::SetAside { reason: reason(), place },
            Sentence::NotStored { reason: reason() },
        ];
        let lines: Vec<String> = all.iter().map(|sentence| format!("{sentence:?}\n    {sentence}")).collect();
        let mut settings = insta::Settings::clone_current();
        settings.set_snapshot_path("../../tests/sentences/snapshots");
        settings.set_prepend_module_to_snapshot(false);
        settings.set_omit_expression(true);
        settings.bind(|| insta::assert_snapshot!("notices", lines.join("\n")));
    }
}
