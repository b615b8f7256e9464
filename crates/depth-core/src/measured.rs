//! [`Measured`]: a value with its standard uncertainty.

use crate::quantity::times_over;

/// A value with its standard uncertainty (1 σ, same unit), 0 where none was given.
///
/// The unit is the base unit of the quantity: pixels, metres or radians.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measured {
    /// The value.
    pub value: f64,
    /// Its standard deviation; 0 where none was given.
    pub sigma: f64,
}

impl Measured {
    /// A value with its standard deviation, both in the base unit.
    pub const fn new(value: f64, sigma: f64) -> Self {
        Self { value, sigma }
    }

    /// A value taken to be exact.
    pub const fn exact(value: f64) -> Self {
        Self { value, sigma: 0.0 }
    }

    /// σ as a fraction of the value: 0 for an exact value, and never more than [`f64::MAX`] (which stands for a σ beside
    /// a value of 0).
    pub fn relative(self) -> f64 {
        if self.sigma == 0.0 {
            0.0
        } else {
            (self.sigma / self.value.abs()).min(f64::MAX)
        }
    }

    /// The sum of two independent quantities. Both parts of the result may overflow to infinity.
    pub(crate) fn plus(self, other: Self) -> Self {
        Self {
            value: self.value + other.value,
            sigma: root_sum_of_squares(&[self.sigma, other.sigma]),
        }
    }

    /// a·b/c of three independent positive quantities, its σ to first order; `None` where either is too large to be
    /// represented or the value too small.
    ///
    /// Source: JCGM 100:2008 (GUM), 5.1.6: for a product of powers ±1 the relative variances add.
    pub(crate) fn times_over(a: Self, b: Self, c: Self) -> Option<Self> {
        let value = times_over(a.value, b.value, c.value);
        let sigma = value * root_sum_of_squares(&[a.relative(), b.relative(), c.relative()]);
        (value.is_normal() && sigma.is_finite()).then_some(Self { value, sigma })
    }

    /// Whether the two numbers can be a value and its standard deviation at all.
    pub(crate) fn is_possible(self) -> bool {
        self.value.is_finite() && self.sigma.is_finite() && self.sigma >= 0.0
    }

    /// Whether this can be a length or a focal length: [possible](Self::is_possible), positive and normal.
    pub(crate) fn is_positive(self) -> bool {
        self.is_possible() && self.value.is_normal() && self.value > 0.0
    }
}

/// √(Σ x²) without overflow or underflow on the way.
///
/// Only additions, multiplications, divisions and a square root, which are the same on every platform;
/// [`f64::hypot`] is not.
pub(crate) fn root_sum_of_squares(terms: &[f64]) -> f64 {
    let largest = terms.iter().fold(0.0_f64, |largest, term| largest.max(term.abs()));
    if largest == 0.0 || largest.is_infinite() {
        return largest;
    }
    let sum: f64 = terms.iter().map(|term| (term / largest) * (term / largest)).sum();
    largest * sum.sqrt()
}
