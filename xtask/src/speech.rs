//! `cargo xtask speech`: what Orca, the screen reader of Linux desktops, says of the page in Firefox and Chromium.

use std::path::Path;

use crate::browsers::{self, Engine, Places};
use crate::prerequisites::{self, Needs};
use crate::step::{command, on_path, root, run, step};
use crate::table::Outcome;
use crate::{apt, dist};

/// What has to be there besides a browser, and the packages of Debian and Ubuntu that bring it.
const PROGRAMS: [(&str, &str); 6] = [
    ("orca", "orca"),
    ("dbus-run-session", "dbus-daemon"),
    ("gdbus", "libglib2.0-bin"),
    ("openbox", "openbox"),
    ("Xvfb", "xvfb"),
    ("xdotool", "xdotool"),
];
const ENGINES: [Engine; 2] = [Engine::Firefox, Engine::Chromium];

/// Builds the page and listens to it. Err: a sentence, where something else is said than tests/browser/speech has.
pub(crate) fn listen(update: bool, places: &Places) -> Result<(), String> {
    prerequisites::check(Needs {
        node: true,
        build_bytes: dist::BUILD_BYTES,
    })?;
    install()?;
    let dist = dist::build()?;
    browsers::install_packages("Install the packages of the browser tests", &root().join("tests/browser"))?;
    let outcomes: Vec<Result<(), String>> = ENGINES.into_iter().map(|engine| listen_in(engine, &dist, update, places)).collect();
    outcomes.into_iter().collect()
}

fn listen_in(engine: Engine, dist: &Path, update: bool, places: &Places) -> Result<(), String> {
    let programs = browsers::find_or_install(engine, places, false).map_err(Outcome::reason)?;
    step(&format!("What is said in {}", programs.version), || {
        let settings = serde_json::json!({
            "engine": engine.name(),
            "dist": dist,
            "browser": programs.browser,
            "driver": programs.driver,
            "names": [],
            "isHeard": true,
        });
        let mut node = command("dbus-run-session", &["--", "node", "tests/browser/speech/speech.mjs"]);
        if update {
            node.env("SPEECH_UPDATE", "1");
        }
        run(node.env("BROWSER_TESTS", settings.to_string()))
    })
}

/// Installs what is missing, where that may be done. Err: a sentence that names it.
fn install() -> Result<(), String> {
    let missing = || PROGRAMS.iter().filter(|(program, _)| on_path(program).is_none());
    let packages: Vec<&str> = missing().map(|(_, package)| *package).chain(["at-spi2-core"]).collect();
    if missing().next().is_some() && apt::may_install(false) {
        step("Install the screen reader", || apt::install(&packages))?;
    }
    match missing().next() {
        None => Ok(()),
        Some((program, _)) => Err(format!(
            "There is no {program}. What is needed: on Debian and Ubuntu `apt-get install {}`.",
            packages.join(" ")
        )),
    }
}
