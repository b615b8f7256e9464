//! The answers, one line each that can be quoted as it stands: value with σ, formula, inputs with theirs.

use super::exporter::Results;
use crate::assess::Assessment;
use crate::field::{Key, Section};
use crate::fields;
use crate::names::{self, Named as _};
use crate::report::{self, quantity_formula};
use crate::sentences::{Statement, capital, lower, needs};
use crate::style::Style;
use depth_core::measured::Measured;
use depth_core::problem::Method;
use depth_core::quantity::Length;

const STYLE: Style = Style::WINDOW;

/// The lines of the answer: what was solved for, the distances and both together, the further ways.
pub(super) fn lines(results: &Results<'_>) -> Vec<String> {
    let solved = solved_for(results);
    let methods = Method::ALL.into_iter().filter_map(|method| of_method(results, method));
    solved
        .into_iter()
        .chain(methods)
        .chain(combined(results))
        .chain(further_ways(results))
        .collect()
}

/// "Stereo: (1.400 ± 0.016) m (k = 1), D = fx·b/d, fx = (700 ± 2) px, b = (100 ± 0.5) mm, d = (50 ± 0.5) px"; without a distance why, if it
/// was asked for.
fn of_method(results: &Results<'_>, method: Method) -> Option<String> {
    let &Results {
        inputs, assessment, unit, ..
    } = results;
    if assessment.unknown.as_ref().is_some_and(|unknown| unknown.method == method) {
        // Its distance was given.
        return None;
    }
    let name = method.name();
    let Some(distance) = assessment.distance(method) else {
        let refused = assessment
            .refusal(method)
            .map(|note| Statement::SeeNote { key: note.key }.to_string());
        let why = refused.unwrap_or_else(|| needs(&inputs.missing_for(method)));
        return (inputs.is_begun(method) && !why.is_empty()).then(|| format!("{name}: {why}"));
    };
    let sigma = assessment
        .solution
        .uncertainty(method)
        .map_or(Length::from_m(0.0), |known| known.sigma);
    let value = with_k(STYLE.measured(Measured::new(distance, sigma), unit), sigma.m());
    let formula = names::formula(&assessment.solution.problem, method);
    let fields = method.fields().into_iter().chain(method.optional_fields());
    let keys: Vec<Key> = fields.map(|field| assessment.worded(field)).collect();
    Some(format!(
        "{name}: {value}, {}{}",
        tight(&formula),
        inputs_of(assessment, &formula, &keys)
    ))
}

/// The same of what was solved for.
fn solved_for(results: &Results<'_>) -> Option<String> {
    let &Results { assessment, unit, .. } = results;
    let unknown = assessment.unknown.as_ref()?;
    let key = assessment.worded(unknown.field);
    let name = key.label;
    let Some(value) = report::unknown(STYLE, unknown, unit) else {
        return Some(format!("{name}: {}", report::why_unsolved(assessment, unknown)?));
    };
    let sigma = unknown.outcome.as_ref().map_or(0.0, |found| found.to_base().sigma);
    let (formula, is_solved) = quantity_formula(&unknown.given, unknown.method, unknown.field);
    let fields = unknown.method.fields().into_iter().chain(unknown.method.optional_fields());
    let keys: Vec<Key> = fields.map(|field| assessment.worded(field)).chain([fields::DISTANCE]).collect();
    let inputs = inputs_of(assessment, &formula, &keys);
    let equation = if is_solved {
        format!("{} = {}", key.symbol, tight(&formula))
    } else {
        tight(&formula)
    };
    Some(format!("{name}: {}, {equation}{inputs}", with_k(value, sigma)))
}

/// "Combined: (1.400 ± 0.015) m (k = 1), the shared focal length accounted for; stereo and monocular agree …"
fn combined(results: &Results<'_>) -> Option<String> {
    let &Results { assessment, unit, .. } = results;
    let said = Statement::comparison(assessment);
    let name = "Combined";
    match (assessment.solution.combined, said) {
        (Some(combined), said) => {
            let value = with_k(STYLE.measured(combined, unit), combined.sigma.m());
            let said = said.map_or_else(String::new, |said| format!(". {said}"));
            let how = Statement::Combined.to_string();
            Some(format!("{name}: {value}, {}{said}", how.trim_start_matches("combined, ")))
        }
        (None, Some(said)) => Some(format!("{name}: {said}")),
        (None, None) => None,
    }
}

/// The ground plane, two photographs, two points: the results of each and its inputs.
fn further_ways(results: &Results<'_>) -> Vec<String> {
    let &Results { assessment, unit, .. } = results;
    let geometry = &assessment.geometry;
    let ground = geometry
        .ground
        .map(|ground| (Section::Ground, report::ground(STYLE, &ground, unit)));
    let shots = geometry
        .two_shots
        .map(|shots| (Section::TwoShots, report::two_shots(STYLE, &shots.solution, unit)));
    let points = geometry
        .two_points
        .map(|points| (Section::TwoPoints, report::two_points(STYLE, &points, unit).into()));
    let line = |(section, values): (Section, Vec<(&'static str, String)>)| {
        let is_measured = values.iter().any(|(_, value)| value.contains('±'));
        let values = values
            .iter()
            .map(|(name, value)| format!("{} {value}", lower(name)))
            .collect::<Vec<_>>()
            .join(", ");
        let k = if is_measured { " (k = 1)" } else { "" };
        let camera = [fields::FOCAL_LENGTH, fields::FY, fields::BASELINE, fields::CX, fields::CY];
        let keys = camera.into_iter().filter(|key| counts(section, *key)).chain(section.keys());
        let inputs = keys.filter_map(|key| input(assessment, key)).collect::<String>();
        format!("{}: {values}{k}{inputs}", section.name())
    };
    ground.into_iter().chain(shots).chain(points).map(line).collect()
}

/// Whether a field of the camera counts in a way of its own.
fn counts(section: Section, key: Key) -> bool {
    match section {
        Section::Ground => key != fields::BASELINE,
        Section::TwoShots => key == fields::FOCAL_LENGTH,
        _ => true,
    }
}

/// ", fx = (700 ± 2) px, b = …", of the fields that stand in `formula`, in the order of `keys`.
fn inputs_of(assessment: &Assessment, formula: &str, keys: &[Key]) -> String {
    let words: Vec<&str> = formula.split(|c: char| !(c.is_alphanumeric() || c == '_')).collect();
    let in_formula = keys.iter().filter(|key| words.contains(&key.symbol));
    in_formula.filter_map(|&key| input(assessment, key)).collect()
}

/// ", fx = (700 ± 2) px"; `None` for what was not given.
fn input(assessment: &Assessment, key: Key) -> Option<String> {
    let reading = assessment.reading(key).filter(|_| !assessment.is_solved_for(key))?;
    Some(format!(", {} = {}", key.symbol, STYLE.typed_with_sigma(reading)))
}

/// `value` with the coverage factor of its σ, where it has one.
fn with_k(value: String, sigma: f64) -> String {
    if sigma > 0.0 { value + " (k = 1)" } else { value }
}

/// A formula as it stands in a running text: "D = fx·b/d".
fn tight(formula: &str) -> String {
    formula.replace(" · ", "·").replace(" / ", "/")
}

/// A remark as a line of its own.
pub(super) fn remark(statement: impl ToString) -> String {
    capital(&statement.to_string())
}
