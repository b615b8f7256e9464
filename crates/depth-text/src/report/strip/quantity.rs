//! The cells of another quantity: the answer, what it means at that distance, and a check.

use super::cell::{Cell, STYLE, Value, sentence};
use super::line::{Line, Part, numbers};
use super::refusal::refused;
use super::shown::Shown;
use crate::assess::{Assessment, Unknown};
use crate::field::Key;
use crate::fields;
use crate::note::{Issue, Severity};
use crate::report::{self, Tone};
use crate::sentences::{Phrase, shares};
use crate::unit::Unit;
use depth_core::angle::AngleUnit;
use depth_core::camera::{pixel_size, subtended_angle};
use depth_core::disparity::{as_stored_by_opencv, num_disparities};
use depth_core::in_image::InImage;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Problem, Solved};
use depth_core::quantity::{Length, LengthUnit, Pixels};
use depth_core::setup::Object;

pub(super) fn cells(shown: &Shown<'_>) -> [Cell; 3] {
    let assessment = shown.assessment;
    let Some(unknown) = &assessment.unknown else {
        let nothing = Cell {
            value: Value::Sentence(Phrase::ChooseQuantity.to_string()),
            ..Cell::default()
        };
        return [nothing, Cell::default(), Cell::default()];
    };
    let [meaning, check] = match unknown.field {
        Field::Disparity => [one_pixel_of_disparity(shown), for_opencv(unknown)],
        Field::Baseline => [one_pixel_of_disparity(shown), angle(shown, unknown)],
        Field::Doffs => [effective_disparity(shown), one_pixel_of_disparity(shown)],
        Field::FocalLength if unknown.method == Method::Stereo => [one_pixel_on_the_object(shown, unknown), one_pixel_of_disparity(shown)],
        _ => [one_pixel_on_the_object(shown, unknown), angle(shown, unknown)],
    };
    [answer(shown, unknown), meaning, check]
}

/// The formula of `method` solved for `field`, with the symbols of the fields: "fx · b / D", and true; where more than the plain equation
/// counts (a lens, a tilt, a ball, angles), the equation as it stands, "D = …", and false.
pub fn formula(problem: &Problem, method: Method, field: Field) -> (String, bool) {
    let has = |field| problem.get(field).is_some_and(|value| value != 0.0);
    let is_angle = |extent: Option<InImage>| matches!(extent, Some(InImage::Angle(_)));
    let is_decorated = has(Field::Lens)
        || has(Field::Zero)
        || is_angle(problem.disparity.filter(|_| method == Method::Stereo))
        || method == Method::Monocular && (has(Field::Tilt) || problem.object == Object::Ball || is_angle(problem.image_width));
    if is_decorated {
        return (crate::names::formula(problem, method), false);
    }
    let f = if problem.needs_fy(method) && problem.get(Field::Fy).is_some() {
        "fy"
    } else {
        "fx"
    };
    let (d, minus) = if has(Field::Doffs) {
        ("(d + doffs)", " − doffs")
    } else {
        ("d", "")
    };
    let formula = match (method, field) {
        (Method::Stereo, Field::FocalLength) => format!("D · {d} / b"),
        (Method::Stereo, Field::Baseline) => format!("D · {d} / {f}"),
        (Method::Stereo, Field::Doffs) => format!("{f} · b / D − d"),
        (Method::Stereo, _) => format!("{f} · b / D{minus}"),
        (Method::Monocular, Field::FocalLength) => "D · w_img / w_real".to_owned(),
        (Method::Monocular, Field::RealWidth) => format!("w_img · D / {f}"),
        (Method::Monocular, _) => format!("w_real · {f} / D"),
    };
    (formula, true)
}

fn answer(shown: &Shown<'_>, unknown: &Unknown) -> Cell {
    let &Shown {
        inputs,
        assessment,
        unit,
        was,
    } = shown;
    let key = assessment.worded(unknown.field);
    let (formula, is_plain) = formula(&unknown.given, unknown.method, unknown.field);
    let cell = Cell {
        title: key.label.to_owned(),
        tone: match Tone::of(key) {
            Tone::Neutral => unknown.method.into(),
            tone => tone,
        },
        formula,
        ..Cell::default()
    };
    let found = match &unknown.outcome {
        Ok(found) => *found,
        Err(Issue::MissingForUnknown { .. }) => {
            let mut missing = inputs.missing_for(unknown.method);
            missing.extend(inputs.entry(fields::DISTANCE).is_blank().then_some(fields::DISTANCE));
            return Cell {
                value: Value::Needs(missing),
                ..cell
            };
        }
        Err(issue) => {
            let was = was.and_then(|was| value(was, unit));
            let note = assessment
                .notes
                .iter()
                .find(|note| note.severity == Severity::Error && note.issue == *issue);
            return match note {
                Some(note) => without_answer(refused(cell, assessment, note, was)),
                None => Cell {
                    value: was.and_then(Value::into_was).unwrap_or_default(),
                    lines: [Line::of(issue, &[]).refusal(), Line::default()],
                    ..cell
                },
            };
        }
    };
    let keys = keys(assessment, unknown.method);
    let line = is_plain.then(|| numbers(&cell.formula, &keys, assessment, unit, &[])).flatten();
    Cell {
        value: value_of(found, unit),
        lines: [how_sure(assessment, unknown, unit), line.unwrap_or_default()],
        remarks: report::remarks(assessment, unknown.method).into_iter().map(sentence).collect(),
        ..cell
    }
}

/// What is refused here is no distance.
fn without_answer(mut cell: Cell) -> Cell {
    let [first, _] = &mut cell.lines;
    if let Some(Part::Text(text)) = first.parts.first_mut() {
        *text = text.replacen(&Phrase::NoDistance.to_string(), &Phrase::NoAnswer.to_string(), 1);
    }
    cell
}

fn keys(assessment: &Assessment, method: Method) -> Vec<Key> {
    let mut keys = super::distance::keys(assessment, method);
    keys.push(fields::DISTANCE);
    keys
}

fn value(assessment: &Assessment, unit: LengthUnit) -> Option<Value> {
    Some(value_of(*assessment.unknown.as_ref()?.outcome.as_ref().ok()?, unit))
}

fn value_of(found: Solved, unit: LengthUnit) -> Value {
    match found {
        Solved::Length(length) => Value::length(length, unit),
        Solved::InImage(InImage::OnSensor(length)) => Value::length(length, LengthUnit::Millimeter),
        Solved::InImage(extent) => Value::of(extent.to_base(), Some(Unit::Pixel)),
    }
}

/// "49.54…50.46 px · 60 % from D"
fn how_sure(assessment: &Assessment, unknown: &Unknown, unit: LengthUnit) -> Line {
    let (Ok(found), Some(distance)) = (&unknown.outcome, unknown.distance) else {
        return Line::default();
    };
    let Measured { sigma, .. } = found.to_base();
    if sigma <= 0.0 {
        return Line::of(Phrase::TakenToBeExact, &[]);
    }
    let range = match *found {
        Solved::Length(length) => STYLE.ends(length, unit),
        Solved::InImage(InImage::OnSensor(length)) => STYLE.ends(length, LengthUnit::Millimeter),
        Solved::InImage(extent) => STYLE.ends_in(extent.to_base(), Unit::Pixel),
    };
    let parts = unknown.given.shares_of_solved(unknown.method, unknown.field, distance);
    let written = shares(&parts.iter().map(|(_, share)| *share).collect::<Vec<_>>());
    let largest = parts.iter().zip(written).max_by(|((_, a), _), ((_, b), _)| a.total_cmp(b));
    match largest {
        Some(((source, _), share)) => {
            let key = source.map_or(fields::DISTANCE, |source| assessment.worded(source));
            Line::of(Phrase::From { share, of: key.symbol }, &[key]).after(&format!("{range} · "))
        }
        None => Line::of(range, &[]),
    }
}

/// What a pixel of disparity more or less makes of the distance.
fn one_pixel_of_disparity(shown: &Shown<'_>) -> Cell {
    let &Shown { assessment, unit, .. } = shown;
    let solution = &assessment.solution;
    let cell = Cell {
        title: Phrase::OnePixel.to_string(),
        formula: "D / d".to_owned(),
        ..Cell::default()
    };
    let (Some(step), Some(disparity)) = (solution.depth_of_one_pixel(), solution.problem.disparity.and_then(InImage::px)) else {
        return cell;
    };
    let at = |shift: f64| {
        let distance = STYLE.length(solution.problem.stereo_distance_if(shift), unit);
        let disparity = Unit::Pixel.behind(&STYLE.readable(disparity.value.px() + shift, 4));
        (disparity, distance)
    };
    let ((fewer, farther), (more, nearer)) = (at(-1.0), at(1.0));
    Cell {
        value: Value::rounded(step, unit),
        lines: [
            Line::of(
                Phrase::OneLess {
                    disparity: fewer,
                    distance: farther,
                },
                &[],
            ),
            Line::of(
                Phrase::OneMore {
                    disparity: more,
                    distance: nearer,
                },
                &[],
            ),
        ],
        ..cell
    }
}

/// The disparity as OpenCV's matchers store it.
fn for_opencv(unknown: &Unknown) -> Cell {
    let cell = Cell {
        title: Phrase::ForOpenCv.to_string(),
        formula: "d × 16".to_owned(),
        ..Cell::default()
    };
    let Ok(Solved::InImage(InImage::Pixels(disparity))) = unknown.outcome else {
        return cell;
    };
    let [_, upper] = disparity.to_base().ends();
    let number = num_disparities(Pixels::new(upper));
    Cell {
        value: Value::of(as_stored_by_opencv(disparity), None),
        lines: [
            Line::of(Phrase::AsOpenCvReturns, &[]),
            number.map_or_else(Line::default, |number| Line::of(Phrase::NumDisparities { number }, &[])),
        ],
        ..cell
    }
}

/// d + doffs.
fn effective_disparity(shown: &Shown<'_>) -> Cell {
    let effective = shown.assessment.solution.problem.effective_disparity();
    Cell {
        title: Phrase::EffectiveDisparity.to_string(),
        tone: Tone::Stereo,
        formula: "d + doffs".to_owned(),
        value: effective.map_or(Value::Nothing, |px| Value::of(Measured::new(px.px(), 0.0), Some(Unit::Pixel))),
        lines: [Line::of(Phrase::WhatDistanceCounts, &[]), Line::of(Phrase::ZeroForRectified, &[])],
        ..Cell::default()
    }
}

/// What a pixel covers on the object, Z/f.
fn one_pixel_on_the_object(shown: &Shown<'_>, unknown: &Unknown) -> Cell {
    let problem = &shown.assessment.solution.problem;
    let f = problem.focal_length_of(unknown.method).and_then(InImage::px);
    let size = f
        .zip(unknown.distance)
        .and_then(|(f, distance)| pixel_size(f.value, distance.value));
    Cell {
        title: Phrase::OnePixelOnObject.to_string(),
        formula: "D / fx".to_owned(),
        value: size.map_or(Value::Nothing, |size| Value::rounded(size, shown.unit)),
        lines: [Line::of(Phrase::SidewaysAtDistance, &[]), Line::default()],
        ..Cell::default()
    }
}

/// The angle that the object spans, or the one between the lines of sight of two cameras.
/// The baseline or the real width, each with its σ: as it was given, or as it was solved for.
pub(in crate::report) fn extent_of(assessment: &Assessment, unknown: &Unknown) -> Option<Measured<Length>> {
    let (given, solved) = match unknown.method {
        Method::Stereo => (unknown.given.baseline, assessment.solution.problem.baseline),
        Method::Monocular => (unknown.given.real_width, assessment.solution.problem.real_width),
    };
    given.or(solved)
}

fn angle(shown: &Shown<'_>, unknown: &Unknown) -> Cell {
    let (extent, title, formula) = match unknown.method {
        Method::Stereo => (extent_of(shown.assessment, unknown), Phrase::BetweenRays, "2 · atan(b / (2 · D))"),
        Method::Monocular => (
            extent_of(shown.assessment, unknown),
            Phrase::ObjectSpans,
            "2 · atan(w_real / (2 · D))",
        ),
    };
    let angle = extent
        .zip(unknown.distance)
        .and_then(|(extent, distance)| subtended_angle(extent, distance));
    Cell {
        title: title.to_string(),
        formula: formula.to_owned(),
        value: angle.map_or(Value::Nothing, |angle| {
            Value::of(
                Measured::new(angle.value.degrees(), angle.sigma.degrees()),
                Some(Unit::Angle(AngleUnit::Degree)),
            )
        }),
        lines: [
            Line::of(
                if unknown.method == Method::Stereo {
                    Phrase::WiderIsBetter
                } else {
                    Phrase::LargerIsBetter
                },
                &[],
            ),
            Line::default(),
        ],
        ..Cell::default()
    }
}
