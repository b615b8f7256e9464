//! The cells of two photographs and a step, and of two points.

use super::cell::{Cell, STYLE, Value, sentence};
use super::ground::refusal;
use super::line::{Line, numbers};
use super::refusal::refused;
use super::shown::Shown;
use crate::assess::Assessment;
use crate::field::{Key, Section};
use crate::fields;
use crate::geometry::missing_for;
use crate::report::{self, BETWEEN_POINTS, FROM_FIRST_PLACE, Tone};
use crate::sentences::Phrase;
use depth_core::measured::Measured;
use depth_core::quantity::Length;

const SHOTS: [Key; 4] = [fields::FAR_WIDTH, fields::NEAR_WIDTH, fields::STEP, fields::FOCAL_LENGTH];

pub(super) fn shots(shown: &Shown<'_>) -> [Cell; 3] {
    let &Shown { assessment, unit, .. } = shown;
    let results = |assessment: &Assessment| {
        let solution = assessment.geometry.two_shots?.solution;
        Some([Some(solution.far), Some(solution.near), solution.size])
    };
    let titles = [
        (FROM_FIRST_PLACE, "s · w_2 / (w_2 − w_1)"),
        ("From the second place", "s · w_1 / (w_2 − w_1)"),
        ("Width of the object", "w_1 · D / fx"),
    ];
    let mut cells = cells(shown, Section::TwoShots, titles, results);
    let [far, near, size] = &mut cells;
    for cell in [far, near] {
        if matches!(cell.value, Value::Number { .. }) {
            let line = numbers(&cell.formula, &SHOTS, assessment, unit, &[]).unwrap_or_default();
            // Pixels divided by pixels.
            cell.lines = [line.without(" px"), Line::default()];
        }
    }
    if assessment.geometry.two_shots.is_some() && size.value == Value::Nothing {
        size.value = Value::Needs(vec![fields::FOCAL_LENGTH]);
    }
    if let Some(shots) = &assessment.geometry.two_shots {
        let [far, ..] = &mut cells;
        far.remarks = report::shots_remarks(assessment, shots).into_iter().map(sentence).collect();
        let one_pixel = shots.is_one_pixel_each.then(|| Line::of(Phrase::OnePixelEach, &[]));
        let [_, second] = &mut far.lines;
        *second = one_pixel.unwrap_or_default();
    }
    cells
}

pub(super) fn points(shown: &Shown<'_>) -> [Cell; 3] {
    let &Shown { assessment, unit, .. } = shown;
    let results = |assessment: &Assessment| {
        let points = assessment.geometry.two_points?;
        let [distance, away, right, _] = report::ways_between(&points).map(|(_, length)| Some(length));
        Some([distance, away, right])
    };
    let titles = [
        (BETWEEN_POINTS, "√(away² + right² + down²)"),
        ("Farther away", "fx · b / d_2 − fx · b / d_1"),
        ("To the right", ""),
    ];
    let mut cells = cells(shown, Section::TwoPoints, titles, results);
    if let Some(points) = &assessment.geometry.two_points {
        let [_, away, across, down] = report::ways_between(points);
        let [straight, farther, right] = &mut cells;
        for (cell, (name, _)) in [(farther, away), (&mut *right, across)] {
            cell.title = name.to_owned();
        }
        right.lines = [
            Line::of(format!("{}: {}", down.0, STYLE.measured(down.1, unit)), &[]),
            Line::default(),
        ];
        let [name_away, name_across, name_down] = [away, across, down].map(|(name, _)| short_way(name));
        straight.formula = format!("√({name_away}² + {name_across}² + {name_down}²)");
        // As precise as their sum.
        let number = |(_, length): (&str, Measured<Length>)| {
            let written = STYLE.length_like(length.value, points.distance, unit);
            written
                .split_once(' ')
                .map_or_else(|| written.clone(), |(number, _)| number.to_owned())
        };
        let of_sum = STYLE.unit_of(points.distance.value, unit).symbol();
        let sides = format!("√({}² + {}² + {}²) {of_sum}", number(away), number(across), number(down));
        straight.lines = [Line::of(sides, &[]), Line::default()];
    }
    cells
}

/// "away" for "Farther away", "right" for "To the right".
fn short_way(name: &str) -> String {
    name.rsplit(' ').next().unwrap_or(name).to_ascii_lowercase()
}

/// The cells of a way of its own: its results, or what is missing for them.
fn cells(
    shown: &Shown<'_>,
    section: Section,
    titles: [(&str, &str); 3],
    results: impl Fn(&Assessment) -> Option<[Option<Measured<Length>>; 3]>,
) -> [Cell; 3] {
    let &Shown { assessment, unit, was, .. } = shown;
    let values = |assessment: &Assessment| -> [Value; 3] {
        let lengths = results(assessment).unwrap_or_default();
        lengths.map(|length| length.map_or(Value::Nothing, |length| Value::length(length, unit)))
    };
    let mut cells = titles.map(|(title, formula)| Cell {
        title: title.to_owned(),
        tone: Tone::Neutral,
        formula: formula.to_owned(),
        ..Cell::default()
    });
    let was = was.map(values).unwrap_or_default();
    let note = refusal(assessment, |key| key.section == Some(section) || of_camera(section).contains(&key));
    let is_there = results(assessment).is_some();
    let missing = missing(shown, section);
    for ((cell, value), was) in cells.iter_mut().zip(values(assessment)).zip(was) {
        match note.filter(|_| !is_there) {
            Some(note) => *cell = refused(std::mem::take(cell), assessment, note, Some(was)),
            None if is_there => cell.value = value,
            None => cell.value = Value::Needs(missing.clone()),
        }
    }
    if !is_there {
        for later in cells.iter_mut().skip(1) {
            later.lines = Default::default();
            later.remarks.clear();
        }
    }
    cells
}

/// The fields of other sections that count.
const fn of_camera(section: Section) -> &'static [Key] {
    match section {
        Section::TwoPoints => &[fields::FOCAL_LENGTH, fields::BASELINE, fields::CX, fields::CY],
        _ => &[],
    }
}

/// What is missing: all of it, where nothing of it was typed.
fn missing(shown: &Shown<'_>, section: Section) -> Vec<Key> {
    let missing = missing_for(section, shown.inputs);
    if !missing.is_empty() {
        return missing;
    }
    let needed = of_camera(section).iter().copied().chain(section.keys());
    let mut needed: Vec<Key> = needed.filter(|&key| shown.inputs.entry(key).is_blank()).collect();
    needed.sort();
    needed
}
