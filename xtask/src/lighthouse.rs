//! `cargo xtask lighthouse`: what Lighthouse says about the page, as a desktop computer and as a phone get it.

use crate::browsers::{self, Engine, Places};
use crate::dist;
use crate::prerequisites::{self, Needs};
use crate::step::{command, root, run, step};
use crate::table::Outcome;

/// Builds the page and audits it `runs` times for each device. Err: a sentence, where a score is below that in
/// tests/lighthouse/floors.json on a machine as fast as the one that they were made for.
pub(crate) fn audit(runs: u32, places: &Places) -> Result<(), String> {
    prerequisites::check(Needs {
        node: true,
        build_bytes: dist::BUILD_BYTES,
    })?;
    let chromium = browsers::find_or_install(Engine::Chromium, places, false).map_err(Outcome::reason)?;
    let dist = dist::build()?;
    let folder = root().join("tests/lighthouse");
    browsers::install_packages("Install Lighthouse", &folder)?;
    step(
        &format!("Audit the page {runs} times for each device (a minute for two audits on two cores)"),
        || {
            let settings = serde_json::json!({ "dist": dist, "browser": chromium.browser, "runs": runs });
            run(command("node", &["tests/lighthouse/run.mjs"]).env("LIGHTHOUSE", settings.to_string()))
        },
    )
}
