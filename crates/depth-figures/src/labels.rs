//! Labels in a picture: each looks for a place where it hides nothing and nothing hides it.

use crate::{Align, Figure, Fill, Ink, Measure, Point, Rect, Shape, Words};

/// From line to line of a label.
const LINE: f32 = 16.0;
/// Free room at the ends of a label, and above and below it.
const ROOM: [f32; 2] = [3.0, 1.0];
/// How far apart the places are that are tried where none of the wanted ones is free.
const STEP: f32 = 6.0;
/// A label farther than this from where it belongs would not be understood as its own.
const NEAR: f32 = 90.0;

/// One or more lines of text that stand together.
#[derive(Clone, Debug)]
pub(crate) struct Label {
    pub(crate) lines: Vec<Words>,
    pub(crate) size: f32,
}

/// A place for a label: its left end, middle or right end is there, and the middle of its height.
pub(crate) type Place = (Point, Align);

/// What a label should not be drawn over.
#[derive(Clone, Copy, Debug)]
enum Obstacle {
    Area(Rect),
    Line(Point, Point),
}

/// Finds places for labels, and draws them.
pub(crate) struct Labels<'a> {
    measure: &'a dyn Measure,
    frame: Rect,
    /// Whether a label hides what is behind it.
    has_ground: bool,
    /// Never covered.
    hard: Vec<Obstacle>,
    /// Covered only where there is no other place.
    soft: Vec<Obstacle>,
    below: Vec<Shape>,
    above: Vec<Shape>,
}

impl Label {
    /// One line.
    pub(crate) fn line(words: Words, size: f32) -> Self {
        Self { lines: vec![words], size }
    }

    fn extent(&self, measure: &dyn Measure) -> [f32; 2] {
        let widths = self.lines.iter().map(|line| measure.width(line, self.size));
        let lines = self.lines.iter().map(|_| LINE).sum::<f32>();
        [widths.fold(0.0, f32::max), lines - LINE + self.size * 1.1]
    }

    /// How wide it is.
    pub(crate) fn width(&self, measure: &dyn Measure) -> f32 {
        self.extent(measure)[0]
    }
}

impl<'a> Labels<'a> {
    pub(crate) const fn new(measure: &'a dyn Measure, frame: Rect) -> Self {
        Self {
            measure,
            frame,
            has_ground: true,
            hard: Vec::new(),
            soft: Vec::new(),
            below: Vec::new(),
            above: Vec::new(),
        }
    }

    /// The same where labels stand on areas of several colors, so that one color behind them would show.
    pub(crate) fn without_ground(mut self) -> Self {
        self.has_ground = false;
        self
    }

    /// Nothing may be written over `area`.
    pub(crate) fn keep_off(&mut self, area: Rect) {
        self.hard.push(Obstacle::Area(area));
    }

    /// Nothing may be written over this line.
    pub(crate) fn keep_off_line(&mut self, from: Point, to: Point) {
        self.hard.push(Obstacle::Line(from, to));
    }

    /// Nothing should be written over this line.
    pub(crate) fn avoid_line(&mut self, from: Point, to: Point) {
        self.soft.push(Obstacle::Line(from, to));
    }

    /// Whether `label` is free of everything at `place`.
    pub(crate) fn is_free_at(&self, label: &Label, place: Place) -> bool {
        self.is_free(rect_at(label.extent(self.measure), place), true)
    }

    /// Draws `label` at the first of `places` that is free, else as near to the first of them as there is room; not at all where there
    /// is none.
    pub(crate) fn put(&mut self, label: &Label, places: &[Place]) -> Option<Rect> {
        let first = *places.first()?;
        let place = self.first_free(label, places, true);
        let near = || Some((self.nearest(label.extent(self.measure), first, true, NEAR)?, false));
        let found = place.or_else(near);
        self.put_found(label, places, found)
    }

    /// The same for a label that would not be understood anywhere else: it rather covers a line.
    pub(crate) fn put_here(&mut self, label: &Label, places: &[Place]) -> Option<Rect> {
        let found = self.first_free(label, places, true);
        self.put_found(label, places, found)
    }

    fn put_found(&mut self, label: &Label, places: &[Place], found: Option<(Place, bool)>) -> Option<Rect> {
        let first = *places.first()?;
        let extent = label.extent(self.measure);
        let (place, covers) = found
            .or_else(|| self.first_free(label, places, false))
            .or_else(|| Some((self.nearest(extent, first, true, f32::INFINITY)?, false)))
            .or_else(|| Some((self.nearest(extent, first, false, f32::INFINITY)?, true)))?;
        let rect = rect_at(extent, place);
        self.hard.push(Obstacle::Area(rect));
        self.draw(label, place, covers);
        Some(rect)
    }

    /// The first of `places` that is free, and whether it covers what should not be covered.
    fn first_free(&self, label: &Label, places: &[Place], with_soft: bool) -> Option<(Place, bool)> {
        let extent = label.extent(self.measure);
        let is_free = |place: &Place| self.is_free(rect_at(extent, *place), with_soft);
        places.iter().copied().find(is_free).map(|place| (place, !with_soft))
    }

    fn draw(&mut self, label: &Label, (at, align): Place, covers: bool) {
        let extent = label.extent(self.measure);
        let behind = Shape::Rect {
            rect: within(with_room(rect_at(extent, (at, align))), self.frame),
            radius: 2.0,
            fill: Some(Fill::new(Ink::Surface)),
            stroke: None,
        };
        if self.has_ground {
            if covers { &mut self.above } else { &mut self.below }.push(behind);
        }
        let mut y = at.y - label.lines.iter().skip(1).map(|_| LINE / 2.0).sum::<f32>();
        for line in &label.lines {
            self.above.push(Shape::Text {
                at: Point::new(at.x, y),
                align,
                words: line.clone(),
                size: label.size,
            });
            y += LINE;
        }
    }

    /// The free place nearest to `first`, no farther than `most`.
    fn nearest(&self, extent: [f32; 2], first: Place, with_soft: bool, most: f32) -> Option<Place> {
        let wanted = rect_at(extent, first);
        let [width, height] = extent;
        let steps = |from: f32, to: f32| std::iter::successors(Some(from), move |at| Some(at + STEP).filter(|at| *at <= to));
        let mut best: Option<(f32, Point)> = None;
        for top in steps(self.frame.top, self.frame.bottom - height) {
            for left in steps(self.frame.left, self.frame.right - width) {
                // A place above or below reads better than one as far to the side.
                let far = (left - wanted.left).abs() + (top - wanted.top).abs();
                if far > most || best.is_some_and(|(nearest, _)| far >= nearest) {
                    continue;
                }
                if self.is_free(Rect::new(left, top, left + width, top + height), with_soft) {
                    best = Some((far, Point::new(left, top + height / 2.0)));
                }
            }
        }
        let (_, left) = best?;
        Some(match first.1 {
            Align::Left => (left, Align::Left),
            Align::Center => (Point::new(left.x + width / 2.0, left.y), Align::Center),
            Align::Right => (Point::new(left.x + width, left.y), Align::Right),
        })
    }

    fn is_free(&self, rect: Rect, with_soft: bool) -> bool {
        let frame = self.frame;
        let is_inside = rect.left >= frame.left && rect.right <= frame.right && rect.top >= frame.top && rect.bottom <= frame.bottom;
        let rect = with_room(rect);
        let soft = self.soft.iter().filter(|_| with_soft);
        is_inside && !self.hard.iter().chain(soft).any(|obstacle| obstacle.meets(rect))
    }

    /// Adds everything to `figure`, with `scene` between what is behind the labels and the labels.
    pub(crate) fn finish(self, figure: &mut Figure, scene: Figure) {
        figure.shapes.extend(self.below);
        figure.shapes.extend(scene.shapes);
        figure.shapes.extend(self.above);
    }
}

impl Obstacle {
    fn meets(self, rect: Rect) -> bool {
        match self {
            Self::Area(area) => area.overlaps(rect),
            Self::Line(from, to) => line_meets(from, to, rect),
        }
    }
}

/// Where a label of this width and height stands.
pub(crate) fn rect_at([width, height]: [f32; 2], (at, align): Place) -> Rect {
    let left = match align {
        Align::Left => at.x,
        Align::Center => at.x - width / 2.0,
        Align::Right => at.x - width,
    };
    Rect::new(left, at.y - height / 2.0, left + width, at.y + height / 2.0)
}

/// `rect` with `by` more on every side.
pub(crate) fn grown(rect: Rect, by: f32) -> Rect {
    Rect::new(rect.left - by, rect.top - by, rect.right + by, rect.bottom + by)
}

fn with_room(rect: Rect) -> Rect {
    let [x, y] = ROOM;
    Rect::new(rect.left - x, rect.top - y, rect.right + x, rect.bottom + y)
}

/// The part of `rect` inside `frame`.
fn within(rect: Rect, frame: Rect) -> Rect {
    Rect::new(
        rect.left.max(frame.left),
        rect.top.max(frame.top),
        rect.right.min(frame.right),
        rect.bottom.min(frame.bottom),
    )
}

/// Whether a part of the line is inside `rect`.
fn line_meets(from: Point, to: Point, rect: Rect) -> bool {
    part_inside(from, to, rect).is_some()
}

/// From which to which part of the line it is inside `rect`: what is left of it after each side has cut off what is beyond (Liang and
/// Barsky, 1984).
pub(crate) fn part_inside(from: Point, to: Point, rect: Rect) -> Option<(f32, f32)> {
    let (dx, dy) = (to.x - from.x, to.y - from.y);
    let sides = [
        (-dx, from.x - rect.left),
        (dx, rect.right - from.x),
        (-dy, from.y - rect.top),
        (dy, rect.bottom - from.y),
    ];
    let (mut start, mut end) = (0.0_f32, 1.0_f32);
    for (speed, room) in sides {
        if speed == 0.0 {
            if room < 0.0 {
                return None;
            }
        } else if speed < 0.0 {
            start = start.max(room / speed);
        } else {
            end = end.min(room / speed);
        }
    }
    (start <= end).then_some((start, end))
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::InterWidths;

    const FRAME: Rect = Rect::new(0.0, 0.0, 300.0, 200.0);

    fn label() -> Label {
        Label::line(Words::new("D (stereo)", Ink::Text), 12.0)
    }

    #[test]
    fn two_labels_for_the_same_place_do_not_overlap() {
        let mut labels = Labels::new(&InterWidths, FRAME);
        let place = (Point::new(100.0, 100.0), Align::Left);
        let [first, second] = [0, 1].map(|_| labels.put(&label(), &[place]).unwrap());
        assert!(!first.overlaps(second), "{first:?} {second:?}");
    }

    #[test]
    fn a_label_stays_inside_and_off_a_line() {
        let mut labels = Labels::new(&InterWidths, FRAME);
        let (from, to) = (Point::new(0.0, 0.0), Point::new(300.0, 200.0));
        labels.avoid_line(from, to);
        for place in [Point::new(400.0, 100.0), Point::new(0.0, 0.0), Point::new(150.0, 100.0)] {
            let rect = labels.put(&label(), &[(place, Align::Right)]).unwrap();
            assert!(!line_meets(from, to, rect), "{rect:?}");
            assert!(rect.left >= 0.0 && rect.right <= 300.0 && rect.top >= 0.0 && rect.bottom <= 200.0);
        }
    }

    #[test]
    fn a_label_without_any_room_is_left_out() {
        let mut labels = Labels::new(&InterWidths, FRAME);
        labels.keep_off(FRAME);
        assert_eq!(labels.put(&label(), &[(Point::new(0.0, 0.0), Align::Left)]), None);
    }
}
