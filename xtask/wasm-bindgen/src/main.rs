//! `wasm-bindgen` as Trunk calls it, over the library that the original command is made of.
//!
//! The original brings a test runner, an HTTP client and their dependencies, and its own lock file no longer installs. This
//! one is built from the workspace's lock file. Its own version must be that of the library, which Trunk compares.

use anyhow::Result;
use clap::{Parser, ValueEnum};
use std::path::PathBuf;
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
    match options.target {
        Target::Web => bindgen.web(true)?,
        Target::NoModules => bindgen.no_modules(true)?,
    };
    bindgen
        .input_path(options.input)
        .out_name(&options.out_name)
        .typescript(!options.no_typescript)
        .keep_debug(options.keep_debug)
        .demangle(!options.no_demangle)
        .generate(options.out_dir)
}
