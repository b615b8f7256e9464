//! Good files, by their format, and bytes that no tool writes.

use crate::mutate::Random;
use crate::photo::{self, Photo, Value, jpeg, phone};
use miniz_oxide::deflate::compress_to_vec;
use rawzip::{CompressionMethod, DataDescriptorOutput, ZipArchiveWriter};
use std::collections::BTreeMap;
use std::fs;
use std::io::Write;
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
    all.insert("exif", photos());
    all
}

/// Photographs, with pixels left out.
fn photos() -> Vec<Vec<u8>> {
    let little = Photo {
        is_big_endian: false,
        ..phone()
    };
    let all = [
        phone(),
        little.oriented(6).with(photo::ZOOM, Value::Rational(2, 1)),
        phone().without(&[photo::PLANE_X]).sized(3000, 3000),
        phone().without(&[photo::FILM]).with(photo::DISTANCE, Value::Rational(1, 10)),
        phone().sized(1008, 756).with(photo::PLANE_X, Value::Rational(72, 1)),
    ];
    all.iter().map(Photo::jpeg).collect()
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
    ("<Calibrations>", "<Camera/>"),
    (
        "<Calibrations>",
        "<Camera><Calibration size=\"1 1\" focalLength=\"7 7\" principalPoint=\"1 1\"/></Camera>",
    ),
    (
        "{\"cameraData\":[",
        "[1,{\"extrinsics\":{\"toCameraSocket\":2,\"rotationMatrix\":[1,0,0,0,1,0,0,0,1],\"translation\":{\"x\":1}}}],",
    ),
    ("{\"cameraData\":[", "[1,{\"intrinsicMatrix\":[7,0,3,0,7,2,0,0,1]}],"),
    ("- cameraData: [[1, {intrinsicMatrix: [7,0,3,0,7,2,0,0,1]}]]\n", "  a: 1\n"),
    ("{\"frames\":[", "{\"fl_x\":7,\"cx\":1,\"cy\":2},"),
    ("fl_x: 7\ncx: 1\ncy: 1\nframes:\n", "- a: 1\n"),
    (
        "model_type: PINHOLE\nprojection_parameters: {fx: 7, fy: 7, cx: 1, cy: 1}\n",
        "body_T_cam0: 1\n",
    ),
    (
        "",
        "---\nmodel_type: PINHOLE\nprojection_parameters: {fx: 7, fy: 7, cx: 1, cy: 1}\n",
    ),
    ("[", "{\"fx\":7,\"cx\":1,\"cy\":2},"),
    ("", "- {fx: 7, cx: 1, cy: 2}\n"),
    ("{\"a\":", "{\"fx\":7,\"a\":"),
    ("fx: 7\ncx: 1\ncy: 1\n", "baseline: 1\n"),
    ("[", "[[7,0,3],[0,7,2],[0,0,1]],"),
    ("7 0 3 0 7 2 0 0 1\n", "1\n"),
    ("7 0 3 0 7 2 0 0 1\n", "1 "),
    ("", "7 0 3 0 7 2 0 0 1\n"),
    ("", "fc = [\n"),
    ("", "fc=7;"),
    ("fc=[7;7]\ncc=[3;2]\n", "fc_error=[1;1]\n"),
    ("cc = [3;2]\nfc = [", "7 "),
    ("cc = [3;2]\nfc = [", "7\n"),
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
    all.push(archive(&vec![b'0'; 64 << 20], 1));
    let header = format!("{{'descr': '<f8', 'fortran_order': False, 'shape': ({}) }}", "1,".repeat(20_000));
    all.push(archive(header.as_bytes(), 1));
    all.push(archive(b"\x93NUMPY", length / 200));
    all.push(archive(&[b"\x93NUMPY\x01\x00\x00\x00".as_slice(), &[b'0'; 100_000]].concat(), 190));
    all.push([&b"\xff\xd8\xff"[..], &b"\xff".repeat(length)].concat());
    all.push([&b"\xff\xd8\xff"[..], &b"\x00".repeat(length)].concat());
    all.push([&b"\xff\xd8"[..], &b"\xff\xe1\x00\x08Exif\0\0".repeat(length / 10)].concat());
    all.push([&b"\xff\xd8"[..], &b"\xff\xc0\x00\x02".repeat(length / 4)].concat());
    all.push(jpeg(&[(0xe1, &overlapping())], [640, 480]));
    all.push([&b"PK\x03\x04"[..], &b"\x00".repeat(length)].concat());
    all.push([&b"\x93NUMPY\x01\x00"[..], &b"\xff".repeat(length)].concat());
    all
}

/// EXIF whose first directory points to thousands of others, which lie over each other and are thousands of entries long.
fn overlapping() -> Vec<u8> {
    const COUNT: u16 = 2_600;
    let behind = 8 + 2 + 12 * u32::from(COUNT) + 4;
    let mut bytes = [b"Exif\0\0II\x2a\0\x08\0\0\0".as_slice(), &COUNT.to_le_bytes()].concat();
    for number in 0..u32::from(COUNT) {
        bytes.extend(b"\x69\x87\x04\0\x01\0\0\0");
        bytes.extend((behind + 2 * number).to_le_bytes());
    }
    bytes.extend([0; 4]);
    let rest = 65_000 - bytes.len();
    bytes.extend(2_000_u16.to_le_bytes().repeat(rest / 2));
    bytes
}

/// An archive with the same array, which is packed, under so many names.
fn archive(array: &[u8], count: usize) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut archive = ZipArchiveWriter::new(&mut bytes);
    let packed = compress_to_vec(array, 6);
    for number in 0..count {
        let name = format!("{number}.npy");
        let file = archive.new_file(&name);
        let (mut entry, _) = file.compression_method(CompressionMethod::DEFLATE).start().unwrap();
        entry.write_all(&packed).unwrap();
        let size = u64::try_from(array.len()).unwrap();
        entry.finish(DataDescriptorOutput::new(rawzip::crc32(array), size)).unwrap();
    }
    archive.finish().unwrap();
    bytes
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
