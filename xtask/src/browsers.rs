//! Real browsers for the tests: finds or installs them, and runs tests/browser.

use std::path::{Path, PathBuf};

use crate::step::{command, output, root, run, step};
use crate::{debian, tools};

const BROWSERS: &[&str] = &[
    "chromium",
    "chromium-browser",
    "google-chrome",
    "google-chrome-stable",
    "/Applications/Google Chrome.app/Contents/MacOS/Google Chrome",
    "C:/Program Files/Google/Chrome/Application/chrome.exe",
];
const OLDEST_NODE: u32 = 20;
const GECKODRIVER_VERSION: &str = "0.37.1";

/// An engine besides Chromium, in which the page must do the same.
struct Other {
    name: &'static str,
    /// What tests/browser/engines.mjs calls it.
    engine: &'static str,
    /// What Debian calls it.
    packages: &'static [&'static str],
    needs_geckodriver: bool,
    /// The programs, as the environment variables that tests/browser/engines.mjs reads.
    find: fn() -> Option<Vec<(&'static str, PathBuf)>>,
}

const OTHERS: &[Other] = &[
    Other {
        name: "Firefox",
        engine: "firefox",
        packages: &["firefox-esr", "xvfb"],
        needs_geckodriver: true,
        find: find_firefox,
    },
    Other {
        name: "WebKit",
        engine: "webkit",
        packages: &["webkit2gtk-driver", "xvfb"],
        needs_geckodriver: false,
        find: find_webkit,
    },
];

/// What only Chromium runs: pictures for people, which need a window as narrow as a phone and a scale of its own.
const PICTURES: &str = "tests/browser/screens.test.mjs";

/// Chromium or Chrome, and the driver of the same version.
struct Chromium {
    browser: PathBuf,
    driver: PathBuf,
}

/// Runs the tests in tests/browser on the page in `dist`: in every engine, and the pictures in Chromium.
pub(crate) fn test(dist: &Path) -> Result<(), String> {
    check_node()?;
    let folder = root().join("tests/browser");
    install_packages("Install the packages of the browser tests", &folder)?;
    let chromium = find_or_install_chromium()?;
    let programs = [("CHROMIUM", chromium.browser), ("CHROMEDRIVER", chromium.driver)];
    let mut files = test_files()?;
    run_tests("Chromium", "chromium", &files, &programs, dist)?;

    files.retain(|file| file != PICTURES);
    let must = debian::must_install();
    let mut untested = Vec::new();
    for other in OTHERS {
        match find_or_install(other, must) {
            Ok(programs) => run_tests(other.name, other.engine, &files, &programs, dist)?,
            Err(reason) if must => return Err(reason),
            Err(reason) => untested.push(format!("NOT TESTED in {}: {reason}", other.name)),
        }
    }
    for line in untested {
        println!("\n!! {line}");
    }
    Ok(())
}

fn run_tests(name: &str, engine: &str, files: &[String], programs: &[(&str, PathBuf)], dist: &Path) -> Result<(), String> {
    step(&format!("Tests in a real browser: {name}"), || {
        let mut node = command("node", &["--test", "--test-concurrency=1", "--test-reporter=spec"]);
        node.args(files).env("DIST", dist).env("ENGINE", engine);
        run(node.envs(programs.iter().map(|(variable, path)| (variable, path))))
    })
}

fn find_or_install(other: &Other, must: bool) -> Result<Vec<(&'static str, PathBuf)>, String> {
    if let Some(programs) = (other.find)() {
        return Ok(programs);
    }
    let driver = if other.needs_geckodriver {
        format!(" and `cargo install geckodriver --version {GECKODRIVER_VERSION}`")
    } else {
        String::new()
    };
    let packages = other.packages.join(" ");
    let advice = format!("the tests need, on Debian and Ubuntu, `apt-get install {packages}`{driver}.");
    if !debian::may_install(must) {
        return Err(advice);
    }
    step(&format!("Install {} (some minutes)", other.name), || {
        // Where a browser came from elsewhere, Debian's package may be missing; what matters is looked for below.
        let installed = debian::install(other.packages);
        if other.needs_geckodriver && geckodriver().is_none() {
            tools::cargo_install("geckodriver", GECKODRIVER_VERSION, &[])?;
        }
        if (other.find)().is_some() { Ok(()) } else { installed }
    })
    .map_err(|reason| format!("{reason}\nFor {}, {advice}", other.name))?;
    (other.find)().ok_or(advice)
}

fn find_firefox() -> Option<Vec<(&'static str, PathBuf)>> {
    let named = std::env::var_os("FIREFOX").map(PathBuf::from);
    let browser = named
        .into_iter()
        .chain(["firefox-esr", "firefox"].map(PathBuf::from))
        .find(|browser| major_version(browser).is_some())?;
    screen()?;
    Some(vec![("FIREFOX", on_path(browser)), ("GECKODRIVER", geckodriver()?)])
}

fn geckodriver() -> Option<PathBuf> {
    let named = |name: &str| std::env::var_os(name).map(PathBuf::from);
    [
        named("GECKODRIVER"),
        named("GECKOWEBDRIVER").map(|folder| folder.join("geckodriver")),
    ]
    .into_iter()
    .flatten()
    .chain([PathBuf::from("geckodriver"), tools::programs().join("geckodriver")])
    .find(|driver| output(&mut command(driver, &["--version"])).is_some())
    .map(on_path)
}

fn find_webkit() -> Option<Vec<(&'static str, PathBuf)>> {
    let driver = on_path(PathBuf::from("WebKitWebDriver"));
    // Debian keeps MiniBrowser beside the libraries, in a folder named after the machine and the version.
    let named = std::env::var_os("MINIBROWSER").map(PathBuf::from);
    let beside = || {
        let machines = std::fs::read_dir("/usr/lib").ok()?;
        let folders = machines.flatten().filter_map(|machine| std::fs::read_dir(machine.path()).ok());
        let mut found: Vec<PathBuf> = folders
            .flat_map(Iterator::flatten)
            .filter(|folder| folder.file_name().to_string_lossy().starts_with("webkit2gtk-"))
            .map(|folder| folder.path().join("MiniBrowser"))
            .filter(|path| path.is_file())
            .collect();
        found.sort();
        found.pop()
    };
    let browser = named.or_else(beside)?;
    screen()?;
    driver.is_file().then(|| vec![("WEBKITDRIVER", driver), ("MINIBROWSER", browser)])
}

/// These two draw nothing without a screen; Xvfb is one without glass.
fn screen() -> Option<()> {
    let has_one = !cfg!(target_os = "linux") || std::env::var_os("DISPLAY").is_some();
    (has_one || on_path(PathBuf::from("Xvfb")).is_file()).then_some(())
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

/// Installs the npm packages that `folder` asks for, unless they are there already.
pub(crate) fn install_packages(what: &str, folder: &Path) -> Result<(), String> {
    let changed = |file: &str| std::fs::metadata(folder.join(file)).and_then(|file| file.modified()).ok();
    if changed("node_modules/.package-lock.json") >= changed("package-lock.json") {
        return Ok(());
    }
    step(what, || {
        let npm = if cfg!(windows) { "npm.cmd" } else { "npm" };
        run(command(npm, &["ci", "--no-audit", "--no-fund"]).current_dir(folder))
    })
}

fn test_files() -> Result<Vec<String>, String> {
    let folder = "tests/browser";
    let entries = std::fs::read_dir(root().join(folder)).map_err(|error| format!("{folder} cannot be read: {error}."))?;
    let names = entries.filter_map(|entry| entry.ok()?.file_name().into_string().ok());
    let mut files: Vec<String> = names
        .filter(|name| name.ends_with(".test.mjs"))
        .map(|name| format!("{folder}/{name}"))
        .collect();
    if files.is_empty() {
        return Err(format!("{folder} holds no tests."));
    }
    files.sort();
    Ok(files)
}

fn find_or_install_chromium() -> Result<Chromium, String> {
    if let Some(chromium) = find_chromium() {
        return Ok(chromium);
    }
    let advice = "The browser tests need Chromium or Chrome and a chromedriver of the same version on PATH: \
                  on Debian and Ubuntu `apt-get install chromium chromium-driver`, elsewhere Chrome and the chromedriver that belongs to it.";
    if !debian::may_install(true) {
        return Err(advice.to_owned());
    }
    step("Install Chromium (about a minute)", || {
        debian::install(&["chromium", "chromium-driver"])
    })
    .map_err(|reason| format!("{reason}\n{advice}"))?;
    find_chromium().ok_or_else(|| advice.to_owned())
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
