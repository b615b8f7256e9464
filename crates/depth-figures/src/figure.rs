//! A picture as a list of shapes.

use crate::{Align, Ink, Words};

/// A place in a figure, points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// To the right.
    pub x: f32,
    /// Down.
    pub y: f32,
}

/// A rectangle with its sides along the axes, points.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rect {
    /// Left edge.
    pub left: f32,
    /// Upper edge.
    pub top: f32,
    /// Right edge.
    pub right: f32,
    /// Lower edge.
    pub bottom: f32,
}

/// A line's color, width and dashes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Stroke {
    /// Its color.
    pub ink: Ink,
    /// Its width.
    pub width: f32,
    /// The length of its dashes and of the gaps between them; `None` for a continuous line.
    pub dash: Option<[f32; 2]>,
}

/// What an area is filled with.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fill {
    /// Its color.
    pub ink: Ink,
    /// From 0, invisible, to 1.
    pub opacity: f32,
}

/// A shape.
#[derive(Clone, Debug, PartialEq)]
pub enum Shape {
    /// A line through points; closed, the edge of an area.
    Path {
        /// Its corners.
        points: Vec<Point>,
        /// Whether the last is joined to the first.
        is_closed: bool,
        /// What is inside. Areas must be convex.
        fill: Option<Fill>,
        /// The line.
        stroke: Option<Stroke>,
    },
    /// A rectangle with rounded corners.
    Rect {
        /// Its place.
        rect: Rect,
        /// The radius of its corners.
        radius: f32,
        /// What is inside.
        fill: Option<Fill>,
        /// Its edge.
        stroke: Option<Stroke>,
    },
    /// A circle.
    Circle {
        /// Its center.
        center: Point,
        /// Its radius.
        radius: f32,
        /// What is inside.
        fill: Option<Fill>,
        /// Its edge.
        stroke: Option<Stroke>,
    },
    /// A line of text.
    Text {
        /// Where its end or middle is, and the middle of the height of its letters.
        at: Point,
        /// Which of these.
        align: Align,
        /// The text.
        words: Words,
        /// Its size.
        size: f32,
    },
}

/// A picture.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Figure {
    /// Its width, points.
    pub width: f32,
    /// Its height, points.
    pub height: f32,
    /// Its shapes, the lowest first.
    pub shapes: Vec<Shape>,
}

impl Point {
    /// The place `x` to the right and `y` down.
    pub const fn new(x: f32, y: f32) -> Self {
        Self { x, y }
    }
}

impl Rect {
    /// The rectangle from `left` to `right` and `top` to `bottom`.
    pub const fn new(left: f32, top: f32, right: f32, bottom: f32) -> Self {
        Self { left, top, right, bottom }
    }

    /// Its width.
    pub fn width(self) -> f32 {
        self.right - self.left
    }

    /// Its height.
    pub fn height(self) -> f32 {
        self.bottom - self.top
    }

    /// Whether it and `other` have an area in common.
    pub fn overlaps(self, other: Self) -> bool {
        self.left < other.right && other.left < self.right && self.top < other.bottom && other.top < self.bottom
    }
}

impl Stroke {
    /// A continuous line.
    pub const fn new(ink: Ink, width: f32) -> Self {
        Self { ink, width, dash: None }
    }

    /// A dashed line.
    pub const fn dashed(ink: Ink, width: f32, dash: [f32; 2]) -> Self {
        Self {
            ink,
            width,
            dash: Some(dash),
        }
    }
}

impl Fill {
    /// Opaque.
    pub const fn new(ink: Ink) -> Self {
        Self { ink, opacity: 1.0 }
    }

    /// What is below it shines through.
    pub const fn sheer(ink: Ink, opacity: f32) -> Self {
        Self { ink, opacity }
    }
}

impl Figure {
    /// An empty picture.
    pub const fn new(width: f32, height: f32) -> Self {
        Self {
            width,
            height,
            shapes: Vec::new(),
        }
    }

    /// The same `times` as large, letters and lines too.
    #[must_use]
    pub fn scaled(mut self, times: f32) -> Self {
        let at = |point: &mut Point| *point = Point::new(times * point.x, times * point.y);
        let line = |stroke: &mut Stroke| {
            stroke.width *= times;
            stroke.dash = stroke.dash.map(|dash| dash.map(|length| times * length));
        };
        self.width *= times;
        self.height *= times;
        for shape in &mut self.shapes {
            match shape {
                Shape::Path { points, stroke, .. } => {
                    points.iter_mut().for_each(at);
                    stroke.iter_mut().for_each(line);
                }
                Shape::Rect { rect, radius, stroke, .. } => {
                    let Rect { left, top, right, bottom } = *rect;
                    *rect = Rect::new(times * left, times * top, times * right, times * bottom);
                    *radius *= times;
                    stroke.iter_mut().for_each(line);
                }
                Shape::Circle {
                    center, radius, stroke, ..
                } => {
                    at(center);
                    *radius *= times;
                    stroke.iter_mut().for_each(line);
                }
                Shape::Text { at: place, size, .. } => {
                    at(place);
                    *size *= times;
                }
            }
        }
        self
    }

    /// Adds a line from `from` to `to`.
    pub fn line(&mut self, from: Point, to: Point, stroke: Stroke) {
        self.path(vec![from, to], stroke);
    }

    /// Adds a line through `points`.
    pub fn path(&mut self, points: Vec<Point>, stroke: Stroke) {
        self.shapes.push(Shape::Path {
            points,
            is_closed: false,
            fill: None,
            stroke: Some(stroke),
        });
    }

    /// Adds a convex area with `points` as its corners.
    pub fn area(&mut self, points: Vec<Point>, fill: Fill, stroke: Option<Stroke>) {
        self.shapes.push(Shape::Path {
            points,
            is_closed: true,
            fill: Some(fill),
            stroke,
        });
    }

    /// Adds a filled rectangle.
    pub fn rect(&mut self, rect: Rect, radius: f32, fill: Fill) {
        self.shapes.push(Shape::Rect {
            rect,
            radius,
            fill: Some(fill),
            stroke: None,
        });
    }

    /// Adds the edge of a rectangle, and what is inside.
    pub fn frame(&mut self, rect: Rect, radius: f32, fill: Option<Fill>, stroke: Stroke) {
        self.shapes.push(Shape::Rect {
            rect,
            radius,
            fill,
            stroke: Some(stroke),
        });
    }

    /// Adds a circle.
    pub fn circle(&mut self, center: Point, radius: f32, fill: Option<Fill>, stroke: Option<Stroke>) {
        self.shapes.push(Shape::Circle {
            center,
            radius,
            fill,
            stroke,
        });
    }

    /// Adds a line of text.
    pub fn text(&mut self, at: Point, align: Align, words: Words, size: f32) {
        self.shapes.push(Shape::Text { at, align, words, size });
    }
}
