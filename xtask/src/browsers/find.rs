//! Where browsers and their drivers are, on Linux, macOS and Windows.

use super::engine::{Engine, Places, Programs};
use crate::step::{on_path, version};
use crate::tools;
use std::path::{Path, PathBuf};

/// Why a browser cannot be used.
pub(crate) struct Missing {
    /// Without a full stop.
    pub(crate) why: String,
    /// Whether everything but geckodriver is there, which can be built.
    pub(crate) needs_geckodriver: bool,
}

impl Missing {
    fn new(why: impl Into<String>) -> Self {
        Self {
            why: why.into(),
            needs_geckodriver: false,
        }
    }
}

/// A browser with a driver that fits.
pub(crate) fn find(engine: Engine, places: &Places) -> Result<Programs, Missing> {
    match engine {
        Engine::Chromium => chromium(places),
        Engine::Firefox => firefox(places),
        Engine::WebKit => webkit(places),
    }
}

/// The first browser for which there is a driver of the same major version.
fn chromium(places: &Places) -> Result<Programs, Missing> {
    const NAMES: &[&str] = &["chromium", "chromium-browser", "google-chrome", "google-chrome-stable", "chrome"];
    const APPLICATIONS: &[&str] = &[
        "Google Chrome.app/Contents/MacOS/Google Chrome",
        "Chromium.app/Contents/MacOS/Chromium",
        "Google/Chrome/Application/chrome.exe",
        "Chromium/Application/chrome.exe",
        "chromium/current/usr/lib/chromium-browser/chrome",
    ];
    let browsers: Vec<(PathBuf, String)> = candidates(places.chromium.as_ref(), NAMES, APPLICATIONS)
        .filter_map(|browser| Some((browser_version(&browser)?, browser)))
        .map(|(version, browser)| (browser, version))
        .collect();
    let drivers: Vec<(PathBuf, String)> = places
        .chromedriver
        .clone()
        .into_iter()
        .chain(in_folder("CHROMEWEBDRIVER", "chromedriver"))
        .chain(on_path("chromedriver"))
        .chain(
            [
                "/usr/lib/chromium-browser/chromedriver",
                "/snap/chromium/current/usr/lib/chromium-browser/chromedriver",
            ]
            .map(PathBuf::from),
        )
        .filter_map(|driver| version(&driver).map(|version| (driver, version)))
        .collect();
    let pair = browsers.iter().find_map(|(browser, version)| {
        let (driver, _) = drivers.iter().find(|(_, of)| major(of) == major(version))?;
        Some(Programs {
            browser: browser.clone(),
            driver: driver.clone(),
            version: version.clone(),
        })
    });
    pair.ok_or_else(|| {
        Missing::new(match (browsers.first(), drivers.first()) {
            (None, _) => "There is neither Chromium nor Google Chrome".to_owned(),
            (Some((_, version)), None) => format!("There is {version}, but no chromedriver"),
            (Some((_, version)), Some((_, driver))) => format!("{version} and {driver} are of different versions"),
        })
    })
}

fn firefox(places: &Places) -> Result<Programs, Missing> {
    const APPLICATIONS: &[&str] = &[
        "Firefox.app/Contents/MacOS/firefox",
        "Mozilla Firefox/firefox.exe",
        "firefox/current/usr/lib/firefox/firefox",
    ];
    let (browser, version) = candidates(places.firefox.as_ref(), &["firefox-esr", "firefox"], APPLICATIONS)
        .find_map(|browser| browser_version(&browser).map(|version| (browser, version)))
        .ok_or_else(|| Missing::new("There is no Firefox"))?;
    screen(&version)?;
    let driver = places
        .geckodriver
        .clone()
        .into_iter()
        .chain(in_folder("GECKOWEBDRIVER", "geckodriver"))
        .chain(on_path("geckodriver"))
        .chain([tools::program("geckodriver")])
        .find(|driver| self::version(driver).is_some());
    match driver {
        Some(driver) => Ok(Programs { browser, driver, version }),
        None => Err(Missing {
            why: format!("There is {version}, but no geckodriver"),
            needs_geckodriver: true,
        }),
    }
}

fn webkit(places: &Places) -> Result<Programs, Missing> {
    if !cfg!(target_os = "linux") {
        return Err(Missing::new("There is no WebKitGTK on this system"));
    }
    let browser = places
        .minibrowser
        .clone()
        .or_else(minibrowser)
        .ok_or_else(|| Missing::new("There is no MiniBrowser of WebKitGTK"))?;
    let driver = places
        .webkitdriver
        .clone()
        .or_else(|| on_path("WebKitWebDriver"))
        .ok_or_else(|| Missing::new("There is no WebKitWebDriver"))?;
    screen("WebKit")?;
    let version = version(&driver).unwrap_or_else(|| "WebKitGTK".to_owned());
    Ok(Programs { browser, driver, version })
}

/// Debian keeps it beside the libraries, in a folder named after the machine and the version.
fn minibrowser() -> Option<PathBuf> {
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
}

/// Two of the engines draw nothing without a screen; Xvfb is one without glass.
fn screen(browser: &str) -> Result<(), Missing> {
    // The same rule as in tests/browser/engines/screen.mjs.
    let is_set = |name| std::env::var_os(name).is_some_and(|value| !value.is_empty());
    let has_one = !cfg!(target_os = "linux") || on_path("Xvfb").is_some() || is_set("DISPLAY") || is_set("WAYLAND_DISPLAY");
    if has_one {
        Ok(())
    } else {
        Err(Missing::new(format!("{browser} needs a screen, and there is neither one nor Xvfb")))
    }
}

/// The programs that exist: the one that somebody named, or those on PATH and in the folders of applications.
fn candidates<'a>(named: Option<&'a PathBuf>, names: &'a [&str], applications: &'a [&str]) -> impl Iterator<Item = PathBuf> + 'a {
    // Whoever names one means that one.
    let search = named.is_none();
    let on_path = names.iter().filter(move |_| search).filter_map(|name| on_path(name));
    let installed = application_folders()
        .into_iter()
        .filter(move |_| search)
        .flat_map(move |folder| applications.iter().map(move |application| folder.join(application)))
        .filter(|program| program.is_file());
    named.cloned().into_iter().chain(installed).chain(on_path)
}

fn application_folders() -> Vec<PathBuf> {
    if cfg!(target_os = "macos") {
        let own = std::env::home_dir().map(|home| home.join("Applications"));
        std::iter::once(PathBuf::from("/Applications")).chain(own).collect()
    } else if cfg!(windows) {
        let variables = ["ProgramFiles", "ProgramFiles(x86)", "LOCALAPPDATA"];
        variables.iter().filter_map(std::env::var_os).map(PathBuf::from).collect()
    } else {
        // Ubuntu's packages on PATH only start these, in a way that no driver understands.
        vec![PathBuf::from("/snap")]
    }
}

fn in_folder(variable: &str, program: &str) -> Option<PathBuf> {
    let folder = std::env::var_os(variable)?;
    Some(PathBuf::from(folder).join(format!("{program}{}", std::env::consts::EXE_SUFFIX)))
}

/// Name and version of a browser, as in "Chromium 156.0.8078.79 built on Debian".
fn browser_version(program: &Path) -> Option<String> {
    // On Windows, asking opens a window.
    if cfg!(windows) { version_beside(program) } else { version(program) }
}

/// What stands beside a browser on Windows: Chrome's folder of the version's name, Firefox's application.ini.
fn version_beside(program: &Path) -> Option<String> {
    let folder = program.parent()?;
    if let Ok(ini) = std::fs::read_to_string(folder.join("application.ini")) {
        let version = ini.lines().find_map(|line| line.strip_prefix("Version="))?;
        return Some(format!("Firefox {version}"));
    }
    let names = std::fs::read_dir(folder)
        .ok()?
        .flatten()
        .filter_map(|entry| entry.file_name().into_string().ok());
    let is_version = |name: &String| name.split('.').count() == 4 && name.split('.').all(|part| part.parse::<u32>().is_ok());
    let newest = names.filter(is_version).max_by_key(|name| major(name))?;
    Some(format!("Chrome {newest}"))
}

/// The first whole number in a version, as in "Chromium 156.0.8078.79".
fn major(version: &str) -> Option<u32> {
    version.split_whitespace().find_map(|word| word.split('.').next()?.parse().ok())
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{major, version_beside};
    use std::fs;

    #[test]
    fn the_major_version_is_the_first_number() {
        assert_eq!(major("Chromium 156.0.8078.79 built on Debian GNU/Linux 12"), Some(156));
        assert_eq!(major("ChromeDriver 156.0.8078.73 (abc)"), Some(156));
        assert_eq!(major("no version"), None);
    }

    #[test]
    fn on_windows_a_version_is_read_from_what_lies_beside_the_program() {
        let folder = std::env::temp_dir().join(format!("xtask-browsers-{}", std::process::id()));
        fs::create_dir_all(folder.join("chrome/99.0.1.2")).unwrap();
        fs::create_dir_all(folder.join("chrome/156.0.8078.79")).unwrap();
        fs::create_dir_all(folder.join("chrome/SetupMetrics")).unwrap();
        fs::create_dir_all(folder.join("firefox")).unwrap();
        fs::write(folder.join("firefox/application.ini"), "[App]\nName=Firefox\nVersion=153.0.1\n").unwrap();
        assert_eq!(
            version_beside(&folder.join("chrome/chrome.exe")).as_deref(),
            Some("Chrome 156.0.8078.79")
        );
        assert_eq!(
            version_beside(&folder.join("firefox/firefox.exe")).as_deref(),
            Some("Firefox 153.0.1")
        );
        fs::remove_dir_all(folder).unwrap();
    }
}
