//! `wasm-bindgen` as Trunk calls it, over the library that the original command is made of, and then what makes the page's download
//! smaller without another tool.
//!
//! The original brings a test runner, an HTTP client and their dependencies, and its own lock file no longer installs. This
//! one is built from the workspace's lock file. Its own version must be that of the library, which Trunk compares.

mod names;
mod order;
mod reach;
mod unused;

use anyhow::{Context as _, Result};
use clap::{Parser, ValueEnum};
use std::fs;
use std::path::{Path, PathBuf};
use wasm_bindgen_cli_support::Bindgen;

#[derive(Clone, Copy, ValueEnum)]
enum Target {
    Web,
    NoModules,
}

/// The options that Trunk uses. Any other is refused, rather than ignored.
#[derive(Parser)]
#[command(name = "wasm-bindgen", version)]
struct Options {
    input: PathBuf,
    #[arg(long)]
    target: Target,
    #[arg(long)]
    out_dir: PathBuf,
    #[arg(long)]
    out_name: String,
    #[arg(long)]
    no_typescript: bool,
    #[arg(long)]
    keep_debug: bool,
    #[arg(long)]
    no_demangle: bool,
}

fn main() -> Result<()> {
    let options = Options::parse();
    let mut bindgen = Bindgen::new();
    // The page draws; what a Worker runs does not, and has no functions of those lists.
    let draws = matches!(options.target, Target::Web);
    match options.target {
        Target::Web => bindgen.web(true)?,
        Target::NoModules => bindgen.no_modules(true)?,
    };
    let input = if options.keep_debug {
        options.input.clone()
    } else {
        // Beside the module, of which it is a part: it is read once.
        let input = options.input.with_extension("used.wasm");
        let module = fs::read(&options.input).context("the module cannot be read")?;
        fs::write(&input, unused::without_unused(&module, draws)?)?;
        input
    };
    bindgen
        .input_path(&input)
        .out_name(&options.out_name)
        .typescript(!options.no_typescript)
        .keep_debug(options.keep_debug)
        .demangle(!options.no_demangle)
        .generate(&options.out_dir)?;
    if options.keep_debug {
        return Ok(());
    }
    shrink(&options.out_dir, &options.out_name)
}

/// Makes the module and the script in `folder` smaller, and writes the names of the functions beside them, a line each in their order,
/// for whoever wants to know what the module consists of.
fn shrink(folder: &Path, name: &str) -> Result<()> {
    let place = |end: &str| folder.join(format!("{name}{end}"));
    let module = fs::read(place("_bg.wasm")).context("the module cannot be read")?;
    let script = fs::read_to_string(place(".js")).context("the script cannot be read")?;
    let short = names::short(&module, &script)?;
    let ordered = order::ordered(&module, &short)?;
    fs::write(place("_bg.wasm"), ordered.module)?;
    fs::write(place(".js"), names::shortened(&script, &short))?;
    fs::write(place("_bg.names"), ordered.names.join("\n"))?;
    Ok(())
}
