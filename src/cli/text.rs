//! The answer for people, and for `head -1`: each distance starts its line with the number, the one to use first.

use super::ascii::in_sentence;
use crate::core::problem::Method;
use crate::core::quantity::LengthUnit;
use depth_text::assess::{Assessment, Unknown};
use depth_text::export::{Exporter, Results};
use depth_text::geometry::PointOrigin;
use depth_text::names::Named as _;
use depth_text::report::{self, ONE_PIXEL, WITHOUT_TILT, agreement, certainty, formula};
use depth_text::sentences::Statement;
use depth_text::style::Style;
use std::convert::Infallible;

/// Lines with the lengths in the unit chosen, numbers without the signs of print.
pub(super) struct Text {
    pub(super) style: Style,
}

impl Exporter for Text {
    type Error = Infallible;

    fn export(&self, &Results { assessment, unit, .. }: &Results<'_>) -> Result<String, Infallible> {
        let solution = &assessment.solution;
        let style = self.style;
        let mut lines = Vec::new();
        if let Some(unknown) = &assessment.unknown {
            lines.extend(solved_for(style, assessment, unknown, unit));
            lines.extend(indented(remarks(assessment, unknown.method)));
        }
        let combined = solution.combined;
        if let Some(combined) = combined {
            lines.push(format!("{} ({})", style.measured(combined, unit), Statement::Combined));
            lines.extend(indented(agreement(assessment)));
        }
        for method in Method::ALL {
            lines.extend(of_method(style, assessment, method, unit).unwrap_or_default());
        }
        if combined.is_none() {
            lines.extend(indented(agreement(assessment)));
        }
        lines.extend(widths(style, assessment, unit));
        if let Some((origin, point)) = &assessment.geometry.point {
            let depth = style.measured(point.z, unit);
            let point = report::point(style, &solution.problem, point, unit).map(|(name, value)| format!("{name}: {value}"));
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
fn solved_for(style: Style, assessment: &Assessment, unknown: &Unknown, unit: LengthUnit) -> Option<String> {
    let value = report::unknown(style, unknown, unit)?;
    Some(format!("{value} ({})", assessment.worded(unknown.field).noun))
}

fn remarks(assessment: &Assessment, method: Method) -> Vec<String> {
    let remarks = report::remarks(assessment, method);
    remarks.iter().map(Statement::to_string).collect()
}

fn indented(lines: Vec<String>) -> impl Iterator<Item = String> {
    lines.into_iter().map(|line| format!("  {line}"))
}

/// The distance of `method`, how it was computed and how sure it is; `None` without one.
fn of_method(style: Style, assessment: &Assessment, method: Method, unit: LengthUnit) -> Option<Vec<String>> {
    let solution = &assessment.solution;
    assessment.distance(method)?;
    let value = style.distance(solution, method, unit);
    let mut below = Vec::new();
    if let Some(numbers) = style.numbers_in_formula(assessment, method) {
        below.push(format!("{} = {numbers}", formula(solution, method)));
    }
    below.extend(remarks(assessment, method));
    if let Some(uncertainty) = solution.uncertainty(method) {
        below.extend(certainty(style, assessment, uncertainty, unit));
    }
    if method == Method::Stereo
        && let Some(range) = style.one_pixel_range(solution, unit)
    {
        below.push(format!("{ONE_PIXEL}: {range}"));
    }
    if method == Method::Monocular
        && let Some(facing) = assessment.geometry.facing
    {
        below.push(format!("{WITHOUT_TILT}: {}", style.length(Some(facing), unit)));
    }
    let first = format!("{value} ({})", method.name().to_ascii_lowercase());
    Some(std::iter::once(first).chain(indented(below)).collect())
}

/// What the stereo distance predicts from one width for the other. The monocular distance would only repeat both.
fn widths(style: Style, assessment: &Assessment, unit: LengthUnit) -> Vec<String> {
    let solution = &assessment.solution;
    let mut lines = Vec::new();
    if solution.stereo.distance().is_none() {
        return lines;
    }
    let [in_image, real] = report::predicted(solution.problem.object);
    if let Some(width) = solution.estimated_width_px {
        lines.push(format!("{in_image}: {} px", style.number(Some(width.px()))));
    }
    if let Some(width) = solution.estimated_width {
        lines.push(format!("{real}: {}", style.length(Some(width), unit)));
    }
    if solution.width_discrepancy().is_some() {
        lines.push(format!("  {}", Statement::widths(assessment)));
    }
    lines
}
