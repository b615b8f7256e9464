//! Runs tests/browser in one browser, and reads how it went.

use std::path::Path;

use super::engine::{Engine, Programs};
use crate::step::{command, root, run, target};
use crate::table::Outcome;

/// What to run in a browser, and on which page.
pub(crate) struct Tests<'a> {
    pub(crate) dist: &'a Path,
    /// Files in tests/browser.
    pub(crate) files: &'a [String],
    /// Only tests with these names, if there are any.
    pub(crate) names: &'a [String],
    /// Of the random walk.
    pub(crate) seed: u64,
    pub(crate) batches: u32,
}

impl Tests<'_> {
    /// Runs them in `engine`.
    pub(crate) fn run(&self, engine: Engine, programs: &Programs) -> Outcome {
        let counts = target().join(format!("tests-{}.json", engine.name()));
        let _ = std::fs::remove_file(&counts);
        let settings = serde_json::json!({
            "engine": engine.name(),
            "dist": self.dist,
            "browser": programs.browser,
            "driver": programs.driver,
            "screenshots": target().join("screenshots"),
            "seed": self.seed,
            "batches": self.batches,
            "names": self.names,
        });
        let mut node = command(
            "node",
            &[
                "--test",
                // Two at a time take longer: drawing without a graphics card keeps all cores busy by itself.
                "--test-concurrency=1",
                // For one that hangs: in a slow hour the longest takes minutes.
                "--test-timeout=1200000",
                "--test-reporter=spec",
                "--test-reporter-destination=stdout",
            ],
        );
        node.arg("--test-reporter=./tests/browser/counts.mjs");
        node.arg(format!("--test-reporter-destination={}", counts.display()));
        let ended = run(node.args(self.files).env("BROWSER_TESTS", settings.to_string()));
        let counted = read_counts(&counts);
        match (ended, counted) {
            // Of the tests that were named, some are only for other engines.
            (Ok(()), Some(counts)) if counts.passed == 0 && !self.names.is_empty() => Outcome::LeftOut(counts.text()),
            (Ok(()), Some(counts)) if counts.passed == 0 => Outcome::Failed(format!("No test ran. {}", counts.text())),
            (Ok(()), Some(counts)) => Outcome::Passed(counts.text()),
            (Ok(()), None) => Outcome::Failed("The tests did not say how many they were.".to_owned()),
            (Err(reason), counts) => Outcome::Failed(counts.map_or(reason, |counts| counts.text())),
        }
    }
}

/// What tests/browser/counts.mjs writes.
struct Counts {
    passed: u64,
    failed: Vec<String>,
    /// Names of tests that were left out, and why.
    left_out: Vec<(String, String)>,
}

impl Counts {
    fn text(&self) -> String {
        let head = format!(
            "{} passed, {} failed, {} left out",
            self.passed,
            self.failed.len(),
            self.left_out.len()
        );
        let failed = self.failed.iter().map(|name| format!("FAILED: {name}"));
        let left_out = self.left_out.iter().map(|(name, why)| format!("left out: {name} ({why})"));
        std::iter::once(head).chain(failed).chain(left_out).collect::<Vec<_>>().join("\n")
    }
}

fn read_counts(file: &Path) -> Option<Counts> {
    let value: serde_json::Value = serde_json::from_str(&std::fs::read_to_string(file).ok()?).ok()?;
    let text = |value: &serde_json::Value| value.as_str().unwrap_or_default().to_owned();
    Some(Counts {
        passed: value.get("passed")?.as_u64()?,
        failed: value.get("failed")?.as_array()?.iter().map(text).collect(),
        left_out: value
            .get("leftOut")?
            .as_array()?
            .iter()
            .filter_map(|one| Some((text(one.get("name")?), text(one.get("why")?))))
            .collect(),
    })
}

/// The files of tests, as paths from the workspace's folder, in order.
pub(crate) fn test_files() -> Result<Vec<String>, String> {
    let folder = "tests/browser";
    let entries = std::fs::read_dir(root().join(folder)).map_err(|error| format!("{folder} cannot be read: {error}."))?;
    let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    let mut files: Vec<String> = names
        .filter(|name| name.ends_with(".test.mjs"))
        .map(|name| format!("{folder}/{name}"))
        .collect();
    if files.is_empty() {
        return Err(format!("{folder} holds no tests."));
    }
    files.sort();
    Ok(files)
}
