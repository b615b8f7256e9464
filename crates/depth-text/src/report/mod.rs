//! The results in words: lengths with their uncertainty, the formulas with their numbers, the table of parameters.
//! Where no [`Style`] is asked for it is that of the window.

use crate::assess::{Assessment, Unknown};
use crate::field::Key;
use crate::fields;
use crate::geometry::TwoShots;
use crate::names::{self, Named};
use crate::note::Issue;
use crate::number::Notation;
use crate::reading::Reading;
use crate::sentences::{Statement, capital, needs, shares, short_name, sizes};
use crate::style::Style;
use crate::unit::Unit;
use depth_core::angle::AngleUnit;
use depth_core::in_image::InImage;
use depth_core::measured::Measured;
use depth_core::problem::{Method, Solution, Solved, Uncertainty};
use depth_core::quantity::{Length, LengthUnit};
use depth_core::setup::Object;

mod budget;
mod field_line;
mod parts;
mod places;
pub mod strip;
mod table;
mod tone;

pub use field_line::{field_line, field_line_in_pair};
pub use places::{
    ALONG_FLOOR, BETWEEN_POINTS, DEPTH_OF_RANGE, FROM_FIRST_PLACE, WAYS_BETWEEN, ground, point, point_origin, two_points, two_shots,
    ways_between,
};

pub use budget::{Budget, BudgetRow, budgets};
pub use parts::{angle_between_rays, mode_rows};
pub use strip::{Badge, Cell, Line, Mode, Part, Quality, Shown, Strip, Value, quantity_formula};
pub use table::{INTERMEDIATE, NONE, Row, all_rows, parameter_rows};
pub use tone::Tone;

pub use crate::style::{DIGITS, NO_UPPER_BOUND, WithSigma};

const STYLE: Style = Style::WINDOW;

/// "1.400 m", or "–.– m" where there is none; see [`Style::length`].
pub fn length(length: Option<Length>, unit: LengthUnit) -> String {
    STYLE.length(length, unit)
}

/// "1.400" and "m"; see [`Style::length_parts`].
pub fn length_parts(length: Option<Length>, unit: LengthUnit) -> [String; 2] {
    STYLE.length_parts(length, unit)
}

/// "1.400" and "m ± 0.016"; see [`Style::measured_parts`].
pub fn measured_parts(length: Measured<Length>, unit: LengthUnit) -> [String; 2] {
    STYLE.measured_parts(length, unit)
}

/// "1.373…1.429 m"; see [`Style::range`].
pub fn range(near: Length, far: Option<Length>, unit: LengthUnit) -> String {
    STYLE.range(near, far, unit)
}

/// "1.373…1.429 m"; see [`Style::one_pixel_range`].
pub fn one_pixel_range(solution: &Solution, unit: LengthUnit) -> Option<String> {
    STYLE.one_pixel_range(solution, unit)
}

/// "1.384…1.416 m"; see [`Style::interval`].
pub fn interval(uncertainty: &Uncertainty, unit: LengthUnit) -> String {
    STYLE.interval(uncertainty, unit)
}

/// The formula of `method` with its symbols, as it is solved; see [`names::formula`].
pub fn formula(solution: &Solution, method: Method) -> String {
    names::formula(&solution.problem, method)
}

/// What is to be said about a distance by `method`, a line each: what was read where that was worked out or could be mistaken, and that
/// the focal length of the lens was added.
pub fn remarks(assessment: &Assessment, method: Method) -> Vec<Statement> {
    let solution = &assessment.solution;
    let mut lines = Vec::new();
    lines.extend(solution.added_lens(method).map(|lens| lens_added(assessment, lens)));
    let extent = match method {
        Method::Stereo => fields::DISPARITY,
        Method::Monocular => fields::IMAGE_WIDTH,
    };
    let is_mil = assessment
        .reading(extent)
        .is_some_and(|reading| reading.unit == Some(Unit::Angle(AngleUnit::NatoMil)));
    if is_mil {
        lines.push(Statement::NatoMil);
    }
    lines
}

/// What is to be said about the distances of two photographs, a line each.
pub fn shots_remarks(assessment: &Assessment, shots: &TwoShots) -> Vec<Statement> {
    let one_pixel = shots.is_one_pixel_each.then_some(Statement::OnePixelEach);
    let lens = shots.added_lens.map(|lens| lens_added(assessment, lens));
    one_pixel.into_iter().chain(lens).collect()
}

fn lens_added(assessment: &Assessment, lens: Length) -> Statement {
    let unit = assessment.reading(fields::FX_LENS).and_then(|reading| reading.unit?.length());
    let unit = unit.unwrap_or(LengthUnit::Millimeter);
    Statement::LensAdded { lens, unit }
}

/// What a reading says that its text does not: the result of what was worked out, which mil it is. `None` where nothing.
pub fn read_as(reading: &Reading) -> Option<String> {
    if reading.is_computed {
        let unit = reading.unit;
        let number = Notation::SHORT.plain(reading.number, 6);
        return Some(format!("= {}", unit.map_or_else(|| number.clone(), |unit| unit.behind(&number))));
    }
    (reading.unit == Some(Unit::Angle(AngleUnit::NatoMil))).then(|| Statement::NatoMil.to_string())
}

/// The formula of `method` with the numbers as they were typed and its result in `unit`, or `None` while an input is missing:
/// "D = 700 px · 10 cm / 50 px = 1.400 m".
pub fn formula_with_numbers(assessment: &Assessment, method: Method, unit: LengthUnit) -> Option<String> {
    let distance = assessment.solution.outcome(method).distance()?;
    let numbers = STYLE.numbers_in_formula(assessment, method)?;
    Some(format!("D = {numbers} = {}", length(Some(distance), unit)))
}

/// Name of the distance of `method` in a table.
pub const fn distance_name(method: Method) -> &'static str {
    match method {
        Method::Stereo => "Object distance (D, stereo)",
        Method::Monocular => "Object distance (D, monocular)",
    }
}

/// Name of the combined distance in a table.
pub const COMBINED_DISTANCE: &str = "Object distance (D, combined)";

/// Name of w_real·fx/D: "Estimated object width (pixels)".
pub const fn estimated_width_px_name(object: Object) -> &'static str {
    match object {
        Object::Width => "Estimated object width (pixels)",
        Object::Height => "Estimated object height (pixels)",
        Object::Ball => "Estimated ball width (pixels)",
    }
}

/// Name of w_img·D/fx in `unit`: "Estimated object width (meters)".
pub fn estimated_width_name(object: Object, unit: LengthUnit) -> String {
    let size = match object {
        Object::Width => "object width",
        Object::Height => "object height",
        Object::Ball => "ball diameter",
    };
    format!("Estimated {size} ({})", unit.name())
}
/// What the monocular distance would be without the tilt.
pub const WITHOUT_TILT: &str = "without the tilt";
/// What w_real·fx/D and w_img·D/fx are: "Width in the image that the real width predicts", "Real width that the width in the image
/// predicts".
pub fn predicted(object: Object) -> [String; 2] {
    let [in_image, real] = sizes(object);
    [(in_image, real), (real, in_image)].map(|(of, by)| format!("{} that {by} predicts", capital(of.trim_start_matches("the "))))
}

/// The change that [`one_pixel_range`] is about.
pub const ONE_PIXEL: &str = "one pixel of disparity more or less";

/// Where the variance comes from: "disparity 75 %, baseline 19 %, focal length 6 %", the largest first.
pub fn budget(assessment: &Assessment, uncertainty: &Uncertainty) -> String {
    let shares = budget_shares(assessment, uncertainty).into_iter();
    let shares = shares.map(|(key, share)| format!("{} {share}", short_name(key)));
    shares.collect::<Vec<_>>().join(", ")
}

/// The inputs that the variance comes from with their shares, the largest first; what is written adds up to 100 %.
pub fn budget_shares(assessment: &Assessment, uncertainty: &Uncertainty) -> Vec<(Key, String)> {
    let mut parts: Vec<_> = uncertainty.budget.iter().filter(|share| share.share > 0.0).collect();
    parts.sort_by(|a, b| b.share.total_cmp(&a.share));
    let written = shares(&parts.iter().map(|share| share.share).collect::<Vec<_>>());
    parts.iter().map(|share| assessment.worded(share.source)).zip(written).collect()
}

/// How sure the distance is that `uncertainty` belongs to, a line each: the interval, the shares, and whether ± σ misleads.
pub fn certainty(style: Style, assessment: &Assessment, uncertainty: &Uncertainty, unit: LengthUnit) -> Vec<String> {
    let mut lines = vec![
        format!("1 σ interval: {}", style.interval(uncertainty, unit)),
        format!("variance: {}", budget(assessment, uncertainty)),
    ];
    if !uncertainty.model.first_order_is_good() {
        let has_simulation = style.has_simulation;
        lines.push(Statement::FirstOrderIsPoor { has_simulation }.to_string());
    }
    lines
}

/// Whether both distances agree, and what to look at if not, a line each.
pub fn agreement(assessment: &Assessment) -> Vec<String> {
    let agreement = Statement::comparison(assessment);
    let suspects = assessment.suspects();
    let statements = agreement
        .into_iter()
        .chain(suspects.iter().map(|suspect| Statement::suspect(assessment, suspect)));
    statements.map(|statement| statement.to_string()).collect()
}

/// What was solved for with its uncertainty, a length in `unit`: "(100.0 ± 1.2) mm"; `None` where something is lacking.
pub fn unknown(style: Style, unknown: &Unknown, unit: LengthUnit) -> Option<String> {
    Some(match *unknown.outcome.as_ref().ok()? {
        Solved::Length(length) => style.measured(length, unit),
        Solved::InImage(InImage::OnSensor(length)) => style.measured(length, LengthUnit::Millimeter),
        Solved::InImage(extent) => {
            let Measured { value, sigma } = extent.to_base();
            if sigma > 0.0 {
                style.with_sigma(value, sigma).text(Unit::Pixel)
            } else {
                format!("{} {}", style.number(Some(value)), Unit::Pixel)
            }
        }
    })
}

/// [`unknown`] in two parts, of which the second is written smaller: "100.0" and "mm ± 1.2".
pub fn unknown_in_parts(unknown: &Unknown, unit: LengthUnit) -> Option<[String; 2]> {
    Some(match *unknown.outcome.as_ref().ok()? {
        Solved::Length(length) => STYLE.measured_parts(length, unit),
        Solved::InImage(InImage::OnSensor(length)) => STYLE.measured_parts(length, LengthUnit::Millimeter),
        Solved::InImage(extent) => {
            let Measured { value, sigma } = extent.to_base();
            if sigma > 0.0 {
                STYLE.with_sigma(value, sigma).parts(Unit::Pixel)
            } else {
                [STYLE.number(Some(value)), Unit::Pixel.to_string()]
            }
        }
    })
}

/// Why nothing was solved for, without repeating what is said at a field: "none; see the note on the disparity", "needs D".
pub fn why_unsolved(assessment: &Assessment, unknown: &Unknown) -> Option<String> {
    let issue = unknown.outcome.as_ref().err()?;
    let note = assessment.notes.iter().find(|note| note.issue == *issue);
    Some(match (note, issue) {
        (Some(note), _) => Statement::SeeNote { key: note.key }.to_string(),
        (None, Issue::MissingForUnknown { key }) => needs(&[*key]),
        (None, issue) => issue.to_string(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::entry::Entry;
    use crate::form::{Example, Inputs};

    use depth_core::problem::Field;

    #[test]
    fn the_formula_of_the_mug_has_its_numbers() {
        let inputs = Example::CoffeeMug.inputs();
        let assessment = inputs.assess();
        assert_eq!(
            one_pixel_range(&assessment.solution, LengthUnit::Meter).as_deref(),
            Some("1.373…1.429 m")
        );
        assert_eq!(
            formula_with_numbers(&assessment, Method::Stereo, LengthUnit::Meter).as_deref(),
            Some("D = 700 px · 10 cm / 50 px = 1.400 m")
        );
        let mut far = Inputs::default();
        far.entry_mut(Field::FocalLength).text = "700".into();
        far.entry_mut(Field::Baseline).text = "4 in".into();
        far.entry_mut(Field::Disparity).text = "0.05".into();
        assert_eq!(
            formula_with_numbers(&far.assess(), Method::Stereo, LengthUnit::Foot).as_deref(),
            Some("D = 700 px · 4 in / 0.05 px = 4667 ft")
        );
    }

    #[test]
    fn a_doffs_below_zero_is_subtracted() {
        let mut inputs = Example::CoffeeMug.inputs();
        inputs.entry_mut(Field::Disparity).text = "90".into();
        inputs.entry_mut(Field::Doffs).text = "-40".into();
        assert_eq!(
            formula_with_numbers(&inputs.assess(), Method::Stereo, LengthUnit::Meter).as_deref(),
            Some("D = 700 px · 10 cm / (90 px − 40 px) = 1.400 m")
        );
    }

    #[test]
    fn the_table_has_inputs_as_typed_and_results_in_the_unit_of_the_results() {
        let rows = parameter_rows(&Example::CoffeeMug.inputs().assess(), LengthUnit::Foot);
        let values: Vec<_> = rows.iter().map(|row| (row.value.as_str(), row.unit.as_str())).collect();
        assert_eq!(
            values.get(..4),
            Some(&[("700", "pixels"), ("10", "centimeters"), ("50", "pixels"), (NONE, "pixels")][..])
        );
        assert!(values.contains(&("4.593", "feet")), "{values:?}");
    }

    #[test]
    fn at_one_pixel_of_disparity_the_far_end_has_no_bound() {
        let mut inputs = Example::CoffeeMug.inputs();
        *inputs.entry_mut(Field::Disparity) = Entry::new("1", None);
        assert_eq!(
            one_pixel_range(&inputs.assess().solution, LengthUnit::Meter).as_deref(),
            Some("35.00…∞ m")
        );
    }

    #[test]
    fn the_widths_are_a_check_only_against_the_stereo_distance() {
        let mut inputs = Example::CoffeeMug.inputs();
        inputs.entry_mut(Field::ImageWidth).text = "165".into();
        inputs.entry_mut(Field::RealWidth).text = "0.3".into();
        let assessment = inputs.assess();
        let solution = &assessment.solution;
        assert_eq!(solution.estimated_width_px.map(|w| w.px().round()), Some(150.0));
        assert!(
            Statement::widths(&assessment).to_string().contains("10 % larger"),
            "{}",
            Statement::widths(&assessment)
        );
        assert!(
            Statement::widths(&Example::Doorway.inputs().assess())
                .to_string()
                .contains("only repeat")
        );
    }
}
