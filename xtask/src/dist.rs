//! `cargo xtask dist`: the page in dist/, for any static host.

use std::fs;
use std::path::{Path, PathBuf};

use crate::files::collect_files;
use crate::origin::{cargo_home, nameless};
use crate::prerequisites::{self, Needs};
use crate::step::{command, root, run, step};
use crate::{compress, scripts, second_module, site, tools};

/// Bytes on the disk, as measured with `du`.
pub(crate) const BUILD_BYTES: u64 = 2_000_000_000;

/// Builds the page and prints the size of every file.
pub(crate) fn print() -> Result<(), String> {
    let dist = checked_build(false)?;
    let mut files = Vec::new();
    collect_files(&dist, &mut files).map_err(|error| format!("dist/ cannot be read: {error}."))?;
    files.sort();

    // Empty without Node.js, which knows how to compress.
    let compressed: Vec<u64> = compress::sizes(&files)
        .unwrap_or_default()
        .iter()
        .map(|[_, _, brotli]| *brotli)
        .collect();
    println!("\n{:>12} {:>12}  file", "bytes", "with brotli");
    let (mut all, mut all_compressed) = (0, 0);
    for (at, file) in files.iter().enumerate() {
        let size = fs::metadata(file)
            .map_err(|error| format!("{} cannot be read: {error}.", file.display()))?
            .len();
        let small = compressed.get(at);
        all += size;
        all_compressed += small.unwrap_or(&0);
        println!(
            "{size:>12} {:>12}  {}",
            cell(small),
            file.strip_prefix(&dist).unwrap_or(file).display()
        );
    }
    println!("{all:>12} {:>12}  together", cell(compressed.first().map(|_first| &all_compressed)));
    if compressed.is_empty() {
        println!("Compressed sizes need Node.js on PATH.");
    }
    println!("\nCopy the folder dist/ to any static host, under any path.");
    Ok(())
}

fn cell(size: Option<&u64>) -> String {
    size.map_or_else(|| "-".to_owned(), u64::to_string)
}

/// Builds the page as [`build`] does, after a look at what that needs, and Node.js where it is used afterwards.
pub(crate) fn checked_build(node: bool) -> Result<PathBuf, String> {
    prerequisites::check(Needs {
        node,
        build_bytes: BUILD_BYTES,
    })?;
    build()
}

/// Builds the page into dist/, whose path it returns.
pub(crate) fn build() -> Result<PathBuf, String> {
    let (trunk, path) = tools::for_page()?;
    tools::fetch_crates()?;
    step("Build the page (2 to 4 minutes on two cores the first time)", || {
        let mut trunk = command(trunk, &["build", "--release", "--offline", "--skip-version-check"]);
        if let Some(flags) = nameless(&[(cargo_home(), "cargo")]) {
            // With the types in the names of generic functions, by which the unused ones among them are found, and with what refers to
            // what, by which goes what only these use.
            let flags = format!("{flags} -Csymbol-mangling-version=v0 -Clink-arg=--emit-relocs");
            trunk.env("CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS", flags);
        }
        // Trunk takes NO_COLOR=1, which is how others understand it, for a mistake.
        run(trunk.env("PATH", &path).env_remove("NO_COLOR"))?;
        let dist = root().join("dist");
        second_module::name(&dist)?;
        write_program_size(&dist)?;
        scripts::strip_comments(&dist)?;
        site::build(&dist)?;
        Ok(dist)
    })
}

/// Tells the page how large its program is: a host that compresses does not say so, and the bar needs an end.
fn write_program_size(dist: &Path) -> Result<(), String> {
    const PLACE: &str = "type=\"application/wasm\"";
    let page = dist.join("index.html");
    let html = fs::read_to_string(&page).map_err(|error| format!("dist/index.html cannot be read: {error}."))?;
    let program = fs::read_dir(dist)
        .map_err(|error| format!("dist/ cannot be read: {error}."))?
        .filter_map(|entry| Some(entry.ok()?.path()))
        .find(|path| path.extension().is_some_and(|extension| extension == "wasm") && !second_module::is_of_it(path))
        .ok_or("The build left no WebAssembly file in dist/.")?;
    let size = fs::metadata(&program)
        .map_err(|error| format!("{} cannot be read: {error}.", program.display()))?
        .len();
    if html.matches(PLACE).count() != 1 {
        return Err(format!("dist/index.html should preload one program, with {PLACE}; it does not."));
    }
    fs::write(&page, html.replace(PLACE, &format!("{PLACE} data-bytes=\"{size}\"")))
        .map_err(|error| format!("dist/index.html cannot be written: {error}."))
}
