//! What the program costs, part by part: each crate, each module of ours, each font.
//!
//! An estimate. A compressor looks at everything at once; here the code, the fonts, the other data and the rest are compressed one by
//! one, the code is divided by the bytes of its functions, and all of it is scaled so that the sum is what the whole program has.

use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};

use super::module::{CODE, DATA, functions, sections};
use super::owner::owner;
use crate::compress;
use crate::files::collect_files;
use crate::step::{root, target};

/// A line: bytes as they are, bytes with brotli, and what has them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Line {
    pub(super) raw: u64,
    pub(super) brotli: u64,
    pub(super) what: String,
}

/// The bill for `program`, which has `brotli` bytes with brotli, the largest first. `names` are those of its functions in their order.
pub(super) fn bill(program: &[u8], brotli: u64, names: &[&str]) -> Result<Vec<Line>, String> {
    let parts = parts(program)?;
    let sizes = compressed(&parts)?;
    let by_owner = by_owner(program, names)?;
    let mut lines = Vec::new();
    for (part, [raw, _, small]) in parts.iter().zip(sizes) {
        if part.what == CODE_NAME {
            let all: u64 = by_owner.values().sum();
            lines.extend(by_owner.iter().map(|(what, &raw)| Line {
                raw,
                brotli: scaled(raw, small, all),
                what: what.clone(),
            }));
        } else {
            lines.push(Line {
                raw,
                brotli: small,
                what: part.what.clone(),
            });
        }
    }
    Ok(scaled_to(lines, brotli))
}

/// `lines` with their sum scaled to `brotli`, the largest first.
fn scaled_to(mut lines: Vec<Line>, brotli: u64) -> Vec<Line> {
    let sum: u64 = lines.iter().map(|line| line.brotli).sum();
    for line in &mut lines {
        line.brotli = scaled(line.brotli, brotli, sum);
    }
    lines.sort_by(|a, b| b.brotli.cmp(&a.brotli).then_with(|| a.what.cmp(&b.what)));
    lines
}

/// `number` · `to` / `from`
fn scaled(number: u64, to: u64, from: u64) -> u64 {
    number.saturating_mul(to).checked_div(from).unwrap_or(0)
}

const CODE_NAME: &str = "code";

/// What is compressed by itself.
struct Part {
    what: String,
    content: Vec<u8>,
}

/// The code, each font, the other data, and the rest of `program`.
fn parts(program: &[u8]) -> Result<Vec<Part>, String> {
    let mut parts = Vec::new();
    let mut rest = Vec::new();
    for (id, content) in sections(program).ok_or("The program is no WebAssembly file.")? {
        match id {
            CODE => parts.push(Part {
                what: CODE_NAME.to_owned(),
                content: content.to_vec(),
            }),
            DATA => parts.extend(data(content, &fonts()?)),
            _ => rest.extend(content),
        }
    }
    parts.push(Part {
        what: "imports, types and tables of the module".to_owned(),
        content: rest,
    });
    Ok(parts)
}

/// The fonts in `data`, and what else is in it.
fn data(data: &[u8], fonts: &[(String, Vec<u8>)]) -> Vec<Part> {
    let mut other = data.to_vec();
    let mut parts = Vec::new();
    for (name, font) in fonts {
        let at = other.windows(font.len().max(1)).position(|window| window == font.as_slice());
        if let Some(at) = at {
            let found: Vec<u8> = other.splice(at..at + font.len(), []).collect();
            parts.push(Part {
                what: format!("font {name}"),
                content: found,
            });
        }
    }
    parts.push(Part {
        what: "texts and tables of all crates".to_owned(),
        content: other,
    });
    parts
}

fn fonts() -> Result<Vec<(String, Vec<u8>)>, String> {
    let mut files = Vec::new();
    collect_files(&root().join("assets/fonts"), &mut files).map_err(|error| format!("assets/fonts cannot be read: {error}."))?;
    files.sort();
    let fonts = files
        .iter()
        .filter(|file| file.extension().is_some_and(|extension| extension == "ttf"));
    let read = |file: &PathBuf| {
        let name = file.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        fs::read(file)
            .map(|content| (name, content))
            .map_err(|error| format!("{} cannot be read: {error}.", file.display()))
    };
    fonts.map(read).collect()
}

/// The sizes of each part.
fn compressed(parts: &[Part]) -> Result<Vec<compress::Sizes>, String> {
    let folder = target().join("size");
    let write = |(at, part): (usize, &Part)| -> std::io::Result<PathBuf> {
        let file = folder.join(at.to_string());
        fs::write(&file, &part.content)?;
        Ok(file)
    };
    let files: std::io::Result<Vec<PathBuf>> = fs::create_dir_all(&folder).and_then(|()| parts.iter().enumerate().map(write).collect());
    compress::sizes(&files.map_err(|error| format!("{} cannot be written: {error}.", folder.display()))?)
}

/// The bytes of the functions of each owner.
fn by_owner(program: &[u8], names: &[&str]) -> Result<BTreeMap<String, u64>, String> {
    let sections = sections(program).unwrap_or_default();
    let code = sections
        .iter()
        .find(|(id, _)| *id == CODE)
        .map(|(_, content)| *content)
        .unwrap_or_default();
    let sizes = functions(code).unwrap_or_default();
    if sizes.len() != names.len() {
        return Err(format!("The program has {} functions, but {} names.", sizes.len(), names.len()));
    }
    let mut by_owner = BTreeMap::new();
    for (name, size) in names.iter().zip(sizes) {
        *by_owner.entry(owner(name)).or_default() += u64::try_from(size).unwrap_or(0);
    }
    Ok(by_owner)
}

/// The names of the functions of `program`, a line each, where the last build on this computer was of it.
pub(super) fn names_of(program: &[u8]) -> Option<String> {
    let mut files = Vec::new();
    collect_files(&target().join("wasm-bindgen"), &mut files).ok()?;
    let is_it = |file: &&PathBuf| is_module(file) && fs::read(file).is_ok_and(|content| content == program);
    fs::read_to_string(files.iter().find(is_it)?.with_extension("names")).ok()
}

fn is_module(file: &Path) -> bool {
    file.extension().is_some_and(|extension| extension == "wasm")
}

#[cfg(test)]
mod tests {
    use super::{Line, by_owner, data, scaled_to};

    fn line(brotli: u64, what: &str) -> Line {
        Line {
            raw: 0,
            brotli,
            what: what.to_owned(),
        }
    }

    #[test]
    fn the_sum_is_that_of_the_program_and_the_largest_comes_first() {
        let lines = scaled_to(vec![line(10, "b"), line(10, "a"), line(80, "c")], 50);
        assert_eq!(lines, [line(40, "c"), line(5, "a"), line(5, "b")]);
    }

    #[test]
    fn fonts_are_told_from_the_other_data() {
        let fonts = [("Inter".to_owned(), vec![1, 2, 3]), ("Other".to_owned(), vec![9])];
        let parts = data(&[7, 1, 2, 3, 8], &fonts);
        let parts: Vec<(&str, &[u8])> = parts.iter().map(|part| (part.what.as_str(), part.content.as_slice())).collect();
        assert_eq!(
            parts,
            [("font Inter", [1, 2, 3].as_slice()), ("texts and tables of all crates", &[7, 8])]
        );
    }

    #[test]
    fn the_bytes_of_functions_are_added_up_by_whose_they_are() {
        let program = [b"\0asm\x01\0\0\0".as_slice(), &[10, 8, 2, 3, 0, 1, 11, 2, 0, 11]].concat();
        let bytes = by_owner(&program, &["egui::a", "egui::b"]).unwrap_or_default();
        assert_eq!(bytes.into_iter().collect::<Vec<_>>(), [("egui".to_owned(), 7)]);
        assert!(by_owner(&program, &["egui::a"]).is_err());
    }
}
