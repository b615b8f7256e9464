//! What an uncertainty comes from.

use crate::axis::Quantity;
use crate::{Ink, Words};
use depth_core::in_image::InImage;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Problem, Solved as Found};
use depth_core::quantity::{Length, LengthUnit};
use depth_core::uncertainty::Uncertainty;
use depth_text::assess::{Assessment, Unknown};
use depth_text::field::Key;
use depth_text::fields;
use depth_text::style::Style;
use depth_text::unit::Unit;

/// A source of uncertainty.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    /// Its symbol in the color of its method: "d".
    pub symbol: Words,
    /// Its name with the symbol: "Disparity d".
    pub name: Words,
    /// Its part of the variance, 0 to 1.
    pub share: f64,
}

/// A value and what its uncertainty comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Solved {
    /// What it is called in a heading: "Disparity".
    pub name: String,
    /// What an axis of it counts: "Disparity d" in px.
    pub quantity: Quantity,
    /// Its unit; what [`value`](Self::value) and [`sigma`](Self::sigma) count.
    pub unit: Unit,
    /// The value.
    pub value: f64,
    /// Its σ, above 0.
    pub sigma: f64,
    /// Whose inputs they are; `None` for both.
    pub method: Option<Method>,
    /// What σ comes from; the shares add to 1.
    pub sources: Vec<Source>,
}

impl Source {
    /// The input `key` with its share.
    pub fn new(key: Key, share: f64) -> Self {
        let ink = match key.input {
            Some(Field::Baseline | Field::Disparity | Field::Doffs) => Ink::Stereo,
            Some(Field::ImageWidth | Field::RealWidth | Field::Tilt) => Ink::MonocularText,
            _ => Ink::Text,
        };
        let name = key.label;
        Self {
            symbol: Words::symbol(key.symbol, ink),
            name: Words::new(format!("{name} "), Ink::Text).then_symbol(key.symbol, ink, false),
            share,
        }
    }

    /// What `uncertainty` comes from, as `assessment` words it.
    pub(crate) fn all(assessment: &Assessment, uncertainty: &Uncertainty) -> Vec<Self> {
        let shares = uncertainty.budget.iter();
        shares
            .map(|share| Self::new(assessment.worded(share.source), share.share))
            .collect()
    }
}

impl Solved {
    /// What was solved for, where it was not the distance, lengths in `unit`; `None` where nothing was found, or it has no σ.
    ///
    /// The share of an input is the square of the σ that it alone gives, over that of all.
    pub fn unknown(assessment: &Assessment, unit: LengthUnit) -> Option<Self> {
        let unknown = assessment.unknown.as_ref()?;
        let found = *unknown.outcome.as_ref().ok()?;
        let Measured { value, sigma } = found.to_base();
        let distance = unknown.distance?;
        let key = assessment.worded(unknown.field);
        let unit = match found {
            Found::Length(length) => Unit::Length(Style::WINDOW.unit_of(length.value, unit)),
            Found::InImage(InImage::OnSensor(_)) => Unit::Length(LengthUnit::Millimeter),
            Found::InImage(_) => Unit::Pixel,
        };
        let problem = &as_typed(assessment);
        let alone = |field| sigma_alone(problem, unknown, field, distance);
        let inputs = unknown.method.fields().into_iter().chain([Field::Fy, Field::Doffs]);
        let mut sources: Vec<Source> = inputs
            .filter(|&field| field != unknown.field)
            .filter_map(|field| Some((field, alone(Some(field))?)))
            .map(|(field, one)| Source::new(assessment.worded(field), one))
            .chain(alone(None).map(|one| Source::new(fields::DISTANCE, one)))
            .filter(|source| source.share > 0.0)
            .collect();
        let variance: f64 = sources.iter().map(|source| source.share * source.share).sum();
        if !(variance.is_normal() && sigma > 0.0 && value.is_finite()) {
            return None;
        }
        for source in &mut sources {
            source.share *= source.share / variance;
        }
        sources.sort_by(|a, b| b.share.total_cmp(&a.share));
        let name = key.label;
        // A title has no subscripts.
        let title = match key.symbol {
            symbol if symbol.contains('_') => name.to_owned(),
            symbol => format!("{name} {symbol}"),
        };
        Some(Self {
            name: name.to_owned(),
            quantity: Quantity::new(title, unit.symbol()),
            unit,
            value: unit.from_base(value),
            sigma: unit.from_base(sigma),
            method: Some(unknown.method),
            sources,
        })
    }
}

/// The inputs with every σ as it was typed: where something was solved for, those of the assessment are without the σ that went into it.
pub fn as_typed(assessment: &Assessment) -> Problem {
    let mut problem = assessment.solution.problem;
    for reading in &assessment.readings {
        if let (Some(field), Some(sigma)) = (reading.key.input, reading.sigma)
            && !assessment.is_solved_for(reading.key)
        {
            problem.set_sigma(field, sigma);
        }
    }
    problem
}

/// σ of what was solved for where only `field`, or only the distance, has one; in its base unit.
fn sigma_alone(problem: &Problem, unknown: &Unknown, field: Option<Field>, distance: Measured<Length>) -> Option<f64> {
    let mut only = problem.without_sigmas();
    if let Some(field) = field {
        only.set_sigma(field, problem.sigma(field));
    }
    only.set(unknown.field, None);
    let distance = if field.is_none() {
        distance
    } else {
        Measured::exact(distance.value)
    };
    let found = only.solve_for(unknown.method, unknown.field, distance).ok()??;
    Some(found.to_base().sigma)
}
