//! `cargo xtask check`, part "architecture": the rules of how the code is laid out, each in a file of its own.

mod circles;
mod crates;
mod imports;
mod lengths;
mod literals;
mod modules;
mod source;
mod trees;

use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::step::{cargo, output, root};

/// Err: everything that breaks a rule, a line each.
pub(crate) fn check() -> Result<(), String> {
    let text = output(&mut cargo(&["metadata", "--format-version", "1", "--no-deps", "--locked"])).ok_or("`cargo metadata` failed.")?;
    let metadata: Value = serde_json::from_str(&text).map_err(|error| format!("`cargo metadata` cannot be parsed: {error}."))?;
    let root = root();
    let mut broken = crates::upward(&metadata);
    broken.extend(trees::unplanned()?);
    broken.extend(literals::broken(&root)?);
    broken.extend(lengths::broken(&root)?);
    for target in targets(&metadata) {
        broken.extend(imports::circles(&target, &root)?);
    }
    if broken.is_empty() {
        Ok(())
    } else {
        Err(format!(
            "The architecture is broken in {} places:\n{}",
            broken.len(),
            broken.join("\n")
        ))
    }
}

/// The root file of everything that is compiled by itself: libraries, programs, tests, benches.
fn targets(metadata: &Value) -> Vec<PathBuf> {
    let packages = metadata.get("packages").and_then(Value::as_array).into_iter().flatten();
    let targets = packages.flat_map(|package| package.get("targets").and_then(Value::as_array).into_iter().flatten());
    let paths = targets.filter_map(|target| target.get("src_path")?.as_str());
    paths.map(|path| Path::new(path).to_path_buf()).collect()
}
