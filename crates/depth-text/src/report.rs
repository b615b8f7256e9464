//! The results in words: the table of parameters, the formulas with their numbers, and the text that *Copy Results* puts on
//! the clipboard.

use crate::inputs::{Assessment, Inputs, Unknown, capital};
use crate::number::{self, NO_NUMBER, exact, plain, significant};
use depth_core::agreement::{Agreement, Suspect, Verdict};
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

/// The formula of `method` with the current numbers and its result in metres, or `None` while an input is missing:
/// "D = 700 px · 0.1 m / 50 px = 1.400 m".
pub fn formula_with_numbers(solution: &Solution, method: Method) -> Option<String> {
    let distance = solution.outcome(method).distance()?;
    let value = |field: Field| {
        let unit = if field.is_length() { "m" } else { "px" };
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

/// How far the entered widths are off what the stereo distance predicts, in a sentence, or what would be needed to know.
pub fn width_check(solution: &Solution) -> String {
    match solution.width_discrepancy() {
        Some(off) if off.abs() < 0.0005 => {
            "Computed from the stereo distance, as a check: both widths agree with what you entered to within 0.1 %.".to_owned()
        }
        Some(off) => format!(
            "Computed from the stereo distance, as a check. The width you entered in the image is {} % {} than they predict; so is the real width.",
            significant(off.abs() * 100.0, 2),
            if off > 0.0 { "larger" } else { "smaller" },
        ),
        None if solution.stereo.distance().is_some() => {
            "Computed from the stereo distance. Enter both widths to check one method against the other.".to_owned()
        }
        None if solution.monocular.distance().is_some() => {
            "Without a stereo distance these only repeat what you entered. Enter a baseline and a disparity to make them a check."
                .to_owned()
        }
        None => "Computed from the stereo distance, as a check on the widths you entered.".to_owned(),
    }
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

/// The nine rows of the table; lengths in metres whatever unit was typed.
pub fn parameter_rows(solution: &Solution) -> [Row; 9] {
    const PIXELS: &str = "pixels";
    const METERS: &str = "meters";
    let input = |field: Field, description| Row {
        parameter: field.name(),
        value: solution.problem.get(field).map_or_else(|| NO_NUMBER.to_owned(), plain),
        unit: if field.is_length() { METERS } else { PIXELS },
        description,
    };
    let output = |parameter, value: Option<f64>, unit, description| Row {
        parameter,
        value: value.map_or_else(|| NO_NUMBER.to_owned(), |value| significant(value, DIGITS)),
        unit,
        description,
    };
    [
        input(Field::FocalLength, "Camera’s focal length"),
        input(Field::Baseline, "Distance between the two cameras"),
        input(Field::Disparity, "Horizontal pixel difference"),
        input(Field::ImageWidth, "Object’s width in the image"),
        input(Field::RealWidth, "Object’s actual physical width"),
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
    ]
}

/// Name of w_real·fx/D.
pub const ESTIMATED_WIDTH_PX: &str = "Estimated object width (pixels)";
/// Name of w_img·D/fx.
pub const ESTIMATED_WIDTH_M: &str = "Estimated object width (meters)";

/// The text for the clipboard: inputs as typed, results rounded in `unit` and with every digit.
pub fn report(inputs: &Inputs, assessment: &Assessment, unit: LengthUnit) -> String {
    let solution = &assessment.solution;
    let mut lines = vec!["Depth Calculator".to_owned(), String::new(), "Inputs".to_owned()];
    for field in Field::ALL {
        let entry = inputs.entry(field);
        if field == Field::Doffs && entry.is_blank() {
            continue;
        }
        let mut value = match solution.problem.get(field) {
            Some(_) => {
                let number = number::read(&entry.text).map_or(entry.text.trim(), |typed| typed.number_text);
                format!("{number} {}", inputs.unit(field).map_or("px", LengthUnit::symbol))
            }
            None if entry.is_blank() => "not given".to_owned(),
            None => format!("{} (not usable)", number::quoted(&entry.text)),
        };
        let sigma = inputs.sigma(field).trim();
        if inputs.with_uncertainty && !sigma.is_empty() {
            value.push_str(&format!(" ± {}", sigma.trim_start_matches('±').trim()));
        }
        lines.push(format!("  {}: {value}", field.name()));
    }
    lines.push(String::new());
    lines.push("Results".to_owned());
    lines.extend(results(assessment, unit).into_iter().map(|line| format!("  {line}")));
    for note in &assessment.notes {
        lines.push(format!("  Note on {}: {}", note.field.name(), note.message));
    }
    lines.push(String::new());
    lines.join("\n")
}

/// The results, a line each: rounded in `unit`, and with every digit.
fn results(assessment: &Assessment, unit: LengthUnit) -> Vec<String> {
    let solution = &assessment.solution;
    let mut lines = Vec::new();
    for method in Method::ALL {
        let distance = solution.outcome(method).distance();
        let known = solution.uncertainty(method);
        let value = match (distance, known) {
            (Some(distance), Some(known)) => with_sigma(distance, known.sigma, unit).text(unit),
            _ => length(distance, unit),
        };
        let mut line = format!("{} distance, {}: {value}", method.name(), formula(solution, method));
        if let Some(distance) = distance {
            line.push_str(&format!(" (unrounded {} {})", exact(distance.in_unit(unit)), unit.symbol()));
        }
        lines.push(line);
        if method == Method::Stereo
            && let Some(range) = one_pixel_around(solution, unit)
        {
            lines.push(format!("  with one pixel of disparity more or less: {range}"));
        }
        if let Some(known) = known {
            lines.push(format!("  1 σ interval: {}", interval(known, unit)));
            lines.push(format!("  variance: {}", budget(known)));
            if !known.model.first_order_is_good() {
                lines.push(format!("  {FIRST_ORDER_IS_POOR}"));
            }
        }
    }
    if let Some(together) = &solution.comparison {
        if let Some(combined) = together.combined {
            let value = with_sigma(combined.value, combined.sigma, unit).text(unit);
            lines.push(format!("Combined distance, the shared focal length accounted for: {value}"));
        }
        lines.push(format!("  {}", agreement_sentence(&together.agreement)));
        lines.extend(assessment.suspects.iter().map(|suspect| format!("  {}", suspect_sentence(suspect))));
    }
    if let Some(width) = solution.estimated_width_px {
        lines.push(format!(
            "{ESTIMATED_WIDTH_PX}: {} px (unrounded {} px)",
            significant(width.px(), DIGITS),
            exact(width.px())
        ));
    }
    if let Some(width) = solution.estimated_width {
        lines.push(format!(
            "{ESTIMATED_WIDTH_M}: {} (unrounded {} m)",
            length(Some(width), LengthUnit::Meter),
            exact(width.m())
        ));
    }
    if solution.estimated_width.is_some() || solution.estimated_width_px.is_some() {
        lines.push(format!("  {}", width_check(solution)));
    }
    lines
}

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
pub fn interval(known: &Uncertainty, unit: LengthUnit) -> String {
    let decimals = decimals_beside(known.model.depth().in_unit(unit), known.sigma.in_unit(unit));
    let end = |length: Length| number::to_decimals(length.in_unit(unit), decimals);
    let near = end(known.interval.near);
    match known.interval.far {
        Some(far) => format!("{near} … {} {}", end(far), unit.symbol()),
        None => format!("{near} {} … no upper bound", unit.symbol()),
    }
}

/// The decimals that show two digits of `sigma`, and at least two of `value`.
pub fn decimals_beside(value: f64, sigma: f64) -> i32 {
    (1 - number::magnitude(sigma)).max(1 - number::magnitude(value))
}

/// Where the variance comes from: "disparity 75 %, baseline 19 %, focal length 6 %", the largest first.
pub fn budget(known: &Uncertainty) -> String {
    let mut shares = known.budget.to_vec();
    shares.sort_by(|a, b| b.share.total_cmp(&a.share));
    shares
        .iter()
        .filter(|share| share.share > 0.0)
        .map(|share| format!("{} {}", short_name(share.source), percent(share.share)))
        .collect::<Vec<_>>()
        .join(", ")
}

/// The input behind most of the variance: "mostly from disparity (75 %)".
pub fn main_cause(known: &Uncertainty) -> Option<String> {
    let share = known.main_cause()?;
    let how = if share.share >= 0.5 { "mostly" } else { "most of it" };
    Some(format!("{how} from {} ({})", short_name(share.source), percent(share.share)))
}

/// A field in the middle of a sentence about causes: "disparity".
pub fn short_name(field: Field) -> &'static str {
    field.noun().trim_start_matches("the ")
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
pub const FIRST_ORDER_IS_POOR: &str =
    "The pixels are known to worse than 10 %: ± σ is a poor description here, the interval and the simulation are right.";

/// What was solved for with its uncertainty, in `unit` (`None`: pixels), or what is lacking: "100.0 ± 1.2 mm".
pub fn unknown(unknown: &Unknown, unit: Option<LengthUnit>) -> String {
    let found = match &unknown.outcome {
        Ok(found) => found,
        Err(reason) => return reason.clone(),
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

/// Whether both distances agree, in a sentence.
pub fn agreement_sentence(agreement: &Agreement) -> String {
    let z = agreement.z.map_or_else(String::new, |z| {
        // What is left of a difference by rounding is none.
        let z = if z < 10.0 { format!("{z:.1}") } else { significant(z, 2) };
        format!(" ({z} σ apart)")
    });
    match agreement.verdict {
        Some(Verdict::Agree) => format!("Stereo and monocular agree within their uncertainties{z}."),
        Some(Verdict::Doubtful) => format!("Stereo and monocular hardly agree{z}: one case in twenty, if the uncertainties are right."),
        Some(Verdict::Disagree) => format!("Stereo and monocular disagree{z}: an input or its uncertainty is wrong."),
        None => match agreement.ratio {
            Some(ratio) => format!(
                "Only the shared focal length has an uncertainty, so agreement cannot be judged; stereo is {} times monocular.",
                significant(ratio, DIGITS)
            ),
            None => "Only the shared focal length has an uncertainty, so agreement cannot be judged.".to_owned(),
        },
    }
}

/// What a suspect is suspected of, in a sentence.
pub fn suspect_sentence(suspect: &Suspect) -> String {
    match *suspect {
        Suspect::RawDisparity { scale } => format!(
            "Was the disparity divided by {}? {}",
            plain(scale),
            if scale == 16.0 {
                "StereoBM and StereoSGBM store sixteenths of a pixel."
            } else {
                "Some files store fixed-point numbers."
            }
        ),
        Suspect::Unit { source, taken, meant } => format!(
            "Is {} really in {}? In {} the two would agree.",
            source.noun(),
            taken.name(),
            meant.name()
        ),
        Suspect::Resized { source, times } => format!(
            "Was {} counted in an image of another size ({} times) than the focal length belongs to?",
            source.noun(),
            plain(times)
        ),
        Suspect::NoSigma(field) => format!("{} is taken to be exact. How well is it known?", capital(field.noun())),
        Suspect::LargestSigma(field) => format!("{} has the largest uncertainty: measure it again.", capital(field.noun())),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::inputs::{Entry, Example};

    #[test]
    fn the_mug_reads_as_in_the_specification() {
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
        let report = report(&inputs, &assessment, LengthUnit::Meter);
        for line in [
            "  Camera baseline (b): 10 cm",
            "  Stereo distance, D = fx · b / d: 1.400 m (unrounded 1.4 m)",
            "    with one pixel of disparity more or less: 1.373 … 1.429 m",
            "  Monocular distance, D = w_real · fx / w_img: –.– m",
        ] {
            assert!(report.lines().any(|candidate| candidate == line), "{line:?} is not in\n{report}");
        }
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
    fn distances_that_only_rounding_tells_apart_are_not_apart() {
        for (z, expected) in [(5e-15, "(0.0 σ apart)"), (1.56, "(1.6 σ apart)"), (12.3, "(12 σ apart)")] {
            let sentence = agreement_sentence(&Agreement {
                ratio: Some(1.0),
                z: Some(z),
                verdict: Some(Verdict::of(z)),
            });
            assert!(sentence.contains(expected), "{sentence}");
        }
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
        assert!(width_check(&solution).contains("10 % larger"), "{}", width_check(&solution));
        assert!(width_check(&Example::Doorway.inputs().assess().solution).contains("only repeat"));
    }
}
