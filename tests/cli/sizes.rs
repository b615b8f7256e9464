//! `sizes`, and `calculate --known`.

use crate::{json, run};
use serde_json::Value;

fn sizes(arguments: &str) -> Value {
    crate::answer(&format!("sizes {arguments}"))
}

#[test]
fn every_size_has_a_source_and_a_place() {
    let all = sizes("");
    for size in all.as_array().unwrap() {
        assert!(
            size["size_m"].as_f64().is_some_and(|meters| (0.005..5.0).contains(&meters)),
            "{size}"
        );
        assert!(size["source"].as_str().is_some_and(|source| source.len() > 7), "{size}");
        assert_eq!(sizes(size["name"].as_str().unwrap()), *size);
    }
    assert_eq!(
        (&sizes("card")["size_m"], &sizes("card")["sigma_m"]),
        (&0.0856.into(), &0.0001.into())
    );
    assert_eq!(sizes("door")["sigma_m"], Value::Null);
    // IFAB: a circumference of 68 to 70 cm; FIBA: of 749 to 780 mm.
    for (ball, [least, most]) in [("soccer-ball", [0.68, 0.70]), ("basketball", [0.749, 0.78])] {
        let size = sizes(ball);
        let middle = f64::midpoint(least, most) / std::f64::consts::PI;
        // As large a standard deviation as that of any size between both.
        let sigma = (most - least) / std::f64::consts::PI / 12.0_f64.sqrt();
        assert!((size["size_m"].as_f64().unwrap() - middle).abs() < 1e-4, "{size}");
        assert!((size["sigma_m"].as_f64().unwrap() - sigma).abs() < 3e-4, "{size}");
    }
}

#[test]
fn a_known_size_is_the_real_width_with_its_uncertainty() {
    let answer = json("--fx 700 --w-img 310 --known card");
    let monocular = &answer["monocular"];
    // 0.0856 m · 700 px / 310 px, and a σ of 0.1 mm in 85.6 mm.
    let distance = 0.0856 * 700.0 / 310.0;
    assert!((monocular["distance_m"].as_f64().unwrap() - distance).abs() < 1e-12, "{monocular}");
    assert!(
        (monocular["sigma_m"].as_f64().unwrap() - distance * 0.1 / 85.6).abs() < 1e-9,
        "{monocular}"
    );
    let own = json("--fx 700 --w-img 310 --known card --w-real 100mm");
    assert!(
        (own["monocular"]["distance_m"].as_f64().unwrap() - 0.1 * 700.0 / 310.0).abs() < 1e-12,
        "what is typed wins"
    );
    let sigma = json("--fx 700 --w-img 310 --known card --sigma-w-real 1mm");
    assert!(
        (sigma["monocular"]["sigma_m"].as_f64().unwrap() - distance / 85.6).abs() < 1e-9,
        "{sigma}"
    );
    let man = json("--fx 700 --fy 710 --w-img 500 --known man");
    assert!(
        (man["monocular"]["distance_m"].as_f64().unwrap() - 1.756 * 710.0 / 500.0).abs() < 1e-12,
        "a height goes with fy"
    );
    let solved = json("--fx 700 --w-img 310 --known card --solve-for w-real --distance 1");
    assert!(solved["warnings"].to_string().contains("is solved for"), "{solved}");
    let both = json("--preset oak-d --known card --w-img 310 --disparity 100");
    assert!(
        both["stereo"]["distance_m"].is_number() && both["monocular"]["distance_m"].is_number(),
        "{both}"
    );
}

#[test]
fn a_size_that_is_not_known_is_refused_with_those_that_are() {
    for arguments in ["sizes banana", "calculate --fx 700 --w-img 310 --known banana"] {
        let output = run(arguments);
        let said = String::from_utf8(output.stderr).unwrap();
        assert_eq!((output.status.code(), output.stdout.len()), (Some(2), 0), "{arguments}");
        assert!(said.contains("card, card-short") && said.lines().count() == 1, "{said}");
    }
}
