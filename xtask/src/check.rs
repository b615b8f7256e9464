//! `cargo xtask check`: what a change must satisfy besides the tests.

use crate::licenses;
use crate::prerequisites::{self, Needs};
use crate::step::{cargo, command, run, step};
use crate::table::Table;
use crate::tools::{self, CARGO_DENY, TYPOS};

/// Bytes on the disk, as measured with `du`.
const BUILD_BYTES: u64 = 3_000_000_000;

/// Formatting, lints on both platforms, documentation, spelling and licenses. What fails hides nothing that follows.
pub(crate) fn run_all() -> Result<(), String> {
    prerequisites::check(Needs {
        node: false,
        build_bytes: BUILD_BYTES,
    })?;
    const PROGRAM: [&str; 3] = ["--locked", "--package", "depth-calculator"];
    const DENY: [&str; 3] = ["--", "--deny", "warnings"];
    let mut table = Table::default();
    let mut check = |what: &str, work: &dyn Fn() -> Result<(), String>| table.run(what, || step(what, work));

    check("formatting", &|| run(&mut cargo(&["fmt", "--all", "--check"])));
    check("the mathematics and the formats alone", &|| {
        run(cargo(&["check"]).args(PROGRAM).args(["--no-default-features", "--lib"]))
    });
    check("lints, desktop, tests and benches", &|| {
        run(cargo(&["clippy", "--locked", "--workspace", "--all-targets"]).args(DENY))
    });
    check("lints, the command line without the window", &|| {
        let cli = ["--no-default-features", "--features", "cli", "--lib", "--bins"];
        run(cargo(&["clippy"]).args(PROGRAM).args(cli).args(DENY))
    });
    check("lints, web page", &|| {
        tools::add_target()?;
        let page = ["--lib", "--bins", "--target", "wasm32-unknown-unknown"];
        run(cargo(&["clippy"]).args(PROGRAM).args(page).args(DENY))
    });
    check("lints, the example of egui-mirror", &|| {
        let example = [
            "--locked",
            "--package",
            "egui-mirror",
            "--examples",
            "--target",
            "wasm32-unknown-unknown",
        ];
        run(cargo(&["clippy"]).args(example).args(DENY))
    });
    check("documentation", &|| {
        let doc = ["doc", "--locked", "--workspace", "--no-deps", "--document-private-items"];
        run(cargo(&doc).env("RUSTDOCFLAGS", "--deny warnings"))
    });
    check("spelling", &|| run(&mut command(TYPOS.find_or_install()?, &[])));
    check("list of licenses", &licenses::check);
    check("licenses, bans and sources of the crates", &|| {
        let deny = ["deny", "--locked", "check", "licenses", "bans", "sources"];
        run(&mut command(CARGO_DENY.find_or_install()?, &deny))
    });
    table.finish(true)
}
