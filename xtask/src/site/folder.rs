//! The files of the site: what they are called, read and written.

use std::fs;
use std::path::Path;

use crate::files::collect_files;

/// The page with the program.
pub(super) const PROGRAM_PAGE: &str = "index.html";
/// The page with the Learn text.
pub(super) const LEARN_PAGE: &str = "learn.html";
/// The page with the licenses of others.
pub(super) const LICENSES_PAGE: &str = "licenses.html";
/// The service worker.
pub(super) const WORKER: &str = "sw.js";
/// Read by some hosts, and served by none of those.
pub(super) const HEADERS: &str = "_headers";

/// Every file in `dist` by its name in an address, in order.
pub(super) fn names(dist: &Path) -> Result<Vec<String>, String> {
    let mut files = Vec::new();
    collect_files(dist, &mut files).map_err(|error| format!("dist/ cannot be read: {error}."))?;
    let mut names: Vec<String> = files
        .iter()
        .filter_map(|file| file.strip_prefix(dist).ok()?.to_str())
        .map(|name| name.replace(std::path::MAIN_SEPARATOR, "/"))
        .collect();
    names.sort();
    Ok(names)
}

/// Whether a hash of its content stands in a file's name.
pub(super) fn is_hashed(name: &str) -> bool {
    name.split(['-', '.', '_'])
        .any(|part| part.len() == 16 && part.chars().all(|c| c.is_ascii_hexdigit()))
}

pub(super) fn read(file: &Path) -> Result<String, String> {
    fs::read_to_string(file).map_err(|error| format!("{} cannot be read: {error}.", file.display()))
}

/// Writes the file `name` of `dist`, and makes the folder that it is in.
pub(super) fn write(dist: &Path, name: &str, content: impl AsRef<[u8]>) -> Result<(), String> {
    let file = dist.join(name);
    file.parent()
        .map_or(Ok(()), fs::create_dir_all)
        .and_then(|()| fs::write(&file, content))
        .map_err(|error| format!("dist/{name} cannot be written: {error}."))
}

#[cfg(test)]
mod tests {
    use super::is_hashed;

    #[test]
    fn files_with_a_hash_in_their_names_are_told_from_the_others() {
        assert!(is_hashed("depth-calculator-ba709360be7a27e3_bg.wasm"));
        assert!(is_hashed("learn-0123456789abcdef.css"));
        for name in ["index.html", "icons/icon-192.png", "sw.js"] {
            assert!(!is_hashed(name), "{name}");
        }
    }
}
