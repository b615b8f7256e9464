//! Numbers as these pictures write them. One place, so that they can follow when the rest of the program writes them in another way.

use depth_core::measured::Measured;
use depth_core::quantity::{Length, LengthUnit};
use depth_text::number::{Notation, magnitude, with_minus};
use depth_text::style::{NO_UPPER_BOUND, Style, WithSigma};
use depth_text::unit::Unit;

use crate::spans::Span;

/// "(1.400 ± 0.016) m", "(1.400 ± 0.016) × 10⁻¹¹ m".
pub(crate) fn bracketed(value: f64, sigma: f64, unit: Unit) -> String {
    let WithSigma { value, sigma, power } = Style::WINDOW.with_sigma(value, sigma);
    with_minus(&format!("({value} ± {sigma}){power} {}", unit.symbol()))
}

/// A length with its σ where it has one: "(1.400 ± 0.016) m", "1.400 m".
pub(crate) fn length(length: Measured<Length>, unit: LengthUnit) -> String {
    let unit = Style::WINDOW.unit_of(length.value, unit);
    if length.sigma.m() > 0.0 {
        bracketed(length.value.in_unit(unit), length.sigma.in_unit(unit), Unit::Length(unit))
    } else {
        plain_length(length.value, unit)
    }
}

/// A length without σ: "1.400 m".
pub(crate) fn plain_length(length: Length, unit: LengthUnit) -> String {
    with_minus(&Style::WINDOW.length(Some(length), unit))
}

/// "± 0.016 m".
pub(crate) fn sigma(value: f64, sigma: f64, unit: Unit) -> String {
    if sigma == 0.0 {
        return format!("± 0 {}", unit.symbol());
    }
    let WithSigma { sigma, power, .. } = Style::WINDOW.with_sigma(value, sigma);
    format!("± {sigma}{power} {}", unit.symbol())
}

/// "1.384…1.416 m", to two digits of `sigma`.
pub(crate) fn span(span: Span, value: f64, sigma: f64, unit: Unit) -> String {
    let decimals = decimals_beside(value, sigma);
    let write = |end: f64| with_minus(&Notation::SHORT.to_decimals(end, decimals));
    let near = write(span.low);
    match span.high {
        Some(high) => format!("{near}…{} {}", write(high), unit.symbol()),
        None => format!("{near} {}…{NO_UPPER_BOUND}", unit.symbol()),
    }
}

/// The decimals that show two digits of `sigma`, and at least two of `value`.
pub(crate) fn decimals_beside(value: f64, sigma: f64) -> i32 {
    let of_sigma = if sigma > 0.0 { 1 - magnitude(sigma) } else { i32::MIN };
    of_sigma.max(1 - magnitude(value)).min(11 - magnitude(value))
}

/// A position, which needs no more than an `f32` has.
#[expect(clippy::cast_possible_truncation, reason = "a position in a picture needs no more than an f32")]
pub(crate) const fn to_f32(number: f64) -> f32 {
    number as f32
}
