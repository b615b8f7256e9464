//! `completions`: the script that makes a shell complete the command line.

use super::arguments::{Cli, NAME};
use clap::CommandFactory;
use clap_complete::Shell;

/// The script that makes `shell` complete the command line.
pub(super) fn script(shell: Shell) -> String {
    let mut script = Vec::new();
    clap_complete::generate(shell, &mut Cli::command(), NAME, &mut script);
    // For bash clap writes the hyphen of the name in two ways, so that nothing behind a command is completed:
    // https://github.com/clap-rs/clap/issues/6421
    String::from_utf8_lossy(&script).replace("depth__subcmd__calculator", "depth__calculator")
}
