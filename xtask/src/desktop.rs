//! The desktop program as assistive technology meets it: AT-SPI, which is Linux's way. tests/desktop holds the test.

use crate::apt;
use crate::step::{cargo, command, on_path, output, run, step, target};
use crate::table::Outcome;

/// Debian's own, which has Debian's bindings.
const PYTHON: &str = "/usr/bin/python3";
/// What Debian and Ubuntu call the bindings, the services they speak to, a screen without glass, and what winit opens on it.
const PACKAGES: &[&str] = &[
    "python3-gi",
    "gir1.2-atspi-2.0",
    "at-spi2-core",
    "dbus-daemon",
    "xvfb",
    "libgl1",
    "libgl1-mesa-dri",
    "libxcursor1",
    "libxi6",
    "libxkbcommon-x11-0",
];

/// Starts the program and uses it by role and name. `asked` says whether packages may be installed with sudo.
pub(crate) fn test(asked: bool) -> Outcome {
    if !cfg!(target_os = "linux") {
        return Outcome::LeftOut("AT-SPI exists on Linux only.".to_owned());
    }
    if !is_there() {
        let advice = format!("What is needed: on Debian and Ubuntu `apt-get install {}`.", PACKAGES.join(" "));
        if !apt::may_install(asked) {
            return Outcome::LeftOut(advice);
        }
        let installed = step("Install what assistive technology needs on the desktop", || apt::install(PACKAGES));
        if let Err(reason) = installed {
            return Outcome::LeftOut(format!("{reason} {advice}"));
        }
        if !is_there() {
            return Outcome::LeftOut(format!("Something is still missing. {advice}"));
        }
    }
    step("The desktop program, through assistive technology", || {
        // As `cargo test` leaves it, so that nothing is built twice.
        run(&mut cargo(&["test", "--locked", "--workspace", "--no-run", "--quiet"]))?;
        run(command(PYTHON, &["-W", "ignore", "tests/desktop/assistive.py"]).arg(target().join("debug/depth-calculator")))
    })
    .into()
}

fn is_there() -> bool {
    let bindings = "import gi; gi.require_version('Atspi', '2.0'); from gi.repository import Atspi, Gio";
    output(&mut command(PYTHON, &["-c", bindings])).is_some()
        && output(&mut command("dbus-run-session", &["--version"])).is_some()
        && on_path("Xvfb").is_some()
}
