//! `cargo xtask idle`: what the page costs a computer on which nobody does anything.

use crate::browsers::{self, Engine, Places};
use crate::dist;
use crate::prerequisites::{self, Needs};
use crate::step::{command, root, run, step};
use crate::table::Outcome;

/// Builds the page and measures processor time for `seconds` on each of four pages. Err: a sentence, where that of the program is more
/// than it should be.
pub(crate) fn measure(seconds: u32, places: &Places) -> Result<(), String> {
    prerequisites::check(Needs {
        node: true,
        build_bytes: dist::BUILD_BYTES,
    })?;
    let chromium = browsers::find_or_install(Engine::Chromium, places, false).map_err(Outcome::reason)?;
    let dist = dist::build()?;
    browsers::install_packages("Install the packages of the browser tests", &root().join("tests/browser"))?;
    step(&format!("Measure four pages for {seconds} s each"), || {
        let settings = serde_json::json!({
            "engine": Engine::Chromium.name(),
            "dist": dist,
            "browser": chromium.browser,
            "driver": chromium.driver,
            "names": [],
        });
        let mut node = command("node", &["tests/browser/idle.mjs"]);
        run(node
            .env("BROWSER_TESTS", settings.to_string())
            .env("IDLE_SECONDS", seconds.to_string()))
    })
}
