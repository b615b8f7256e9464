//! The answer for a program to read.

use super::warning::Warning;
use crate::core::problem::{Method, Solution};
use crate::core::quantity::{Length, Pixels};
use depth_text::export::{Exporter, Results};
use serde::Serialize;

/// Lengths in meters; null for what is unknown or unbounded.
#[derive(Serialize)]
struct Answer<'a> {
    stereo: Option<Distance>,
    monocular: Option<Distance>,
    combined: Option<Combined>,
    estimated_width_px: Option<f64>,
    estimated_width_m: Option<f64>,
    warnings: &'a [Warning],
}

#[derive(Serialize)]
struct Distance {
    distance_m: f64,
    sigma_m: Option<f64>,
    near_m: Option<f64>,
    far_m: Option<f64>,
}

#[derive(Serialize)]
struct Combined {
    distance_m: f64,
    sigma_m: f64,
}

/// The answer in JSON, beside which these warnings were given.
pub(super) struct Json<'a> {
    pub(super) warnings: &'a [Warning],
}

impl Exporter for Json<'_> {
    type Error = serde_json::Error;

    fn export(&self, &Results { assessment, .. }: &Results<'_>) -> Result<String, serde_json::Error> {
        let solution = &assessment.solution;
        let combined = solution.comparison.and_then(|comparison| comparison.combined);
        let answer = Answer {
            stereo: distance(solution, Method::Stereo),
            monocular: distance(solution, Method::Monocular),
            combined: combined.map(|combined| Combined {
                distance_m: combined.value.m(),
                sigma_m: combined.sigma.m(),
            }),
            estimated_width_px: solution.estimated_width_px.map(Pixels::px),
            estimated_width_m: solution.estimated_width.map(Length::m),
            warnings: self.warnings,
        };
        Ok(serde_json::to_string_pretty(&answer)? + "\n")
    }
}

fn distance(solution: &Solution, method: Method) -> Option<Distance> {
    let uncertainty = solution.uncertainty(method);
    let interval = uncertainty.map(|uncertainty| uncertainty.interval);
    Some(Distance {
        distance_m: solution.outcome(method).distance()?.m(),
        sigma_m: uncertainty.map(|uncertainty| uncertainty.sigma.m()),
        near_m: interval.map(|interval| interval.near.m()),
        far_m: interval.and_then(|interval| interval.far).map(Length::m),
    })
}
