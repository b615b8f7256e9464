//! Running other programs, and saying what is done and how long it took.

use std::ffi::OsStr;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::Mutex;
use std::time::Instant;

/// Every step so far, with its seconds.
static TIMES: Mutex<Vec<(String, f64)>> = Mutex::new(Vec::new());

/// The folder of the workspace.
pub(crate) fn root() -> PathBuf {
    let manifest = std::env::var_os("CARGO_MANIFEST_DIR").map_or_else(|| PathBuf::from(env!("CARGO_MANIFEST_DIR")), PathBuf::from);
    manifest.parent().map_or_else(|| manifest.clone(), Path::to_path_buf)
}

/// Where cargo builds.
pub(crate) fn target() -> PathBuf {
    std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), |folder| root().join(folder))
}

/// Announces `what`, does it, and prints its seconds. Err: a sentence saying what failed.
pub(crate) fn step<T>(what: &str, work: impl FnOnce() -> Result<T, String>) -> Result<T, String> {
    println!("\n== {what}");
    let start = Instant::now();
    let outcome = work();
    let end = if outcome.is_ok() { "done" } else { "FAILED" };
    let seconds = start.elapsed().as_secs_f64();
    println!("== {what}: {end} after {seconds:.1} s");
    if let Ok(mut times) = TIMES.lock() {
        times.push((what.to_owned(), seconds));
    }
    outcome
}

/// Prints the steps that took a second or more, in their order. A step inside another one is a part of its time.
pub(crate) fn print_times() {
    println!("\n  where the time went");
    for (what, seconds) in TIMES
        .lock()
        .iter()
        .flat_map(|times| times.iter())
        .filter(|(_, seconds)| *seconds >= 1.0)
    {
        println!("{seconds:>9.1} s  {what}");
    }
}

/// A command that runs in the workspace's folder and reads nothing from the terminal.
pub(crate) fn command(program: impl AsRef<OsStr>, arguments: &[&str]) -> Command {
    let mut command = Command::new(program);
    command.args(arguments).current_dir(root()).stdin(Stdio::null());
    command
}

/// The cargo that runs this program.
pub(crate) fn cargo(arguments: &[&str]) -> Command {
    command(std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into()), arguments)
}

/// The whole path of a program on PATH, with the ending that this system gives to programs.
pub(crate) fn on_path(program: &str) -> Option<PathBuf> {
    which::which(program).ok()
}

/// Runs a command to its end, with its output on the terminal. Err: a sentence, unless it succeeded.
pub(crate) fn run(command: &mut Command) -> Result<(), String> {
    let line = line(command);
    println!("$ {line}");
    match command.status() {
        Ok(status) if status.success() => Ok(()),
        Ok(status) => Err(match status.code() {
            Some(code) => {
                format!("`{line}` failed with exit code {code}; its output above says why.")
            }
            None => format!("`{line}` was stopped by a signal."),
        }),
        Err(error) => Err(format!("`{line}` could not be started: {error}.")),
    }
}

/// What a command prints, without white space around it; `None` if it cannot be run or fails.
pub(crate) fn output(command: &mut Command) -> Option<String> {
    let output = command.stderr(Stdio::null()).output().ok()?;
    output
        .status
        .success()
        .then(|| String::from_utf8_lossy(&output.stdout).trim().to_owned())
}

/// What `program --version` prints, if it can be run.
pub(crate) fn version(program: impl AsRef<OsStr>) -> Option<String> {
    output(&mut command(program, &["--version"]))
}

fn line(command: &Command) -> String {
    let program = Path::new(command.get_program()).file_stem().unwrap_or(command.get_program());
    std::iter::once(program)
        .chain(command.get_args())
        .map(OsStr::to_string_lossy)
        .collect::<Vec<_>>()
        .join(" ")
}
