//! The floor from above: what the camera sees of it, and the point.

use super::{DOTS, LINE, Model, RING, level_dimension, strong};
use crate::floor::{Axes, LABEL_TEXT, Scale, dimension, grid_step, room_for_ticks, step_text, to_f32};
use crate::labels::{Label, Labels, grown};
use crate::{Align, Figure, Fill, Ink, Measure, Point, Rect, Shape, Stroke, Words};
use depth_core::quantity::Length;

/// Above the point: room for its ellipse and the dimension to the right.
const ABOVE: f32 = 36.0;
/// From the line of the camera to the lower edge.
const BELOW: f32 = 29.0;
/// At the sides of what is shown: room for the dimension ahead and its label.
const ASIDE: f32 = 90.0;
/// Half the length of the ellipse, at most, and so that it can be seen, at least.
const ELLIPSE: [f64; 2] = [27.0, 9.0];

/// The floor from above.
#[derive(Clone, Debug, PartialEq)]
pub struct Above {
    /// The picture.
    pub figure: Figure,
    /// At the right of the title: "to scale, grid 1 m".
    pub caption: String,
    /// Below the picture: "Ellipse: 1 σ, drawn 2 × as large. Gray: the floor in the image."
    pub note: String,
    /// The point.
    pub ring: Point,
    /// Where the grid is.
    pub plot: Rect,
    /// Points per meter.
    pub per_meter: f64,
    origin: Point,
}

/// The error ellipse: its half axes, points, the longer one first, the direction of that, and how many times as large it is drawn.
struct Ellipse {
    radii: [f64; 2],
    angle: f64,
    factor: f64,
}

struct Drawing<'a> {
    model: &'a Model,
    measure: &'a dyn Measure,
    plot: Rect,
    scale: Scale,
    step: f64,
    ellipse: Option<Ellipse>,
    scene: Figure,
    labels: Labels<'a>,
}

impl Above {
    /// The picture of `model`, `width` and `height` points large.
    pub fn new(model: &Model, [width, height]: [f32; 2], measure: &dyn Measure) -> Self {
        let mut left = 34.0;
        for _ in 0..2 {
            let plot = Rect::new(left, 17.0, width, height - BELOW);
            let scale = scale_of(model, plot);
            let [per_meter, _] = scale.per_meter;
            let step = grid_step(measure, per_meter, model.unit, f64::from(plot.width()) / per_meter);
            let highest = Length::from_m(f64::from(plot.height()) / per_meter).in_unit(model.unit);
            left = room_for_ticks(measure, step, highest);
        }
        let plot = Rect::new(left, 17.0, width, height - BELOW);
        let scale = scale_of(model, plot);
        let [per_meter, _] = scale.per_meter;
        let drawing = Drawing {
            model,
            measure,
            plot,
            scale,
            step: grid_step(measure, per_meter, model.unit, f64::from(plot.width()) / per_meter),
            ellipse: ellipse_of(model, per_meter),
            scene: Figure::new(width, height),
            labels: Labels::new(measure, Rect::new(plot.left, 2.0, width, height - 2.0)).without_ground(),
        };
        Self {
            caption: format!("to scale, grid {}", step_text(drawing.step, model.unit)),
            note: drawing.note(width),
            ring: drawing.ring(),
            figure: drawing.figure([width, height]),
            plot,
            per_meter,
            origin: scale.origin,
        }
    }

    /// How far to the right and how far ahead a point is that is drawn at `at`.
    pub fn place_at(&self, at: Point) -> [Length; 2] {
        let meters = |points: f32| Length::from_m(f64::from(points) / self.per_meter);
        [meters(at.x - self.origin.x), meters(self.origin.y - at.y)]
    }
}

/// The largest scale at which the camera and the point fit, with room for what is written beside them.
fn scale_of(model: &Model, plot: Rect) -> Scale {
    let (ahead, right) = (model.ahead.value.m(), model.right_m());
    let vertical = f64::from((plot.height() - ABOVE).max(30.0)) / ahead.abs().max(1e-12);
    let horizontal = f64::from((plot.width() - 2.0 * ASIDE).max(60.0)) / right.abs().max(1e-12);
    let per_meter = vertical.min(horizontal);
    let below = to_f32(ahead.min(0.0) * per_meter);
    let middle = to_f32(right / 2.0 * per_meter);
    Scale::even(
        Point::new(f32::midpoint(plot.left, plot.right) - middle, plot.bottom + below),
        per_meter,
    )
}

/// Its axes follow from three σ: of the way ahead, to the right and along the floor, which depends on how the first two go together.
fn ellipse_of(model: &Model, per_meter: f64) -> Option<Ellipse> {
    let (ahead, along) = (model.ahead, model.distance);
    let right = model.right?;
    let (a, r) = (ahead.value.m(), right.value.m());
    let [va, vr, vd] = [ahead, right, along].map(|length| length.sigma.m().powi(2));
    let most = (va * vr).sqrt();
    let product = 2.0 * a * r;
    let covariance = if product == 0.0 {
        0.0
    } else {
        (vd * (a * a + r * r) - a * a * va - r * r * vr) / product
    };
    let covariance = covariance.clamp(-most, most);
    let middle = f64::midpoint(va, vr);
    let apart = ((va - vr) / 2.0).hypot(covariance);
    let [long, short] = [middle + apart, (middle - apart).max(0.0)].map(|variance| variance.sqrt() * per_meter);
    let [largest, smallest] = ELLIPSE;
    if !(long > 0.0 && long.is_finite()) {
        return None;
    }
    let factors = [100.0, 50.0, 20.0, 10.0, 5.0, 2.0];
    let factor = factors.into_iter().find(|factor| long * factor <= largest).unwrap_or(1.0);
    let long = long * factor;
    (long >= smallest && long <= 1.2 * largest).then(|| Ellipse {
        radii: [long, (short * factor).max(3.0)],
        // From the right towards ahead.
        angle: covariance.atan2(vr - middle + apart),
        factor,
    })
}

impl Drawing<'_> {
    fn ring(&self) -> Point {
        self.scale.at(self.model.right_m(), self.model.ahead.value.m())
    }

    fn note(&self, width: f32) -> String {
        let ellipse = match &self.ellipse {
            Some(ellipse) if ellipse.factor > 1.0 => Some(format!("Ellipse: 1 σ, drawn {:.0} × as large.", ellipse.factor)),
            Some(_) => Some("Ellipse: 1 σ.".to_owned()),
            None => None,
        };
        let floor = self.floor().map(|_| "Gray: the floor in the image.".to_owned());
        let sentences: Vec<String> = ellipse.into_iter().chain(floor).collect();
        crate::below::fitted(&sentences, width, self.measure)
    }

    fn figure(mut self, [width, height]: [f32; 2]) -> Figure {
        let mut figure = Figure::new(width, height);
        if let Some(floor) = self.floor() {
            figure.area(floor, Fill::new(Ink::Band), None);
        }
        let is_to_the_right = self.model.right_m() >= 0.0;
        let axes = Axes {
            plot: self.plot,
            scale: self.scale,
            unit: self.model.unit,
            steps: [self.step; 2],
            up: "Ahead",
            below: height - 11.0,
            across: ("Right", Point::new(width, self.scale.origin.y - 11.0), Align::Right),
        };
        for text in axes.draw(&mut figure, self.measure) {
            self.labels.keep_off(text);
        }
        let origin = self.scale.origin;
        figure.line(
            Point::new(origin.x, self.plot.top),
            Point::new(origin.x, self.plot.bottom),
            Stroke::new(Ink::Border, 1.0),
        );
        self.ray();
        self.dimensions(is_to_the_right);
        self.labels.finish(&mut figure, self.scene);
        figure
    }

    /// The ray along the floor, the point with its ellipse, and the camera.
    fn ray(&mut self) {
        let (origin, ring) = (self.scale.origin, self.ring());
        self.scene.line(origin, ring, Stroke::new(Ink::Text, 2.0));
        self.labels.avoid_line(origin, ring);
        if let Some(ellipse) = &self.ellipse {
            let [long, short] = ellipse.radii;
            let (sin, cos) = ellipse.angle.sin_cos();
            let points = (0..48_u8).map(|step| {
                let (y, x) = (f64::from(step) * std::f64::consts::TAU / 48.0).sin_cos();
                let (x, y) = (x * long, y * short);
                Point::new(ring.x + to_f32(x * cos - y * sin), ring.y - to_f32(x * sin + y * cos))
            });
            let points: Vec<Point> = points.collect();
            for point in points.iter().step_by(4) {
                self.labels.keep_off(grown(Rect::new(point.x, point.y, point.x, point.y), 3.0));
            }
            self.scene.shapes.push(Shape::Path {
                points,
                is_closed: true,
                fill: None,
                stroke: Some(Stroke::new(Ink::Text, 1.4)),
            });
        }
        self.scene
            .circle(ring, RING - 1.0, Some(Fill::new(Ink::Surface)), Some(Stroke::new(Ink::Text, 2.25)));
        self.labels.keep_off(grown(Rect::new(ring.x, ring.y, ring.x, ring.y), RING + 1.0));
        let corner = |dx: f32, dy: f32| Point::new(origin.x + dx, origin.y + dy);
        let body = vec![corner(-3.5, 0.0), corner(3.5, 0.0), corner(8.0, 10.0), corner(-8.0, 10.0)];
        self.scene.area(body, Fill::new(Ink::Text), None);
        self.labels
            .keep_off(Rect::new(origin.x - 9.0, origin.y - 2.0, origin.x + 9.0, origin.y + 11.0));
    }

    fn dimensions(&mut self, is_to_the_right: bool) {
        let (origin, ring, model) = (self.scale.origin, self.ring(), self.model);
        let side = if is_to_the_right { 1.0 } else { -1.0 };
        let away = if is_to_the_right { Align::Right } else { Align::Left };
        let toward = if is_to_the_right { Align::Left } else { Align::Right };
        let x = origin.x - side * 20.0;
        let is_long = (origin.y - ring.y).abs() >= 12.0;
        if is_long {
            dimension(&mut self.scene, Point::new(x, ring.y), Point::new(x, origin.y), LINE);
            self.labels
                .keep_off(Rect::new(x - 5.0, ring.y.min(origin.y) - 2.0, x + 5.0, ring.y.max(origin.y) + 2.0));
            self.scene
                .line(Point::new(x + side * 8.0, ring.y), Point::new(ring.x - side * 14.0, ring.y), DOTS);
        }
        if let Some(right) = model.right {
            let word = if is_to_the_right { "to the right" } else { "to the left" };
            let label = strong(format!("{} {word}", model.length(right)));
            let width = label.width(self.measure);
            let above = if model.ahead.value.m() < 0.0 { origin.y - 2.0 } else { ring.y };
            let top = (above - 28.0).max(self.plot.top + 8.0);
            let ends = [Point::new(origin.x, top), Point::new(ring.x, top)];
            level_dimension(&mut self.scene, &mut self.labels, ends, &label, width);
        }
        let name = if model.ahead.value.m() < 0.0 { "behind" } else { "ahead" };
        let lines = vec![Words::new(name, Ink::Muted), Words::strong(model.length(model.ahead), Ink::Text)];
        let ahead = Label { lines, size: LABEL_TEXT };
        let middle = f32::midpoint(origin.y, ring.y);
        let down = f32::midpoint(middle, origin.y);
        self.labels
            .put(&ahead, &[middle, down, ring.y].map(|y| (Point::new(x - side * 10.0, y), away)));
        if model.right.is_some() {
            let label = strong(format!("{} along the floor", model.length(model.distance)));
            let at = |part: f32| {
                Point::new(
                    origin.x + part * (ring.x - origin.x) + side * 16.0,
                    origin.y + part * (ring.y - origin.y),
                )
            };
            self.labels.put(&label, &[0.46, 0.6, 0.3, 0.15].map(|part| (at(part), toward)));
        }
    }

    /// What the image shows of the floor, as far as it is in the picture.
    fn floor(&self) -> Option<Vec<Point>> {
        let eye = self.model.eye.as_ref()?;
        let [across, down] = eye.size();
        let slope = |column: f64| (column - eye.center[0]) / eye.focal[0];
        let (left, right) = (slope(0.0), slope(across));
        let (sin, cos) = self.model.pitch.0.sin_cos();
        let near = eye.slope_down(down);
        let steepness = sin + near * cos;
        // The uppermost row that still meets the floor, or one so near to the horizon that it does so far outside the picture.
        let far = eye.slope_down(0.0).max((1e-4 * steepness - sin) / cos.abs().max(1e-9));
        let corners = [[left, near], [right, near], [right, far], [left, far]];
        let points: Option<Vec<Point>> = corners
            .into_iter()
            .map(|corner| self.model.on_floor(corner).map(|[x, ahead]| self.scale.at(x, ahead)))
            .collect();
        let inside = cut(points?, self.plot);
        (inside.len() >= 3).then_some(inside)
    }
}

/// The part of a convex area inside `rect` (Sutherland and Hodgman, 1974).
fn cut(mut area: Vec<Point>, rect: Rect) -> Vec<Point> {
    let sides: [&dyn Fn(Point) -> f32; 4] = [
        &|point| point.x - rect.left,
        &|point| rect.right - point.x,
        &|point| point.y - rect.top,
        &|point| rect.bottom - point.y,
    ];
    for inside in sides {
        let mut kept = Vec::new();
        for (index, &to) in area.iter().enumerate() {
            let Some(&from) = area.get((index + area.len() - 1) % area.len()) else {
                continue;
            };
            let (start, end) = (inside(from), inside(to));
            if (start < 0.0) != (end < 0.0) {
                let part = start / (start - end);
                kept.push(Point::new(from.x + part * (to.x - from.x), from.y + part * (to.y - from.y)));
            }
            if end >= 0.0 {
                kept.push(to);
            }
        }
        area = kept;
    }
    area
}
