//! Where a build comes from: the commit, which it names, and folders of the builder's computer, which it does not.

use std::path::PathBuf;

use crate::step::{command, output};

/// Where cargo keeps the crates.
pub(crate) fn cargo_home() -> Option<PathBuf> {
    let named = std::env::var_os("CARGO_HOME").map(PathBuf::from);
    named.or_else(|| Some(std::env::home_dir()?.join(".cargo")))
}

/// The flags that keep folders of this computer, and with them the name of whoever builds, out of the program's panic
/// messages: each is called by the word beside it. `None` where cargo would cut a folder in two at its space.
pub(crate) fn nameless(folders: &[(Option<PathBuf>, &str)]) -> Option<String> {
    let flags = folders.iter().filter_map(|(folder, word)| Some((folder.as_ref()?, word)));
    let flags: Vec<String> = flags
        .map(|(folder, word)| format!("--remap-path-prefix={}={word}", folder.display()))
        .collect();
    (!flags.iter().any(|flag| flag.contains(' '))).then(|| flags.join(" "))
}

/// The commit that is built, short; with a plus where files differ from it. `None` outside a repository.
pub(crate) fn commit() -> Option<String> {
    let git = |arguments: &[&str]| output(&mut command("git", arguments));
    let commit = git(&["rev-parse", "--short=12", "HEAD"])?;
    let changed = git(&["status", "--porcelain", "--untracked-files=no"]).is_some_and(|changes| !changes.is_empty());
    Some(if changed { format!("{commit}+") } else { commit })
}

/// When that commit was made, in seconds since 1970. `None` outside a repository.
pub(crate) fn commit_time() -> Option<String> {
    output(&mut command("git", &["log", "-1", "--format=%ct"]))
}
