//! The results in words: lengths with their uncertainty, the formulas with their numbers, the table of parameters.

use crate::assess::Unknown;
use crate::field::Key;
use crate::number::{self, NO_NUMBER, plain, significant};
use crate::sentences::Statement;
use depth_core::problem::{Field, Method, Solution, Uncertainty};
use depth_core::quantity::{Length, LengthUnit};

/// Significant digits of a result on the screen.
pub const DIGITS: usize = 4;

/// `length` in `unit` with four significant digits and its unit: "1.400 m", or "–.– m" where there is none.
pub fn length(length: Option<Length>, unit: LengthUnit) -> String {
    format!("{} {}", length_number(length, unit), unit.symbol())
}

/// [`length`] without the unit.
pub fn length_number(length: Option<Length>, unit: LengthUnit) -> String {
    length.map_or_else(|| NO_NUMBER.to_owned(), |length| significant(length.in_unit(unit), DIGITS))
}

/// What one pixel of disparity more or less makes of the stereo distance: "1.373 … 1.429 m".
pub fn one_pixel_around(solution: &Solution, unit: LengthUnit) -> Option<String> {
    let (near, far) = solution.one_pixel_range()?;
    let near = length_number(Some(near), unit);
    Some(match far {
        Some(far) => format!("{near} … {}", length(Some(far), unit)),
        None => format!("{near} {} … no upper bound", unit.symbol()),
    })
}

/// The formula of `method` with its symbols, with doffs where there is one.
pub fn formula(solution: &Solution, method: Method) -> &'static str {
    match (method, solution.problem.doffs) {
        (Method::Stereo, Some(_)) => "D = fx · b / (d + doffs)",
        _ => method.formula(),
    }
}

/// The formula of `method` with the current numbers and its result in meters, or `None` while an input is missing:
/// "D = 700 px · 0.1 m / 50 px = 1.400 m".
pub fn formula_with_numbers(solution: &Solution, method: Method) -> Option<String> {
    let distance = solution.outcome(method).distance()?;
    let value = |field: Field| {
        let unit = if Key::from(field).is_length() { "m" } else { "px" };
        solution.problem.get(field).map(|value| format!("{} {unit}", plain(value)))
    };
    let (first, second, divisor) = match method {
        Method::Stereo => (Field::FocalLength, Field::Baseline, Field::Disparity),
        Method::Monocular => (Field::RealWidth, Field::FocalLength, Field::ImageWidth),
    };
    let divisor = match (method, value(Field::Doffs)) {
        (Method::Stereo, Some(doffs)) => format!("({} + {doffs})", value(divisor)?),
        _ => value(divisor)?,
    };
    Some(format!(
        "D = {} · {} / {divisor} = {}",
        value(first)?,
        value(second)?,
        length(Some(distance), LengthUnit::Meter)
    ))
}

/// One row of the table "Key input parameters and outputs".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// What it is.
    pub parameter: &'static str,
    /// Its value in [`unit`](Self::unit), or [`NO_NUMBER`].
    pub value: String,
    /// "pixels" or "meters".
    pub unit: &'static str,
    /// What it means.
    pub description: &'static str,
}

/// The rows of the table: the inputs that everybody has, then what follows; lengths in meters whatever unit was typed.
pub fn parameter_rows(solution: &Solution) -> Vec<Row> {
    const PIXELS: &str = "pixels";
    const METERS: &str = "meters";
    let inputs = Key::form().filter(|key| !key.is_optional).filter_map(|key| {
        let value = solution.problem.get(key.input?);
        Some(Row {
            parameter: key.spec().name,
            value: value.map_or_else(|| NO_NUMBER.to_owned(), plain),
            unit: key.kind.base_unit(),
            description: key.spec().description,
        })
    });
    let output = |parameter, value: Option<f64>, unit, description| Row {
        parameter,
        value: value.map_or_else(|| NO_NUMBER.to_owned(), |value| significant(value, DIGITS)),
        unit,
        description,
    };
    let outputs = [
        output(
            ESTIMATED_WIDTH_PX,
            solution.estimated_width_px.map(|width| width.px()),
            PIXELS,
            "Width in the image that the real width and the distance predict",
        ),
        output(
            ESTIMATED_WIDTH_M,
            solution.estimated_width.map(Length::m),
            METERS,
            "Real width that the width in the image and the distance predict",
        ),
        output(
            "Distance (stereo)",
            solution.stereo.distance().map(Length::m),
            METERS,
            "Distance from disparity",
        ),
        output(
            "Distance (monocular)",
            solution.monocular.distance().map(Length::m),
            METERS,
            "Distance from the object’s known width",
        ),
    ];
    inputs.chain(outputs).collect()
}

/// Name of w_real·fx/D.
pub const ESTIMATED_WIDTH_PX: &str = "Estimated object width (pixels)";
/// Name of w_img·D/fx.
pub const ESTIMATED_WIDTH_M: &str = "Estimated object width (meters)";

/// A value and its σ, written to the same decimal.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct WithSigma {
    /// The value.
    pub value: String,
    /// Its σ with two significant digits.
    pub sigma: String,
}

impl WithSigma {
    /// "1.400 ± 0.016 m".
    pub fn text(&self, unit: LengthUnit) -> String {
        format!("{} ± {} {}", self.value, self.sigma, unit.symbol())
    }
}

/// `length` and its `sigma` in `unit`: σ with two significant digits, the value with as many decimals.
pub fn with_sigma(length: Length, sigma: Length, unit: LengthUnit) -> WithSigma {
    let (value, sigma) = (length.in_unit(unit), sigma.in_unit(unit));
    let decimals = decimals_beside(value, sigma);
    WithSigma {
        value: number::to_decimals(value, decimals),
        sigma: significant(sigma, 2),
    }
}

/// The 1 σ interval, to the decimals of σ: "1.384 … 1.416 m".
pub fn interval(uncertainty: &Uncertainty, unit: LengthUnit) -> String {
    let decimals = decimals_beside(uncertainty.model.depth().in_unit(unit), uncertainty.sigma.in_unit(unit));
    let end = |length: Length| number::to_decimals(length.in_unit(unit), decimals);
    let near = end(uncertainty.interval.near);
    match uncertainty.interval.far {
        Some(far) => format!("{near} … {} {}", end(far), unit.symbol()),
        None => format!("{near} {} … no upper bound", unit.symbol()),
    }
}

/// The decimals that show two digits of `sigma`, and at least two of `value`.
pub fn decimals_beside(value: f64, sigma: f64) -> i32 {
    (1 - number::magnitude(sigma)).max(1 - number::magnitude(value))
}

/// Where the variance comes from: "disparity 75 %, baseline 19 %, focal length 6 %", the largest first.
pub fn budget(uncertainty: &Uncertainty) -> String {
    let mut shares = uncertainty.budget.to_vec();
    shares.sort_by(|a, b| b.share.total_cmp(&a.share));
    shares
        .iter()
        .filter(|share| share.share > 0.0)
        .map(|share| format!("{} {}", short_name(share.source), percent(share.share)))
        .collect::<Vec<_>>()
        .join(", ")
}

/// The input behind most of the variance: "mostly from disparity (75 %)".
pub fn main_cause(uncertainty: &Uncertainty) -> Option<String> {
    let share = uncertainty.main_cause()?;
    let how = if share.share >= 0.5 { "mostly" } else { "most of it" };
    Some(format!("{how} from {} ({})", short_name(share.source), percent(share.share)))
}

/// A field in the middle of a sentence about causes: "disparity".
pub fn short_name(field: Field) -> &'static str {
    Key::from(field).spec().noun.trim_start_matches("the ")
}

/// A share of a whole, "75 %".
pub fn percent(share: f64) -> String {
    let percent = share * 100.0;
    if percent > 0.0 && percent < 0.5 {
        "under 1 %".to_owned()
    } else {
        format!("{percent:.0} %")
    }
}

/// What is said where σ alone would mislead.
pub const FIRST_ORDER_IS_POOR: Statement = Statement::FirstOrderIsPoor { has_simulation: true };

/// What was solved for with its uncertainty, in `unit` (`None`: pixels), or what is lacking: "100.0 ± 1.2 mm".
pub fn unknown(unknown: &Unknown, unit: Option<LengthUnit>) -> String {
    let found = match &unknown.outcome {
        Ok(found) => found,
        Err(reason) => return reason.to_string(),
    };
    let in_unit = |base: f64| unit.map_or(base, |unit| Length::from_m(base).in_unit(unit));
    let symbol = unit.map_or("px", LengthUnit::symbol);
    let (value, sigma) = (in_unit(found.value), in_unit(found.sigma));
    if sigma == 0.0 {
        return format!("{} {symbol}", significant(value, DIGITS));
    }
    let decimals = decimals_beside(value, sigma);
    format!("{} ± {} {symbol}", number::to_decimals(value, decimals), significant(sigma, 2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::entry::Entry;
    use crate::form::Example;

    #[test]
    fn the_formula_of_the_mug_has_its_numbers() {
        let inputs = Example::CoffeeMug.inputs();
        let assessment = inputs.assess();
        assert_eq!(
            one_pixel_around(&assessment.solution, LengthUnit::Meter).as_deref(),
            Some("1.373 … 1.429 m")
        );
        assert_eq!(
            formula_with_numbers(&assessment.solution, Method::Stereo).as_deref(),
            Some("D = 700 px · 0.1 m / 50 px = 1.400 m")
        );
    }

    #[test]
    fn the_table_has_lengths_in_meters_whatever_was_typed() {
        let rows = parameter_rows(&Example::CoffeeMug.inputs().assess().solution);
        let values: Vec<_> = rows.iter().map(|row| (row.value.as_str(), row.unit)).collect();
        assert_eq!(
            values.get(..4),
            Some(&[("700", "pixels"), ("0.1", "meters"), ("50", "pixels"), (NO_NUMBER, "pixels")][..])
        );
    }

    #[test]
    fn at_one_pixel_of_disparity_the_far_end_has_no_bound() {
        let mut inputs = Example::CoffeeMug.inputs();
        *inputs.entry_mut(Field::Disparity) = Entry::new("1", None);
        assert_eq!(
            one_pixel_around(&inputs.assess().solution, LengthUnit::Meter).as_deref(),
            Some("35.00 m … no upper bound")
        );
    }

    #[test]
    fn the_widths_are_a_check_only_against_the_stereo_distance() {
        let mut inputs = Example::CoffeeMug.inputs();
        inputs.entry_mut(Field::ImageWidth).text = "165".into();
        inputs.entry_mut(Field::RealWidth).text = "0.3".into();
        let solution = inputs.assess().solution;
        assert_eq!(solution.estimated_width_px.map(|w| w.px().round()), Some(150.0));
        assert!(
            Statement::widths(&solution).to_string().contains("10 % larger"),
            "{}",
            Statement::widths(&solution)
        );
        assert!(
            Statement::widths(&Example::Doorway.inputs().assess().solution)
                .to_string()
                .contains("only repeat")
        );
    }
}
