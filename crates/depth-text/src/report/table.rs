//! The rows of the table "Key input parameters and outputs".

use super::{COMBINED_DISTANCE, Tone, distance_name, estimated_width_name, estimated_width_px_name};
use crate::assess::Assessment;
use crate::field::Key;
use crate::fields::{DISTANCE, TARGET_HEIGHT};
use crate::form::Inputs;
use crate::names::{self, Named as _};
use crate::sentences::{Description, quoted};
use crate::style::Style;
use crate::unit::Unit;
use depth_core::in_image::InImage;
use depth_core::measured::Measured;
use depth_core::problem::{Field, Method, Solved};
use depth_core::quantity::{Length, LengthUnit};

const STYLE: Style = Style::WINDOW;

/// What stands in a table where there is no number.
pub const NONE: &str = "–";

/// The heading above what follows from the inputs.
pub const INTERMEDIATE: &str = "Intermediate values";

/// One row of the table "Key input parameters and outputs".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// The input that it is; `None` for what follows.
    pub key: Option<Key>,
    /// What it is called everywhere: "Focal length (fx)".
    pub parameter: String,
    /// The same without its symbol, where that stands behind it: "Focal length". Of what follows all of it.
    pub label: String,
    /// Its symbol: "fx"; empty where there is none.
    pub parameter_symbol: &'static str,
    /// Its value in [`unit`](Self::unit), or [`NONE`]: of inputs as typed.
    pub value: String,
    /// Its σ in the same unit: of inputs as typed, else with two digits, to the last decimal of the value.
    pub sigma: Option<String>,
    /// "pixels" or "meters".
    pub unit: String,
    /// "px" or "m", where there is no room for that.
    pub symbol: String,
    /// What it means, in a few words.
    pub description: String,
    /// Which method it belongs to.
    pub tone: Tone,
    /// The heading above it, where a group begins: "Intermediate values".
    pub heading: Option<&'static str>,
}

/// The rows of the table: the inputs that everybody has as they were typed, then what follows, its lengths in `unit`: nine, and the
/// combined distance.
pub fn parameter_rows(assessment: &Assessment, unit: LengthUnit) -> Vec<Row> {
    let inputs = Key::form().filter(|key| !key.is_optional);
    inputs
        .map(|key| row_of(assessment, key, unit))
        .chain(output_rows(assessment, unit))
        .collect()
}

/// [`parameter_rows`] and between them every other field with something in it, the distance where it was given, and what cannot be read
/// as it was typed.
pub fn all_rows(inputs: &Inputs, assessment: &Assessment, unit: LengthUnit) -> Vec<Row> {
    let given = assessment.unknown.is_some().then_some(DISTANCE);
    let keys = Key::form().filter(|key| !key.is_optional || !inputs.entry(*key).is_blank());
    let rows = keys.chain(given).map(|key| typed_row(inputs, assessment, key, unit));
    rows.chain(output_rows(assessment, unit)).collect()
}

/// The input `key`; what cannot be read as it was typed.
pub(super) fn typed_row(inputs: &Inputs, assessment: &Assessment, key: Key, unit: LengthUnit) -> Row {
    let row = row_of(assessment, key, unit);
    if key == TARGET_HEIGHT && inputs.entry(key).is_blank() {
        // What holds while nothing is typed.
        return Row {
            value: "0".to_owned(),
            ..row
        };
    }
    let is_unreadable = row.value == NONE && !inputs.entry(key).is_blank() && !assessment.is_solved_for(key);
    if is_unreadable {
        let value = Description::Unusable(quoted(&inputs.entry(key).text)).to_string();
        Row { value, sigma: None, ..row }
    } else {
        row
    }
}

/// A value with its σ, as the cells of a row have it.
pub(super) struct Cells {
    value: String,
    sigma: Option<String>,
    unit: Option<Unit>,
}

impl Cells {
    pub(super) const fn none(unit: Option<Unit>) -> Self {
        Self {
            value: String::new(),
            sigma: None,
            unit,
        }
    }

    pub(super) fn of(measured: Measured<f64>, unit: Option<Unit>) -> Self {
        if measured.sigma > 0.0 {
            let written = STYLE.with_sigma(measured.value, measured.sigma);
            return Self {
                value: format!("{}{}", written.value, written.power),
                sigma: Some(format!("{}{}", written.sigma, written.power)),
                unit,
            };
        }
        Self {
            value: STYLE.number(Some(measured.value)),
            sigma: None,
            unit,
        }
    }

    pub(super) fn of_length(length: Option<Measured<Length>>, unit: LengthUnit) -> Self {
        let Some(length) = length else {
            return Self::none(Some(Unit::Length(unit)));
        };
        let unit = STYLE.unit_of(length.value, unit);
        let measured = Measured::new(length.value.in_unit(unit), length.sigma.in_unit(unit));
        Self::of(measured, Some(Unit::Length(unit)))
    }

    pub(super) fn row(self, parameter: &str, description: String) -> Row {
        let Self { value, sigma, unit } = self;
        Row {
            key: None,
            parameter: parameter.to_owned(),
            label: parameter.to_owned(),
            parameter_symbol: "",
            value: if value.is_empty() { NONE.to_owned() } else { value },
            sigma,
            unit: match unit {
                Some(square @ Unit::Square(_)) => square.to_string(),
                unit => unit.map_or("", Unit::name).to_owned(),
            },
            symbol: unit.map_or_else(String::new, |unit| unit.to_string()),
            description,
            tone: Tone::Neutral,
            heading: None,
        }
    }
}

/// The input `key` as it was typed, be it refused; where it was solved for the result, a length in `unit`.
pub(super) fn row_of(assessment: &Assessment, key: Key, unit: LengthUnit) -> Row {
    let words = assessment.worded(key);
    let cells = if assessment.is_solved_for(key) {
        let found = assessment.unknown.as_ref().and_then(|unknown| unknown.outcome.as_ref().ok());
        match found {
            Some(Solved::Length(length)) => Cells::of_length(Some(*length), unit),
            Some(Solved::InImage(InImage::OnSensor(length))) => Cells::of_length(Some(*length), LengthUnit::Millimeter),
            Some(found) => Cells::of(found.to_base(), key.kind.default_unit()),
            None => Cells::none(key.kind.default_unit()),
        }
    } else {
        match assessment.reading(key) {
            Some(reading) => Cells {
                value: STYLE.typed_number(reading),
                sigma: reading.sigma_text(),
                unit: reading.unit,
            },
            None => Cells::none(key.kind.default_unit()),
        }
    };
    Row {
        key: Some(words),
        label: words.label.to_owned(),
        parameter_symbol: words.symbol,
        tone: Tone::of(key),
        ..cells.row(words.name, Description::OfField(words).to_string())
    }
}

/// The sizes that the distance predicts, in pixels and as a length in `unit`. Where a stereo distance was begun and there is none, those
/// of the monocular one, which only repeat what was entered, would pass for a check.
fn widths(assessment: &Assessment, unit: LengthUnit) -> [Cells; 2] {
    let solution = &assessment.solution;
    let is_stereo = |key: Key| key == Field::Baseline || key == Field::Disparity;
    let mut begun = assessment
        .readings
        .iter()
        .map(|reading| reading.key)
        .chain(assessment.notes.iter().map(|note| note.key));
    if solution.stereo.distance().is_none() && begun.any(is_stereo) {
        return [Cells::none(Some(Unit::Pixel)), Cells::of_length(None, unit)];
    }
    let px = solution.estimated_width_px_with_sigma();
    let px = px.or(solution.estimated_width_px.map(Measured::exact)).map(Measured::to_base);
    let real = solution
        .estimated_width_with_sigma()
        .or(solution.estimated_width.map(Measured::exact));
    let px = px.map_or(Cells::none(Some(Unit::Pixel)), |px| Cells::of(px, Some(Unit::Pixel)));
    [px, Cells::of_length(real, unit)]
}

/// What follows from the inputs, its lengths in `unit`.
fn output_rows(assessment: &Assessment, unit: LengthUnit) -> impl Iterator<Item = Row> {
    let solution = &assessment.solution;
    let object = solution.problem.object;
    let [width_px, width] = widths(assessment, unit);
    let is_shown = !(width_px.value.is_empty() && width.value.is_empty());
    let [of_px, of_length] = Description::of_widths(assessment, is_shown);
    let distance = |method: Method| {
        let distance = solution.outcome(method).distance();
        let sigma = solution.uncertainty(method).map_or(Length::from_m(0.0), |known| known.sigma);
        let cells = Cells::of_length(distance.map(|distance| Measured::new(distance, sigma)), unit);
        let formula = names::formula(&solution.problem, method);
        Row {
            parameter_symbol: "D",
            tone: method.into(),
            ..cells.row(distance_name(method), formula.trim_start_matches("D = ").to_owned())
        }
    };
    let combined = Row {
        parameter_symbol: "D",
        tone: Tone::Combined,
        ..Cells::of_length(solution.combined, unit).row(COMBINED_DISTANCE, Description::of_combined(assessment).to_string())
    };
    [
        Row {
            heading: Some(INTERMEDIATE),
            ..width_px.row(estimated_width_px_name(object), of_px.to_string())
        },
        width.row(&estimated_width_name(object, unit), of_length.to_string()),
        distance(Method::Stereo),
        distance(Method::Monocular),
        combined,
    ]
    .into_iter()
}
