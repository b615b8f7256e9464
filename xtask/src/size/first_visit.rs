//! Which files of the site a first visit needs before the calculator can be used.

use std::fs;
use std::path::Path;

/// Whether a file is a WebAssembly module.
pub(super) fn is_program(file: &str) -> bool {
    Path::new(file).extension().is_some_and(|extension| extension == "wasm")
}

/// The page in `dist` and every file of ours that it names as needed at once: scripts, styles and the program. (An icon is not:
/// browsers ask for one later, some for none. Nor is what only old browsers run.)
pub(super) fn files(dist: &Path) -> Result<Vec<String>, String> {
    const PAGE: &str = "index.html";
    let html = fs::read_to_string(dist.join(PAGE)).map_err(|error| format!("dist/{PAGE} cannot be read: {error}."))?;
    let named = needed(&html).filter(|file| dist.join(file).is_file()).map(str::to_owned);
    let files: Vec<String> = std::iter::once(PAGE.to_owned()).chain(named).collect();
    if files.iter().filter(|file| is_program(file)).count() != 1 {
        return Err(format!(
            "dist/{PAGE} should name one WebAssembly file; it names {}.",
            files.join(", ")
        ));
    }
    Ok(files)
}

/// The addresses in `html` that a current browser fetches before the program can start.
fn needed(html: &str) -> impl Iterator<Item = &str> {
    let tags = html.split('<').filter_map(|rest| rest.split('>').next());
    tags.filter_map(|tag| {
        let script = tag.starts_with("script") && !tag.contains(" nomodule");
        let link = tag.starts_with("link")
            && ["stylesheet", "modulepreload", "preload"]
                .iter()
                .any(|&rel| value(tag, "rel") == Some(rel));
        if script {
            value(tag, "src")
        } else if link {
            value(tag, "href")
        } else {
            None
        }
    })
    .map(|address| address.trim_start_matches("./"))
}

/// The value of an attribute in a tag.
fn value<'a>(tag: &'a str, attribute: &str) -> Option<&'a str> {
    tag.split_once(&format!(" {attribute}=\""))?.1.split('"').next()
}

#[cfg(test)]
mod tests {
    use super::needed;

    #[test]
    fn the_first_visit_needs_scripts_styles_and_the_program_only() {
        let page = r#"<link rel="icon" href="icons/favicon.svg"><link rel="manifest" href="manifest.webmanifest">
            <link rel="stylesheet" href="./page-1.css"/> <script src="./start-1.js" type="module"></script>
            <script src="./old-1.js" nomodule></script><script type="application/ld+json">{}</script>
            <link rel="modulepreload" href="./a.js" crossorigin="anonymous"><link rel="preload" href="./a.wasm" as="fetch">
            <a href="learn.html">Learn</a>"#;
        let files: Vec<&str> = needed(page).collect();
        assert_eq!(files, ["page-1.css", "start-1.js", "a.js", "a.wasm"]);
    }
}
