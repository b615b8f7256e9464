//! `cargo xtask lighthouse`: what Lighthouse says about the page, as a desktop computer and as a phone get it.

use crate::step::{command, root, run, step};
use crate::{browsers, dist};

/// Builds the page and audits it. Err: a sentence, where a score is below that in tests/lighthouse/floors.json.
pub(crate) fn audit() -> Result<(), String> {
    let dist = dist::build()?;
    let folder = root().join("tests/lighthouse");
    browsers::install_packages("Install Lighthouse", &folder)?;
    step("Audit the page five times for each device (4 minutes on two cores)", || {
        // It finds an installed Chrome or Chromium by itself, unless CHROMIUM names one.
        let mut node = command("node", &["tests/lighthouse/run.mjs"]);
        run(node.env("DIST", dist))
    })
}
