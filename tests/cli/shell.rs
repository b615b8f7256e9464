//! What a shell and a packager need: help, completions, the manual page, and what happens when nobody can read the answer.

use super::{OPTIONS, run};

#[test]
fn help_teaches() {
    let output = run("calculate --help");
    assert_eq!(output.status.code(), Some(0));
    let text = String::from_utf8(output.stdout).unwrap();
    for taught in [
        "D = fx · b / (d + doffs)",
        "one standard deviation",
        "1.400 m away",
        "StereoSGBM",
        "JSON stays in meters",
        "[possible values: nm, µm, mm, cm, m, km, in, ft, yd, mi]",
    ] {
        assert!(text.contains(taught), "{taught}");
    }
}

/// With the window it is the window that is wanted, and without it a command; neither is a matter of parsing.
#[test]
fn no_arguments_and_a_lone_double_dash_are_the_same() {
    for arguments in ["", "--"] {
        let output = run(arguments);
        let reason = String::from_utf8(output.stderr).unwrap();
        let last = reason.lines().last().unwrap();
        if cfg!(feature = "app") {
            assert_eq!(reason.lines().count(), 1, "{reason}");
            assert!(last.starts_with("depth-calculator: There is no display"), "{last}");
            assert!(!last.contains(".rs") && !last.contains(".."), "{last}");
        } else {
            assert_eq!(output.status.code(), Some(2), "{last}");
            assert!(reason.contains("Usage:"), "{reason}");
        }
        assert!(last.contains("depth-calculator calculate"), "{last}");
        assert!(output.stdout.is_empty());
    }
}

/// What cannot be written is said, whatever it is.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_sentence_and_status_1() {
    let mug = super::MUG;
    for arguments in [
        format!("calculate {mug}"),
        format!("calculate {mug} --json"),
        "--help".to_owned(),
        "--version".to_owned(),
        "calculate --help".to_owned(),
        "completions bash".to_owned(),
        "man".to_owned(),
    ] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let words: Vec<_> = arguments.split_whitespace().collect();
        let output = super::program(&words).stdout(full).output().unwrap();
        assert_eq!(output.status.code(), Some(1), "{arguments}");
        assert_eq!(
            String::from_utf8(output.stderr).unwrap(),
            "depth-calculator: The answer could not be written: No space left on device.\n",
            "{arguments}"
        );
    }
}

/// `head -1` closes the pipe when it has seen enough.
#[cfg(unix)]
#[test]
fn a_reader_that_went_away_is_no_fault() {
    let (reader, writer) = std::io::pipe().unwrap();
    drop(reader);
    let output = super::program(&["completions", "zsh"]).stdout(writer).output().unwrap();
    assert_eq!(output.status.code(), Some(0));
    assert!(output.stderr.is_empty());
}

#[test]
fn completions_know_every_option() {
    for shell in ["bash", "zsh", "fish", "powershell", "elvish"] {
        let output = run(&format!("completions {shell}"));
        assert_eq!(output.status.code(), Some(0), "{shell}");
        let script = String::from_utf8(output.stdout).unwrap();
        for word in ["sigma-w-real", "doffs", "unit", "completions", "man"] {
            assert!(script.contains(word), "{shell}: {word}");
        }
    }
}

/// What bash offers behind a command, asked of bash itself.
#[cfg(target_os = "linux")]
#[test]
fn bash_completes() {
    use std::process::{Command, Stdio};
    let offered = |typed: &[&str]| {
        let script = format!(
            "source <({} completions bash) && COMP_WORDS=({}) COMP_CWORD={} && \
             _depth__calculator depth-calculator '{}' '{}' && printf '%s\\n' \"${{COMPREPLY[@]}}\"",
            env!("CARGO_BIN_EXE_depth-calculator"),
            typed.iter().map(|word| format!("'{word}'")).collect::<Vec<_>>().join(" "),
            typed.len() - 1,
            typed[typed.len() - 1],
            typed[typed.len() - 2],
        );
        let output = Command::new("bash")
            .args(["--norc", "-c", &script])
            .stdin(Stdio::null())
            .output()
            .unwrap();
        assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout)
            .unwrap()
            .split_whitespace()
            .map(str::to_owned)
            .collect::<Vec<_>>()
    };
    assert_eq!(offered(&["depth-calculator", "calc"]), ["calculate"]);
    assert_eq!(
        offered(&["depth-calculator", "calculate", "--sigma-w"]),
        ["--sigma-w-img", "--sigma-w-real"]
    );
    assert_eq!(
        offered(&["depth-calculator", "calculate", "--unit", ""]),
        ["nm", "µm", "mm", "cm", "m", "km", "in", "ft", "yd", "mi"]
    );
}

#[test]
fn the_manual_page_is_for_the_whole_program() {
    let page = String::from_utf8(run("man").stdout).unwrap();
    for section in [
        "NAME",
        "SYNOPSIS",
        "DESCRIPTION",
        "COMMANDS",
        "OPTIONS",
        "UNCERTAINTY",
        "FORMULAS",
        "EXAMPLES",
        "\"EXIT STATUS\"",
        "COMPLETIONS",
    ] {
        assert_eq!(
            page.lines().filter(|line| *line == format!(".SH {section}")).count(),
            1,
            "{section}"
        );
    }
    for (option, _) in OPTIONS {
        let option = option.replace('-', "\\-");
        assert!(page.contains(&format!("\\fB\\-\\-{option}\\fR")), "{option}");
        assert!(page.contains(&format!("\\fB\\-\\-sigma\\-{option}\\fR")), "{option}");
    }
    assert!(page.contains("\\fB\\-\\-unit\\fR"));
    // What is not flowed fits into a terminal of 80 columns, where man indents by 7.
    for block in page.split("\n.nf\n").skip(1) {
        for line in block.split("\n.fi\n").next().unwrap().lines() {
            let shown = line.replace("\\*(Aq", "'").replace('\\', "");
            assert!(shown.chars().count() <= 73, "{line}");
        }
    }
}
