//! "What the letters mean": the two cameras from above, both images, and the two formulas. No numbers, and not to scale.

mod above;
mod formulas;
mod images;
mod pen;

use crate::{Figure, Ink, Measure, Point, Stroke};
use pen::Pen;

/// What is said at the right of the title.
pub const CAPTION: &str = "from above; cameras and images drawn larger than they are";

/// The same where there is less room.
pub const SHORT_CAPTION: &str = "cameras drawn larger";

/// Narrower than this, the images stand below the cameras.
const NARROW: f32 = 560.0;

/// Everything that the letters stand for, `width` points wide and as high as it has to be; never narrower than 300.
///
/// `highlighted` is the symbol of the field that has the focus, such as "fx" or "`w_img`": it has a box behind it.
pub fn figure(width: f32, highlighted: Option<&str>, has_doffs: bool, measure: &dyn Measure) -> Figure {
    let width = width.max(300.0);
    let mut pen = Pen {
        figure: Figure::new(width, 0.0),
        measure,
        highlighted,
    };
    let bottom = if width >= NARROW {
        let images = (width * 0.342).clamp(204.0, 320.0);
        let schema = above::Schema::new(width - images - 32.0, 0.0, measure);
        schema.draw(&mut pen);
        let stack = images::Stack {
            left: width - images,
            top: 8.0,
            width: images,
            frame: 184.0,
        };
        schema.bottom().max(stack.draw(&mut pen))
    } else {
        let schema = above::Schema::new(width, 0.0, measure);
        schema.draw(&mut pen);
        let stack = images::Stack {
            left: 0.0,
            top: schema.bottom() + 26.0,
            width,
            frame: 150.0,
        };
        stack.draw(&mut pen)
    };
    let line = bottom + 22.0;
    pen.figure
        .line(Point::new(0.0, line), Point::new(width, line), Stroke::new(Ink::Line, 1.0));
    let end = pen.formulas(line + 32.0, has_doffs);
    pen.figure.height = end;
    pen.figure
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::faults::{faults, texts};
    use crate::{InterWidths, Rect, Shape};

    const SYMBOLS: [&str; 6] = ["fx", "b", "d", "w_img", "w_real", "D"];

    #[test]
    fn nothing_is_outside_and_no_text_is_on_another_at_any_width() {
        for width in 300_u16..1200 {
            let figure = figure(f32::from(width), None, false, &InterWidths);
            let faults = faults(&figure);
            assert!(faults.is_empty(), "at {width}: {faults:#?}");
        }
    }

    #[test]
    fn every_letter_is_explained_at_every_width() {
        for width in [300.0, 326.0, 437.0, 559.0, 560.0, 784.0] {
            let texts = texts(&figure(width, None, false, &InterWidths));
            for letter in ["fx", "b", "d", "wimg", "wreal", "D", "the answer", "Left image", "Right image"] {
                assert!(texts.iter().any(|(text, _)| text == letter), "{letter} at {width}");
            }
        }
    }

    #[test]
    fn the_letter_of_the_field_with_the_focus_has_a_box_and_covers_nothing() {
        for width in [300.0, 326.0, 437.0, 560.0, 784.0] {
            let plain = figure(width, None, false, &InterWidths);
            for symbol in SYMBOLS {
                let highlighted = figure(width, Some(symbol), false, &InterWidths);
                let boxes: Vec<Rect> = highlighted
                    .shapes
                    .iter()
                    .filter(|shape| !plain.shapes.contains(shape))
                    .filter_map(|shape| match shape {
                        Shape::Rect { rect, .. } => Some(*rect),
                        _ => None,
                    })
                    .collect();
                assert_eq!(boxes.len(), 1, "{symbol} at {width}");
                let inside = texts(&highlighted)
                    .iter()
                    .filter(|(_, rect)| boxes.iter().any(|one| one.overlaps(*rect)))
                    .count();
                assert_eq!(inside, 1, "{symbol} at {width}");
                assert!(faults(&highlighted).is_empty(), "{symbol} at {width}");
            }
        }
    }
}
