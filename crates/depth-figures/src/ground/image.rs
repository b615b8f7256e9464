//! The point in the image: horizon, principal point, row and column.

use super::{DOTS, Eye, Model, RING, muted, strong};
use crate::floor::to_f32;
use crate::labels::{Labels, grown};
use crate::{Align, Figure, Fill, Ink, Measure, Point, Rect, Stroke};
use depth_text::number;

/// Below the frame: the column.
const BELOW: f32 = 24.0;
/// The image is no higher than this many times its width, and no lower than the other way round.
const SQUAREST: f64 = 1.5;

/// What the camera sees.
#[derive(Clone, Debug, PartialEq)]
pub struct ImageView {
    /// The picture; its height follows from the shape of the image.
    pub figure: Figure,
    /// At the right of the title: "1280 × 720".
    pub caption: String,
    /// Below the picture.
    pub note: String,
    /// The point. Dragged, it is another column and another row.
    pub ring: Point,
    frame: Rect,
    size: [f64; 2],
}

impl ImageView {
    /// The picture of `model`, `width` points wide; `None` where the point was given by its angle, not by its row.
    pub fn new(model: &Model, width: f32, measure: &dyn Measure) -> Option<Self> {
        let eye = model.eye.as_ref()?;
        let size = eye.size();
        let [across, down] = size;
        if !(across > 0.0 && down > 0.0) {
            return None;
        }
        let ratio = (down / across).clamp(1.0 / SQUAREST / 2.0, SQUAREST);
        let frame = Rect::new(0.5, 0.5, width - 0.5, 0.5 + to_f32(f64::from(width) * ratio));
        let column = eye.column.as_ref().map_or(eye.center[0], |(column, _)| *column);
        let view = Self {
            figure: Figure::new(width, frame.bottom + BELOW),
            caption: format!("{} × {}", number::plain(across.round()), number::plain(down.round())),
            note: "Rows above the horizon never meet the floor.".to_owned(),
            ring: place(grown(frame, -RING - 1.0), frame, [column / across, eye.row.0 / down]),
            frame,
            size,
        };
        Some(view.drawn(eye, measure))
    }

    /// Column and row, px, of the pixel that is drawn at `at`; inside the image.
    pub fn pixel_at(&self, at: Point) -> [f64; 2] {
        let frame = self.frame;
        let part = |at: f32, from: f32, to: f32| f64::from(((at - from) / (to - from)).clamp(0.0, 1.0));
        let [across, down] = self.size;
        [
            part(at.x, frame.left, frame.right) * across,
            part(at.y, frame.top, frame.bottom) * down,
        ]
    }

    fn drawn(mut self, eye: &Eye, measure: &dyn Measure) -> Self {
        let (frame, ring) = (self.frame, self.ring);
        let mut figure = Figure::new(self.figure.width, self.figure.height);
        let mut scene = Figure::new(figure.width, figure.height);
        let mut labels = Labels::new(measure, Rect::new(0.0, 2.0, figure.width, figure.height)).without_ground();
        figure.rect(frame, 4.0, Fill::sheer(Ink::Band, 0.45));
        let horizon = eye.horizon.map(|row| place(frame, frame, [0.0, row / self.size[1]]).y);
        let floor_top = horizon.unwrap_or(frame.top);
        if floor_top < frame.bottom {
            figure.rect(
                Rect::new(frame.left, floor_top, frame.right, frame.bottom),
                4.0,
                Fill::new(Ink::Band),
            );
        }
        scene.frame(frame, 4.0, None, Stroke::new(Ink::Border, 1.0));
        let center = place(frame, frame, [0.5; 2]);
        labels.keep_off(grown(Rect::new(ring.x, ring.y, ring.x, ring.y), RING + 1.0));
        labels.keep_off(grown(Rect::new(center.x, center.y, center.x, center.y), 6.0));
        for (dx, dy) in [(5.0, 0.0), (0.0, 5.0)] {
            let [from, to] = [-1.0, 1.0].map(|side| Point::new(center.x + side * dx, center.y + side * dy));
            scene.line(from, to, Stroke::new(Ink::Text, 1.5));
        }
        let across = [Point::new(frame.left, ring.y), ring];
        let down = [ring, Point::new(ring.x, frame.bottom)];
        let dots = Stroke::dashed(Ink::Text, 1.0, [1.5, 3.0]);
        let visible = horizon.filter(|y| *y > frame.top && *y < frame.bottom);
        let level = visible.map(|y| ([frame.left, frame.right].map(|x| Point::new(x, y)), DOTS));
        let column = eye.column.as_ref().map(|_| (down, dots));
        for ([from, to], stroke) in [Some((across, dots)), column, level].into_iter().flatten() {
            scene.line(from, to, stroke);
            labels.avoid_line(from, to);
        }
        scene.circle(ring, RING, Some(Fill::new(Ink::Surface)), Some(Stroke::new(Ink::Text, 2.25)));
        for y in [frame.top, frame.bottom] {
            labels.avoid_line(Point::new(frame.left, y), Point::new(frame.right, y));
        }
        self.write(eye, &mut labels, visible, measure);
        labels.finish(&mut figure, scene);
        self.figure = figure;
        self
    }

    /// Row, column, horizon and center.
    fn write(&self, eye: &Eye, labels: &mut Labels<'_>, horizon: Option<f32>, measure: &dyn Measure) {
        let (frame, ring, width) = (self.frame, self.ring, self.figure.width);
        let row = strong(format!("v = {}", bare(&eye.row.1)));
        let at = |y: f32, dy: f32| (Point::new(frame.left + 7.0, y + dy), Align::Left);
        labels.put(&row, &[at(ring.y, 10.5), at(ring.y, -10.5)]);
        if let Some((_, text)) = &eye.column {
            let label = strong(format!("u = {}", bare(text)));
            let half = label.width(measure) / 2.0;
            let x = ring.x.min(width - half - 1.0).max(half + 1.0);
            labels.put(&label, &[(Point::new(x, frame.bottom + 13.0), Align::Center)]);
        }
        if let (Some(y), Some(horizon)) = (horizon, eye.horizon) {
            let text = number::with_minus(&format!("horizon, v = {horizon:.0}"));
            labels.put(&muted(text), &[at(y, -10.5), at(y, 10.5)]);
        }
        let name = muted("center");
        let center = place(frame, frame, [0.5; 2]);
        let beside = [
            (-9.0, 12.0, Align::Right),
            (9.0, 12.0, Align::Left),
            (-9.0, -12.0, Align::Right),
            (9.0, -12.0, Align::Left),
        ];
        let places = beside.map(|(dx, dy, align)| (Point::new(center.x + dx, center.y + dy), align));
        if let Some(place) = places.into_iter().find(|place| labels.is_free_at(&name, *place)) {
            labels.put(&name, &[place]);
        }
    }
}

/// Where these parts of the width and height of the image are; what is outside `limits` at their edge.
fn place(limits: Rect, frame: Rect, [across, down]: [f64; 2]) -> Point {
    let [x, y] = [across, down].map(|part| to_f32(part.clamp(-1e6, 1e6)));
    let (x, y) = (frame.left + x * frame.width(), frame.top + y * frame.height());
    Point::new(x.clamp(limits.left, limits.right), y.clamp(limits.top, limits.bottom))
}

/// A number of pixels without its unit.
fn bare(text: &str) -> &str {
    text.trim_end_matches("px").trim_end()
}
