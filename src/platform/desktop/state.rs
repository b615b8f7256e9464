//! The state of a window, in a file of the user's configuration folder.
//!
//! Each window is a process, and has a file of its own: `state-v1.json`, `state-v1-2.json` and so on. (A folder of an older version
//! contains only the first.) No two windows write the same file: as long as a window is open it holds a lock on the file `….lock` of its
//! number, which the system releases when the process ends, however it ends. The lock is on a file apart, as saving replaces the file of
//! the state by another.
//!
//! A new window takes, of the states that no open window has, the one that was stored last: the first window after a restart goes on
//! with what was typed last, the next with what was typed before that in another window. Where all are taken it gets the first number
//! that is free, and starts as a copy of what was stored last, without storing that until it changes.
//!
//! Where the system has no locks, such as on some network drives, every window has the first file: what is stored last stays.

use crate::app::{Place, PlatformError};
use std::cmp::Reverse;
use std::fs::{self, File, TryLockError};
use std::io::{Error, ErrorKind};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

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

/// The name of the files of the states. It contains the version of the format.
const NAME: &str = "state-v1";

/// More windows than anybody opens.
const MOST_WINDOWS: u32 = 1000;

/// The file in `folder` that belongs to the window with this number.
fn file_of(folder: &Path, name: &str, number: u32, ending: &str) -> PathBuf {
    folder.join(if number == 1 {
        format!("{name}.{ending}")
    } else {
        format!("{name}-{number}.{ending}")
    })
}

/// The states in `folder`: the number of the window and when it was stored, the last one first.
fn states(folder: &Path) -> Vec<(SystemTime, u32)> {
    let mut found: Vec<_> = (1..=MOST_WINDOWS)
        // Numbers are given out in order, and files that cannot be read are rare: some further on there are none.
        .map(|number| {
            (
                number,
                fs::metadata(file_of(folder, NAME, number, "json")).and_then(|file| file.modified()),
            )
        })
        .take_while(|(number, stored)| stored.is_ok() || file_of(folder, NAME, *number, "lock").exists() || *number == 1)
        .filter_map(|(number, stored)| Some((stored.ok()?, number)))
        .collect();
    found.sort_by_key(|(stored, number)| (Reverse(*stored), *number));
    found
}

/// Locks the number in `folder`, for as long as the file is open. `None` where another window has it.
fn lock(folder: &Path, number: u32) -> Result<Option<File>, Error> {
    fs::create_dir_all(folder)?;
    let file = File::options()
        .write(true)
        .create(true)
        .truncate(false)
        .open(file_of(folder, NAME, number, "lock"))?;
    match file.try_lock() {
        Ok(()) => Ok(Some(file)),
        Err(TryLockError::WouldBlock) => Ok(None),
        Err(TryLockError::Error(error)) => Err(error),
    }
}

/// The state of one window.
pub struct State {
    folder: Result<PathBuf, PlatformError>,
    number: u32,
    /// The file that the window starts with, where it has none of its own.
    last: Option<PathBuf>,
    /// Locked as long as the window is open.
    _lock: Option<File>,
}

impl State {
    /// A state in `folder` that no other window has.
    pub fn within(folder: Result<PathBuf, PlatformError>) -> Self {
        let of = |folder, number, lock| Self {
            folder,
            number,
            last: None,
            _lock: lock,
        };
        let Ok(path) = &folder else { return of(folder, 1, None) };
        let stored = states(path);
        let numbers = stored.iter().map(|(_, number)| *number).chain(1..=MOST_WINDOWS);
        for number in numbers {
            match lock(path, number) {
                Ok(Some(lock)) => {
                    let last = stored.first().map(|(_, last)| file_of(path, NAME, *last, "json"));
                    return Self {
                        last,
                        ..of(folder, number, Some(lock))
                    };
                }
                Ok(None) => {}
                Err(_no_locks) => break,
            }
        }
        of(folder, 1, None)
    }

    /// A file of this window alone, for something else than the state.
    pub fn file_named(&self, name: &str) -> Option<PathBuf> {
        let folder = self.folder.as_ref().ok()?;
        Some(file_of(folder, name, self.number, "json"))
    }

    fn file(&self) -> Result<PathBuf, PlatformError> {
        let folder = self.folder.as_ref().map_err(Clone::clone)?;
        Ok(file_of(folder, NAME, self.number, "json"))
    }

    /// The text of this window, else what was stored last, if there is anything.
    ///
    /// # Errors
    /// [`PlatformError::NoHomeFolder`] or [`PlatformError::FileNotRead`].
    pub fn load(&self) -> Result<Option<String>, PlatformError> {
        let own = read(&self.file()?)?;
        // Another window may be replacing it, or have moved it: then there is nothing to start with.
        Ok(own.or_else(|| read(self.last.as_deref()?).ok().flatten()))
    }

    /// Stores `text` over what was stored.
    ///
    /// # Errors
    /// [`PlatformError::NoHomeFolder`] or [`PlatformError::FileNotWritten`].
    pub fn save(&self, text: &str) -> Result<(), PlatformError> {
        let file = self.file()?;
        replace(&file, text).map_err(|error| PlatformError::FileNotWritten {
            file,
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
        if matches!(fs::symlink_metadata(&file), Err(error) if error.kind() == ErrorKind::NotFound) {
            return Ok(None);
        }
        let moved = reserve_name(&file).and_then(|aside| match fs::rename(&file, &aside) {
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
                file,
                reason: error.to_string(),
            }),
        }
    }
}

/// The text of `file`, if there is one. Bytes that are not UTF-8 make it a corrupt state.
fn read(file: &Path) -> Result<Option<String>, PlatformError> {
    match fs::read(file) {
        Ok(bytes) => Ok(Some(String::from_utf8_lossy(&bytes).into_owned())),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(PlatformError::FileNotRead {
            file: file.to_owned(),
            reason: error.to_string(),
        }),
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

    /// The names of the files in `folder`, without those of the locks.
    fn files(folder: &Path) -> Vec<String> {
        let mut names: Vec<_> = fs::read_dir(folder)
            .unwrap()
            .map(|entry| entry.unwrap().file_name().into_string().unwrap())
            .filter(|name| !name.ends_with(".lock"))
            .collect();
        names.sort();
        names
    }

    fn window(folder: &Path) -> State {
        State::within(Ok(folder.to_owned()))
    }

    /// As if the window with this number had stored its state that many seconds ago.
    fn age(folder: &Path, number: u32, seconds: u64) {
        let file = File::options().write(true).open(file_of(folder, NAME, number, "json")).unwrap();
        file.set_modified(SystemTime::now() - std::time::Duration::from_secs(seconds))
            .unwrap();
    }

    fn loaded(window: &State) -> Option<String> {
        window.load().unwrap()
    }

    #[test]
    fn two_windows_at_once_keep_what_is_typed_in_each() {
        let folder = folder("windows");
        let first = window(&folder);
        first.save("first").unwrap();
        let second = window(&folder);
        assert_eq!(
            loaded(&second).as_deref(),
            Some("first"),
            "a new window starts with what was stored last"
        );
        assert_eq!(files(&folder), ["state-v1.json"], "and stores nothing before it changes");
        second.save("second").unwrap();
        first.save("first, changed").unwrap();
        assert_eq!(loaded(&first).as_deref(), Some("first, changed"));
        assert_eq!(loaded(&second).as_deref(), Some("second"));
        assert_eq!(files(&folder), ["state-v1-2.json", "state-v1.json"]);
        assert_ne!(first.file_named("window-v1"), second.file_named("window-v1"));
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn after_a_restart_the_first_window_has_what_was_typed_last_and_the_next_the_other() {
        let folder = folder("restart");
        let (first, second) = (window(&folder), window(&folder));
        first.save("first").unwrap();
        second.save("second").unwrap();
        age(&folder, 1, 20);
        age(&folder, 2, 10);
        drop((first, second));
        let (first, second) = (window(&folder), window(&folder));
        assert_eq!(loaded(&first).as_deref(), Some("second"));
        assert_eq!(loaded(&second).as_deref(), Some("first"));
        second.save("first, changed").unwrap();
        let third = window(&folder);
        assert_eq!(loaded(&third).as_deref(), Some("first, changed"), "both are taken");
        third.save("third").unwrap();
        assert_eq!(files(&folder), ["state-v1-2.json", "state-v1-3.json", "state-v1.json"]);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn a_number_becomes_free_when_its_window_is_closed() {
        let folder = folder("closed");
        let (first, second) = (window(&folder), window(&folder));
        second.save("second").unwrap();
        drop(second);
        assert_eq!(loaded(&window(&folder)).as_deref(), Some("second"));
        drop(first);
        assert_eq!(window(&folder).number, 2, "a state goes before a number that has none");
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn what_an_older_version_stored_is_what_the_first_window_starts_with() {
        let folder = folder("older");
        fs::create_dir_all(&folder).unwrap();
        fs::write(folder.join("state-v1.json"), "older").unwrap();
        let first = window(&folder);
        assert_eq!(loaded(&first).as_deref(), Some("older"));
        first.save("newer").unwrap();
        assert_eq!(files(&folder), ["state-v1.json"]);
        fs::remove_dir_all(folder).unwrap();
    }

    #[test]
    fn what_another_window_cannot_read_is_not_moved_away_from_it() {
        let folder = folder("others");
        let first = window(&folder);
        first.save("of a newer version").unwrap();
        let second = window(&folder);
        assert_eq!(second.set_aside(), Ok(None));
        second.save("second").unwrap();
        assert_eq!(loaded(&first).as_deref(), Some("of a newer version"));
        fs::remove_dir_all(folder).unwrap();
    }

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
        assert_eq!(files(&folder), ["state-v1.json"]);
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
            assert_eq!(files(&folder), ["state-v1.json"]);
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
