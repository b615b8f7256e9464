//! What programs are given away for. A test compares the list with the two that Rust cannot share: deny.toml and the workflow that
//! makes a release.

/// The platforms, by the names that Rust has for them.
pub(crate) const ALL: &[&str] = &[
    "x86_64-unknown-linux-gnu",
    "aarch64-unknown-linux-gnu",
    "x86_64-pc-windows-msvc",
    "aarch64-apple-darwin",
    "x86_64-apple-darwin",
    WEB,
];

/// The page's.
pub(crate) const WEB: &str = "wasm32-unknown-unknown";

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{ALL, WEB};
    use crate::step::root;
    use std::collections::BTreeSet;
    use std::fs;

    fn read(file: &str) -> String {
        fs::read_to_string(root().join(file)).unwrap()
    }

    #[test]
    fn crates_are_checked_for_every_platform_and_no_other() {
        let settings = read("deny.toml");
        let list = settings.split_once("\ntargets = [").unwrap().1.split_once(']').unwrap().0;
        let checked: BTreeSet<&str> = list
            .lines()
            .filter_map(|line| line.trim().trim_end_matches(',').strip_prefix('"')?.strip_suffix('"'))
            .collect();
        assert_eq!(checked, ALL.iter().copied().collect());
    }

    #[test]
    fn a_release_has_a_program_for_every_platform_but_the_page() {
        let workflow = read(".github/workflows/release.yml");
        let built: BTreeSet<&str> = workflow
            .lines()
            .filter_map(|line| {
                line.trim()
                    .strip_prefix("- { system: ")?
                    .split_once(", target: ")?
                    .1
                    .strip_suffix(" }")
            })
            .collect();
        assert_eq!(built, ALL.iter().copied().filter(|platform| *platform != WEB).collect());
    }
}
