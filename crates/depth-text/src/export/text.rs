//! The text that *Copy Results* puts on the clipboard.

use super::exporter::{Exporter, Results};
use crate::assess::Assessment;
use crate::field::Key;
use crate::form::Inputs;
use crate::names::Named as _;
use crate::number::{exact, significant};
use crate::reading;
use crate::report::{
    COMBINED, DIGITS, ESTIMATED_WIDTH_M, ESTIMATED_WIDTH_PX, ONE_PIXEL, agreement, certainty, formula, length, one_pixel_range, with_sigma,
};
use crate::sentences::{Statement, capital, quoted};
use crate::style::Style;
use crate::unit::Unit;
use depth_core::problem::{Method, Solution};
use depth_core::quantity::LengthUnit;
use std::convert::Infallible;

const STYLE: Style = Style::WINDOW;

/// Lines of plain text: inputs as typed, results rounded in the unit chosen and with every digit.
#[derive(Clone, Copy, Debug)]
pub struct Text;

impl Exporter for Text {
    type Error = Infallible;

    fn export(&self, &Results { inputs, assessment, unit }: &Results<'_>) -> Result<String, Infallible> {
        let solution = &assessment.solution;
        let mut lines = vec!["Depth Calculator".to_owned(), String::new(), "Inputs".to_owned()];
        for key in Key::form().filter(|key| !key.is_optional || !inputs.entry(*key).is_blank()) {
            lines.push(format!("  {}: {}", key.name, input(inputs, assessment, key)));
        }
        lines.extend([String::new(), "Results".to_owned()]);
        let methods = Method::ALL.into_iter().flat_map(|method| of_method(solution, method, unit));
        let results = methods.chain(comparison(assessment, unit)).chain(widths(solution));
        lines.extend(results.map(|line| format!("  {line}")));
        for note in &assessment.notes {
            lines.push(format!("  Note on {}: {}", note.key.name, note.issue));
        }
        lines.push(String::new());
        Ok(lines.join("\n"))
    }
}

/// One input as typed, with its σ.
fn input(inputs: &Inputs, assessment: &Assessment, key: Key) -> String {
    let entry = inputs.entry(key);
    let is_used = key.input.is_none_or(|field| assessment.solution.problem.get(field).is_some());
    let mut value = match assessment.reading(key) {
        Some(reading) if is_used => reading.text(),
        None if is_used && key.input.is_some() => {
            // It was solved for; what is in the field did not count.
            format!("{} {}", entry.text.trim(), entry.chosen_unit(key).map_or("", Unit::symbol))
        }
        _ if entry.is_blank() => "not given".to_owned(),
        _ => format!("{} (not usable)", quoted(&entry.text)),
    };
    let sigma = reading::sigma_text(entry);
    if inputs.with_uncertainty && !sigma.is_empty() {
        value.push_str(&format!(" ± {sigma}"));
    }
    value
}

/// The distance of `method`, rounded and with every digit, and how sure it is.
fn of_method(solution: &Solution, method: Method, unit: LengthUnit) -> Vec<String> {
    let value = STYLE.distance(solution, method, unit);
    let mut line = format!("{} distance, {}: {value}", method.name(), formula(solution, method));
    if let Some(distance) = solution.outcome(method).distance() {
        line.push_str(&format!(" (unrounded {} {})", exact(distance.in_unit(unit)), unit.symbol()));
    }
    let one_pixel = one_pixel_range(solution, unit).filter(|_| method == Method::Stereo);
    let one_pixel = one_pixel.map(|range| format!("  with {ONE_PIXEL}: {range}"));
    let uncertainty = solution.uncertainty(method);
    let certainty = uncertainty.into_iter().flat_map(|uncertainty| certainty(STYLE, uncertainty, unit));
    let indented = certainty.map(|line| format!("  {line}"));
    std::iter::once(line).chain(one_pixel).chain(indented).collect()
}

/// What both distances say together.
fn comparison(assessment: &Assessment, unit: LengthUnit) -> Vec<String> {
    let combined = assessment.solution.comparison.and_then(|comparison| comparison.combined);
    let combined = combined.map(|combined| {
        let value = with_sigma(combined.value, combined.sigma, unit).text(unit);
        format!("{}: {value}", capital(COMBINED))
    });
    let agreement = agreement(assessment).into_iter().map(|line| format!("  {line}"));
    combined.into_iter().chain(agreement).collect()
}

/// The widths that the distance predicts.
fn widths(solution: &Solution) -> Vec<String> {
    let mut lines = Vec::new();
    if let Some(width) = solution.estimated_width_px {
        let (rounded, exact) = (significant(width.px(), DIGITS), exact(width.px()));
        lines.push(format!("{ESTIMATED_WIDTH_PX}: {rounded} px (unrounded {exact} px)"));
    }
    if let Some(width) = solution.estimated_width {
        let (rounded, exact) = (length(Some(width), LengthUnit::Meter), exact(width.m()));
        lines.push(format!("{ESTIMATED_WIDTH_M}: {rounded} (unrounded {exact} m)"));
    }
    if !lines.is_empty() {
        lines.push(format!("  {}", Statement::widths(solution)));
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
            "  Monocular distance, D = w_real · fx / w_img: –.– m",
        ] {
            assert!(report.lines().any(|candidate| candidate == line), "{line:?} is not in\n{report}");
        }
    }
}
