//! What tests there are.

use std::fs;
use std::path::Path;

use super::part::Part;
use crate::step::{command, output, root};
use crate::{browsers, prerequisites};

/// A test of the page: the file it is in, and its name.
pub(super) type BrowserTest = (String, String);

/// The tests in tests/browser, as Node.js lists them.
pub(super) fn browser_tests() -> Result<Vec<BrowserTest>, String> {
    prerequisites::node()?;
    browsers::install_packages("Install the packages of the browser tests", &root().join("tests/browser"))?;
    let printed = output(command("node", &["tests/browser/list.mjs"]).args(browsers::test_files()?))
        .ok_or("The browser tests could not be listed: `node tests/browser/list.mjs` failed.")?;
    let tests = printed.lines().filter_map(|line| line.split_once('\t'));
    Ok(tests.map(|(file, name)| (file.to_owned(), name.to_owned())).collect())
}

/// The names of the files of Rust tests, which cargo calls targets: of the program and of the crates below it.
pub(super) fn rust_targets() -> Vec<String> {
    let crates = fs::read_dir(root().join("crates")).into_iter().flatten().flatten();
    let packages = std::iter::once(root()).chain(crates.map(|entry| entry.path()));
    let files = packages.flat_map(|package| fs::read_dir(package.join("tests")).into_iter().flatten().flatten());
    let mut names: Vec<String> = files.filter_map(|entry| target_name(&entry.path())).collect();
    names.sort();
    names.dedup();
    names
}

/// `golden` of tests/golden.rs, and of tests/golden/ with a main.rs in it.
fn target_name(path: &Path) -> Option<String> {
    let name = path.file_name()?.to_str()?;
    let name = if path.join("main.rs").is_file() {
        Some(name)
    } else {
        name.strip_suffix(".rs")
    };
    name.map(str::to_owned)
}

pub(super) fn print(tests: &[BrowserTest]) {
    println!("\nParts");
    for part in Part::ALL {
        println!("  {:<9} {}", part.name(), part.description());
    }
    println!("\nFiles of Rust tests (all tests in them: cargo test -- --list)");
    println!("  {}", rust_targets().join(", "));
    println!("\nTests in browsers");
    let mut last = "";
    for (file, name) in tests {
        if file != last {
            println!("  {file}");
            last = file;
        }
        println!("    {name}");
    }
}
