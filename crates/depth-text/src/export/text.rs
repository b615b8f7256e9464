//! The text that *Copy Results* puts on the clipboard.

use super::exporter::{Exporter, Results};
use crate::assess::Assessment;
use crate::field::{Key, Section};
use crate::fields::DISTANCE;
use crate::form::Inputs;
use crate::names::Named as _;
use crate::note::{Part, Severity};
use crate::number::{exact, significant};
use crate::report::{
    self, DIGITS, ONE_PIXEL, WITHOUT_TILT, agreement, certainty, estimated_width_name, estimated_width_px_name, formula,
    formula_with_numbers, length, one_pixel_range, point_origin, unknown,
};
use crate::sentences::{Statement, capital, needs, quoted};
use crate::style::Style;
use depth_core::problem::Method;
use depth_core::quantity::LengthUnit;
use depth_core::setup::{Object, Pair};
use std::convert::Infallible;

const STYLE: Style = Style::WINDOW;

/// Lines of plain text: inputs as typed, results rounded in the unit chosen and with every digit.
#[derive(Clone, Copy, Debug)]
pub struct Text;

impl Exporter for Text {
    type Error = Infallible;

    fn export(&self, &Results { inputs, assessment, unit }: &Results<'_>) -> Result<String, Infallible> {
        let mut lines = vec!["Depth Calculator".to_owned(), String::new(), "Inputs".to_owned()];
        for key in Key::form().filter(|key| !key.is_optional || !inputs.entry(*key).is_blank()) {
            lines.push(format!("  {}: {}", inputs.worded(key).name, input(inputs, assessment, key)));
        }
        if assessment.unknown.is_some() {
            lines.push(format!("  {}: {}", DISTANCE.name, input(inputs, assessment, DISTANCE)));
        }
        lines.extend(choices(inputs).map(|choice| format!("  {choice}")));
        lines.extend([String::new(), "Results".to_owned()]);
        let methods = Method::ALL
            .into_iter()
            .flat_map(|method| of_method(inputs, assessment, method, unit));
        let unknown = assessment.unknown.as_ref();
        let of_unknown = unknown.map_or_else(Vec::new, |unknown| remarks(assessment, unknown.method));
        let results = solved_for(assessment, unit)
            .into_iter()
            .chain(of_unknown)
            .chain(methods)
            .chain(comparison(assessment, unit))
            .chain(widths(assessment, unit))
            .chain(geometry(assessment, unit));
        lines.extend(results.map(|line| format!("  {line}")));
        for note in &assessment.notes {
            lines.push(format!("  Note on {}: {}", note.key.name, note.issue));
        }
        lines.push(String::new());
        Ok(lines.join("\n"))
    }
}

/// What was chosen otherwise than usual: "Cameras: one above the other".
fn choices(inputs: &Inputs) -> impl Iterator<Item = String> {
    let pair = (inputs.pair != Pair::default()).then(|| format!("Cameras: {}", inputs.pair.name().to_lowercase()));
    let object = (inputs.object != Object::default()).then(|| format!("Measured: {}", inputs.object.name().to_lowercase()));
    pair.into_iter().chain(object)
}

/// One input as typed, with its σ.
fn input(inputs: &Inputs, assessment: &Assessment, key: Key) -> String {
    let entry = inputs.entry(key);
    let error = |part| {
        let mut notes = assessment.notes.iter().filter(|note| note.severity == Severity::Error);
        notes.any(|note| (note.key, note.part) == (key, part))
    };
    if assessment.is_solved_for(key) {
        return "solved for".to_owned();
    }
    let mut value = match assessment.reading(key) {
        Some(reading) if !error(Part::Value) => reading.text(),
        _ if entry.is_blank() => "not given".to_owned(),
        _ => format!("{} (not usable)", quoted(&entry.text)),
    };
    let sigma = entry.sigma_text();
    if inputs.counts_sigma(key) && !sigma.is_empty() {
        value.push_str(&format!(" ± {sigma}"));
        if error(Part::Sigma) {
            value.push_str(" (not usable)");
        }
    }
    value
}

/// What was solved for.
fn solved_for(assessment: &Assessment, unit: LengthUnit) -> Option<String> {
    let solved = assessment.unknown.as_ref()?;
    let name = assessment.worded(solved.field).name;
    let value = unknown(STYLE, solved, unit).or_else(|| report::why_unsolved(assessment, solved))?;
    Some(format!("{name} of the {} distance: {value}", solved.method.name().to_lowercase()))
}

/// Why there is no distance of `method` though its fields are filled in: what is wrong is said among the notes.
fn refused(assessment: &Assessment, method: Method) -> Option<String> {
    let key = assessment.refusal(method)?.key;
    Some(Statement::SeeNote { key }.to_string())
}

/// The distance of `method`, rounded and with every digit, and how sure it is; or why there is none, if it was asked for.
fn of_method(inputs: &Inputs, assessment: &Assessment, method: Method, unit: LengthUnit) -> Vec<String> {
    let solution = &assessment.solution;
    let name = format!("{} distance, {}", method.name(), formula(solution, method));
    if assessment.unknown.as_ref().is_some_and(|unknown| unknown.method == method) {
        // Its distance was given.
        return Vec::new();
    }
    let Some(distance) = assessment.distance(method) else {
        let why = refused(assessment, method).unwrap_or_else(|| needs(&inputs.missing_for(method)));
        let is_asked_for = inputs.is_begun(method) && !why.is_empty();
        return is_asked_for.then(|| format!("{name}: {why}")).into_iter().collect();
    };
    let value = STYLE.distance(solution, method, unit);
    let unrounded = STYLE.unit_of(distance, unit);
    let line = format!(
        "{name}: {value} (unrounded {} {})",
        exact(distance.in_unit(unrounded)),
        unrounded.symbol()
    );
    let numbers = formula_with_numbers(assessment, method, unit).map(|numbers| format!("  {numbers}"));
    let one_pixel = one_pixel_range(solution, unit).filter(|_| method == Method::Stereo);
    let one_pixel = one_pixel.map(|range| format!("  with {ONE_PIXEL}: {range}"));
    let uncertainty = solution.uncertainty(method);
    let certainty = uncertainty
        .into_iter()
        .flat_map(|uncertainty| certainty(STYLE, assessment, uncertainty, unit));
    let facing = assessment.geometry.facing.filter(|_| method == Method::Monocular);
    let facing = facing.map(|facing| format!("  {WITHOUT_TILT}: {}", length(Some(facing), unit)));
    let indented = certainty.map(|line| format!("  {line}"));
    let below = numbers
        .into_iter()
        .chain(remarks(assessment, method))
        .chain(one_pixel)
        .chain(facing)
        .chain(indented);
    std::iter::once(line).chain(below).collect()
}

/// What is to be said about the distance of `method`, given or computed.
fn remarks(assessment: &Assessment, method: Method) -> Vec<String> {
    let remarks = report::remarks(assessment, method).into_iter();
    remarks.map(|remark| format!("  {}", capital(&remark.to_string()))).collect()
}

/// The point in space and the point on the floor.
fn geometry(assessment: &Assessment, unit: LengthUnit) -> Vec<String> {
    let geometry = &assessment.geometry;
    let mut lines = Vec::new();
    let indented = |(name, value): (&'static str, String)| format!("  {name}: {value}");
    if let Some((origin, point)) = &geometry.point {
        lines.push(format!("Point in space, {}", point_origin(*origin)));
        lines.extend(report::point(STYLE, &assessment.solution.problem, point, unit).map(indented));
    }
    if let Some(ground) = &geometry.ground {
        lines.push("Ground plane".to_owned());
        lines.extend(report::ground(STYLE, ground, unit).into_iter().map(indented));
    }
    if let Some(shots) = &geometry.two_shots {
        lines.push(Section::TwoShots.name().to_owned());
        lines.extend(report::two_shots(STYLE, &shots.solution, unit).into_iter().map(indented));
        lines.extend(
            report::shots_remarks(assessment, shots)
                .into_iter()
                .map(|remark| format!("  {remark}")),
        );
    }
    if let Some(points) = &geometry.two_points {
        lines.push(Section::TwoPoints.name().to_owned());
        lines.extend(report::two_points(STYLE, points, unit).map(indented));
    }
    lines
}

/// What both distances say together.
fn comparison(assessment: &Assessment, unit: LengthUnit) -> Vec<String> {
    let combined = assessment.solution.combined;
    let combined = combined.map(|combined| format!("{}: {}", capital(&Statement::Combined.to_string()), STYLE.measured(combined, unit)));
    let agreement = agreement(assessment).into_iter().map(|line| format!("  {line}"));
    combined.into_iter().chain(agreement).collect()
}

/// The widths that the distance predicts.
fn widths(assessment: &Assessment, unit: LengthUnit) -> Vec<String> {
    let solution = &assessment.solution;
    let object = solution.problem.object;
    let mut lines = Vec::new();
    if let Some(width) = solution.estimated_width_px {
        let (rounded, exact) = (significant(width.px(), DIGITS), exact(width.px()));
        lines.push(format!("{}: {rounded} px (unrounded {exact} px)", estimated_width_px_name(object)));
    }
    if let Some(width) = solution.estimated_width {
        let unit = STYLE.unit_of(width, unit);
        let (rounded, exact) = (length(Some(width), unit), exact(width.in_unit(unit)));
        lines.push(format!(
            "{}: {rounded} (unrounded {exact} {})",
            estimated_width_name(object, unit),
            unit.symbol()
        ));
    }
    if !lines.is_empty() {
        lines.push(format!("  {}", Statement::widths(assessment)));
    }
    lines
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::form::Example;

    #[test]
    fn the_mug_reads_as_in_the_specification() {
        let inputs = Example::CoffeeMug.inputs();
        let Ok(report) = Text.export(&Results {
            inputs: &inputs,
            assessment: &inputs.assess(),
            unit: LengthUnit::Meter,
        });
        for line in [
            "  Camera baseline (b): 10 cm",
            "  Stereo distance, D = fx · b / d: 1.400 m (unrounded 1.4 m)",
            "    with one pixel of disparity more or less: 1.373 … 1.429 m",
        ] {
            assert!(report.lines().any(|candidate| candidate == line), "{line:?} is not in\n{report}");
        }
        assert!(!report.contains("Monocular"), "nobody asked for it:\n{report}");
    }
}
