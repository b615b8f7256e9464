//! `cargo xtask check`: what a change must satisfy besides the tests.

use crate::platforms::WEB;
use crate::prerequisites::{self, Needs};
use crate::step::{cargo, command, run, step};
use crate::table::Table;
use crate::tools::{self, CARGO_DENY, TYPOS};
use crate::{architecture, licenses};

/// Bytes on the disk, as measured with `du`.
const BUILD_BYTES: u64 = 3_000_000_000;

/// One thing that is checked.
struct Check {
    name: &'static str,
    work: fn() -> Result<(), String>,
}

const CHECKS: &[Check] = &[
    Check {
        name: "architecture",
        work: architecture::check,
    },
    Check {
        name: "formatting",
        work: || run(&mut cargo(&["fmt", "--all", "--check"])),
    },
    Check {
        name: "the library without features",
        work: || run(cargo(&["check"]).args(PROGRAM).args(["--no-default-features", "--lib"])),
    },
    Check {
        name: "lints, desktop, tests and benches",
        work: || run(cargo(&["clippy", "--locked", "--workspace", "--all-targets"]).args(DENY)),
    },
    Check {
        name: "lints, the command line without the window",
        work: || {
            let cli = ["--no-default-features", "--features", "cli", "--lib", "--bins"];
            run(cargo(&["clippy"]).args(PROGRAM).args(cli).args(DENY))
        },
    },
    Check {
        name: "lints, web page",
        work: || {
            tools::add_target()?;
            let page = ["--lib", "--bins", "--target", WEB];
            run(cargo(&["clippy"]).args(PROGRAM).args(page).args(DENY))
        },
    },
    Check {
        name: "lints, the second module",
        work: || {
            tools::add_target()?;
            let module = ["--locked", "--package", "depth-jobs", "--features", "worker", "--target", WEB];
            run(cargo(&["clippy"]).args(module).args(DENY))
        },
    },
    Check {
        name: "lints, the example of egui-mirror",
        work: || {
            tools::add_target()?;
            let example = ["--locked", "--package", "egui-mirror", "--examples", "--target", WEB];
            run(cargo(&["clippy"]).args(example).args(DENY))
        },
    },
    Check {
        name: "documentation",
        work: || {
            let doc = ["doc", "--locked", "--workspace", "--no-deps", "--document-private-items"];
            run(cargo(&doc).env("RUSTDOCFLAGS", "--deny warnings"))
        },
    },
    Check {
        name: "spelling",
        work: || run(&mut command(TYPOS.find_or_install()?, &[])),
    },
    Check {
        name: "list of licenses",
        work: licenses::check,
    },
    Check {
        name: "licenses, bans and sources of the crates",
        work: || {
            let deny = ["deny", "--locked", "check", "licenses", "bans", "sources"];
            run(&mut command(CARGO_DENY.find_or_install()?, &deny))
        },
    },
    Check {
        name: "the mathematics without features",
        work: || run(&mut cargo(&["check", "--locked", "--package", CORE, "--no-default-features"])),
    },
    Check {
        name: "tests of the mathematics, built for the web",
        work: || {
            tools::add_target()?;
            let mut build = cargo(&["test", "--locked", "--package", CORE, "--no-run", "--target", WEB]);
            // Property tests come with a source of random numbers, which asks to be told that there is none.
            run(build.env(
                "CARGO_TARGET_WASM32_UNKNOWN_UNKNOWN_RUSTFLAGS",
                "--cfg getrandom_backend=\"unsupported\"",
            ))
        },
    },
];

/// The crate with the mathematics.
const CORE: &str = "depth-core";

const PROGRAM: [&str; 3] = ["--locked", "--package", "depth-calculator"];
const DENY: [&str; 3] = ["--", "--deny", "warnings"];

/// Checks what has one of `words` in its name, or everything. What fails hides nothing that follows.
pub(crate) fn run_chosen(words: &[String]) -> Result<(), String> {
    let is_chosen = |check: &&Check| words.is_empty() || words.iter().any(|word| check.name.contains(word.as_str()));
    let chosen: Vec<&Check> = CHECKS.iter().filter(is_chosen).collect();
    if chosen.is_empty() {
        let names: Vec<&str> = CHECKS.iter().map(|check| check.name).collect();
        return Err(format!("No check has that in its name. There are:\n{}", names.join("\n")));
    }
    prerequisites::check(Needs {
        node: false,
        build_bytes: BUILD_BYTES,
    })?;
    let mut table = Table::default();
    for Check { name, work } in chosen {
        table.run(name, || step(name, work));
    }
    table.finish(false)
}
