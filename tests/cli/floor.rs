//! Figures of `ground` that were worked out independently, each through the program.

use super::{near, refused, run_words, text};
use serde_json::Value;

/// The answer of `ground` in JSON.
fn ground(words: &[&str]) -> Value {
    let output = run_words(&[&["ground"], words, &["--json"]].concat());
    assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
    serde_json::from_slice(&output.stdout).unwrap()
}

fn ground_of(arguments: &str) -> Value {
    ground(&arguments.split(' ').collect::<Vec<_>>())
}

#[test]
fn the_floor_in_every_unit() {
    let of = |height: &str| ground(&["--fx", "700", "--cy", "360", "--pitch", "10", "--row", "500", "--height", height]);
    for (height, expected) in [("120 cm", 3.076), ("1.2", 3.076), ("4 ft", 3.125), ("1200mm", 3.076)] {
        near(&of(height)["distance_m"], expected, 1e-3);
    }
    near(
        &ground_of("--fx 700 --cy 360 --pitch 25 --row 360 --height 40in")["distance_m"],
        2.179,
        5e-4,
    );
    let both = ground(&["--pitch", "10", "--angle", "5", "--height", "1.2 m ± 2 cm"]);
    let apart = ground(&["--pitch", "10", "--angle", "5", "--height", "1.2", "--sigma-height", "2 cm"]);
    assert_eq!(both, apart);
    let explicit = ground(&[
        "--pitch",
        "10",
        "--angle",
        "5",
        "--height",
        "1.2 m ± 5 cm",
        "--sigma-height",
        "2 cm",
    ]);
    assert_eq!(explicit, apart);
    let uncertain = |option: &str, sigma: &str| {
        let camera = ["--fx", "700", "--cy", "360", "--pitch", "10", "--row", "500", "--height", "1.2"];
        ground(&[&camera[..], &[option, sigma]].concat())["sigma_m"].clone()
    };
    for (option, sigma, expected) in [
        ("--sigma-height", "5 cm", 0.128),
        ("--sigma-height", "5%", 0.154),
        ("--sigma-pitch", "0.5°", 0.079),
        ("--sigma-pitch", "±0.5", 0.079),
        ("--sigma-pitch", "0.5", 0.079),
    ] {
        near(&uncertain(option, sigma), expected, 6e-4);
    }
}

#[test]
fn the_floor_has_a_column() {
    let answer = ground_of("--fx 700 --fy 700 --cx 640 --cy 360 --height 1.2 --pitch 10 --u 1100 --row 500");
    near(&answer["ahead_m"], 3.076, 1e-3);
    near(&answer["right_m"], 2.128, 1e-3);
    near(&answer["distance_m"], 3.740, 1e-3);
    near(&answer["slant_m"], 3.928, 1e-3);
    let (lines, _) = text("ground --fx 700 --cx 640 --cy 360 --height 1.2 --pitch 10 --u 1100 --row 500 --unit ft");
    assert_eq!(lines[0], "12.27 ft (along the floor)");
}

#[test]
fn the_floor_straight_down_upwards_and_with_the_pitch_the_other_way() {
    for (row, distance, ahead) in [("768", 0.0, 0.0), ("1268", 4.313, -4.313), ("268", 4.313, 4.313)] {
        let answer = ground_of(&format!("--fx 2318.84 --cy 768 --height 20 --pitch 90 --row {row}"));
        near(&answer["distance_m"], distance, 5e-4);
        near(&answer["ahead_m"], ahead, 5e-4);
        assert!(answer["right_m"].is_null());
    }
    let up = ground_of("--height 20in --target-height 60in --pitch -25 --angle 0");
    near(&up["distance_m"], 2.179, 5e-4);
    let reason = refused("ground --fx 2318.84 --cy 768 --height 20 --pitch -45 --row 768");
    assert!(reason.contains("--pitch: Pitch is counted downwards here"), "{reason}");
    // It meets the floor all the same.
    near(
        &ground_of("--fx 700 --cy 360 --height 1.2 --pitch -5 --row 700")["distance_m"],
        3.1414,
        1e-3,
    );
}

#[test]
fn what_the_floor_lacks_is_named() {
    assert!(refused("ground --height 1.2").contains("Add --fx, --cy, --pitch and --row"));
    assert!(refused("ground --height 1.2 --pitch 10 --angle 5 --u 3").contains("Add --fx and --cx"));
    assert!(refused("ground --fx 700 --cy 360 --height 1.2px --pitch 10 --row 500").contains("--height: "));
    assert!(refused("ground --height 1.2 --pitch 10 --angle 5 --row 3 --fx 700 --cy 360").contains("not both"));
}

#[test]
fn a_horizontal_ray_is_at_the_horizon_however_it_is_rounded() {
    for arguments in [
        "--height 1.2 --pitch 80 --angle -80",
        "--fx 700 --height 1.2 --pitch -45 --row 1060 --cy 360",
    ] {
        let reason = refused(&format!("ground {arguments}"));
        assert!(
            reason.contains("never meets") && !reason.contains("counted downwards"),
            "{arguments}: {reason}"
        );
    }
}

#[test]
fn what_ground_does_not_use_is_a_warning() {
    for (arguments, option) in [
        ("--fx 700 --height 1.2 --pitch 10 --angle 5", "fx"),
        ("--fx 700 --fy 650 --cy 360 --row 500 --height 1.2 --pitch 10", "fx"),
        ("--cx 640 --height 1.2 --pitch 10 --angle 5", "cx"),
        // And a σ that leaves little of the answer, at the option that has most of it.
        ("--height 1.2 --pitch 1 --sigma-pitch 1 --angle 0", "pitch"),
        ("--height 1.2 --sigma-height 1e9 --pitch 10 --sigma-pitch 1 --angle 5", "height"),
        (
            "--fx 700 --height 1.2 --pitch 1 --sigma-pitch 0.1 --cy 360 --row 360 --sigma-row 20",
            "row",
        ),
        (
            "--fx 700 --sigma-fx 300 --height 1.2 --pitch 1 --cy 360 --row 500 --sigma-row 1",
            "fx",
        ),
    ] {
        assert_eq!(ground_of(arguments)["warnings"][0]["field"], option, "{arguments}");
    }
    assert!(refused("ground --height 0 --pitch 10 --angle 5").contains("--height: The height of the camera cannot be zero"));
}

/// Whatever the σ is, no answer has one that says nothing.
#[test]
fn a_sigma_out_of_all_proportion_is_refused() {
    for (option, sigma) in [
        ("height", "1e200"),
        ("pitch", "1e9"),
        ("pitch", "91"),
        ("row", "1e200"),
        ("fx", "1e200"),
    ] {
        let reason = refused(&format!(
            "ground --fx 700 --height 1.2 --pitch 10 --cy 360 --row 500 --sigma-{option} {sigma}"
        ));
        assert!(
            reason.contains(&format!("--sigma-{option}: The uncertainty of")),
            "{option} {sigma}: {reason}"
        );
    }
    for (option, sigma) in [("range", "1e200"), ("fx", "1e200")] {
        let reason = refused(&format!(
            "calculate --fx 700 --cx 640 --cy 360 --u 1000 --v 360 --range 5 --sigma-{option} {sigma}"
        ));
        assert!(
            reason.contains(&format!("--sigma-{option}: The uncertainty of")),
            "{option} {sigma}: {reason}"
        );
    }
}

#[test]
fn the_sign_of_the_pitch_is_blamed_only_where_the_other_one_helps() {
    let up = refused("ground --height 20in --target-height 60in --pitch 25 --angle 0");
    assert!(up.contains("--pitch: The camera looks down and the target is above it"), "{up}");
    let down = refused("ground --height 1.2 --pitch -25 --angle 0");
    assert!(down.contains("--pitch: Pitch is counted downwards here"), "{down}");
    // Far beyond straight down there is no pitch, whatever its sine would be.
    for pitch in ["200", "370", "3.49rad", "-130"] {
        let said = refused(&format!("ground --height 1.2 --pitch {pitch} --angle 0"));
        assert!(said.contains("--pitch: This is no pitch"), "{said}");
    }
    assert!(refused("ground --height 1.2 --pitch 10cm --angle 5").contains("“cm” does not fit the pitch"));
    let neither = refused("ground --height 1.2 --pitch -10 --angle 10");
    assert!(
        neither.contains("never meets the plane") && !neither.contains("Pitch is counted"),
        "{neither}"
    );
}
