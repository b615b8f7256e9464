//! The same object in both images: it is `w_img` wide, and shifted by d.

use super::pen::{Pen, SMALL};
use crate::floor::dimension;
use crate::{Align, Fill, Ink, Point, Rect, Shape, Stroke, Words};

/// Both images, one below the other.
pub(super) struct Stack {
    pub(super) left: f32,
    /// The middle of the first line of text.
    pub(super) top: f32,
    pub(super) width: f32,
    /// The height of each image.
    pub(super) frame: f32,
}

/// The box in one of the images.
#[derive(Clone, Copy)]
struct Parcel {
    place: Rect,
    point: Point,
}

impl Stack {
    /// Draws both, and returns where they end.
    pub(super) fn draw(&self, pen: &mut Pen<'_>) -> f32 {
        let second = self.top + self.frame + 44.0;
        let (left, right) = (self.frame_at(self.top), self.frame_at(second));
        for (name, top, frame) in [("Left image", self.top, left), ("Right image", second, right)] {
            let words = Words::strong(name, Ink::Text);
            pen.figure.text(Point::new(self.left, top), Align::Left, words, SMALL + 1.0);
            let edge = Stroke::new(Ink::Border, 1.0);
            pen.figure.frame(frame, 4.0, Some(Fill::sheer(Ink::Band, 0.45)), edge);
        }
        // As far to the right in the left image as leaves the shift room.
        let seen = Self::parcel(left, left.right - 10.0 - self.parcel_width(), 0.79);
        let shifted = Self::parcel(right, right.left + 23.0, 0.79);
        let ghost = Self::parcel(right, seen.place.left, 0.79);
        self.solid(pen, left, seen);
        self.solid(pen, right, shifted);
        outline(pen, ghost.place);
        let below = [left, right].map(|frame| frame.bottom - frame.height() * 0.125);
        let [width_y, shift_y] = [below[0], below[1] + 2.0];
        let [from, to] = [seen.place.left, seen.place.right].map(|x| Point::new(x, width_y));
        dimension(&mut pen.figure, from, to, Stroke::new(Ink::MonocularText, 1.75));
        pen.letter("w_img", (Point::new(from.x - 10.0, width_y), Align::Right), Ink::MonocularText);
        let sight = Stroke::dashed(Ink::Stereo, 1.3, [5.0, 3.0]);
        pen.figure.line(seen.point, Point::new(seen.point.x, shift_y - 4.0), sight);
        pen.figure.line(shifted.point, Point::new(shifted.point.x, shift_y - 4.0), sight);
        pen.level(
            [shifted.point, seen.point].map(|point| Point::new(point.x, shift_y)),
            "d",
            Ink::Stereo,
        );
        for point in [seen.point, shifted.point] {
            pen.figure.circle(point, 4.0, Some(Fill::new(Ink::Stereo)), None);
        }
        let hollow = Stroke::new(Ink::Stereo, 1.5);
        pen.figure.circle(ghost.point, 4.0, Some(Fill::new(Ink::Surface)), Some(hollow));
        let mut end = right.bottom;
        for line in pen.wrapped("d = x left − x right, of the same point", SMALL, self.width) {
            end += 16.0;
            pen.small(&line, Point::new(self.left, end), Align::Left);
        }
        end + 8.0
    }

    fn frame_at(&self, top: f32) -> Rect {
        Rect::new(self.left + 0.5, top + 12.0, self.left + self.width - 0.5, top + 12.0 + self.frame)
    }

    fn parcel_width(&self) -> f32 {
        (self.width * 0.373).min(110.0)
    }

    /// The box with its left edge at `left`, standing at this part of the height of `frame`.
    fn parcel(frame: Rect, left: f32, stands_at: f32) -> Parcel {
        let width = (frame.width() * 0.373).min(110.0);
        let bottom = frame.top + frame.height() * stands_at;
        let place = Rect::new(left, bottom - frame.height() * 0.457, left + width, bottom);
        Parcel {
            place,
            point: Point::new(left + width / 2.0, f32::midpoint(place.top, place.bottom)),
        }
    }

    /// The box with its tape, on the floor.
    fn solid(&self, pen: &mut Pen<'_>, frame: Rect, Parcel { place, point }: Parcel) {
        let edge = Stroke::new(Ink::Border, 1.0);
        let figure = &mut pen.figure;
        figure.line(
            Point::new(frame.left + 8.0, place.bottom),
            Point::new(frame.right - 8.0, place.bottom),
            edge,
        );
        figure.frame(place, 0.0, Some(Fill::new(Ink::Band)), edge);
        let fold = place.top + place.height() * 0.36;
        figure.line(Point::new(place.left, fold), Point::new(place.right, fold), edge);
        let tape = self.parcel_width() * 0.08;
        for x in [point.x - tape, point.x + tape] {
            figure.line(Point::new(x, place.top), Point::new(x, fold), edge);
        }
    }
}

/// Where the box was in the other image.
fn outline(pen: &mut Pen<'_>, rect: Rect) {
    let corners = [
        (rect.left, rect.top),
        (rect.right, rect.top),
        (rect.right, rect.bottom),
        (rect.left, rect.bottom),
        (rect.left, rect.top),
    ];
    pen.figure.shapes.push(Shape::Path {
        points: corners.into_iter().map(|(x, y)| Point::new(x, y)).collect(),
        is_closed: false,
        fill: None,
        stroke: Some(Stroke::dashed(Ink::Border, 1.0, [4.0, 3.0])),
    });
}
