//! The console window that Windows opens for a console program.
//!
//! The program is built for the console subsystem, so that shells wait for the output of `calculate`. From Windows 11 24H2 on its
//! manifest prevents a console of its own. An older Windows opens one at a double click, and it must not stay open beside the window.

use std::io::IsTerminal as _;
use std::os::windows::process::CommandExt as _;
use std::process::{Command, Stdio};

/// Starts the program again without a console, if it has one. Returns whether it was started, and this one can end.
pub fn leave() -> bool {
    /// <https://learn.microsoft.com/windows/win32/procthread/process-creation-flags>
    const DETACHED_PROCESS: u32 = 0x0000_0008;
    // Redirected output stays redirected.
    if !(std::io::stdout().is_terminal() && std::io::stderr().is_terminal()) {
        return false;
    }
    std::env::current_exe()
        .and_then(|program| {
            Command::new(program)
                .stdin(Stdio::null())
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .creation_flags(DETACHED_PROCESS)
                .spawn()
        })
        .is_ok()
}
