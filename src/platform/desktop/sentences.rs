//! What is said where there is no window, in one sentence: what is missing, and what to do.

use std::fmt::{self, Display, Formatter};

/// Whether environment variables name the display, as with X11 and Wayland.
pub const NAMES_DISPLAYS: bool = !cfg!(any(target_os = "windows", target_os = "macos"));

/// What keeps the window from opening, or what has ended it.
#[derive(Debug, PartialEq, Eq)]
pub enum Failure {
    /// No environment variable names a display.
    NoDisplay,
    /// The display that the variable names does not answer.
    SilentDisplay {
        variable: &'static str,
        display: String,
        reason: String,
    },
    /// A client library of the display server is not installed.
    NoLibrary(String),
    /// The display offers no OpenGL, for this reason; without a reason, no library of OpenGL is installed.
    NoOpenGl(Option<String>),
    /// There is OpenGL, and its driver fails.
    NoDriver(String),
    /// An OpenGL older than the window can be drawn with.
    OldOpenGl,
    /// Anything else before there was a window.
    NoWindow(String),
    /// The display went away while the window was open.
    LostDisplay,
    /// An error in the program while its window was open, with its place in the source, a file and a line, where that is known.
    Stopped { reason: String, place: Option<(String, u32)> },
}

impl Display for Failure {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        const TERMINAL: &str = "or compute on the terminal (depth-calculator calculate --help)";
        let driver = if NAMES_DISPLAYS {
            "try LIBGL_ALWAYS_SOFTWARE=1 depth-calculator, install or update the graphics driver (on most Linux systems Mesa)"
        } else {
            "install or update the driver of the graphics card"
        };
        match self {
            Self::NoDisplay => write!(
                f,
                "There is no display to open a window on, as neither WAYLAND_DISPLAY nor DISPLAY is set: start the program on a desktop, {TERMINAL}."
            ),
            Self::SilentDisplay { variable, display, reason } => write!(
                f,
                "The display that {variable} names, {display}, cannot be used ({reason}): start the program on a desktop that runs, {TERMINAL}."
            ),
            Self::NoLibrary(reason) => write!(
                f,
                "A library that the window needs is not installed ({reason}): install it (on Debian and Ubuntu one of libx11-6, libxcursor1, libxi6, libxkbcommon-x11-0), {TERMINAL}."
            ),
            Self::NoOpenGl(reason) => {
                let reason = reason.as_deref().unwrap_or("neither libGL nor libEGL can be loaded");
                write!(f, "There is no OpenGL to draw the window with ({reason}): {driver}, {TERMINAL}.")
            }
            Self::NoDriver(reason) => {
                write!(f, "OpenGL is there, but its driver fails ({reason}): {driver}, {TERMINAL}.")
            }
            Self::OldOpenGl => {
                write!(f, "OpenGL is there, but older than version 2, which draws the window: {driver}, {TERMINAL}.")
            }
            Self::NoWindow(reason) => {
                write!(f, "The window could not be opened ({reason}): start the program on another desktop, {TERMINAL}.")
            }
            Self::LostDisplay => {
                f.write_str("The display has closed the connection to the program: start it again on a desktop that runs; what you entered before is kept.")
            }
            Self::Stopped { reason, place } => {
                write!(f, "The program has stopped because of an error in it ({reason}, ")?;
                match place {
                    Some((file, line)) => write!(f, "in {file} at line {line}")?,
                    None => f.write_str("at an unknown place")?,
                }
                f.write_str("): start it again; what you entered before is kept.")
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{Failure, NAMES_DISPLAYS};
    use crate::app::snapshot::{assert_shown, every};

    fn every_failure() -> Vec<Failure> {
        let stopped = |place| Failure::Stopped {
            reason: "attempt to divide by zero".into(),
            place,
        };
        let mut failures = every![Failure;
            Failure::NoDisplay => Failure::NoDisplay,
            Failure::SilentDisplay { .. } => Failure::SilentDisplay {
                variable: "DISPLAY",
                display: ":77".into(),
                reason: "Failed to open connection to X server".into(),
            },
            Failure::NoLibrary(_) => Failure::NoLibrary("Library libxkbcommon-x11.so could not be loaded".into()),
            Failure::NoOpenGl(_) => Failure::NoOpenGl(Some("provided display handle is not supported".into())),
            Failure::NoDriver(_) => Failure::NoDriver("GLXBadFBConfig".into()),
            Failure::OldOpenGl => Failure::OldOpenGl,
            Failure::NoWindow(_) => Failure::NoWindow("X server missing XInput extension".into()),
            Failure::LostDisplay => Failure::LostDisplay,
            Failure::Stopped { .. } => stopped(Some(("src/app/mod.rs".into(), 7))),
        ];
        failures.extend([Failure::NoOpenGl(None), stopped(None)]);
        failures
    }

    #[test]
    #[cfg(not(any(target_os = "windows", target_os = "macos")))]
    fn every_failure_is_as_it_was_written() {
        assert_shown("no-window", &every_failure());
    }

    #[test]
    fn every_failure_is_one_sentence_that_says_what_to_do() {
        for failure in every_failure() {
            let sentence = failure.to_string();
            assert!(!sentence.contains('\n') && sentence.ends_with('.'), "{sentence}");
            assert!(!sentence.contains("..") && !sentence.contains(". "), "{sentence}");
            assert!(sentence.contains(": "), "what to do stands after the colon: {sentence}");
            if !matches!(failure, Failure::LostDisplay | Failure::Stopped { .. }) {
                assert!(sentence.contains("depth-calculator calculate"), "{sentence}");
            }
            if NAMES_DISPLAYS && matches!(failure, Failure::NoOpenGl(_) | Failure::NoDriver(_) | Failure::OldOpenGl) {
                assert!(sentence.contains("LIBGL_ALWAYS_SOFTWARE=1"), "{sentence}");
            }
        }
    }
}
