//! A crate of the workspace uses only those below it.

use serde_json::Value;

use crate::step::root;

/// Every crate of the workspace, and which of the others it may use, for itself, its tests and its build.
const MAY_USE: &[(&str, &[&str])] = &[
    // Random numbers and problems for the tests of the two below, which use it there only.
    ("depth-generators", &["depth-core"]),
    ("depth-core", &["depth-generators"]),
    ("depth-text", &["depth-core", "depth-generators"]),
    ("depth-figures", &["depth-core", "depth-text", "depth-generators"]),
    ("depth-files", &["depth-core"]),
    ("depth-vision", &["depth-core"]),
    ("depth-presets", &["depth-core"]),
    ("depth-jobs", &["depth-core", "depth-files", "depth-vision"]),
    ("egui-mirror", &[]),
    (
        "depth-calculator",
        &[
            "depth-core",
            "depth-text",
            "depth-figures",
            "depth-files",
            "depth-vision",
            "depth-presets",
            "depth-jobs",
            "egui-mirror",
        ],
    ),
    ("xtask", &[]),
    ("wasm-bindgen-tool", &[]),
];

/// Whether the crate `name` is there.
pub(super) fn exists(name: &str) -> bool {
    root().join("crates").join(name).join("Cargo.toml").is_file()
}

/// The dependencies that [`MAY_USE`] does not have, and the crates that it does not know, in `cargo metadata --no-deps`.
pub(super) fn upward(metadata: &Value) -> Vec<String> {
    let packages: Vec<&Value> = list(metadata, "packages").collect();
    let names: Vec<&str> = packages.iter().filter_map(|package| name(package)).collect();
    let mut broken = Vec::new();
    for package in &packages {
        let Some(user) = name(package) else { continue };
        let Some((_, may_use)) = MAY_USE.iter().find(|(known, _)| *known == user) else {
            broken.push(format!(
                "The crate {user} has no place in the architecture: give it one in xtask/src/architecture/crates.rs."
            ));
            continue;
        };
        let used = list(package, "dependencies").filter_map(name).filter(|used| names.contains(used));
        for used in used.filter(|used| !may_use.contains(used)) {
            broken.push(format!("The crate {user} uses {used}, which is not below it."));
        }
    }
    broken
}

fn list<'a>(value: &'a Value, key: &str) -> impl Iterator<Item = &'a Value> {
    value.get(key).and_then(Value::as_array).into_iter().flatten()
}

fn name(value: &Value) -> Option<&str> {
    value.get("name")?.as_str()
}

#[cfg(test)]
mod tests {
    use super::upward;
    use serde_json::{Value, json};

    /// What cargo says of crates and the dependencies of each.
    fn metadata(crates: &[(&str, &[&str])]) -> Value {
        let package = |(name, used): &(&str, &[&str])| {
            let dependencies: Vec<Value> = used.iter().map(|used| json!({ "name": used })).collect();
            json!({ "name": name, "dependencies": dependencies })
        };
        json!({ "packages": crates.iter().map(package).collect::<Vec<_>>() })
    }

    #[test]
    fn a_crate_may_use_what_is_below_it_and_crates_of_others() {
        let house: &[(&str, &[&str])] = &[
            ("depth-core", &["serde"]),
            ("depth-text", &["depth-core", "serde"]),
            ("egui-mirror", &["egui"]),
            ("depth-calculator", &["depth-core", "depth-text", "egui-mirror", "eframe"]),
            ("xtask", &["clap"]),
        ];
        assert_eq!(upward(&metadata(house)), Vec::<String>::new());
        assert_eq!(upward(&metadata(&[("depth-calculator", &["serde"])])), Vec::<String>::new());
    }

    #[test]
    fn a_crate_that_uses_one_above_or_beside_it_is_named() {
        let upside_down: &[(&str, &[&str])] = &[
            ("depth-core", &["depth-text"]),
            ("depth-text", &["depth-core"]),
            ("egui-mirror", &["depth-core"]),
        ];
        assert_eq!(
            upward(&metadata(upside_down)),
            [
                "The crate depth-core uses depth-text, which is not below it.",
                "The crate egui-mirror uses depth-core, which is not below it.",
            ]
        );
    }

    #[test]
    fn a_crate_without_a_place_is_refused() {
        let broken = upward(&metadata(&[("depth-clouds", &[])]));
        assert!(
            broken.first().is_some_and(|first| first.contains("depth-clouds has no place")),
            "{broken:?}"
        );
    }
}
