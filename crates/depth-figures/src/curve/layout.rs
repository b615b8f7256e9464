//! The layout of a [`CurveModel`].

use super::drawing::{CHIP_PADDING, Drawing, LABEL_GAP};
use super::model::{Axes, CurveModel, Kind};
use super::tip;
use crate::axis::{self, LABEL_SIZE, Tick};
use crate::{Figure, Ink, Measure, Point, Rect, Words};
use depth_text::number;

/// The plot begins so far below the top of the figure, which the title of the vertical axis needs.
const TOP: f32 = 24.0;
/// What is below the plot: labels or a chip, and a title.
const BOTTOM: f32 = 42.0;
/// What is left of the plot at least: labels or a chip.
const LEFT: f32 = 48.0;
/// What is right of the plot at least: half of the last label.
const RIGHT: f32 = 12.0;
/// A margin grows by steps, so that the plot stands still while numbers change.
const STEP: f32 = 8.0;

/// How a curve is to be shown.
#[derive(Clone, Copy, Debug, Default)]
pub struct Shown<'a> {
    /// Axes that are kept, as while the point is dragged; `None` for those of the model.
    pub axes: Option<&'a Axes>,
    /// Where on the horizontal axis a tip is shown; `None` for none, as on paper.
    pub tip: Option<f64>,
}

/// A curve as it is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct Curve {
    /// The picture.
    pub figure: Figure,
    /// What is to be said at the title: "band: ± 2 σ", "last valid: d = 50 px", or nothing.
    pub caption: String,
    /// Where curve and grid are.
    pub plot: Rect,
    /// Its axes.
    pub axes: Axes,
    /// The middle of the ring; `None` where there is no point.
    pub handle: Option<Point>,
    /// Where the tip is, if one is shown.
    pub tip: Option<Rect>,
    /// What of every disparity is doffs, px.
    doffs: f64,
}

/// What a place on the curve says, for the pointer above it.
#[derive(Clone, Debug, PartialEq)]
pub struct Crosshair {
    /// The place on the horizontal axis, in its unit.
    pub x: f64,
    /// Where it is on the curve; at the edge of the plot where the curve is beyond it.
    pub at: Point,
    /// To the next value that is worth telling: one pixel, or about a tenth of the distance.
    pub step: f64,
    /// The lines of a tip.
    pub lines: Vec<Words>,
}

impl CurveModel {
    /// The curve in `width` by `height` points.
    pub fn layout(&self, width: f32, height: f32, shown: &Shown<'_>, measure: &dyn Measure) -> Curve {
        let axes = shown.axes.unwrap_or_else(|| self.axes()).clone();
        let ticks = axes.y.ticks_down(height - TOP - BOTTOM);
        let mut plot = Rect::new(self.left(&ticks, measure), TOP, width - RIGHT, height - BOTTOM);
        let across = axes.x.ticks_across(plot.width(), measure);
        if let Some(last) = across.last() {
            let is_end = axes.x.fraction(last.value) > 0.9;
            let half = if is_end { axis::width(&last.label, measure) / 2.0 } else { 0.0 };
            plot.right = width - RIGHT.max(half.ceil());
        }
        let mut drawing = Drawing::new(self, &axes, plot, Figure::new(width, height), measure);
        drawing.grid(&across, &ticks);
        drawing.curve();
        let tip = shown.tip.and_then(|x| drawing.place_tip(x));
        drawing.level();
        drawing.labels(&across, &ticks);
        let handle = drawing.point();
        if let Some(tip) = &tip {
            drawing.tip(tip);
        }
        Curve {
            figure: drawing.into_figure(),
            caption: self.caption(),
            plot,
            axes,
            handle,
            tip: tip.map(|tip| tip.rect),
            doffs: self.doffs(),
        }
    }

    /// What is shown where the pointer is at `x` points from the left of `curve`; `None` outside of its plot, or where there is no
    /// value.
    pub fn crosshair(&self, curve: &Curve, x: f32) -> Option<Crosshair> {
        if x < curve.plot.left || x > curve.plot.right {
            return None;
        }
        let place = match self.kind {
            Kind::Distance => curve.disparity_at(x) + curve.doffs,
            Kind::Disparity => curve.value_at(x),
        };
        let value = self.value_at(place)?;
        Some(Crosshair {
            x: place,
            at: curve.point_at(place, value),
            step: tip::step(self, place),
            lines: self.tip_at(place),
        })
    }

    /// The room left of the plot.
    fn left(&self, ticks: &[Tick], measure: &dyn Measure) -> f32 {
        let labels = ticks.iter().map(|tick| axis::width(&tick.label, measure)).fold(0.0, f32::max);
        let chip = self.point.as_ref().map_or(0.0, |point| {
            measure.width(&Words::strong(point.y_text.as_str(), Ink::OnStereo), LABEL_SIZE) + 2.0 * CHIP_PADDING + 1.0
        });
        let needed = (labels + LABEL_GAP).max(chip);
        LEFT.max((needed / STEP).ceil() * STEP)
    }
}

impl Curve {
    /// Where a value of the horizontal axis is, points from the left of the figure.
    pub fn x_of(&self, value: f64) -> f32 {
        self.axes.x.position(value, self.plot.left, self.plot.right)
    }

    /// Where a place in the units of the axes is in the figure, kept in the plot.
    pub fn point_at(&self, x: f64, y: f64) -> Point {
        let y = self.axes.y.position(y, self.plot.bottom, self.plot.top);
        Point::new(self.x_of(x), y)
    }

    /// The value of the horizontal axis at `x` points from the left of the figure, kept on the axis.
    pub fn value_at(&self, x: f32) -> f64 {
        let fraction = f64::from((x - self.plot.left) / self.plot.width().max(1.0));
        let end = self.axes.x.high;
        let steps = resolution(end, self.plot.width());
        number::rounded_to((fraction.clamp(0.0, 1.0) * end).max(steps), steps)
    }

    /// The disparity, without doffs, at `x` points from the left of the figure: rounded to what the picture can tell apart, and above
    /// zero with doffs in it. For "Distance against disparity".
    pub fn disparity_at(&self, x: f32) -> f64 {
        let end = self.axes.x.high;
        let steps = resolution(end, self.plot.width());
        let fraction = f64::from((x - self.plot.left) / self.plot.width().max(1.0));
        let effective = (fraction.clamp(0.0, 1.0) * end).max(steps);
        // The number that the field will show; rounding may not take it out of the picture.
        let rounded = number::rounded_to(effective - self.doffs, steps);
        if rounded + self.doffs > 0.0 {
            rounded
        } else {
            effective - self.doffs
        }
    }
}

/// The smallest number of pixels that a drag on an axis to `end`, `width` points long, can tell apart: a power of ten.
fn resolution(end: f64, width: f32) -> f64 {
    10f64.powf((end / f64::from(width.max(1.0))).log10().floor())
}
