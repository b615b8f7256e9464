//! Where the uncertainty of an answer comes from.

use super::{Mode, Shown, Tone};
use crate::field::Key;
use crate::fields;
use crate::names::Named as _;
use crate::number::magnitude;
use crate::sentences::{Phrase, shares};
use crate::style::Style;
use crate::unit::Unit;
use depth_core::judge::Term;
use depth_core::measured::Measured;
use depth_core::problem::{Method, Solved};
use depth_core::quantity::{Length, LengthUnit};

const STYLE: Style = Style::WINDOW;

/// Where the σ of one answer comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Budget {
    /// Of which answer: "Stereo".
    pub title: String,
    /// Which method that belongs to.
    pub tone: Tone,
    /// Its σ: "± 0.016 m".
    pub sigma: String,
    /// What it comes from, the largest first.
    pub rows: Vec<BudgetRow>,
}

/// What one input has of a σ.
#[derive(Clone, Debug, PartialEq)]
pub struct BudgetRow {
    /// The input.
    pub key: Key,
    /// Its part of the variance, 0 to 1.
    pub share: f64,
    /// The same in percent; those of a budget add to 100: "75 %".
    pub percent: String,
    /// What it would be alone: "± 0.0140 m".
    pub contribution: String,
}

/// The budgets of what `mode` asks for; none where all is exact.
pub fn budgets(mode: Mode, shown: &Shown<'_>) -> Vec<Budget> {
    match mode {
        Mode::Distance => Method::ALL.into_iter().filter_map(|method| of_method(shown, method)).collect(),
        Mode::Quantity => of_quantity(shown).into_iter().collect(),
        Mode::Ground => of_ground(shown).into_iter().collect(),
        Mode::TwoShots | Mode::TwoPoints => Vec::new(),
    }
}

fn of_method(shown: &Shown<'_>, method: Method) -> Option<Budget> {
    let &Shown { assessment, unit, .. } = shown;
    let uncertainty = assessment.solution.uncertainty(method)?;
    let distance = Measured::new(assessment.distance(method)?, uncertainty.sigma);
    let parts = uncertainty
        .budget
        .iter()
        .map(|share| (assessment.worded(share.source), share.share));
    Some(budget(method.name(), method.into(), in_unit(distance, unit), parts.collect()))
}

fn of_quantity(shown: &Shown<'_>) -> Option<Budget> {
    let &Shown { assessment, unit, .. } = shown;
    let unknown = assessment.unknown.as_ref()?;
    let found = *unknown.outcome.as_ref().ok()?;
    let key = assessment.worded(unknown.field);
    let sigma = match found {
        Solved::Length(length) => in_unit(length, unit),
        Solved::InImage(extent) => match key.kind.default_unit() {
            Some(Unit::Pixel) if extent.px().is_none() => in_unit(
                Measured::from_base(found.to_base().value, found.to_base().sigma),
                LengthUnit::Millimeter,
            ),
            unit => (found.to_base().sigma, unit?),
        },
    };
    let parts = unknown.given.shares_of_solved(unknown.method, unknown.field, unknown.distance?);
    let parts = parts
        .into_iter()
        .map(|(source, share)| (source.map_or(fields::DISTANCE, |source| assessment.worded(source)), share));
    Some(budget(key.label, Tone::of(key), sigma, parts.collect())).filter(|budget| !budget.rows.is_empty())
}

fn of_ground(shown: &Shown<'_>) -> Option<Budget> {
    let ground = shown.assessment.geometry.ground?;
    let parts = ground.distance_shares.into_iter().map(|(term, share)| (key_of(term), share));
    let title = Phrase::DistanceAlongFloor.to_string();
    let budget = budget(&title, Tone::Combined, in_unit(ground.distance, shown.unit), parts.collect());
    Some(budget).filter(|budget| !budget.rows.is_empty())
}

/// The field that a term of the ground plane is typed into.
pub(super) const fn key_of(term: Term) -> Key {
    match term {
        Term::CameraHeight => fields::CAMERA_HEIGHT,
        Term::Pitch => fields::CAMERA_PITCH,
        Term::Row => fields::FLOOR_ROW,
        Term::BelowAxis => fields::FLOOR_ANGLE,
        _ => fields::FOCAL_LENGTH,
    }
}

/// The σ of a length in the unit in which it is written.
fn in_unit(length: Measured<Length>, unit: LengthUnit) -> (f64, Unit) {
    let unit = STYLE.unit_of(length.value, unit);
    (length.sigma.in_unit(unit), Unit::Length(unit))
}

fn budget(title: &str, tone: Tone, (sigma, unit): (f64, Unit), mut parts: Vec<(Key, f64)>) -> Budget {
    parts.retain(|(_, share)| *share > 0.0);
    parts.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    let percents = shares(&parts.iter().map(|(_, share)| *share).collect::<Vec<_>>());
    // One decimal more than σ has.
    let decimals = 2 - magnitude(sigma);
    let rows = parts.into_iter().zip(percents).map(|((key, share), percent)| BudgetRow {
        key,
        share,
        percent,
        contribution: format!("± {}", unit.behind(&STYLE.to_decimals(sigma_of(share, sigma), decimals))),
    });
    Budget {
        title: title.to_owned(),
        tone,
        sigma: format!("± {}", unit.behind(&STYLE.with_sigma(0.0, sigma).sigma)),
        rows: rows.collect(),
    }
}

/// What a share of the variance is of σ.
fn sigma_of(share: f64, sigma: f64) -> f64 {
    depth_core::uncertainty::part_of_sigma(share, sigma)
}
