//! The pages that need no program have the colors of the program.
#![allow(clippy::unwrap_used, reason = "tests")]

use std::fs;

use crate::files::collect_files;
use crate::step::root;

/// The program's theme: one file, or a folder.
fn theme() -> String {
    let app = root().join("src/app");
    let mut files = vec![app.join("theme.rs")];
    collect_files(&app.join("theme"), &mut files).ok();
    files.iter().filter_map(|file| fs::read_to_string(file).ok()).collect()
}

/// The colors of a palette in the program's theme: its fields' names and `#rrggbb`.
fn palette(theme: &str, name: &str) -> Vec<(String, String)> {
    let (_, rest) = theme.split_once(&format!("const {name}: Palette = Palette {{")).unwrap();
    let fields = rest
        .split_once("};")
        .unwrap()
        .0
        .lines()
        .filter_map(|line| line.trim().split_once(": "));
    fields
        .map(|(field, value)| {
            let color = value.replace("Color32::WHITE", "ffffff").replace("Color32::from_rgb", "");
            let digits = color.replace("0x", "").replace(['(', ')', ',', ' '], "");
            (field.to_owned(), format!("#{digits}"))
        })
        .collect()
}

#[test]
fn the_pages_have_the_colors_of_the_program() {
    let theme = theme();
    for file in ["assets/web/learn.css", "assets/web/page.css"] {
        let style = fs::read_to_string(root().join(file)).unwrap();
        let (light, rest) = style.split_once("@media (prefers-color-scheme: dark)").unwrap();
        let dark = rest.split_once("\n}").unwrap().0;
        for (part, name) in [(light, "LIGHT"), (dark, "DARK")] {
            let palette = palette(&theme, name);
            let variables: Vec<(&str, &str)> = part
                .lines()
                .filter_map(|line| line.trim().strip_prefix("--")?.split_once(": "))
                .collect();
            assert!(variables.len() >= 6, "{file}");
            for (variable, color) in variables {
                let field = (variable.replace('-', "_"), color.trim_end_matches(';').to_owned());
                assert!(palette.contains(&field), "{file}, {name}: {field:?}");
            }
        }
    }
    let page = |name| palette(&theme, name).into_iter().find(|(field, _)| field == "page").unwrap().1;
    for file in ["index.html", "assets/web/learn.html"] {
        let html = fs::read_to_string(root().join(file)).unwrap();
        for (name, scheme) in [("LIGHT", "light"), ("DARK", "dark")] {
            let meta = format!(
                "<meta name=\"theme-color\" content=\"{}\" media=\"(prefers-color-scheme: {scheme})\">",
                page(name)
            );
            assert!(html.contains(&meta), "{file}: {meta}");
        }
    }
    let manifest = fs::read_to_string(root().join("assets/web/manifest.webmanifest")).unwrap();
    assert_eq!(manifest.matches(&page("LIGHT")).count(), 2);
}
