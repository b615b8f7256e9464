//! Finds out why there is no window, and says it.

use std::any::Any;
use std::env;
use std::io::IsTerminal as _;
use std::panic::{AssertUnwindSafe, PanicHookInfo};
use std::sync::{Arc, Mutex};
use winit::error::EventLoopError;

use super::sentences::{Failure, NAMES_DISPLAYS};

impl Failure {
    /// Classifies an error of eframe. `environment` gives the value of an environment variable.
    pub fn of(error: &eframe::Error, environment: impl Fn(&str) -> Option<String>) -> Self {
        let reason = |error: &dyn std::fmt::Display| without_place(&error.to_string());
        match error {
            eframe::Error::WinitEventLoop(EventLoopError::ExitFailure(_)) => Self::LostDisplay,
            eframe::Error::WinitEventLoop(error) => Self::of_display(reason(error), environment),
            // Without the configuration template that eframe adds.
            eframe::Error::NoGlutinConfigs(_, error) => Self::NoOpenGl(Some(reason(error)).filter(|reason| reason != "not found")),
            eframe::Error::Glutin(error) => Self::NoDriver(reason(error)),
            eframe::Error::OpenGL(error) => {
                let reason = reason(error);
                if reason.contains("requires opengl 2") {
                    Self::OldOpenGl
                } else {
                    Self::NoDriver(reason)
                }
            }
            other => Self::NoWindow(reason(other)),
        }
    }

    /// Where environment variables name the display, one may be unset or wrong; winit tries Wayland first.
    fn of_display(reason: String, environment: impl Fn(&str) -> Option<String>) -> Self {
        if !NAMES_DISPLAYS {
            return Self::NoWindow(reason);
        }
        let named = ["WAYLAND_DISPLAY", "WAYLAND_SOCKET", "DISPLAY"]
            .into_iter()
            .find_map(|variable| Some((variable, environment(variable).filter(|display| !display.is_empty())?)));
        match named {
            None => Self::NoDisplay,
            Some(_) if is_of_library(&reason) => Self::NoLibrary(reason),
            Some((variable, display)) => Self::SilentDisplay { variable, display, reason },
        }
    }

    /// Classifies a panic before there was a window: winit panics where some libraries are missing.
    fn before_window(reason: String) -> Self {
        if NAMES_DISPLAYS && is_of_library(&reason) {
            Self::NoLibrary(reason)
        } else {
            Self::NoWindow(reason)
        }
    }
}

/// Whether `reason`, from winit, is that a library is missing.
fn is_of_library(reason: &str) -> bool {
    reason.contains("could not be loaded") || reason.contains("shared libraries")
}

/// Runs the window, and prints a failure, a panic included, to stderr.
///
/// # Errors
/// The failure, which has been printed.
pub fn report_failures(run: impl FnOnce() -> eframe::Result, is_open: impl Fn() -> bool + Send + Sync + 'static) -> Result<(), Failure> {
    let panicked = Arc::new(Mutex::new(None));
    let noted = Arc::clone(&panicked);
    let usual = std::panic::take_hook();
    std::panic::set_hook(Box::new(move |panic| {
        let failure = of_panic(panic, is_open());
        // Before unwinding: a second panic while unwinding aborts the program.
        print(&failure);
        // For debugging.
        if env::var_os("RUST_BACKTRACE").is_some_and(|wish| wish != "0") {
            usual(panic);
        }
        if let Ok(mut noted) = noted.lock() {
            *noted = Some(failure);
        }
    }));
    // Unwind safe: nothing that the closure used is used again.
    let failure = match std::panic::catch_unwind(AssertUnwindSafe(run)) {
        Ok(Ok(())) => return Ok(()),
        Ok(Err(error)) => {
            let failure = Failure::of(&error, |variable| env::var(variable).ok());
            print(&failure);
            failure
        }
        Err(payload) => {
            let noted = panicked.lock().ok().and_then(|mut noted| noted.take());
            noted.unwrap_or_else(|| Failure::before_window(message(payload.as_ref())))
        }
    };
    Err(failure)
}

fn print(failure: &Failure) {
    eprintln!("depth-calculator: {failure}");
}

/// Shows the failure in a message box with this title where stderr is not a terminal, as after a double click. The box is the
/// system's own, which needs no OpenGL; on Linux it is that of zenity, where that is installed.
pub fn show(failure: &Failure, title: &str) {
    if !std::io::stderr().is_terminal() && !matches!(failure, Failure::NoDisplay | Failure::SilentDisplay { .. } | Failure::LostDisplay) {
        rfd::MessageDialog::new()
            .set_level(rfd::MessageLevel::Error)
            .set_title(title)
            .set_description(failure.to_string())
            .show();
    }
}

fn of_panic(panic: &PanicHookInfo<'_>, is_open: bool) -> Failure {
    let reason = message(panic.payload());
    if !is_open {
        return Failure::before_window(reason);
    }
    let place = panic
        .location()
        .map(|location| (place_in_package(location.file()), location.line()));
    Failure::Stopped { reason, place }
}

/// The message of a panic, as part of a sentence.
fn message(payload: &dyn Any) -> String {
    let text = payload
        .downcast_ref::<&str>()
        .copied()
        .or_else(|| payload.downcast_ref::<String>().map(String::as_str));
    without_place(text.unwrap_or("no reason given"))
}

/// `text` in one line, without a full stop, and without the place in the source that libraries put before it
/// (`os error at /…/mod.rs:765: …`): it is a folder of the computer that built the program.
fn without_place(text: &str) -> String {
    let line = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let rest = line.rsplit_once(".rs:").map_or(line.as_str(), |(_, rest)| {
        rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == ':').trim_start()
    });
    rest.trim_end_matches('.').to_owned()
}

/// The path of a source file from its package on: `winit-0.30.13/src/window.rs`, and not where that was built.
fn place_in_package(file: &str) -> String {
    let parts: Vec<&str> = file.split(['/', '\\']).collect();
    let source = parts
        .iter()
        .rposition(|part| *part == "src")
        .unwrap_or(parts.len().saturating_sub(1));
    parts.get(source.saturating_sub(1)..).unwrap_or_default().join("/")
}

#[cfg(test)]
#[allow(clippy::unwrap_used, clippy::panic, reason = "tests")]
mod tests {
    use super::*;

    #[test]
    #[cfg(not(any(target_os = "windows", target_os = "macos")))]
    fn the_display_that_is_named_is_the_one_that_was_tried() {
        let of = |set: &[(&str, &str)]| {
            let value = |name: &str| set.iter().find(|(known, _)| *known == name).map(|(_, value)| (*value).to_owned());
            Failure::of_display("no answer".into(), value)
        };
        assert_eq!(of(&[]), Failure::NoDisplay);
        assert_eq!(of(&[("DISPLAY", "")]), Failure::NoDisplay);
        let named = |failure| match failure {
            Failure::SilentDisplay { variable, display, .. } => (variable, display),
            other => panic!("{other:?}"),
        };
        assert_eq!(
            Failure::of_display("Failed to load one of xlib's shared libraries".into(), |_| Some(":0".into())),
            Failure::NoLibrary("Failed to load one of xlib's shared libraries".into())
        );
        assert_eq!(named(of(&[("DISPLAY", ":77")])), ("DISPLAY", ":77".to_owned()));
        assert_eq!(
            named(of(&[("DISPLAY", ":0"), ("WAYLAND_DISPLAY", "wayland-9")])),
            ("WAYLAND_DISPLAY", "wayland-9".to_owned())
        );
    }

    #[test]
    fn a_panic_is_reported_with_its_place_or_as_a_window_that_does_not_open() {
        let told = |is_open| report_failures(|| panic!("Out of luck."), move || is_open).unwrap_err();
        let stopped = told(true).to_string();
        let before = told(false);
        // Restores the hook for the other tests.
        drop(std::panic::take_hook());
        assert!(
            stopped.contains("(Out of luck, in src/platform/desktop/failure.rs at line "),
            "{stopped}"
        );
        assert_eq!(before, Failure::NoWindow("Out of luck".into()));
        assert_eq!(report_failures(|| Ok(()), || true), Ok(()));
        drop(std::panic::take_hook());
    }

    #[test]
    fn reasons_name_no_folder_of_the_builder() {
        for (said, expected) in [
            (
                "os error at /home/me/.cargo/registry/src/index/winit-0.30.13/src/linux/mod.rs:788: Failed to open connection to X server",
                "Failed to open connection to X server",
            ),
            ("C:\\me\\winit\\src\\windows.rs:12:5: no class.", "no class"),
            ("[a7] GLXBadFBConfig", "[a7] GLXBadFBConfig"),
            ("two\nlines.", "two lines"),
        ] {
            assert_eq!(without_place(said), expected);
        }
        for (file, expected) in [
            (
                "/home/me/.cargo/registry/src/index/winit-0.30.13/src/linux/mod.rs",
                "winit-0.30.13/src/linux/mod.rs",
            ),
            ("C:\\me\\winit-0.30.13\\src\\window.rs", "winit-0.30.13/src/window.rs"),
            ("/rustc/0123/library/core/src/option.rs", "core/src/option.rs"),
            ("src/app/mod.rs", "src/app/mod.rs"),
            ("build.rs", "build.rs"),
        ] {
            assert_eq!(place_in_package(file), expected);
        }
    }
}
