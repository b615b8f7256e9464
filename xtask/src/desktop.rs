//! The desktop program as assistive technology meets it: AT-SPI, which is Linux's way. tests/desktop holds the test.

use crate::apt;
use crate::plan::Plan;
use crate::step::{cargo, command, on_path, output, run, step, target};
use crate::table::Outcome;

/// Debian's own, which has Debian's bindings.
const PYTHON: &str = "/usr/bin/python3";
const NOT_LINUX: &str = "AT-SPI exists on Linux only.";
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

/// What [`test()`] will come to.
pub(crate) fn plan(asked: bool) -> Plan {
    if !cfg!(target_os = "linux") {
        return Plan::LeaveOut(NOT_LINUX.to_owned());
    }
    let missing = missing();
    if missing.is_empty() {
        Plan::Run(String::new())
    } else if apt::may_install(asked) {
        Plan::RunAfter(format!("There is no {}; it will be installed.", missing.join(", no ")))
    } else {
        Plan::LeaveOut(without(&missing))
    }
}

/// Starts the program and uses it by role and name. `asked` says whether packages may be installed with sudo.
pub(crate) fn test(asked: bool) -> Outcome {
    if !cfg!(target_os = "linux") {
        return Outcome::LeftOut(NOT_LINUX.to_owned());
    }
    if !missing().is_empty() && apt::may_install(asked) {
        let installed = step("Install what assistive technology needs on the desktop", || apt::install(PACKAGES));
        if let Err(reason) = installed {
            return Outcome::LeftOut(format!("{reason} {}", without(&missing())));
        }
    }
    let missing = missing();
    if !missing.is_empty() {
        return Outcome::LeftOut(without(&missing));
    }
    step("The desktop program, through assistive technology", || {
        // As `cargo test` leaves it, so that nothing is built twice.
        run(&mut cargo(&["test", "--locked", "--workspace", "--no-run", "--quiet"]))?;
        run(command(PYTHON, &["-W", "ignore", "tests/desktop/assistive.py"]).arg(target().join("debug/depth-calculator")))
    })
    .into()
}

/// What the test needs and this computer lacks.
fn missing() -> Vec<&'static str> {
    let bindings = "import gi; gi.require_version('Atspi', '2.0'); from gi.repository import Atspi, Gio";
    let is_there = [
        ("AT-SPI for Python", output(&mut command(PYTHON, &["-c", bindings])).is_some()),
        (
            "dbus-run-session",
            output(&mut command("dbus-run-session", &["--version"])).is_some(),
        ),
        ("Xvfb", on_path("Xvfb").is_some()),
    ];
    is_there
        .into_iter()
        .filter(|(_, is_there)| !is_there)
        .map(|(what, _)| what)
        .collect()
}

/// What is missing, and what somebody can do who lacks it.
fn without(missing: &[&str]) -> String {
    format!(
        "There is no {}. What is needed: on Debian and Ubuntu `apt-get install {}`.",
        missing.join(", no "),
        PACKAGES.join(" ")
    )
}

#[cfg(test)]
mod tests {
    use super::without;

    #[test]
    fn what_is_missing_is_named_with_the_packages_that_bring_it() {
        let sentence = without(&["dbus-run-session", "Xvfb"]);
        assert!(sentence.starts_with("There is no dbus-run-session, no Xvfb. "), "{sentence}");
        assert!(sentence.contains("dbus-daemon") && sentence.contains("xvfb"), "{sentence}");
    }
}
