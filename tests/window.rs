//! The desktop program where its window cannot be opened. Only Linux names displays by the environment, so that they can be taken away.
#![cfg(target_os = "linux")]
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use std::process::{Command, Output};

/// Starts the program with these variables and no other display.
fn start(variables: &[(&str, &str)]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_depth-calculator"))
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .env("RUST_BACKTRACE", "0")
        // Where zenity is installed, a failure would wait in a box that nobody closes.
        .env("PATH", "/nonexistent")
        .envs(variables.iter().copied())
        .output()
        .unwrap()
}

/// That the program failed with one sentence, which says `words` and where else an answer can be had.
fn says(output: &Output, words: &[&str]) {
    let said = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(1), "{said}");
    assert_eq!(said.lines().count(), 1, "{said}");
    assert!(said.starts_with("depth-calculator: "), "{said}");
    for words in words.iter().chain(&["depth-calculator calculate"]) {
        assert!(said.contains(words), "{words}: {said}");
    }
    for noise in ["Error(", "Error {", "EventLoop", ".rs:", "/home", "/root", "registry", "panicked"] {
        assert!(!said.contains(noise), "{noise}: {said}");
    }
    assert!(output.stdout.is_empty());
}

#[test]
fn without_a_display_one_sentence_says_so_and_what_to_do() {
    says(&start(&[]), &["There is no display", "WAYLAND_DISPLAY", "DISPLAY", "on a desktop"]);
    says(&start(&[("DISPLAY", "")]), &["There is no display"]);
}

#[test]
fn a_display_that_does_not_answer_is_named() {
    for (variables, named) in [
        ([("DISPLAY", ":7777"), ("XDG_RUNTIME_DIR", "/nonexistent")], "DISPLAY names, :7777,"),
        (
            [("WAYLAND_DISPLAY", "wayland-none"), ("XDG_RUNTIME_DIR", "/nonexistent")],
            "WAYLAND_DISPLAY names, wayland-none,",
        ),
    ] {
        let output = start(&variables);
        // A bare system cannot even ask: it lacks the library for that, which is then what is named.
        let lacks_library = String::from_utf8_lossy(&output.stderr).contains("A library that the window needs is not installed");
        says(&output, &[if lacks_library { "on Debian and Ubuntu one of lib" } else { named }]);
    }
}
