//! The layout of [`Bars`]: a heading and a bar for each row, over one axis.

use crate::axis::{Axis, LABEL_SIZE};
use crate::bars::{Bars, Gap, Looks, RowId, RowModel};
use crate::spans::{Estimate, Span};
use crate::{Align, Figure, Fill, Ink, Measure, Point, Rect, Stroke, Words};

/// The size of headings and values, points.
const HEADING_SIZE: f32 = 12.5;
/// The middle of a heading below the top of its row, points.
const HEADING_AT: f32 = 9.0;
/// Where the track of a bar begins below the top of its row, points.
const TRACK_AT: f32 = 19.0;
/// What is below the axis: labels, its title and the legend, points.
const BELOW_AXIS: f32 = 40.0;
/// Between the last row and the axis, points.
const ABOVE_AXIS: f32 = 6.0;
/// The height of a bar at least and at most, and as a part of its track, points.
const BAR: [f32; 2] = [16.0, 24.0];
const BAR_SHARE: f32 = 0.36;
/// What is left free at the right of an axis from zero, so that its last label stands below its tick, points.
const END: f32 = 12.0;
/// What is left free at both ends of an axis around the values, points: at its left the bars are broken.
const FREE: [f32; 2] = [31.0, 28.0];
/// How far a label may stand beside its tick, unless that is at an end of the axis, points.
const MOVED: f32 = 5.0;
/// The length of an arrow head at the end of an interval that goes on, points.
const HEAD: f32 = 9.0;
/// How much farther than the farthest value an axis goes for an interval that is long.
const FARTHEST: f64 = 3.0;
/// Values that are spread over less than this part of the farthest have an axis around them.
const NARROW: f64 = 0.5;

/// Rows as they are drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Rows {
    /// The picture.
    pub figure: Figure,
    /// What is to be said of the axis: "axis does not start at 0", "axis from zero"; empty where nothing is drawn.
    pub caption: String,
    /// The rows, from the top.
    pub rows: Vec<Row>,
}

/// A row as it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Row {
    /// Which it is.
    pub id: RowId,
    /// Where it takes a pointer.
    pub hit: Rect,
    /// Its point; `None` where it is empty.
    pub point: Option<Point>,
    /// Its heading.
    pub name: Words,
    /// Its value.
    pub value: Words,
    /// What a tip says, a line each; empty without σ.
    pub tip: Vec<String>,
}

impl Bars {
    /// The rows in `width` by `height` points.
    pub fn layout(&self, width: f32, height: f32, measure: &dyn Measure) -> Rows {
        let scale = Scale::of(self);
        let mut drawing = Drawing {
            figure: Figure::new(width, height),
            axis: scale.as_ref().and_then(|scale| scale.axis(width, &self.quantity)),
            is_broken: matches!(scale, Some(Scale::Around(..))),
            has_bars: self.has_bars,
            measure,
        };
        let axis_y = height - BELOW_AXIS;
        let count = u16::try_from(self.rows.len().max(1)).unwrap_or(u16::MAX);
        let pitch = (axis_y - ABOVE_AXIS) / f32::from(count);
        let tops = (0..count).map(|row| f32::from(row) * pitch);
        let rows: Vec<(Rect, &RowModel)> = tops.map(|top| Rect::new(0.0, top, width, top + pitch)).zip(&self.rows).collect();
        drawing.background(&rows, self.band, axis_y);
        let drawn = rows.iter().map(|&(rect, row)| drawing.row(rect, row)).collect();
        if let (Some(gap), Some((rect, _))) = (&self.gap, rows.last()) {
            drawing.gap(track(*rect), gap);
        }
        let has_sigma = self.rows.iter().any(|row| row.estimate.is_some_and(|known| known.sigma.is_some()));
        drawing.axis(axis_y, has_sigma, self.band.is_some());
        let caption = match (&drawing.axis, scale) {
            (Some(_), Some(Scale::Around(..))) => "axis does not start at 0",
            (Some(_), Some(Scale::FromZero(_))) => "axis from zero",
            _ => "",
        };
        Rows {
            figure: drawing.figure,
            caption: caption.to_owned(),
            rows: drawn,
        }
    }
}

/// What has to be on the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Scale {
    FromZero(f64),
    Around(f64, f64),
}

impl Scale {
    fn of(bars: &Bars) -> Option<Self> {
        let estimates = || bars.rows.iter().filter_map(|row| row.estimate);
        let farthest = estimates().map(|known| known.value).fold(f64::NEG_INFINITY, f64::max);
        if !farthest.is_finite() {
            return None;
        }
        let nearest = estimates().map(|known| known.value).fold(f64::INFINITY, f64::min);
        let low = estimates()
            .filter_map(|known| known.two())
            .map(|two| two.low)
            .fold(nearest, f64::min);
        let ends = || {
            estimates()
                .filter_map(|known| known.two())
                .map(|two| two.high.unwrap_or(f64::INFINITY))
        };
        let high = ends().fold(farthest, f64::max);
        let is_narrow = high > low && high - low < NARROW * high.abs();
        // What was solved for may be below zero, and then no bar begins there.
        if is_narrow || (!bars.has_bars && high.is_finite() && high > low) {
            // Digits behind the fifth are too long for labels.
            let least = 1e-5 * high.abs();
            let more = ((least - (high - low)) / 2.0).max(0.0);
            return Some(Self::Around(low - more, high + more));
        }
        // An interval that is far too long would leave no room for the values: it ends in an arrow.
        Some(Self::FromZero(high.min(FARTHEST * farthest) * 1.04))
    }

    fn axis(self, width: f32, quantity: &crate::axis::Quantity) -> Option<Axis> {
        match self {
            Self::FromZero(least) => Axis::from_zero(quantity.clone(), least),
            Self::Around(low, high) => {
                let [left, right] = FREE.map(f64::from);
                let point = (high - low) / (f64::from(width) - left - right).max(1.0);
                Axis::between(quantity.clone(), low - left * point, high + right * point)
            }
        }
    }
}

/// The colors of a row: its line, its bar.
const fn inks(looks: Looks) -> (Ink, Fill) {
    match looks {
        Looks::Stereo => (Ink::Stereo, Fill::new(Ink::StereoTint)),
        Looks::Monocular => (Ink::Monocular, Fill::new(Ink::MonocularTint)),
        Looks::Combined => (Ink::Text, Fill::sheer(Ink::Line, 0.8)),
        Looks::Supposed => (Ink::ShareFirst, Fill::sheer(Ink::Line, 0.8)),
        Looks::Stale => (Ink::Stale, Fill::new(Ink::StaleTint)),
    }
}

/// Where the bar of a row is.
fn track(row: Rect) -> Rect {
    Rect::new(row.left, (row.top + TRACK_AT).min(row.bottom), row.right, row.bottom)
}

/// The middle of the bar in its track: near the heading that it belongs to.
fn middle(track: Rect) -> f32 {
    let height = track.height();
    track.top + (height / 2.0).min(12.0) + (height - 37.0).max(0.0) * 0.4
}

struct Drawing<'a> {
    figure: Figure,
    axis: Option<Axis>,
    is_broken: bool,
    has_bars: bool,
    measure: &'a dyn Measure,
}

impl Drawing<'_> {
    fn x(&self, value: f64) -> f32 {
        let right = self.axis_width();
        self.axis.as_ref().map_or(0.0, |axis| axis.position(value, 0.0, right))
    }

    /// How long the axis is.
    fn axis_width(&self) -> f32 {
        self.figure.width - if self.is_broken { 0.0 } else { END }
    }

    /// The band and the grid lines, in the tracks only.
    fn background(&mut self, rows: &[(Rect, &RowModel)], band: Option<Span>, axis_y: f32) {
        let Some(axis) = self.axis.clone() else { return };
        let width = self.figure.width;
        let ticks = axis.ticks_across(self.axis_width(), self.measure);
        for (index, (row, _)) in rows.iter().enumerate() {
            let is_last = index + 1 == rows.len();
            let track = track(*row);
            let bottom = if is_last { axis_y } else { track.bottom };
            if let Some(band) = band {
                let right = band.high.map_or(width, |high| self.x(high));
                let rect = Rect::new(self.x(band.low), track.top, right, bottom);
                self.figure.rect(rect, 0.0, Fill::new(Ink::Band));
            }
            for tick in &ticks {
                let x = self.x(tick.value).clamp(0.5, width - 0.5);
                let stroke = Stroke::new(Ink::Line, 1.0);
                self.figure.line(Point::new(x, track.top), Point::new(x, bottom), stroke);
            }
        }
    }

    fn row(&mut self, rect: Rect, row: &RowModel) -> Row {
        let y = rect.top + HEADING_AT;
        let size = self.heading_size(row);
        self.figure.text(Point::new(0.0, y), Align::Left, row.name.clone(), size);
        self.figure
            .text(Point::new(self.figure.width, y), Align::Right, row.value.clone(), size);
        let point = row
            .estimate
            .filter(|_| self.axis.is_some())
            .map(|estimate| self.bar(track(rect), row.looks, &estimate));
        Row {
            id: row.id,
            hit: rect,
            point,
            name: row.name.clone(),
            value: row.value.clone(),
            tip: row.tip.clone(),
        }
    }

    /// Smaller where name and value would run into each other.
    fn heading_size(&self, row: &RowModel) -> f32 {
        const APART: f32 = 10.0;
        let taken = self.measure.width(&row.name, HEADING_SIZE) + self.measure.width(&row.value, HEADING_SIZE);
        HEADING_SIZE * ((self.figure.width - APART) / taken.max(1.0)).min(1.0)
    }

    /// The bar with its intervals and its point, which is returned.
    fn bar(&mut self, track: Rect, looks: Looks, estimate: &Estimate) -> Point {
        let (ink, fill) = inks(looks);
        let y = middle(track);
        let x = self.x(estimate.value);
        let [least, most] = BAR;
        let height = (track.height() * BAR_SHARE).clamp(least, most);
        let half = (height / 2.0).min(track.height() / 2.0);
        if self.has_bars {
            let bar = Rect::new(0.0, y - half, x, y + half);
            self.figure.rect(bar, 0.0, fill);
            if self.is_broken {
                self.break_mark(bar);
            }
        }
        if let Some([one, two]) = estimate.intervals {
            self.interval(y, two, Stroke::new(ink, 2.0));
            self.interval(y, one, Stroke::new(ink, 6.0 * height / least));
        }
        let center = Point::new(x.clamp(6.5, self.figure.width - 6.5), y);
        if looks == Looks::Stale {
            let (inside, edge) = (Fill::new(Ink::Surface), Stroke::new(ink, 1.5));
            self.figure.circle(center, 4.0, Some(inside), Some(edge));
        } else {
            self.figure.circle(center, 5.75, Some(Fill::new(Ink::Surface)), None);
            self.figure.circle(center, 4.25, Some(Fill::new(ink)), None);
        }
        center
    }

    /// Two strokes through a bar that does not begin at zero.
    fn break_mark(&mut self, bar: Rect) {
        const SLANT: f32 = 6.0;
        const APART: f32 = 4.0;
        let at = |x: f32| [Point::new(x + SLANT, bar.top - 1.0), Point::new(x, bar.bottom + 1.0)];
        let ([a, b], [c, d]) = (at(9.0), at(9.0 + APART));
        self.figure.area(vec![a, c, d, b], Fill::new(Ink::Surface), None);
        for (from, to) in [(a, b), (c, d)] {
            self.figure.line(from, to, Stroke::new(Ink::Border, 1.0));
        }
    }

    /// A line over an interval, with an arrow head where it goes on beyond the axis.
    fn interval(&mut self, y: f32, span: Span, stroke: Stroke) {
        let Some(axis) = &self.axis else { return };
        let (end, width) = (axis.high, self.figure.width);
        let from = self.x(span.low);
        let to = match span.high {
            Some(high) if high <= end => self.x(high),
            _ => {
                let tip = Point::new(width, y);
                let half = 3.0 + stroke.width / 2.0;
                let head = vec![Point::new(width - HEAD, y - half), tip, Point::new(width - HEAD, y + half)];
                self.figure.area(head, Fill::new(stroke.ink), None);
                width - HEAD
            }
        };
        if to > from {
            self.figure.line(Point::new(from, y), Point::new(to, y), stroke);
        }
    }

    /// A bracket between two points, and how far they are apart.
    fn gap(&mut self, track: Rect, gap: &Gap) {
        const APART: f32 = 9.0;
        const CAP: f32 = 4.0;
        if self.axis.is_none() {
            return;
        }
        let (y, width) = (middle(track), self.figure.width);
        let ends = gap.between.map(|value| self.x(value).clamp(0.5, width - 0.5));
        let [one, other] = ends;
        let [left, right] = [one.min(other), one.max(other)];
        let stroke = Stroke::new(Ink::Error, 1.5);
        for x in [left, right] {
            self.figure.line(Point::new(x, y - CAP), Point::new(x, y + CAP), stroke);
        }
        let words = |text: &String| Words::strong(text, Ink::Error);
        let place = |text: &String| {
            let taken = self.measure.width(&words(text), LABEL_SIZE);
            let middle = f32::midpoint(left, right);
            let fits = right - left >= taken + 3.0 * APART;
            let centers = [
                fits.then_some(middle),
                (right + APART + taken <= width).then_some(right + APART + taken / 2.0),
                (left - APART - taken >= 0.0).then_some(left - APART - taken / 2.0),
            ];
            Some((words(text), centers.into_iter().flatten().next()?, taken, fits))
        };
        let Some((words, center, taken, is_between)) = gap.texts.iter().find_map(place) else {
            self.figure.line(Point::new(left, y), Point::new(right, y), stroke);
            return;
        };
        let half = taken / 2.0 + APART;
        let pieces = if is_between {
            vec![(left, center - half), (center + half, right)]
        } else {
            vec![(left, right)]
        };
        for (from, to) in pieces {
            self.figure.line(Point::new(from, y), Point::new(to, y), stroke);
        }
        self.figure.text(Point::new(center, y), Align::Center, words, LABEL_SIZE);
    }

    fn axis(&mut self, y: f32, has_sigma: bool, has_band: bool) {
        let width = self.figure.width;
        let line = Stroke::new(Ink::Border, 1.0);
        self.figure.line(Point::new(0.0, y), Point::new(width, y), line);
        let Some(axis) = self.axis.clone() else { return };
        for tick in axis.ticks_across(self.axis_width(), self.measure) {
            let x = self.x(tick.value);
            let half = crate::axis::width(&tick.label, self.measure) / 2.0;
            let mark = x.clamp(0.5, width - 0.5);
            self.figure.line(Point::new(mark, y), Point::new(mark, y + 4.0), line);
            let inside = x.clamp(half, (width - half).max(half));
            let is_end = x < 1.0 || x > width - 1.0;
            if (inside - x).abs() > MOVED && !is_end {
                continue;
            }
            let at = Point::new(inside, y + 14.0);
            self.figure.text(at, Align::Center, Words::new(tick.label, Ink::Muted), LABEL_SIZE);
        }
        let title = Words::new(axis.title(), Ink::Muted);
        let taken = self.measure.width(&title, LABEL_SIZE);
        self.figure.text(Point::new(0.0, y + 32.0), Align::Left, title, LABEL_SIZE);
        if has_sigma {
            self.legend(y + 32.0, taken + 10.0, has_band);
        }
    }

    /// "▮ combined  ▬ ± 1 σ  — ± 2 σ" at the right, as far as there is room beyond `from`.
    fn legend(&mut self, y: f32, from: f32, has_band: bool) {
        const SWATCH: f32 = 22.0;
        const APART: f32 = 6.0;
        const BETWEEN: f32 = 16.0;
        let words = |times: u8| Words::new(format!("± {times} σ"), Ink::Muted);
        let taken = |times| self.measure.width(&words(times), LABEL_SIZE);
        let item = |right: f32, times| (right - taken(times) - APART - SWATCH, right - taken(times));
        let (two, two_text) = item(self.figure.width, 2);
        let (one, one_text) = item(two - BETWEEN, 1);
        if one < from {
            return;
        }
        for (left, text, times, thick) in [(one, one_text, 1, 6.0), (two, two_text, 2, 2.0)] {
            let stroke = Stroke::new(Ink::Muted, thick);
            self.figure.line(Point::new(left, y), Point::new(left + SWATCH, y), stroke);
            self.figure.text(Point::new(text, y), Align::Left, words(times), LABEL_SIZE);
        }
        let name = Words::new(if self.has_bars { "combined" } else { "as typed" }, Ink::Muted);
        let text = one - BETWEEN - self.measure.width(&name, LABEL_SIZE);
        let band = Rect::new(text - APART - 12.0, y - 6.0, text - APART, y + 6.0);
        if has_band && band.left >= from {
            self.figure
                .frame(band, 0.0, Some(Fill::new(Ink::Band)), Stroke::new(Ink::Line, 1.0));
            self.figure.text(Point::new(text, y), Align::Left, name, LABEL_SIZE);
        }
    }
}
