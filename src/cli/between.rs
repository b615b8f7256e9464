//! `between`: the length between two points that a stereo pair sees.

use super::ascii::in_sentence;
use super::options::{Between, name};
use super::reply::Reply;
use super::warning::Warning;
use crate::core::two_points::TwoPointsSolution;
use depth_text::field::Section;
use depth_text::form::Inputs;
use depth_text::geometry::missing_for;
use depth_text::note::{Part, Severity};
use depth_text::report;
use depth_text::sentences::CommandLine;
use serde::Serialize;

/// Lengths in meters; null for what is unknown.
#[derive(Serialize)]
struct Answer<'a> {
    distance_m: f64,
    sigma_m: Option<f64>,
    dx_m: f64,
    dy_m: f64,
    dz_m: f64,
    sigma_dz_m: Option<f64>,
    warnings: &'a [Warning],
}

impl Between {
    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        self.fields.refuse_empty()?;
        let inputs = Inputs {
            entries: self.fields.entries(),
            with_uncertainty: true,
            pair: self.pair,
            ..Inputs::default()
        };
        let assessment = inputs.assess();
        if let Some(note) = assessment.notes.iter().find(|note| note.severity == Severity::Error) {
            return Err(Warning::of(note).to_string());
        }
        let Some(points) = &assessment.geometry.two_points else {
            let mut options: Vec<String> = Vec::new();
            for option in missing_for(Section::TwoPoints, &inputs)
                .into_iter()
                .map(|key| name(key, Part::Value))
            {
                if !options.contains(&option) {
                    options.push(option);
                }
            }
            if options.is_empty() {
                options = ["fx", "baseline", "cx", "cy", "from", "to"].map(str::to_owned).into();
            }
            return Err(CommandLine::NoWay { options }.to_string());
        };
        let warnings: Vec<Warning> = assessment.notes.iter().map(Warning::of).collect();
        if self.fields.json {
            return json(points, &warnings);
        }
        let mut text = String::new();
        for (place, (what, value)) in report::two_points(self.fields.style(), points, self.fields.unit)
            .into_iter()
            .enumerate()
        {
            let line = if place == 0 {
                format!("{value} ({})\n", what.to_lowercase())
            } else {
                format!("  {what}: {value}\n")
            };
            text.push_str(&line);
        }
        Ok(Reply {
            text: in_sentence(&text),
            warnings: warnings.iter().map(Warning::to_string).collect(),
        })
    }
}

fn json(points: &TwoPointsSolution, warnings: &[Warning]) -> Result<Reply, String> {
    let sigma = |sigma: f64| (sigma > 0.0).then_some(sigma);
    let answer = Answer {
        distance_m: points.distance.value.m(),
        sigma_m: sigma(points.distance.sigma.m()),
        dx_m: points.dx.m(),
        dy_m: points.dy.m(),
        dz_m: points.dz.value.m(),
        sigma_dz_m: sigma(points.dz.sigma.m()),
        warnings,
    };
    let text = serde_json::to_string_pretty(&answer).map_err(|error| error.to_string())?;
    Ok(Reply::without_warnings(text + "\n"))
}
