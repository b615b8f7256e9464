//! The answer for people.

use super::{MUG, SIGMAS, TWIN, json, near, text};

#[test]
fn the_first_line_is_the_answer() {
    let first = |arguments: &str| text(&format!("calculate {arguments}")).0[0].clone();
    assert_eq!(first(MUG), "1.400 m (stereo)");
    assert_eq!(first("--fx 950 --w-img 200 --w-real 0.9"), "4.275 m (monocular)");
    assert_eq!(first(&format!("{MUG} {SIGMAS}")), "(1.400 ± 0.016) m (stereo)");
    assert_eq!(
        first(&format!("{MUG} {SIGMAS} {TWIN}")),
        "(1.400 ± 0.015) m (combined, the shared focal length accounted for)"
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
            "(1.400 ± 0.015) m (combined, the shared focal length accounted for)",
            "  Stereo and monocular agree within their uncertainties (0 σ apart).",
            "(1.400 ± 0.016) m (stereo)",
            "  D = fx · b / d = 700 px · 100 mm / 50 px",
            "  1 σ interval: 1.384 to 1.416 m",
            "  variance: disparity 75 %, baseline 19 %, focal length 6 %",
            "(1.400 ± 0.050) m (monocular)",
            "  D = w_real · fx / w_img = 0.3 m · 700 px / 150 px",
            "  1 σ interval: 1.350 to 1.451 m",
            "  variance: real width 86 %, width in the image 14 %, focal length < 1 %",
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
    assert_eq!(offset[1], "  D = fx · b / (d + doffs) = 700 px · 100 mm / (90 px - 40 px)");
    let (poor, _) = text("calculate --fx 700 --baseline 100 --disparity 1 --sigma-disparity 1");
    assert!(poor.iter().any(|line| line.contains("more than 10 %")), "{poor:?}");
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
        "(12350 ± 120) m (stereo)"
    );
    assert_eq!(first("--fx 700 --baseline 0.05mm --disparity 50"), "0.0007000 m (stereo)");
}

#[test]
fn lengths_beyond_that_take_the_next_unit_or_a_power_of_ten() {
    let first = |arguments: &str| text(&format!("calculate {arguments}")).0[0].clone();
    for (arguments, distance) in [
        ("--fx 1000 --baseline 384.4km --disparity 1", "384400 km"),
        ("--fx 2000 --baseline 100km --disparity 1", "200000 km"),
        ("--fx 1000 --baseline 1000000mi --disparity 1", "1.609 × 10¹² m"),
        ("--fx 1000 --baseline 7nm --disparity 1000", "7.000 nm"),
        ("--fx 1000 --baseline 0.014nm --disparity 1000", "1.400 × 10⁻¹¹ m"),
        (
            "--fx 1000 --baseline 0.014nm --disparity 1000 --sigma-disparity 1%",
            "(1.400 ± 0.014) × 10⁻¹¹ m",
        ),
        ("--fx 1000 --baseline 1000mi --disparity 1 --unit mi", "1000000 mi"),
    ] {
        assert_eq!(first(arguments), format!("{distance} (stereo)"), "{arguments}");
    }
}

/// The lengths of the mug, by unit.
const LENGTHS: [(&str, [&str; 3]); 5] = [
    ("mm", ["(1400 ± 15) mm", "1384 to 1416 mm", "300.0 mm"]),
    ("cm", ["(140.0 ± 1.5) cm", "138.4 to 141.6 cm", "30.00 cm"]),
    ("m", ["(1.400 ± 0.015) m", "1.384 to 1.416 m", "0.3000 m"]),
    ("in", ["(55.12 ± 0.61) in", "54.49 to 55.76 in", "11.81 in"]),
    ("ft", ["(4.593 ± 0.051) ft", "4.541 to 4.647 ft", "0.9843 ft"]),
];

#[test]
fn every_length_of_the_text_is_in_the_unit_asked_for_and_json_in_meters() {
    let arguments = format!("{MUG} {SIGMAS} {TWIN}");
    for (unit, lengths) in LENGTHS {
        let (lines, _) = text(&format!("calculate {arguments} --unit {unit}"));
        // The numbers in a formula stand as they were typed.
        let results: Vec<String> = lines.into_iter().filter(|line| !line.contains(" = ")).collect();
        let all = results.join("\n");
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

/// 1.4 m against 14 m, 8 σ and more apart: nothing between them is an answer.
#[test]
fn distances_that_contradict_each_other_are_not_combined() {
    let (lines, _) = text(&format!(
        "calculate {}",
        "--fx 700 --baseline 100mm --disparity 50 --sigma-disparity 0.5 --w-img 150 --w-real 3 --sigma-w-img 1"
    ));
    assert_eq!(lines[0], "(1.400 ± 0.014) m (stereo)");
    assert!(!lines.iter().any(|line| line.contains("combined")), "{lines:?}");
    assert!(lines.iter().any(|line| line.contains("disagree")), "{lines:?}");
}

#[test]
fn inputs_stand_in_the_formula_as_they_were_typed() {
    let formula = |arguments: &str| text(&format!("calculate {arguments}")).0[1].clone();
    assert_eq!(
        formula("--fx 700 --baseline 4in --disparity 0.05 --unit ft"),
        "  D = fx · b / d = 700 px · 4 in / 0.05 px"
    );
    assert_eq!(
        formula("--fx 700 --baseline 100 --disparity 90 --doffs -40"),
        "  D = fx · b / (d + doffs) = 700 px · 100 mm / (90 px - 40 px)"
    );
    assert_eq!(
        formula("--fx 950 --w-img 200 --w-real 0.9 --tilt 60"),
        "  D = w_real · cos φ · fx / w_img = 0.9 m · cos 60° · 950 px / 200 px"
    );
}

/// With a σ of the disparity its stand-in would be a second interval that contradicts the first.
#[test]
fn one_pixel_stands_in_for_a_sigma_of_the_disparity() {
    let has_one_pixel = |arguments: &str| {
        text(&format!("calculate {arguments}"))
            .0
            .iter()
            .any(|line| line.contains("one pixel"))
    };
    assert!(has_one_pixel(MUG));
    assert!(has_one_pixel(&format!("{MUG} --sigma-baseline 1mm")));
    assert!(!has_one_pixel(&format!("{MUG} --sigma-disparity 0.5")));
}
