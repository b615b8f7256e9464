//! What the machine refuses, and where it has put a file or what could not be read.

use std::fmt::{self, Display, Formatter};
use std::path::PathBuf;

/// Why the storage, the clipboard or the files of the machine cannot be used. A `reason` is the message of the operating system, without a full
/// stop, or that of the browser, a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "the facts of a sentence have the names of what they are")]
pub enum PlatformError {
    /// The user has no folder for what programs keep.
    NoHomeFolder,
    /// A file that was chosen or dropped cannot be read.
    FileNotOpened { file: String, reason: String },
    /// More files were chosen or dropped than any calibration has, or larger ones together.
    TooManyFiles,
    /// A file that was chosen or dropped is larger than any calibration.
    FileTooLarge { file: String },
    /// There is no dialog to choose files in.
    NoFileDialog { reason: String },
    /// The file of the state exists, but cannot be read.
    FileNotRead { file: PathBuf, reason: String },
    /// The file of the state cannot be written.
    FileNotWritten { file: PathBuf, reason: String },
    /// The file of a state that could not be parsed cannot be moved out of the way.
    FileNotRenamed { file: PathBuf, reason: String },
    /// The page runs outside a browser window.
    NoWindow,
    /// The browser has local storage, and denies it to the page.
    StorageDenied { reason: String },
    /// The browser has no local storage.
    NoStorage,
    /// Local storage cannot be read.
    StorageNotRead { reason: String },
    /// Local storage cannot be written.
    StorageNotWritten { reason: String },
    /// The text of a state that could not be parsed cannot be moved to another key of local storage.
    NotSetAside { reason: String },
    /// The browser has no clipboard for a page that is not a secure context.
    NoClipboard,
    /// The browser has a clipboard, and denies it to the page.
    CopyDenied { reason: String },
    /// The browser has a clipboard, and does not let the page read it.
    PasteDenied { reason: String },
    /// A file that the person asked for cannot be written.
    NotSaved { file: PathBuf, reason: String },
    /// The browser refuses to download a file that the person asked for.
    NoDownload { reason: String },
    /// The window gave no picture of itself, or none of the chart.
    NoPicture,
    /// A picture cannot be written as PNG.
    NoPng { reason: String },
    /// The state has no text form.
    NotSerialized { reason: String },
}

impl Display for PlatformError {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::NoHomeFolder => f.write_str("There is no home folder to store anything in."),
            Self::FileNotOpened { file, reason } => write!(f, "“{file}” cannot be read: {}.", reason.trim_end_matches('.')),
            Self::TooManyFiles => f.write_str(
                "These are more files than a calibration has: at most 16, of 16 MB together. Open those that the calibration wrote.",
            ),
            Self::FileTooLarge { file } => write!(
                f,
                "“{file}” is larger than 16 MB, which no calibration is. Open the file that the calibration wrote."
            ),
            Self::NoFileDialog { reason } => write!(
                f,
                "No files can be chosen here: {} Drop them on the window instead, or paste their text.",
                reason.trim_end_matches('.').to_owned() + "."
            ),
            Self::FileNotRead { file, reason } => write!(f, "What was stored in {} cannot be read: {reason}.", file.display()),
            Self::FileNotWritten { file, reason } => write!(f, "What you entered cannot be stored in {}: {reason}.", file.display()),
            Self::FileNotRenamed { file, reason } => write!(f, "{} cannot be renamed: {reason}.", file.display()),
            Self::NoWindow => f.write_str("There is no browser window."),
            Self::StorageDenied { reason } => write!(
                f,
                "This browser does not let the page store anything: {reason} Allow this page to store data and reload it."
            ),
            Self::NoStorage => f.write_str("This browser has no storage for pages."),
            Self::StorageNotRead { reason } => write!(f, "This browser does not let the page read what it stored: {reason}"),
            Self::StorageNotWritten { reason } => write!(
                f,
                "This browser could not store your inputs: {reason} Its storage for this site may be full: clear what you no longer need."
            ),
            Self::NotSetAside { reason } => write!(f, "This browser could not set it aside: {reason}"),
            Self::NoClipboard => f.write_str(
                "This browser copies and pastes only on pages that arrive over https or from this computer: open the page that way.",
            ),
            Self::CopyDenied { reason } => write!(
                f,
                "This browser refused to copy: {reason} Allow this page to use the clipboard and try again."
            ),
            Self::PasteDenied { reason } => write!(
                f,
                "This browser refused to paste: {reason} Press Ctrl+V, on a Mac ⌘V, or hold a finger on the field, which needs no permission."
            ),
            Self::NotSaved { file, reason } => write!(f, "{} cannot be written: {reason}.", file.display()),
            Self::NoDownload { reason } => write!(
                f,
                "This browser refused to download the file: {reason} Allow this page to download files and try again."
            ),
            Self::NoPicture => f.write_str("The window gave no picture of the chart: show the whole chart and try again."),
            Self::NoPng { reason } => write!(f, "The picture cannot be written as PNG: {reason}."),
            Self::NotSerialized { reason } => write!(f, "What you entered cannot be written as text: {reason}."),
        }
    }
}

impl std::error::Error for PlatformError {}

/// Where a file is that was asked for, or a stored text that could not be parsed. Its `Display` is the end of a sentence.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Place {
    /// In this file.
    File(PathBuf),
    /// In the browser's local storage, under this key.
    Storage(String),
    /// Among what the browser has downloaded, under this name or one like it.
    Downloads(String),
}

impl Display for Place {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::File(file) => write!(f, "in the file {}", file.display()),
            Self::Storage(key) => write!(f, "in this browser's storage, under the key “{key}”"),
            Self::Downloads(name) => write!(f, "among this browser's downloads, as “{name}”"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Place, PlatformError};
    use crate::app::sentences::snapshot::{assert_shown, every};

    #[test]
    fn every_refusal_of_the_machine_is_as_it_was_written() {
        let file = || "state-v1.json".into();
        let system = || "Permission denied (os error 13)".to_owned();
        let browser = || "Access is denied.".to_owned();
        let errors = every![PlatformError;
            PlatformError::NoHomeFolder => PlatformError::NoHomeFolder,
            PlatformError::FileNotRead { .. } => PlatformError::FileNotRead { file: file(), reason: system() },
            PlatformError::FileNotWritten { .. } => PlatformError::FileNotWritten { file: file(), reason: system() },
            PlatformError::FileNotRenamed { .. } => PlatformError::FileNotRenamed { file: file(), reason: system() },
            PlatformError::NoWindow => PlatformError::NoWindow,
            PlatformError::StorageDenied { .. } => PlatformError::StorageDenied { reason: browser() },
            PlatformError::NoStorage => PlatformError::NoStorage,
            PlatformError::StorageNotRead { .. } => PlatformError::StorageNotRead { reason: browser() },
            PlatformError::StorageNotWritten { .. } => PlatformError::StorageNotWritten { reason: browser() },
            PlatformError::NotSetAside { .. } => PlatformError::NotSetAside { reason: browser() },
            PlatformError::NoClipboard => PlatformError::NoClipboard,
            PlatformError::CopyDenied { .. } => PlatformError::CopyDenied { reason: browser() },
            PlatformError::PasteDenied { .. } => PlatformError::PasteDenied { reason: browser() },
            PlatformError::NotSaved { .. } => PlatformError::NotSaved { file: "Downloads/top-view.png".into(), reason: system() },
            PlatformError::NoDownload { .. } => PlatformError::NoDownload { reason: browser() },
            PlatformError::NoPicture => PlatformError::NoPicture,
            PlatformError::FileNotOpened { .. } => PlatformError::FileNotOpened { file: "left.yaml".into(), reason: browser() },
            PlatformError::TooManyFiles => PlatformError::TooManyFiles,
            PlatformError::FileTooLarge { .. } => PlatformError::FileTooLarge { file: "video.mp4".into() },
            PlatformError::NoFileDialog { .. } => PlatformError::NoFileDialog { reason: browser() },
            PlatformError::NoPng { .. } => PlatformError::NoPng { reason: "out of memory".into() },
            PlatformError::NotSerialized { .. } => PlatformError::NotSerialized { reason: "key must be a string".into() },
        ];
        assert_shown("platform-errors", &errors);
        let places = every![Place;
            Place::File(_) => Place::File("state-v1.old".into()),
            Place::Storage(_) => Place::Storage("depth-calculator/v1/set aside".into()),
            Place::Downloads(_) => Place::Downloads("top-view.png".into()),
        ];
        assert_shown("places", &places);
    }
}
