//! The command line, as a shell sees it: answers, exit status, what is said on stderr.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, missing_docs, reason = "tests")]

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

fn json(arguments: &str) -> Value {
    let output = run(&format!("calculate {arguments} --json"));
    assert_eq!(
        output.status.code(),
        Some(0),
        "{arguments}: {}",
        String::from_utf8_lossy(&output.stderr)
    );
    serde_json::from_slice(&output.stdout).unwrap()
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

#[test]
fn the_mug_and_the_doorway() {
    let mug = json(MUG);
    assert_eq!(mug["stereo"]["distance_m"], 1.4);
    assert!(mug["stereo"]["sigma_m"].is_null() && mug["stereo"]["near_m"].is_null() && mug["stereo"]["far_m"].is_null());
    assert!(mug["monocular"].is_null() && mug["combined"].is_null() && mug["estimated_width_px"].is_null());
    assert_eq!(mug["warnings"].as_array().unwrap().len(), 0);
    assert_eq!(json("--fx 950 --w-img 200 --w-real 0.9m")["monocular"]["distance_m"], 4.275);
}

/// The golden figures: 1.400 ± 0.016 m; 1.400 ± 0.050 m (1.3498 … 1.4507); combined ± 0.01547 m.
#[test]
fn uncertainty_of_both_methods_and_of_their_combination() {
    let both = json(&format!("{MUG} {SIGMAS} {TWIN}"));
    near(&both["stereo"]["sigma_m"], 0.0162, 5e-5);
    near(&both["stereo"]["near_m"], 1.3840, 5e-5);
    near(&both["stereo"]["far_m"], 1.4163, 5e-5);
    near(&both["monocular"]["sigma_m"], 0.050, 5e-4);
    near(&both["monocular"]["near_m"], 1.3498, 5e-5);
    near(&both["monocular"]["far_m"], 1.4507, 5e-5);
    near(&both["combined"]["distance_m"], 1.4, 1e-12);
    near(&both["combined"]["sigma_m"], 0.01547, 5e-6);
    near(&both["estimated_width_px"], 150.0, 1e-9);
    near(&both["estimated_width_m"], 0.3, 1e-9);
}

#[test]
fn bare_lengths_percentages_and_other_units() {
    assert_eq!(json("--fx 700 --baseline 100 --disparity 50")["stereo"]["distance_m"], 1.4);
    assert_eq!(json("--fx 950 --w-img 200 --w-real 0.9")["monocular"]["distance_m"], 4.275);
    near(
        &json("--fx 700 --baseline 4in --disparity 50")["stereo"]["distance_m"],
        1.4224,
        1e-12,
    );
    near(&json(&format!("{MUG} --sigma-disparity 1%"))["stereo"]["sigma_m"], 0.014, 1e-12);
    near(&json(&format!("{MUG} --sigma-baseline 1mm"))["stereo"]["sigma_m"], 0.014, 1e-12);
    near(&json(&format!("{MUG} --sigma-baseline 1"))["stereo"]["sigma_m"], 0.014, 1e-12);
}

/// OpenCV's stereoRectify with cx 610 and 650: Z = 777.78 mm at d = 50 px.
#[test]
fn doffs_is_added_to_the_disparity_and_may_be_negative() {
    near(
        &json("--fx 700 --baseline 100 --disparity 50 --doffs 40")["stereo"]["distance_m"],
        0.777_777_8,
        1e-6,
    );
    near(
        &json("--fx 700 --baseline 100 --disparity 90 --doffs=-40")["stereo"]["distance_m"],
        1.4,
        1e-12,
    );
    // Only d + doffs has to be positive.
    near(
        &json("--fx 700 --baseline 100 --disparity=-10 --doffs 60")["stereo"]["distance_m"],
        1.4,
        1e-12,
    );
}

#[test]
fn an_unbounded_far_end_is_null() {
    let far = json("--fx 700 --baseline 100 --disparity 1 --sigma-disparity 1");
    assert!(far["stereo"]["far_m"].is_null());
    near(&far["stereo"]["near_m"], 35.0, 1e-9);
}

#[test]
fn half_of_the_other_method_is_a_warning() {
    let half = json(&format!("{MUG} --w-img 150"));
    assert_eq!(half["warnings"][0]["field"], "w-real");
    assert!(half["warnings"][0]["message"].as_str().unwrap().contains("missing"));
    let beside = json("--fx 950 --w-img 200 --w-real 0.9 --baseline 100 --disparity 0");
    assert_eq!(beside["warnings"][0]["field"], "disparity");
    let unusual = json("--fx 700 --baseline 0.1 --disparity 50");
    assert_eq!(unusual["warnings"][0]["field"], "baseline");
}

#[test]
fn what_cannot_be_answered_is_refused_in_one_line_with_status_2() {
    assert!(refused("calculate --fx 700").contains("No distance can be computed"));
    assert!(refused("calculate --fx abc --baseline 100 --disparity 50").contains("--fx: “abc” is not a number"));
    assert!(refused("calculate --fx 1,000 --baseline 100 --disparity 50").contains("could mean"));
    assert!(refused("calculate --fx 700 --baseline 100 --disparity 0").contains("infinitely far away"));
    assert!(refused("calculate --fx 700 --baseline 100 --disparity=-50").contains("swapped"));
    assert!(refused("calculate --fx 700 --baseline 100 --disparity 50 --sigma-fx=-1").contains("negative"));
    assert!(refused("calculate --fx 700 --baseline 100px --disparity 50").contains("mm, cm, m, in or ft"));
    assert!(refused("calculate --focal 700").contains("--focal"));
    assert!(refused("frobnicate").contains("frobnicate"));
}

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
        "[possible values: mm, cm, m, in, ft]",
    ] {
        assert!(text.contains(taught), "{taught}");
    }
}

/// The value options, each with a value.
const OPTIONS: [(&str, &str); 6] = [
    ("fx", "700"),
    ("baseline", "100"),
    ("disparity", "50"),
    ("doffs", "0"),
    ("w-img", "150"),
    ("w-real", "0.3"),
];

/// The options of one method that has the value option `name`, with their σ, and with `value` for `option`.
fn all_but(name: &str, option: &str, value: &str) -> String {
    let (stereo, monocular) = (&OPTIONS[..4], [&OPTIONS[..1], &OPTIONS[4..]].concat());
    let method = if name.starts_with("w-") { &monocular } else { stereo };
    let values = method.iter().map(|(name, value)| (name.to_string(), *value));
    let sigmas = method.iter().map(|(name, _)| (format!("sigma-{name}"), "0.01"));
    values
        .chain(sigmas)
        .map(|(name, usual)| format!("--{name}={}", if name == option { value } else { usual }))
        .collect::<Vec<_>>()
        .join(" ")
}

#[test]
fn every_refusal_names_the_option_that_was_typed() {
    for (name, _) in OPTIONS {
        for option in [name.to_owned(), format!("sigma-{name}")] {
            for wrong in ["abc", "1,000", "1furlong", "-", "-abc", "-5parsecs", "1e999"] {
                let reason = refused(&format!("calculate {}", all_but(name, &option, wrong)));
                let start = format!("depth-calculator: --{option}: ");
                assert!(reason.starts_with(&start), "{option} {wrong}: {reason}");
            }
            let reason = refused(&format!("calculate {}", all_but(name, &option, "")));
            assert!(reason.contains(&format!("--{option} is empty")), "{reason}");
        }
        let sigma = format!("sigma-{name}");
        let reason = refused(&format!("calculate {}", all_but(name, &sigma, "-1")));
        assert!(reason.contains(&format!("--{sigma}: “-1” is negative")), "{reason}");
    }
    // A σ so large that not even the distance's own can be represented.
    let reason = refused("calculate --fx 1e154 --baseline 1e154m --disparity 1 --sigma-disparity 1e10");
    assert!(reason.contains("--sigma-disparity: This uncertainty"), "{reason}");
}

#[test]
fn every_warning_names_the_option_that_was_typed() {
    for (option, unusual) in [
        ("fx", "30000"),
        ("baseline", "9m"),
        ("disparity", "2000"),
        ("doffs", "2000"),
        ("w-img", "9000"),
        ("w-real", "99"),
    ] {
        let arguments = all_but(option, option, unusual);
        let warnings = &json(&arguments)["warnings"];
        let fields: Vec<_> = warnings.as_array().unwrap().iter().map(|warning| &warning["field"]).collect();
        assert!(fields.iter().any(|field| **field == option), "{option}: {fields:?}");
        let (_, err) = text(&format!("calculate {arguments}"));
        let start = format!("depth-calculator: warning: --{option}: ");
        assert!(err.iter().any(|line| line.starts_with(&start)), "{option}: {err:?}");
    }
    // A σ that is wrong, of a method without a distance; and one that has nothing to belong to.
    for (method, others) in [
        (MUG, ["w-img", "w-real"]),
        ("--fx 950 --w-img 200 --w-real 0.9", ["baseline", "disparity"]),
    ] {
        for option in others {
            for sigma in ["abc", "1"] {
                let warnings = &json(&format!("{method} --sigma-{option} {sigma}"))["warnings"];
                assert_eq!(warnings[0]["field"], format!("sigma-{option}"), "{sigma}");
            }
        }
    }
    let doffs = json("--fx 950 --w-img 200 --w-real 0.9 --doffs 3 --sigma-doffs 1");
    assert_eq!(doffs["warnings"][0]["field"], "doffs");
    assert_eq!(doffs["warnings"][1]["field"], "sigma-doffs");
    assert_eq!(json(&format!("{MUG} --sigma-doffs 1"))["warnings"].as_array().unwrap().len(), 0);
}

#[test]
fn a_value_may_start_with_a_minus_sign_behind_a_blank_as_behind_an_equals_sign() {
    for value in ["-5", "-.5", "-1e3", "-5px", "-5 px", "-5 mm", "-1,000", "-abc", "−5", "−5 mm"] {
        for (name, _) in OPTIONS {
            for option in [name.to_owned(), format!("sigma-{name}")] {
                let arguments = format!("calculate {}", all_but(name, &option, "HERE"));
                let call = |separator: &str| {
                    let given = arguments.replace("=HERE", &format!("{separator}HERE"));
                    let words: Vec<_> = given.split(' ').map(|word| word.replace("HERE", value)).collect();
                    let output = run_words(&words.iter().map(String::as_str).collect::<Vec<_>>());
                    (output.status.code(), output.stdout, String::from_utf8(output.stderr).unwrap())
                };
                let behind_a_blank = call(" ");
                assert_eq!(behind_a_blank, call("="), "{option} {value}");
                let (status, _, err) = behind_a_blank;
                assert!(status == Some(0) || err.contains(&option), "{option} {value}: {err}");
            }
        }
    }
    near(
        &json("--fx 700 --baseline 100 --disparity 90 --doffs -40px")["stereo"]["distance_m"],
        1.4,
        1e-12,
    );
}

#[test]
fn a_forgotten_value_is_not_the_next_option() {
    for (option, _) in OPTIONS {
        for option in [format!("--{option}"), format!("--sigma-{option}"), "--unit".to_owned()] {
            for next in ["--json", "--fx", "-h"] {
                let reason = refused(&format!("calculate {option} {next} 100"));
                assert!(reason.contains("a value is required for") && reason.contains(&option), "{reason}");
            }
        }
    }
}

#[test]
fn a_refusal_keeps_the_tip_that_helps() {
    assert!(refused("calculate --fxx 7").contains("a similar argument exists: '--fx'"));
    assert!(refused("calculat").contains("a similar subcommand exists: 'calculate'"));
    assert!(refused("calculate --unit km").contains("[possible values: mm, cm, m, in, ft]"));
    assert!(refused("completions").contains("<SHELL>"));
    assert!(refused("completions tcsh").contains("bash"));
    for arguments in ["calculate", "calculate --", "calculate --json"] {
        let reason = refused(arguments);
        for option in ["--fx, --baseline and --disparity", "--fx, --w-img and --w-real", "see --help"] {
            assert!(reason.contains(option), "{reason}");
        }
    }
    assert!(refused("calculate --fx 7 --w-img 9").contains("Add --w-real for the monocular distance"));
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
            assert!(last.starts_with("depth-calculator: The window could not be opened: "), "{last}");
            assert!(!last.contains(".rs") && !last.contains(".."), "{last}");
        } else {
            assert_eq!(output.status.code(), Some(2), "{last}");
            assert!(reason.contains("Usage:"), "{reason}");
        }
        assert!(last.contains("depth-calculator calculate"), "{last}");
        assert!(output.stdout.is_empty());
    }
}

#[test]
fn the_first_line_is_the_answer() {
    let first = |arguments: &str| text(&format!("calculate {arguments}")).0[0].clone();
    assert_eq!(first(MUG), "1.400 m (stereo)");
    assert_eq!(first("--fx 950 --w-img 200 --w-real 0.9"), "4.275 m (monocular)");
    assert_eq!(first(&format!("{MUG} {SIGMAS}")), "1.400 ± 0.016 m (stereo)");
    assert_eq!(
        first(&format!("{MUG} {SIGMAS} {TWIN}")),
        "1.400 ± 0.015 m (combined, the shared focal length accounted for)"
    );
    // Without σ nothing is combined.
    let (both, _) = text(&format!("calculate {MUG} --w-img 150 --w-real 0.3"));
    let distances: Vec<_> = both.iter().filter(|line| line.starts_with(|c: char| c.is_ascii_digit())).collect();
    assert_eq!(distances, ["1.400 m (stereo)", "1.400 m (monocular)"]);
}

#[test]
fn the_text_says_what_is_needed_and_no_more() {
    let (lines, err) = text(&format!("calculate {MUG} {SIGMAS} {TWIN}"));
    assert_eq!(
        lines,
        [
            "1.400 ± 0.015 m (combined, the shared focal length accounted for)",
            "  Stereo and monocular agree within their uncertainties (0.0 σ apart).",
            "1.400 ± 0.016 m (stereo)",
            "  D = fx · b / d = 700 px · 0.1 m / 50 px",
            "  1 σ interval: 1.384 to 1.416 m",
            "  variance: disparity 75 %, baseline 19 %, focal length 6 %",
            "  one pixel of disparity more or less: 1.373 to 1.429 m",
            "1.400 ± 0.050 m (monocular)",
            "  D = w_real · fx / w_img = 0.3 m · 700 px / 150 px",
            "  1 σ interval: 1.350 to 1.451 m",
            "  variance: real width 86 %, width in the image 14 %, focal length 1 %",
            "Width in the image that the real width predicts: 150.0 px",
            "Real width that the width in the image predicts: 0.3000 m",
            "  Computed from the stereo distance, as a check: both widths agree with what you entered to within 0.1 %.",
        ]
    );
    assert_eq!(err, Vec::<String>::new());
    let (doorway, _) = text("calculate --fx 950 --w-img 200 --w-real 0.9");
    assert_eq!(
        doorway,
        ["4.275 m (monocular)", "  D = w_real · fx / w_img = 0.9 m · 950 px / 200 px"]
    );
    let (offset, _) = text("calculate --fx 700 --baseline 100 --disparity 90 --doffs -40");
    assert_eq!(offset[1], "  D = fx · b / (d + doffs) = 700 px · 0.1 m / (90 px - 40 px)");
    let (poor, _) = text("calculate --fx 700 --baseline 100 --disparity 1 --sigma-disparity 1");
    assert!(poor.iter().any(|line| line.contains("worse than 10 %")), "{poor:?}");
    assert!(
        poor.contains(&"  1 σ interval: 35 m or more, without an upper bound".to_owned()),
        "{poor:?}"
    );
}

/// Whatever is asked: no digits but ASCII ones with nothing between them, no minus but the hyphen, and nothing that only the
/// window has.
#[test]
fn numbers_are_plain_and_nothing_is_said_of_the_window() {
    for arguments in [
        format!("{MUG} {SIGMAS} {TWIN}"),
        format!("{MUG} {SIGMAS} --w-img 113 --w-real 0.3 --sigma-w-img 2 --sigma-w-real 0.01 --unit mm"),
        "--fx 30000 --baseline 9m --disparity 0.7 --sigma-disparity 0.6 --doffs -0.1 --w-img 9000 --w-real 99".to_owned(),
        "--fx 700 --baseline 100 --disparity 50 --doffs -2000".replace("50", "2050"),
        "--fx 7e8 --baseline 1e-3mm --disparity 1e-5 --sigma-baseline 1% --unit ft".to_owned(),
    ] {
        let (out, err) = text(&format!("calculate {arguments}"));
        let all = [out, err].concat().join("\n");
        for wrong in [
            "simulation",
            "unrounded",
            "−",
            "\u{2009}",
            "\u{202f}",
            "\u{a0}",
            "…",
            "–",
            "99999",
            "00000000000",
        ] {
            assert!(!all.contains(wrong), "{wrong:?} is in\n{all}");
        }
        let characters: Vec<char> = all.chars().collect();
        let grouped = characters
            .windows(3)
            .any(|three| matches!(three, [a, ' ' | ',' | '\'', c] if a.is_numeric() && c.is_numeric()));
        assert!(!grouped, "{all}");
        assert!(all.chars().all(|c| !c.is_numeric() || c.is_ascii_digit()), "{all}");
    }
}

#[test]
fn large_and_small_distances_are_written_out() {
    let first = |arguments: &str| text(&format!("calculate {arguments}")).0[0].clone();
    assert_eq!(first("--fx 1200 --baseline 10m --disparity 1"), "12000 m (stereo)");
    assert_eq!(first("--fx 7000 --baseline 100m --disparity 1 --unit mm"), "700000000 mm (stereo)");
    assert_eq!(
        first("--fx 12346 --baseline 1m --disparity 1 --sigma-disparity 1%"),
        "12350 ± 120 m (stereo)"
    );
    assert_eq!(first("--fx 700 --baseline 0.05mm --disparity 50"), "0.0007000 m (stereo)");
}

#[test]
fn every_length_of_the_text_is_in_the_unit_asked_for_and_json_in_meters() {
    let arguments = format!("{MUG} {SIGMAS} {TWIN}");
    for (unit, lengths) in [
        (
            "mm",
            [
                "1400 ± 15 mm",
                "1384 to 1416 mm",
                "· 100 mm /",
                "1373 to 1429 mm",
                "= 300 mm",
                "300.0 mm",
            ],
        ),
        (
            "cm",
            [
                "140.0 ± 1.5 cm",
                "138.4 to 141.6 cm",
                "· 10 cm /",
                "137.3 to 142.9 cm",
                "= 30 cm",
                "30.00 cm",
            ],
        ),
        (
            "m",
            [
                "1.400 ± 0.015 m",
                "1.384 to 1.416 m",
                "· 0.1 m /",
                "1.373 to 1.429 m",
                "= 0.3 m",
                "0.3000 m",
            ],
        ),
        (
            "in",
            [
                "55.12 ± 0.61 in",
                "54.49 to 55.76 in",
                "· 3.93700787402 in /",
                "54.04 to 56.24 in",
                "= 11.811023622 in",
                "11.81 in",
            ],
        ),
        (
            "ft",
            [
                "4.593 ± 0.051 ft",
                "4.541 to 4.647 ft",
                "· 0.328083989501 ft /",
                "4.503 to 4.687 ft",
                "= 0.984251968504 ft",
                "0.9843 ft",
            ],
        ),
    ] {
        let (lines, _) = text(&format!("calculate {arguments} --unit {unit}"));
        let all = lines.join("\n");
        for length in lengths {
            assert!(all.contains(length), "{length:?} is not in\n{all}");
        }
        let others = ["mm", "cm", "m", "in", "ft"].into_iter().filter(|other| *other != unit);
        for other in others {
            let elsewhere = all.split([' ', '\n']).collect::<Vec<_>>();
            let wrong = elsewhere
                .windows(2)
                .any(|pair| pair[0].ends_with(|c: char| c.is_ascii_digit()) && pair[1] == other);
            assert!(!wrong, "{other} is in\n{all}");
        }
        near(&json(&format!("{arguments} --unit {unit}"))["stereo"]["distance_m"], 1.4, 1e-12);
    }
}

/// What cannot be written is said, whatever it is.
#[cfg(target_os = "linux")]
#[test]
fn a_full_disk_is_a_sentence_and_status_1() {
    for arguments in [
        format!("calculate {MUG}"),
        format!("calculate {MUG} --json"),
        "--help".to_owned(),
        "--version".to_owned(),
        "calculate --help".to_owned(),
        "completions bash".to_owned(),
        "man".to_owned(),
    ] {
        let full = std::fs::OpenOptions::new().write(true).open("/dev/full").unwrap();
        let words: Vec<_> = arguments.split_whitespace().collect();
        let output = program(&words).stdout(full).output().unwrap();
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
    let output = program(&["completions", "zsh"]).stdout(writer).output().unwrap();
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
        ["mm", "cm", "m", "in", "ft"]
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
