//! [`Measured`]: a value with its standard uncertainty.

use crate::arithmetic::{root_sum_of_squares, times_over};
use crate::quantity::Quantity;

/// A value with its standard uncertainty (1 σ), 0 where none was given.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Measured<Q> {
    /// The value.
    pub value: Q,
    /// Its standard deviation; 0 where none was given.
    pub sigma: Q,
}

impl<Q: Quantity> Measured<Q> {
    /// A value with its standard deviation.
    ///
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::quantity::Pixels;
    ///
    /// let d = Measured::new(Pixels::new(50.0), Pixels::new(0.5));
    /// assert_eq!(d.sigma.px(), 0.5);
    /// ```
    pub const fn new(value: Q, sigma: Q) -> Self {
        Self { value, sigma }
    }

    /// A value taken to be exact.
    ///
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::quantity::Length;
    ///
    /// assert_eq!(Measured::exact(Length::from_m(0.1)).sigma.m(), 0.0);
    /// ```
    pub const fn exact(value: Q) -> Self {
        Self { value, sigma: Q::ZERO }
    }

    /// A value with its standard deviation, both in the base unit of the quantity (meters, pixels, radians).
    ///
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::quantity::Length;
    ///
    /// let b: Measured<Length> = Measured::from_base(0.1, 0.0005);
    /// assert_eq!(b.value, Length::from_m(0.1));
    /// ```
    pub fn from_base(value: f64, sigma: f64) -> Self {
        Self {
            value: Q::from_base(value),
            sigma: Q::from_base(sigma),
        }
    }

    /// The two numbers, in the base unit of the quantity.
    ///
    /// ```
    /// use depth_core::measured::Measured;
    /// use depth_core::quantity::{Length, LengthUnit};
    ///
    /// let b = Measured::exact(Length::new(100.0, LengthUnit::Millimeter));
    /// assert_eq!(b.to_base(), Measured::new(0.1, 0.0));
    /// ```
    pub fn to_base(self) -> Measured<f64> {
        Measured {
            value: self.value.to_base(),
            sigma: self.sigma.to_base(),
        }
    }

    /// σ as a fraction of the value: 0 for an exact value, and never more than [`f64::MAX`] (which stands for a σ beside
    /// a value of 0).
    ///
    /// ```
    /// use depth_core::measured::Measured;
    ///
    /// assert_eq!(Measured::new(50.0, 0.5).relative(), 0.01);
    /// ```
    pub fn relative(self) -> f64 {
        let Measured { value, sigma } = self.to_base();
        if sigma == 0.0 { 0.0 } else { (sigma / value.abs()).min(f64::MAX) }
    }

    /// The sum of two independent quantities. Both parts of the result may overflow to infinity.
    pub(crate) fn plus(self, other: Self) -> Self {
        let (a, b) = (self.to_base(), other.to_base());
        Self::from_base(a.value + b.value, root_sum_of_squares(&[a.sigma, b.sigma]))
    }

    /// The difference of two independent quantities. Both parts of the result may overflow to infinity.
    pub(crate) fn minus(self, other: Self) -> Self {
        self.plus(Self {
            value: Q::from_base(-other.value.to_base()),
            sigma: other.sigma,
        })
    }
}

impl Measured<f64> {
    /// Value − σ and value + σ.
    ///
    /// ```
    /// use depth_core::measured::Measured;
    ///
    /// assert_eq!(Measured::new(50.0, 0.5).ends(), [49.5, 50.5]);
    /// ```
    pub fn ends(self) -> [f64; 2] {
        [self.value - self.sigma, self.value + self.sigma]
    }
}

/// a·b/c of three independent positive quantities, its σ to first order; `None` where either is too large to be represented
/// or the value too small. The units are the caller's: those of a and b over that of c must be that of the result.
///
/// Source: JCGM 100:2008 (GUM), 5.1.6: for a product of powers ±1 the relative variances add.
pub(crate) fn measured_times_over<A: Quantity, B: Quantity, C: Quantity, R: Quantity>(
    a: Measured<A>,
    b: Measured<B>,
    c: Measured<C>,
) -> Option<Measured<R>> {
    let value = times_over(a.value.to_base(), b.value.to_base(), c.value.to_base());
    let sigma = value * root_sum_of_squares(&[a.relative(), b.relative(), c.relative()]);
    (value.is_normal() && sigma.is_finite()).then(|| Measured::from_base(value, sigma))
}
