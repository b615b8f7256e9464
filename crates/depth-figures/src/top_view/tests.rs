#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

use super::*;
use crate::faults::{faults, is_free_of_text, texts};
use crate::{Ink, InterWidths, Point, Shape};
use depth_core::problem::{Field, Method};
use depth_core::quantity::LengthUnit;
use depth_core::setup::{Object, Pair};
use depth_text::assess::Assessment;
use depth_text::field::Key;
use depth_text::fields;
use depth_text::form::Inputs;

const WIDTHS: [f32; 6] = [300.0, 326.0, 368.0, 437.0, 560.0, 784.0];

/// The form with these fields: value and σ, each with its unit.
fn inputs(typed: &[(Key, &str, &str)]) -> Inputs {
    let mut inputs = Inputs { ..Inputs::default() };
    for (key, value, sigma) in typed {
        inputs.entry_mut(*key).text = (*value).to_owned();
        inputs.set_sigma(*key, *sigma);
    }
    inputs
}

fn stereo(f: &str, b: &str, d: &str) -> Inputs {
    inputs(&[
        (fields::FOCAL_LENGTH, f, "0.3 %"),
        (fields::BASELINE, b, "0.5 %"),
        (fields::DISPARITY, d, "1 %"),
    ])
}

fn both(b: &str, d: &str, w_img: &str, w_real: &str) -> Inputs {
    let mut inputs = stereo("700", b, d);
    inputs.entry_mut(fields::IMAGE_WIDTH).text = w_img.into();
    inputs.set_sigma(fields::IMAGE_WIDTH, "2 px");
    inputs.entry_mut(fields::REAL_WIDTH).text = w_real.into();
    inputs.set_sigma(fields::REAL_WIDTH, "3 %");
    inputs
}

fn parcel() -> Inputs {
    both("100 mm", "50", "150", "0.30 m")
}

fn model(inputs: &Inputs) -> Model {
    of(&inputs.assess(), None)
}

fn of(now: &Assessment, before: Option<&Assessment>) -> Model {
    let source = Source {
        now,
        before,
        unit: LengthUnit::Meter,
        angle: None,
    };
    Model::new(source).unwrap()
}

fn view(model: &Model, width: f32) -> TopView {
    TopView::new(model, [width, 290.0], Options::default(), &InterWidths)
}

/// Models from a thousandth to a thousand times the size of anything, with what can be wrong in a picture.
fn cases() -> Vec<Model> {
    let mut cases = Vec::new();
    for b in ["1 mm", "100 mm", "0.5 m", "10 m", "200 m"] {
        for d in ["0.007", "0.7", "7", "50", "700", "7000"] {
            cases.push(model(&stereo("700", b, d)));
            for (w_img, w_real) in [
                ("150", "0.30 m"),
                ("11667", "50 m"),
                ("1", "3 mm"),
                ("15", "3 m"),
                ("3000", "20 cm"),
            ] {
                cases.push(model(&both(b, d, w_img, w_real)));
            }
        }
    }
    let mut special = parcel();
    special.entry_mut(fields::ZERO).text = "0.2 m".into();
    cases.push(model(&special));
    special.entry_mut(fields::ZERO).text = "-0.2 m".into();
    cases.push(model(&special));
    let mut side = parcel();
    side.pair = Pair::Vertical;
    side.object = Object::Height;
    cases.push(model(&side));
    let mut with_angle = cases[0].clone();
    for angle in ["(4.091 ± 0.036)°", "(0.000 012 ± 0.000 003)°"] {
        with_angle.angle = Some(angle.to_owned());
        cases.push(with_angle.clone());
    }
    cases
}

#[test]
fn nothing_is_outside_and_no_text_is_on_another_whatever_the_numbers() {
    for model in cases() {
        for width in WIDTHS {
            for height in [230.0, 290.0, 480.0] {
                let view = TopView::new(&model, [width, height], Options::default(), &InterWidths);
                let faults = faults(&view.figure);
                assert!(faults.is_empty(), "{model:?} at {width} × {height}: {faults:#?}");
            }
        }
    }
}

#[test]
fn no_text_is_on_the_ring_or_on_a_camera() {
    for model in cases() {
        for width in WIDTHS {
            let view = view(&model, width);
            for point in view.ring.iter().chain(view.cameras.iter().flatten()) {
                assert!(is_free_of_text(&view.figure, *point, 5.0), "{model:?} at {width}");
            }
        }
    }
}

#[test]
fn every_label_is_there_whatever_the_numbers() {
    for model in cases() {
        for width in WIDTHS {
            let texts = texts(&view(&model, width).figure);
            let has = |start: &str| texts.iter().any(|(text, _)| text.starts_with(start));
            assert!(model.stereo.is_none() || has("D (stereo)"), "{model:?} at {width}");
            assert!(model.monocular.is_none() || has("D (monocular)"), "{model:?} at {width}");
            assert!(model.baseline.is_none() || has("b"), "{model:?} at {width}");
            assert!(model.width.is_none() || has("wreal"), "{model:?} at {width}");
            let numbers = texts
                .iter()
                .filter(|(text, _)| text.starts_with(|c: char| c.is_ascii_digit() || c == '−'))
                .count();
            assert!(numbers >= 3, "{model:?} at {width}");
        }
    }
}

#[test]
fn a_length_across_is_as_long_as_the_same_length_ahead_unless_the_picture_says_otherwise() {
    for model in cases() {
        for width in WIDTHS {
            let view = view(&model, width);
            let texts = texts(&view.figure);
            let is_baseline_broken = view.caption.contains("but for b");
            let is_depth_moved = texts.iter().any(|(text, _)| text == "not to scale");
            if let (Some([left, right]), Some((meters, _))) = (view.cameras, &model.baseline)
                && !is_baseline_broken
            {
                let drawn = f64::from(right.x - left.x);
                assert!(
                    (drawn - meters * view.per_meter).abs() < 0.05 + drawn * 1e-4,
                    "{model:?} at {width}"
                );
            }
            if let (Some(ring), Some(sight)) = (view.ring, &model.stereo)
                && !is_depth_moved
            {
                let drawn = f64::from(view.ground.y - ring.y);
                assert!(
                    (drawn - sight.depth_m * view.per_meter).abs() < 0.5 + drawn * 1e-4,
                    "{model:?} at {width}"
                );
            }
        }
    }
}

#[test]
fn a_ring_that_is_not_moved_stands_for_the_distance_that_it_was_drawn_for() {
    for model in cases() {
        let view = view(&model, 368.0);
        let distance = view.distance_at(view.ring.unwrap()).unwrap().m();
        let wanted = model.stereo.as_ref().unwrap().depth_m - model.zero_m;
        assert!((distance / wanted - 1.0).abs() < 1e-6, "{distance} {wanted}");
        let baseline = view.baseline_at(view.cameras.unwrap()[1]).unwrap().m();
        assert!((baseline / model.baseline.as_ref().unwrap().0 - 1.0).abs() < 1e-3, "{baseline}");
    }
}

#[test]
fn a_ring_follows_the_pointer_while_the_scale_is_held() {
    let start = view(&model(&parcel()), 368.0);
    let pointer = Point::new(200.0, start.ring.unwrap().y + 60.0);
    let distance = start.distance_at(pointer).unwrap().m();
    let disparity = 70.0 / distance;
    let dragged = model(&both("100 mm", &format!("{disparity}"), "150", "0.30 m"));
    let options = Options {
        hold: Some(start.per_meter),
        ..Options::default()
    };
    let now = TopView::new(&dragged, [368.0, 290.0], options, &InterWidths);
    assert!((now.ring.unwrap().y - pointer.y).abs() < 0.1, "{:?} {pointer:?}", now.ring);
    assert_eq!(start.distance_at(Point::new(0.0, 289.0)), None);
}

#[test]
fn the_parcel_is_the_picture_of_the_design() {
    let model = model(&parcel());
    let options = Options {
        drag: Drag::PointerAndKeys,
        hold: None,
    };
    let view = TopView::new(&model, [368.0, 290.0], options, &InterWidths);
    assert_eq!(view.caption, "to scale but for ±, grid 0.5 m");
    assert_eq!(view.note, "Ellipse, bracket: 1 σ, 5 × as large. The ring can be dragged.");
    let texts: Vec<String> = texts(&view.figure).into_iter().map(|(text, _)| text).collect();
    for text in [
        "Z (m)",
        "X (m)",
        "b = 100 mm",
        "wreal = 0.30 m",
        "D (stereo)",
        "D (monocular)",
        "1.400 m",
        "−1.0",
    ] {
        assert!(texts.iter().any(|written| written == text), "{text} is not in {texts:?}");
    }
}

#[test]
fn cameras_that_cannot_be_told_apart_are_drawn_apart_and_the_picture_says_so() {
    let view = view(&model(&both("100 mm", "50", "150", "3.0 m")), 368.0);
    let [left, right] = view.cameras.unwrap();
    assert!(right.x - left.x >= 12.0);
    assert!(view.caption.starts_with("to scale but for b"), "{}", view.caption);
    let texts = texts(&view.figure);
    assert!(texts.iter().any(|(text, _)| text.starts_with("b = 100 mm")), "{texts:?}");
}

#[test]
fn one_camera_is_enough_for_an_object_of_known_width() {
    let door = inputs(&[
        (fields::FOCAL_LENGTH, "950", "2"),
        (fields::IMAGE_WIDTH, "200", "2"),
        (fields::REAL_WIDTH, "0.9 m", "1 cm"),
    ]);
    let model = model(&door);
    for width in WIDTHS {
        let view = view(&model, width);
        assert_eq!((view.ring, view.cameras), (None, None));
        assert!(faults(&view.figure).is_empty());
        assert!(texts(&view.figure).iter().any(|(text, _)| text == "D (monocular)"));
        assert_eq!(view.note, "Bracket: ± 1 σ.");
    }
}

#[test]
fn a_distance_that_is_refused_is_gray_and_the_other_is_not() {
    let before = parcel().assess();
    let mut refused = parcel();
    refused.entry_mut(fields::DISPARITY).text = "-12".into();
    let model = of(&refused.assess(), Some(&before));
    assert!(model.stereo.as_ref().unwrap().is_stale && !model.monocular.as_ref().unwrap().is_stale);
    let view = view(&model, 368.0);
    assert!(view.note.starts_with("Gray: the last valid stereo distance."));
    let is_blue = |shape: &Shape| matches!(shape, Shape::Path { stroke: Some(stroke), .. } if stroke.ink == Ink::Stereo);
    assert!(!view.figure.shapes.iter().any(is_blue));
    // What was emptied was not refused: it is gone.
    refused.entry_mut(fields::DISPARITY).text.clear();
    assert_eq!(of(&refused.assess(), Some(&before)).stereo, None);
}

#[test]
fn a_given_distance_is_said_to_be_given() {
    let mut inputs = stereo("700", "100 mm", "");
    inputs.unknown = Some((Method::Stereo, Field::Disparity));
    inputs.entry_mut(fields::DISTANCE).text = "1.40 m".into();
    inputs.set_sigma(fields::DISTANCE, "1 cm");
    let texts: Vec<String> = texts(&view(&model(&inputs), 368.0).figure)
        .into_iter()
        .map(|(text, _)| text)
        .collect();
    assert!(
        texts.contains(&"D (given)".to_owned()) && texts.contains(&"1.40 m".to_owned()),
        "{texts:?}"
    );
}

#[test]
fn heights_are_seen_from_the_side() {
    let mut inputs = parcel();
    inputs.pair = Pair::Vertical;
    inputs.object = Object::Height;
    let view = view(&model(&inputs), 368.0);
    assert!(texts(&view.figure).iter().any(|(text, _)| text == "Y (m)"));
    assert!(view.note.contains("Seen from the side."));
}

#[test]
fn what_is_too_large_for_a_picture_has_none() {
    let assessment = stereo("1e200", "10 cm", "50").assess();
    let source = Source {
        now: &assessment,
        before: None,
        unit: LengthUnit::Meter,
        angle: None,
    };
    assert_eq!(Model::new(source), None);
}

#[test]
fn a_turned_object_is_named_by_what_shows_of_it() {
    let mut inputs = parcel();
    inputs.entry_mut(fields::TILT).text = "60".into();
    let turned = model(&inputs);
    assert!((turned.width.as_ref().unwrap().0 - 0.15).abs() < 1e-12);
    let view = view(&turned, 560.0);
    let said = texts(&view.figure);
    assert!(said.iter().any(|(text, _)| text.contains("· cos φ = 0.1500 m")), "{said:?}");
}
