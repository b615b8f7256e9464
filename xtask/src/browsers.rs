//! Real browsers for the tests: finds or installs them, and runs tests/browser.

use std::path::{Path, PathBuf};

use crate::step::{command, output, root, run, step};

const BROWSERS: &[&str] = &[
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "C:/Program Files/Google/Chrome/Application/chrome.exe",
];
const OLDEST_NODE: u32 = 20;

/// Chromium or Chrome, and the driver of the same version.
struct Chromium {
    browser: PathBuf,
    driver: PathBuf,
}

/// Runs the tests in tests/browser on the page in `dist`.
pub(crate) fn test(dist: &Path) -> Result<(), String> {
    check_node()?;
    let chromium = find_or_install_chromium()?;
    install_packages()?;
    step("Tests in a real browser", || {
        let mut files = test_files()?;
        files.sort();
        let mut node = command("node", &["--test", "--test-concurrency=1", "--test-reporter=spec"]);
        node.args(files)
            .env("DIST", dist)
            .env("CHROMIUM", chromium.browser)
            .env("CHROMEDRIVER", chromium.driver);
        run(&mut node)
    })
}

fn check_node() -> Result<(), String> {
    let wanted = format!("The browser tests need Node.js {OLDEST_NODE} or newer, with npm, on PATH");
    let version = output(&mut command("node", &["--version"])).ok_or_else(|| format!("{wanted}."))?;
    let major = version
        .trim_start_matches('v')
        .split('.')
        .next()
        .and_then(|major| major.parse::<u32>().ok());
    match major {
        Some(major) if major >= OLDEST_NODE => Ok(()),
        _ => Err(format!("{wanted}; this is {version}.")),
    }
}

/// Installs the packages of tests/browser unless they are there already.
fn install_packages() -> Result<(), String> {
    let folder = root().join("tests/browser");
    let changed = |file: &str| std::fs::metadata(folder.join(file)).and_then(|file| file.modified()).ok();
    if changed("node_modules/.package-lock.json") >= changed("package-lock.json") {
        return Ok(());
    }
    step("Install the packages of the browser tests", || {
        let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
        run(command(npm, &["ci", "--no-audit", "--no-fund"]).current_dir(&folder))
    })
}

fn test_files() -> Result<Vec<String>, String> {
    let folder = "tests/browser";
    let entries = std::fs::read_dir(root().join(folder)).map_err(|error| format!("{folder} cannot be read: {error}."))?;
    let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    let files: Vec<String> = names
        .filter(|name| name.ends_with(".test.mjs"))
        .map(|name| format!("{folder}/{name}"))
        .collect();
    if files.is_empty() {
        return Err(format!("{folder} holds no tests."));
    }
    Ok(files)
}

fn find_or_install_chromium() -> Result<Chromium, String> {
    if let Some(chromium) = find_chromium() {
        return Ok(chromium);
    }
    let advice = "The browser tests need Chromium or Chrome and a chromedriver of the same version on PATH: \
                  on Debian and Ubuntu `apt-get install chromium chromium-driver`, elsewhere Chrome and the chromedriver that belongs to it.";
    if output(&mut command("apt-get", &["--version"])).is_none() {
        return Err(advice.to_owned());
    }
    step("Install Chromium (about a minute)", || {
        apt_get(&["update"])?;
        apt_get(&["install", "--yes", "--no-install-recommends", "chromium", "chromium-driver"])
    })
    .map_err(|reason| format!("{reason}\n{advice}"))?;
    find_chromium().ok_or_else(|| advice.to_owned())
}

fn apt_get(arguments: &[&str]) -> Result<(), String> {
    let is_root = output(&mut command("id", &["-u"])).as_deref() == Some("0");
    // -n: fail instead of asking for a password that nobody may be there to type.
    let mut apt_get = if is_root {
        command("apt-get", &[])
    } else {
        command("sudo", &["-n", "apt-get"])
    };
    run(apt_get.args(arguments).env("DEBIAN_FRONTEND", "noninteractive"))
}

/// The first browser for which there is a driver of the same major version.
fn find_chromium() -> Option<Chromium> {
    let named = |name: &str| std::env::var_os(name).map(PathBuf::from);
    let drivers: Vec<PathBuf> = [
        named("CHROMEDRIVER"),
        named("CHROMEWEBDRIVER").map(|folder| folder.join("chromedriver")),
    ]
    .into_iter()
    .flatten()
    .chain(["chromedriver", "/usr/lib/chromium-browser/chromedriver"].map(PathBuf::from))
    .collect();
    let browsers = named("CHROMIUM").into_iter().chain(BROWSERS.iter().map(PathBuf::from));
    browsers
        .filter_map(|browser| Some((major_version(&browser)?, browser)))
        .find_map(|(version, browser)| {
            let driver = drivers.iter().find(|driver| major_version(driver) == Some(version))?;
            Some(Chromium {
                browser: on_path(browser),
                driver: on_path(driver.clone()),
            })
        })
}

/// The first whole number in what `program --version` prints, as in "Chromium 156.0.8078.79".
fn major_version(program: &Path) -> Option<u32> {
    let text = output(&mut command(program, &["--version"]))?;
    text.split_whitespace().find_map(|word| word.split('.').next()?.parse().ok())
}

/// The whole path of a program that is named without a folder: WebDriver takes nothing less.
fn on_path(program: PathBuf) -> PathBuf {
    let folders = std::env::var_os("PATH").unwrap_or_default();
    std::env::split_paths(&folders)
        .map(|folder| folder.join(&program))
        .find(|path| path.is_file())
        .unwrap_or(program)
}
