//! Debian's packages, for what the tests need besides Rust and Node.js.

use crate::step::{command, output, run};

/// Is this CI, where what is missing is installed, and nothing may be left out?
pub(crate) fn must_install() -> bool {
    std::env::var_os("CI").is_some_and(|ci| ci == "true")
}

/// Only as root, or where it `must` be: elsewhere a machine's programs are its owner's business.
pub(crate) fn may_install(must: bool) -> bool {
    output(&mut command("apt-get", &["--version"])).is_some() && (must || is_root())
}

/// Installs packages, and what they cannot do without.
pub(crate) fn install(packages: &[&str]) -> Result<(), String> {
    apt_get(&["update"])?;
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
