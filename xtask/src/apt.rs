//! Debian's and Ubuntu's packages, for what the tests need besides Rust and Node.js.

use crate::step::{command, on_path, output, run};
use std::sync::OnceLock;

/// Whether packages may be installed here: by root, or by anybody else only where the command line asks for it
/// (`asked`: then with sudo). Elsewhere a machine's programs are its owner's business.
pub(crate) fn may_install(asked: bool) -> bool {
    on_path("apt-get").is_some() && (is_root() || (asked && on_path("sudo").is_some()))
}

/// Whether this is Ubuntu, whose Chromium and Firefox are no packages but snaps.
pub(crate) fn is_ubuntu() -> bool {
    let system = std::fs::read_to_string("/etc/os-release").unwrap_or_default();
    system.lines().any(|line| line == "ID=ubuntu" || line == "ID_LIKE=ubuntu")
}

/// Installs packages, and what they cannot do without.
pub(crate) fn install(packages: &[&str]) -> Result<(), String> {
    static UPDATED: OnceLock<Result<(), String>> = OnceLock::new();
    UPDATED.get_or_init(|| apt_get(&["update"])).clone()?;
    let mut install = vec!["install", "--yes", "--no-install-recommends"];
    install.extend(packages);
    apt_get(&install)
}

fn is_root() -> bool {
    output(&mut command("id", &["-u"])).as_deref() == Some("0")
}

fn apt_get(arguments: &[&str]) -> Result<(), String> {
    // -n: fail instead of asking for a password that nobody may be there to type.
    let mut apt_get = if is_root() {
        command("apt-get", &[])
    } else {
        command("sudo", &["-n", "apt-get"])
    };
    run(apt_get.args(arguments).env("DEBIAN_FRONTEND", "noninteractive"))
}
