//! What the application says about what just happened: the texts of the notice bar.

use super::platform_error::{Place, PlatformError};
use crate::app::copyable::Copyable;
use std::fmt::{self, Display, Formatter};

/// A text of the notice bar, with its facts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum NoticeText {
    /// The results are on the clipboard.
    Copied(Copyable),
    /// The results could not be copied.
    NotCopied(PlatformError),
    /// The clipboard could not be pasted.
    NotPasted(PlatformError),
    /// A file was saved.
    Saved(Place),
    /// A file could not be saved.
    NotSaved(PlatformError),
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
    /// A rig was filled in.
    FilledByRig(String),
    /// A known size was filled in.
    FilledBySize { label: &'static str, source: &'static str },
    /// Rigs of a file were added, and so many found no room.
    RigsAdded { added: usize, left_out: usize },
    /// Numbers of a rig were replaced.
    RigChanged(String),
    /// A rig was removed.
    RigRemoved(String),
    /// A file of rigs cannot be read.
    RigsNotRead { file: String },
    /// The rigs cannot be written as text.
    RigsNotSaved { reason: String },
    /// Files could not be opened.
    NotOpened(PlatformError),
    /// An edit was undone.
    Undone,
    /// There is no edit to undo.
    NothingToUndo,
    /// An edit was done again.
    Redone,
    /// There is no edit to do again.
    NothingToRedo,
    /// The program starts with empty fields, and cannot store anything: the old text cannot be moved out of the way, because of
    /// `obstacle`, which is absent where it is what the fresh start was for.
    Forgetful {
        cause: FreshStart,
        obstacle: Option<PlatformError>,
    },
    /// The program starts with empty fields, and the old text was moved to `place`.
    SetAside { cause: FreshStart, place: Place },
    /// The old text could not be moved out of the way at the start, and now it was, to this place.
    SetAsideLater(Place),
    /// What is typed could not be stored.
    NotStored(PlatformError),
}

/// Why the program starts with empty fields although something is stored.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FreshStart {
    /// The stored text is corrupt or of another version.
    NotParsed,
    /// The stored text could not be loaded.
    NotLoaded(PlatformError),
}

impl Display for NoticeText {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Copied(Copyable::Results) => {
                f.write_str("Copied to the clipboard: the answers, the table, and a link that opens them again.")
            }
            Self::Copied(Copyable::QMatrix) => f.write_str("Q matrix copied to the clipboard; its baseline is in meters."),
            Self::Copied(Copyable::Value(value)) => write!(f, "“{value}” copied to the clipboard."),
            Self::NotCopied(error) | Self::NotPasted(error) | Self::NotSaved(error) | Self::NotOpened(error) => error.fmt(f),
            Self::Saved(place) => write!(f, "Saved {place}."),
            Self::Cleared => f.write_str("All fields are cleared."),
            Self::NothingToClear => f.write_str("There was nothing to clear."),
            Self::FilledByExample => f.write_str("The example is filled in."),
            Self::FilledByLink => f.write_str("The link filled in the fields that it names."),
            Self::FilledByQMatrix => f.write_str("The Q matrix filled in focal length, baseline, doffs and the principal point (cx, cy)."),
            Self::FilledBySize { label, source } => write!(f, "{label} is filled in, from: {source}."),
            Self::FilledByRig(name) => write!(f, "“{name}” is filled in."),
            Self::RigsAdded { added: 0, left_out: 0 } => {
                f.write_str("No rig was added: those of the file are here already, or it has none.")
            }
            Self::RigsAdded { added: 0, .. } => f.write_str("No rig was added: there are six already. Remove one first."),
            Self::RigsAdded { added, left_out: 0 } => write!(f, "{added} {} added.", if *added == 1 { "rig was" } else { "rigs were" }),
            Self::RigsAdded { added, left_out } => {
                write!(f, "Rigs added: {added}. There was no room for {left_out} more: remove some first.")
            }
            Self::RigChanged(name) => write!(f, "“{name}” was changed."),
            Self::RigRemoved(name) => write!(f, "“{name}” was removed."),
            Self::RigsNotRead { file } => write!(
                f,
                "The rigs in “{file}” cannot be read: it was saved by a newer version of this program, or is damaged. Save it again, or open the calibration files."
            ),
            Self::RigsNotSaved { reason } => write!(f, "The rigs cannot be written as text: {reason}."),
            Self::Undone => f.write_str("Undone."),
            Self::NothingToUndo => f.write_str("There is nothing to undo."),
            Self::Redone => f.write_str("Done again."),
            Self::NothingToRedo => f.write_str("There is nothing to do again."),
            Self::Forgetful { cause, obstacle } => {
                write!(f, "{cause} ")?;
                if let Some(obstacle) = obstacle {
                    write!(f, "{obstacle} ")?;
                }
                f.write_str("The program works, but forgets what you enter when it is closed: copy your results to keep them.")
            }
            Self::SetAside { cause, place } => write!(f, "{cause} The old text is kept {place}."),
            Self::SetAsideLater(place) => write!(f, "There is room again for what you enter. The old text is kept {place}."),
            Self::NotStored(error) => write!(
                f,
                "{error} What you enter now may be gone after a restart: copy your results to keep them."
            ),
        }
    }
}

impl Display for FreshStart {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotParsed => {
                f.write_str("What was stored last time could not be read, or is of another version, so the program starts fresh.")
            }
            Self::NotLoaded(error) => error.fmt(f),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{FreshStart, NoticeText, Place, PlatformError};
    use crate::app::copyable::Copyable;
    use crate::app::sentences::snapshot::{assert_shown, every};

    #[test]
    fn every_notice_is_as_it_was_written() {
        let full = || PlatformError::NotSetAside {
            reason: "Storage is full.".to_owned(),
        };
        let place = || Place::File("old.json".into());
        let mut notices = every![NoticeText;
            NoticeText::Copied(_) => NoticeText::Copied(Copyable::Results),
            NoticeText::NotPasted(_) => NoticeText::NotPasted(PlatformError::NoClipboard),
            NoticeText::NotCopied(_) => NoticeText::NotCopied(PlatformError::NoClipboard),
            NoticeText::Saved(_) => NoticeText::Saved(Place::Downloads("top-view.png".to_owned())),
            NoticeText::NotSaved(_) => NoticeText::NotSaved(PlatformError::NoPicture),
            NoticeText::Cleared => NoticeText::Cleared,
            NoticeText::NothingToClear => NoticeText::NothingToClear,
            NoticeText::FilledByExample => NoticeText::FilledByExample,
            NoticeText::FilledByLink => NoticeText::FilledByLink,
            NoticeText::FilledByQMatrix => NoticeText::FilledByQMatrix,
            NoticeText::FilledByRig(_) => NoticeText::FilledByRig("Robot, front".to_owned()),
            NoticeText::FilledBySize { .. } => NoticeText::FilledBySize { label: "Bank or ID card, long side", source: "ISO/IEC 7810, ID-1" },
            NoticeText::RigsAdded { .. } => NoticeText::RigsAdded { added: 2, left_out: 0 },
            NoticeText::RigsNotRead { .. } => NoticeText::RigsNotRead { file: "rigs.json".to_owned() },
            NoticeText::RigChanged(_) => NoticeText::RigChanged("Robot, front".to_owned()),
            NoticeText::RigRemoved(_) => NoticeText::RigRemoved("Robot, front".to_owned()),
            NoticeText::RigsNotSaved { .. } => NoticeText::RigsNotSaved { reason: "key must be a string".to_owned() },
            NoticeText::NotOpened(_) => NoticeText::NotOpened(PlatformError::FileTooLarge { file: "video.mp4".to_owned() }),
            NoticeText::Undone => NoticeText::Undone,
            NoticeText::NothingToUndo => NoticeText::NothingToUndo,
            NoticeText::Redone => NoticeText::Redone,
            NoticeText::NothingToRedo => NoticeText::NothingToRedo,
            NoticeText::Forgetful { .. } => NoticeText::Forgetful { cause: FreshStart::NotParsed, obstacle: Some(full()) },
            NoticeText::SetAside { .. } => NoticeText::SetAside { cause: FreshStart::NotParsed, place: place() },
            NoticeText::SetAsideLater(_) => NoticeText::SetAsideLater(place()),
            NoticeText::NotStored(_) => NoticeText::NotStored(PlatformError::NoStorage),
        ];
        let not_loaded = || FreshStart::NotLoaded(PlatformError::NoStorage);
        notices.extend([
            NoticeText::Saved(Place::File("Downloads/top-view.png".into())),
            NoticeText::RigsAdded { added: 1, left_out: 0 },
            NoticeText::RigsAdded { added: 2, left_out: 1 },
            NoticeText::RigsAdded { added: 0, left_out: 3 },
            NoticeText::RigsAdded { added: 0, left_out: 0 },
            NoticeText::Forgetful {
                cause: not_loaded(),
                obstacle: None,
            },
            NoticeText::SetAside {
                cause: not_loaded(),
                place: place(),
            },
        ]);
        assert_shown("notices", &notices);
    }
}
