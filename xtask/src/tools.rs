//! What building the page needs besides cargo: the WebAssembly target, Trunk, and the wasm-bindgen tool.

use std::ffi::OsString;
use std::path::{Path, PathBuf};

use crate::step::{self, cargo, command, output, root, run};

const TARGET: &str = "wasm32-unknown-unknown";
/// The newest that builds with the pinned Rust.
const TRUNK_VERSION: &str = "0.21.14";

/// Installs what is missing, into `target/tools`, and returns a `PATH` with these tools in front.
pub(crate) fn set_up() -> Result<OsString, String> {
    add_target()?;
    let path = path_with_tools()?;
    install("trunk", "trunk", TRUNK_VERSION, &["--locked"], "4 to 7 minutes on two cores", &path)?;
    // Trunk refuses a tool that is not of exactly the library's version. With --locked it does not install.
    let version = locked_version("wasm-bindgen")?;
    install(
        "wasm-bindgen",
        "wasm-bindgen-cli",
        &version,
        &[],
        "about 2 minutes on two cores",
        &path,
    )?;
    Ok(path)
}

/// Downloads the crates once, since Trunk then builds without the network.
pub(crate) fn fetch_crates() -> Result<(), String> {
    step::step("Fetch the crates", || run(&mut cargo(&["fetch", "--locked", "--target", TARGET])))
}

/// Makes the pinned Rust able to build WebAssembly.
pub(crate) fn add_target() -> Result<(), String> {
    let sysroot =
        output(&mut command("rustc", &["--print", "sysroot"])).ok_or("rustc could not be run: install Rust with rustup first.")?;
    if Path::new(&sysroot).join("lib/rustlib").join(TARGET).is_dir() {
        return Ok(());
    }
    step::step("Add the WebAssembly target to Rust (half a minute)", || {
        run(&mut command("rustup", &["target", "add", TARGET])).map_err(|reason| {
            format!(
                "{reason}\nRust cannot build for {TARGET} yet; a Rust that rustup did not install needs that target from where it came."
            )
        })
    })
}

fn install(program: &str, package: &str, version: &str, options: &[&str], time: &str, path: &OsString) -> Result<(), String> {
    let wanted = format!("{program} {version}");
    let found = output(command(program, &["--version"]).env("PATH", path));
    if found.as_deref() == Some(wanted.as_str()) {
        return Ok(());
    }
    step::step(&format!("Install {wanted} into target/tools, once ({time})"), || {
        cargo_install(package, version, options)
    })
}

/// Builds a package's programs into [`programs`].
pub(crate) fn cargo_install(package: &str, version: &str, options: &[&str]) -> Result<(), String> {
    // Optimising these tools, or describing them for a debugger, takes far longer than they will ever run.
    let mut install = cargo(&["install", package, "--version", version, "--debug", "--force", "--root"]);
    run(install.arg(tools_folder()).args(options).env("CARGO_PROFILE_DEV_DEBUG", "0"))
}

fn tools_folder() -> PathBuf {
    root().join("target").join("tools")
}

/// Where [`cargo_install`] puts programs.
pub(crate) fn programs() -> PathBuf {
    tools_folder().join("bin")
}

fn path_with_tools() -> Result<OsString, String> {
    let rest = std::env::var_os("PATH").unwrap_or_default();
    let folders = std::iter::once(programs()).chain(std::env::split_paths(&rest));
    std::env::join_paths(folders).map_err(|error| format!("A folder's name cannot stand in PATH: {error}."))
}

/// The version of a package in Cargo.lock.
fn locked_version(package: &str) -> Result<String, String> {
    let lock = std::fs::read_to_string(root().join("Cargo.lock")).map_err(|error| format!("Cargo.lock cannot be read: {error}."))?;
    let mut lines = lock.lines().skip_while(|line| *line != format!("name = \"{package}\""));
    lines
        .nth(1)
        .and_then(|line| line.strip_prefix("version = \"")?.strip_suffix('"'))
        .map(str::to_owned)
        .ok_or_else(|| format!("Cargo.lock names no version of {package}."))
}
