//! Arrays of NumPy, written by NumPy 2.4: `numpy.savez`, `savez_compressed` and `save` of the numbers below. What is expected was computed by
//! NumPy too, where it is not one of those numbers.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{bytes, found, pinhole, refused, value};
use depth_files::{Format, Warning, read};

const LEFT: [f64; 4] = [712.5, 713.75, 331.25, 244.5];
/// Exact in 32 bits.
const RIGHT: [f64; 4] = [709.25, 710.5, 318.5, 239.75];
/// `numpy.linalg.norm(T)` of (−119.4, 0.6, −2.1).
const NORM: f64 = 119.419_973_203_815_46;

#[test]
fn the_archive_of_the_tutorial_is_a_camera() {
    let one = found(&["numpy/mono.npz"]);
    assert_eq!((one.format, one.cameras.len()), (Format::NumPy, 1));
    assert_eq!(pinhole(&one.cameras[0]), LEFT);
    assert_eq!(one.cameras[0].distortion, [-0.21, 0.045, 0.0011, -0.0007, 0.0]);
    let origin = &one.cameras[0].origin;
    assert_eq!((origin.line, origin.how.as_str()), (0, "mtx"));
    assert!(one.warnings.contains(&Warning::NoBaseline { format: Format::NumPy }));
}

#[test]
fn a_compressed_archive_of_a_pair_has_its_baseline_whatever_order_its_bytes_are_in() {
    // The right matrix is in big-endian numbers of 32 bits, column by column.
    let pair = found(&["numpy/stereo_compressed.npz"]);
    assert_eq!(pair.cameras.iter().map(pinhole).collect::<Vec<_>>(), [LEFT, RIGHT]);
    assert_eq!(pair.cameras[0].size, Some([640, 480]));
    assert!((value(&pair) - NORM).abs() < 1e-12);
    assert_eq!(pair.pair, Some([0, 1]));
}

#[test]
fn arrays_without_names_are_known_by_their_numbers() {
    let pair = found(&["numpy/without_names.npz"]);
    assert_eq!(pair.cameras.iter().map(pinhole).collect::<Vec<_>>(), [LEFT, RIGHT]);
    let pair = found(&["numpy/matrix_by_columns.npy", "numpy/matrix_right.npy"]);
    assert_eq!(pair.cameras.iter().map(pinhole).collect::<Vec<_>>(), [LEFT, RIGHT]);
    assert_eq!(pair.cameras[1].origin.file, 1);
    let one = found(&["numpy/distortion.npy", "numpy/matrix_by_columns.npy"]);
    assert_eq!(one.cameras.iter().map(pinhole).collect::<Vec<_>>(), [LEFT]);
    assert!(refused(&["numpy/distortion.npy"]).contains("no camera matrix"));
}

#[test]
fn intrinsics_in_numpy_and_extrinsics_in_yaml_are_one_calibration() {
    let intrinsics = bytes("numpy/stereo_compressed.npz");
    let extrinsics = b"T: [ -60., 0.5, 0. ]\nP1: [700,0,320,0, 0,700,240,0, 0,0,1,0]\nP2: [700,0,330,-42000, 0,700,240,0, 0,0,1,0]\n";
    let both = read(&[&intrinsics, extrinsics]).unwrap();
    assert_eq!((value(&both), both.is_rectified()), (60.0, true));
}

#[test]
fn objects_are_refused_with_the_line_that_exports_them_unless_the_matrix_is_beside_them() {
    for file in ["numpy/dictionary.npy", "numpy/objects_alone.npz"] {
        let sentence = refused(&[file]);
        assert!(
            sentence.contains("allow_pickle=True") && sentence.contains("json.dumps"),
            "{sentence}"
        );
    }
    assert_eq!(pinhole(&found(&["numpy/objects_beside_a_matrix.npz"]).cameras[0]), LEFT);
}

#[test]
fn pickles_are_refused_with_the_line_that_exports_them() {
    for file in ["pickle/protocol_4.pkl", "pickle/protocol_0.p"] {
        let sentence = refused(&[file]);
        assert!(
            sentence.contains("pickle of Python") && sentence.contains("json.dumps(pickle.load("),
            "{sentence}"
        );
    }
    // What that line writes of the two, by Python.
    let exported = br#"{"mtx": [[712.5, 0, 331.25], [0, 713.75, 244.5], [0, 0, 1]]}"#;
    assert_eq!(pinhole(&read(&[exported]).unwrap().cameras[0]), LEFT);
    // And of what the tutorial saves, (mtx, dist), and of a dictionary in which it is.
    let list = br#"[[[712.5, 0.0, 331.25], [0.0, 713.75, 244.5], [0.0, 0.0, 1.0]], [[0.0, 0.0, 0.0, 0.0, 0.0]]]"#;
    let map = [b"{\"calibration\": ", list.as_slice(), b"}"].concat();
    for exported in [list.as_slice(), &map] {
        let one = read(&[exported]).unwrap();
        assert_eq!((one.format, pinhole(&one.cameras[0])), (Format::OpenCv, LEFT));
    }
}

#[test]
fn a_matrix_without_a_name_goes_with_extrinsics() {
    let extrinsics = b"T: [ -60., 0.5, 0. ]\n";
    let (left, right) = (bytes("numpy/matrix_by_columns.npy"), bytes("numpy/matrix_right.npy"));
    let pair = read(&[extrinsics, &left, &right]).unwrap();
    assert_eq!(pair.cameras.iter().map(pinhole).collect::<Vec<_>>(), [LEFT, RIGHT]);
    assert!((value(&pair) - 60.002_083_297_165_605).abs() < 1e-12);
    // Of four nobody knows which are meant.
    assert!(refused(&["numpy/matrix_right.npy", "numpy/without_names.npz"]).contains("no camera matrix"));
}

#[test]
fn a_file_of_matlab_is_refused_with_the_line_that_exports_it() {
    let mut file = b"MATLAB 5.0 MAT-file, Platform: GLNXA64, Created on: Mon Jan  5 10:00:00 2026".to_vec();
    file.resize(300, 0);
    let sentence = read(&[&file]).unwrap_err().to_string();
    assert!(
        sentence.contains("MATLAB") && sentence.contains("jsonencode(struct('K1',K1"),
        "{sentence}"
    );
    // What that line writes, as jsonencode does.
    let exported =
        br#"{"K1":[[712.5,0,331.25],[0,713.75,244.5],[0,0,1]],"K2":[[709.25,0,318.5],[0,710.5,239.75],[0,0,1]],"T":[-119.4,0.6,-2.1]}"#;
    let pair = read(&[exported]).unwrap();
    assert_eq!(pair.cameras.iter().map(pinhole).collect::<Vec<_>>(), [LEFT, RIGHT]);
    assert!((value(&pair) - NORM).abs() < 1e-12);
}

#[test]
fn what_is_wrong_in_a_file_without_lines_is_said_without_a_line() {
    let mut bytes = Vec::new();
    let mut header = b"\x93NUMPY\x01\x00\x3b\x00{'descr': '<f8', 'fortran_order': False, 'shape': (2, 3), }  \n".to_vec();
    header.extend([0; 48]);
    let mut archive = rawzip::ZipArchiveWriter::new(&mut bytes);
    let (mut entry, config) = archive.new_file("mtx.npy").start().unwrap();
    let mut writer = config.wrap(&mut entry);
    std::io::Write::write_all(&mut writer, &header).unwrap();
    let (_, descriptor) = writer.finish().unwrap();
    entry.finish(descriptor).unwrap();
    archive.finish().unwrap();
    let sentence = read(&[&bytes]).unwrap_err().to_string();
    assert!(
        sentence.contains("in the file the camera matrix has 6 numbers, not 9"),
        "{sentence}"
    );
}

#[test]
fn a_damaged_archive_is_refused_as_one() {
    let whole = bytes("numpy/mono.npz");
    let mut cut = whole.clone();
    cut.truncate(whole.len() - 40);
    let mut changed = whole.clone();
    // A number of the first array, which its checksum knows.
    let at = whole.windows(8).position(|eight| eight == 712.5_f64.to_le_bytes()).unwrap();
    changed[at + 6] ^= 1;
    for damaged in [&cut, &changed] {
        let sentence = read(&[damaged]).unwrap_err().to_string();
        assert!(sentence.contains("NumPy") && sentence.contains("damaged"), "{sentence}");
    }
    let zip = read(&[b"PK\x05\x06\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"]).unwrap_err().to_string();
    assert!(zip.contains("archive without arrays"), "{zip}");
}

#[test]
fn an_array_that_is_shorter_than_its_shape_is_refused() {
    let whole = bytes("numpy/matrix_right.npy");
    let sentence = read(&[&whole[..whole.len() - 1]]).unwrap_err().to_string();
    assert!(sentence.contains("ends before its last number"), "{sentence}");
    let text = String::from_utf8_lossy(&whole[10..]).replace("(3, 3)", "(9999999999, 9999999999, 9)");
    let mut huge = whole[..8].to_vec();
    huge.extend(u16::try_from(text.len()).unwrap().to_le_bytes());
    huge.extend(text.as_bytes());
    assert!(read(&[&huge]).unwrap_err().to_string().contains("no camera matrix"));
}
