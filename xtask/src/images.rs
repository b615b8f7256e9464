//! The images of the screens, which tests/screens compares: what draws them, and whether they were left out.

use crate::apt;
use crate::step::{step, target};
use std::path::PathBuf;

/// Mesa's software renderer for Vulkan, as Debian and Ubuntu call it.
const PACKAGE: &str = "mesa-vulkan-drivers";

/// Installs what draws them, where that is missing and may be installed; with sudo if `asked`. The tests say if it is still missing.
pub(crate) fn prepare(asked: bool) {
    // What an earlier run said.
    let _ = std::fs::remove_file(note());
    if cfg!(target_os = "linux") && !has_renderer() && apt::may_install(asked) {
        let _ = step("Install what draws the images of the screens", || apt::install(&[PACKAGE]));
    }
}

/// Why the tests that ran since [`prepare`] compared no images; nothing if they did, or if there were no such tests.
pub(crate) fn left_out() -> Option<String> {
    std::fs::read_to_string(note()).ok()
}

/// Where the tests say it.
fn note() -> PathBuf {
    target().join("tmp/screens/left-out.txt")
}

/// Whether Vulkan is told of Mesa's llvmpipe.
fn has_renderer() -> bool {
    let mut drivers = std::fs::read_dir("/usr/share/vulkan/icd.d").into_iter().flatten().flatten();
    drivers.any(|driver| driver.file_name().to_string_lossy().starts_with("lvp_icd"))
}
