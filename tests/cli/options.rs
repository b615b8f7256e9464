//! What is said about an option names the option that was typed.

use super::{MUG, OPTIONS, json, near, refused, run_words, text};

#[test]
fn what_cannot_be_answered_is_refused_in_one_line_with_status_2() {
    assert!(refused("calculate --fx 700").contains("No distance can be computed"));
    assert!(refused("calculate --fx abc --baseline 100 --disparity 50").contains("--fx: “abc” is not a number"));
    assert!(refused("calculate --fx 1,000 --baseline 100 --disparity 50").contains("could mean"));
    assert!(refused("calculate --fx 700 --baseline 100 --disparity 0").contains("infinitely far away"));
    assert!(refused("calculate --fx 700 --baseline 100 --disparity=-50").contains("swapped"));
    assert!(refused("calculate --fx 700 --baseline 100 --disparity 50 --sigma-fx=-1").contains("negative"));
    assert!(refused("calculate --fx 700 --baseline 100px --disparity 50").contains("mm, cm, m, km, in, ft, yd or mi"));
    assert!(refused("calculate --focal 700").contains("--focal"));
    assert!(refused("frobnicate").contains("frobnicate"));
}

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
    assert!(reason.contains("--sigma-disparity: The uncertainty"), "{reason}");
}

#[test]
fn every_warning_names_the_option_that_was_typed() {
    for (option, unusual) in [
        ("fx", "300000"),
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
    assert!(refused("calculates").contains("a similar subcommand exists: 'calculate'"));
    assert!(refused("calculate --unit parsec").contains("[possible values: nm, µm, mm, cm, m, km, in, ft, yd, mi]"));
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

#[test]
fn a_command_that_there_is_not_is_refused_with_those_that_there_are() {
    assert!(refused("frobnicate").contains(
        "the commands are calculate, ground, step, between, import, q, camera, decode, presets, sizes, completions, man (see --help)"
    ));
    assert!(refused("calculates").contains(
        "the commands are calculate, ground, step, between, import, q, camera, decode, presets, sizes, completions, man (see --help)"
    ));
}

/// A variable of a script that was not set, behind the sign.
#[test]
fn a_sigma_that_was_begun_and_left_empty_is_refused() {
    let output = run_words(&["calculate", "--fx", "700", "--baseline", "100", "--disparity", "50 ±"]);
    assert_eq!(output.status.code(), Some(2));
    assert!(String::from_utf8(output.stderr).unwrap().contains("--disparity"));
}
