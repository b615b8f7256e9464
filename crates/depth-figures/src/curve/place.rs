//! Where labels find a place that no line runs through.

use crate::{Point, Rect};

/// What a label must not lie on.
#[derive(Default)]
pub(super) struct Obstacles {
    lines: Vec<Vec<Point>>,
    /// Lines that a label may cover where there is no other place.
    thin: Vec<Vec<Point>>,
    rects: Vec<Rect>,
}

impl Obstacles {
    /// A line through points.
    pub(super) fn line(&mut self, points: &[Point]) {
        self.lines.push(points.to_vec());
    }

    /// A line that a label may cover where there is no other place.
    pub(super) fn thin_line(&mut self, points: &[Point]) {
        self.thin.push(points.to_vec());
    }

    /// An area.
    pub(super) fn rect(&mut self, rect: Rect) {
        self.rects.push(rect);
    }

    /// Whether nothing is within `room` points of `rect` but perhaps thin lines.
    pub(super) fn are_clear_of(&self, rect: Rect, room: f32) -> bool {
        let wide = widened(rect, room);
        !self.rects.iter().any(|other| other.overlaps(wide)) && !self.lines.iter().any(|line| crosses_line(line, wide))
    }

    /// Whether no thin line is within `room` points of `rect`.
    pub(super) fn thin_are_clear_of(&self, rect: Rect, room: f32) -> bool {
        !self.thin.iter().any(|line| crosses_line(line, widened(rect, room)))
    }
}

fn widened(rect: Rect, room: f32) -> Rect {
    Rect::new(rect.left - room, rect.top - room, rect.right + room, rect.bottom + room)
}

fn crosses_line(line: &[Point], rect: Rect) -> bool {
    line.windows(2).any(|pair| match pair {
        [from, to] => crosses(*from, *to, rect),
        _ => false,
    })
}

/// Whether the line from `from` to `to` has a part in `rect` (Liang and Barsky).
fn crosses(from: Point, to: Point, rect: Rect) -> bool {
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    let mut enters = 0.0_f32;
    let mut leaves = 1.0_f32;
    let sides = [
        (-dx, from.x - rect.left),
        (dx, rect.right - from.x),
        (-dy, from.y - rect.top),
        (dy, rect.bottom - from.y),
    ];
    for (slope, room) in sides {
        if slope == 0.0 {
            if room < 0.0 {
                return false;
            }
        } else if slope < 0.0 {
            enters = enters.max(room / slope);
        } else {
            leaves = leaves.min(room / slope);
        }
    }
    enters <= leaves
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_line_that_passes_between_two_corners_crosses_the_rectangle() {
        let rect = Rect::new(0.0, 0.0, 10.0, 10.0);
        let at = Point::new;
        assert!(crosses(at(-5.0, 5.0), at(15.0, 5.0), rect));
        assert!(crosses(at(-1.0, 3.0), at(3.0, -1.0), rect));
        assert!(!crosses(at(-3.0, 1.0), at(1.0, -3.0), rect));
        assert!(!crosses(at(11.0, -5.0), at(11.0, 15.0), rect));
    }
}
