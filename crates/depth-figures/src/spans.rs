//! Estimates with the intervals around them.

use depth_core::problem::{Field, Method, Problem, Solution};
use depth_core::quantity::{Length, LengthUnit};
use depth_core::uncertainty::Interval;

/// An interval on an axis, in the unit of the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Span {
    /// Its lower end.
    pub low: f64,
    /// Its upper end; `None` where there is no upper bound.
    pub high: Option<f64>,
}

/// A value, its σ and the intervals around it, in the unit of the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Estimate {
    /// The value.
    pub value: f64,
    /// Its σ to first order; `None` where it has none, and then there are no intervals.
    pub sigma: Option<f64>,
    /// The interval of 1 σ and that of 2 σ.
    pub intervals: Option<[Span; 2]>,
}

impl Span {
    /// An interval of lengths, in `unit`.
    pub(crate) fn of(interval: Interval, unit: LengthUnit) -> Self {
        Self {
            low: interval.near.in_unit(unit),
            high: interval.far.map(|far| far.in_unit(unit)),
        }
    }

    /// From `value` − `half` to `value` + `half`.
    pub(crate) fn around(value: f64, half: f64) -> Self {
        Self {
            low: value - half,
            high: Some(value + half),
        }
    }
}

impl Estimate {
    /// A value whose intervals are symmetric; without any where `sigma` is 0.
    pub(crate) fn symmetric(value: f64, sigma: f64) -> Self {
        let known = (sigma > 0.0).then_some(sigma);
        Self {
            value,
            sigma: known,
            intervals: known.map(|sigma| [1.0, 2.0].map(|times| Span::around(value, times * sigma))),
        }
    }

    /// The distance of `method` with the exact intervals of the core; `None` where there is no distance.
    pub(crate) fn distance(solution: &Solution, method: Method, unit: LengthUnit) -> Option<Self> {
        let value = solution.outcome(method).distance()?.in_unit(unit);
        let known = solution.uncertainty(method);
        let intervals = known.map(|known| {
            let twice = two_sigma(&solution.problem, method).unwrap_or(Interval {
                near: Length::from_m(0.0),
                far: None,
            });
            [known.interval, twice].map(|interval| Span::of(interval, unit))
        });
        Some(Self {
            value,
            sigma: known.map(|known| known.sigma.in_unit(unit)),
            intervals,
        })
    }

    /// Both distances combined, of which only the first order is known; `None` where they are not.
    pub(crate) fn combined(solution: &Solution, unit: LengthUnit) -> Option<Self> {
        let combined = solution.combined?;
        let mut estimate = Self::symmetric(combined.value.in_unit(unit), combined.sigma.in_unit(unit));
        for span in estimate.intervals.iter_mut().flatten() {
            span.low = span.low.max(0.0);
        }
        Some(estimate)
    }

    /// The interval of 1 σ.
    pub(crate) fn one(&self) -> Option<Span> {
        self.intervals.map(|[one, _]| one)
    }

    /// The interval of 2 σ.
    pub(crate) fn two(&self) -> Option<Span> {
        self.intervals.map(|[_, two]| two)
    }
}

/// The exact interval of 2 σ: that of 1 σ with every σ twice as large. `None` where nothing can be said.
pub(crate) fn two_sigma(problem: &Problem, method: Method) -> Option<Interval> {
    Some(with_sigmas_doubled(problem).solve().uncertainty(method)?.interval)
}

/// `problem` with every σ twice as large.
pub(crate) fn with_sigmas_doubled(problem: &Problem) -> Problem {
    let mut doubled = *problem;
    for field in Field::ALL {
        doubled.set_sigma(field, 2.0 * problem.sigma(field));
    }
    doubled
}
