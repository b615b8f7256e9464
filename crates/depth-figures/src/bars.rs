//! What the rows of "Stereo against monocular" and of "If one input were exact" show; [`crate::rows`] lays them out.

use crate::axis::Quantity;
use crate::numbers;
use crate::sources::Solved;
use crate::spans::{Estimate, Span};
use crate::{Ink, Words};
use depth_core::agreement::Comparison;
use depth_core::measured::Measured;
use depth_core::problem::{Method, Origin, Solution};
use depth_core::quantity::{Length, LengthUnit};
use depth_text::names::Named as _;
use depth_text::number::Notation;
use depth_text::sentences::sigmas;
use depth_text::style::Style;
use depth_text::unit::Unit;

/// Which row it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RowId {
    /// The distance from there.
    Distance(Origin),
    /// What was solved for, with every σ as it was typed.
    AllAsTyped,
    /// … with this source of the budget exact.
    Exact(usize),
}

/// The colors of a row.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Looks {
    Stereo,
    Monocular,
    Combined,
    /// Dark gray: what would be.
    Supposed,
    /// Gray: what was.
    Stale,
}

/// A row.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct RowModel {
    pub id: RowId,
    pub looks: Looks,
    /// Its heading.
    pub name: Words,
    /// At the right of the heading.
    pub value: Words,
    /// What is drawn; `None` for an empty row.
    pub estimate: Option<Estimate>,
    /// What a tip says.
    pub tip: Vec<String>,
}

/// Both distances where they cannot be right both.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Gap {
    pub between: [f64; 2],
    /// "10 times as far, over 10 σ apart", and shorter.
    pub texts: Vec<String>,
}

/// Rows on one axis.
#[derive(Clone, Debug, PartialEq)]
pub struct Bars {
    pub(crate) quantity: Quantity,
    pub(crate) rows: Vec<RowModel>,
    /// The interval behind all rows.
    pub(crate) band: Option<Span>,
    pub(crate) gap: Option<Gap>,
    /// Whether bars are drawn from zero to the points.
    pub(crate) has_bars: bool,
}

impl Bars {
    /// "Stereo against monocular": always three rows. A distance that is not there is shown as it was in `last`, the last solution
    /// that had it, in gray.
    pub fn new(solution: &Solution, last: Option<&Solution>, unit: LengthUnit) -> Self {
        let unit = unit_of_axis(solution, last, unit);
        let stereo = method_row(solution, last, Method::Stereo, unit);
        let monocular = method_row(solution, last, Method::Monocular, unit);
        let combined = combined_row(solution, last, unit);
        let band = match solution.combined {
            Some(_) => combined.estimate,
            None if solution.comparison.is_some_and(|comparison| !comparison.contradict()) => stereo.estimate,
            None => None,
        };
        Self {
            quantity: Quantity::distance(unit.symbol()),
            band: band.and_then(|estimate| estimate.one()),
            gap: gap(solution, unit),
            rows: vec![stereo, monocular, combined],
            has_bars: true,
        }
    }

    /// "If one input were exact": σ as it is, and without each of its sources, σ·√(1 − share).
    pub fn gains(solved: &Solved) -> Self {
        let Solved {
            value,
            sigma,
            unit,
            sources,
            ..
        } = solved;
        let row = |id, looks, name, sigma_left: f64, less: Option<f64>| {
            let estimate = Estimate::symmetric(*value, sigma_left);
            let less = less.map(|part| format!("{:.0} % less", part * 100.0));
            RowModel {
                id,
                looks,
                name,
                value: less
                    .map_or_else(Words::default, |less| Words::new(format!("{less}   "), Ink::Muted))
                    .then_strong(numbers::sigma(*value, sigma_left, *unit), Ink::Text),
                tip: tip(&estimate, *unit),
                estimate: Some(estimate),
            }
        };
        let looks = match solved.method {
            Some(Method::Stereo) => Looks::Stereo,
            Some(Method::Monocular) => Looks::Monocular,
            None => Looks::Combined,
        };
        let all = row(RowId::AllAsTyped, looks, Words::strong("All as typed", Ink::Text), *sigma, None);
        let exact = sources.iter().enumerate().map(|(index, source)| {
            let left = (1.0 - source.share).clamp(0.0, 1.0).sqrt();
            let name = strong(&source.symbol).then_strong(" exact", Ink::Text);
            row(RowId::Exact(index), Looks::Supposed, name, sigma * left, Some(1.0 - left))
        });
        Self {
            quantity: solved.quantity.clone(),
            band: all.estimate.and_then(|estimate| estimate.one()),
            rows: std::iter::once(all.clone()).chain(exact).collect(),
            gap: None,
            has_bars: false,
        }
    }

    /// The name and the value of each row.
    pub fn in_words(&self) -> Vec<(String, String)> {
        self.rows.iter().map(|row| (row.name.text(), row.value.text())).collect()
    }

    /// Whether there is anything to draw.
    pub fn is_empty(&self) -> bool {
        self.rows.iter().all(|row| row.estimate.is_none())
    }
}

/// The same words, all of them heavy and in the ink of text.
fn strong(words: &Words) -> Words {
    let mut words = words.clone();
    for run in &mut words.runs {
        run.is_strong = true;
        run.ink = Ink::Text;
    }
    words
}

/// The unit in which the longest of all distances is written out.
fn unit_of_axis(solution: &Solution, last: Option<&Solution>, unit: LengthUnit) -> LengthUnit {
    let distances = Method::ALL.into_iter().filter_map(|method| {
        let of = |solution: &Solution| solution.outcome(method).distance();
        of(solution).or_else(|| last.and_then(of))
    });
    let longest = distances.max_by(|a, b| a.m().total_cmp(&b.m()));
    longest.map_or(unit, |longest| Style::WINDOW.unit_of(longest, unit))
}

fn method_row(solution: &Solution, last: Option<&Solution>, method: Method, unit: LengthUnit) -> RowModel {
    let looks = match method {
        Method::Stereo => Looks::Stereo,
        Method::Monocular => Looks::Monocular,
    };
    let now = Estimate::distance(solution, method, unit);
    let then = last.and_then(|last| Some((last.outcome(method).distance()?, Estimate::distance(last, method, unit)?)));
    let drawn = match (now, then) {
        (Some(estimate), _) => {
            let sigma = solution.uncertainty(method).map_or(Length::from_m(0.0), |known| known.sigma);
            let distance = solution.outcome(method).distance().unwrap_or(Length::from_m(0.0));
            Drawn::now(looks, estimate, &numbers::length(Measured::new(distance, sigma), unit))
        }
        (None, Some((was, estimate))) => Drawn::was(estimate, was, unit),
        (None, None) => Drawn::nothing(looks, "no distance"),
    };
    drawn.row(RowId::Distance(Origin::Method(method)), method.name(), unit)
}

fn combined_row(solution: &Solution, last: Option<&Solution>, unit: LengthUnit) -> RowModel {
    let has_both = Method::ALL.into_iter().all(|method| solution.outcome(method).distance().is_some());
    let now = solution.combined.zip(Estimate::combined(solution, unit));
    let then = last
        .filter(|_| !has_both)
        .and_then(|last| Some((last.combined?.value, Estimate::combined(last, unit)?)));
    let drawn = match (now, then) {
        (Some((combined, estimate)), _) => Drawn::now(Looks::Combined, estimate, &numbers::length(combined, unit)),
        (None, Some((was, estimate))) => Drawn::was(estimate, was, unit),
        (None, None) => Drawn::nothing(Looks::Combined, why_not_combined(solution, has_both)),
    };
    drawn.row(RowId::Distance(Origin::Combined), "Combined", unit)
}

fn why_not_combined(solution: &Solution, has_both: bool) -> &'static str {
    if !has_both {
        "needs both distances"
    } else if solution.comparison.is_some_and(|comparison| comparison.contradict()) {
        "not combined"
    } else {
        "needs ± in both"
    }
}

/// What stands in a row of a distance.
struct Drawn {
    looks: Looks,
    value: Words,
    estimate: Option<Estimate>,
}

impl Drawn {
    fn now(looks: Looks, estimate: Estimate, text: &str) -> Self {
        Self {
            looks,
            value: Words::strong(text, Ink::Text),
            estimate: Some(estimate),
        }
    }

    fn was(estimate: Estimate, was: Length, unit: LengthUnit) -> Self {
        let text = format!("was {}", numbers::plain_length(was, unit));
        Self {
            looks: Looks::Stale,
            value: Words::new(text, Ink::Muted),
            estimate: Some(estimate),
        }
    }

    fn nothing(looks: Looks, why: &str) -> Self {
        Self {
            looks,
            value: Words::new(why, Ink::Muted),
            estimate: None,
        }
    }

    fn row(self, id: RowId, name: &str, unit: LengthUnit) -> RowModel {
        // What can be no number of a picture is not drawn.
        let estimate = self.estimate.filter(|estimate| estimate.value.is_normal());
        RowModel {
            id,
            looks: self.looks,
            name: Words::strong(name, Ink::Text),
            value: self.value,
            tip: estimate.map_or_else(Vec::new, |estimate| tip(&estimate, Unit::Length(unit))),
            estimate,
        }
    }
}

/// "± 1 σ: 1.350…1.451 m", "± 2 σ: 1.300…1.502 m".
fn tip(estimate: &Estimate, unit: Unit) -> Vec<String> {
    let (Some(sigma), Some([one, two])) = (estimate.sigma, estimate.intervals) else {
        return Vec::new();
    };
    let line = |times: u32, span| format!("± {times} σ: {}", numbers::span(span, estimate.value, sigma, unit));
    vec![line(1, one), line(2, two)]
}

/// The gap between two distances that contradict each other.
fn gap(solution: &Solution, unit: LengthUnit) -> Option<Gap> {
    let comparison = solution.comparison.filter(Comparison::contradict)?;
    let between = Method::ALL.map(|method| solution.outcome(method).distance().map(|distance| distance.in_unit(unit)));
    let [Some(stereo), Some(monocular)] = between else { return None };
    let short = |number: f64| Notation::SHORT.plain(number, 2);
    let times = comparison.ratio.map(|ratio| {
        let ratio = ratio.max(1.0 / ratio);
        if ratio < 2.0 {
            format!("{} % farther", short((ratio - 1.0) * 100.0))
        } else {
            format!("{} times as far", short(ratio))
        }
    });
    let apart = comparison.agreement.map(|agreement| format!("{} σ apart", sigmas(agreement.z)));
    let texts = match (times, apart) {
        (Some(times), Some(apart)) => vec![format!("{times}, {apart}"), apart, times],
        (times, apart) => times.into_iter().chain(apart).collect(),
    };
    Some(Gap {
        between: [stereo, monocular],
        texts,
    })
}
