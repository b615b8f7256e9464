//! The scripts of the page, without their comments: those are for who reads the source, and a third of what a visitor would download.

use base64::prelude::{BASE64_STANDARD, Engine as _};
use sha2::{Digest as _, Sha384};
use std::fs;
use std::path::Path;

/// Our own scripts in dist/, by the beginnings of their names.
const SCRIPTS: [&str; 4] = ["start-", "rest-", "register-", "old-browser-"];

/// How the name of the script around the program begins.
const PROGRAM: &str = "depth-calculator-";

/// Takes the comments out of the scripts in `dist`, and tells its page their digests. That of the program is known to its preload only: a
/// browser that knew it of the WebAssembly could not compile what arrives before it has all of it.
pub(crate) fn strip_comments(dist: &Path) -> Result<(), String> {
    let page = dist.join("index.html");
    let mut html = fs::read_to_string(&page).map_err(|error| format!("dist/index.html cannot be read: {error}."))?;
    let entries = fs::read_dir(dist).map_err(|error| format!("dist/ cannot be read: {error}."))?;
    for path in entries.filter_map(|entry| Some(entry.ok()?.path())) {
        let name = path.file_name().and_then(|name| name.to_str()).unwrap_or_default();
        if name.ends_with(".js") && name.starts_with(PROGRAM) {
            let script = fs::read_to_string(&path).map_err(|error| format!("dist/{name} cannot be read: {error}."))?;
            let place = format!("<link rel=\"modulepreload\" href=\"./{name}\"");
            if html.matches(&place).count() != 1 {
                return Err(format!("dist/index.html should preload {name} once; it does not."));
            }
            html = html.replace(&place, &format!("{place} integrity=\"{}\"", integrity(&script)));
        }
        if !(name.ends_with(".js") && SCRIPTS.iter().any(|script| name.starts_with(script))) {
            continue;
        }
        let text = fs::read_to_string(&path).map_err(|error| format!("dist/{name} cannot be read: {error}."))?;
        let (before, short) = (integrity(&text), without_comments(&text));
        fs::write(&path, &short).map_err(|error| format!("dist/{name} cannot be written: {error}."))?;
        if !html.contains(&before) {
            return Err(format!("dist/index.html does not say the digest of {name}, which is {before}."));
        }
        html = html.replace(&before, &integrity(&short));
    }
    fs::write(&page, html).map_err(|error| format!("dist/index.html cannot be written: {error}."))
}

/// The digest of a script as Trunk writes it into the page.
fn integrity(script: &str) -> String {
    format!("sha384-{}", BASE64_STANDARD.encode(Sha384::digest(script)))
}

/// `script` without the comments that have lines of their own, blank lines and indentation. No text in our scripts has several lines.
pub(crate) fn without_comments(script: &str) -> String {
    let mut is_inside = false;
    let mut kept = String::with_capacity(script.len());
    for line in script.lines().map(str::trim) {
        let begins = line.starts_with("/*");
        let is_comment = is_inside || begins || line.starts_with("//") || line.is_empty();
        is_inside = (is_inside || begins) && !line.ends_with("*/");
        if !is_comment {
            kept.push_str(line);
            kept.push('\n');
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::without_comments;

    #[test]
    fn what_is_no_comment_stays() {
        let script =
            "// What it is.\n\n/** One. */\nconst a = 'https://example.org'; // Why.\n/**\n * Two\n * lines.\n */\nif (a) {\n  b(a);\n}\n";
        assert_eq!(
            without_comments(script),
            "const a = 'https://example.org'; // Why.\nif (a) {\nb(a);\n}\n"
        );
    }
}
