//! What the top view shows, in meters, and what is written into it.

use crate::app::sentences::{Description, Hint, TopView};
use crate::core::problem::{Method, Origin, Solution};
use crate::core::quantity::{Length, LengthUnit};
use crate::core::setup::Object;
use depth_text::assess::Assessment;
use depth_text::field::Key;
use depth_text::names::Named as _;
use depth_text::style::Style;
use depth_text::{fields, report};

/// The scene in meters: x to the right, z away from the cameras, the middle of the cameras at the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Model {
    /// From the lens.
    pub(super) depth_m: f64,
    /// Where distances are counted from, in front of the lens.
    pub(super) zero_m: f64,
    /// Where the depth is from, if there are two distances.
    pub(super) origin: Option<Origin>,
    /// Two cameras this far apart, or one.
    pub(super) baseline_m: Option<f64>,
    /// The object's width, where it is known.
    pub(super) width_m: Option<f64>,
    /// The 1 σ interval of the depth, where it is known; without an upper bound its far end is absent.
    pub(super) interval_m: Option<(f64, Option<f64>)>,
    /// Whether it is seen from the side, as the cameras stand one above the other, or a height is measured.
    pub(super) is_from_side: bool,
}

impl Model {
    /// The scene at the [best](Solution::best) distance: with two cameras where there is a stereo distance, else with one.
    pub(super) fn new(solution: &Solution) -> Option<Self> {
        let problem = &solution.problem;
        let best = solution.best()?;
        let interval = solution.best_interval();
        let zero_m = problem.zero.map_or(0.0, Length::m);
        let from_lens = |length: Length| length.m() + zero_m;
        let interval_m = interval.map(|interval| (from_lens(interval.near), interval.far.map(from_lens)));
        let has_stereo = solution.stereo.distance().is_some();
        let is_from_side = problem.needs_fy(if has_stereo { Method::Stereo } else { Method::Monocular });
        let model = Self {
            depth_m: from_lens(best.distance.value),
            zero_m,
            origin: Some(best.origin).filter(|_| has_stereo && solution.monocular.distance().is_some()),
            baseline_m: problem.baseline.filter(|_| has_stereo).map(|baseline| baseline.value.m()),
            width_m: problem
                .foreshortened_width()
                .filter(|_| (problem.object == Object::Height) == is_from_side)
                .map(|width| width.value.m()),
            is_from_side,
            interval_m,
        };
        // Painting is done in f32, so lengths beyond its range are not drawn.
        let drawable = |length: f64| (1e-30..1e30).contains(&length);
        [Some(model.depth_m), model.baseline_m, model.width_m]
            .into_iter()
            .flatten()
            .all(drawable)
            .then_some(model)
    }

    /// A depth from the lens as it is counted.
    const fn counted(&self, depth_m: f64) -> Length {
        Length::from_m(depth_m - self.zero_m)
    }

    pub(super) const fn remark(&self) -> Hint {
        match self.baseline_m {
            _ if self.is_from_side => Hint::FromTheSide,
            Some(_) => Hint::ObjectMidway,
            None => Hint::ObjectAhead,
        }
    }

    pub(super) fn description<'a>(&self, words: &'a Words) -> Description<'a> {
        Description::TopView(TopView {
            baseline: words.baseline.as_deref(),
            distance: &words.distance,
            origin: self.origin,
            interval: self
                .interval_m
                .map(|(near, far)| (self.counted(near), far.map(|far| self.counted(far)))),
            is_from_side: self.is_from_side,
            width: words.width.as_deref(),
            unit: words.unit,
        })
    }
}

/// What is written into the picture: what was typed as it was typed, and the distance in the unit of the results.
pub(super) struct Words {
    /// Beside the object.
    pub(super) object: String,
    pub(super) distance: String,
    pub(super) baseline: Option<String>,
    pub(super) width: Option<String>,
    pub(super) unit: LengthUnit,
}

impl Words {
    pub(super) fn new(assessment: &Assessment, model: &Model, unit: LengthUnit) -> Self {
        let typed = |key: Key, meters: Option<f64>| {
            let reading = assessment.reading(key).filter(|_| !assessment.is_solved_for(key));
            let computed = report::length(meters.map(Length::from_m), unit);
            meters.map(|_| reading.map_or(computed, |reading| Style::WINDOW.typed(reading)))
        };
        let distance = report::length(Some(model.counted(model.depth_m)), unit);
        Self {
            object: match model.origin {
                Some(Origin::Combined) => format!("combined {distance}"),
                Some(Origin::Method(method)) => format!("{} {distance}", method.name().to_lowercase()),
                None => format!("object {distance}"),
            },
            distance,
            baseline: typed(fields::BASELINE, model.baseline_m),
            width: typed(fields::REAL_WIDTH, model.width_m),
            unit,
        }
    }
}
