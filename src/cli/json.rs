//! The answer for a program to read.

use super::warning::Warning;
use crate::core::problem::{Method, Solution};
use crate::core::quantity::{Length, Pixels};
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

/// The answer as JSON, with a line end.
///
/// # Errors
/// Why it cannot be JSON.
pub(super) fn answer(solution: &Solution, warnings: &[Warning]) -> Result<String, String> {
    let distance = |method: Method| {
        let known = solution.uncertainty(method);
        Some(Distance {
            distance_m: solution.outcome(method).distance()?.m(),
            sigma_m: known.map(|known| known.sigma.m()),
            near_m: known.map(|known| known.interval.near.m()),
            far_m: known.and_then(|known| known.interval.far).map(Length::m),
        })
    };
    let combined = solution.comparison.and_then(|comparison| comparison.combined);
    let answer = Answer {
        stereo: distance(Method::Stereo),
        monocular: distance(Method::Monocular),
        combined: combined.map(|combined| Combined {
            distance_m: combined.value.m(),
            sigma_m: combined.sigma.m(),
        }),
        estimated_width_px: solution.estimated_width_px.map(Pixels::px),
        estimated_width_m: solution.estimated_width.map(Length::m),
        warnings,
    };
    let mut text = serde_json::to_string_pretty(&answer).map_err(|error| error.to_string())?;
    text.push('\n');
    Ok(text)
}
