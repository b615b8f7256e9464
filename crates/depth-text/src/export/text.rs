//! The text that *Copy Results* puts on the clipboard.

use super::answer::{self, remark};
use super::exporter::{Exporter, Results};
use crate::assess::Assessment;
use crate::form::Inputs;
use crate::names::Named as _;
use crate::report::{
    self, NONE, ONE_PIXEL, Row, WITHOUT_TILT, agreement, certainty, formula_with_numbers, length, one_pixel_range, point_origin,
};
use crate::sentences::Statement;
use crate::style::Style;
use depth_core::problem::Method;
use depth_core::quantity::LengthUnit;
use depth_core::setup::{Object, Pair};
use std::convert::Infallible;

const STYLE: Style = Style::WINDOW;

/// Plain text that can be pasted unedited: the answer in lines that can be quoted, what is behind it, a table with tabs, and where it
/// comes from.
#[derive(Clone, Copy, Debug)]
pub struct Text;

impl Exporter for Text {
    type Error = Infallible;

    fn export(&self, results: &Results<'_>) -> Result<String, Infallible> {
        let &Results {
            inputs,
            assessment,
            unit,
            provenance,
        } = results;
        let mut lines = answer::lines(results);
        if lines.is_empty() {
            lines.extend(assessment.missing.iter().map(|note| note.message()));
        }
        let details: Vec<String> = details(inputs, assessment, unit);
        if !details.is_empty() {
            lines.extend([String::new(), "Details".to_owned()]);
            lines.extend(details.into_iter().map(|line| format!("  {line}")));
        }
        lines.push(String::new());
        lines.extend(table(results));
        lines.extend([String::new(), provenance.line(", ")]);
        lines.extend((!provenance.link.is_empty()).then(|| provenance.link.to_owned()));
        lines.push(String::new());
        Ok(lines.join("\n"))
    }
}

/// How each answer came about, and what is to be said about it and about what was typed.
fn details(inputs: &Inputs, assessment: &Assessment, unit: LengthUnit) -> Vec<String> {
    let unknown = assessment.unknown.as_ref();
    let of_unknown = unknown.map_or_else(Vec::new, |unknown| {
        let remarks = report::remarks(assessment, unknown.method).into_iter().map(remark);
        remarks.collect()
    });
    let methods = Method::ALL.into_iter().flat_map(|method| of_method(assessment, method, unit));
    let suspects = agreement(assessment).into_iter().skip(1);
    let notes = assessment
        .notes
        .iter()
        .map(|note| format!("Note on {}: {}", note.key.name, note.issue));
    of_unknown
        .into_iter()
        .chain(methods)
        .chain(suspects)
        .chain(widths(assessment))
        .chain(geometry(assessment, unit))
        .chain(choices(inputs))
        .chain(notes)
        .collect()
}

/// What was chosen otherwise than usual: "Cameras: one above the other".
fn choices(inputs: &Inputs) -> impl Iterator<Item = String> {
    let pair = (inputs.pair != Pair::default()).then(|| format!("Cameras: {}", inputs.pair.name().to_ascii_lowercase()));
    let object = (inputs.object != Object::default()).then(|| format!("Measured: {}", inputs.object.name().to_ascii_lowercase()));
    pair.into_iter().chain(object)
}

/// The numbers behind the distance of `method`, and how sure it is.
fn of_method(assessment: &Assessment, method: Method, unit: LengthUnit) -> Vec<String> {
    let solution = &assessment.solution;
    let is_given = assessment.unknown.as_ref().is_some_and(|unknown| unknown.method == method);
    if is_given || assessment.distance(method).is_none() {
        return Vec::new();
    }
    let numbers = formula_with_numbers(assessment, method, unit);
    let one_pixel = one_pixel_range(solution, unit).filter(|_| method == Method::Stereo);
    let one_pixel = one_pixel.map(|range| format!("with {ONE_PIXEL}: {range}"));
    let uncertainty = solution.uncertainty(method).into_iter();
    let certainty = uncertainty.flat_map(|uncertainty| certainty(STYLE, assessment, uncertainty, unit));
    let facing = assessment.geometry.facing.filter(|_| method == Method::Monocular);
    let facing = facing.map(|facing| format!("{WITHOUT_TILT}: {}", length(Some(facing), unit)));
    let below = numbers
        .into_iter()
        .chain(report::remarks(assessment, method).into_iter().map(remark))
        .chain(one_pixel)
        .chain(facing)
        .chain(certainty)
        .map(|line| format!("  {line}"));
    std::iter::once(method.name().to_owned()).chain(below).collect()
}

/// Whether the widths that the distance predicts are those that were entered.
fn widths(assessment: &Assessment) -> Option<String> {
    let is_checked = assessment.solution.width_discrepancy().is_some();
    is_checked.then(|| Statement::widths(assessment).to_string())
}

/// The point in space, and what is to be said about two photographs.
fn geometry(assessment: &Assessment, unit: LengthUnit) -> Vec<String> {
    let geometry = &assessment.geometry;
    let mut lines = Vec::new();
    if let Some((origin, point)) = &geometry.point {
        lines.push(format!("Point in space, {}", point_origin(*origin)));
        let values = report::point(STYLE, &assessment.solution.problem, point, unit);
        lines.extend(values.map(|(name, value)| format!("  {name}: {value}")));
    }
    if let Some(shots) = &geometry.two_shots {
        lines.extend(report::shots_remarks(assessment, shots).into_iter().map(remark));
    }
    lines
}

/// The table, its cells apart by tabs, with numbers that a spreadsheet reads.
fn table(results: &Results<'_>) -> Vec<String> {
    let header = ["Parameter", "Value", "± 1 σ", "Unit", "Description"].join("\t");
    let rows = report::all_rows(results.inputs, results.assessment, results.unit);
    let line = |row: Row| {
        let value = number(&row.value);
        let sigma = row.sigma.as_deref().map_or_else(String::new, number);
        [row.parameter, value, sigma, row.symbol, row.description].join("\t")
    };
    // What was neither given nor found is no row to paste.
    let rows = rows.into_iter().filter(|row| row.value != NONE);
    std::iter::once(header).chain(rows.map(line)).collect()
}

/// A number without the signs of print.
fn number(text: &str) -> String {
    text.replace('\u{2009}', "").replace('−', "-")
}
