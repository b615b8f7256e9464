//! The module that a Worker runs beside the page, in dist/: its name has a hash of its content, like those of the page's own files, and
//! the page knows it.

use sha2::{Digest as _, Sha256};
use std::fs;
use std::path::Path;

use crate::scripts::without_comments;
use crate::step::root;

/// What Trunk calls what it has built.
const SCRIPT: &str = "depth-worker.js";
const MODULE: &str = "depth-worker_bg.wasm";

/// Whether a file of dist/ is of the second module.
pub(crate) fn is_of_it(file: &Path) -> bool {
    let name = file.file_name().and_then(|name| name.to_str()).unwrap_or_default();
    name.starts_with("depth-worker") || name.starts_with("worker-")
}

/// Gives the files of the module in `dist` their names, adds the script that starts it, and tells the page what that is called.
pub(crate) fn name(dist: &Path) -> Result<(), String> {
    let starter = root().join("assets/web/worker.js");
    let text = fs::read_to_string(&starter).map_err(|error| format!("assets/web/worker.js cannot be read: {error}."))?;
    let module = renamed(dist, MODULE)?;
    let script = renamed(dist, SCRIPT)?;
    let text = [("SCRIPT", &script), ("MODULE", &module)]
        .into_iter()
        .try_fold(text, |text, (what, name)| {
            let place = format!("const {what} = '';");
            (text.matches(&place).count() == 1)
                .then(|| text.replace(&place, &format!("const {what} = '{name}';")))
                .ok_or_else(|| format!("assets/web/worker.js should have “{place}” once; it does not."))
        })?;
    let text = without_comments(&text);
    let name = format!("worker-{}.js", hash(text.as_bytes()));
    fs::write(dist.join(&name), text).map_err(|error| format!("dist/{name} cannot be written: {error}."))?;
    let page = dist.join("index.html");
    let html = fs::read_to_string(&page).map_err(|error| format!("dist/index.html cannot be read: {error}."))?;
    let place = "<meta name=\"worker\" content=\"\">";
    if html.matches(place).count() != 1 {
        return Err(format!("dist/index.html should have {place} once; it does not."));
    }
    fs::write(&page, html.replace(place, &format!("<meta name=\"worker\" content=\"{name}\">")))
        .map_err(|error| format!("dist/index.html cannot be written: {error}."))
}

/// The new name of a file, in which a hash of its content stands.
fn renamed(dist: &Path, name: &str) -> Result<String, String> {
    let from = dist.join(name);
    let content = fs::read(&from).map_err(|error| format!("dist/{name} cannot be read: {error}."))?;
    let new = name.replacen("depth-worker", &format!("depth-worker-{}", hash(&content)), 1);
    fs::rename(&from, dist.join(&new)).map_err(|error| format!("dist/{name} cannot be renamed: {error}."))?;
    Ok(new)
}

/// Sixteen digits, as in the names that Trunk gives.
fn hash(content: &[u8]) -> String {
    let digits: String = Sha256::digest(content).iter().map(|byte| format!("{byte:02x}")).collect();
    digits.chars().take(16).collect()
}
