//! The desktop program as assistive technology meets it: AT-SPI, which is Linux's way. tests/desktop holds the test.

use crate::debian;
use crate::step::{command, output, root, run, step};

/// Debian's own, which has Debian's bindings.
const PYTHON: &str = "/usr/bin/python3";
/// What Debian calls the bindings, the services they speak to, a screen without glass, and what winit opens on it.
const PACKAGES: &[&str] = &[
    "python3-gi",
    "gir1.2-atspi-2.0",
    "at-spi2-core",
    "dbus-daemon",
    "xvfb",
    "libgl1",
    "libxcursor1",
    "libxi6",
    "libxkbcommon-x11-0",
];

/// Starts the program, which `cargo test` has built, and uses it by role and name. Elsewhere than on Linux it only says that this is not tested.
pub(crate) fn test() -> Result<(), String> {
    if !is_there() {
        let advice = format!(
            "it needs Linux and, on Debian and Ubuntu, `apt-get install {}`.",
            PACKAGES.join(" ")
        );
        if !debian::may_install(debian::must_install()) {
            println!("\n!! NOT TESTED with assistive technology on the desktop: {advice}");
            return Ok(());
        }
        step("Install what assistive technology needs on the desktop", || {
            debian::install(PACKAGES)
        })?;
        if !is_there() {
            return Err(format!("The desktop program cannot be tested with assistive technology: {advice}"));
        }
    }
    step("The desktop program, through assistive technology", || {
        let target = std::env::var_os("CARGO_TARGET_DIR").map_or_else(|| root().join("target"), Into::into);
        let mut session = command("dbus-run-session", &["--", PYTHON, "-W", "ignore", "tests/desktop/assistive.py"]);
        run(session.arg(target.join("debug/depth-calculator")))
    })
}

fn is_there() -> bool {
    let bindings = "import gi; gi.require_version('Atspi', '2.0'); from gi.repository import Atspi, Gio";
    let answers = |program: &str, arguments: &[&str]| output(&mut command(program, arguments)).is_some();
    answers(PYTHON, &["-c", bindings]) && answers("dbus-run-session", &["--version"]) && answers("sh", &["-c", "command -v Xvfb"])
}
