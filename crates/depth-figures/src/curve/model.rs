//! What a curve shows.

use crate::axis::{Axis, Quantity};
use crate::sources::as_typed;
use crate::spans::{Estimate, Span, with_sigmas_doubled};
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Problem, Solution};
use depth_core::quantity::{Length, LengthUnit, Pixels};
use depth_text::assess::Assessment;
use depth_text::fields;
use depth_text::number::{self, Notation};
use depth_text::style::Style;
use depth_text::unit::Unit;

/// How much farther than the point the horizontal axis goes.
const ACROSS: f64 = 1.8;
/// How much farther than the point the vertical axis goes.
const UP: f64 = 2.5;
/// A monocular distance up to so many times the stereo distance is taken onto the axis.
const NEAR: f64 = 4.0;

/// Digits of a number that may have been typed: more have no room on a chip.
pub(super) const DIGITS: usize = 6;

/// Which of the two plots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// The distance over the disparity.
    Distance,
    /// The disparity over the distance.
    Disparity,
}

/// Both axes of the plot.
#[derive(Clone, Debug, PartialEq)]
pub struct Axes {
    /// The horizontal one.
    pub x: Axis,
    /// The vertical one.
    pub y: Axis,
}

/// The monocular distance beside the curve.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Level {
    pub estimate: Estimate,
    /// "1.400 m".
    pub text: String,
    /// The disparity that belongs to it, where there is one.
    pub x: Option<f64>,
}

/// What the curve shows.
#[derive(Clone, Debug, PartialEq)]
pub struct CurveModel {
    /// Which of the two plots.
    pub kind: Kind,
    /// The current point, in the units of the axes; `None` where there is none.
    pub point: Option<CurvePoint>,
    /// Whether the point is what was, while an input cannot be used.
    pub is_stale: bool,
    pub(crate) problem: Problem,
    /// The same with every σ twice as large.
    doubled: Problem,
    pub(crate) unit: LengthUnit,
    /// σ of the distance that was given, as a part of it: what it would be at another one, nobody has said.
    given_relative: f64,
    pub(crate) level: Option<Level>,
    axes: Axes,
}

/// A point on the curve.
#[derive(Clone, Debug, PartialEq)]
pub struct CurvePoint {
    /// Where it is on the horizontal axis.
    pub x: f64,
    /// Its σ there, 0 for none.
    pub x_sigma: f64,
    /// What the chip on the horizontal axis says, "50". May be replaced by the number as it was typed.
    pub x_text: String,
    /// Where it is on the vertical axis, with its intervals.
    pub y: Estimate,
    /// What the chip on the vertical axis says, "1.400".
    pub y_text: String,
}

impl CurveModel {
    /// "Distance against disparity". Where there is no stereo distance, the point is that of `last`, the last solution that had one, in
    /// gray. `None` where no curve can be drawn.
    pub fn new(solution: &Solution, last: Option<&Solution>, unit: LengthUnit) -> Option<Self> {
        let has_point = |solution: &&Solution| solution.stereo.distance().is_some() && solution.problem.effective_disparity().is_some();
        let last = last.filter(has_point).filter(|_| !has_point(&solution));
        let drawn = last.unwrap_or(solution);
        let problem = stereo_only(&drawn.problem);
        let unit = drawn
            .stereo
            .distance()
            .map_or(unit, |distance| Style::WINDOW.unit_of(distance, unit));
        let point = distance_point(drawn, unit);
        let level = Estimate::distance(solution, Method::Monocular, unit).and_then(|estimate| {
            let distance = solution.monocular.distance()?;
            let sigma = solution
                .uncertainty(Method::Monocular)
                .map_or(Length::from_m(0.0), |known| known.sigma);
            Some(Level {
                x: disparity_of(&problem, Measured::exact(distance)).map(|disparity| disparity.value),
                text: Style::WINDOW.length_like(distance, Measured::new(distance, sigma), unit),
                estimate,
            })
        });
        let (low, high) = Field::Disparity.usual_range();
        let at = point.as_ref().map(|point| point.x);
        let center = at.or(level.as_ref().and_then(|level| level.x)).unwrap_or((low * high).sqrt());
        let distance = problem.depth_at(Pixels::new(center))?.in_unit(unit);
        let level_end = level
            .as_ref()
            .map(|level| level.estimate.value)
            .filter(|&level| level <= NEAR * distance)
            .map_or(0.0, |level| 1.25 * level);
        let has_doffs = problem.get(Field::Doffs).is_some();
        Some(Self {
            kind: Kind::Distance,
            axes: Axes {
                x: Axis::from_zero(Quantity::disparity(has_doffs), ACROSS * center)?,
                y: Axis::from_zero(Quantity::distance(unit.symbol()), level_end.max(UP * distance))?,
            },
            doubled: with_sigmas_doubled(&problem),
            given_relative: 0.0,
            is_stale: last.is_some(),
            point,
            problem,
            unit,
            level,
        })
    }

    /// "Disparity against distance": the disparity that belongs to `distance`, of the pair of cameras in `problem`. `None` where there
    /// is none.
    pub fn inverse(problem: &Problem, distance: Measured<Length>, unit: LengthUnit) -> Option<Self> {
        let problem = stereo_only(problem);
        let unit = Style::WINDOW.unit_of(distance.value, unit);
        let disparity = disparity_of(&problem, distance)?;
        let x = distance.value.in_unit(unit);
        let point = CurvePoint {
            x,
            x_sigma: distance.sigma.in_unit(unit),
            x_text: number::with_minus(&Notation::SHORT.plain(x, DIGITS)),
            y: Estimate::symmetric(disparity.value, disparity.sigma),
            y_text: number::with_minus(&with_sigma(disparity.value, disparity.sigma)),
        };
        let has_doffs = problem.get(Field::Doffs).is_some();
        Some(Self {
            kind: Kind::Disparity,
            axes: Axes {
                x: Axis::from_zero(Quantity::distance(unit.symbol()), UP * x)?,
                y: Axis::from_zero(Quantity::disparity(has_doffs), ACROSS * disparity.value)?,
            },
            doubled: with_sigmas_doubled(&problem),
            given_relative: distance.relative(),
            is_stale: false,
            point: Some(point),
            level: None,
            problem,
            unit,
        })
    }

    /// [`inverse`](Self::inverse) of what was assessed, with the distance as it was typed; `None` unless the disparity was solved for.
    pub fn inverse_of(assessment: &Assessment, unit: LengthUnit) -> Option<Self> {
        let unknown = assessment.unknown.as_ref()?;
        if (unknown.method, unknown.field) != (Method::Stereo, Field::Disparity) {
            return None;
        }
        let mut model = Self::inverse(&as_typed(assessment), unknown.distance?, unit)?;
        let typed = assessment.reading(fields::DISTANCE);
        if let (Some(typed), Some(point)) = (typed, &mut model.point)
            && typed.unit == Some(Unit::Length(model.unit))
        {
            point.x_text = number::with_minus(&typed.number_text);
        }
        Some(model)
    }

    /// The axes that show the point with room around it. A window keeps those from the start of a drag, and [eases](Axes::eased) to
    /// these when it ends.
    pub const fn axes(&self) -> &Axes {
        &self.axes
    }

    /// The caption: "band: ± 2 σ", "last valid: d = 50 px", or nothing.
    pub fn caption(&self) -> String {
        match &self.point {
            Some(point) if self.is_stale => {
                let typed = point.x - self.doffs();
                format!("last valid: d = {} px", number::with_minus(&Notation::SHORT.plain(typed, DIGITS)))
            }
            Some(point) if point.y.sigma.is_some() => "band: ± 2 σ".to_owned(),
            _ => String::new(),
        }
    }

    /// What of every disparity on the axis is doffs, px.
    pub fn doffs(&self) -> f64 {
        self.problem.offset().value.px()
    }

    /// The value on the curve at `x`; `None` where there is none.
    pub(crate) fn value_at(&self, x: f64) -> Option<f64> {
        match self.kind {
            Kind::Distance => Some(self.problem.depth_at(Pixels::new(x))?.in_unit(self.unit)),
            Kind::Disparity => {
                let distance = Measured::exact(Length::new(x, self.unit));
                Some(disparity_of(&self.problem, distance)?.value)
            }
        }
    }

    /// The value at `x` with the intervals that it would have there, each input as sure as it is.
    pub(crate) fn estimate_at(&self, x: f64) -> Option<Estimate> {
        match self.kind {
            Kind::Distance => {
                let solution = at_disparity(&self.problem, x).solve();
                Estimate::distance(&solution, Method::Stereo, self.unit)
            }
            Kind::Disparity => {
                let meters = Length::new(x, self.unit).m();
                let distance = Measured::from_base(meters, meters * self.given_relative);
                let disparity = disparity_of(&self.problem, distance)?;
                Some(Estimate::symmetric(disparity.value, disparity.sigma))
            }
        }
    }

    /// The interval of 2 σ at `x`, without what else an estimate has; `None` without σ.
    pub(crate) fn band_at(&self, x: f64) -> Option<Span> {
        match self.kind {
            Kind::Distance => {
                let solution = at_disparity(&self.doubled, x).solve();
                solution.stereo.distance()?;
                match solution.uncertainty(Method::Stereo) {
                    Some(known) => Some(Span::of(known.interval, self.unit)),
                    // Twice σ is out of all proportion.
                    None => solution.unusable_sigma.map(|_| Span { low: 0.0, high: None }),
                }
            }
            Kind::Disparity => self.estimate_at(x)?.two(),
        }
    }
}

impl Axes {
    /// The axes on the way from these to `other`: these at 0, the others at 1.
    #[must_use]
    pub fn eased(&self, other: &Self, factor: f64) -> Self {
        Self {
            x: self.x.eased(&other.x, factor),
            y: self.y.eased(&other.y, factor),
        }
    }
}

/// `problem` without what belongs to the other method.
fn stereo_only(problem: &Problem) -> Problem {
    Problem {
        image_width: None,
        real_width: None,
        ..*problem
    }
}

/// `problem` with a disparity that is `effective` with doffs in it, its σ as it is.
fn at_disparity(problem: &Problem, effective: f64) -> Problem {
    let mut moved = *problem;
    moved.set(Field::Disparity, Some(effective - problem.offset().value.px()));
    moved
}

/// The disparity that belongs to `distance`, with doffs in it, px.
fn disparity_of(problem: &Problem, distance: Measured<Length>) -> Option<Measured<f64>> {
    let without = Problem {
        disparity: None,
        ..*problem
    };
    let found = without.solve_for(Method::Stereo, Field::Disparity, distance).ok()??.to_base();
    let effective = found.value + problem.offset().value.px();
    (effective.is_normal() && effective > 0.0).then_some(Measured::new(effective, found.sigma))
}

fn distance_point(solution: &Solution, unit: LengthUnit) -> Option<CurvePoint> {
    let y = Estimate::distance(solution, Method::Stereo, unit)?;
    let problem = &solution.problem;
    let x = problem.effective_disparity()?.px();
    let sigmas = [problem.sigma(Field::Disparity), problem.sigma(Field::Doffs)];
    Some(CurvePoint {
        x,
        x_sigma: sigmas.iter().map(|sigma| sigma * sigma).sum::<f64>().sqrt(),
        x_text: number::with_minus(&Notation::SHORT.plain(x, DIGITS)),
        y_text: number::with_minus(&with_sigma(y.value, y.sigma.unwrap_or(0.0))),
        y,
    })
}

/// The number alone, to two digits of its σ.
fn with_sigma(value: f64, sigma: f64) -> String {
    if sigma > 0.0 {
        let written = Style::WINDOW.with_sigma(value, sigma);
        format!("{}{}", written.value, written.power)
    } else {
        Style::WINDOW.number(Some(value))
    }
}
