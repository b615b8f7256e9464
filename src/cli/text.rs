//! The answer for people, and for `head -1`: each distance starts its line with the number, the one to use first.

use super::ascii::in_sentence;
use crate::core::problem::Method;
use crate::core::quantity::LengthUnit;
use depth_text::assess::{Assessment, Unknown};
use depth_text::export::{Exporter, Results};
use depth_text::field::Key;
use depth_text::geometry::PointOrigin;
use depth_text::names::Named as _;
use depth_text::report::{self, ONE_PIXEL, PREDICTED_WIDTH_M, PREDICTED_WIDTH_PX, WITHOUT_TILT, agreement, certainty, formula};
use depth_text::sentences::Statement;
use depth_text::style::Style;
use std::convert::Infallible;

const STYLE: Style = Style::TERMINAL;

/// Lines with the lengths in the unit chosen, numbers in ASCII.
pub(super) struct Text;

impl Exporter for Text {
    type Error = Infallible;

    fn export(&self, &Results { assessment, unit, .. }: &Results<'_>) -> Result<String, Infallible> {
        let solution = &assessment.solution;
        let mut lines = Vec::new();
        if let Some(unknown) = &assessment.unknown {
            lines.extend(solved_for(unknown, unit));
        }
        let combined = solution.combined;
        if let Some(combined) = combined {
            lines.push(format!("{} ({})", STYLE.measured(combined, unit), Statement::Combined));
            lines.extend(indented(agreement(assessment)));
        }
        for method in Method::ALL {
            lines.extend(of_method(assessment, method, unit).unwrap_or_default());
        }
        if combined.is_none() {
            lines.extend(indented(agreement(assessment)));
        }
        lines.extend(widths(assessment, unit));
        if let Some((origin, point)) = &assessment.geometry.point {
            let depth = STYLE.measured(point.z, unit);
            let point = report::point(STYLE, point, unit).map(|(name, value)| format!("{name}: {value}"));
            // What was asked for with a range alone comes first.
            if *origin == PointOrigin::Range {
                lines.push(format!("{depth} ({})", report::DEPTH_OF_RANGE));
            } else {
                lines.push(format!("Point in space, {}", report::point_origin(*origin)));
            }
            lines.extend(indented(point.into()));
        }
        Ok(lines.into_iter().map(|line| in_sentence(&line) + "\n").collect())
    }
}

/// "35.00 px (the disparity)"
fn solved_for(unknown: &Unknown, unit: LengthUnit) -> Option<String> {
    let value = report::unknown(STYLE, unknown, unit)?;
    Some(format!("{value} ({})", Key::from(unknown.field).noun))
}

fn indented(lines: Vec<String>) -> impl Iterator<Item = String> {
    lines.into_iter().map(|line| format!("  {line}"))
}

/// The distance of `method`, how it was computed and how sure it is; `None` without one.
fn of_method(assessment: &Assessment, method: Method, unit: LengthUnit) -> Option<Vec<String>> {
    let solution = &assessment.solution;
    assessment.distance(method)?;
    let value = STYLE.distance(solution, method, unit);
    let mut below = Vec::new();
    if let Some(numbers) = STYLE.numbers_in_formula(assessment, method) {
        below.push(format!("{} = {numbers}", formula(solution, method)));
    }
    if let Some(uncertainty) = solution.uncertainty(method) {
        below.extend(certainty(STYLE, uncertainty, unit));
    }
    if method == Method::Stereo
        && let Some(range) = STYLE.one_pixel_range(solution, unit)
    {
        below.push(format!("{ONE_PIXEL}: {range}"));
    }
    if method == Method::Monocular
        && let Some(facing) = assessment.geometry.facing
    {
        below.push(format!("{WITHOUT_TILT}: {}", STYLE.length(Some(facing), unit)));
    }
    let first = format!("{value} ({})", method.name().to_lowercase());
    Some(std::iter::once(first).chain(indented(below)).collect())
}

/// What the stereo distance predicts from one width for the other. The monocular distance would only repeat both.
fn widths(assessment: &Assessment, unit: LengthUnit) -> Vec<String> {
    let solution = &assessment.solution;
    let mut lines = Vec::new();
    if solution.stereo.distance().is_none() {
        return lines;
    }
    if let Some(width) = solution.estimated_width_px {
        lines.push(format!("{PREDICTED_WIDTH_PX}: {} px", STYLE.number(Some(width.px()))));
    }
    if let Some(width) = solution.estimated_width {
        lines.push(format!("{PREDICTED_WIDTH_M}: {}", STYLE.length(Some(width), unit)));
    }
    if solution.width_discrepancy().is_some() {
        lines.push(format!("  {}", Statement::widths(assessment)));
    }
    lines
}
