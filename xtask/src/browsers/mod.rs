//! Real browsers for the tests: which there are, how what is missing is installed, and how tests/browser runs in one.

mod find;

use clap::Args;
use std::path::{Path, PathBuf};

use crate::step::{command, on_path, root, run, step, target};
use crate::table::Outcome;
use crate::{apt, tools};
pub(crate) use find::find;

/// The engines that the page is tested in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Engine {
    Chromium,
    Firefox,
    WebKit,
}

impl Engine {
    /// What the command line and tests/browser/engines call it.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Chromium => "chromium",
            Self::Firefox => "firefox",
            Self::WebKit => "webkit",
        }
    }

    /// What Debian and Ubuntu call what it needs.
    fn packages(self) -> &'static [&'static str] {
        match self {
            // Ubuntu's are snaps, which the drivers of these tests do not start.
            Self::Chromium | Self::Firefox if apt::is_ubuntu() => &[],
            Self::Chromium => &["chromium", "chromium-driver"],
            Self::Firefox => &["firefox-esr", "xvfb"],
            Self::WebKit => &["webkit2gtk-driver", "xvfb"],
        }
    }

    /// What somebody can do who lacks it.
    fn advice(self) -> String {
        let debian = match self.packages() {
            [] => String::new(),
            packages => format!("on Debian `apt-get install {}`; ", packages.join(" ")),
        };
        match self {
            Self::Chromium => format!(
                "{debian}elsewhere Google Chrome or Chromium and the chromedriver of the same version on PATH, or --chromium and --chromedriver"
            ),
            Self::Firefox => format!("{debian}elsewhere Firefox on PATH or --firefox; geckodriver is built by this command"),
            Self::WebKit => format!("{debian}it exists on Linux only: Safari is not driven by these tests"),
        }
    }
}

/// Where the browsers are, for those that are not found by themselves.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Where browsers and drivers are, unless they are on PATH or in their usual places")]
pub(crate) struct Places {
    /// Chromium or Google Chrome
    #[arg(long, value_name = "PROGRAM", env = "CHROMIUM", hide_env_values = true)]
    pub(crate) chromium: Option<PathBuf>,
    /// chromedriver, of the same major version [also in the folder CHROMEWEBDRIVER]
    #[arg(long, value_name = "PROGRAM", env = "CHROMEDRIVER", hide_env_values = true)]
    pub(crate) chromedriver: Option<PathBuf>,
    /// Firefox
    #[arg(long, value_name = "PROGRAM", env = "FIREFOX", hide_env_values = true)]
    pub(crate) firefox: Option<PathBuf>,
    /// geckodriver [also in the folder GECKOWEBDRIVER]
    #[arg(long, value_name = "PROGRAM", env = "GECKODRIVER", hide_env_values = true)]
    pub(crate) geckodriver: Option<PathBuf>,
    /// MiniBrowser of WebKitGTK
    #[arg(long, value_name = "PROGRAM", env = "MINIBROWSER", hide_env_values = true)]
    pub(crate) minibrowser: Option<PathBuf>,
    /// WebKitWebDriver
    #[arg(long, value_name = "PROGRAM", env = "WEBKITDRIVER", hide_env_values = true)]
    pub(crate) webkitdriver: Option<PathBuf>,
}

/// A browser and the driver that fits it.
#[derive(Debug)]
pub(crate) struct Programs {
    pub(crate) browser: PathBuf,
    pub(crate) driver: PathBuf,
    /// Name and version, for people.
    pub(crate) version: String,
}

/// Whether [`find_or_install`] would install something here.
pub(crate) fn can_install(engine: Engine, asked: bool) -> bool {
    !engine.packages().is_empty() && apt::may_install(asked)
}

/// The browser and its driver, installed if need be and allowed. Err: how the part ends without them: left out where something
/// is missing that is not installed here, failed where it could not be installed.
pub(crate) fn find_or_install(engine: Engine, places: &Places, asked: bool) -> Result<Programs, Outcome> {
    let mut found = find(engine, places);
    if found.as_ref().is_err_and(|missing| !missing.needs_geckodriver) && can_install(engine, asked) {
        let what = format!("Install {} (about a minute)", engine.name());
        step(&what, || apt::install(engine.packages())).map_err(Outcome::Failed)?;
        found = find(engine, places);
    }
    // A driver that is only missing can be built wherever its browser is.
    if found.as_ref().is_err_and(|missing| missing.needs_geckodriver) {
        tools::geckodriver().map_err(Outcome::Failed)?;
        found = find(engine, places);
    }
    found.map_err(|missing| Outcome::LeftOut(format!("{}. What is needed: {}.", missing.why, engine.advice())))
}

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

/// Installs the npm packages that `folder` asks for, unless they are there already.
pub(crate) fn install_packages(what: &str, folder: &Path) -> Result<(), String> {
    let changed = |file: &str| std::fs::metadata(folder.join(file)).and_then(|file| file.modified()).ok();
    if changed("node_modules/.package-lock.json") >= changed("package-lock.json") {
        return Ok(());
    }
    step(what, || {
        let npm = on_path("npm").ok_or("npm, which comes with Node.js, is not on PATH.")?;
        run(command(npm, &["ci", "--no-audit", "--no-fund"]).current_dir(folder))
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
