//! The cells of a distance: stereo, monocular and both combined.

use super::cell::{Badge, Cell, Quality, STYLE, Value, sentence};
use super::line::{Line, numbers};
use super::refusal::refused;
use super::shown::Shown;
use crate::assess::Assessment;
use crate::field::Key;
use crate::names::{self, Named as _};
use crate::report::{self, Tone, budget_shares};
use crate::sentences::{Phrase, Statement, needs};
use depth_core::agreement::{Suspect, Verdict};
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Uncertainty};
use depth_core::quantity::{Length, LengthUnit};

pub(super) fn cells(shown: &Shown<'_>) -> [Cell; 3] {
    let [stereo, monocular] = Method::ALL.map(|method| of_method(shown, method));
    let mut combined = combined(shown);
    // Where the pixel was typed, the place of the point is what is asked for.
    if let Some((_, point)) = shown.assessment.geometry.point {
        let length = |length: Measured<Length>| STYLE.measured(length, shown.unit);
        let [_, second] = &mut combined.lines;
        *second = Line::of(
            Phrase::PointIs {
                range: length(point.range),
            },
            &[],
        );
    }
    [stereo, monocular, combined]
}

/// The fields of a formula of `method`, in the words of what is measured.
pub(super) fn keys(assessment: &Assessment, method: Method) -> Vec<Key> {
    let fields = method.fields().into_iter().chain(method.optional_fields());
    fields.map(|field| assessment.worded(field)).collect()
}

pub(super) fn value(assessment: &Assessment, method: Method, unit: LengthUnit) -> Option<Value> {
    let distance = assessment.distance(method)?;
    let sigma = assessment
        .solution
        .uncertainty(method)
        .map_or(Length::from_m(0.0), |known| known.sigma);
    Some(Value::length(Measured::new(distance, sigma), unit))
}

/// So many characters fit behind "Example: ".
const LONGEST_EXAMPLE: usize = 24;

fn of_method(shown: &Shown<'_>, method: Method) -> Cell {
    let &Shown {
        inputs,
        assessment,
        unit,
        was,
    } = shown;
    let formula = names::formula(&assessment.solution.problem, method);
    let cell = Cell {
        title: method.name().to_owned(),
        tone: method.into(),
        formula: formula.trim_start_matches("D = ").to_owned(),
        ..Cell::default()
    };
    if let Some(value) = value(assessment, method, unit) {
        let lines = [certainty(assessment, method, unit), numbers_of(&cell, assessment, method, unit)];
        return Cell {
            value,
            lines,
            remarks: remarks(assessment, method, unit),
            ..cell
        };
    }
    let missing = inputs.missing_for(method);
    if let Some(note) = assessment.refusal(method) {
        if inputs.is_begun(method) {
            return refused(cell, assessment, note, was.and_then(|was| self::value(was, method, unit)));
        }
        return Cell {
            value: Value::Needs(missing),
            ..refused(cell, assessment, note, None)
        };
    }
    let example = inputs.with_examples().assess();
    let lines = match self::value(&example, method, unit).filter(|_| !missing.is_empty()) {
        Some(value) => {
            let numbers = numbers_of(&cell, &example, method, unit);
            let is_long = numbers.text().chars().count() > LONGEST_EXAMPLE;
            // Pixels divided by pixels.
            let numbers = if is_long { numbers.without(" px") } else { numbers };
            [
                numbers.after(&Phrase::Example.to_string()),
                Line::of(format!("= {}", value.text()), &[]),
            ]
        }
        None => Default::default(),
    };
    Cell {
        value: if missing.is_empty() {
            Value::Nothing
        } else {
            Value::Needs(missing)
        },
        lines,
        ..cell
    }
}

fn numbers_of(cell: &Cell, assessment: &Assessment, method: Method, unit: LengthUnit) -> Line {
    numbers(&cell.formula, &keys(assessment, method), assessment, unit, &[]).unwrap_or_default()
}

/// The interval, and what most of it comes from; without σ what one pixel changes.
fn certainty(assessment: &Assessment, method: Method, unit: LengthUnit) -> Line {
    let solution = &assessment.solution;
    if let Some(uncertainty) = solution.uncertainty(method) {
        return how_sure(assessment, uncertainty, unit);
    }
    match STYLE.one_pixel_range(solution, unit).filter(|_| method == Method::Stereo) {
        Some(range) => Line::of(Phrase::WithOnePixel { range }, &[assessment.worded(Field::Disparity)]),
        None => Line::of(Phrase::TakenToBeExact, &[]),
    }
}

/// "1.384…1.416 m · 75 % from d"
fn how_sure(assessment: &Assessment, uncertainty: &Uncertainty, unit: LengthUnit) -> Line {
    let range = STYLE.interval(uncertainty, unit);
    match budget_shares(assessment, uncertainty).into_iter().next() {
        Some((key, share)) => Line::of(Phrase::From { share, of: key.symbol }, &[key]).after(&format!("{range} · ")),
        None => Line::of(range, &[]),
    }
}

/// What else is to be said of a distance.
fn remarks(assessment: &Assessment, method: Method, unit: LengthUnit) -> Vec<String> {
    let solution = &assessment.solution;
    let of_method = report::remarks(assessment, method).into_iter().map(sentence);
    let uncertainty = solution.uncertainty(method);
    let one_pixel = STYLE
        .one_pixel_range(solution, unit)
        .filter(|_| method == Method::Stereo && uncertainty.is_some());
    let one_pixel = one_pixel.map(|range| sentence(format!("{range} with {}", report::ONE_PIXEL)));
    let facing = assessment.geometry.facing.filter(|_| method == Method::Monocular);
    let facing = facing.map(|facing| {
        sentence(format!(
            "{} {}: {}",
            method.name(),
            report::WITHOUT_TILT,
            STYLE.length(Some(facing), unit)
        ))
    });
    let is_poor = uncertainty.is_some_and(|known| !known.model.first_order_is_good());
    let poor = is_poor.then(|| sentence(Statement::FirstOrderIsPoor { has_simulation: true }));
    let bias = uncertainty.and_then(|known| known.notable_bias()).map(|bias| {
        let bias = Value::rounded(bias, unit).text();
        Phrase::MeanIsTooFar { bias }.to_string()
    });
    of_method.chain(one_pixel).chain(facing).chain(poor).chain(bias).collect()
}

fn combined(shown: &Shown<'_>) -> Cell {
    let &Shown {
        inputs,
        assessment,
        unit,
        was,
    } = shown;
    let solution = &assessment.solution;
    let cell = Cell {
        title: Phrase::Combined.to_string(),
        tone: Tone::Combined,
        ..Cell::default()
    };
    if let Some(comparison) = solution.comparison {
        return match (solution.combined, comparison.contradict()) {
            (Some(combined), _) => agreeing(cell, assessment, Value::length(combined, unit)),
            (None, true) => disagreeing(cell, assessment),
            (None, false) => unjudged(cell, assessment, comparison.ratio),
        };
    }
    let lacks = |method: &Method| assessment.distance(*method).is_none();
    let lines = match (
        Method::ALL.into_iter().find(lacks),
        Method::ALL.into_iter().find(|method| !lacks(method)),
    ) {
        (Some(missing), Some(there)) if !inputs.missing_for(missing).is_empty() => {
            let missing = inputs.missing_for(missing);
            let needs = needs(&missing);
            [
                Line::of(Phrase::AloneSoFar { method: there }, &[]),
                Line::of(Phrase::ToCheckIt { needs }, &missing),
            ]
        }
        (Some(missing), Some(there)) => [
            Line::of(Phrase::OneIsMissing { missing }, &[]),
            Line::of(Phrase::StandsAlone { method: there }, &[]),
        ],
        _ => match inputs.with_examples().assess().solution.combined {
            Some(combined) => [
                Line::of(Value::length(combined, unit).text(), &[]).after(&Phrase::Example.to_string()),
                Line::of(Phrase::WhatCombinedIs, &[]),
            ],
            None => [Line::default(), Line::of(Phrase::WhatCombinedIs, &[])],
        },
    };
    let is_refused = |method| inputs.is_begun(method) && assessment.refusal(method).is_some();
    let was = was.filter(|_| Method::ALL.into_iter().any(is_refused));
    let was = was.and_then(|was| Value::length(was.solution.combined?, unit).into_was());
    Cell {
        value: was.unwrap_or(Value::NeedsBoth),
        lines,
        ..cell
    }
}

fn agreeing(cell: Cell, assessment: &Assessment, value: Value) -> Cell {
    let solution = &assessment.solution;
    let agreement = solution.comparison.and_then(|comparison| comparison.agreement);
    let badge = agreement.map(|agreement| match agreement.verdict {
        Verdict::Agree => Badge {
            text: "Agree",
            quality: Quality::Good,
        },
        Verdict::Doubtful => Badge {
            text: "Hardly agree",
            quality: Quality::Fair,
        },
        Verdict::Disagree => DISAGREE,
    });
    let apart = agreement.zip(solution.weights()).map(|(agreement, [of_stereo, _])| {
        let z = agreement.z;
        if agreement.widening() > NOTABLE_WIDENING {
            Phrase::Widened { z }
        } else {
            Phrase::Apart { z, of_stereo }
        }
    });
    let shares_focal_length = solution.best().is_some_and(|best| best.has_focal_length);
    let shared = if agreement.is_some_and(|agreement| agreement.verdict != Verdict::Agree) {
        Some(Phrase::OneInTwenty)
    } else {
        shares_focal_length.then_some(Phrase::SharedFocalLength)
    };
    let line = |phrase: Option<Phrase>| phrase.map_or_else(Line::default, |phrase| Line::of(phrase, &[Field::FocalLength.into()]));
    let said = Statement::comparison(assessment).into_iter().map(sentence);
    Cell {
        value,
        badge,
        lines: [line(apart), line(shared)],
        remarks: said.chain(suspects(assessment)).collect(),
        ..cell
    }
}

/// From so many times on it is said that the combined ± was widened: below, the digits shown hardly change.
const NOTABLE_WIDENING: f64 = 1.05;

const DISAGREE: Badge = Badge {
    text: "Disagree",
    quality: Quality::Bad,
};

fn disagreeing(cell: Cell, assessment: &Assessment) -> Cell {
    let mut lines = assessment.suspects().into_iter().map(|suspect| suspected(assessment, &suspect));
    let ratio = assessment.solution.comparison.and_then(|comparison| comparison.ratio);
    Cell {
        value: Value::Sentence(Phrase::Times { ratio }.to_string()),
        badge: Some(DISAGREE),
        lines: [lines.next().unwrap_or_default(), lines.next().unwrap_or_default()],
        remarks: Statement::comparison(assessment)
            .into_iter()
            .map(sentence)
            .chain(suspects(assessment))
            .collect(),
        ..cell
    }
}

/// Two distances, of which not each has a σ of its own.
fn unjudged(cell: Cell, assessment: &Assessment, ratio: Option<f64>) -> Cell {
    let remarks = Statement::comparison(assessment).into_iter().map(sentence);
    Cell {
        value: Value::Sentence(Phrase::NeedsSigmas.to_string()),
        lines: [Line::of(Phrase::Times { ratio }, &[]), Line::of(Phrase::HowToJudge, &[])],
        remarks: remarks.collect(),
        ..cell
    }
}

fn suspects(assessment: &Assessment) -> impl Iterator<Item = String> {
    let suspects = assessment.suspects().into_iter();
    suspects.map(|suspect| Statement::suspect(assessment, &suspect).to_string())
}

/// What a suspect is suspected of, short, with the symbol of its field.
fn suspected(assessment: &Assessment, suspect: &Suspect) -> Line {
    let key = |source: Field| assessment.worded(source);
    let (phrase, key) = match *suspect {
        Suspect::RawDisparity { scale } => (Phrase::NotDivided { scale }, key(Field::Disparity)),
        Suspect::Unit { source, taken, meant } => {
            let symbol = key(source).symbol;
            (Phrase::ReallyIn { symbol, taken, meant }, key(source))
        }
        Suspect::Resized { source, times } => (
            Phrase::OtherSize {
                symbol: key(source).symbol,
                times,
            },
            key(source),
        ),
        Suspect::NoSigma(source) => (
            Phrase::HowWellKnown {
                symbol: key(source).symbol,
            },
            key(source),
        ),
        Suspect::LargestSigma(source) => (
            Phrase::MeasureAgain {
                symbol: key(source).symbol,
            },
            key(source),
        ),
    };
    Line::of(phrase, &[key])
}
