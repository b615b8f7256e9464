//! Tools that the commands need besides cargo: the WebAssembly target, Trunk, wasm-bindgen, geckodriver, and what `check` runs.
//! A tool that is on PATH is used; what is missing comes by `cargo binstall`, where that is installed, else it is built.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use crate::platforms::WEB;
use crate::step::{self, cargo, command, on_path, output, run, target, version};

/// A program of a package in Rust's registry.
pub(crate) struct Tool {
    program: &'static str,
    package: &'static str,
    /// Which one is installed.
    version: &'static str,
    /// Any version that starts so may be used.
    accepted: &'static str,
    features: &'static [&'static str],
    time: &'static str,
}

const TRUNK: Tool = Tool {
    program: "trunk",
    package: "trunk",
    // The newest that builds with the pinned Rust.
    version: "0.21.14",
    accepted: "0.21.",
    // It only builds here, and neither downloads nor serves: no TLS, no search for newer versions.
    features: &["--no-default-features"],
    time: "2 to 4 minutes on two cores",
};
const GECKODRIVER: Tool = Tool {
    program: "geckodriver",
    package: "geckodriver",
    version: "0.37.1",
    accepted: "0.",
    features: &[],
    time: "a minute on two cores",
};
pub(crate) const TYPOS: Tool = Tool {
    program: "typos",
    package: "typos-cli",
    version: "1.52.0",
    accepted: "1.",
    features: &[],
    time: "a minute on two cores",
};
pub(crate) const CARGO_DENY: Tool = Tool {
    program: "cargo-deny",
    package: "cargo-deny",
    version: "0.20.2",
    accepted: "0.",
    features: &[],
    time: "3 minutes on two cores",
};

impl Tool {
    /// Where it is, installed into `target/tools` if there is none.
    pub(crate) fn find_or_install(&self) -> Result<PathBuf, String> {
        if let Some(found) = self.find() {
            return Ok(found);
        }
        let what = format!("Install {} {} into target/tools, once ({})", self.program, self.version, self.time);
        step::step(&what, || self.install())?;
        Ok(program(self.program))
    }

    fn find(&self) -> Option<PathBuf> {
        let own = program(self.program);
        std::iter::once(own).chain(on_path(self.program)).find(|path| self.accepts(path))
    }

    /// Whether `program` is of a version that may be used: it prints its name and that.
    fn accepts(&self, program: &Path) -> bool {
        let printed = version(program).unwrap_or_default();
        printed
            .split_whitespace()
            .nth(1)
            .is_some_and(|version| version.starts_with(self.accepted))
    }

    fn install(&self) -> Result<(), String> {
        let Self { package, version, .. } = self;
        let folder = folder();
        if on_path("cargo-binstall").is_some() {
            let mut binstall = cargo(&["binstall", "--no-confirm", "--force", "--root"]);
            if run(binstall.arg(&folder).arg(format!("{package}@{version}"))).is_ok() && self.find().is_some() {
                return Ok(());
            }
        }
        // Optimizing these tools, or describing them for a debugger, takes far longer than they will ever run.
        let mut install = cargo(&["install", package, "--version", version, "--locked", "--debug", "--force", "--root"]);
        // In one place, so that what several of them are made of is built once.
        install.env("CARGO_TARGET_DIR", folder.join("build"));
        run(install.arg(&folder).args(self.features).env("CARGO_PROFILE_DEV_DEBUG", "0"))
    }
}

/// Sets up what builds the page. Returns Trunk, and a `PATH` on which it finds the wasm-bindgen of this workspace.
pub(crate) fn for_page() -> Result<(PathBuf, OsString), String> {
    add_target()?;
    let trunk = TRUNK.find_or_install()?;
    let bindgen = wasm_bindgen()?;
    let rest = std::env::var_os("PATH").unwrap_or_default();
    let path = std::env::join_paths(std::iter::once(bindgen).chain(std::env::split_paths(&rest)))
        .map_err(|error| format!("A folder's name cannot stand in PATH: {error}."))?;
    Ok((trunk, path))
}

/// Builds `wasm-bindgen` from the workspace. Returns the folder it is in.
fn wasm_bindgen() -> Result<PathBuf, String> {
    step::step("Build wasm-bindgen (half a minute the first time)", || {
        run(&mut cargo(&["build", "--locked", "--quiet", "--package", "wasm-bindgen-tool"]))
    })?;
    Ok(target().join("debug"))
}

pub(crate) fn geckodriver() -> Result<(), String> {
    GECKODRIVER.find_or_install().map(drop)
}

/// Downloads the crates once, since Trunk then builds without the network.
pub(crate) fn fetch_crates() -> Result<(), String> {
    step::step("Fetch the crates", || run(&mut cargo(&["fetch", "--locked", "--target", WEB])))
}

/// Makes the pinned Rust able to build WebAssembly.
pub(crate) fn add_target() -> Result<(), String> {
    if sysroot()?.join("lib/rustlib").join(WEB).is_dir() {
        return Ok(());
    }
    step::step("Add the WebAssembly target to Rust (half a minute)", || {
        run(&mut command("rustup", &["target", "add", WEB])).map_err(|reason| {
            format!("{reason}\nRust cannot build for {WEB} yet; a Rust that rustup did not install needs that target from where it came.")
        })
    })
}

/// Where Rust itself is.
pub(crate) fn sysroot() -> Result<PathBuf, String> {
    let sysroot = output(&mut command("rustc", &["--print", "sysroot"]));
    sysroot
        .map(PathBuf::from)
        .ok_or_else(|| "rustc could not be run: install Rust with rustup first.".to_owned())
}

fn folder() -> PathBuf {
    target().join("tools")
}

/// Where a tool is put that is installed here.
pub(crate) fn program(name: &str) -> PathBuf {
    folder().join("bin").join(format!("{name}{}", std::env::consts::EXE_SUFFIX))
}

#[cfg(test)]
mod tests {
    use super::{CARGO_DENY, GECKODRIVER, TRUNK, TYPOS};

    #[test]
    fn the_version_that_is_installed_is_one_that_is_accepted() {
        for tool in [TRUNK, GECKODRIVER, TYPOS, CARGO_DENY] {
            assert!(tool.version.starts_with(tool.accepted), "{}", tool.program);
        }
    }
}
