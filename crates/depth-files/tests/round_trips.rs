//! Numbers that are written as the tools write them are read as the same numbers.

#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

mod common;

use common::{pinhole, value};
use depth_files::{Found, read};
use proptest::prelude::*;
use rawzip::{CompressionMethod, ZipArchiveWriter};
use std::io::Write;

/// fx, fy, cx and cy of an image of 1280 × 800.
fn camera() -> impl Strategy<Value = [f64; 4]> {
    [300.0..3_000.0, 300.0..3_000.0, 100.0..1_200.0, 100.0..700.0]
}

/// From the left camera to the right one, in meters: mostly along the row.
fn shift() -> impl Strategy<Value = [f64; 3]> {
    [-0.5..-0.02, -0.01..0.01, -0.01..0.01_f64]
}

fn norm([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

fn is_same(got: f64, want: f64) -> bool {
    (got - want).abs() <= 1e-9 * want.abs()
}

/// Whether these cameras were found, and so long a baseline.
fn has(found: &Found, cameras: &[[f64; 4]], baseline: Option<f64>) -> bool {
    let got: Vec<f64> = found.cameras.iter().flat_map(pinhole).collect();
    let want = cameras.concat();
    let are_same = got.len() == want.len() && got.iter().zip(&want).all(|(got, want)| is_same(*got, *want));
    are_same && baseline.is_none_or(|baseline| is_same(value(found), baseline))
}

fn matrix([fx, fy, cx, cy]: [f64; 4]) -> [f64; 9] {
    [fx, 0.0, cx, 0.0, fy, cy, 0.0, 0.0, 1.0]
}

/// Numbers with something between them.
fn joined(all: &[f64], between: &str) -> String {
    let all: Vec<String> = all.iter().map(f64::to_string).collect();
    all.join(between)
}

/// .npy of these numbers, row by row or column by column.
fn npy(all: &[f64], [rows, columns]: [usize; 2], is_fortran: bool) -> Vec<u8> {
    let order = if is_fortran { "True" } else { "False" };
    let header = format!("{{'descr': '<f8', 'fortran_order': {order}, 'shape': ({rows}, {columns}), }}\n");
    let length = u16::try_from(header.len()).unwrap().to_le_bytes();
    let index = |at: usize| if is_fortran { at % rows * columns + at / rows } else { at };
    let numbers = (0..all.len()).flat_map(|at| all[index(at)].to_le_bytes()).collect();
    [b"\x93NUMPY\x01\x00".to_vec(), length.to_vec(), header.into_bytes(), numbers].concat()
}

fn npz(arrays: &[(&str, Vec<u8>)]) -> Vec<u8> {
    let mut bytes = Vec::new();
    let mut archive = ZipArchiveWriter::new(&mut bytes);
    for (name, array) in arrays {
        let name = format!("{name}.npy");
        let file = archive.new_file(&name).compression_method(CompressionMethod::STORE);
        let (mut entry, config) = file.start().unwrap();
        let mut writer = config.wrap(&mut entry);
        writer.write_all(array).unwrap();
        let (_, descriptor) = writer.finish().unwrap();
        entry.finish(descriptor).unwrap();
    }
    archive.finish().unwrap();
    bytes
}

/// A pair as an OAK camera has it: the right camera leads to the left one.
fn depth_ai(cameras: [[f64; 4]; 2], [x, y, z]: [f64; 3]) -> String {
    let [left, right] = cameras.map(|camera| joined(&matrix(camera), ","));
    let [x, y, z] = [x, y, z].map(|one| -100.0 * one);
    let none = r#"{"rotationMatrix":[],"toCameraSocket":-1,"translation":{"x":0,"y":0,"z":0}}"#;
    let to_left = format!(r#"{{"rotationMatrix":[[1,0,0],[0,1,0],[0,0,1]],"toCameraSocket":1,"translation":{{"x":{x},"y":{y},"z":{z}}}}}"#);
    let info = |k: &str, extrinsics: &str| format!(r#"{{"intrinsicMatrix":[{k}],"width":1280,"height":800,"extrinsics":{extrinsics}}}"#);
    format!(r#"{{"cameraData":[[1,{}],[2,{}]]}}"#, info(&left, none), info(&right, &to_left))
}

/// Both cameras look ahead from a body that is turned by a quarter.
fn vins(cameras: [[f64; 4]; 2], [x, y, z]: [f64; 3]) -> [String; 3] {
    let pose = |name: &str, [x, y, z]: [f64; 3]| {
        format!("{name}: !!opencv-matrix\n   rows: 4\n   cols: 4\n   dt: d\n   data: [0,-1,0,{x}, 1,0,0,{y}, 0,0,1,{z}, 0,0,0,1]\n")
    };
    // The right camera stands at −t of the left one, which is at (1, 2, 3).
    let settings = pose("body_T_cam0", [1.0, 2.0, 3.0]) + &pose("body_T_cam1", [1.0 + y, 2.0 - x, 3.0 - z]);
    let [left, right] = cameras.map(|[fx, fy, cx, cy]| {
        format!("%YAML:1.0\n---\nmodel_type: PINHOLE\nprojection_parameters:\n   fx: {fx}\n   fy: {fy}\n   cx: {cx}\n   cy: {cy}\n")
    });
    [format!("%YAML:1.0\n{settings}"), left, right]
}

fn bouguet(cameras: [[f64; 4]; 2], shift: [f64; 3], error: [f64; 4]) -> String {
    let [a, b, c, d] = error;
    let sides = ["left", "right"].iter().zip(cameras).map(|(side, [fx, fy, cx, cy])| {
        format!(
            "Focal Length:          fc_{side} = [ {fx}   {fy} ] +/- [ {a}   {b} ]\n\
             Principal point:       cc_{side} = [ {cx}   {cy} ] +/- [ {c}   {d} ]\n"
        )
    });
    format!(
        "{}Translation vector:           T = [ {} ] +/- [ 1 1 1 ]\n",
        sides.collect::<String>(),
        joined(&shift, "   ")
    )
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn arrays_of_numpy_hold_what_was_saved(left in camera(), right in camera(), t in shift(), is_fortran in any::<bool>()) {
        let [one, other] = [left, right].map(|camera| npy(&matrix(camera), [3, 3], is_fortran));
        prop_assert!(has(&read(&[&one]).unwrap(), &[left], None));
        let all = npz(&[("mtx_l", one), ("mtx_r", other), ("T", npy(&t, [3, 1], is_fortran))]);
        prop_assert!(has(&read(&[&all]).unwrap(), &[left, right], Some(norm(t))));
    }

    #[test]
    fn an_oak_camera_holds_what_was_written(left in camera(), right in camera(), t in shift()) {
        prop_assert!(has(&read(&[depth_ai([left, right], t).as_bytes()]).unwrap(), &[left, right], Some(norm(t))));
    }

    #[test]
    fn cameras_of_vins_hold_what_was_written(left in camera(), right in camera(), t in shift()) {
        let files = vins([left, right], t);
        let files: Vec<&[u8]> = files.iter().map(String::as_bytes).collect();
        // The body is meters away, which costs some digits.
        let found = read(&files).unwrap();
        prop_assert!(has(&found, &[left, right], None) && (value(&found) - norm(t)).abs() < 1e-12);
    }

    #[test]
    fn results_of_bouguets_toolbox_hold_what_was_written(left in camera(), right in camera(), t in shift(), error in [0.1..9.0, 0.1..9.0, 0.1..9.0, 0.1..9.0]) {
        let found = read(&[bouguet([left, right], t, error).as_bytes()]).unwrap();
        prop_assert!(has(&found, &[left, right], Some(norm(t))));
        let sigma = found.cameras[1].sigma.unwrap().map(|one| one.px());
        prop_assert!(sigma.iter().zip(error).all(|(got, error)| is_same(*got, error / 3.0)));
    }

    #[test]
    fn robots_scenes_and_names_hold_what_was_written(one in camera(), baseline in 0.02..2.0) {
        let [fx, fy, cx, cy] = one;
        let k = joined(&matrix(one), " ");
        let text = format!("{k}\n{baseline}\n");
        prop_assert!(has(&read(&[text.as_bytes()]).unwrap(), &[one], Some(baseline)));
        let ftc = format!(
            "<Calibrations><Camera vid=\"a\" pid=\"b\"><Calibration size=\"1280 800\" focalLength=\"{fx}f, {fy}f\" principalPoint=\"{cx} {cy}\"/>\
             </Camera></Calibrations>"
        );
        prop_assert!(has(&read(&[ftc.as_bytes()]).unwrap(), &[one], None));
        let scene = format!(r#"{{"fl_x":{fx},"fl_y":{fy},"cx":{cx},"cy":{cy},"w":1280,"h":800,"frames":[]}}"#);
        prop_assert!(has(&read(&[scene.as_bytes()]).unwrap(), &[one], None));
        let angles = [1280.0 / 2.0 / fx, 800.0 / 2.0 / fy].map(|tan: f64| 2.0 * tan.atan());
        let [x, y] = angles;
        let scene = format!(r#"{{"camera_angle_x":{x},"camera_angle_y":{y},"cx":{cx},"cy":{cy},"w":1280,"h":800,"frames":[]}}"#);
        prop_assert!(has(&read(&[scene.as_bytes()]).unwrap(), &[one], None));
        let columns = format!(r#"{{"width":1280,"height":800,"intrinsic_matrix":[{fx},0,0,0,{fy},0,{cx},{cy},1]}}"#);
        prop_assert!(has(&read(&[columns.as_bytes()]).unwrap(), &[one], None));
        let names = format!(r#"{{"fx":{fx},"fy":{fy},"ppx":{cx},"ppy":{cy},"baseline":{baseline}}}"#);
        prop_assert!(has(&read(&[names.as_bytes()]).unwrap(), &[one], Some(baseline)));
    }
}
