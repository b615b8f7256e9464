//! What a tip says about a place on the curve.

use super::model::{CurveModel, DIGITS, Kind};
use crate::axis::round_up;
use crate::numbers;
use crate::{Ink, Words};
use depth_core::problem::Field;
use depth_core::quantity::Length;
use depth_text::number::{Notation, with_minus};
use depth_text::style::Style;
use depth_text::unit::Unit;

impl CurveModel {
    /// The lines of a tip at `x`: the disparity, the distance, and what one pixel more or less makes of it.
    pub fn tip_at(&self, x: f64) -> Vec<Words> {
        lines(self, x)
    }
}

fn lines(model: &CurveModel, x: f64) -> Vec<Words> {
    let Some(estimate) = model.estimate_at(x) else { return Vec::new() };
    let [of_x, of_y] = match model.kind {
        Kind::Distance => ["d", "D"],
        Kind::Disparity => ["D", "d"],
    };
    let sigma = estimate.sigma.unwrap_or(0.0);
    let first = format!("{of_x} = {}", given(model, x));
    let second = format!("{of_y} = {}", found(model, estimate.value, sigma));
    let mut lines = vec![Words::new(first, Ink::Text), Words::strong(second, Ink::Text)];
    let step = step(model, x);
    for beside in [x - step, x + step] {
        if let Some(value) = model.value_at(beside).filter(|_| beside > 0.0) {
            let text = format!("{}: {}", plain_x(model, beside), found(model, value, 0.0));
            lines.push(Words::new(text, Ink::Muted));
        }
    }
    lines
}

/// To the next value that is worth telling: one pixel, or about a tenth of the distance.
pub(super) fn step(model: &CurveModel, x: f64) -> f64 {
    match model.kind {
        Kind::Distance => 1.0,
        Kind::Disparity => tenth(x),
    }
}

/// What the horizontal axis counts with its σ, as a person would type it: "(50 ± 0.5) px".
fn given(model: &CurveModel, x: f64) -> String {
    let at_point = model.point.as_ref().filter(|point| point.x == x);
    let sigma = match model.kind {
        Kind::Distance => model.problem.sigma(Field::Disparity),
        Kind::Disparity => at_point.map_or(0.0, |point| point.x_sigma),
    };
    let number = match (model.kind, at_point) {
        (Kind::Disparity, Some(point)) => point.x_text.clone(),
        (Kind::Distance, _) => typed(x - model.doffs()),
        (Kind::Disparity, None) => typed(x),
    };
    let unit = unit_of_x(model);
    if sigma > 0.0 {
        format!("({number} ± {}) {unit}", typed(sigma))
    } else {
        format!("{number} {unit}")
    }
}

/// The same without σ: "49 px".
fn plain_x(model: &CurveModel, x: f64) -> String {
    let number = match model.kind {
        Kind::Distance => typed(x - model.doffs()),
        Kind::Disparity => like(typed(x), model.point.as_ref().map_or("", |point| &point.x_text)),
    };
    format!("{number} {}", unit_of_x(model))
}

/// `number` with at least the decimals of `other`, if neither has a power of ten: "1.3" beside "1.40" is "1.30".
fn like(number: String, other: &str) -> String {
    let decimals = |text: &str| text.split_once('.').map_or(0, |(_, decimals)| decimals.len());
    let (own, wanted) = (decimals(&number), decimals(other));
    if own >= wanted || number.contains('×') || other.contains('×') {
        return number;
    }
    let point = if own == 0 { "." } else { "" };
    format!("{number}{point}{}", "0".repeat(wanted - own))
}

fn typed(number: f64) -> String {
    with_minus(&Notation::SHORT.plain(number, DIGITS))
}

/// What the vertical axis counts, with its σ where that is above 0.
fn found(model: &CurveModel, value: f64, sigma: f64) -> String {
    match model.kind {
        Kind::Distance if sigma > 0.0 => numbers::bracketed(value, sigma, Unit::Length(model.unit)),
        Kind::Distance => numbers::plain_length(Length::new(value, model.unit), model.unit),
        Kind::Disparity if sigma > 0.0 => numbers::bracketed(value - model.doffs(), sigma, Unit::Pixel),
        Kind::Disparity => format!("{} px", with_minus(&Style::WINDOW.number(Some(value - model.doffs())))),
    }
}

fn unit_of_x(model: &CurveModel) -> &'static str {
    match model.kind {
        Kind::Distance => Unit::Pixel.symbol(),
        Kind::Disparity => model.unit.symbol(),
    }
}

/// A round number near `value`, for steps of a tip.
fn tenth(value: f64) -> f64 {
    round_up(value / 10.0 * 0.700_1).min(value / 2.0)
}
