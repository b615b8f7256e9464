//! `cargo xtask lighthouse`: what Lighthouse says about the page, as a desktop computer and as a phone get it.

use std::path::Path;

use crate::dist;
use crate::step::{command, root, run, step};

/// Builds the page and audits it. Err: a sentence, where a score is below that in tests/lighthouse/floors.json.
pub(crate) fn audit() -> Result<(), String> {
    let dist = dist::build()?;
    let folder = root().join("tests/lighthouse");
    install_packages(&folder)?;
    step("Audit the page five times for each device (4 minutes on two cores)", || {
        // It finds an installed Chrome or Chromium by itself, unless CHROMIUM names one.
        let mut node = command("node", &["tests/lighthouse/run.mjs"]);
        run(node.env("DIST", dist))
    })
}

/// Installs what the audit needs, unless it is there already.
fn install_packages(folder: &Path) -> Result<(), String> {
    let changed = |file: &str| std::fs::metadata(folder.join(file)).and_then(|file| file.modified()).ok();
    if changed("node_modules/.package-lock.json") >= changed("package-lock.json") {
        return Ok(());
    }
    step("Install Lighthouse", || {
        let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
        run(command(npm, &["ci", "--no-audit", "--no-fund"]).current_dir(folder))
    })
}
