//! The cells of the ground plane: straight ahead, to the right, along the floor.

use super::cell::{Cell, STYLE, Value};
use super::line::{Line, numbers};
use super::refusal::refused;
use super::shown::Shown;
use crate::assess::Assessment;
use crate::field::{Key, Section};
use crate::fields;
use crate::geometry::missing_for_ground;
use crate::note::Severity;
use crate::report::budget::key_of;
use crate::report::{ALONG_FLOOR, Tone};
use crate::sentences::{Phrase, shares};
use crate::unit::Unit;
use depth_core::angle::AngleUnit;
use depth_core::camera::GroundSolution;
use depth_core::judge::Term;
use depth_core::measured::Measured;
use depth_core::quantity::Length;

/// The fields of the ground plane and of the camera that looks at it.
const KEYS: [Key; 9] = [
    fields::FOCAL_LENGTH,
    fields::FY,
    fields::CX,
    fields::CY,
    fields::CAMERA_HEIGHT,
    fields::CAMERA_PITCH,
    fields::FLOOR_COLUMN,
    fields::FLOOR_ROW,
    fields::TARGET_HEIGHT,
];

pub(super) fn cells(shown: &Shown<'_>) -> [Cell; 3] {
    let has_target = shown
        .assessment
        .reading(fields::TARGET_HEIGHT)
        .is_some_and(|reading| reading.value != 0.0);
    let height = if has_target { "(H − h)" } else { "H" };
    let cell = |title: &str, formula: String| Cell {
        title: title.to_owned(),
        tone: Tone::Neutral,
        formula,
        ..Cell::default()
    };
    let Some(ground) = shown.assessment.geometry.ground else {
        let titles = [
            ("Straight ahead", format!("{height} / tan(θ + α)")),
            ("To the right", "depth · (u − cx) / fx".to_owned()),
            (ALONG_FLOOR, String::new()),
        ];
        let mut cells = titles.map(|(title, formula)| without(shown, cell(title, formula)));
        // What is missing is said once, and once more where it is for another reason.
        for later in cells.iter_mut().skip(1) {
            later.lines = Default::default();
            later.remarks.clear();
        }
        return cells;
    };
    let [ahead, right] = names(&ground);
    [
        straight_ahead(shown, &ground, cell(ahead, format!("{height} / tan(θ + α)"))),
        to_the_right(shown, &ground, cell(right, "depth · (u − cx) / fx".to_owned())),
        along(
            shown,
            &ground,
            cell(
                ALONG_FLOOR,
                if ground.right.is_some() {
                    "√(ahead² + right²)".to_owned()
                } else {
                    String::new()
                },
            ),
        ),
    ]
}

/// "Straight ahead" and "To the right", or behind and to the left.
fn names(ground: &GroundSolution) -> [&'static str; 2] {
    let is_behind = ground.ahead.value.m() < 0.0;
    let is_left = ground.right.is_some_and(|right| right.value.m() < 0.0);
    [
        if is_behind { "Straight behind" } else { "Straight ahead" },
        if is_left { "To the left" } else { "To the right" },
    ]
}

/// Without a sign: that is in the name.
fn positive(length: Measured<Length>) -> Measured<Length> {
    Measured::new(Length::from_m(length.value.m().abs()), length.sigma)
}

fn straight_ahead(shown: &Shown<'_>, ground: &GroundSolution, cell: Cell) -> Cell {
    let &Shown { assessment, unit, .. } = shown;
    let alpha = Unit::DEGREE.behind(&STYLE.readable(ground.below_axis.in_unit(AngleUnit::Degree), 4));
    let solved = [("α", alpha)];
    let line = numbers(&cell.formula, &KEYS, assessment, unit, &solved).unwrap_or_default();
    Cell {
        value: Value::length(positive(ground.ahead), unit),
        lines: [of_shares(ground.ahead_shares), line],
        ..cell
    }
}

fn to_the_right(shown: &Shown<'_>, ground: &GroundSolution, cell: Cell) -> Cell {
    let &Shown { assessment, unit, .. } = shown;
    let (Some(right), Some(aside)) = (ground.right, ground.aside) else {
        let mut missing = vec![fields::FLOOR_COLUMN, fields::CX, fields::FOCAL_LENGTH];
        missing.retain(|&key| shown.inputs.entry(key).is_blank());
        missing.sort();
        let value = if missing.is_empty() {
            Value::Nothing
        } else {
            Value::Needs(missing)
        };
        return Cell { value, ..cell };
    };
    let px = Unit::Pixel.behind(&STYLE.readable(aside.px(), 5));
    let depth = STYLE.length(Some(ground.depth.value), unit);
    // The difference is the same for both signs of a formula.
    let formula = "depth · aside / fx";
    let solved = [("depth", depth), ("aside", px)];
    let line = numbers(formula, &KEYS, assessment, unit, &solved).unwrap_or_default();
    Cell {
        value: Value::length(positive(right), unit),
        lines: [of_shares(ground.right_shares), line],
        ..cell
    }
}

fn along(shown: &Shown<'_>, ground: &GroundSolution, cell: Cell) -> Cell {
    let unit = shown.unit;
    let slant = Value::length(ground.slant, unit).text();
    let sides = ground.right.map(|right| {
        let unit = STYLE.unit_of(ground.distance.value, unit);
        let number = |length: Length| STYLE.number(Some(length.in_unit(unit).abs()));
        let sum = format!("√({}² + {}²) {}", number(ground.ahead.value), number(right.value), unit.symbol());
        Line::of(sum, &[])
    });
    Cell {
        tone: Tone::Combined,
        value: Value::length(ground.distance, unit),
        lines: [
            sides.unwrap_or_else(|| of_shares(ground.distance_shares)),
            Line::of(Phrase::SlantIs { length: slant }, &[]),
        ],
        ..cell
    }
}

/// "72 % from H, 28 % from θ", the two largest.
fn of_shares(parts: [(Term, f64); 4]) -> Line {
    let mut parts: Vec<(Term, f64)> = parts.into_iter().filter(|(_, share)| *share > 0.0).collect();
    parts.sort_by(|(_, a), (_, b)| b.total_cmp(a));
    let written = shares(&parts.iter().map(|(_, share)| *share).collect::<Vec<_>>());
    let keys: Vec<Key> = parts.iter().map(|(term, _)| key_of(*term)).collect();
    let texts = keys
        .iter()
        .zip(written)
        .take(2)
        .map(|(key, share)| Phrase::From { share, of: key.symbol }.to_string());
    let text = texts.collect::<Vec<_>>().join(", ");
    if text.is_empty() {
        Line::of(Phrase::TakenToBeExact, &[])
    } else {
        Line::of(text, &keys)
    }
}

/// A cell while there is no point on the floor.
fn without(shown: &Shown<'_>, cell: Cell) -> Cell {
    let &Shown {
        inputs,
        assessment,
        unit,
        was,
    } = shown;
    let is_of_ground = |key: Key| key.section == Some(Section::Ground) || KEYS.contains(&key);
    let was = was.and_then(|was| value(was, &cell, unit));
    if let Some(note) = refusal(assessment, is_of_ground) {
        return refused(cell, assessment, note, was);
    }
    let missing = missing_for_ground(|key| inputs.entry(key).is_blank());
    Cell {
        value: if missing.is_empty() {
            Value::Nothing
        } else {
            Value::Needs(missing)
        },
        ..cell
    }
}

fn value(was: &Assessment, cell: &Cell, unit: depth_core::quantity::LengthUnit) -> Option<Value> {
    let ground = was.geometry.ground?;
    let length = match cell.title.as_str() {
        ALONG_FLOOR => ground.distance,
        "To the right" => positive(ground.right?),
        _ => positive(ground.ahead),
    };
    Some(Value::length(length, unit))
}

/// The first error at a field that counts here.
pub(super) fn refusal(assessment: &Assessment, counts: impl Fn(Key) -> bool) -> Option<&crate::note::Note> {
    assessment
        .notes
        .iter()
        .find(|note| note.severity == Severity::Error && counts(note.key))
}
