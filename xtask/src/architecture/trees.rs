//! What the crates at the bottom are compiled with, in `cargo tree`: nothing heavy comes in through a dependency.

use super::crates::exists;
use crate::step::{cargo, output};

/// Serde and what it needs.
const SERDE: &[&str] = &[
    "serde",
    "serde_core",
    "serde_derive",
    "proc-macro2",
    "quote",
    "syn",
    "unicode-ident",
];
/// What belongs to the window.
const EGUI: &[&str] = &["egui", "eframe", "epaint", "emath", "ecolor", "accesskit"];

/// The crates in the trees of depth-core and depth-text that may not be there.
pub(super) fn unplanned() -> Result<Vec<String>, String> {
    let mut broken = Vec::new();
    if exists("depth-core") {
        broken.extend(core(&tree("depth-core", "--all-features")?, SERDE));
        broken.extend(core(&tree("depth-core", "--no-default-features")?, &[]));
    }
    if exists("depth-text") {
        broken.extend(text(&tree("depth-text", "--all-features")?));
    }
    Ok(broken)
}

/// The names of the crates that `package` is compiled with, itself first, on any platform.
fn tree(package: &str, features: &str) -> Result<Vec<String>, String> {
    let arguments = [
        "tree", "--locked", "--edges", "normal", "--target", "all", "--prefix", "none", "--format", "{p}",
    ];
    let printed = output(cargo(&arguments).args(["--package", package, features])).ok_or("`cargo tree` failed.")?;
    Ok(names(&printed))
}

fn names(printed: &str) -> Vec<String> {
    let mut names: Vec<String> = printed
        .lines()
        .filter_map(|line| line.split(' ').next())
        .map(str::to_owned)
        .collect();
    names.sort();
    names.dedup();
    names.retain(|name| !name.is_empty());
    names
}

fn core(names: &[String], planned: &[&str]) -> Vec<String> {
    let others = names
        .iter()
        .filter(|name| *name != "depth-core" && !planned.contains(&name.as_str()));
    others
        .map(|name| format!("depth-core is compiled with {name}: only serde may be, and only where it is asked for."))
        .collect()
}

fn text(names: &[String]) -> Vec<String> {
    let of_window = |name: &&String| EGUI.iter().any(|egui| name.starts_with(egui));
    names
        .iter()
        .filter(of_window)
        .map(|name| format!("depth-text is compiled with {name}, which belongs to the window."))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::{SERDE, core, names, text};

    const TREE: &str = "depth-core v0.1.0 (/somewhere/crates/depth-core)\nserde v1.0.228\nserde_derive v1.0.228 (proc-macro)\n\
        syn v2.0.117\nserde_core v1.0.228 (*)\n";

    #[test]
    fn only_serde_may_be_below_the_mathematics() {
        assert_eq!(core(&names(TREE), SERDE), Vec::<String>::new());
        let more = names(&format!("{TREE}log v0.4.28\n"));
        assert_eq!(
            core(&more, SERDE),
            ["depth-core is compiled with log: only serde may be, and only where it is asked for."]
        );
    }

    #[test]
    fn without_features_the_mathematics_stand_alone() {
        assert_eq!(core(&names("depth-core v0.1.0\n"), &[]), Vec::<String>::new());
        assert_eq!(core(&names(TREE), &[]).len(), 4);
    }

    #[test]
    fn texts_are_compiled_without_the_window() {
        assert_eq!(
            text(&names("depth-text v0.1.0\ndepth-core v0.1.0\nserde v1.0.228\n")),
            Vec::<String>::new()
        );
        assert_eq!(
            text(&names("depth-text v0.1.0\negui_plot v0.38.0\n")),
            ["depth-text is compiled with egui_plot, which belongs to the window."]
        );
    }
}
