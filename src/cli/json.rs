//! The answer for a program to read.

use super::ascii::in_sentence;
use super::typed::name;
use super::warning::Warning;
use crate::core::agreement::Verdict;
use crate::core::angle::AngleUnit;
use crate::core::camera::PointSolution;
use crate::core::in_image::InImage;
use crate::core::measured::Measured;
use crate::core::problem::{Method, Origin, Solved};
use crate::core::quantity::{Length, LengthUnit, Pixels, Quantity};
use depth_text::assess::{Assessment, Unknown};
use depth_text::export::{Exporter, Results};
use depth_text::field::Key;
use depth_text::geometry::PointOrigin;
use depth_text::note::{Part, Severity};
use depth_text::sentences::Statement;
use depth_text::unit::Unit;
use serde::Serialize;
use std::collections::BTreeMap;

/// Lengths in meters; null for what is unknown or unbounded.
#[derive(Serialize)]
struct Answer<'a> {
    /// What was read, by the name of its option.
    inputs: BTreeMap<String, Input>,
    /// What of the object is measured, and how the cameras stand.
    object: &'static str,
    pair: &'static str,
    stereo: Option<Distance>,
    monocular: Option<Distance>,
    combined: Option<Combined>,
    agreement: Option<Agreement>,
    solved: Option<SolvedFor>,
    point: Option<Point>,
    estimated_width_px: Option<f64>,
    estimated_width_m: Option<f64>,
    warnings: &'a [Warning],
}

/// A value with its σ in the base unit: px, m or rad.
#[derive(Serialize)]
struct Input {
    value: f64,
    unit: Option<&'static str>,
    sigma: Option<f64>,
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

#[derive(Serialize)]
struct Agreement {
    z: f64,
    verdict: &'static str,
    suspects: Vec<String>,
}

#[derive(Serialize)]
struct SolvedFor {
    field: String,
    value: f64,
    unit: &'static str,
    sigma: Option<f64>,
}

#[derive(Serialize)]
struct Point {
    from: &'static str,
    x_m: f64,
    y_m: f64,
    z_m: f64,
    range_m: f64,
    sigma_x_m: Option<f64>,
    sigma_y_m: Option<f64>,
    sigma_z_m: Option<f64>,
    sigma_range_m: Option<f64>,
}

/// The answer in JSON, beside which these warnings were given.
pub(super) struct Json<'a> {
    pub(super) warnings: &'a [Warning],
}

impl Exporter for Json<'_> {
    type Error = serde_json::Error;

    fn export(&self, &Results { assessment, .. }: &Results<'_>) -> Result<String, serde_json::Error> {
        let solution = &assessment.solution;
        let answer = Answer {
            inputs: inputs(assessment),
            object: solution.problem.object.key(),
            pair: solution.problem.pair.key(),
            stereo: distance(assessment, Method::Stereo),
            monocular: distance(assessment, Method::Monocular),
            combined: solution.combined.map(|combined| Combined {
                distance_m: combined.value.m(),
                sigma_m: combined.sigma.m(),
            }),
            agreement: agreement(assessment),
            solved: assessment.unknown.as_ref().and_then(solved),
            point: assessment.geometry.point.map(|(origin, point)| of_point(origin, &point)),
            estimated_width_px: solution.estimated_width_px.map(Pixels::px),
            estimated_width_m: solution.estimated_width.map(Length::m),
            warnings: self.warnings,
        };
        Ok(serde_json::to_string_pretty(&answer)? + "\n")
    }
}

/// Every field that was read and is used, whichever it is.
fn inputs(assessment: &Assessment) -> BTreeMap<String, Input> {
    let is_refused = |key| assessment.note(key).is_some_and(|note| note.severity == Severity::Error);
    let used = assessment
        .readings
        .iter()
        .filter(|reading| !is_refused(reading.key) && !assessment.is_solved_for(reading.key));
    let inputs = used.map(|reading| {
        let input = Input {
            value: reading.value,
            unit: reading.base_unit().map(Unit::symbol),
            sigma: reading.sigma.filter(|&sigma| sigma > 0.0),
        };
        (name(reading.key, Part::Value), input)
    });
    inputs.collect()
}

/// The distance that was computed by `method`; one that was given is an input.
fn distance(assessment: &Assessment, method: Method) -> Option<Distance> {
    let uncertainty = assessment.solution.uncertainty(method);
    let interval = uncertainty.map(|uncertainty| uncertainty.interval);
    Some(Distance {
        distance_m: assessment.distance(method)?.m(),
        sigma_m: uncertainty.map(|uncertainty| uncertainty.sigma.m()),
        near_m: interval.map(|interval| interval.near.m()),
        far_m: interval.and_then(|interval| interval.far).map(Length::m),
    })
}

/// σ, where there is one.
fn sigma<Q: Quantity>(measured: Measured<Q>) -> Option<f64> {
    Some(measured.sigma.to_base()).filter(|&sigma| sigma > 0.0)
}

fn agreement(assessment: &Assessment) -> Option<Agreement> {
    let agreement = assessment.solution.comparison?.agreement?;
    Some(Agreement {
        z: agreement.z,
        verdict: match agreement.verdict {
            Verdict::Agree => "agree",
            Verdict::Doubtful => "doubtful",
            Verdict::Disagree => "disagree",
        },
        suspects: assessment
            .suspects()
            .iter()
            .map(|suspect| in_sentence(&Statement::suspect(assessment, suspect).to_string()))
            .collect(),
    })
}

fn solved(unknown: &Unknown) -> Option<SolvedFor> {
    let found = unknown.outcome.as_ref().ok()?;
    let key = Key::from(unknown.field);
    Some(SolvedFor {
        field: name(key, Part::Value),
        value: found.to_base().value,
        unit: match found {
            Solved::InImage(InImage::Pixels(_)) => Unit::Pixel,
            Solved::InImage(InImage::Angle(_)) => Unit::Angle(AngleUnit::Radian),
            Solved::InImage(InImage::OnSensor(_)) | Solved::Length(_) => Unit::Length(LengthUnit::Meter),
        }
        .symbol(),
        sigma: sigma(found.to_base()),
    })
}

fn of_point(origin: PointOrigin, point: &PointSolution) -> Point {
    // Beside others a σ of 0 is one: that of a row in the middle of the image.
    let has_sigma = point.z.sigma.m() > 0.0 || point.range.sigma.m() > 0.0;
    let sigma = |length: Measured<Length>| has_sigma.then(|| length.sigma.m());
    Point {
        from: match origin {
            PointOrigin::Distance(Origin::Combined) => "combined",
            PointOrigin::Distance(Origin::Method(Method::Stereo)) | PointOrigin::Given(Method::Stereo) => "stereo",
            PointOrigin::Distance(Origin::Method(Method::Monocular)) | PointOrigin::Given(Method::Monocular) => "monocular",
            PointOrigin::Range => "range",
        },
        x_m: point.x.value.m(),
        y_m: point.y.value.m(),
        z_m: point.z.value.m(),
        range_m: point.range.value.m(),
        sigma_x_m: sigma(point.x),
        sigma_y_m: sigma(point.y),
        sigma_z_m: sigma(point.z),
        sigma_range_m: sigma(point.range),
    }
}
