//! The engines that the page is tested in, and where their browsers and drivers are said to be.

use clap::Args;
use std::path::PathBuf;

use crate::apt;

/// The engines that the page is tested in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Engine {
    Chromium,
    Firefox,
    WebKit,
}

impl Engine {
    /// What the command line and tests/browser/engines call it.
    pub(crate) const fn name(self) -> &'static str {
        match self {
            Self::Chromium => "chromium",
            Self::Firefox => "firefox",
            Self::WebKit => "webkit",
        }
    }

    /// What Debian and Ubuntu call what it needs.
    pub(super) fn packages(self) -> &'static [&'static str] {
        match self {
            // Ubuntu's are snaps, which the drivers of these tests do not start.
            Self::Chromium | Self::Firefox if apt::is_ubuntu() => &[],
            Self::Chromium => &["chromium", "chromium-driver"],
            Self::Firefox => &["firefox-esr", "xvfb"],
            Self::WebKit => &["webkit2gtk-driver", "xvfb"],
        }
    }

    /// What somebody can do who lacks it.
    pub(super) fn advice(self) -> String {
        let debian = match self.packages() {
            [] => String::new(),
            packages => format!("on Debian `apt-get install {}`; ", packages.join(" ")),
        };
        match self {
            Self::Chromium => format!(
                "{debian}elsewhere Google Chrome or Chromium and the chromedriver of the same version on PATH, or --chromium and --chromedriver"
            ),
            Self::Firefox => format!("{debian}elsewhere Firefox on PATH or --firefox; geckodriver is built by this command"),
            Self::WebKit => format!("{debian}it exists on Linux only: Safari is not driven by these tests"),
        }
    }
}

/// Where the browsers are, for those that are not found by themselves.
#[derive(Args, Clone, Debug, Default)]
#[command(next_help_heading = "Where browsers and drivers are, unless they are on PATH or in their usual places")]
pub(crate) struct Places {
    /// Chromium or Google Chrome
    #[arg(long, value_name = "PROGRAM", env = "CHROMIUM", hide_env_values = true)]
    pub(crate) chromium: Option<PathBuf>,
    /// chromedriver, of the same major version [also in the folder CHROMEWEBDRIVER]
    #[arg(long, value_name = "PROGRAM", env = "CHROMEDRIVER", hide_env_values = true)]
    pub(crate) chromedriver: Option<PathBuf>,
    /// Firefox
    #[arg(long, value_name = "PROGRAM", env = "FIREFOX", hide_env_values = true)]
    pub(crate) firefox: Option<PathBuf>,
    /// geckodriver [also in the folder GECKOWEBDRIVER]
    #[arg(long, value_name = "PROGRAM", env = "GECKODRIVER", hide_env_values = true)]
    pub(crate) geckodriver: Option<PathBuf>,
    /// MiniBrowser of WebKitGTK
    #[arg(long, value_name = "PROGRAM", env = "MINIBROWSER", hide_env_values = true)]
    pub(crate) minibrowser: Option<PathBuf>,
    /// WebKitWebDriver
    #[arg(long, value_name = "PROGRAM", env = "WEBKITDRIVER", hide_env_values = true)]
    pub(crate) webkitdriver: Option<PathBuf>,
}

/// A browser and the driver that fits it.
#[derive(Debug)]
pub(crate) struct Programs {
    pub(crate) browser: PathBuf,
    pub(crate) driver: PathBuf,
    /// Name and version, for people.
    pub(crate) version: String,
}
