//! The axis of every plot: round ticks, one way to write all of its numbers, and a range in which nothing touches an edge.

use crate::Measure;
use crate::numbers::to_f32;
use crate::{Ink, Words};
use depth_text::number::with_minus;

/// The size of the labels and titles of axes, points.
pub const LABEL_SIZE: f32 = 12.0;
/// Ticks across stand no closer than this, points, unless that makes the last one stand at the end.
const ACROSS: f32 = 62.0;
/// … and then no closer than this.
const CLOSE_ACROSS: f32 = 44.0;
/// So many ticks are enough to read a value.
const ENOUGH: usize = 4;
/// Ticks above each other stand no closer than this, points.
const DOWN: f32 = 32.0;
/// Labels that stand beside each other have at least this between them, points.
const GAP: f32 = 8.0;
/// Ends at which an axis may stop: round, and not too far apart.
const ENDS: [f64; 12] = [1.0, 1.2, 1.5, 1.6, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0];
/// Steps between ticks.
const STEPS: [f64; 4] = [1.0, 2.0, 2.5, 5.0];
/// Numbers from here on have their power of ten in the title.
const LARGE: f64 = 1e5;
/// Numbers below this have their power of ten in the title.
const SMALL: f64 = 1e-3;

/// What an axis counts.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Quantity {
    /// "Distance D".
    pub name: String,
    /// "m".
    pub unit: String,
}

/// An axis: what it counts, and from where to where.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// What it counts.
    pub quantity: Quantity,
    /// The value at its start, in its unit.
    pub low: f64,
    /// The value at its end.
    pub high: f64,
}

/// A tick of an axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Tick {
    /// Its value, in the unit of the axis.
    pub value: f64,
    /// Its label.
    pub label: String,
}

impl Quantity {
    /// `name` in `unit`.
    pub fn new(name: impl Into<String>, unit: impl Into<String>) -> Self {
        Self {
            name: name.into(),
            unit: unit.into(),
        }
    }

    /// "Distance D" in `unit`.
    pub fn distance(unit: &str) -> Self {
        Self::new("Distance D", unit)
    }

    /// "Disparity d" in pixels, or what enters the formula where doffs is part of it.
    pub fn disparity(has_doffs: bool) -> Self {
        Self::new(if has_doffs { "Disparity d + doffs" } else { "Disparity d" }, "px")
    }
}

impl Axis {
    /// From 0 to the next round number that is not below `least`; `None` where that is no positive number that can be drawn.
    pub fn from_zero(quantity: Quantity, least: f64) -> Option<Self> {
        let high = round_up(least);
        (least.is_normal() && least > 0.0 && high.is_normal()).then_some(Self { quantity, low: 0.0, high })
    }

    /// From `low` to `high` as they are; `None` unless that is a range that can be drawn.
    pub fn between(quantity: Quantity, low: f64, high: f64) -> Option<Self> {
        let is_drawable = low.is_finite() && high.is_finite() && (high - low).is_normal() && high > low;
        is_drawable.then_some(Self { quantity, low, high })
    }

    /// Where `value` is, from 0 at the start to 1 at the end; beyond them where it is not on the axis.
    pub fn fraction(&self, value: f64) -> f64 {
        (value - self.low) / (self.high - self.low)
    }

    /// The value at a fraction of the axis.
    pub fn value_at(&self, fraction: f64) -> f64 {
        self.low + fraction * (self.high - self.low)
    }

    /// Where `value` is between two positions, kept between them.
    pub(crate) fn position(&self, value: f64, from: f32, to: f32) -> f32 {
        from + (to - from) * to_f32(self.fraction(value).clamp(0.0, 1.0))
    }

    /// Its title, with the power of ten that its labels leave out: "Distance D (m)", "Distance D (10⁶ m)".
    pub fn title(&self) -> String {
        let Quantity { name, unit } = &self.quantity;
        match self.exponent() {
            0 => format!("{name} ({unit})"),
            exponent => format!("{name} (10{} {unit})", raised(exponent)),
        }
    }

    /// The axis on the way from this one to `other`: this one at 0, the other at 1. For a window that moves from one to the other.
    #[must_use]
    pub fn eased(&self, other: &Self, factor: f64) -> Self {
        let factor = factor.clamp(0.0, 1.0);
        let between = |from: f64, to: f64| if factor == 1.0 { to } else { from + (to - from) * factor };
        Self {
            quantity: other.quantity.clone(),
            low: between(self.low, other.low),
            high: between(self.high, other.high),
        }
    }

    /// Its ticks across `length` points: as many as have room beside each other.
    pub fn ticks_across(&self, length: f32, measure: &dyn Measure) -> Vec<Tick> {
        let widest = |ticks: &[Tick]| ticks.iter().map(|tick| width(&tick.label, measure)).fold(0.0, f32::max);
        let fits_with = |step: f64, least: f32, widths: f32| {
            let ticks = self.ticks(step);
            let apart = self.apart(step, length);
            (apart >= least.max(widths * widest(&ticks) + GAP)).then_some(ticks)
        };
        // A label at an end is moved inwards by half of its width.
        let fits = |step, least| fits_with(step, least, 1.5);
        let steps = || self.steps(length).filter(|&step| !self.is_long(step));
        let usual = steps().find_map(|step| Some((step, fits(step, ACROSS)?)));
        // A tick at the end is worth a little less room.
        let full = steps()
            .filter(|&step| self.ends_on(step))
            .find_map(|step| Some((step, fits(step, CLOSE_ACROSS)?)));
        match (usual, full) {
            (Some((step, ticks)), _) if self.ends_on(step) && ticks.len() >= ENOUGH => ticks,
            (_, Some((_, ticks))) => ticks,
            (Some((_, ticks)), None) if ticks.len() > 1 => ticks,
            // Long labels.
            _ => self.steps(length).find_map(|step| fits_with(step, ACROSS, 1.0)).unwrap_or_default(),
        }
    }

    /// Its ticks over `length` points of height.
    pub fn ticks_down(&self, length: f32) -> Vec<Tick> {
        let fits = |step: &f64| self.apart(*step, length) >= DOWN;
        let full = self.steps(length).filter(fits).find(|&step| self.ends_on(step));
        let any = self.steps(length).find(fits);
        let step = match (any, full) {
            // A tick at the end is worth a coarser step, but not one that leaves nothing between the ends.
            (Some(any), Some(full)) if full <= 1.5 * any => Some(full),
            (any, _) => any,
        };
        step.map(|step| self.ticks(step)).unwrap_or_default()
    }

    /// The power of ten that stands in the title; 0 where the numbers are written out.
    fn exponent(&self) -> i32 {
        let largest = self.low.abs().max(self.high.abs());
        if (SMALL..LARGE).contains(&largest) { 0 } else { power_of(largest) }
    }

    /// How far ticks `step` apart are, points.
    fn apart(&self, step: f64, length: f32) -> f32 {
        length * to_f32(step / (self.high - self.low))
    }

    /// Whether labels would have one more decimal than those of other steps as large: 0.025, but not 25.
    fn is_long(&self, step: f64) -> bool {
        let decimals = |step| decimals_of(times_power(step, -self.exponent()));
        decimals(step) > decimals(power_of_ten(power_of(step)))
    }

    /// Whether there is a tick at its end.
    fn ends_on(&self, step: f64) -> bool {
        let steps = self.high / step;
        (steps - steps.round()).abs() < 1e-6
    }

    /// Round steps, the smallest first, of which none puts ticks closer than a few points.
    fn steps(&self, length: f32) -> impl Iterator<Item = f64> {
        let least = (self.high - self.low) * 10.0 / f64::from(length.max(1.0));
        let power = power_of(least);
        (0..5)
            .flat_map(move |more| STEPS.map(|digit| digit * power_of_ten(power + more)))
            .filter(move |&step| step >= least && step.is_normal())
    }

    /// The multiples of `step` on the axis, their labels with the same number of decimals.
    fn ticks(&self, step: f64) -> Vec<Tick> {
        // More cannot be told apart.
        const MOST: u32 = 200;
        let exponent = self.exponent();
        let scaled = |value: f64| times_power(value, -exponent);
        let decimals = decimals_of(scaled(step));
        let first = (self.low / step - 1e-6).ceil();
        (0..MOST)
            .map(|count| (first + f64::from(count)) * step)
            .take_while(|&value| value <= self.high + 1e-6 * step)
            .map(|value| Tick {
                value,
                label: label(scaled(value), decimals),
            })
            .collect()
    }
}

/// The label of a tick: 0 without decimals, as it is no measurement.
fn label(value: f64, decimals: usize) -> String {
    if value == 0.0 {
        "0".to_owned()
    } else {
        with_minus(&grouped(format!("{value:.decimals$}")))
    }
}

/// The whole part in groups of three digits, as values have it, where that has more than four.
fn grouped(number: String) -> String {
    let whole = number.trim_start_matches('-').split('.').next().map_or(0, str::len);
    // An axis has no more than five digits before the point.
    if whole == 5 {
        let at = number.find('.').unwrap_or(number.len()) - 3;
        format!(
            "{}\u{2009}{}",
            number.get(..at).unwrap_or_default(),
            number.get(at..).unwrap_or_default()
        )
    } else {
        number
    }
}

/// The width of a label.
pub(crate) fn width(label: &str, measure: &dyn Measure) -> f32 {
    measure.width(&Words::new(label, Ink::Muted), LABEL_SIZE)
}

/// The decimals that a multiple of `step` needs.
fn decimals_of(step: f64) -> usize {
    const MOST: usize = 12;
    let is_whole = |decimals: &usize| {
        let scaled = step * power_of_ten(i32::try_from(*decimals).unwrap_or(0));
        (scaled - scaled.round()).abs() < 1e-6 * scaled.abs().max(1e-3) && scaled >= 0.5
    };
    (0..MOST).find(is_whole).unwrap_or(MOST)
}

/// The next round number that is not below `value` (positive).
pub(crate) fn round_up(value: f64) -> f64 {
    let power = power_of(value);
    ENDS.into_iter()
        .map(|digit| times_power(digit, power))
        .find(|&end| end >= value * (1.0 - 1e-12))
        .unwrap_or(value)
}

/// The power of ten of the first digit of `value`.
fn power_of(value: f64) -> i32 {
    let text = format!("{value:e}");
    text.split_once('e').and_then(|(_, power)| power.parse().ok()).unwrap_or(0)
}

fn power_of_ten(power: i32) -> f64 {
    times_power(1.0, power)
}

/// `value` times a power of ten, rounded once: 3 · 0.1 would have a remainder.
fn times_power(value: f64, power: i32) -> f64 {
    format!("{value:e}")
        .split_once('e')
        .and_then(|(digits, own)| format!("{digits}e{}", own.parse::<i32>().ok()? + power).parse().ok())
        .unwrap_or(value)
}

/// A power as it stands behind a 10.
fn raised(power: i32) -> String {
    let raise = |c: char| match c {
        '-' => '⁻',
        c => c
            .to_digit(10)
            .and_then(|digit| "⁰¹²³⁴⁵⁶⁷⁸⁹".chars().nth(usize::try_from(digit).ok()?))
            .unwrap_or(c),
    };
    power.to_string().chars().map(raise).collect()
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::*;
    use crate::InterWidths;

    fn distance(low: f64, high: f64) -> Axis {
        Axis::between(Quantity::distance("m"), low, high).unwrap()
    }

    fn labels(ticks: &[Tick]) -> Vec<&str> {
        ticks.iter().map(|tick| tick.label.as_str()).collect()
    }

    #[test]
    fn all_ticks_of_an_axis_have_the_same_decimals_but_zero_has_none() {
        let around = distance(1.28, 1.52).ticks_across(368.0, &InterWidths);
        assert_eq!(labels(&around), ["1.30", "1.35", "1.40", "1.45", "1.50"]);
        let halves = distance(0.0, 2.0).ticks_across(300.0, &InterWidths);
        assert_eq!(labels(&halves), ["0", "0.5", "1.0", "1.5", "2.0"]);
        let quarters = distance(0.0, 100.0).ticks_across(308.0, &InterWidths);
        assert_eq!(labels(&quarters), ["0", "25", "50", "75", "100"]);
        assert_eq!(labels(&distance(0.0, 4.0).ticks_down(158.0)), ["0", "1", "2", "3", "4"]);
    }

    #[test]
    fn a_power_of_ten_stands_in_the_title_and_in_no_tick() {
        let far = distance(0.0, 4e6);
        assert_eq!(far.title(), "Distance D (10⁶ m)");
        assert_eq!(labels(&far.ticks_down(158.0)), ["0", "1", "2", "3", "4"]);
        let near = distance(0.0, 2.5e-6);
        assert_eq!(near.title(), "Distance D (10⁻⁶ m)");
        assert_eq!(labels(&near.ticks_down(200.0)), ["0", "0.5", "1.0", "1.5", "2.0", "2.5"]);
        assert_eq!(distance(0.0, 99_000.0).title(), "Distance D (m)");
        assert_eq!(distance(-2.0, 2.0).ticks_down(120.0).first().unwrap().label, "−2");
    }

    #[test]
    fn ticks_have_room_beside_each_other_and_there_are_at_least_two() {
        for width in [240.0, 268.0, 320.0, 368.0, 560.0, 900.0] {
            for power in [-300, -30, -6, -3, -1, 0, 1, 2, 4, 5, 7, 30, 300] {
                for (low, high) in [
                    (0.0, 1.0),
                    (0.0, 4.7),
                    (0.0, 9.9),
                    (1.28, 1.52),
                    (7.001, 7.004),
                    (1.399_99, 1.400_01),
                ] {
                    let scale = power_of_ten(power);
                    let axis = distance(low * scale, high * scale);
                    let ticks = axis.ticks_across(width, &InterWidths);
                    assert!(ticks.len() >= 2, "{low}…{high} × 10^{power} on {width}: {ticks:?}");
                    for pair in ticks.windows(2) {
                        let [left, right] = pair else { continue };
                        let apart = axis.position(right.value, 0.0, width) - axis.position(left.value, 0.0, width);
                        let half = |tick: &Tick| super::width(&tick.label, &InterWidths) / 2.0;
                        assert!(apart > half(left) + half(right) + 4.0, "{ticks:?} on {width}");
                        assert_ne!(left.label, right.label);
                    }
                }
            }
        }
    }

    #[test]
    fn an_axis_from_zero_ends_on_the_next_round_number() {
        for (least, end) in [(100.0, 100.0), (3.5, 4.0), (15.6, 16.0), (0.011, 0.012), (3e300, 3e300)] {
            let axis = Axis::from_zero(Quantity::distance("m"), least).unwrap();
            assert_eq!(axis.high, end);
        }
        for least in [0.0, -1.0, f64::NAN, f64::INFINITY, 1.7e308] {
            assert_eq!(Axis::from_zero(Quantity::distance("m"), least), None);
        }
    }

    #[test]
    fn the_way_from_one_axis_to_another_ends_exactly_there() {
        let (from, to) = (distance(0.0, 4.0), distance(0.0, 0.3));
        assert_eq!(from.eased(&to, 0.0), from);
        assert_eq!(from.eased(&to, 1.0), to);
        assert!((from.eased(&to, 0.5).high - 2.15).abs() < 1e-12);
    }
}
