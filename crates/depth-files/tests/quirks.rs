//! Every quirk of calibration files that was met in public: small files of our own, with the right answers in `data/quirks/expected.json`.

#![allow(clippy::unwrap_used, clippy::expect_used, clippy::indexing_slicing, reason = "tests")]

use depth_files::{Baseline, Found, Refusal, read};
use serde_json::{Value, json};
use std::fs;
use std::path::PathBuf;

fn folder() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tests/data/quirks")
}

fn expected() -> Value {
    serde_json::from_str(&fs::read_to_string(folder().join("expected.json")).unwrap()).unwrap()
}

fn bytes_of(case: &Value) -> Vec<Vec<u8>> {
    let names = case["files"].as_array().unwrap().iter();
    names.map(|name| fs::read(folder().join(name.as_str().unwrap())).unwrap()).collect()
}

fn read_all(files: &[Vec<u8>]) -> Result<Found, Refusal> {
    let files: Vec<&[u8]> = files.iter().map(Vec::as_slice).collect();
    read(&files)
}

/// What differs between what was found and what is right.
fn differences(found: &Found, case: &Value) -> Vec<String> {
    let mut all = Vec::new();
    let mut compare = |what: &str, got: Option<f64>, want: &Value| {
        let is_same = match (got, want.as_f64()) {
            (None, None) => true,
            (Some(got), Some(want)) => (got - want).abs() <= 1e-9 + 1e-6 * want.abs(),
            _ => false,
        };
        if !is_same {
            all.push(format!("{what} {got:?} instead of {want}"));
        }
    };
    if let Some(cameras) = case["cameras"].as_array() {
        compare(
            "the number of cameras",
            Some(u32::try_from(found.cameras.len()).unwrap().into()),
            &json!(cameras.len()),
        );
        for (got, want) in found.cameras.iter().zip(cameras) {
            let [width, height] = got.size.map_or([None; 2], |size| size.map(|side| Some(f64::from(side))));
            compare("width", width, &want["width"]);
            compare("height", height, &want["height"]);
            for (name, value) in [("fx", got.fx), ("fy", got.fy), ("cx", got.cx), ("cy", got.cy)] {
                compare(name, Some(value.px()), &want[name]);
            }
        }
    }
    compare(
        "the baseline",
        found.baseline.and_then(|one| one.length(None)).map(|one| one.m()),
        &case["baseline_m"],
    );
    if !case["baseline_file_units"].is_null() {
        let value = match found.baseline {
            Some(Baseline::InFileUnits { value, .. }) => Some(value),
            _ => None,
        };
        compare("the baseline in units of the file", value, &case["baseline_file_units"]);
    }
    if !case["doffs_px"].is_null() {
        compare("doffs", found.doffs.map(|doffs| doffs.px()), &case["doffs_px"]);
    }
    if let Some(rectified) = case["rectified"].as_bool().filter(|rectified| *rectified != found.is_rectified()) {
        all.push(format!("rectified should be {rectified}"));
    }
    if let Some(format) = case["format"].as_str().filter(|format| *format != found.format.name()) {
        all.push(format!("the format is {} instead of {format}", found.format.name()));
    }
    let said: Vec<String> = found.warnings.iter().map(ToString::to_string).collect();
    if !says_one_of(&said.join(" "), &case["warn_any_of"]) {
        all.push(format!("none of {} in {said:?}", case["warn_any_of"]));
    }
    all
}

/// Whether one of these words is in a text, or none is asked for.
fn says_one_of(text: &str, words: &Value) -> bool {
    let lower = text.to_ascii_lowercase();
    let all = words.as_array();
    all.is_none_or(|all| all.iter().any(|word| lower.contains(&word.as_str().unwrap().to_ascii_lowercase())))
}

fn judge(answer: &Result<Found, Refusal>, case: &Value) -> Vec<String> {
    match (answer, case["refuse"].is_null()) {
        (Ok(found), true) => differences(found, case),
        (Ok(found), false) => vec![format!("should be refused ({}), found {found:?}", case["refuse"])],
        (Err(refusal), true) => vec![format!("refused: {refusal}")],
        (Err(refusal), false) => {
            let sentence = refusal.to_string();
            let is_clear = says_one_of(&sentence, &case["refuse_any_of"]);
            if is_clear {
                Vec::new()
            } else {
                vec![format!("says none of {}: {sentence}", case["refuse_any_of"])]
            }
        }
    }
}

/// What is as good: each overrides some of what is right; a text for the cameras leaves them open.
fn alternatives(case: &Value) -> Vec<Value> {
    let others = case["also_accept"].as_array().into_iter().flatten().filter_map(Value::as_object);
    others
        .map(|other| {
            let mut merged = case.clone();
            merged["refuse"] = Value::Null;
            for (key, value) in other {
                merged[key] = if key == "cameras" && value.is_string() {
                    Value::Null
                } else {
                    value.clone()
                };
            }
            merged
        })
        .collect()
}

#[test]
fn every_quirk_is_read_or_refused_as_it_should_be() {
    let mut faults = Vec::new();
    let all = expected();
    let cases = all["cases"].as_array().unwrap();
    for case in cases {
        let answer = read_all(&bytes_of(case));
        let found = judge(&answer, case);
        if !found.is_empty() && !alternatives(case).iter().any(|other| judge(&answer, other).is_empty()) {
            faults.push(format!("{}: {}", case["files"], found.join("; ")));
        }
    }
    assert!(cases.len() >= 52, "{}", cases.len());
    assert!(faults.is_empty(), "{} of {}:\n{}", faults.len(), cases.len(), faults.join("\n"));
}

#[test]
fn files_of_megabytes_and_deep_brackets_are_refused_in_a_sentence() {
    let zeros = vec![0; 10 << 20];
    let row = [b"P0: ".to_vec(), b"0 ".repeat(2_000_000)].concat();
    let brackets = b"[".repeat(200_000);
    for (bytes, word) in [(zeros, "binary"), (row, "12"), (brackets, "deep")] {
        let refusal = read(&[&bytes]).unwrap_err().to_string();
        assert!(refusal.contains(word), "{refusal}");
    }
}

/// Of each file every beginning: none makes the program panic, and one that ends with a line has the baseline of the whole, or none.
#[test]
fn every_truncation_is_refused_or_has_no_other_baseline_than_the_whole() {
    let all = expected();
    let baseline = |found: &Found| match found.baseline {
        Some(Baseline::Known(length)) => Some(length.m()),
        Some(Baseline::InFileUnits { value, .. }) => Some(value),
        None => None,
    };
    for case in all["cases"].as_array().unwrap() {
        let files = bytes_of(case);
        let whole = read_all(&files);
        let last = files.last().unwrap();
        let powers = (0..20).map(|power| 1usize << power);
        let line_ends = last.iter().enumerate().filter(|(_, byte)| **byte == b'\n').map(|(at, _)| at + 1);
        for length in powers
            .chain((0..last.len()).step_by(397))
            .chain(line_ends)
            .filter(|length| *length < last.len())
        {
            let mut cut = files.clone();
            cut.last_mut().unwrap().truncate(length);
            let ends_with_line = cut.last().unwrap().last() == Some(&b'\n');
            let answers = (
                read_all(&cut).ok().as_ref().and_then(baseline),
                whole.as_ref().ok().and_then(baseline),
            );
            if let (Some(cut), Some(whole)) = answers
                && ends_with_line
            {
                // What P has to say may be cut off, and T be left.
                let is_same = (cut - whole).abs() < 0.01 * whole;
                assert!(is_same, "{}: {length} bytes: {cut} instead of {whole}", case["files"]);
            }
        }
    }
}
