//! `cargo xtask size`: what a first visit downloads before the calculator can be used, and whether that is too much.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use crate::step::{command, output};

/// With brotli. At 10 Mbit/s that is 0.8 s.
const BUDGET: u64 = 1_000_000;

/// Prints the size of every file of the first visit to the page in `dist`, and what the program consists of.
/// Err: a sentence, where the files are larger than the budget.
pub(crate) fn check(dist: &Path) -> Result<(), String> {
    let files = first_load(dist)?;
    let sizes = sizes(dist, &files)?;

    println!(
        "\n{:>12} {:>12} {:>12}  file of the first visit",
        "bytes", "with gzip", "with brotli"
    );
    for ([raw, gzip, brotli], file) in sizes.iter().zip(&files) {
        println!("{raw:>12} {gzip:>12} {brotli:>12}  {file}");
    }
    let [raw, gzip, brotli] = sizes.iter().fold([0; 3], |[raw, gzip, brotli], file| {
        [raw + file[0], gzip + file[1], brotli + file[2]]
    });
    println!("{raw:>12} {gzip:>12} {brotli:>12}  together; at most {BUDGET} with brotli");

    for file in files.iter().filter(|file| is_program(file)) {
        let program = fs::read(dist.join(file)).map_err(|error| format!("dist/{file} cannot be read: {error}."))?;
        let parts = sections(&program).ok_or_else(|| format!("dist/{file} is no WebAssembly file."))?;
        println!("\n{:>12}  part of {file}", "bytes");
        for (name, bytes) in parts {
            println!("{bytes:>12}  {name}");
        }
    }
    if brotli > BUDGET {
        return Err(format!(
            "The first visit downloads {brotli} bytes with brotli, {} more than the budget of {BUDGET}.",
            brotli - BUDGET
        ));
    }
    Ok(())
}

fn is_program(file: &str) -> bool {
    Path::new(file).extension().is_some_and(|extension| extension == "wasm")
}

/// The page and every file of ours that it names as needed at once: scripts, styles and the program. (An icon is not:
/// browsers ask for one later, some for none. Nor is what only old browsers run.)
fn first_load(dist: &Path) -> Result<Vec<String>, String> {
    const PAGE: &str = "index.html";
    let html = fs::read_to_string(dist.join(PAGE)).map_err(|error| format!("dist/{PAGE} cannot be read: {error}."))?;
    let named = needed(&html).filter(|file| dist.join(file).is_file()).map(str::to_owned);
    let files: Vec<String> = std::iter::once(PAGE.to_owned()).chain(named).collect();
    if files.iter().filter(|file| is_program(file)).count() != 1 {
        return Err(format!(
            "dist/{PAGE} should name one WebAssembly file; it names {}.",
            files.join(", ")
        ));
    }
    Ok(files)
}

/// The addresses in `html` that a current browser fetches before the program can start.
fn needed(html: &str) -> impl Iterator<Item = &str> {
    let tags = html.split('<').filter_map(|rest| rest.split('>').next());
    tags.filter_map(|tag| {
        let script = tag.starts_with("script") && !tag.contains(" nomodule");
        let link = tag.starts_with("link")
            && ["stylesheet", "modulepreload", "preload"]
                .iter()
                .any(|&rel| value(tag, "rel") == Some(rel));
        if script {
            value(tag, "src")
        } else if link {
            value(tag, "href")
        } else {
            None
        }
    })
    .map(|address| address.trim_start_matches("./"))
}

/// The value of an attribute in a tag.
fn value<'a>(tag: &'a str, attribute: &str) -> Option<&'a str> {
    tag.split_once(&format!(" {attribute}=\""))?.1.split('"').next()
}

/// The bytes of each file: as it is, with gzip at its best, and with brotli at its best. Node.js knows how to compress.
fn sizes(dist: &Path, files: &[String]) -> Result<Vec<[u64; 3]>, String> {
    const SCRIPT: &str = "const zlib = require('zlib');
        for (const file of process.argv.slice(1)) {
            const content = require('fs').readFileSync(file);
            const gzip = zlib.gzipSync(content, { level: 9 });
            console.log(content.length, gzip.length, zlib.brotliCompressSync(content).length);
        }";
    let paths = files.iter().map(|file| dist.join(file));
    let text = output(command("node", &["--eval", SCRIPT]).args(paths)).ok_or("Compressed sizes need Node.js on PATH.")?;
    let sizes: Vec<[u64; 3]> = text.lines().filter_map(three_numbers).collect();
    if sizes.len() == files.len() {
        Ok(sizes)
    } else {
        Err(format!(
            "Node.js should have printed {} lines of sizes; it printed: {text}",
            files.len()
        ))
    }
}

fn three_numbers(line: &str) -> Option<[u64; 3]> {
    let numbers: Option<Vec<u64>> = line.split(' ').map(|number| number.parse().ok()).collect();
    numbers?.try_into().ok()
}

/// The sections of a WebAssembly file with their bytes, the largest first.
/// Source: WebAssembly Core Specification 2.0, 5.5 "Modules".
fn sections(program: &[u8]) -> Option<Vec<(&'static str, usize)>> {
    let mut rest = program.strip_prefix(b"\0asm\x01\0\0\0")?;
    let mut bytes: BTreeMap<&'static str, usize> = BTreeMap::new();
    while let Some((&id, after_id)) = rest.split_first() {
        let (size, content) = leb128(after_id)?;
        *bytes.entry(section_name(id)).or_default() += size;
        rest = content.get(size..)?;
    }
    let mut parts: Vec<_> = bytes.into_iter().collect();
    parts.sort_by_key(|&(_, size)| std::cmp::Reverse(size));
    Some(parts)
}

fn section_name(id: u8) -> &'static str {
    match id {
        10 => "code",
        11 => "data: fonts, texts, tables",
        9 => "tables of functions that are called by reference",
        3 => "types of the functions",
        2 => "imports",
        _ => "everything else",
    }
}

/// An unsigned number in LEB128, seven bits to a byte, and what follows it.
fn leb128(bytes: &[u8]) -> Option<(usize, &[u8])> {
    let mut number = 0_usize;
    for (at, &byte) in bytes.iter().enumerate() {
        let shift = u32::try_from(at).ok()?.checked_mul(7)?;
        number |= usize::from(byte & 0x7f).checked_shl(shift)?;
        if byte & 0x80 == 0 {
            return Some((number, bytes.get(at + 1..)?));
        }
    }
    None
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, reason = "tests")]

    use super::{leb128, needed, sections, three_numbers};

    #[test]
    fn the_first_visit_needs_scripts_styles_and_the_program_only() {
        let page = r#"<link rel="icon" href="icons/favicon.svg"><link rel="manifest" href="manifest.webmanifest">
            <link rel="stylesheet" href="./page-1.css"/> <script src="./start-1.js" type="module"></script>
            <script src="./old-1.js" nomodule></script><script type="application/ld+json">{}</script>
            <link rel="modulepreload" href="./a.js" crossorigin="anonymous"><link rel="preload" href="./a.wasm" as="fetch">
            <a href="learn.html">Learn</a>"#;
        let files: Vec<&str> = needed(page).collect();
        assert_eq!(files, ["page-1.css", "start-1.js", "a.js", "a.wasm"]);
    }

    #[test]
    fn sections_are_read_to_the_end() {
        let long = [&[10, 0x80, 0x01][..], &[0; 128]].concat();
        let program = [b"\0asm\x01\0\0\0".as_slice(), &[11, 2, 7, 7], &long, &[0, 1, 0]].concat();
        let parts = sections(&program).unwrap();
        assert_eq!(parts, [("code", 128), ("data: fonts, texts, tables", 2), ("everything else", 1)]);
        assert_eq!(sections(program.get(..program.len() - 4).unwrap()), None, "cut off");
        assert_eq!(sections(b"<!doctype html>"), None);
    }

    #[test]
    fn numbers_are_read_as_they_are_written() {
        // An example of the DWARF standard, section 7.6.
        assert_eq!(leb128(&[0xb9, 0x64, 5]), Some((12857, [5].as_slice())));
        assert_eq!(leb128(&[0x80]), None);
        assert_eq!(three_numbers("1 2 3"), Some([1, 2, 3]));
        assert_eq!(three_numbers("1 2"), None);
    }
}
