//! No file imports, by whatever way round, a file that imports it.
//!
//! The edges lead from file to file, in one crate. A file leads to every other one that defines an item which it names: in a `use`,
//! or by a path such as `crate::a::b`, `super::b` or `child::b`. Names are followed through what modules re-export to where the item
//! is defined, so neither `mod child;` nor `pub use child::Item;` leads to the child, and naming a module alone leads nowhere. What
//! only tests import does not count. A method leads nowhere either: it has no path.

use std::collections::BTreeMap;
use std::path::Path;

use super::circles::{Graph, circles as in_graph};
use super::modules::{Crate, Import, Words};

/// How many re-exports are followed: a circle of them has no end.
const MOST_STEPS: u8 = 20;

/// The circles in the crate whose first file is `target`, a paragraph each. Paths are shown as seen from `root`.
pub(super) fn circles(target: &Path, root: &Path) -> Result<Vec<String>, String> {
    Ok(of_crate(&Crate::read(target)?, root))
}

fn of_crate(krate: &Crate, root: &Path) -> Vec<String> {
    let edges = edges(krate);
    let mut graph = Graph::new();
    for &(from, to) in edges.keys() {
        graph.entry(from).or_default().insert(to);
    }
    in_graph(&graph)
        .iter()
        .map(|circle| paragraph(krate, &edges, circle, root))
        .collect()
}

/// `a -> b -> a`, and below it the lines that say so.
fn paragraph(krate: &Crate, edges: &Edges, circle: &[usize], root: &Path) -> String {
    let name = |file: usize| {
        let path = krate.files.get(file).map(|file| file.strip_prefix(root).unwrap_or(file));
        path.map(|path| path.display().to_string().replace('\\', "/")).unwrap_or_default()
    };
    let closed = || circle.iter().chain(circle.first()).copied();
    let way: Vec<String> = closed().map(name).collect();
    let steps = closed().zip(closed().skip(1));
    let reasons = steps.filter_map(|(from, to)| {
        let (line, path) = edges.get(&(from, to))?;
        Some(format!("\n    {}:{line} names {path}", name(from)))
    });
    format!("Imports in a circle: {}{}", way.join(" -> "), reasons.collect::<String>())
}

/// From file to file, and the first line and path that says so.
type Edges = BTreeMap<(usize, usize), (usize, String)>;

fn edges(krate: &Crate) -> Edges {
    let mut edges = Edges::new();
    for (place, module) in &krate.modules {
        let imports = module.imports.iter().filter(|import| !import.is_public);
        let imports = imports.map(|import| (&import.path, import.line, import.name.is_none()));
        let mentions = module.mentions.iter().map(|mention| (&mention.path, mention.line, false));
        for (path, line, is_glob) in imports.chain(mentions) {
            let file = match resolve(krate, place, path, MOST_STEPS) {
                Some(Found::Item(file)) => Some(file),
                // Everything in a module: at least what it defines.
                Some(Found::Module(path)) if is_glob => krate.modules.get(&path).map(|module| module.file),
                _ => None,
            };
            if let Some(file) = file.filter(|&file| file != module.file) {
                edges.entry((module.file, file)).or_insert_with(|| (line, path.join("::")));
            }
        }
    }
    edges
}

/// What a path leads to.
enum Found {
    /// An item that is defined in this file.
    Item(usize),
    /// The module with this path.
    Module(Words),
    /// Something of another crate.
    Outside,
}

/// What `path` is in the module at `place`; `None` where its first word is no name there.
fn resolve(krate: &Crate, place: &[String], path: &[String], steps: u8) -> Option<Found> {
    let steps = steps.checked_sub(1)?;
    let (first, rest) = path.split_first()?;
    match first.as_str() {
        "crate" => inside(krate, &[], rest, steps).or_else(|| unknown(krate, &[])),
        "self" => inside(krate, place, rest, steps).or_else(|| unknown(krate, place)),
        "super" => {
            let (_, parent) = place.split_last()?;
            // `super::super::a` is `super::a` of the parent.
            if rest.first().is_some_and(|next| next == "super") {
                resolve(krate, parent, rest, steps)
            } else {
                inside(krate, parent, rest, steps).or_else(|| unknown(krate, parent))
            }
        }
        _ => inside(krate, place, path, steps),
    }
}

/// A name that the module at `place` must have, and that cannot be seen in it: a macro makes it, or it is of another crate of
/// which everything is imported.
fn unknown(krate: &Crate, place: &[String]) -> Option<Found> {
    let module = krate.modules.get(place)?;
    let is_glob = |import: &&Import| import.name.is_none();
    let foreign = module
        .imports
        .iter()
        .filter(is_glob)
        .any(|import| is_foreign(krate, place, &import.path));
    Some(if foreign { Found::Outside } else { Found::Item(module.file) })
}

fn is_foreign(krate: &Crate, place: &[String], path: &[String]) -> bool {
    matches!(resolve(krate, place, path, MOST_STEPS), None | Some(Found::Outside))
}

/// What `path` is, counted from the inside of the module at `place`; `None` where its first word is no name there.
fn inside(krate: &Crate, place: &[String], path: &[String], steps: u8) -> Option<Found> {
    let module = krate.modules.get(place)?;
    let Some((first, rest)) = path.split_first() else {
        return Some(Found::Module(place.to_vec()));
    };
    let child = || {
        let child: Words = place.iter().chain([first]).cloned().collect();
        let is_there = module.children.contains(first);
        is_there
            .then(|| inside(krate, &child, rest, steps).or_else(|| unknown(krate, &child)))
            .flatten()
    };
    let item = || module.items.contains(first).then_some(Found::Item(module.file));
    let imported = || imported(krate, place, path, steps);
    // A module and a function may have the same name: the last word is the function, any other one is the module.
    if rest.is_empty() {
        item().or_else(imported).or_else(child)
    } else {
        child().or_else(item).or_else(imported)
    }
}

/// What `path` is by one of the imports of the module at `place`.
fn imported(krate: &Crate, place: &[String], path: &[String], steps: u8) -> Option<Found> {
    let module = krate.modules.get(place)?;
    let (first, rest) = path.split_first()?;
    if let Some(import) = module.imports.iter().find(|import| import.name.as_ref() == Some(first)) {
        let whole: Words = import.path.iter().chain(rest).cloned().collect();
        return Some(resolve(krate, place, &whole, steps).unwrap_or(Found::Outside));
    }
    let globs = module.imports.iter().filter(|import| import.name.is_none());
    globs
        .into_iter()
        .find_map(|import| match resolve(krate, place, &import.path, steps)? {
            Found::Module(of) if of != place => inside(krate, &of, path, steps.checked_sub(1)?),
            _ => None,
        })
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{Crate, of_crate};
    use std::fs;
    use std::path::Path;

    /// The first lines of the circles in a crate of these files, of which the first is its root.
    fn circles(test: &str, files: &[(&str, &str)]) -> Vec<String> {
        let folder = std::env::temp_dir().join(format!("depth-calculator-imports-{}-{test}", std::process::id()));
        for (name, text) in files {
            let file = folder.join(name);
            fs::create_dir_all(file.parent().unwrap()).unwrap();
            fs::write(file, text).unwrap();
        }
        let krate = Crate::read(&folder.join(files.first().unwrap().0));
        fs::remove_dir_all(&folder).unwrap();
        let found = of_crate(&krate.unwrap(), &folder);
        found
            .iter()
            .map(|circle| circle.lines().next().unwrap().replace("Imports in a circle: ", ""))
            .collect()
    }

    #[test]
    fn siblings_that_import_each_other_are_a_circle_and_the_lines_are_named() {
        let files = [
            ("lib.rs", "mod a; mod b; mod c;"),
            ("a.rs", "use crate::b::B; pub struct A;"),
            ("b.rs", "pub struct B;\nfn f() { let c = super::c::C { x: [1, 2] }; }"),
            ("c.rs", "use super::{a::{self, A as Other}, b}; pub struct C;"),
        ];
        assert_eq!(circles("siblings", &files), ["a.rs -> b.rs -> c.rs -> a.rs"]);
        let krate = Crate {
            files: vec!["/x/a.rs".into(), "/x/b.rs".into()],
            ..Crate::default()
        };
        let edges = [((0, 1), (3, "crate::b::B".to_owned())), ((1, 0), (4, "super::a::A".to_owned()))].into();
        let paragraph = super::paragraph(&krate, &edges, &[0, 1], Path::new("/x"));
        assert_eq!(
            paragraph,
            "Imports in a circle: a.rs -> b.rs -> a.rs\n    a.rs:3 names crate::b::B\n    b.rs:4 names super::a::A"
        );
    }

    #[test]
    fn a_child_may_use_its_parent_or_the_parent_its_child_but_not_both() {
        let parent_uses = ("p/mod.rs", "mod child; pub struct P; fn f() { child::g(); }");
        let parent_only_declares = ("p/mod.rs", "mod child; pub use child::g; pub struct P;");
        let child_uses = ("p/child.rs", "use super::P; pub fn g() {}");
        let child_alone = ("p/child.rs", "pub fn g() {}");
        let lib = ("lib.rs", "mod p;");
        let none: Vec<String> = Vec::new();
        assert_eq!(
            circles("both", &[lib, parent_uses, child_uses]),
            ["p/mod.rs -> p/child.rs -> p/mod.rs"]
        );
        assert_eq!(circles("child", &[lib, parent_only_declares, child_uses]), none);
        assert_eq!(circles("parent", &[lib, parent_uses, child_alone]), none);
    }

    #[test]
    fn re_exports_are_followed_to_where_the_item_is() {
        let files = [
            ("lib.rs", "mod p;"),
            ("p/mod.rs", "mod a; mod b; pub use a::A; pub use b::*;"),
            ("p/a.rs", "use super::B; pub struct A;"),
            ("p/b.rs", "use crate::p::A; pub struct B;"),
        ];
        assert_eq!(circles("re-exports", &files), ["p/a.rs -> p/b.rs -> p/a.rs"]);
        // A function with the name of its module.
        let same_name = [
            ("lib.rs", "mod a; mod b; use a::a;"),
            ("a.rs", "use crate::b; pub fn a() { b::f(); }"),
            ("b.rs", "pub fn f() {}"),
        ];
        assert_eq!(circles("same-name", &same_name), Vec::<String>::new());
    }

    #[test]
    fn modules_that_are_only_named_other_crates_and_tests_are_no_circle() {
        let files = [
            ("lib.rs", "mod a; mod b; pub use other as outside; use std::fmt;"),
            ("a.rs", "use crate::b; use ::b::B; use crate::outside::b; pub struct A;"),
            (
                "b.rs",
                "use crate::a::A; use fmt::a; #[cfg(test)] mod tests { use crate::a::A; } #[cfg(test)] mod more;",
            ),
        ];
        assert_eq!(circles("no-circle", &files), Vec::<String>::new());
    }

    #[test]
    fn modules_inside_a_file_belong_to_it_and_macros_are_read() {
        let files = [
            ("lib.rs", "mod a; mod b;"),
            ("a.rs", "pub mod inner { use super::super::b::B; pub struct I; }"),
            ("b.rs", "pub struct B; fn f() { println!(\"{:?}\", crate::a::inner::I); }"),
        ];
        assert_eq!(circles("inline", &files), ["a.rs -> b.rs -> a.rs"]);
    }
}
