#![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

use super::*;
use crate::InterWidths;
use crate::faults::{faults, is_free_of_text, texts};
use depth_core::quantity::LengthUnit;
use depth_text::field::Key;
use depth_text::fields::{CAMERA_HEIGHT, CAMERA_PITCH, CX, CY, FLOOR_ANGLE, FLOOR_COLUMN, FLOOR_ROW, FOCAL_LENGTH, TARGET_HEIGHT};
use depth_text::form::Inputs;

const WIDTHS: [f32; 4] = [300.0, 368.0, 548.0, 784.0];

/// A camera with f = 700 px and 1280 × 720 pixels: its height, its pitch in degrees, the row, and the column if any.
fn camera(height: &str, pitch: &str, row: &str, column: &str) -> Inputs {
    let mut inputs = Inputs { ..Inputs::default() };
    let typed: [(Key, &str, &str); 7] = [
        (FOCAL_LENGTH, "700", ""),
        (CX, "640", ""),
        (CY, "360", ""),
        (CAMERA_HEIGHT, height, "4 %"),
        (CAMERA_PITCH, pitch, "0.5"),
        (FLOOR_ROW, row, ""),
        (FLOOR_COLUMN, column, ""),
    ];
    for (key, value, sigma) in typed {
        inputs.entry_mut(key).text = value.to_owned();
        inputs.set_sigma(key, sigma);
    }
    inputs
}

fn model(inputs: &Inputs) -> Option<Model> {
    Model::new(&inputs.assess(), LengthUnit::Meter)
}

fn mast() -> Model {
    let mut inputs = camera("1.20 m", "10", "500", "1100");
    inputs.set_sigma(CAMERA_HEIGHT, "5 cm");
    model(&inputs).unwrap()
}

fn cases() -> Vec<Model> {
    let mut cases = Vec::new();
    for height in ["2 mm", "1.20 m", "80 m"] {
        for pitch in ["-20", "2", "10", "45", "100"] {
            for row in ["0", "240", "361", "719"] {
                for column in ["", "0", "1100", "40000"] {
                    cases.extend(model(&camera(height, pitch, row, column)));
                }
            }
        }
    }
    for target in ["0.5 m", "3 m", "-1 m"] {
        for row in ["100", "500"] {
            let mut inputs = camera("1.20 m", "10", row, "1100");
            inputs.entry_mut(TARGET_HEIGHT).text = target.into();
            cases.extend(model(&inputs));
        }
    }
    let mut by_angle = camera("1.20 m", "10", "", "");
    by_angle.entry_mut(FLOOR_ANGLE).text = "11.31".into();
    cases.push(model(&by_angle).unwrap());
    assert!(cases.len() > 100, "{}", cases.len());
    cases
}

#[test]
fn nothing_is_outside_and_no_text_is_on_another_whatever_the_numbers() {
    for model in cases() {
        for width in WIDTHS {
            let mut figures = vec![
                SideView::new(&model, [width, 222.0], &InterWidths).figure,
                Above::new(&model, [width, 290.0], &InterWidths).figure,
            ];
            figures.extend(ImageView::new(&model, width.min(400.0), &InterWidths).map(|view| view.figure));
            figures.extend(ImageView::new(&model, 208.0, &InterWidths).map(|view| view.figure));
            for figure in figures {
                let faults = faults(&figure);
                assert!(faults.is_empty(), "{model:?} at {width}: {faults:#?}");
            }
        }
    }
}

#[test]
fn no_text_is_on_a_ring() {
    for model in cases() {
        for width in WIDTHS {
            let side = SideView::new(&model, [width, 222.0], &InterWidths);
            let above = Above::new(&model, [width, 290.0], &InterWidths);
            for (figure, ring) in [(&side.figure, side.ring), (&above.figure, above.ring)] {
                assert!(is_free_of_text(figure, ring, 5.0), "{model:?} at {width}");
            }
        }
    }
}

#[test]
fn the_camera_on_a_mast_is_the_picture_of_the_design() {
    let model = mast();
    let side = SideView::new(&model, [548.0, 222.0], &InterWidths);
    assert_eq!(
        side.caption,
        "to scale, grid 0.5 m high and 1 m ahead; on the floor: ± 1 σ thick, ± 2 σ thin"
    );
    let side_texts: Vec<String> = texts(&side.figure).into_iter().map(|(text, _)| text).collect();
    for text in [
        "θ = 10°",
        "α = 11.31°",
        "H = 1.20 m",
        "level",
        "optical axis",
        "3.08 m ahead",
        "Height (m)",
        "Ahead (m)",
    ] {
        assert!(side_texts.iter().any(|written| written == text), "{text} is not in {side_texts:?}");
    }
    let image = ImageView::new(&model, 208.0, &InterWidths).unwrap();
    assert_eq!(image.caption, "1280 × 720");
    let image_texts: Vec<String> = texts(&image.figure).into_iter().map(|(text, _)| text).collect();
    for text in ["horizon, v = 237", "center", "v = 500", "u = 1100"] {
        assert!(
            image_texts.iter().any(|written| written == text),
            "{text} is not in {image_texts:?}"
        );
    }
    let above = Above::new(&model, [368.0, 290.0], &InterWidths);
    assert_eq!(above.caption, "to scale, grid 1 m");
    let above_texts: Vec<String> = texts(&above.figure).into_iter().map(|(text, _)| text).collect();
    for text in ["2.13 m to the right", "ahead", "3.08 m", "3.74 m along the floor", "Right (m)"] {
        assert!(
            above_texts.iter().any(|written| written == text),
            "{text} is not in {above_texts:?}"
        );
    }
}

#[test]
fn a_point_is_where_the_pointer_was_that_it_was_dragged_to() {
    for model in cases() {
        let side = SideView::new(&model, [548.0, 222.0], &InterWidths);
        let ahead = side.ahead_at(side.ring);
        let wanted = model.ahead.value.m();
        assert!(
            (ahead.m() - wanted).abs() <= 1e-4 * (wanted.abs() + model.height.0),
            "{ahead:?} {model:?}"
        );
        if let (Some(row), Some(eye)) = (model.row_at(model.ahead.value), &model.eye) {
            assert!((row - eye.row.0).abs() < 1e-3 * (1.0 + eye.row.0.abs()), "{row} {model:?}");
        }
        let above = Above::new(&model, [368.0, 290.0], &InterWidths);
        let [right, ahead] = above.place_at(above.ring);
        let size = model.distance.value.m();
        assert!((ahead.m() - wanted).abs() < 1e-3 * size && (right.m() - model.right_m()).abs() < 1e-3 * size);
    }
    let image = ImageView::new(&mast(), 208.0, &InterWidths).unwrap();
    let [column, row] = image.pixel_at(image.ring);
    assert!((column - 1100.0).abs() < 0.1 && (row - 500.0).abs() < 0.1);
}

#[test]
fn a_point_far_away_has_heights_drawn_larger_and_says_so() {
    let far = model(&camera("1.20 m", "0", "365", "1100")).unwrap();
    assert!(far.ahead.value.m() > 100.0);
    let side = SideView::new(&far, [548.0, 222.0], &InterWidths);
    assert!(
        side.caption.starts_with("heights drawn") && side.caption.contains("× as large"),
        "{}",
        side.caption
    );
    let near = SideView::new(&mast(), [548.0, 222.0], &InterWidths);
    assert!(near.caption.starts_with("to scale"));
}
