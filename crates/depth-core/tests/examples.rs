//! Every public function has an example in its documentation, and documentation examples are compiled and run.
#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

use std::fs;
use std::path::{Path, PathBuf};

/// The Rust files under `folder`.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut files = Vec::new();
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else {
            files.push(path);
        }
    }
    files.sort();
    files
}

/// The names of the public functions in `source` and whether each has an example.
fn functions(source: &str) -> Vec<(&str, bool)> {
    let lines: Vec<&str> = source.lines().map(str::trim).collect();
    let mut found = Vec::new();
    for (number, line) in lines.iter().enumerate() {
        let Some((_, rest)) = line
            .split_once("pub fn ")
            .or_else(|| line.split_once("pub const fn "))
            .filter(|(before, _)| before.is_empty())
        else {
            continue;
        };
        let above = lines[..number].iter().rev();
        let documentation = above.take_while(|line| line.starts_with("///") || line.starts_with("#["));
        let has_example = documentation.filter(|line| line.starts_with("/// ```")).count() >= 2;
        found.push((&rest[..rest.find(['(', '<']).unwrap()], has_example));
    }
    found
}

#[test]
fn every_public_function_has_an_example() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut lacking = Vec::new();
    let mut count = 0;
    for path in sources(&folder) {
        let source = fs::read_to_string(&path).unwrap();
        for (name, has_example) in functions(&source) {
            count += 1;
            if !has_example {
                lacking.push(format!("{}: {name}", path.strip_prefix(&folder).unwrap().display()));
            }
        }
    }
    assert!(count > 90, "only {count} functions found: are they looked for in the right way?");
    assert!(lacking.is_empty(), "without an example:\n{}", lacking.join("\n"));
}

#[test]
fn a_function_without_an_example_is_found() {
    let source = "/// A.\n///\n/// ```\n/// b();\n/// ```\n#[must_use]\npub const fn a(x: f64) {}\n\n    /// C.\n    pub fn c<T>() {}\n";
    assert_eq!(functions(source), [("a", true), ("c", false)]);
}
