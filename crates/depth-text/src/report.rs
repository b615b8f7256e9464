//! The results in words: lengths with their uncertainty, the formulas with their numbers, the table of parameters.
//! Where no [`Style`] is asked for it is that of the window.

use crate::assess::{Assessment, Unknown};
use crate::field::Key;
use crate::names::{self, Named};
use crate::number::{NO_NUMBER, plain};
use crate::sentences::Statement;
use crate::style::Style;
use crate::unit::Unit;
use depth_core::problem::{Field, Method, Solution, Uncertainty};
use depth_core::quantity::{Length, LengthUnit};

pub use crate::style::{DIGITS, NO_UPPER_BOUND, WithSigma};

const STYLE: Style = Style::WINDOW;

/// "1.400 m", or "–.– m" where there is none; see [`Style::length`].
pub fn length(length: Option<Length>, unit: LengthUnit) -> String {
    STYLE.length(length, unit)
}

/// [`length`] without the unit.
pub fn length_number(length: Option<Length>, unit: LengthUnit) -> String {
    STYLE.number(length.map(|length| length.in_unit(unit)))
}

/// "1.373 … 1.429 m"; see [`Style::range`].
pub fn range(near: Length, far: Option<Length>, unit: LengthUnit) -> String {
    STYLE.range(near, far, unit)
}

/// "1.373 … 1.429 m"; see [`Style::one_pixel_range`].
pub fn one_pixel_range(solution: &Solution, unit: LengthUnit) -> Option<String> {
    STYLE.one_pixel_range(solution, unit)
}

/// `length` and its `sigma` in `unit`; see [`Style::with_sigma`].
pub fn with_sigma(length: Length, sigma: Length, unit: LengthUnit) -> WithSigma {
    STYLE.with_sigma(length.in_unit(unit), sigma.in_unit(unit))
}

/// "1.384 … 1.416 m"; see [`Style::interval`].
pub fn interval(uncertainty: &Uncertainty, unit: LengthUnit) -> String {
    STYLE.interval(uncertainty, unit)
}

/// The formula of `method` with its symbols, with doffs where there is one.
pub const fn formula(solution: &Solution, method: Method) -> &'static str {
    names::formula(method, solution.problem.doffs.is_some())
}

/// The formula of `method` with the current numbers and its result in meters, or `None` while an input is missing:
/// "D = 700 px · 0.1 m / 50 px = 1.400 m".
pub fn formula_with_numbers(solution: &Solution, method: Method) -> Option<String> {
    let distance = solution.outcome(method).distance()?;
    let numbers = STYLE.numbers_in_formula(solution, method, LengthUnit::Meter)?;
    Some(format!("D = {numbers} = {}", length(Some(distance), LengthUnit::Meter)))
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
    let inputs = Key::form().filter(|key| !key.is_optional).filter_map(|key| {
        let value = solution.problem.get(key.input?);
        Some(Row {
            parameter: key.spec().name,
            value: value.map_or_else(|| NO_NUMBER.to_owned(), plain),
            unit: key.kind.base_unit().map_or("", Named::name),
            description: key.spec().description,
        })
    });
    let output = |parameter, value, unit: Unit, description| Row {
        parameter,
        value: STYLE.number(value),
        unit: unit.name(),
        description,
    };
    let meters = Unit::Length(LengthUnit::Meter);
    let outputs = [
        output(
            ESTIMATED_WIDTH_PX,
            solution.estimated_width_px.map(|width| width.px()),
            Unit::Pixel,
            "Width in the image that the real width and the distance predict",
        ),
        output(
            ESTIMATED_WIDTH_M,
            solution.estimated_width.map(Length::m),
            meters,
            "Real width that the width in the image and the distance predict",
        ),
        output(
            "Distance (stereo)",
            solution.stereo.distance().map(Length::m),
            meters,
            "Distance from disparity",
        ),
        output(
            "Distance (monocular)",
            solution.monocular.distance().map(Length::m),
            meters,
            "Distance from the object’s known width",
        ),
    ];
    inputs.chain(outputs).collect()
}

/// Name of w_real·fx/D.
pub const ESTIMATED_WIDTH_PX: &str = "Estimated object width (pixels)";
/// Name of w_img·D/fx.
pub const ESTIMATED_WIDTH_M: &str = "Estimated object width (meters)";
/// What w_real·fx/D is, where there is no table to explain its name.
pub const PREDICTED_WIDTH_PX: &str = "Width in the image that the real width predicts";
/// What w_img·D/fx is, where there is no table to explain its name.
pub const PREDICTED_WIDTH_M: &str = "Real width that the width in the image predicts";

/// The change that [`one_pixel_range`] is about.
pub const ONE_PIXEL: &str = "one pixel of disparity more or less";
/// What both distances combined are, where that has a line of its own.
pub const COMBINED_ESTIMATE: &str = "Combined estimate; the shared focal length is accounted for";
/// The same beside their value.
pub const COMBINED: &str = "combined, the shared focal length accounted for";

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

/// How sure the distance is that `uncertainty` belongs to, a line each: the interval, the shares, and whether ± σ misleads.
pub fn certainty(style: Style, uncertainty: &Uncertainty, unit: LengthUnit) -> Vec<String> {
    let mut lines = vec![
        format!("1 σ interval: {}", style.interval(uncertainty, unit)),
        format!("variance: {}", budget(uncertainty)),
    ];
    if !uncertainty.model.first_order_is_good() {
        let has_simulation = style.has_simulation;
        lines.push(Statement::FirstOrderIsPoor { has_simulation }.to_string());
    }
    lines
}

/// Whether both distances agree, and what to look at if not, a line each.
pub fn agreement(assessment: &Assessment) -> Vec<String> {
    let comparison = assessment.solution.comparison.iter();
    let agreement = comparison.map(|comparison| Statement::agreement(&comparison.agreement));
    let suspects = assessment.suspects();
    let statements = agreement.chain(suspects.iter().map(Statement::suspect));
    statements.map(|statement| statement.to_string()).collect()
}

/// What was solved for with its uncertainty, in `unit` (`None`: pixels), or what is lacking: "100.0 ± 1.2 mm".
pub fn unknown(unknown: &Unknown, unit: Option<LengthUnit>) -> String {
    let found = match &unknown.outcome {
        Ok(found) => found,
        Err(reason) => return reason.to_string(),
    };
    let unit = unit.map_or(Unit::Pixel, Unit::Length);
    let (value, sigma) = (unit.from_base(found.value), unit.from_base(found.sigma));
    if sigma == 0.0 {
        return format!("{} {}", STYLE.number(Some(value)), unit.symbol());
    }
    STYLE.with_sigma(value, sigma).text(unit)
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
            one_pixel_range(&assessment.solution, LengthUnit::Meter).as_deref(),
            Some("1.373 … 1.429 m")
        );
        assert_eq!(
            formula_with_numbers(&assessment.solution, Method::Stereo).as_deref(),
            Some("D = 700 px · 0.1 m / 50 px = 1.400 m")
        );
    }

    #[test]
    fn a_doffs_below_zero_is_subtracted() {
        let mut inputs = Example::CoffeeMug.inputs();
        inputs.entry_mut(Field::Disparity).text = "90".into();
        inputs.entry_mut(Field::Doffs).text = "-40".into();
        assert_eq!(
            formula_with_numbers(&inputs.assess().solution, Method::Stereo).as_deref(),
            Some("D = 700 px · 0.1 m / (90 px − 40 px) = 1.400 m")
        );
    }

    #[test]
    fn the_table_has_lengths_in_metres_whatever_was_typed() {
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
            one_pixel_range(&inputs.assess().solution, LengthUnit::Meter).as_deref(),
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
