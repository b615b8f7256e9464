//! Whose a function is, by its name.

/// The crates of this workspace that can be a part of the page, as their names stand in code.
const OWN: &[&str] = &[
    "depth_calculator",
    "depth_core",
    "depth_text",
    "depth_files",
    "depth_vision",
    "depth_jobs",
    "egui_mirror",
];
/// What comes with Rust.
const STD: &[&str] = &["core", "alloc", "std", "compiler_builtins", "dlmalloc", "__rustc"];

const STD_NAME: &str = "Rust's standard library";
/// Closures are called through tables, by functions that do not say whose they are.
const CLOSURES: &str = "closures that do not say whose they are";
const NAMELESS: &str = "functions without a crate";

/// The crate that the function called `name` is of, and for one of this workspace the module: that of the first type or function in
/// the name that is not the standard library's.
pub(super) fn owner(name: &str) -> String {
    if name.contains("{{vtable.shim}}") {
        return CLOSURES.to_owned();
    }
    let paths = paths(name);
    let is_std = |path: &&Vec<&str>| path.first().is_some_and(|krate| STD.contains(krate));
    match paths.iter().find(|path| !is_std(path)).or(paths.first()) {
        Some(path) if is_std(&path) => STD_NAME.to_owned(),
        Some(path) => module(path),
        // `<&T as Debug>` and the like.
        None if name.starts_with('<') => STD_NAME.to_owned(),
        None => NAMELESS.to_owned(),
    }
}

/// The crate of a path, or for one of this workspace its module.
fn module(path: &[&str]) -> String {
    let is_own = path.first().is_some_and(|krate| OWN.contains(krate));
    let is_type = |word: &&str| word.starts_with(|c: char| c.is_uppercase());
    let end = path.iter().position(is_type).unwrap_or(path.len().saturating_sub(1));
    let modules = path.get(..end).unwrap_or_default();
    if is_own {
        modules.join("::")
    } else {
        path.first().copied().unwrap_or_default().to_owned()
    }
}

/// The paths of two words or more in a name, such as `a::b::C` twice in `<a::b::C as core::ops::Drop>::drop::h0123456789abcdef`
/// and the like, without closures and hashes.
fn paths(name: &str) -> Vec<Vec<&str>> {
    let is_of_path = |c: char| c.is_alphanumeric() || "_:[]{}#".contains(c);
    let mut paths = Vec::new();
    for part in name.split(|c| !is_of_path(c)) {
        let words = part.split("::").map(|word| word.split('[').next().unwrap_or(word));
        let words: Vec<&str> = words
            .filter(|word| !word.is_empty() && !word.contains('{') && !is_hash(word))
            .collect();
        // What goes on after a bracket, such as `::drop`, begins no path.
        if words.len() > 1 && !part.starts_with(':') {
            paths.push(words);
        }
    }
    paths
}

/// `h` and 16 digits.
fn is_hash(word: &str) -> bool {
    word.len() == 17
        && word
            .strip_prefix('h')
            .is_some_and(|digits| digits.chars().all(|c| c.is_ascii_hexdigit()))
}

#[cfg(test)]
mod tests {
    use super::{CLOSURES, NAMELESS, STD_NAME, owner};

    #[test]
    fn a_function_is_of_the_first_crate_in_its_name_that_does_not_come_with_rust() {
        for (name, expected) in [
            ("egui::context::Context::write::h6412b74b4cb45fcd", "egui"),
            (
                "<&mut serde_json::de::Deserializer<R> as serde_core::de::Deserializer>::deserialize_struct::h5383106a5c1f33f4",
                "serde_json",
            ),
            ("<T as egui::widgets::Widget>::ui::h5383106a5c1f33f4", "egui"),
            (
                "core::ptr::drop_in_place<alloc::vec::Vec<egui::shape::Shape>>::h5383106a5c1f33f4",
                "egui",
            ),
            ("<alloc[3ca501edff3f0c7c]::raw_vec::RawVec<u8>>::grow_one", STD_NAME),
            ("<&T as core::fmt::Debug>::fmt::h5383106a5c1f33f4", STD_NAME),
            ("<str>::to_lowercase", STD_NAME),
            ("core::ops::function::FnOnce::call_once{{vtable.shim}}::h5383106a5c1f33f4", CLOSURES),
            ("memcpy", NAMELESS),
            ("", NAMELESS),
        ] {
            assert_eq!(owner(name), expected, "{name}");
        }
    }

    #[test]
    fn a_function_of_ours_is_of_its_module() {
        for (name, expected) in [
            (
                "depth_calculator::platform::web::main::{{closure}}::h8f73dea87a45d11c",
                "depth_calculator::platform::web",
            ),
            (
                "<depth_calculator::app::App as eframe::epi::App>::ui::he3bd0c035dbb0d69",
                "depth_calculator::app",
            ),
            (
                "depth_core::problem::Problem::solve::{{closure}}::{{closure}}::hccad75024d8507e5",
                "depth_core::problem",
            ),
            (
                "core::ptr::drop_in_place<depth_text::report::Report>::h5383106a5c1f33f4",
                "depth_text::report",
            ),
        ] {
            assert_eq!(owner(name), expected, "{name}");
        }
    }
}
