//! The command line, as a shell sees it: answers, exit status, what is said on stderr.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, missing_docs, reason = "tests")]

mod camera;
mod contradictions;
mod counted;
mod decode;
mod fields;
mod figures;
mod floor;
mod import;
mod json;
mod options;
mod presets;
mod shell;
mod sizes;
mod text;

use serde_json::Value;
use std::process::{Command, Output, Stdio};

/// The program without a display: a window would fail.
fn program(arguments: &[&str]) -> Command {
    let mut program = Command::new(env!("CARGO_BIN_EXE_depth-calculator"));
    program
        .args(arguments)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .stdin(Stdio::null());
    program
}

fn run_words(arguments: &[&str]) -> Output {
    program(arguments).output().unwrap()
}

fn run(arguments: &str) -> Output {
    run_words(&arguments.split_whitespace().collect::<Vec<_>>())
}

/// What a call with --json is answered with.
fn answer(arguments: &str) -> Value {
    let output = run(&format!("{arguments} --json"));
    assert_eq!(
        output.status.code(),
        Some(0),
        "{arguments}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    serde_json::from_slice(&output.stdout).unwrap()
}

fn json(arguments: &str) -> Value {
    answer(&format!("calculate {arguments}"))
}

/// What is said on stderr of a call that is refused: nothing on stdout, status 2.
fn refusal(arguments: &str) -> String {
    let output = run(arguments);
    assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{arguments}");
    String::from_utf8(output.stderr).unwrap()
}

/// The lines on stdout and on stderr of a call that is answered.
fn text(arguments: &str) -> (Vec<String>, Vec<String>) {
    let output = run(arguments);
    let lines = |bytes: Vec<u8>| {
        let text = String::from_utf8(bytes).unwrap();
        text.lines().map(str::to_owned).collect::<Vec<_>>()
    };
    let (out, err) = (lines(output.stdout), lines(output.stderr));
    assert_eq!(output.status.code(), Some(0), "{arguments}: {err:?}");
    (out, err)
}

fn refused_words(arguments: &[&str]) -> String {
    let output = run_words(arguments);
    let reason = String::from_utf8(output.stderr).unwrap();
    assert_eq!(output.status.code(), Some(2), "{arguments:?}: {reason}");
    assert_eq!(reason.trim_end().lines().count(), 1, "{reason}");
    assert!(reason.starts_with("depth-calculator: "), "{reason}");
    assert!(output.stdout.is_empty());
    reason
}

fn refused(arguments: &str) -> String {
    refused_words(&arguments.split_whitespace().collect::<Vec<_>>())
}

fn near(value: &Value, expected: f64, tolerance: f64) {
    let got = value.as_f64().unwrap();
    assert!((got - expected).abs() <= tolerance, "{got} is not {expected}");
}

const MUG: &str = "--fx 700 --baseline 100mm --disparity 50";

const SIGMAS: &str = "--sigma-fx 2 --sigma-baseline 0.5mm --sigma-disparity 0.5";

const TWIN: &str = "--w-img 150 --w-real 0.3m --sigma-w-img 2 --sigma-w-real 0.01m";

/// The value options, each with a value.
const OPTIONS: [(&str, &str); 6] = [
    ("fx", "700"),
    ("baseline", "100"),
    ("disparity", "50"),
    ("doffs", "0"),
    ("w-img", "150"),
    ("w-real", "0.3"),
];
