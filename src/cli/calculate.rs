//! `calculate`: what is answered, warned about or refused.

use super::json::Json;
use super::options::{Calculate, name};
use super::reply::Reply;
use super::text::Text;
use super::warning::Warning;
use crate::core::problem::{Method, Outcome, Solution};
use depth_text::entry::Entry;
use depth_text::export::{Exporter as _, Results};
use depth_text::field::Key;
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::names::Named as _;
use depth_text::note::{Part, Severity};
use depth_text::sentences::CommandLine;

impl Calculate {
    /// Whether the option for the value of `key` or for its σ was given.
    fn is_given(&self, key: impl Into<Key>, part: Part) -> bool {
        let key = key.into();
        self.typed.iter().any(|typed| (typed.0, typed.1) == (key, part))
    }

    fn inputs(&self) -> Inputs {
        let mut inputs = Inputs {
            with_uncertainty: true,
            ..Inputs::default()
        };
        for (key, part, text) in &self.typed {
            match part {
                Part::Value => inputs.fill(*key, Entry::new(text, None)),
                Part::Sigma => inputs.set_sigma(*key, text),
            }
        }
        inputs
    }

    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        self.refuse_empty()?;
        let inputs = self.inputs();
        let assessment = inputs.assess();
        let solution = &assessment.solution;
        let answered = Method::ALL.iter().any(|&method| solution.outcome(method).distance().is_some());
        let error = assessment.notes.iter().find(|note| note.severity == Severity::Error);
        if let Some(note) = error
            && !(answered && is_beside_the_answer(solution, note.key))
        {
            return Err(Warning::of(note).to_string());
        }
        if !answered {
            return Err(self.what_is_missing().to_string());
        }
        // Half of the other method was given: that is worth a warning, an untouched one is not.
        let missing = assessment.missing.iter().filter(|note| assessment.note(note.key).is_none());
        let mut warnings: Vec<Warning> = assessment.notes.iter().chain(missing).map(Warning::of).collect();
        let unused = self.unused(solution);
        // What there is a better sentence about is not mentioned again.
        let is_new = |unused: &Warning| warnings.iter().all(|warning| warning.field != unused.field);
        let unused: Vec<Warning> = unused.into_iter().filter(is_new).collect();
        warnings.extend(unused);
        let results = Results {
            inputs: &inputs,
            assessment: &assessment,
            unit: self.unit,
        };
        if self.json {
            let answer = Json { warnings: &warnings }.export(&results);
            return answer.map(Reply::without_warnings).map_err(|error| error.to_string());
        }
        let Ok(text) = Text.export(&results);
        Ok(Reply {
            text,
            warnings: warnings.iter().map(Warning::to_string).collect(),
        })
    }

    /// An empty value is a variable of a script that was not set, not an input that was left out.
    fn refuse_empty(&self) -> Result<(), String> {
        let empty = |(_, _, text): &&(Key, Part, String)| text.trim().is_empty();
        // Field by field, as they are asked for.
        match self.typed.iter().filter(empty).min_by_key(|(key, part, _)| (*key, *part)) {
            Some((key, part, _)) => Err(CommandLine::EmptyOption { option: name(*key, *part) }.to_string()),
            None => Ok(()),
        }
    }

    /// Which options would give a distance: those of the methods of which something was typed, else those of both.
    fn what_is_missing(&self) -> CommandLine {
        let touched = |method: &Method| method.own_fields().into_iter().any(|field| self.is_given(field, Part::Value));
        let any_touched = Method::ALL.iter().any(touched);
        let ways = Method::ALL
            .into_iter()
            .filter(|method| touched(method) || !any_touched)
            .map(|method| {
                let missing = method.fields().into_iter().filter(|&field| !self.is_given(field, Part::Value));
                (missing.map(|field| name(field.into(), Part::Value)).collect(), method.name())
            })
            .collect();
        CommandLine::NoDistance { ways }
    }

    /// What was typed and plays no part in the answer.
    fn unused(&self, solution: &Solution) -> Vec<Warning> {
        let stereo = Method::Stereo.own_fields();
        let is_stereo = solution.stereo.distance().is_some() || stereo.iter().any(|&field| self.is_given(field, Part::Value));
        let reason = |key: Key, part| match part {
            _ if key == fields::DOFFS => (!is_stereo).then_some(CommandLine::UnusedDoffs),
            Part::Sigma if !self.is_given(key, Part::Value) => Some(CommandLine::UnusedSigma {
                option: name(key, Part::Value),
            }),
            Part::Sigma | Part::Value => None,
        };
        let mut typed: Vec<(Key, Part)> = self.typed.iter().map(|&(key, part, _)| (key, part)).collect();
        typed.sort();
        typed
            .into_iter()
            .filter_map(|(key, part)| Some(Warning::new(key, part, &reason(key, part)?)))
            .collect()
    }
}

/// Whether `key` belongs only to a method that is not the one that gave an answer.
fn is_beside_the_answer(solution: &Solution, key: Key) -> bool {
    let belongs = |method: Method| {
        let is_offset = method == Method::Stereo && key == fields::DOFFS;
        method.fields().into_iter().any(|field| key == field) || is_offset
    };
    Method::ALL
        .into_iter()
        .filter(|&method| matches!(solution.outcome(method), Outcome::Distance(_)))
        .all(|method| !belongs(method))
}
