//! What every picture must keep to, for tests.

use crate::labels::rect_at;
use crate::{Figure, InterWidths, Measure as _, Point, Rect, Shape};

/// What reaches out of `figure`, and which of its texts are on one another.
pub(crate) fn faults(figure: &Figure) -> Vec<String> {
    let mut faults = Vec::new();
    let frame = Rect::new(-0.51, -0.51, figure.width + 0.51, figure.height + 0.51);
    let texts = texts(figure);
    for shape in &figure.shapes {
        let bounds = bounds(shape);
        let is_inside =
            bounds.left >= frame.left && bounds.right <= frame.right && bounds.top >= frame.top && bounds.bottom <= frame.bottom;
        if !is_inside {
            faults.push(format!("outside: {shape:?}"));
        }
    }
    for (index, (text, rect)) in texts.iter().enumerate() {
        for (other, other_rect) in texts.iter().skip(index + 1) {
            if rect.overlaps(*other_rect) {
                faults.push(format!("{text:?} is on {other:?}"));
            }
        }
    }
    faults
}

/// Every text with the room that its letters take.
pub(crate) fn texts(figure: &Figure) -> Vec<(String, Rect)> {
    let text = |shape: &Shape| match shape {
        Shape::Text { words, .. } => Some((words.text(), bounds(shape))),
        _ => None,
    };
    figure.shapes.iter().filter_map(text).collect()
}

/// The room that `shape` takes.
fn bounds(shape: &Shape) -> Rect {
    match shape {
        Shape::Path { points, .. } => points.iter().fold(
            Rect::new(f32::INFINITY, f32::INFINITY, f32::NEG_INFINITY, f32::NEG_INFINITY),
            |rect, point| {
                assert!(point.x.is_finite() && point.y.is_finite(), "{points:?}");
                Rect::new(
                    rect.left.min(point.x),
                    rect.top.min(point.y),
                    rect.right.max(point.x),
                    rect.bottom.max(point.y),
                )
            },
        ),
        Shape::Rect { rect, .. } => *rect,
        Shape::Circle { center, radius, .. } => Rect::new(center.x - radius, center.y - radius, center.x + radius, center.y + radius),
        Shape::Text { at, align, words, size } => rect_at([InterWidths.width(words, *size), size * 0.95], (*at, *align)),
    }
}

/// Whether `point` is in no text of `figure`.
pub(crate) fn is_free_of_text(figure: &Figure, point: Point, around: f32) -> bool {
    let area = Rect::new(point.x - around, point.y - around, point.x + around, point.y + around);
    texts(figure).iter().all(|(_, rect)| !rect.overlaps(area))
}
