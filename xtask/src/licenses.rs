//! `cargo xtask licenses`: what the licenses of others ask to be passed on, as assets/licenses.txt. The window and the archives
//! show that file, the page links to it; `cargo xtask check` says when it is no longer true.

use serde_json::Value;
use spdx::{Expression, LicenseReq, Licensee};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use crate::platforms;
use crate::step::{cargo, output, root};

const FILE: &str = "assets/licenses.txt";

/// Of several licenses that a crate offers, the first of these is taken: those first whose text is the same for all.
const PREFERRED: &[&str] = &[
    "Apache-2.0",
    "Zlib",
    "0BSD",
    "MIT-0",
    "BSL-1.0",
    "CC0-1.0",
    "Unlicense",
    "MIT",
    "ISC",
    "BSD-2-Clause",
    "BSD-3-Clause",
    "Unicode-3.0",
    "MPL-2.0",
    "OFL-1.1",
    "LicenseRef-UFL-1.0",
    "Ubuntu-font-1.0",
];
/// These name whoever holds the copyright, so that each crate's own file counts.
const NAMES_A_HOLDER: &[&str] = &["MIT", "ISC", "BSD-2-Clause", "BSD-3-Clause", "Zlib", "0BSD", "Unicode-3.0"];

/// Font, license, and the file with its text.
const FONTS: &[(&str, &str, &str)] = &[
    (
        "Inter (a part of its characters)",
        "SIL Open Font License 1.1",
        "assets/fonts/OFL.txt",
    ),
    (
        "DejaVu Sans (a part of its characters)",
        "Bitstream Vera License",
        "assets/fonts/DejaVu-LICENSE.txt",
    ),
];
/// No line of the file is longer, so that a window can show one in each row.
const WIDTH: usize = 100;

/// A crate that becomes part of the program.
struct Crate {
    name: String,
    version: String,
    expression: String,
    authors: String,
    folder: PathBuf,
}

/// Writes the file.
pub(crate) fn write() -> Result<(), String> {
    fs::write(root().join(FILE), text()?).map_err(|error| format!("{FILE} cannot be written: {error}."))?;
    println!("{FILE} is written.");
    Ok(())
}

/// Err: a sentence, where the file is not what [`write()`] would write.
pub(crate) fn check() -> Result<(), String> {
    // A checkout on Windows may have other ends of lines.
    let kept = fs::read_to_string(root().join(FILE)).unwrap_or_default().replace("\r\n", "\n");
    if kept == text()? {
        Ok(())
    } else {
        Err(format!("{FILE} is out of date: run `cargo xtask licenses` and commit it."))
    }
}

fn text() -> Result<String, String> {
    let crates = linked_crates()?;
    let mut texts: BTreeMap<(&str, String), Vec<&Crate>> = BTreeMap::new();
    for one in &crates {
        for license in chosen(one)? {
            let text = license_text(one, license)?;
            texts.entry((license, text)).or_default().push(one);
        }
        if let Some(notice) = own_file(one, &["NOTICE"], |_| true) {
            texts.entry(("Notice", notice)).or_default().push(one);
        }
    }
    let mut out = String::from(
        "Depth Calculator is licensed under MIT or Apache-2.0, at your option.\n\
         What follows is by others and part of the program: fonts, and the crates it is built from.\n\nFonts\n",
    );
    for (font, license, _) in FONTS {
        out.push_str(&format!("  {font}: {license}\n"));
    }
    out.push_str("\nCrates, with the license that they are used under\n");
    for one in &crates {
        out.push_str(&format!("  {} {}: {}\n", one.name, one.version, chosen(one)?.join(" and ")));
    }
    for ((license, text), of) in &texts {
        let names: Vec<String> = of.iter().map(|one| format!("{} {}", one.name, one.version)).collect();
        section(&mut out, license, &names.join(", "), text);
    }
    for (font, license, file) in FONTS {
        section(&mut out, license, font, &read(&root().join(file))?);
    }
    Ok(out)
}

fn section(out: &mut String, license: &str, of: &str, text: &str) {
    let (double, single) = ("=".repeat(WIDTH), "-".repeat(WIDTH));
    out.push_str(&format!("\n{double}\n{license}\n{}{single}\n\n", wrapped(&format!("  {of}"))));
    for line in text.trim().lines() {
        out.push_str(&wrapped(line));
    }
}

/// `line` in lines of at most [`WIDTH`] characters, which begin as it does.
fn wrapped(line: &str) -> String {
    let indent: String = line.chars().take_while(|c| *c == ' ').collect();
    let mut lines = vec![indent.clone()];
    for word in line.split(' ').skip(indent.len()) {
        let last = lines.last_mut().map(|last| (last.trim().is_empty(), last));
        match last {
            Some((is_empty, last)) if is_empty || last.chars().count() + 1 + word.chars().count() <= WIDTH => {
                if !is_empty {
                    last.push(' ');
                }
                last.push_str(word);
            }
            _ => lines.push(format!("{indent}{word}")),
        }
    }
    lines.iter().map(|line| format!("{}\n", line.trim_end())).collect()
}

/// The crates that the desktop programs and the page are linked from, in the order of their names.
fn linked_crates() -> Result<Vec<Crate>, String> {
    let mut crates = BTreeMap::new();
    for platform in platforms::ALL {
        let arguments = ["metadata", "--format-version", "1", "--locked", "--filter-platform", platform];
        let text = output(&mut cargo(&arguments)).ok_or("`cargo metadata` failed.")?;
        let metadata: Value = serde_json::from_str(&text).map_err(|error| format!("`cargo metadata` cannot be parsed: {error}."))?;
        let linked = linked(platform)?;
        let names = packages(&metadata).map(|one| ((one.name.clone(), one.version.clone()), one));
        crates.extend(names.filter(|(name, _)| linked.contains(name)));
    }
    Ok(crates.into_values().collect())
}

fn list<'a>(value: &'a Value, key: &str) -> impl Iterator<Item = &'a Value> {
    value.get(key).and_then(Value::as_array).into_iter().flatten()
}

fn string(value: &Value, key: &str) -> String {
    value.get(key).and_then(Value::as_str).unwrap_or_default().to_owned()
}

/// Names and versions of what the program is linked from on one platform. `cargo metadata` does not know: it turns on every
/// feature that tests need.
fn linked(platform: &str) -> Result<BTreeSet<(String, String)>, String> {
    let program = ["tree", "--locked", "--package", "depth-calculator", "--target", platform];
    let format = ["--edges", "normal", "--prefix", "none", "--format", "{p}"];
    let text = output(cargo(&program).args(format)).ok_or("`cargo tree` failed.")?;
    let name = |line: &str| {
        let mut words = line.split_whitespace();
        Some((words.next()?.to_owned(), words.next()?.strip_prefix('v')?.to_owned()))
    };
    Ok(text.lines().filter_map(name).collect())
}

/// The crates of others.
fn packages(metadata: &Value) -> impl Iterator<Item = Crate> {
    let is_ours = |package: &Value| package.get("source").is_none_or(Value::is_null);
    list(metadata, "packages")
        .filter(move |package| !is_ours(package))
        .map(|package| Crate {
            name: string(package, "name"),
            version: string(package, "version"),
            expression: string(package, "license"),
            authors: list(package, "authors").filter_map(Value::as_str).collect::<Vec<_>>().join(", "),
            folder: Path::new(&string(package, "manifest_path"))
                .parent()
                .map(Path::to_path_buf)
                .unwrap_or_default(),
        })
}

/// The licenses that a crate is used under.
fn chosen(one: &Crate) -> Result<Vec<&'static str>, String> {
    let wrong = |reason: &dyn std::fmt::Display| format!("The license \"{}\" of {} cannot be used: {reason}.", one.expression, one.name);
    let mode = spdx::ParseMode::LAX;
    let expression = Expression::parse_mode(&one.expression, mode).map_err(|error| wrong(&error.reason))?;
    let preferred: Vec<Licensee> = PREFERRED.iter().filter_map(|name| Licensee::parse(name).ok()).collect();
    let requirements = expression.minimized_requirements(&preferred).map_err(|error| wrong(&error))?;
    let name = |requirement: &LicenseReq| {
        let id = requirement.license.id()?;
        PREFERRED.iter().find(|name| **name == id.name).copied()
    };
    requirements
        .iter()
        .map(|requirement| name(requirement).ok_or_else(|| wrong(&"it is not in the list")))
        .collect()
}

/// The text of `license` that has to be passed on for this crate.
fn license_text(one: &Crate, license: &'static str) -> Result<String, String> {
    if NAMES_A_HOLDER.contains(&license)
        && let Some(own) = own_text(one, license)
    {
        return Ok(own);
    }
    let standard = spdx::license_id(license).map(|id| id.text().to_owned());
    let standard = standard.ok_or_else(|| format!("There is no text of {license}, the license of {}.", one.name))?;
    let holder = if one.authors.is_empty() {
        format!("the authors of {}", one.name)
    } else {
        one.authors.clone()
    };
    Ok(if NAMES_A_HOLDER.contains(&license) {
        format!("Copyright (c) {holder}\n\n{standard}")
    } else {
        standard
    })
}

/// The crate's own file with the text of `license`.
fn own_text(one: &Crate, license: &str) -> Option<String> {
    let words = match license {
        "MIT" => "Permission is hereby granted, free of charge",
        "ISC" | "0BSD" => "Permission to use, copy, modify, and",
        "Zlib" => "This software is provided 'as-is'",
        "Unicode-3.0" => "UNICODE LICENSE V3",
        _ => "Redistribution and use in source and binary forms",
    };
    let normal = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    own_file(one, &["LICENSE", "LICENCE", "COPYING", "COPYRIGHT"], |text| {
        normal(text).contains(words)
    })
}

/// The first of the crate's own files whose name starts with one of `names` and whose text will do.
fn own_file(one: &Crate, names: &[&str], will_do: impl Fn(&str) -> bool) -> Option<String> {
    let mut files: Vec<PathBuf> = fs::read_dir(&one.folder).ok()?.flatten().map(|entry| entry.path()).collect();
    files.sort();
    let is_named = |file: &&PathBuf| {
        let name = file
            .file_name()
            .map(|name| name.to_string_lossy().to_ascii_uppercase())
            .unwrap_or_default();
        names.iter().any(|start| name.starts_with(start))
    };
    let texts = files.iter().filter(is_named).filter_map(|file| read(file).ok());
    texts.into_iter().find(|text| will_do(text))
}

fn read(file: &Path) -> Result<String, String> {
    let bytes = fs::read(file).map_err(|error| format!("{} cannot be read: {error}.", file.display()))?;
    let text = String::from_utf8_lossy(&bytes);
    // One form for all, so that equal texts are equal and no line depends on where a file was written.
    let lines: Vec<&str> = text.trim_start_matches('\u{feff}').lines().map(str::trim_end).collect();
    Ok(lines.join("\n").trim().to_owned())
}

#[cfg(test)]
mod tests {
    use super::{Crate, WIDTH, chosen, wrapped};
    use std::path::PathBuf;

    fn licensed(expression: &str) -> Result<Vec<&'static str>, String> {
        chosen(&Crate {
            name: "one".into(),
            version: "1.0.0".into(),
            expression: expression.into(),
            authors: String::new(),
            folder: PathBuf::new(),
        })
    }

    #[test]
    fn of_several_licenses_the_one_with_the_shared_text_is_taken() {
        assert_eq!(licensed("MIT OR Apache-2.0").as_deref(), Ok(["Apache-2.0"].as_slice()));
        assert_eq!(licensed("MIT/Apache-2.0").as_deref(), Ok(["Apache-2.0"].as_slice()));
        assert_eq!(licensed("(MIT OR Apache-2.0) AND Unicode-3.0").map(|names| names.len()), Ok(2));
    }

    #[test]
    fn a_license_that_may_not_be_used_is_refused_by_name() {
        let refusal = licensed("AGPL-3.0-only");
        assert!(
            refusal
                .as_ref()
                .is_err_and(|reason| reason.contains("AGPL-3.0-only") && reason.contains("one")),
            "{refusal:?}"
        );
    }

    #[test]
    fn long_lines_are_broken_between_words_and_short_ones_stay() {
        assert_eq!(wrapped("  a  b"), "  a  b\n");
        assert_eq!(wrapped(""), "\n");
        let broken = wrapped(&format!("  {}", "word ".repeat(50)));
        assert!(
            broken.lines().all(|line| line.len() <= WIDTH && line.starts_with("  word")),
            "{broken}"
        );
    }
}
