//! Draws the top view.

use super::fit::{Fit, RING, Span};
use super::model::{Model, Sight};
use crate::floor::Axes;
use crate::labels::{Labels, grown};
use crate::{Align, Figure, Fill, Ink, Measure, Point, Rect, Shape, Stroke};

/// What it takes to draw.
pub(super) struct Drawing<'a> {
    pub(super) model: &'a Model,
    pub(super) fit: &'a Fit,
    pub(super) measure: &'a dyn Measure,
}

/// What is drawn so far.
pub(super) struct Sheet<'a> {
    pub(super) scene: Figure,
    pub(super) labels: Labels<'a>,
}

impl Drawing<'_> {
    /// The whole picture.
    pub(super) fn figure(&self, [width, height]: [f32; 2]) -> Figure {
        let mut figure = Figure::new(width, height);
        let axes = Axes {
            plot: self.fit.plot,
            scale: self.fit.scale,
            unit: self.model.unit,
            steps: [self.fit.step; 2],
            up: "Z",
            below: height - 10.0,
            across: (
                if self.model.is_from_side { "Y" } else { "X" },
                Point::new(0.0, height - 10.0),
                Align::Left,
            ),
        };
        let texts = axes.draw(&mut figure, self.measure);
        let frame = Rect::new(self.fit.plot.left, 2.0, width, height - 2.0);
        let mut sheet = Sheet {
            scene: Figure::new(width, height),
            labels: Labels::new(self.measure, frame),
        };
        texts.into_iter().for_each(|text| sheet.labels.keep_off(text));
        let ground = |x: f32| Point::new(x, self.fit.ground());
        sheet.labels.avoid_line(ground(self.fit.plot.left), ground(width));
        self.monocular(&mut sheet);
        self.sights(&mut sheet);
        self.ring(&mut sheet);
        self.cameras(&mut sheet);
        self.labels(&mut sheet);
        sheet.labels.finish(&mut figure, sheet.scene);
        figure
    }

    pub(super) fn center(&self) -> f32 {
        self.fit.center()
    }

    /// The camera of the monocular distance: the left one, or the only one.
    fn eye(&self) -> Point {
        let left = self.fit.baseline.map_or(0.0, |span| span.half);
        Point::new(self.center() - left, self.fit.ground())
    }

    /// The ends of the object and its height: at the monocular distance where there is one.
    pub(super) fn object(&self) -> Option<[Point; 2]> {
        let span = self.fit.object?;
        let y = self.fit.monocular_y.or(self.fit.stereo_y)?;
        Some([-1.0, 1.0].map(|side| Point::new(self.center() + side * span.half, y)))
    }

    /// The object, and what the camera sees of it.
    fn monocular(&self, sheet: &mut Sheet<'_>) {
        let sight = self.model.monocular.as_ref();
        let [line, tint] = if sight.is_some_and(|sight| sight.is_stale) {
            [Ink::Stale, Ink::StaleTint]
        } else {
            [Ink::Monocular, Ink::MonocularTint]
        };
        let Some([left, right]) = self.object() else { return };
        if sight.is_some() {
            let eye = self.eye();
            sheet.scene.area(vec![eye, left, right], Fill::sheer(tint, 1.0), None);
            for end in [left, right] {
                sheet.scene.line(eye, end, Stroke::new(line, 1.0));
                sheet.labels.avoid_line(eye, end);
            }
        }
        sheet.scene.line(left, right, Stroke::new(line, 5.0));
        sheet.labels.keep_off(grown(Rect::new(left.x, left.y, right.x, right.y), 4.0));
    }

    /// The lines of sight of both cameras.
    fn sights(&self, sheet: &mut Sheet<'_>) {
        let (Some(y), Some(sight)) = (self.fit.stereo_y, &self.model.stereo) else {
            return;
        };
        let ring = Point::new(self.center(), y);
        for eye in self.stereo_cameras() {
            sheet.scene.line(eye, ring, Stroke::dashed(stereo_ink(sight), 1.5, [5.0, 3.0]));
            sheet.labels.avoid_line(eye, ring);
        }
    }

    fn stereo_cameras(&self) -> Vec<Point> {
        let side = |span: Span| [-1.0, 1.0].map(|side| Point::new(self.center() + side * span.half, self.fit.ground()));
        self.fit.baseline.map_or_else(Vec::new, |span| side(span).to_vec())
    }

    /// The object as a point at the stereo distance, with its error ellipse.
    fn ring(&self, sheet: &mut Sheet<'_>) {
        let (Some(y), Some(sight)) = (self.fit.stereo_y, &self.model.stereo) else {
            return;
        };
        let center = Point::new(self.center(), y);
        let ink = stereo_ink(sight);
        if let Some(ellipse) = self.fit.ellipse {
            let [wide, high] = ellipse.radii;
            let points = (0..48_u8).map(|step| {
                let (sin, cos) = (f32::from(step) * std::f32::consts::TAU / 48.0).sin_cos();
                Point::new(center.x + wide * cos, center.y + high * sin)
            });
            sheet.scene.shapes.push(Shape::Path {
                points: points.collect(),
                is_closed: true,
                fill: None,
                stroke: Some(Stroke::new(ink, 1.75)),
            });
            let around = Rect::new(center.x - wide, center.y - high, center.x + wide, center.y + high);
            sheet.labels.keep_off(grown(around, 2.0));
        }
        sheet
            .scene
            .circle(center, RING, Some(Fill::new(Ink::Surface)), Some(Stroke::new(ink, 2.5)));
        let around = Rect::new(center.x, center.y, center.x, center.y);
        sheet.labels.keep_off(grown(around, RING + 2.0));
    }

    fn cameras(&self, sheet: &mut Sheet<'_>) {
        let stereo = self.stereo_cameras();
        let is_stale = self.model.sights().all(|sight| sight.is_stale) || self.model.stereo.as_ref().is_some_and(|sight| sight.is_stale);
        let ink = if is_stale { Ink::Stale } else { Ink::Stereo };
        let all = if stereo.is_empty() { vec![self.eye()] } else { stereo };
        for eye in all {
            let corner = |dx: f32, dy: f32| Point::new(eye.x + dx, eye.y + dy);
            let body = vec![corner(-3.0, 0.0), corner(3.0, 0.0), corner(6.0, 8.5), corner(-6.0, 8.5)];
            sheet.scene.area(body, Fill::new(ink), None);
            sheet
                .labels
                .keep_off(Rect::new(eye.x - 7.0, eye.y - 2.0, eye.x + 7.0, eye.y + 10.0));
        }
    }
}

pub(super) const fn stereo_ink(sight: &Sight) -> Ink {
    if sight.is_stale { Ink::Stale } else { Ink::Stereo }
}

/// Of its lines, and of its text.
pub(super) const fn monocular_inks(sight: &Sight) -> [Ink; 2] {
    if sight.is_stale {
        [Ink::Stale; 2]
    } else {
        [Ink::Monocular, Ink::MonocularText]
    }
}
