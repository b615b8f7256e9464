//! The object and both cameras from above.

use super::pen::{LETTER, Pen, SMALL, dotted};
use crate::floor::dimension;
use crate::{Align, Figure, Fill, Ink, Measure, Point, Rect, Stroke, Words};

/// Narrower than this, "the answer" stands below its letter.
const ROOMY: f32 = 440.0;

/// Where everything is: as drawn for a width of 484, and narrower than that squeezed.
pub(super) struct Schema {
    top: f32,
    is_roomy: bool,
    /// The dimension of the focal length and that of the distance.
    columns: [f32; 2],
    /// How high it is, as a part of how high it is drawn.
    height: f32,
}

impl Schema {
    /// The schematic at the left edge, `width` points wide.
    pub(super) fn new(width: f32, top: f32, measure: &dyn Measure) -> Self {
        let is_roomy = width >= ROOMY;
        let answer = measure.width(&Words::new("the answer", Ink::Muted), SMALL);
        let right = if is_roomy {
            (width - answer - 14.0).min(560.0)
        } else {
            width - answer / 2.0 - 1.0
        };
        let schema = Self {
            top,
            is_roomy,
            columns: [if is_roomy { 66.0 } else { 46.0 }, right],
            height: if is_roomy { 1.0 } else { 0.84 },
        };
        // The name of the right image, beside the line ahead of the camera.
        let name = measure.width(&Words::new("right image", Ink::Muted), SMALL);
        Self {
            is_roomy: is_roomy && schema.x(306.0) - schema.x(236.0) >= name + 4.0,
            ..schema
        }
    }

    /// Where it ends.
    pub(super) fn bottom(&self) -> f32 {
        self.y(470.0) + 13.0
    }

    /// How far to the right of the dimension of the focal length, of 342 to the dimension of the distance.
    fn x(&self, drawn: f32) -> f32 {
        let [left, right] = self.columns;
        left + drawn / 342.0 * (right - left)
    }

    fn y(&self, drawn: f32) -> f32 {
        self.top + 13.0 + (drawn - 13.0) * self.height
    }

    fn at(&self, x: f32, y: f32) -> Point {
        Point::new(self.x(x), self.y(y))
    }

    pub(super) fn draw(&self, pen: &mut Pen<'_>) {
        self.object(pen);
        self.cameras(pen);
        self.planes(pen);
        self.dimensions(pen);
        let ring = self.at(150.0, 116.0);
        pen.figure
            .circle(ring, 5.5, Some(Fill::new(Ink::Surface)), Some(Stroke::new(Ink::Stereo, 2.5)));
    }

    /// The box, and what the left camera sees of it.
    fn object(&self, pen: &mut Pen<'_>) {
        let [left, right, eye] = [self.at(80.0, 116.0), self.at(220.0, 116.0), self.at(46.0, 428.0)];
        let figure = &mut pen.figure;
        figure.area(vec![eye, left, right], Fill::new(Ink::MonocularTint), None);
        for end in [left, right] {
            figure.line(eye, end, Stroke::new(Ink::Monocular, 1.0));
        }
        let edge = Stroke::new(Ink::Border, 1.0);
        let top = self.y(72.0);
        figure.frame(Rect::new(left.x, top, right.x, left.y), 0.0, Some(Fill::new(Ink::Band)), edge);
        let middle = self.x(150.0);
        figure.line(Point::new(middle, top), Point::new(middle, left.y), edge);
        figure.line(left, right, Stroke::new(Ink::Monocular, 5.0));
        let above = self.y(54.0);
        let [from, to] = [left.x, right.x].map(|x| Point::new(x, above));
        dimension(figure, from, to, Stroke::new(Ink::MonocularText, 1.75));
        pen.letter("w_real", (Point::new(middle, above - 17.0), Align::Center), Ink::MonocularText);
    }

    fn cameras(&self, pen: &mut Pen<'_>) {
        let ring = self.at(150.0, 116.0);
        for x in [46.0, 236.0] {
            let eye = self.at(x, 428.0);
            // In a narrow picture these would cross the names of the images.
            let from = if self.is_roomy { self.y(272.0) } else { self.y(312.0) };
            pen.figure.line(Point::new(eye.x, from), eye, dotted(Ink::Border));
            pen.figure.line(eye, ring, Stroke::dashed(Ink::Stereo, 1.6, [6.0, 4.0]));
            let corner = |dx: f32, dy: f32| Point::new(eye.x + dx, eye.y + dy);
            let body = vec![corner(-6.0, 0.0), corner(6.0, 0.0), corner(12.0, 21.0), corner(-12.0, 21.0)];
            pen.figure.area(body, Fill::new(Ink::Stereo), None);
        }
        let baseline = [46.0, 236.0].map(|x| self.at(x, 470.0));
        pen.level(baseline, "b", Ink::Stereo);
    }

    /// Both images, in front of the cameras, where they are upright.
    fn planes(&self, pen: &mut Pen<'_>) {
        let y = self.y(312.0);
        let black = Stroke::new(Ink::Text, 1.75);
        // Where a line from a camera to something at the height of the object crosses the images.
        let crossing = |eye: f32, of: f32| Point::new(self.x(eye + (of - eye) * (428.0 - 312.0) / (428.0 - 116.0)), y);
        for (eye, [from, to]) in [(46.0, [-24.0, 116.0]), (236.0, [166.0, 306.0])] {
            let [from, to] = [from, to].map(|x| Point::new(self.x(x), y));
            dimension(&mut pen.figure, from, to, black);
            if eye < 100.0 {
                let seen = Stroke::new(Ink::Monocular, 5.0);
                pen.figure.line(crossing(eye, 80.0), crossing(eye, 220.0), seen);
            }
            pen.figure.circle(crossing(eye, 150.0), 4.0, Some(Fill::new(Ink::Stereo)), None);
        }
        let labels = y - 16.0;
        pen.small("left image", Point::new(self.x(-24.0), labels), Align::Left);
        pen.small("right image", Point::new(self.x(306.0), labels), Align::Right);
    }

    fn dimensions(&self, pen: &mut Pen<'_>) {
        let [focal, depth] = self.columns;
        let ground = self.y(428.0);
        let object = self.y(116.0);
        for (from, to) in [
            (Point::new(focal - 4.0, ground), Point::new(self.x(46.0) - 10.0, ground)),
            (Point::new(self.x(236.0) + 16.0, ground), Point::new(depth, ground)),
            (Point::new(self.x(220.0) + 8.0, object), Point::new(depth, object)),
        ] {
            pen.figure.line(from, to, dotted(Ink::Border));
        }
        let black = Stroke::new(Ink::Text, 1.75);
        let top = self.y(312.0);
        dimension(&mut pen.figure, Point::new(focal, top), Point::new(focal, ground), black);
        let beside = Point::new(focal - 24.0, f32::midpoint(top, ground));
        pen.letter("fx", (beside, Align::Center), Ink::Text);
        // Beside the names of the images there is room for it only in a roomy picture.
        let letter = Point::new(depth, self.y(if self.is_roomy { 272.0 } else { 222.0 }));
        let below = if self.is_roomy { 15.0 } else { 15.0 + 16.0 };
        upright(
            &mut pen.figure,
            [Point::new(depth, object), Point::new(depth, letter.y - 15.0)],
            black,
        );
        upright(
            &mut pen.figure,
            [Point::new(depth, ground), Point::new(depth, letter.y + below)],
            black,
        );
        pen.letter("D", (letter, Align::Center), Ink::Text);
        if self.is_roomy {
            pen.small("the answer", Point::new(depth + 14.0, letter.y), Align::Left);
        } else {
            pen.small("the answer", Point::new(depth, letter.y + LETTER + 4.0), Align::Center);
        }
    }
}

/// An upright line with a cap at its first end.
fn upright(figure: &mut Figure, [end, inner]: [Point; 2], stroke: Stroke) {
    figure.line(end, inner, stroke);
    figure.line(Point::new(end.x - 4.0, end.y), Point::new(end.x + 4.0, end.y), stroke);
}
