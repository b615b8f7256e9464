//! The layout of a histogram of simulated distances.

use crate::axis::{Axis, LABEL_SIZE, Quantity};
use crate::{Align, Figure, Fill, Ink, Measure, Point, Rect, Stroke, Words};
use depth_core::measured::Measured;
use depth_core::monte_carlo::Distribution;
use depth_core::problem::Method;
use depth_core::quantity::{Length, LengthUnit};
use depth_text::sentences::percent;
use depth_text::style::Style;

/// What is below the axis: labels, its title and the legend, points.
const BELOW_AXIS: f32 = 40.0;
/// Above the highest bar, points.
const ABOVE: f32 = 4.0;

/// Simulated distances, counted in bins of equal width.
#[derive(Clone, Debug, PartialEq)]
pub struct Histogram {
    axis: Axis,
    counts: Vec<u32>,
    drawn: u32,
    median: Option<f64>,
    method: Method,
    like: Measured<Length>,
    unit: LengthUnit,
}

/// A histogram as it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Drawn {
    /// The picture.
    pub figure: Figure,
    /// Its bars, from the left.
    pub bars: Vec<Bar>,
}

/// A bar as it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Bar {
    /// Where it takes a pointer: its column.
    pub hit: Rect,
    /// The middle of its upper end.
    pub top: Point,
    /// What a tip says, a line each.
    pub tip: [String; 2],
}

impl Histogram {
    /// What was drawn for the distance of `method`, which is `like`: it is written as precisely as that. `None` where all draws are the
    /// same, or none is near enough to be drawn.
    pub fn new(distribution: &Distribution, method: Method, like: Measured<Length>, unit: LengthUnit) -> Option<Self> {
        let histogram = distribution.histogram.as_ref()?;
        let unit = Style::WINDOW.unit_of(like.value, unit);
        let [low, high] = [histogram.low, histogram.high].map(|end| end.in_unit(unit));
        Some(Self {
            axis: Axis::between(Quantity::distance(unit.symbol()), low, high)?,
            counts: histogram.counts.clone(),
            drawn: distribution.drawn,
            median: distribution.median.map(|median| median.in_unit(unit)),
            method,
            like,
            unit,
        })
    }

    /// The histogram in `width` by `height` points.
    pub fn layout(&self, width: f32, height: f32, measure: &dyn Measure) -> Drawn {
        let mut figure = Figure::new(width, height);
        let axis_y = height - BELOW_AXIS;
        let bars = self.bars(width, axis_y);
        let ink = match self.method {
            Method::Stereo => Ink::Stereo,
            Method::Monocular => Ink::Monocular,
        };
        for bar in &bars {
            // Without a gap between two that touch.
            let rect = Rect::new(bar.hit.left, bar.top.y, (bar.hit.right + 0.25).min(width), axis_y);
            figure.rect(rect, 0.0, Fill::new(ink));
        }
        self.draw_axis(&mut figure, axis_y, measure);
        if let Some(median) = self.median {
            let x = self.axis.position(median, 0.0, width);
            let stroke = Stroke::new(Ink::Text, 1.5);
            figure.line(Point::new(x, 0.0), Point::new(x, axis_y), stroke);
            let words = Words::new("median", Ink::Muted);
            let left = width - measure.width(&words, LABEL_SIZE);
            let y = axis_y + 32.0;
            figure.line(Point::new(left - 6.0, y - 6.0), Point::new(left - 6.0, y + 6.0), stroke);
            figure.text(Point::new(left, y), Align::Left, words, LABEL_SIZE);
        }
        Drawn { figure, bars }
    }

    fn bars(&self, width: f32, axis_y: f32) -> Vec<Bar> {
        let most = f64::from(self.counts.iter().copied().max().unwrap_or(1).max(1));
        let count = u32::try_from(self.counts.len()).unwrap_or(u32::MAX).max(1);
        let end = |at: u32| self.axis.value_at(f64::from(at) / f64::from(count));
        let bar = |(at, &draws): (u32, &u32)| {
            let [low, high] = [end(at), end(at + 1)];
            let [left, right] = [low, high].map(|end| self.axis.position(end, 0.0, width));
            let share = f64::from(draws) / most;
            let top = axis_y - crate::numbers::to_f32(share) * (axis_y - ABOVE);
            let [near, far] = [low, high].map(|end| Length::new(end, self.unit));
            Bar {
                hit: Rect::new(left, 0.0, right, axis_y),
                top: Point::new(f32::midpoint(left, right), top),
                tip: [
                    Style::WINDOW.range_like(near, Some(far), self.like, self.unit),
                    format!("{} of the draws", percent(f64::from(draws) / f64::from(self.drawn.max(1)))),
                ],
            }
        };
        (0..count).zip(&self.counts).map(bar).collect()
    }

    fn draw_axis(&self, figure: &mut Figure, y: f32, measure: &dyn Measure) {
        let width = figure.width;
        let line = Stroke::new(Ink::Border, 1.0);
        figure.line(Point::new(0.0, y), Point::new(width, y), line);
        for tick in self.axis.ticks_across(width, measure) {
            let x = self.axis.position(tick.value, 0.0, width);
            let half = crate::axis::width(&tick.label, measure) / 2.0;
            // One at an end would stand beside its tick.
            if x < half || x > width - half {
                continue;
            }
            figure.line(Point::new(x, y), Point::new(x, y + 4.0), line);
            figure.text(
                Point::new(x, y + 14.0),
                Align::Center,
                Words::new(tick.label, Ink::Muted),
                LABEL_SIZE,
            );
        }
        let title = Words::new(self.axis.title(), Ink::Muted);
        figure.text(Point::new(0.0, y + 32.0), Align::Left, title, LABEL_SIZE);
    }
}

#[cfg(test)]
mod tests {
    #![allow(clippy::unwrap_used, clippy::indexing_slicing, reason = "tests")]

    use super::*;
    use crate::InterWidths;
    use depth_core::monte_carlo;

    fn histogram() -> Histogram {
        let bins = monte_carlo::Histogram {
            low: Length::from_m(1.0),
            high: Length::from_m(3.0),
            counts: vec![10, 40, 20, 5],
            below: 5,
            beyond: 20,
        };
        Histogram {
            axis: Axis::between(Quantity::distance("m"), bins.low.m(), bins.high.m()).unwrap(),
            counts: bins.counts,
            drawn: 100,
            median: Some(1.75),
            method: Method::Stereo,
            like: Measured::from_base(1.8, 0.4),
            unit: LengthUnit::Meter,
        }
    }

    #[test]
    fn bars_stand_side_by_side_as_high_as_what_they_count() {
        let drawn = histogram().layout(400.0, 144.0, &InterWidths);
        let heights: Vec<f32> = drawn.bars.iter().map(|bar| 104.0 - bar.top.y).collect();
        assert_eq!(heights, [25.0, 100.0, 50.0, 12.5]);
        assert!(drawn.bars.windows(2).all(|pair| pair[0].hit.right == pair[1].hit.left));
        assert_eq!(drawn.bars[1].tip, ["1.50…2.00 m", "40 % of the draws"]);
    }

    #[test]
    fn nothing_leaves_the_picture() {
        for width in [200.0, 366.0, 700.0] {
            let drawn = histogram().layout(width, 144.0, &InterWidths);
            crate::checks::assert_tidy(&drawn.figure, &format!("{width} wide"));
        }
    }
}
