//! The service worker, which keeps the site on the visitor's computer, and the name of the build that it keeps.

use base64::Engine as _;
use base64::prelude::BASE64_STANDARD;
use sha2::{Digest as _, Sha256};
use std::fs;
use std::hash::{DefaultHasher, Hash as _, Hasher as _};
use std::path::Path;

use super::folder::{HEADERS, LICENSES_PAGE, PROGRAM_PAGE, WORKER, names};
use super::html::replace_once;
use crate::second_module;

/// What a visitor's browser does not ask for, unless the visitor does. The service worker keeps everything else.
const NOT_FOR_VISITORS: &[&str] = &[
    WORKER,
    HEADERS,
    LICENSES_PAGE,
    "icons/screenshot.png",
    "icons/screenshot-phone.png",
    "og.png",
    "robots.txt",
    "sitemap.xml",
];

/// A hash of every byte of the site.
pub(super) fn build_id(dist: &Path, worker: &str) -> Result<String, String> {
    let mut hasher = DefaultHasher::new();
    worker.hash(&mut hasher);
    for name in names(dist)?.iter().filter(|name| ![WORKER, HEADERS].contains(&name.as_str())) {
        name.hash(&mut hasher);
        fs::read(dist.join(name))
            .map_err(|error| format!("dist/{name} cannot be read: {error}."))?
            .hash(&mut hasher);
    }
    Ok(format!("{:016x}", hasher.finish()))
}

/// The service worker: `template` with the name of the build, and with the files to keep, at once or when they are first
/// used, and their digests.
pub(super) fn service_worker(dist: &Path, template: &str, build: &str) -> Result<String, String> {
    let (mut files, mut later) = (Vec::new(), Vec::new());
    for name in names(dist)?.iter().filter(|name| !NOT_FOR_VISITORS.contains(&name.as_str())) {
        // Some hosts redirect from the long name, and all of them show it under the short one.
        let address = if name == PROGRAM_PAGE { "./" } else { name };
        let list = if second_module::is_of_it(Path::new(name)) {
            &mut later
        } else {
            &mut files
        };
        list.push((address.to_owned(), integrity(&dist.join(name))?));
    }
    let worker = replace_once(template, "const BUILD = '';", &format!("const BUILD = '{build}';"))?;
    let list = |name: &str, files: &[(String, String)]| format!("const {name} = {};", serde_json::json!(files));
    let worker = replace_once(&worker, "const FILES = [];", &list("FILES", &files))?;
    replace_once(&worker, "const LATER = [];", &list("LATER", &later))
}

/// The digest of a file as an `integrity` attribute has it. Source: W3C, Subresource Integrity, 3.1.
pub(super) fn integrity(file: &Path) -> Result<String, String> {
    let content = fs::read(file).map_err(|error| format!("{} cannot be read: {error}.", file.display()))?;
    Ok(format!("sha256-{}", BASE64_STANDARD.encode(Sha256::digest(content))))
}
