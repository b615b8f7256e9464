//! Good files, by their format, and bytes that no tool writes.

use crate::mutate::Random;
use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

/// Files that are read, by the name of their format, and those that are refused.
pub fn files(folder: &Path) -> BTreeMap<&'static str, Vec<Vec<u8>>> {
    let mut all = BTreeMap::new();
    let mut folders = vec![folder.to_owned()];
    while let Some(folder) = folders.pop() {
        let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
        paths.sort();
        for path in paths {
            if path.is_dir() {
                folders.push(path);
            } else {
                let bytes = fs::read(path).unwrap();
                let format = depth_files::read(&[&bytes]).map_or("refused", |found| found.format.name());
                all.entry(format).or_insert_with(Vec::new).push(bytes);
            }
        }
    }
    all
}

/// What would be large, slow or deep where nobody counts: a beginning, and what is repeated behind it.
const PARTS: &[(&str, &str)] = &[
    ("", "["),
    ("", "{"),
    ("", "{a: "),
    ("", "- "),
    ("", "? - "),
    ("", "<a>"),
    ("<opencv_storage>", "<a>1</a>\n"),
    ("<opencv_storage><a>", "1 "),
    ("", "---\n"),
    ("", "---\na: 1\n"),
    ("", "--- {intrinsics: [1,1,1,1], T_BS: 0}\n"),
    ("", "--- {K: [7,0,3,0,7,2,0,0,1], distortion_model: a}\n"),
    ("", "\t"),
    ("K: [", "1,\t"),
    ("K: [", "1,"),
    ("K: ", "1 "),
    ("K: \"", "a"),
    ("K1: [", "&a [*a, *a], "),
    ("a: &a 1\nb: [", "*a,"),
    ("", "a: 1\n"),
    ("", "\n"),
    ("", "\r"),
    ("", "a"),
    ("", "%\n"),
    ("a: |\n", " b\n"),
    ("", "#"),
    ("", "#\n"),
    ("P0: ", "0 "),
    ("", "P0: 7 0 3 0 0 7 2 0 0 0 1 0\n"),
    ("", "P0: 7 0 3 0 0 7 2 0 0 0 1 0\nP1: 7 0 3 -4 0 7 2 0 0 0 1 0\n"),
    ("", "7 0 3 0 0 7 2 0 0 0 1 0\n"),
    ("", "1 PINHOLE 9 9 7 7 3 3\n"),
    ("1 PINHOLE 9 9 ", "7 "),
    ("", "[LEFT_CAM_HD]\nfx=7\nfy=7\ncx=3\ncy=3\n"),
    ("[LEFT_CAM_HD]\n", "fx=7\n"),
    ("", " Intrinsic of \"Infrared 1\"\n"),
    ("", " Intrinsic of \"Infrared 1\"\nFx: 7\nFy: 7\nPPX: 3\nPPY: 3\n"),
    (" Intrinsic of \"Infrared 1\"\n", "Fx: 7\n"),
    ("cam0=[7 0 3; 0 7 2; 0 0 1]\n", "baseline=1\n"),
    ("cam0=[", "7 "),
    ("# oST version 5.0 parameters\n", "projection\n7 0 3 0\n0 7 2 0\n0 0 1 0\n"),
    ("# oST version 5.0 parameters\n", "projection\n"),
    (
        "cam0: {intrinsics: [7,7,3,2]}\n",
        "cam1: {intrinsics: [7,7,3,2], T_cn_cnm1: [1,0,0,1,0,1,0,0,0,0,1,0,0,0,0,1]}\n",
    ),
    ("Camera.fx: 7\n", "Camera.fy: 7\n"),
    ("\u{feff}", "a: 1\n"),
    ("cam0=[7 0 3; 0 7 2; 0 0 1]\n", "=\n"),
    ("[LEFT_CAM_HD]\n", "a=\n"),
    ("# oST version 5.0 parameters\n", "a\n"),
    (" Intrinsic of \"Infrared 1\"\n", "Fx:\n"),
    ("P0: 7 0 3 0 0 7 2 0 0 0 1 0\n", "S_rect_00: 1 1\n"),
    ("{\"a\":[", "{},"),
    ("a:\n", " - b\n"),
    ("<a ", "b=\"1\" "),
    ("<a>", "<b/>"),
    ("<a>", "<!---->"),
    ("<a>", "&lt;"),
];

/// Each of [`PARTS`] with `length` bytes.
pub fn inflated(length: usize) -> Vec<Vec<u8>> {
    let mut all: Vec<Vec<u8>> = PARTS
        .iter()
        .map(|(start, part)| [start.as_bytes(), &part.as_bytes().repeat(length / part.len())].concat())
        .collect();
    let attributes: String = (0..9_000).map(|number| format!(" b{number}=\"\"")).collect();
    all.push(format!("<a{attributes}>").into_bytes());
    // UTF-16, of letters that are three bytes long in UTF-8.
    all.push([&b"\xff\xfe"[..], &b"\x00\x4e".repeat(length / 2)].concat());
    all.push([&b"PK\x03\x04"[..], &b"\x00".repeat(length)].concat());
    all.push([&b"\x93NUMPY\x01\x00"[..], &b"\xff".repeat(length)].concat());
    all
}

/// A good file made large: all of it again and again, or a line of it behind it.
pub fn repeated(file: &[u8], length: usize, random: &mut Random) -> Vec<u8> {
    let lines: Vec<&[u8]> = file.split_inclusive(|byte| *byte == b'\n').collect();
    if lines.is_empty() || random.below(8) == 0 {
        return file.repeat(length / file.len().max(1));
    }
    let line = random.of::<&[u8]>(&lines);
    [file, &line.repeat(length / line.len())].concat()
}
