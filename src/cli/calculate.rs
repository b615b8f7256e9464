//! `calculate`: what is answered, warned about or refused.

use super::fill::fill;
use super::json::Json;
use super::options::{Calculate, method_of};
use super::presets::asks_zero;
use super::reply::Reply;
use super::sizes;
use super::text::Text;
use super::typed::name;
use super::warning::Warning;
use crate::core::in_image::InImage;
use crate::core::problem::{Field, Method, Outcome};
use depth_text::assess::{Assessment, Unknown};
use depth_text::export::{Exporter as _, Provenance, Results};
use depth_text::field::{Key, Section};
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::names::Named as _;
use depth_text::note::{Issue, Part, Severity};
use depth_text::report;
use depth_text::sentences::{CommandLine, Statement};

impl Calculate {
    fn is_given(&self, key: impl Into<Key>, part: Part) -> bool {
        self.fields.is_given(key, part)
    }

    fn inputs(&self) -> Result<Inputs, String> {
        Ok(Inputs {
            entries: self.fields.entries(),
            unknown: self.unknown()?,
            object: self.object.unwrap_or_default(),
            pair: self.pair.unwrap_or_default(),
        })
    }

    /// The equation and its unknown, where that is not the distance.
    fn unknown(&self) -> Result<Option<(Method, Field)>, String> {
        let Some((key, field)) = self.solve_for.and_then(|key| Some((key, key.input?))) else {
            return Ok(None);
        };
        if !self.is_given(fields::DISTANCE, Part::Value) {
            return Err(CommandLine::NoKnownDistance.to_string());
        }
        if let Some(method) = method_of(key) {
            return Ok(Some((method, field)));
        }
        let begun = |method: &Method| method.own_fields().into_iter().any(|field| self.is_given(field, Part::Value));
        match Method::ALL.into_iter().filter(begun).collect::<Vec<_>>()[..] {
            [method] => Ok(Some((method, field))),
            [] => {
                let inputs = Inputs {
                    entries: self.fields.entries(),
                    unknown: Some((Method::Stereo, field)),
                    ..Inputs::default()
                };
                Err(self.what_is_missing(&inputs).to_string())
            }
            _ => Err(CommandLine::WhichEquation.to_string()),
        }
    }

    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        self.fields.refuse_empty()?;
        let mut filled = self.clone();
        let mut warnings = Vec::new();
        if let Some(name) = &self.known {
            let (object, said) = sizes::fill(name, &mut filled.fields, self.solve_for)?;
            filled.object.get_or_insert(object);
            warnings.push(Warning::of_option("known", &said));
        }
        if let Some(preset) = &self.preset {
            let said = preset.fill(&mut filled.fields, self.solve_for)?;
            warnings.push(Warning::of_option("preset", &said));
            return filled.answer(warnings).map_err(|refusal| with(refusal, vec![said]));
        }
        if asks_zero(&self.fields) {
            return Err("--zero preset is the zero point of a preset: say which with --preset.".to_owned());
        }
        let Some(calibration) = &self.calibration else {
            return filled.answer(warnings);
        };
        let stand = (filled.object.unwrap_or_default(), self.pair.unwrap_or_default());
        let said = fill(calibration, &mut filled.fields, stand, self.solve_for)?;
        warnings.extend(said.iter().map(|sentence| Warning::of_option("from", sentence)));
        // Why something is missing is what the files say of it.
        filled.answer(warnings).map_err(|refusal| with(refusal, said))
    }

    /// The answer, beside what was said of the files that it is from.
    fn answer(&self, mut warnings: Vec<Warning>) -> Result<Reply, String> {
        let inputs = self.inputs()?;
        let assessment = inputs.assess();
        let solution = &assessment.solution;
        let has_distance = Method::ALL.iter().any(|&method| solution.outcome(method).distance().is_some());
        let answered = has_distance || assessment.geometry.point.is_some();
        let error = assessment.notes.iter().find(|note| note.severity == Severity::Error);
        if let Some(note) = error
            && !(answered && is_beside_the_answer(&assessment, note.key))
        {
            return Err(Warning::of(note).to_string());
        }
        if let Some(unknown) = &assessment.unknown
            && let Err(issue) = &unknown.outcome
        {
            return Err(self.why_not_solved(&inputs, unknown, issue));
        }
        if !answered {
            return Err(self.what_is_missing(&inputs).to_string());
        }
        warnings.extend(self.warnings(&inputs, &assessment));
        let results = Results {
            inputs: &inputs,
            assessment: &assessment,
            unit: self.fields.unit,
            provenance: Provenance::default(),
        };
        if self.fields.json {
            warnings.extend(remarks(&assessment));
            let answer = Json { warnings: &warnings }.export(&results);
            return answer.map(Reply::without_warnings).map_err(|error| error.to_string());
        }
        let Ok(text) = Text {
            style: self.fields.style(),
        }
        .export(&results);
        Ok(Reply {
            text,
            warnings: warnings.iter().map(Warning::to_string).collect(),
        })
    }

    fn warnings(&self, inputs: &Inputs, assessment: &Assessment) -> Vec<Warning> {
        // Half of the other method was given: that is worth a warning, an untouched one is not.
        let missing = assessment.missing.iter().filter(|note| assessment.note(note.key).is_none());
        let missing = missing.filter(|_| Method::ALL.into_iter().any(|method| inputs.is_begun(method)));
        let mut warnings: Vec<Warning> = assessment.notes.iter().chain(missing).map(Warning::of).collect();
        let unused = self.unused(assessment);
        // What there is a better sentence about is not mentioned again.
        let is_new = |unused: &Warning| warnings.iter().all(|warning| warning.field != unused.field);
        let unused: Vec<Warning> = unused.into_iter().filter(is_new).collect();
        warnings.extend(unused);
        if assessment.solution.comparison.is_some_and(|comparison| comparison.contradict()) {
            warnings.extend(Statement::comparison(assessment).map(|statement| Warning::of_results(&statement)));
        }
        warnings
    }

    /// Why what is asked for by `--solve-for` cannot be had, with the option to look at.
    fn why_not_solved(&self, inputs: &Inputs, unknown: &Unknown, issue: &Issue) -> String {
        match issue {
            Issue::MissingForUnknown { key } if *key == fields::DISTANCE => Warning::new(*key, Part::Value, issue).to_string(),
            Issue::MissingForUnknown { .. } => {
                let missing = inputs.missing_for(unknown.method).into_iter();
                CommandLine::NotSolved {
                    unknown: inputs.worded(unknown.field),
                    options: missing.map(|key| name(key, Part::Value)).collect(),
                }
                .to_string()
            }
            _ => issue.to_string(),
        }
    }

    /// The options that the point in space still needs, where one of it was given.
    fn missing_for_point(&self) -> Vec<String> {
        let camera = std::iter::once(fields::FOCAL_LENGTH).chain(Section::Point.keys());
        let needed = camera.filter(|&key| key.input != Some(Field::Zero) && key != fields::TAPED_RANGE);
        let missing = needed.filter(|&key| !self.is_given(key, Part::Value));
        missing.map(|key| name(key, Part::Value)).collect()
    }

    /// Which options would give a distance: those of the methods of which something was typed, else those of both.
    fn what_is_missing(&self, inputs: &Inputs) -> CommandLine {
        let touched = |method: &Method| method.own_fields().into_iter().any(|field| self.is_given(field, Part::Value));
        let any_touched = Method::ALL.iter().any(touched);
        if !any_touched && self.is_given(fields::TAPED_RANGE, Part::Value) {
            let options = self.missing_for_point();
            return CommandLine::NoPoint { options };
        }
        let ways = Method::ALL
            .into_iter()
            .filter(|method| match self.solve_for.and_then(method_of) {
                Some(solved) => *method == solved,
                None => touched(method) || !any_touched,
            })
            .map(|method| {
                let missing = inputs.missing_for(method).into_iter();
                (missing.map(|key| name(key, Part::Value)).collect(), method.name())
            })
            .collect();
        CommandLine::NoDistance { ways }
    }

    /// What was typed and plays no part in the answer.
    fn unused(&self, assessment: &Assessment) -> Vec<Warning> {
        let mut typed: Vec<(Key, Part)> = self.fields.typed.iter().map(|&(key, part, _)| (key, part)).collect();
        typed.sort();
        let fields = typed
            .into_iter()
            .filter_map(|(key, part)| Some(Warning::new(key, part, &self.why_unused(assessment, key, part)?)));
        let is_begun = |method: Method| method.own_fields().into_iter().any(|field| self.is_given(field, Part::Value));
        let choice = |option: &str, method| (!is_begun(method)).then(|| Warning::of_option(option, &CommandLine::UnusedChoice { method }));
        let object = self.object.and_then(|_| choice("object", Method::Monocular));
        let pair = self.pair.and_then(|_| choice("pair", Method::Stereo));
        fields.chain(object).chain(pair).collect()
    }

    /// Whether `key`, a focal length or what belongs to it, plays no part in what was computed: beside angles, or fy beside columns.
    fn is_idle(&self, assessment: &Assessment, key: Key) -> Option<CommandLine> {
        let problem = &assessment.solution.problem;
        if assessment.geometry.point.is_some() || self.solve_for.is_some() {
            return None;
        }
        let solution = &assessment.solution;
        // One width predicts the other with the same focal length.
        let has_width = solution.estimated_width.is_some() || solution.estimated_width_px.is_some();
        let has_distance = |method: &Method| solution.outcome(*method).distance().is_some() || (*method == Method::Monocular && has_width);
        let mut methods = Method::ALL.into_iter().filter(has_distance).peekable();
        methods.peek()?;
        let by_angle = |method: Method| {
            let extent = if method == Method::Stereo {
                problem.disparity
            } else {
                problem.image_width
            };
            matches!(extent, Some(InImage::Angle(_)))
        };
        let (mut all_by_angle, mut none_in_rows) = (true, true);
        for method in methods {
            all_by_angle &= by_angle(method);
            none_in_rows &= !problem.needs_fy(method);
        }
        if [fields::FOCAL_LENGTH, fields::FX_LENS, fields::FY].contains(&key) && all_by_angle {
            return Some(CommandLine::UnusedBesideAngle);
        }
        if key == fields::FX_LENS && matches!(problem.focal_length, Some(InImage::OnSensor(_))) {
            return Some(CommandLine::UnusedLens);
        }
        (key == fields::FY && none_in_rows).then_some(CommandLine::UnusedFy)
    }

    fn why_unused(&self, assessment: &Assessment, key: Key, part: Part) -> Option<CommandLine> {
        let is_also_solved_for = key == fields::FY
            && self.solve_for == Some(fields::FOCAL_LENGTH)
            && assessment
                .unknown
                .as_ref()
                .is_some_and(|unknown| assessment.solution.problem.needs_fy(unknown.method));
        if self.solve_for == Some(key) || is_also_solved_for {
            return Some(CommandLine::UnusedUnknown);
        }
        if key == fields::DISTANCE && self.solve_for.is_none() {
            return Some(CommandLine::UnusedDistance);
        }
        if part == Part::Sigma && key != fields::DOFFS && !self.is_given(key, Part::Value) {
            return Some(CommandLine::UnusedSigma {
                option: name(key, Part::Value),
            });
        }
        if let Some(idle) = self.is_idle(assessment, key) {
            return Some(idle);
        }
        if key.section == Some(Section::Point) && key.input.is_none() && assessment.geometry.point.is_none() {
            if matches!(assessment.solution.problem.focal_length, Some(InImage::OnSensor(_))) {
                return Some(CommandLine::UnusedBesideLengths);
            }
            let options = self.missing_for_point();
            return Some(CommandLine::UnusedPoint { options });
        }
        let method = Method::ALL.into_iter().find(|method| key == method.own_optional_field())?;
        let is_begun = method.own_fields().into_iter().any(|field| self.is_given(field, Part::Value));
        (!is_begun && assessment.solution.outcome(method).distance().is_none()).then_some(match method {
            Method::Stereo => CommandLine::UnusedDoffs,
            Method::Monocular => CommandLine::UnusedTilt,
        })
    }
}

/// Whether `key` belongs only to a method that is not the one that gave an answer.
fn is_beside_the_answer(assessment: &Assessment, key: Key) -> bool {
    if assessment.unknown.is_some() || key.section == Some(Section::Point) {
        return false;
    }
    let belongs = |method: Method| {
        let mut fields = method.fields().into_iter().chain(method.optional_fields());
        fields.any(|field| key == field)
    };
    let is_answered = |&method: &Method| matches!(assessment.solution.outcome(method), Outcome::Distance(_));
    let is_of_point = assessment.geometry.point.is_some() && key == fields::FOCAL_LENGTH;
    !is_of_point && Method::ALL.into_iter().filter(is_answered).all(|method| !belongs(method))
}

/// What the text says below a distance, for an answer that is not text.
fn remarks(assessment: &Assessment) -> Vec<Warning> {
    let mut remarks: Vec<Warning> = Vec::new();
    for method in Method::ALL {
        let extent = match method {
            Method::Stereo => fields::DISPARITY,
            Method::Monocular => fields::IMAGE_WIDTH,
        };
        for remark in report::remarks(assessment, method) {
            let key = if matches!(remark, Statement::LensAdded { .. }) {
                fields::FX_LENS
            } else {
                extent
            };
            let remark = Warning::new(key, Part::Value, &remark);
            if !remarks.contains(&remark) {
                remarks.push(remark);
            }
        }
    }
    remarks
}

/// `refusal`, and what may explain it.
fn with(refusal: String, said: Vec<String>) -> String {
    [refusal].into_iter().chain(said).collect::<Vec<_>>().join(" ")
}
