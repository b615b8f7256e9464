//! `ground`: where a pixel's ray meets the floor.

use super::ascii::in_sentence;
use super::options::Ground;
use super::reply::Reply;
use super::typed::name;
use super::warning::Warning;
use crate::core::camera::GroundSolution;
use depth_text::field::{Key, Section};
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::geometry::missing_for_ground;
use depth_text::note::{Part, Severity};
use depth_text::report;
use depth_text::sentences::CommandLine;
use serde::Serialize;

/// Lengths in meters; null for what is unknown.
#[derive(Serialize)]
struct Answer<'a> {
    distance_m: f64,
    ahead_m: f64,
    right_m: Option<f64>,
    slant_m: f64,
    depth_m: f64,
    sigma_m: Option<f64>,
    warnings: &'a [Warning],
}

impl Ground {
    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        self.fields.refuse_empty()?;
        let inputs = Inputs {
            entries: self.fields.entries(),
            ..Inputs::default()
        };
        let assessment = inputs.assess();
        if let Some(note) = assessment.notes.iter().find(|note| note.severity == Severity::Error) {
            return Err(Warning::of(note).to_string());
        }
        let Some(ground) = &assessment.geometry.ground else {
            let missing = missing_for_ground(|key| inputs.entry(key).is_blank());
            let options = missing.into_iter().map(|key| name(key, Part::Value)).collect();
            return Err(CommandLine::NoWay { options }.to_string());
        };
        let mut warnings: Vec<Warning> = assessment.notes.iter().map(Warning::of).collect();
        warnings.extend(self.unused());
        if self.fields.json {
            return json(ground, &warnings);
        }
        let lines = report::ground(self.fields.style(), ground, self.fields.unit);
        let along = self.fields.style().measured(ground.distance, self.fields.unit);
        let mut text = format!("{along} (along the floor)\n");
        for (name, value) in lines.into_iter().filter(|(name, _)| *name != report::ALONG_FLOOR) {
            text.push_str(&format!("  {name}: {value}\n"));
        }
        Ok(Reply {
            text: in_sentence(&text),
            warnings: warnings.iter().map(Warning::to_string).collect(),
        })
    }

    /// What was typed and plays no part in the answer.
    fn unused(&self) -> Vec<Warning> {
        let is_given = |key: Key| self.fields.is_given(key, Part::Value);
        let unused = |&(key, part, _): &(Key, Part, String)| {
            let without_column = !is_given(fields::FLOOR_COLUMN);
            let is_of_row = [fields::CY, fields::FY].contains(&key) || (without_column && key == fields::FOCAL_LENGTH);
            let by_angle = is_given(fields::FLOOR_ANGLE) && is_of_row;
            let has_sigma = self.fields.is_given(fields::FOCAL_LENGTH, Part::Sigma);
            let only_fy = key == fields::FOCAL_LENGTH && is_given(fields::FY) && without_column && !has_sigma;
            let without_column = without_column && key == fields::CX;
            let reason = if part == Part::Sigma && !is_given(key) {
                CommandLine::UnusedSigma {
                    option: name(key, Part::Value),
                }
            } else if by_angle {
                CommandLine::UnusedWithAngle
            } else if only_fy {
                CommandLine::UnusedFocalLength
            } else if without_column {
                CommandLine::UnusedSigma { option: "u".to_owned() }
            } else {
                return None;
            };
            Some(Warning::new(key, part, &reason))
        };
        let is_of_ground = |(key, _, _): &&(Key, Part, String)| key.section.is_some_and(|section| section != Section::Stereo);
        self.fields.typed.iter().filter(is_of_ground).filter_map(unused).collect()
    }
}

fn json(ground: &GroundSolution, warnings: &[Warning]) -> Result<Reply, String> {
    let sigma = ground.distance.sigma.m();
    let answer = Answer {
        distance_m: ground.distance.value.m(),
        ahead_m: ground.ahead.value.m(),
        right_m: ground.right.map(|right| right.value.m()),
        slant_m: ground.slant.value.m(),
        depth_m: ground.depth.value.m(),
        sigma_m: (sigma > 0.0).then_some(sigma),
        warnings,
    };
    Reply::json(&answer)
}
