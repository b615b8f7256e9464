//! The ground plane: a camera above a floor from the side, what it sees, and the floor from above.

mod above;
mod image;
mod model;
mod side;
#[cfg(test)]
mod tests;

pub use above::Above;
pub use image::ImageView;
pub use model::{Eye, Model};
pub use side::SideView;

use crate::floor::LABEL_TEXT;
use crate::labels::{Label, Labels, Place};
use crate::{Align, Figure, Ink, Point, Rect, Stroke, Words};

/// Radius of the rings.
const RING: f32 = 6.5;

/// Lines that belong to no method.
const LINE: Stroke = Stroke::new(Ink::Text, 1.75);

/// Dots that lead from one thing to another.
const DOTS: Stroke = Stroke::dashed(Ink::Border, 1.0, [1.5, 3.0]);

/// A label in the heavier weight.
fn strong(text: impl Into<String>) -> Label {
    Label::line(Words::strong(text, Ink::Text), LABEL_TEXT)
}

/// A label that matters less.
fn muted(text: impl Into<String>) -> Label {
    Label::line(Words::new(text, Ink::Muted), LABEL_TEXT)
}

/// A level dimension line with `label` in the middle of it, or beside it where it is too short.
fn level_dimension(scene: &mut Figure, labels: &mut Labels<'_>, [from, to]: [Point; 2], label: &Label, width: f32) {
    let (from, to) = if from.x <= to.x { (from, to) } else { (to, from) };
    let middle = Point::new(f32::midpoint(from.x, to.x), from.y);
    let cap = |scene: &mut Figure, at: Point| scene.line(Point::new(at.x, at.y - 4.0), Point::new(at.x, at.y + 4.0), LINE);
    let half = width / 2.0 + 5.0;
    let has_room = to.x - from.x >= 2.0 * half + 12.0;
    let parts = if has_room {
        vec![
            (from, Point::new(middle.x - half, from.y)),
            (Point::new(middle.x + half, from.y), to),
        ]
    } else {
        vec![(from, to)]
    };
    cap(scene, from);
    cap(scene, to);
    for (start, end) in parts {
        scene.line(start, end, LINE);
        labels.keep_off(Rect::new(start.x - 2.0, start.y - 4.0, end.x + 2.0, end.y + 4.0));
    }
    let beside: [Place; 2] = [
        (Point::new(to.x + 10.0, to.y), Align::Left),
        (Point::new(from.x - 10.0, from.y), Align::Right),
    ];
    if has_room {
        labels.put(label, &[(middle, Align::Center)]);
    } else {
        labels.put(label, &beside);
    }
}

/// The part of a line inside `rect`; `None` where there is none.
fn clipped(from: Point, to: Point, rect: Rect) -> Option<[Point; 2]> {
    let (start, end) = crate::labels::part_inside(from, to, rect)?;
    let at = |part: f32| Point::new(from.x + part * (to.x - from.x), from.y + part * (to.y - from.y));
    Some([at(start), at(end)])
}
