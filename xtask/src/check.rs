//! `cargo xtask check`: what a change must satisfy besides the tests.

use crate::step::{cargo, run, step};
use crate::tools;

/// Formatting, lints on both platforms, and the mathematics without the user interface.
pub(crate) fn run_all() -> Result<(), String> {
    tools::add_target()?;
    step("Formatting", || run(&mut cargo(&["fmt", "--all", "--check"])))?;
    step("The mathematics and the formats without the user interface", || {
        run(&mut cargo(&[
            "check",
            "--locked",
            "--package",
            "depth-calculator",
            "--no-default-features",
            "--lib",
        ]))
    })?;
    step("Lints, desktop", || {
        run(&mut cargo(&[
            "clippy",
            "--locked",
            "--workspace",
            "--all-targets",
            "--",
            "--deny",
            "warnings",
        ]))
    })?;
    step("Lints, web page", || {
        let target = ["--target", "wasm32-unknown-unknown"];
        run(cargo(&["clippy", "--locked", "--package", "depth-calculator", "--lib", "--bins"])
            .args(target)
            .args(["--", "--deny", "warnings"]))
    })
}
