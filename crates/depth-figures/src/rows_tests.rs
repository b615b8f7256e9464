//! Tests of the rows: the model and its layout.

use crate::bars::{Bars, RowId};
use crate::checks::{MUG, assert_tidy, bounds, cases, solved};
use crate::curve::{CurveModel, Shown};
use crate::rows::Rows;
use crate::sources::{Solved, Source};
use crate::spans::Span;
use crate::{Ink, InterWidths, Shape, Words};
use depth_core::problem::{Method, Origin};
use depth_core::quantity::LengthUnit;
use depth_generators::{any_problem, any_unit, delicate_problem};
use depth_text::unit::Unit;
use proptest::prelude::*;

const WIDTHS: [f32; 4] = [300.0, 326.0, 368.0, 560.0];
const HEIGHTS: [f32; 4] = [214.0, 230.0, 300.0, 420.0];

fn drawn(bars: &Bars) -> Rows {
    bars.layout(368.0, 220.0, &InterWidths)
}

fn mug() -> Rows {
    drawn(&Bars::new(&solved(MUG), None, LengthUnit::Meter))
}

fn disparity() -> Solved {
    let source = |name, share| Source {
        symbol: Words::symbol(name, Ink::Text),
        name: Words::symbol(name, Ink::Text),
        share,
    };
    Solved {
        name: "Disparity".to_owned(),
        quantity: crate::axis::Quantity::disparity(false),
        unit: Unit::Pixel,
        value: 50.0,
        sigma: 0.4588,
        method: Some(Method::Stereo),
        sources: vec![source("D", 0.606), source("b", 0.297), source("fx", 0.097)],
    }
}

#[test]
fn nothing_leaves_the_picture_and_no_text_is_over_another() {
    for (name, solution) in cases() {
        for last in [None, Some(solved(MUG))] {
            for unit in [LengthUnit::Meter, LengthUnit::Millimeter, LengthUnit::Inch] {
                let bars = Bars::new(&solution, last.as_ref(), unit);
                for width in WIDTHS {
                    for height in HEIGHTS {
                        let rows = bars.layout(width, height, &InterWidths);
                        assert_tidy(&rows.figure, &format!("{name} in {unit:?} on {width} × {height}"));
                    }
                }
            }
        }
    }
}

#[test]
fn no_interval_crosses_a_text() {
    for (name, solution) in cases() {
        for width in WIDTHS {
            let rows = Bars::new(&solution, Some(&solved(MUG)), LengthUnit::Meter).layout(width, 214.0, &InterWidths);
            let (texts, others): (Vec<_>, Vec<_>) = rows.figure.shapes.iter().partition(|shape| matches!(shape, Shape::Text { .. }));
            let bounds = |shape: &Shape| match shape {
                Shape::Path { stroke: Some(stroke), .. } if stroke.width >= 1.5 => Some((bounds(shape), stroke.width / 2.0)),
                Shape::Circle { .. } => Some((bounds(shape), 0.0)),
                _ => None,
            };
            for (line, half) in others.into_iter().filter_map(bounds) {
                let thick = crate::Rect::new(line.left, line.top - half, line.right, line.bottom + half);
                for text in &texts {
                    assert!(
                        !crate::checks::bounds(text).overlaps(thick),
                        "{name} on {width}: {text:?} {thick:?}"
                    );
                }
            }
        }
    }
}

#[test]
fn gains_stay_in_the_picture_whatever_is_solved_for() {
    for (value, sigma) in [(50.0, 0.46), (50.0, 1e-9), (-3.0, 20.0), (0.0, 1.0), (1e7, 2e6), (1e-9, 1e-10)] {
        for width in WIDTHS {
            let solved = Solved {
                value,
                sigma,
                ..disparity()
            };
            let rows = Bars::gains(&solved).layout(width, 230.0, &InterWidths);
            assert_tidy(&rows.figure, &format!("{value} ± {sigma} on {width}"));
        }
    }
}

#[test]
fn there_are_three_rows_in_their_places_whatever_is_known() {
    let places = |rows: &Rows| rows.rows.iter().map(|row| (row.id, row.hit)).collect::<Vec<_>>();
    let full = places(&mug());
    assert_eq!(
        full.iter().map(|(id, _)| *id).collect::<Vec<_>>(),
        [Origin::Method(Method::Stereo), Origin::Method(Method::Monocular), Origin::Combined].map(RowId::Distance)
    );
    for (name, solution) in cases() {
        assert_eq!(places(&drawn(&Bars::new(&solution, None, LengthUnit::Meter))), full, "{name}");
    }
}

#[test]
fn the_mug_agrees_on_an_axis_around_its_values() {
    let rows = mug();
    assert_eq!(rows.caption, "axis does not start at 0");
    let said: Vec<_> = rows.rows.iter().map(|row| row.value.text()).collect();
    assert_eq!(said, ["(1.400 ± 0.016) m", "(1.400 ± 0.050) m", "(1.400 ± 0.015) m"]);
    assert_eq!(rows.rows[1].tip, ["± 1 σ: 1.350…1.451 m", "± 2 σ: 1.300…1.502 m"]);
}

/// 1 % of σ, and 3 % between both: on an axis from zero nobody could see whether the intervals meet.
#[test]
fn agreement_can_be_seen_where_sigma_is_one_percent() {
    let solution = solved([(700.0, 0.0), (0.1, 0.0), (50.0, 0.5), (150.0, 1.5), (0.309, 0.0)]);
    let rows = drawn(&Bars::new(&solution, None, LengthUnit::Meter));
    let thick = rows.figure.shapes.iter().filter_map(|shape| match shape {
        Shape::Path {
            points,
            stroke: Some(stroke),
            ..
        } if stroke.width == 6.0 && points.len() == 2 && stroke.ink != Ink::Muted => Some((stroke.ink, points[1].x - points[0].x)),
        _ => None,
    });
    let lengths: Vec<_> = thick.collect();
    assert_eq!(lengths.len(), 3);
    for (ink, length) in lengths {
        assert!(length > 40.0, "{ink:?}: {length}");
    }
}

#[test]
fn two_distances_that_contradict_have_a_bracket_and_are_not_combined() {
    let mut inputs = MUG;
    inputs[4] = (3.0, 0.1);
    let rows = drawn(&Bars::new(&solved(inputs), None, LengthUnit::Meter));
    assert_eq!(
        (rows.caption.as_str(), rows.rows[2].value.text().as_str()),
        ("axis from zero", "not combined")
    );
    let is_said = rows
        .figure
        .shapes
        .iter()
        .any(|shape| matches!(shape, Shape::Text { words, .. } if words.text() == "10 times as far, over 10 σ apart"));
    assert!(is_said);
}

#[test]
fn what_holds_no_longer_is_gray_and_says_what_it_was() {
    let mut inputs = MUG;
    inputs[2] = (-12.0, 0.5);
    let rows = drawn(&Bars::new(&solved(inputs), Some(&solved(MUG)), LengthUnit::Meter));
    let said: Vec<_> = rows.rows.iter().map(|row| row.value.text()).collect();
    assert_eq!(said, ["was 1.400 m", "(1.400 ± 0.050) m", "was 1.400 m"]);
    let without = drawn(&Bars::new(&solved(inputs), None, LengthUnit::Meter));
    let said: Vec<_> = without.rows.iter().map(|row| row.value.text()).collect();
    assert_eq!(said, ["no distance", "(1.400 ± 0.050) m", "needs both distances"]);
}

/// 50 ± 60 px: the disparity may be 0.
#[test]
fn an_interval_without_an_end_has_an_arrow_at_the_edge() {
    let mut inputs = MUG;
    inputs[2] = (50.0, 60.0);
    let rows = drawn(&Bars::new(&solved(inputs), None, LengthUnit::Meter));
    let touches = rows.figure.shapes.iter().any(|shape| {
        matches!(shape, Shape::Path { points, fill: Some(fill), .. } if fill.ink == Ink::Stereo && points.iter().any(|point| point.x == 368.0))
    });
    assert!(touches);
    assert!(rows.rows[0].tip[0].ends_with("no upper bound"), "{:?}", rows.rows[0].tip);
}

#[test]
fn without_sigma_there_is_no_legend() {
    let rows = drawn(&Bars::new(&solved(MUG.map(|(value, _)| (value, 0.0))), None, LengthUnit::Meter));
    let text = |shape: &Shape| match shape {
        Shape::Text { words, .. } => Some(words.text()),
        _ => None,
    };
    let texts: Vec<_> = rows.figure.shapes.iter().filter_map(text).collect();
    assert!(!texts.iter().any(|text| text.contains('σ')), "{texts:?}");
    assert_eq!(rows.rows[2].value.text(), "needs ± in both");
}

/// √(1 − 60.6 %) = 63 %.
#[test]
fn without_a_source_its_share_of_the_variance_is_gone() {
    let bars = Bars::gains(&disparity());
    let said: Vec<_> = bars.rows.iter().map(|row| (row.name.text(), row.value.text())).collect();
    let expected = [
        ("All as typed", "± 0.46 px"),
        ("D exact", "37 % less   ± 0.29 px"),
        ("b exact", "16 % less   ± 0.38 px"),
        ("fx exact", "5 % less   ± 0.44 px"),
    ];
    assert_eq!(said, expected.map(|(name, value)| (name.to_owned(), value.to_owned())));
    let Some(Span { low, high: Some(high) }) = bars.band else {
        panic!("no band")
    };
    assert!((high - low - 2.0 * 0.4588).abs() < 1e-12);
    assert_eq!(drawn(&bars).caption, "axis does not start at 0");
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(300))]

    #[test]
    fn every_problem_can_be_drawn(problem in prop_oneof![any_problem(), delicate_problem()], last in any_problem(), unit in any_unit()) {
        let (solution, last) = (problem.solve(), last.solve());
        let rows = Bars::new(&solution, Some(&last), unit).layout(326.0, 230.0, &InterWidths);
        assert_tidy(&rows.figure, "rows");
        if let Some(model) = CurveModel::new(&solution, Some(&last), unit) {
            let tip = model.point.as_ref().map(|point| point.x);
            for tip in [None, tip] {
                let shown = Shown { axes: None, tip };
                assert_tidy(&model.layout(326.0, 230.0, &shown, &InterWidths).figure, "curve");
            }
        }
    }
}
