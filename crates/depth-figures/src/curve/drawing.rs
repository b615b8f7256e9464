//! What is drawn of a curve, piece by piece.

use super::model::{Axes, CurveModel, Kind};
use super::place::Obstacles;
use crate::axis::{LABEL_SIZE, Tick};
use crate::spans::Span;
use crate::{Align, Figure, Fill, Ink, Measure, Point, Rect, Stroke, Words};

/// Pieces of the curve and of its band.
const PIECES: u32 = 96;
/// Half of the height of a chip.
const CHIP_HALF: f32 = 9.5;
/// From a chip's text to its edge.
pub(super) const CHIP_PADDING: f32 = 6.0;
/// Between the labels of the vertical axis and the plot.
pub(super) const LABEL_GAP: f32 = 8.0;
/// The ring, points.
const RING: f32 = 8.0;
/// The interval of the point is not shown at an axis where it takes more than this part of it: the band around the curve shows that
/// nothing is sure.
const LARGEST: f32 = 0.3;

/// A curve that is being drawn.
pub(super) struct Drawing<'a> {
    pub(super) model: &'a CurveModel,
    pub(super) axes: &'a Axes,
    pub(super) plot: Rect,
    pub(super) figure: Figure,
    pub(super) measure: &'a dyn Measure,
    pub(super) obstacles: Obstacles,
    /// The middle of the ring.
    pub(super) ring: Option<Point>,
    chips: Vec<Rect>,
}

/// The color of the curve, of its band, and of what is written on the first.
pub(super) struct Inks {
    pub line: Ink,
    pub band: Ink,
}

impl<'a> Drawing<'a> {
    pub(super) fn new(model: &'a CurveModel, axes: &'a Axes, plot: Rect, figure: Figure, measure: &'a dyn Measure) -> Self {
        let mut drawing = Self {
            model,
            axes,
            plot,
            figure,
            measure,
            obstacles: Obstacles::default(),
            ring: None,
            chips: Vec::new(),
        };
        drawing.ring = model.point.as_ref().map(|point| drawing.at(point.x, point.y.value));
        drawing
    }

    pub(super) fn into_figure(self) -> Figure {
        self.figure
    }

    pub(super) fn x(&self, value: f64) -> f32 {
        self.axes.x.position(value, self.plot.left, self.plot.right)
    }

    pub(super) fn y(&self, value: f64) -> f32 {
        self.axes.y.position(value, self.plot.bottom, self.plot.top)
    }

    pub(super) fn at(&self, x: f64, y: f64) -> Point {
        Point::new(self.x(x), self.y(y))
    }

    pub(super) const fn inks(&self) -> Inks {
        if self.model.is_stale {
            Inks {
                line: Ink::Stale,
                band: Ink::StaleTint,
            }
        } else {
            Inks {
                line: Ink::Stereo,
                band: Ink::StereoBand,
            }
        }
    }

    /// The bands below the lines of the grid, and those.
    pub(super) fn grid(&mut self, across: &[Tick], down: &[Tick]) {
        self.band();
        self.level_band();
        self.projection_bands();
        let plot = self.plot;
        let line = Stroke::new(Ink::Line, 1.0);
        for tick in across.iter().filter(|tick| tick.value > self.axes.x.low) {
            let x = self.x(tick.value);
            self.figure.line(Point::new(x, plot.top), Point::new(x, plot.bottom), line);
        }
        for tick in down.iter().filter(|tick| tick.value > self.axes.y.low) {
            let y = self.y(tick.value);
            self.figure.line(Point::new(plot.left, y), Point::new(plot.right, y), line);
        }
        let corner = Point::new(plot.left, plot.bottom);
        let axis = Stroke::new(Ink::Border, 1.0);
        self.figure.line(Point::new(plot.left, plot.top), corner, axis);
        self.figure.line(corner, Point::new(plot.right, plot.bottom), axis);
    }

    /// The part of the horizontal axis, from the left, where `value` is above the plot.
    fn start(&self, value: impl Fn(f64) -> Option<f64>) -> f64 {
        let (mut above, mut below) = (self.axes.x.high * 1e-9, self.axes.x.high);
        for _ in 0..50 {
            let middle = (above * below).sqrt();
            if value(middle).is_none_or(|value| value > self.axes.y.high) {
                above = middle;
            } else {
                below = middle;
            }
        }
        below
    }

    /// Places from `start` to the end of the axis, close to each other where the curve is steep.
    fn places(&self, start: f64) -> impl Iterator<Item = f64> + use<> {
        let end = self.axes.x.high;
        (0..=PIECES).map(move |piece| {
            let part = f64::from(piece) / f64::from(PIECES);
            start + (end - start).max(0.0) * part * part
        })
    }

    /// The band of 2 σ around the curve, in pieces that are convex. Each reaches a little into the next, so that no gap shines through.
    fn band(&mut self) {
        const OVER: f32 = 1.5;
        let inks = self.inks();
        if self.model.point.as_ref().is_none_or(|point| point.y.sigma.is_none()) {
            return;
        }
        let start = self.start(|x| self.model.band_at(x).map(|span| span.low));
        // The upper edge comes in from above between two places.
        let enters = self.start(|x| self.model.band_at(x)?.high);
        let mut places: Vec<f64> = self.places(start).chain([enters]).collect();
        places.sort_by(f64::total_cmp);
        let ends: Vec<(f32, f32, f32)> = places
            .into_iter()
            .filter_map(|x| {
                let Span { low, high } = self.model.band_at(x)?;
                let top = high.map_or(self.plot.top, |high| self.y(high));
                Some((self.x(x), self.y(low), top))
            })
            .collect();
        for pair in ends.windows(2) {
            let &[(left, left_low, left_high), (right, right_low, right_high)] = pair else {
                continue;
            };
            let width = right - left;
            if width <= 0.0 {
                continue;
            }
            let over = OVER.min(self.plot.right - right).max(0.0);
            let beyond = |from: f32, to: f32| (to + (to - from) / width * over).clamp(self.plot.top, self.plot.bottom);
            let corners = vec![
                Point::new(left, left_high),
                Point::new(right + over, beyond(left_high, right_high)),
                Point::new(right + over, beyond(left_low, right_low)),
                Point::new(left, left_low),
            ];
            self.figure.area(corners, Fill::new(inks.band), None);
        }
    }

    /// The curve, from the top of the plot to its right.
    pub(super) fn curve(&mut self) {
        let start = self.start(|x| self.model.value_at(x));
        let points: Vec<Point> = self
            .places(start)
            .filter_map(|x| {
                let y = self.model.value_at(x)?;
                (y <= self.axes.y.high * (1.0 + 1e-6)).then(|| self.at(x, y))
            })
            .collect();
        if points.len() > 1 {
            self.obstacles.line(&points);
            self.figure.path(points, Stroke::new(self.inks().line, 2.5));
        }
        if let Some(ring) = self.ring {
            let half = RING + 2.0;
            self.obstacles
                .rect(Rect::new(ring.x - half, ring.y - half, ring.x + half, ring.y + half));
        }
    }

    /// The intervals of the point on both axes, as far as the lines to them.
    fn projection_bands(&mut self) {
        let (Some(point), Some(ring)) = (&self.model.point, self.ring) else {
            return;
        };
        let inks = self.inks();
        let plot = self.plot;
        let two = point.y.two().and_then(|two| Some((self.y(two.high?), self.y(two.low))));
        let half = 2.0 * point.x_sigma;
        let (left, right) = (self.x(point.x - half), self.x(point.x + half));
        if let Some((top, bottom)) = two.filter(|(top, bottom)| bottom - top < LARGEST * plot.height()) {
            self.figure
                .rect(Rect::new(plot.left, top, ring.x, bottom), 0.0, Fill::new(inks.band));
        }
        if half > 0.0 && right - left < LARGEST * plot.width() {
            let ink = if self.model.kind == Kind::Distance { inks.band } else { Ink::Band };
            self.figure.rect(Rect::new(left, ring.y, right, plot.bottom), 0.0, Fill::new(ink));
        }
    }

    /// The labels of both axes but those that a chip covers, and their titles.
    pub(super) fn labels(&mut self, across: &[Tick], down: &[Tick]) {
        self.chips = self.chip_rects();
        let plot = self.plot;
        let is_covered = |chips: &[Rect], rect: Rect| {
            let mut chips = chips.iter();
            chips.any(|chip| Rect::new(chip.left, chip.top - 2.0, chip.right, chip.bottom + 2.0).overlaps(rect))
        };
        let half = LABEL_SIZE / 2.0;
        for tick in down {
            let (y, right) = (self.y(tick.value), plot.left - LABEL_GAP);
            let width = crate::axis::width(&tick.label, self.measure);
            if !is_covered(&self.chips, Rect::new(right - width, y - half, right, y + half)) {
                let words = Words::new(tick.label.as_str(), Ink::Muted);
                self.figure.text(Point::new(right, y), Align::Right, words, LABEL_SIZE);
            }
        }
        // The 0 in the corner is that of the vertical axis.
        for tick in across.iter().filter(|tick| tick.value > self.axes.x.low) {
            let (x, y) = (self.x(tick.value), plot.bottom + 14.0);
            let width = crate::axis::width(&tick.label, self.measure) / 2.0 + LABEL_GAP;
            if !is_covered(&self.chips, Rect::new(x - width, y - half, x + width, y + half)) {
                let words = Words::new(tick.label.as_str(), Ink::Muted);
                self.figure.text(Point::new(x, y), Align::Center, words, LABEL_SIZE);
            }
        }
        let [x, y] = [&self.axes.x, &self.axes.y].map(|axis| Words::new(axis.title(), Ink::Muted));
        self.figure.text(Point::new(0.0, 8.0), Align::Left, y, LABEL_SIZE);
        let at = Point::new(plot.right, plot.bottom + 34.0);
        self.figure.text(at, Align::Right, x, LABEL_SIZE);
    }

    /// The chips of the point: at the vertical axis, and at the horizontal one.
    fn chip_rects(&self) -> Vec<Rect> {
        let (Some(point), Some(ring)) = (&self.model.point, self.ring) else {
            return Vec::new();
        };
        let width = |text: &str| self.measure.width(&Words::strong(text, Ink::OnStereo), LABEL_SIZE) + 2.0 * CHIP_PADDING;
        let right = self.plot.left - 1.0;
        let y = ring.y;
        let beside = Rect::new((right - width(&point.y_text)).max(0.0), y - CHIP_HALF, right, y + CHIP_HALF);
        let half = width(&point.x_text) / 2.0;
        let x = ring
            .x
            .clamp(self.plot.left.max(half), (self.figure.width - half).max(self.plot.left.max(half)));
        let top = self.plot.bottom + 5.0;
        vec![beside, Rect::new(x - half, top, x + half, top + 2.0 * CHIP_HALF)]
    }

    /// The point: the lines to its chips, those, and the ring, whose middle is returned.
    pub(super) fn point(&mut self) -> Option<Point> {
        let point = self.model.point.as_ref()?;
        let ring = self.ring?;
        let inks = self.inks();
        let given = match self.model.kind {
            Kind::Disparity if !self.model.is_stale => Ink::Text,
            _ => inks.line,
        };
        let dotted = |ink| Stroke::dashed(ink, 1.5, [2.0, 3.0]);
        self.figure.line(Point::new(self.plot.left, ring.y), ring, dotted(inks.line));
        self.figure.line(Point::new(ring.x, self.plot.bottom), ring, dotted(given));
        let texts = [(&point.y_text, inks.line), (&point.x_text, given)];
        for (chip, (text, ink)) in self.chips.iter().zip(texts) {
            self.figure.rect(*chip, 4.0, Fill::new(ink));
            let at = Point::new(f32::midpoint(chip.left, chip.right), f32::midpoint(chip.top, chip.bottom));
            // On black, white; on white, black.
            let on = if ink == Ink::Text { Ink::Surface } else { Ink::OnStereo };
            self.figure.text(at, Align::Center, Words::strong(text.as_str(), on), LABEL_SIZE);
        }
        let (inside, edge) = (Fill::new(Ink::Surface), Stroke::new(inks.line, 2.5));
        self.figure.circle(ring, RING, Some(inside), Some(edge));
        Some(ring)
    }
}
