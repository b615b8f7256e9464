//! Tests of the curve: its model, its layout, and what a window asks of it.

use super::{CurveModel, Kind, Shown};
use crate::checks::{MUG, assert_tidy, cases, solved};
use crate::{InterWidths, Shape};
use depth_core::measured::Measured;
use depth_core::problem::{Field, Problem};
use depth_core::quantity::LengthUnit::Meter;

const WIDTHS: [f32; 4] = [300.0, 326.0, 368.0, 560.0];
const HEIGHTS: [f32; 2] = [220.0, 420.0];

fn mug() -> CurveModel {
    CurveModel::new(&solved(MUG), None, Meter).unwrap()
}

fn texts(curve: &super::Curve) -> Vec<String> {
    let text = |shape: &Shape| match shape {
        Shape::Text { words, .. } => Some(words.text()),
        _ => None,
    };
    curve.figure.shapes.iter().filter_map(text).collect()
}

#[test]
fn nothing_leaves_the_picture_and_no_text_is_over_another() {
    let mut drawn = 0;
    for (name, solution) in cases() {
        for last in [None, Some(solved(MUG))] {
            let Some(model) = CurveModel::new(&solution, last.as_ref(), Meter) else {
                continue;
            };
            for width in WIDTHS {
                for height in HEIGHTS {
                    let what = format!("{name} on {width} × {height}");
                    let curve = model.layout(width, height, &Shown::default(), &InterWidths);
                    assert_tidy(&curve.figure, &what);
                    // Along the whole axis, as a drag does with the axes of its start.
                    for step in [0.02, 0.3, 0.6, 0.95] {
                        let x = curve.axes.x.value_at(step);
                        let mut problem = solution.problem;
                        problem.set(Field::Disparity, Some(x - model.doffs()));
                        let Some(moved) = CurveModel::new(&problem.solve(), None, Meter) else {
                            continue;
                        };
                        let shown = Shown {
                            axes: Some(&curve.axes),
                            tip: None,
                        };
                        assert_tidy(&moved.layout(width, height, &shown, &InterWidths).figure, &format!("{what} at {x}"));
                    }
                    drawn += 1;
                }
            }
        }
    }
    assert!(drawn > 80, "{drawn}");
}

#[test]
fn a_tip_covers_neither_the_curve_nor_the_ring() {
    for width in WIDTHS {
        let model = mug();
        let shown = Shown {
            axes: None,
            tip: Some(50.0),
        };
        let curve = model.layout(width, 220.0, &shown, &InterWidths);
        let tip = curve.tip.unwrap();
        let ring = curve.handle.unwrap();
        assert!(ring.x + 8.0 < tip.left || ring.y - 8.0 > tip.bottom, "{tip:?} {ring:?}");
        for step in 30..100_u32 {
            let x = f64::from(step);
            let at = curve.point_at(x, model.value_at(x).unwrap());
            assert!(
                !(tip.left..tip.right).contains(&at.x) || !(tip.top..tip.bottom).contains(&at.y),
                "{width}: {at:?} {tip:?}"
            );
        }
    }
}

#[test]
fn the_mug_has_the_numbers_of_its_card() {
    let curve = mug().layout(
        368.0,
        220.0,
        &Shown {
            axes: None,
            tip: Some(50.0),
        },
        &InterWidths,
    );
    assert_eq!((curve.axes.x.high, curve.axes.y.high), (100.0, 4.0));
    assert_eq!(curve.caption, "band: ± 2 σ");
    let said = texts(&curve);
    for text in [
        "Distance D (m)",
        "Disparity d (px)",
        "50",
        "1.400",
        "monocular 1.400 m",
        "d = (50 ± 0.5) px",
        "D = (1.400 ± 0.016) m",
        "49 px: 1.429 m",
        "51 px: 1.373 m",
    ] {
        assert!(said.iter().any(|said| said == text), "{text}: {said:?}");
    }
}

#[test]
fn every_point_of_the_curve_obeys_the_formula() {
    let model = mug();
    for x in [17.5, 40.0, 50.0, 100.0] {
        assert!((model.value_at(x).unwrap() * x / 70.0 - 1.0).abs() < 1e-12);
    }
}

#[test]
fn a_monocular_distance_beyond_the_top_is_named_with_its_disparity() {
    let mut inputs = MUG;
    inputs[4] = (3.0, 0.1);
    for width in WIDTHS {
        let curve = CurveModel::new(&solved(inputs), None, Meter)
            .unwrap()
            .layout(width, 220.0, &Shown::default(), &InterWidths);
        assert!(texts(&curve).iter().any(|text| text.starts_with("monocular 14.00 m")), "{width}");
    }
}

#[test]
fn the_last_valid_point_is_gray_and_named() {
    let mut inputs = MUG;
    inputs[2] = (-12.0, 0.5);
    let model = CurveModel::new(&solved(inputs), Some(&solved(MUG)), Meter).unwrap();
    assert!(model.is_stale);
    assert_eq!(model.caption(), "last valid: d = 50 px");
    let alone = CurveModel::new(&solved(inputs), None, Meter).unwrap();
    assert_eq!((alone.is_stale, alone.point), (false, None));
}

#[test]
fn a_drag_gives_round_disparities_above_zero() {
    let curve = mug().layout(368.0, 220.0, &Shown::default(), &InterWidths);
    let at = |x: f64| curve.disparity_at(curve.x_of(x));
    assert_eq!(at(60.04), 60.0);
    assert_eq!(curve.disparity_at(-500.0), 0.1);
    assert_eq!(curve.disparity_at(5000.0), 100.0);
    let crosshair = mug().crosshair(&curve, curve.x_of(50.0)).unwrap();
    assert_eq!((crosshair.x, crosshair.step), (50.0, 1.0));
    assert_eq!(crosshair.lines[1].text(), "D = (1.400 ± 0.016) m");
    assert_eq!(mug().crosshair(&curve, 0.0), None);
}

/// 700 px · 0.1 m / (50 px + 40 px).
#[test]
fn doffs_is_part_of_the_axis_and_not_of_what_is_dragged() {
    let mut problem = solved(MUG).problem;
    problem.set(Field::Doffs, Some(40.0));
    let model = CurveModel::new(&problem.solve(), None, Meter).unwrap();
    assert_eq!(model.point.as_ref().unwrap().x, 90.0);
    let curve = model.layout(368.0, 220.0, &Shown::default(), &InterWidths);
    assert_eq!(curve.axes.x.title(), "Disparity d + doffs (px)");
    assert_eq!(curve.disparity_at(curve.x_of(90.0)), 50.0);
    assert!(curve.disparity_at(0.0) + 40.0 > 0.0);
    assert_eq!(model.tip_at(90.0)[0].text(), "d = (50 ± 0.5) px");
}

#[test]
fn the_inverse_plot_has_the_disparity_of_a_distance() {
    let problem = solved(MUG).problem;
    let mut model = CurveModel::inverse(&problem, Measured::from_base(1.4, 0.01), Meter).unwrap();
    assert_eq!(model.kind, Kind::Disparity);
    model.point.as_mut().unwrap().x_text = "1.40".to_owned();
    let said: Vec<_> = model.tip_at(1.4).iter().map(crate::Words::text).collect();
    assert_eq!(
        said,
        [
            "D = (1.40 ± 0.01) m",
            "d = (50.00 ± 0.46) px",
            "1.30 m: 53.85 px",
            "1.50 m: 46.67 px"
        ]
    );
    for width in WIDTHS {
        let shown = Shown {
            axes: None,
            tip: Some(1.4),
        };
        let curve = model.layout(width, 220.0, &shown, &InterWidths);
        assert_eq!((curve.axes.x.high, curve.axes.y.high), (4.0, 100.0));
    }
    for meters in [1e-6, 0.01, 30.0, 1e6] {
        let model = CurveModel::inverse(&problem, Measured::from_base(meters, meters / 50.0), Meter).unwrap();
        assert_tidy(
            &model.layout(326.0, 220.0, &Shown::default(), &InterWidths).figure,
            &format!("{meters} m"),
        );
    }
}

#[test]
fn what_cannot_be_drawn_has_no_curve_rather_than_a_broken_one() {
    let pair = |f: f64, b: f64| {
        let mut problem = Problem::default();
        problem.set(Field::FocalLength, Some(f));
        problem.set(Field::Baseline, Some(b));
        CurveModel::new(&problem.solve(), None, Meter)
    };
    assert_eq!(CurveModel::new(&Problem::default().solve(), None, Meter), None);
    assert_eq!(pair(1e300, 1e300), None);
    assert!(pair(1e150, 1e-150).is_some());
}

#[test]
fn axes_move_from_those_of_a_drag_to_those_of_the_point() {
    let (from, to) = (
        mug().axes().clone(),
        CurveModel::new(&solved([MUG[0], MUG[1], (5.0, 0.5), MUG[3], MUG[4]]), None, Meter).unwrap(),
    );
    assert_eq!(from.eased(to.axes(), 0.0), from);
    assert_eq!(&from.eased(to.axes(), 1.0), to.axes());
}
