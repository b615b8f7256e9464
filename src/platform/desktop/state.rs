//! The state, in a file of the user's configuration folder.

use crate::app::{Place, PlatformError};
use std::fs::{self, File};
use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};

/// The folder of everything that the program keeps.
///
/// # Errors
/// [`PlatformError::NoHomeFolder`].
pub fn folder() -> Result<PathBuf, PlatformError> {
    directories::ProjectDirs::from("", "", "depth-calculator")
        .map(|folders| folders.config_dir().to_owned())
        .ok_or(PlatformError::NoHomeFolder)
}

/// Replaces the contents of `file` by `text`. Creates its folder where that is missing.
///
/// # Errors
/// The error of the system. The file is then unchanged.
pub fn replace(file: &Path, text: &str) -> Result<(), Error> {
    if let Some(folder) = file.parent() {
        fs::create_dir_all(folder)?;
    }
    // Written beside and moved over, so that a crash leaves the old text or the new one, never half of it.
    let beside = file.with_extension("new");
    fs::write(&beside, text)?;
    fs::rename(&beside, file)
}

/// The file of the state. Its name contains the version of the format.
pub struct State {
    file: Result<PathBuf, PlatformError>,
}

impl State {
    /// The file in `folder`.
    pub fn within(folder: Result<PathBuf, PlatformError>) -> Self {
        Self {
            file: folder.map(|folder| folder.join("state-v1.json")),
        }
    }

    fn file(&self) -> Result<&Path, PlatformError> {
        self.file.as_deref().map_err(Clone::clone)
    }

    /// The stored text, if there is any.
    ///
    /// # Errors
    /// [`PlatformError::NoHomeFolder`] or [`PlatformError::FileNotRead`].
    pub fn load(&self) -> Result<Option<String>, PlatformError> {
        let file = self.file()?;
        match fs::read(file) {
            // Bytes that are not UTF-8 are treated as a corrupt state.
            Ok(bytes) => Ok(Some(String::from_utf8_lossy(&bytes).into_owned())),
            Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
            Err(error) => Err(PlatformError::FileNotRead {
                file: file.to_owned(),
                reason: error.to_string(),
            }),
        }
    }

    /// Stores `text` over what was stored.
    ///
    /// # Errors
    /// [`PlatformError::NoHomeFolder`] or [`PlatformError::FileNotWritten`].
    pub fn save(&self, text: &str) -> Result<(), PlatformError> {
        let file = self.file()?;
        replace(file, text).map_err(|error| PlatformError::FileNotWritten {
            file: file.to_owned(),
            reason: error.to_string(),
        })
    }

    /// Moves the file, byte for byte, to a name beside it that nothing has: `state-v1.old`, then `state-v1.old-2` and so on.
    /// Returns where it is then, or nothing where there is no file.
    ///
    /// # Errors
    /// [`PlatformError::NoHomeFolder`] or [`PlatformError::FileNotRenamed`]. The file is then where it was.
    pub fn set_aside(&self) -> Result<Option<Place>, PlatformError> {
        let file = self.file()?;
        if matches!(fs::symlink_metadata(file), Err(error) if error.kind() == ErrorKind::NotFound) {
            return Ok(None);
        }
        let moved = reserve_name(file).and_then(|aside| match fs::rename(file, &aside) {
            Ok(()) => Ok(aside),
            Err(error) => {
                // The empty file that reserved the name.
                fs::remove_file(&aside)?;
                Err(error)
            }
        });
        match moved {
            Ok(aside) => Ok(Some(Place::File(aside))),
            Err(error) => Err(PlatformError::FileNotRenamed {
                file: file.to_owned(),
                reason: error.to_string(),
            }),
        }
    }
}

/// Creates an empty file beside `file`, which reserves its name.
fn reserve_name(file: &Path) -> Result<PathBuf, Error> {
    let endings = std::iter::once("old".to_owned()).chain((2_u32..).map(|number| format!("old-{number}")));
    for aside in endings.map(|ending| file.with_extension(ending)) {
        match File::create_new(&aside) {
            Ok(_empty) => return Ok(aside),
            Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
            Err(error) => return Err(error),
        }
    }
    Err(ErrorKind::AlreadyExists.into())
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;

    /// An empty folder of this test alone.
    fn folder(name: &str) -> PathBuf {
        let folder = std::env::temp_dir().join(format!("depth-calculator-{}-{name}", std::process::id()));
        if folder.exists() {
            fs::remove_dir_all(&folder).unwrap();
        }
        folder
    }

    #[test]
    fn what_is_saved_is_loaded_and_nothing_else_is_left_behind() {
        let folder = folder("saved");
        let state = State::within(Ok(folder.clone()));
        assert_eq!(state.load(), Ok(None));
        state.save("first").unwrap();
        state.save("second").unwrap();
        assert_eq!(state.load(), Ok(Some("second".to_owned())));
        assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn what_is_set_aside_keeps_every_byte_and_is_never_overwritten() {
        let folder = folder("aside");
        let state = State::within(Ok(folder.clone()));
        assert_eq!(state.set_aside(), Ok(None));
        let names = ["state-v1.old", "state-v1.old-2", "state-v1.old-3"];
        let texts: [&[u8]; 3] = [b"not a state", b"\xff\xfe not even text", b""];
        fs::create_dir_all(&folder).unwrap();
        for (name, bytes) in names.iter().zip(texts) {
            fs::write(folder.join("state-v1.json"), bytes).unwrap();
            assert_eq!(state.set_aside(), Ok(Some(Place::File(folder.join(name)))));
            assert_eq!(state.load(), Ok(None), "moved, so that it is not set aside again at the next start");
            state.save("a good state").unwrap();
        }
        for (name, bytes) in names.iter().zip(texts) {
            assert_eq!(fs::read(folder.join(name)).unwrap(), bytes);
        }
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn what_cannot_be_moved_stays_and_leaves_no_empty_file() {
        let folder = folder("stays");
        let state = State::within(Ok(folder.clone()));
        // A folder in the place of the file: it cannot be read, nor take the name of a file.
        fs::create_dir_all(folder.join("state-v1.json")).unwrap();
        let state_file = folder.join("state-v1.json");
        assert!(matches!(state.load(), Err(PlatformError::FileNotRead { file, .. }) if file == state_file));
        if let Err(error) = state.set_aside() {
            assert!(
                matches!(&error, PlatformError::FileNotRenamed { file, .. } if *file == state_file),
                "{error}"
            );
            assert!(folder.join("state-v1.json").is_dir());
            assert_eq!(fs::read_dir(&folder).unwrap().count(), 1);
        }
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn without_a_home_every_answer_says_so() {
        let state = State::within(Err(PlatformError::NoHomeFolder));
        assert_eq!(state.load(), Err(PlatformError::NoHomeFolder));
        assert_eq!(state.save("text"), Err(PlatformError::NoHomeFolder));
        assert_eq!(state.set_aside(), Err(PlatformError::NoHomeFolder));
    }
}
