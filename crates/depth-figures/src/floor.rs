//! The ground of a view to scale: grid, axis labels, and the marks that dimension a drawing.

use crate::labels::rect_at;
use crate::{Align, Figure, Ink, Measure, Point, Rect, Stroke, Words};
use depth_core::quantity::{Length, LengthUnit};
use depth_text::number;

/// The size of the labels of axes.
pub(crate) const AXIS_TEXT: f32 = 12.0;
/// The size of the labels of things.
pub(crate) const LABEL_TEXT: f32 = 12.5;
/// Half of what stands across the end of a dimension line.
pub(crate) const CAP: f32 = 4.0;
/// Grid lines closer than this are a pattern.
const CLOSEST: f64 = 45.0;
/// Room between two labels of an axis.
const LABEL_ROOM: f32 = 14.0;

/// A coordinate of a figure; what is too small to see becomes zero.
#[expect(clippy::cast_possible_truncation, reason = "a place in a figure needs no more than an f32")]
pub(crate) const fn to_f32(points: f64) -> f32 {
    points as f32
}

/// Where meters are in a figure.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Scale {
    /// Where 0 of both axes is.
    pub(crate) origin: Point,
    /// Points per meter, to the right and up.
    pub(crate) per_meter: [f64; 2],
}

impl Scale {
    /// The same on both axes.
    pub(crate) const fn even(origin: Point, per_meter: f64) -> Self {
        Self {
            origin,
            per_meter: [per_meter; 2],
        }
    }

    /// The place `x_m` to the right and `up_m` up.
    pub(crate) fn at(&self, x_m: f64, up_m: f64) -> Point {
        let [x, up] = self.per_meter;
        Point::new(self.origin.x + to_f32(x_m * x), self.origin.y - to_f32(up_m * up))
    }
}

/// The axes of a view.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Axes<'a> {
    /// Where the grid is; it may go below the line of 0.
    pub(crate) plot: Rect,
    pub(crate) scale: Scale,
    /// The unit of the labels.
    pub(crate) unit: LengthUnit,
    /// The distances of grid lines in that unit, across and up.
    pub(crate) steps: [f64; 2],
    /// What is up, without its unit; at the upper left corner of the figure.
    pub(crate) up: &'a str,
    /// Where the labels of the other axis stand.
    pub(crate) below: f32,
    /// What is to the right, and where that is written.
    pub(crate) across: (&'a str, Point, Align),
}

/// The smallest of 1, 2 and 5 times a power of ten that is no less than `least`.
pub(crate) fn round_up(least: f64) -> f64 {
    let power = 10.0_f64.powf(least.log10().floor());
    let multiples = [1.0, 2.0, 5.0, 10.0].map(|digit| digit * power);
    multiples.into_iter().find(|step| *step >= least * (1.0 - 1e-9)).unwrap_or(least)
}

/// A round distance of grid lines in `unit`, where `per_meter` points are a meter: far enough apart for the eye, and for labels up to
/// `largest_m`.
pub(crate) fn grid_step(measure: &dyn Measure, per_meter: f64, unit: LengthUnit, largest_m: f64) -> f64 {
    let per_unit = per_meter * Length::new(1.0, unit).m();
    let mut step = round_up(CLOSEST / per_unit);
    // A longer step has shorter labels, so this ends.
    for _ in 0..4 {
        let largest = (Length::from_m(largest_m).in_unit(unit) / step).floor() * step;
        let width = measure.width(&Words::new(format!("−{}", tick_text(largest, step)), Ink::Muted), AXIS_TEXT) + LABEL_ROOM;
        if f64::from(width) <= step * per_unit {
            break;
        }
        step = round_up(step * 1.01);
    }
    step
}

/// `value`, a multiple of `step`, with the decimals of the step: "1.0".
pub(crate) fn tick_text(value: f64, step: f64) -> String {
    if value.abs() < step / 2.0 {
        return "0".to_owned();
    }
    let is_long = !(1e-4..1e6).contains(&value.abs()) || step < 1e-4;
    if is_long {
        return number::with_minus(&number::significant(value, 2));
    }
    if step >= 1.0 {
        return number::with_minus(&number::plain(value));
    }
    let decimals = usize::try_from(-number::magnitude(step)).unwrap_or(0);
    number::with_minus(&format!("{value:.decimals$}"))
}

/// The room that the labels up to `largest` need at the left of a plot.
pub(crate) fn room_for_ticks(measure: &dyn Measure, step: f64, largest: f64) -> f32 {
    let width = |tick| measure.width(&Words::new(tick_text(tick, step), Ink::Muted), AXIS_TEXT);
    ticks(step, 0.0, largest).map(width).fold(26.0, f32::max) + 8.0
}

/// "0.5 m"
pub(crate) fn step_text(step: f64, unit: LengthUnit) -> String {
    format!("{} {}", number::plain(step), unit.symbol())
}

/// The multiples of `step` between `from` and `to`, no more than anybody would label.
pub(crate) fn ticks(step: f64, from: f64, to: f64) -> impl Iterator<Item = f64> {
    let first = (from / step - 1e-6).ceil();
    std::iter::successors(Some(first), |index| Some(index + 1.0))
        .map(move |index| index * step)
        .take_while(move |tick| *tick <= to + step * 1e-6)
        .take(60)
}

impl Axes<'_> {
    /// Draws the grid and its labels. Returns where text stands.
    pub(crate) fn draw(&self, figure: &mut Figure, measure: &dyn Measure) -> Vec<Rect> {
        let grid = Stroke::new(Ink::Line, 1.0);
        let plot = self.plot;
        let with_unit = |name: &str| format!("{name} ({})", self.unit.symbol());
        let (across, across_at, across_align) = self.across;
        let mut texts = Texts {
            figure,
            measure,
            taken: Vec::new(),
        };
        texts.put(with_unit(self.up), (Point::new(0.0, 8.0), Align::Left));
        let across = texts.put(with_unit(across), (across_at, across_align));
        let [step_x, step_up] = self.steps;
        let in_unit = |points: f32, axis: f64| Length::from_m(f64::from(points) / axis).in_unit(self.unit);
        let [per_x, per_up] = self.scale.per_meter;
        let origin = self.scale.origin;
        for tick in ticks(step_x, in_unit(plot.left - origin.x, per_x), in_unit(plot.right - origin.x, per_x)) {
            let x = self.scale.at(Length::new(tick, self.unit).m(), 0.0).x;
            // Not through the name of the axis.
            let crossed = across.filter(|name| name.left - 3.0 < x && x < name.right + 3.0 && name.top < plot.bottom);
            let gap = crossed.map_or([plot.bottom; 2], |name| [name.top - 1.0, (name.bottom + 1.0).min(plot.bottom)]);
            for (from, to) in [(plot.top, gap[0]), (gap[1], plot.bottom)] {
                if to > from {
                    texts.figure.line(Point::new(x, from), Point::new(x, to), grid);
                }
            }
            texts.put(tick_text(tick, step_x), (Point::new(x, self.below), Align::Center));
        }
        for tick in ticks(
            step_up,
            in_unit(origin.y - plot.bottom, per_up).max(0.0),
            in_unit(origin.y - plot.top, per_up),
        ) {
            let y = self.scale.at(0.0, Length::new(tick, self.unit).m()).y;
            let is_zero = tick.abs() < step_up / 2.0;
            let stroke = if is_zero { Stroke::new(Ink::Border, 1.0) } else { grid };
            texts.figure.line(Point::new(plot.left, y), Point::new(plot.right, y), stroke);
            texts.put(tick_text(tick, step_up), (Point::new(plot.left - 8.0, y), Align::Right));
        }
        texts.taken
    }
}

/// The labels of axes: each where it is neither cut off nor on another one, or not at all.
struct Texts<'a> {
    figure: &'a mut Figure,
    measure: &'a dyn Measure,
    taken: Vec<Rect>,
}

impl Texts<'_> {
    /// Returns where it stands, if it does.
    fn put(&mut self, text: String, (at, align): (Point, Align)) -> Option<Rect> {
        let words = Words::new(text, Ink::Muted);
        let width = self.measure.width(&words, AXIS_TEXT);
        let inner = rect_at([width, AXIS_TEXT], (at, align));
        let is_inside = inner.left >= 0.0 && inner.right <= self.figure.width && inner.top >= 0.0 && inner.bottom <= self.figure.height;
        let with_room = Rect::new(inner.left - 4.0, inner.top, inner.right + 4.0, inner.bottom);
        if !is_inside || self.taken.iter().any(|other| other.overlaps(with_room)) {
            return None;
        }
        self.taken.push(inner);
        self.figure.text(at, align, words, AXIS_TEXT);
        Some(inner)
    }
}

/// A line with a cap across each end.
pub(crate) fn dimension(figure: &mut Figure, from: Point, to: Point, stroke: Stroke) {
    figure.line(from, to, stroke);
    let is_level = (from.y - to.y).abs() < (from.x - to.x).abs();
    let (dx, dy) = if is_level { (0.0, CAP) } else { (CAP, 0.0) };
    for end in [from, to] {
        figure.line(Point::new(end.x - dx, end.y - dy), Point::new(end.x + dx, end.y + dy), stroke);
    }
}

/// A level dimension line that is too short or too long to be drawn: it has a gap with two slanted strokes.
pub(crate) fn broken_dimension(figure: &mut Figure, from: Point, to: Point, stroke: Stroke) {
    let middle = f32::midpoint(from.x, to.x);
    for (end, inner) in [(from, middle - 5.0), (to, middle + 5.0)] {
        figure.line(end, Point::new(inner, end.y), stroke);
        figure.line(Point::new(end.x, end.y - CAP), Point::new(end.x, end.y + CAP), stroke);
        figure.line(Point::new(inner - 2.5, end.y + 5.0), Point::new(inner + 2.5, end.y - 5.0), stroke);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::InterWidths;

    #[test]
    fn steps_are_round_and_leave_room_for_their_labels() {
        for exponent in -5..8 {
            let per_meter = 139.0 * 10.0_f64.powi(exponent);
            let step = grid_step(&InterWidths, per_meter, LengthUnit::Meter, 300.0 / per_meter);
            let digit = step / 10.0_f64.powf(step.log10().floor() + 1e-9);
            assert!(
                [1.0, 2.0, 5.0, 10.0].iter().any(|round| (digit / round - 1.0).abs() < 1e-6),
                "{step}"
            );
            assert!((45.0..=250.0).contains(&(step * per_meter)), "{step} at {per_meter}");
        }
    }

    #[test]
    fn labels_have_the_decimals_of_their_step() {
        assert_eq!(tick_text(1.0, 0.5), "1.0");
        assert_eq!(tick_text(-10.0, 5.0), "−10");
        assert_eq!(tick_text(-1e-17, 0.5), "0");
        assert_eq!(tick_text(0.15, 0.05), "0.15");
    }
}
