//! Installs what the tests need besides Rust and Node.js, where that may be done.

use std::path::Path;

use super::engine::{Engine, Places, Programs};
use super::find::{Missing, find};
use crate::plan::Plan;
use crate::step::{command, on_path, run, step};
use crate::table::Outcome;
use crate::{apt, tools};

/// What [`find_or_install`] will come to.
pub(crate) fn plan(engine: Engine, places: &Places, asked: bool) -> Plan {
    match find(engine, places) {
        Ok(programs) => Plan::Run(programs.version),
        Err(missing) if missing.needs_geckodriver => Plan::RunAfter(format!("{}; it will be built.", missing.why)),
        Err(missing) if can_install(engine, asked) => Plan::RunAfter(format!("{}; it will be installed.", missing.why)),
        Err(missing) => Plan::LeaveOut(without(engine, &missing)),
    }
}

/// Why there is no browser, and what somebody can do who lacks it.
fn without(engine: Engine, missing: &Missing) -> String {
    format!("{}. What is needed: {}.", missing.why, engine.advice())
}

/// Whether [`find_or_install`] would install something here.
fn can_install(engine: Engine, asked: bool) -> bool {
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
    found.map_err(|missing| Outcome::LeftOut(without(engine, &missing)))
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
