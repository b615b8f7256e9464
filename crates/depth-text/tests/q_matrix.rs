//! Q matrices as people paste them.
#![allow(clippy::unwrap_used, missing_docs, reason = "tests")]

use depth_text::note::Issue;
use depth_text::q_matrix::{read, written};

/// OpenCV 4.14, stereoRectify with T = (−100, 0, 0), cx 610 and 650: Q[2][3] = 700, Q[3][2] = 0.01, Q[3][3] = 0.4.
fn is_the_reference(text: &str) {
    let q = read(text).unwrap();
    assert_eq!(
        (q.focal_length.px(), q.baseline, q.doffs.px(), q.swapped),
        (700.0, 100.0, 40.0, false),
        "{text}"
    );
    assert_eq!((q.cx.px(), q.cy.px()), (610.0, 350.0));
}

#[test]
fn numpy_yaml_xml_and_plain_numbers_are_read() {
    is_the_reference(
        "array([[ 1.00e+00,  0.,  0., -6.10e+02],\n [0., 1., 0., -350.],\n [0., 0., 0., 700.],\n [0., 0., 0.01, 0.4]], dtype=float64)",
    );
    is_the_reference(
        "[[   1.    0.    0. -610.  ]\n [   0.    1.    0. -350.  ]\n [   0.    0.    0.  700.  ]\n [   0.    0.    0.01    0.4 ]]",
    );
    is_the_reference(
        "%YAML:1.0\n---\nP2: !!opencv-matrix\n   rows: 3\n   cols: 4\n   data: [ 1., 2., 3. ]\nQ: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: d\n   data: [ 1., 0., 0., -610., 0., 1., 0., -350., 0., 0.,\n       0., 700., 0., 0., 0.01, 0.4 ]\n",
    );
    is_the_reference(
        "<Q type_id=\"opencv-matrix\"><rows>4</rows><cols>4</cols><dt>d</dt><data>\n1. 0. 0. -610. 0. 1. 0. -350. 0. 0. 0. 700. 0. 0. 0.01 0.4</data></Q>",
    );
    is_the_reference("Q = 1 0 0 −610; 0 1 0 −350; 0 0 0 700; 0 0 0.01 0.4");
}

/// OpenCV's own formats, and what programs print and people write.
#[test]
fn every_way_to_write_it_is_read() {
    is_the_reference("np.float32([[1,0,0,-610],[0,1,0,-350],[0,0,0,700],[0,0,0.01,0.4]])");
    is_the_reference("Q = np.array([[1, 0, 0, -610], [0, 1, 0, -350], [0, 0, 0, 700], [0, 0, -1/-100, 0.4]], dtype=np.float32)");
    is_the_reference("numpy.array([[1, 0, 0, -610], [0, 1, 0, -350], [0, 0, 0, 700], [0, 0, 1 / 100, 0.4]])");
    is_the_reference(
        "stereo:\n   K1: !!opencv-matrix\n      rows: 3\n      cols: 3\n      dt: d\n      data: [ 700., 0., 610., 0., 700., 350., 0., 0., 1. ]\n   Q: !!opencv-matrix\n      rows: 4\n      cols: 4\n      dt: d\n      data: [ 1., 0., 0., -610., 0., 1., 0., -350., 0., 0.,\n          0., 700., 0., 0., 0.01, 0.4 ]\n   R1: !!opencv-matrix\n      rows: 3\n      cols: 3\n      data: [ 1., 2., 3. ]\n",
    );
    is_the_reference(
        r#"{ "K1": { "type_id": "opencv-matrix", "rows": 3, "cols": 3, "dt": "d", "data": [ 7.0, 0.0, 6.1 ] },
             "Q": { "type_id": "opencv-matrix", "rows": 4, "cols": 4, "dt": "d",
               "data": [ 1.0, 0.0, 0.0, -610.0, 0.0, 1.0, 0.0, -350.0, 0.0, 0.0, 0.0, 700.0, 0.0, 0.0, 0.01, 0.4 ] },
             "rms": 0.2 }"#,
    );
    is_the_reference(r#"{"Q": [[1, 0, 0, -610], [0, 1, 0, -350], [0, 0, 0, 700], [0, 0, 0.01, 0.4]], "image_width": 1280}"#);
    is_the_reference(
        "<?xml version=\"1.0\"?>\n<opencv_storage>\n<K1 type_id=\"opencv-matrix\"><rows>3</rows><cols>3</cols><dt>d</dt><data>7 0 6</data></K1>\n<Q type_id=\"opencv-matrix\">\n  <rows>4</rows>\n  <cols>4</cols>\n  <dt>d</dt>\n  <data>\n    1. 0. 0. -610. 0. 1. 0. -350. 0. 0. 0. 700. 0. 0. 1.0e-02 0.4</data></Q>\n<rms>0.2</rms>\n</opencv_storage>",
    );
    is_the_reference("Q:\n- [1, 0, 0, -610]\n- [0, 1, 0, -350]\n- [0, 0, 0, 700]\n- [0, 0, 0.01, 0.4]\n");
    // MATLAB, format long: a factor in front of all.
    is_the_reference(
        "Q =\n\n   1.0e+03 *\n\n   0.001000000000000                   0                   0  -0.610000000000000\n                   0   0.001000000000000                   0  -0.350000000000000\n                   0                   0                   0   0.700000000000000\n                   0                   0   0.000010000000000   0.000400000000000\n",
    );
}

/// What people write around and between the numbers.
#[test]
fn comments_dates_products_and_decimal_commas_are_no_obstacle() {
    is_the_reference("# 1 2 3\nnp.array([[1,0,0,-610],[0,1,0,-350],[0,0,0,700],[0,0,0.01,0.4]], np.float32)");
    is_the_reference("// fx 700\ndouble Q[4][4] = {1,0,0,-610,0,1,0,-350,0,0,0,700,0,0,0.01,0.4};");
    is_the_reference("Q matrix (2023-05-01):\n[[1,0,0,-610],[0,1,0,-350],[0,0,0,700],[0,0,0.01,0.4]]");
    is_the_reference("1 0 0 -610,0 0 1 0 -350,0 0 0 0 700,0 0 0 0,01 0,4");
    is_the_reference("[[1, 0, 0, -0.5*1220], [0, 1, 0, -0.5*700], [0, 0, 0, 700], [0, 0, 1/100, 0.4]]");
    is_the_reference("1 0 0 -610 # first\n0 1 0 -350 // second\n0 0 0 700 % third\n0 0 0.01 0.4");
    is_the_reference("/* 12 boards 2024 */ 1 0 0 -610 0 1 0 -350 0 0 0 700 0 0 0.01 0.4");
    is_the_reference("2024-05-01 12:00\n1 0 0 -610\n0 1 0 -350\n0 0 0 700\n0 0 0.01 0.4");
    is_the_reference("[[1, 0, 0, -0.5 * 1220], [0, 1, 0, -0.5*700], [0, 0, 0, 2*350], [0, 0, 1/100, 0.4]]");
    // −1/Tx of a baseline of −0.2, and of one of +0.2, which is swapped.
    let q = |w: &str| read(&format!("[[1,0,0,-610],[0,1,0,-350],[0,0,0,700],[0,0,{w},0]]")).unwrap();
    assert_eq!((q("-1/-0.2").baseline, q("-1/-0.2").swapped), (0.2, false));
    assert_eq!((q("-1/0.2").baseline, q("-1/0.2").swapped), (0.2, true));
}

/// A narrow window of MATLAB's or Octave's, in which the matrix is printed in parts.
#[test]
fn a_matrix_in_parts_is_put_together() {
    is_the_reference(
        "Q =\n\n  Columns 1 through 3\n\n     1     0     0\n     0     1     0\n     0     0     0\n     0     0     0.01\n\n  Column 4\n\n  -610\n  -350\n   700\n   0.4\n",
    );
    is_the_reference(
        "Q =\n\n Columns 1 and 2:\n\n   1   0\n   0   1\n   0   0\n   0   0\n\n Columns 3 and 4:\n\n   0  -610\n   0  -350\n   0   700\n   0.01   0.4\n\n",
    );
    is_the_reference(
        "Q =\n\n   1.0e+03 *\n\n  Columns 1 through 2\n\n   0.001000000000000                   0\n                   0   0.001000000000000\n                   0                   0\n                   0                   0\n\n  Columns 3 through 4\n\n                   0  -0.610000000000000\n                   0  -0.350000000000000\n                   0   0.700000000000000\n   0.000010000000000   0.000400000000000\n",
    );
    is_the_reference(
        "Q =\n\n  Columns 1 through 3\n\n 1 0 0\n 0 1 0\n 0 0 0\n 0 0 0.01\n\n  Column 4\n\n -610\n -350\n 700\n 0.4\n\nP1 =\n\n  Columns 1 through 3\n\n 700 0 640\n 0 700 360\n 0 0 1\n\n  Column 4\n\n 0\n 0\n 0\n",
    );
    let half = read("Q =\n\n  Columns 1 through 3\n\n 1 0 0\n 0 1 0\n 0 0 0\n 0 0 0.01\n");
    assert_eq!(half, Err(Issue::QMatrixCount { found: 12 }));
}

const NUMBERS: &str = "1, 0, 0, -610, 0, 1, 0, -350, 0, 0, 0, 700, 0, 0, 0.01, 0.4";

#[test]
fn what_stands_around_it_does_not_matter() {
    for (before, after) in [
        (
            "%YAML:1.0\n---\nQ: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: d\n   data: [",
            "]\n",
        ),
        ("---\nQ: [", "]\n---\nfoo: 1\n"),
        ("- Q = [", "]"),
        ("- Q: [", "]\n- reprojection error: 0.2"),
        ("# the Q below is in mm\nP1: [1, 2, 3]\nQ: [", "]\n# --- end"),
        ("Q: [", "]\ninformation: none"),
        ("Q: [", "]\n[INFO] done"),
        ("double Q[4][4] = {", "};"),
        ("cv::Mat Q = (cv::Mat_<double>(4,4) << ", ");"),
        ("<Q rows=\"4\" cols=\"4\">", "</Q>"),
        ("q = np.array([", "])"),
        ("Q_matrix = [", "]"),
        ("tensor([", "], device='cuda:0')"),
        ("**Q**: [", "]"),
        ("\u{feff}Q =\r\n[", "]\r\n"),
    ] {
        is_the_reference(&format!("{before}{NUMBERS}{after}"));
    }
    for minus in ['–', '—', '‐', '‑', '﹣', '－', '−'] {
        is_the_reference(&NUMBERS.replace('-', &minus.to_string()));
    }
    is_the_reference(&NUMBERS.replace("0.01", "-1/(-100)"));
    is_the_reference(&NUMBERS.replace("0.01", "0.01f"));
}

#[test]
fn it_is_refused_for_the_true_reason() {
    let said = |text: &str| read(text).unwrap_err().to_string();
    for without in [
        "%YAML:1.0\nK1: !!opencv-matrix\n   rows: 3\n   cols: 3\n   data: [ 1., 2., 3. ]\n",
        "<opencv_storage><M1><data>1 2 3</data></M1></opencv_storage>",
        "{\"M1\": [[1, 2], [3, 4]]}",
    ] {
        assert!(said(without).contains("There is no Q in it"), "{without}: {}", said(without));
    }
    let rounded = "Q =\n  1.0e+03 *\n 0.0010 0 0 -0.6100\n 0 0.0010 0 -0.3500\n 0 0 0 0.7000\n 0 0 0.0000 0.0004";
    assert!(said(rounded).contains("format long g"), "{}", said(rounded));
    for few_digits in ["0.0019", "0.0083", "0.0100"] {
        assert!(
            said(&rounded.replace("0.0000", few_digits)).contains("format long g"),
            "{few_digits}"
        );
    }
    let sample = "Q = np.float32([[1, 0, 0, -0.5*w], [0,-1, 0,  0.5*h], [0, 0, 0, -f], [0, 0, 1, 0]])";
    assert!(said(sample).contains("“*”") || said(sample).contains('w'), "{}", said(sample));
    assert!(said("np.float32([[1,0,0,-320],[0,1,0,-240],[0,0,0,500]])").contains("has 12"));
    assert!(said("1 0 0 -610 0 1 0 -350 0 0 0 700 0 0 1/0 0.4").contains("1/0"));
}

#[test]
fn what_is_written_is_read() {
    let q = read("1 0 0 -610 0 1 0 -350 0 0 0 700 0 0 0.01 0.4").unwrap();
    let text = written(&q).unwrap();
    assert_eq!(
        text,
        "%YAML:1.0\n---\nQ: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: d\n   data: [ 1., 0., 0., -610.,\n       0., 1., 0., -350.,\n       0., 0., 0., 700.,\n       0., 0., 0.01, 0.4 ]\n"
    );
    assert_eq!(read(&text), Ok(q));
}

#[test]
fn a_negative_sign_means_swapped() {
    assert!(read("1 0 0 -610 0 1 0 -350 0 0 0 700 0 0 -0.01 -0.4").unwrap().swapped);
}

#[test]
fn what_is_no_q_matrix_is_refused_in_words() {
    assert!(read("1 2 3").unwrap_err().to_string().contains("16 numbers; this text has 3"));
    assert!(read("").unwrap_err().to_string().contains("has 0"));
    assert!(read(&"1 ".repeat(16)).unwrap_err().to_string().contains("row 1, column 2"));
    assert!(
        read("1 0 0 -610 0 1 0 -350 0 0 0 nan 0 0 0.01 0.4")
            .unwrap_err()
            .to_string()
            .contains("nan")
    );
}

/// An exact zero has no sign, neither in what is read nor in what is copied out: "-0" is nothing to print.
#[test]
fn no_zero_is_negative() {
    let q = read("1 0 0 0; 0 1 0 0; 0 0 0 700; 0 0 -5 0").unwrap();
    assert!(q.swapped);
    for zero in [q.doffs.px(), q.cx.px(), q.cy.px()] {
        assert!(zero == 0.0 && zero.is_sign_positive(), "{zero}");
    }
    let again = depth_core::q_matrix::of(&q).unwrap();
    assert!(
        again.iter().flatten().all(|entry| *entry != 0.0 || entry.is_sign_positive()),
        "{again:?}"
    );
}
