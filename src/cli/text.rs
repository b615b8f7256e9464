//! The answer for people, and for `head -1`: each distance starts its line with the number, the one to use first.

use super::digits::{in_sentence, plain, rounded, significant};
use crate::core::agreement::Verdict;
use crate::core::problem::{Field, Method, Solution, Uncertainty};
use crate::core::quantity::{Length, LengthUnit};
use depth_text::assess::Assessment;
use depth_text::names::Named as _;
use depth_text::report;
use depth_text::sentences::Statement;

/// Significant digits of a number without σ.
const DIGITS: u8 = 4;
/// Of a number that stands as it was typed, at most.
const TYPED_DIGITS: u8 = 12;
/// Of a length that may have been typed in another unit: 120 mm are 4.7244094 in.
const CONVERTED_DIGITS: u8 = 8;

/// The answer with its lengths in `unit`, a line each.
pub(super) fn answer(assessment: &Assessment, unit: LengthUnit) -> String {
    let solution = &assessment.solution;
    let mut lines = Vec::new();
    // Two distances that contradict each other have nothing in between that could be right.
    let compatible = solution
        .comparison
        .as_ref()
        .filter(|comparison| comparison.agreement.verdict != Some(Verdict::Disagree));
    let combined = compatible.and_then(|comparison| comparison.combined);
    if let Some(combined) = combined {
        let value = with_sigma(combined.value, combined.sigma, unit);
        lines.push(format!("{value} (combined, the shared focal length accounted for)"));
        lines.extend(agreement(assessment));
    }
    for method in Method::ALL {
        lines.extend(of_method(solution, method, unit).unwrap_or_default());
    }
    if combined.is_none() {
        lines.extend(agreement(assessment));
    }
    lines.extend(widths(solution, unit));
    lines.into_iter().map(|line| in_sentence(&line) + "\n").collect()
}

/// The distance of `method`, how it was computed and how sure it is; `None` without one.
fn of_method(solution: &Solution, method: Method, unit: LengthUnit) -> Option<Vec<String>> {
    let distance = solution.outcome(method).distance()?;
    let known = solution.uncertainty(method);
    let value = known.map_or_else(|| length(distance, unit), |known| with_sigma(distance, known.sigma, unit));
    let mut lines = vec![format!("{value} ({})", method.name().to_lowercase())];
    if let Some(numbers) = formula_with_numbers(solution, method, unit) {
        lines.push(format!("  {} = {numbers}", report::formula(solution, method)));
    }
    if let Some(known) = known {
        lines.push(format!("  1 σ interval: {}", interval(known, unit)));
        lines.push(format!("  variance: {}", report::budget(known)));
        if !known.model.first_order_is_good() {
            lines.push(format!("  {}", Statement::FirstOrderIsPoor { has_simulation: false }));
        }
    }
    if method == Method::Stereo
        && let Some((near, far)) = solution.one_pixel_range()
    {
        let number = |length: Length| significant(length.in_unit(unit), DIGITS);
        lines.push(format!(
            "  one pixel of disparity more or less: {}",
            range(&number(near), far.map(number).as_deref(), unit)
        ));
    }
    Some(lines)
}

/// Whether both methods agree, and what to look at if not.
fn agreement(assessment: &Assessment) -> Vec<String> {
    let Some(comparison) = &assessment.solution.comparison else {
        return Vec::new();
    };
    let suspects = assessment.suspects();
    std::iter::once(Statement::agreement(&comparison.agreement))
        .chain(suspects.iter().map(Statement::suspect))
        .map(|sentence| format!("  {sentence}"))
        .collect()
}

/// What the stereo distance predicts from one width for the other. The monocular distance would only repeat both.
fn widths(solution: &Solution, unit: LengthUnit) -> Vec<String> {
    let mut lines = Vec::new();
    if solution.stereo.distance().is_none() {
        return lines;
    }
    if let Some(width) = solution.estimated_width_px {
        lines.push(format!(
            "Width in the image that the real width predicts: {} px",
            significant(width.px(), DIGITS)
        ));
    }
    if let Some(width) = solution.estimated_width {
        lines.push(format!("Real width that the width in the image predicts: {}", length(width, unit)));
    }
    if solution.width_discrepancy().is_some() {
        lines.push(format!("  {}", Statement::widths(solution)));
    }
    lines
}

/// The right side of the formula: "700 px · 0.1 m / 50 px".
fn formula_with_numbers(solution: &Solution, method: Method, unit: LengthUnit) -> Option<String> {
    let number = |field: Field| solution.problem.get(field);
    let px = |field: Field| Some(format!("{} px", plain(number(field)?, TYPED_DIGITS)));
    let length = |field: Field| {
        Some(format!(
            "{} {}",
            plain(Length::from_m(number(field)?).in_unit(unit), CONVERTED_DIGITS),
            unit.symbol()
        ))
    };
    let (first, second) = match method {
        Method::Stereo => (px(Field::FocalLength)?, length(Field::Baseline)?),
        Method::Monocular => (length(Field::RealWidth)?, px(Field::FocalLength)?),
    };
    let divisor = match (method, number(Field::Doffs)) {
        (Method::Monocular, _) => px(Field::ImageWidth)?,
        (Method::Stereo, None) => px(Field::Disparity)?,
        (Method::Stereo, Some(doffs)) => {
            let sign = if doffs < 0.0 { '-' } else { '+' };
            format!("({} {sign} {} px)", px(Field::Disparity)?, plain(doffs.abs(), TYPED_DIGITS))
        }
    };
    Some(format!("{first} · {second} / {divisor}"))
}

/// "1.400 m"
fn length(length: Length, unit: LengthUnit) -> String {
    format!("{} {}", significant(length.in_unit(unit), DIGITS), unit.symbol())
}

/// "1.400 ± 0.016 m": σ with two significant digits, the value with as many decimals.
fn with_sigma(length: Length, sigma: Length, unit: LengthUnit) -> String {
    let (value, sigma) = (length.in_unit(unit), sigma.in_unit(unit));
    let decimals = report::decimals_beside(value, sigma);
    format!("{} ± {} {}", rounded(value, decimals), significant(sigma, 2), unit.symbol())
}

/// The 1 σ interval, to the decimals of σ.
fn interval(known: &Uncertainty, unit: LengthUnit) -> String {
    let decimals = report::decimals_beside(known.model.depth().in_unit(unit), known.sigma.in_unit(unit));
    let number = |length: Length| rounded(length.in_unit(unit), decimals);
    range(&number(known.interval.near), known.interval.far.map(number).as_deref(), unit)
}

/// "1.384 to 1.416 m"
fn range(near: &str, far: Option<&str>, unit: LengthUnit) -> String {
    match far {
        Some(far) => format!("{near} to {far} {}", unit.symbol()),
        None => format!("{near} {} or more, without an upper bound", unit.symbol()),
    }
}
