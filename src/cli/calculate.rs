//! `calculate`: its options, and what is answered, warned about or refused.

use super::digits::in_sentence;
use super::{Reply, json, text};
use crate::core::problem::{Field, Method, Outcome, Solution};
use crate::core::quantity::LengthUnit;
use crate::formats::inputs::{Entry, Inputs, Note, Part, Severity, default_unit};
use clap::builder::{PossibleValuesParser, TypedValueParser};
use clap::{Args, ValueHint};
use serde::Serialize;

/// The lines are short enough for a manual page in 80 columns.
pub(super) const MORE_HELP: &str = "\
Formulas:
  stereo     D = fx · b / (d + doffs)   needs --fx, --baseline, --disparity
  monocular  D = w_real · fx / w_img    needs --fx, --w-img, --w-real

Units:
  A length may carry mm, cm, m, in or ft (100mm, 0.1m). Bare, --baseline is
  in mm and --w-real in m. An uncertainty is one standard deviation: with a
  unit, in percent (1%), or bare in the unit of its value. A raw value of
  OpenCV's StereoBM or StereoSGBM is 16 times the disparity: divide it.

Answer:
  The first line starts with the distance; with both methods and their
  uncertainties it is the two combined. Warnings go to standard error, or
  with --json into \"warnings\".

Examples:
  depth-calculator calculate --fx 700 --baseline 100mm --disparity 50
      a coffee mug, 1.400 m away
  depth-calculator calculate --fx 950 --w-img 200 --w-real 0.9m --unit ft
      a doorway, 14.03 ft away
  depth-calculator calculate --fx 700 --baseline 100 --disparity 50 \\
      --sigma-fx 2 --sigma-baseline 0.5mm --sigma-disparity 0.5 --json
      how sure one can be of the mug, for a program to read

Exit status:
  0 with an answer, 2 with a one-line reason on standard error,
  1 if the answer could not be written";

const UNCERTAINTY: &str = "Uncertainty";
const OUTPUT: &str = "Output";

#[derive(Debug, Args)]
pub(super) struct Calculate {
    /// Focal length in pixels of the image that the other pixels are counted in
    #[arg(long, value_name = "PX", value_hint = ValueHint::Other)]
    fx: Option<String>,
    /// Distance between the two cameras; bare: in mm
    #[arg(long, value_name = "LENGTH", value_hint = ValueHint::Other)]
    baseline: Option<String>,
    /// Horizontal shift of the object between the rectified images, left x minus right x
    #[arg(long, value_name = "PX", value_hint = ValueHint::Other)]
    disparity: Option<String>,
    /// cx of the right camera minus cx of the left one, added to the disparity
    #[arg(long, value_name = "PX", value_hint = ValueHint::Other)]
    doffs: Option<String>,
    /// Width of the object in the image
    #[arg(long, value_name = "PX", value_hint = ValueHint::Other)]
    w_img: Option<String>,
    /// Width of the object itself; bare: in m
    #[arg(long, value_name = "LENGTH", value_hint = ValueHint::Other)]
    w_real: Option<String>,
    /// 1 σ of the focal length, such as 2 or 0.3%
    #[arg(long, value_name = "PX|%", value_hint = ValueHint::Other, help_heading = UNCERTAINTY)]
    sigma_fx: Option<String>,
    /// 1 σ of the baseline, such as 0.5mm or 0.5%
    #[arg(long, value_name = "LENGTH|%", value_hint = ValueHint::Other, help_heading = UNCERTAINTY)]
    sigma_baseline: Option<String>,
    /// 1 σ of the disparity, such as 0.25
    #[arg(long, value_name = "PX|%", value_hint = ValueHint::Other, help_heading = UNCERTAINTY)]
    sigma_disparity: Option<String>,
    /// 1 σ of doffs
    #[arg(long, value_name = "PX|%", value_hint = ValueHint::Other, help_heading = UNCERTAINTY)]
    sigma_doffs: Option<String>,
    /// 1 σ of the width in the image
    #[arg(long, value_name = "PX|%", value_hint = ValueHint::Other, help_heading = UNCERTAINTY)]
    sigma_w_img: Option<String>,
    /// 1 σ of the real width, such as 1cm or 3%
    #[arg(long, value_name = "LENGTH|%", value_hint = ValueHint::Other, help_heading = UNCERTAINTY)]
    sigma_w_real: Option<String>,
    /// Unit of every length in the answer; JSON stays in meters
    #[arg(long, default_value = LengthUnit::Meter.symbol(), value_parser = unit_parser(), help_heading = OUTPUT)]
    unit: LengthUnit,
    /// Answer in JSON: lengths in meters, null for what is unknown or unbounded
    #[arg(long, help_heading = OUTPUT)]
    json: bool,
}

fn unit_parser() -> impl TypedValueParser<Value = LengthUnit> {
    PossibleValuesParser::new(LengthUnit::ALL.map(LengthUnit::symbol)).try_map(|symbol| {
        let unit = LengthUnit::ALL.into_iter().find(|unit| unit.symbol() == symbol);
        unit.ok_or("not a unit of length")
    })
}

/// What is to be said about an option without refusing it.
#[derive(Serialize)]
pub(super) struct Warning {
    /// The option without its dashes.
    field: String,
    message: String,
}

impl Warning {
    fn of(note: &Note) -> Self {
        Self {
            field: option(note.field, note.part),
            message: in_sentence(&note.message),
        }
    }
}

/// The option that sets the value of `field` or its σ, without its dashes.
fn option(field: Field, part: Part) -> String {
    let value = match field {
        Field::FocalLength => "fx",
        Field::Baseline => "baseline",
        Field::Disparity => "disparity",
        Field::Doffs => "doffs",
        Field::ImageWidth => "w-img",
        Field::RealWidth => "w-real",
    };
    match part {
        Part::Value => value.to_owned(),
        Part::Sigma => format!("sigma-{value}"),
    }
}

impl Calculate {
    /// What was typed for the value of `field` or for its σ.
    fn typed(&self, field: Field, part: Part) -> Option<&str> {
        let (value, sigma) = match field {
            Field::FocalLength => (&self.fx, &self.sigma_fx),
            Field::Baseline => (&self.baseline, &self.sigma_baseline),
            Field::Disparity => (&self.disparity, &self.sigma_disparity),
            Field::Doffs => (&self.doffs, &self.sigma_doffs),
            Field::ImageWidth => (&self.w_img, &self.sigma_w_img),
            Field::RealWidth => (&self.w_real, &self.sigma_w_real),
        };
        match part {
            Part::Value => value.as_deref(),
            Part::Sigma => sigma.as_deref(),
        }
    }

    fn inputs(&self) -> Inputs {
        let mut inputs = Inputs::default();
        inputs.with_uncertainty = true;
        for field in Field::ALL {
            if let Some(text) = self.typed(field, Part::Value) {
                *inputs.entry_mut(field) = Entry::new(text, default_unit(field));
            }
            if let Some(text) = self.typed(field, Part::Sigma) {
                inputs.set_sigma(field, text);
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
            && !(answered && is_beside_the_answer(solution, note.field))
        {
            let Warning { field, message } = Warning::of(note);
            return Err(format!("--{field}: {message}"));
        }
        if !answered {
            return Err(self.what_is_missing());
        }
        // Half of the other method was given: that is worth a warning, an untouched one is not.
        let missing = inputs.missing();
        let missing = missing.iter().filter(|note| assessment.note(note.field).is_none());
        let mut warnings: Vec<Warning> = assessment.notes.iter().chain(missing).map(Warning::of).collect();
        let unused = self.unused(solution);
        // What there is a better sentence about is not mentioned again.
        let is_new = |unused: &Warning| warnings.iter().all(|warning| warning.field != unused.field);
        let unused: Vec<Warning> = unused.into_iter().filter(is_new).collect();
        warnings.extend(unused);
        if self.json {
            return json::answer(solution, &warnings).map(Reply::without_warnings);
        }
        Ok(Reply {
            text: text::answer(&assessment, self.unit),
            warnings: warnings
                .iter()
                .map(|Warning { field, message }| format!("--{field}: {message}"))
                .collect(),
        })
    }

    /// An empty value is a variable of a script that was not set, not an input that was left out.
    fn refuse_empty(&self) -> Result<(), String> {
        for field in Field::ALL {
            for part in [Part::Value, Part::Sigma] {
                if self.typed(field, part).is_some_and(|text| text.trim().is_empty()) {
                    return Err(format!("--{} is empty: give it a value or leave it out.", option(field, part)));
                }
            }
        }
        Ok(())
    }

    /// Which options would give a distance: those of the methods of which something was typed, else those of both.
    fn what_is_missing(&self) -> String {
        let given = |field: Field| self.typed(field, Part::Value).is_some();
        let touched = |method: &Method| method.own_fields().into_iter().any(given);
        let any_touched = Method::ALL.iter().any(touched);
        let ways: Vec<String> = Method::ALL
            .iter()
            .filter(|method| touched(method) || !any_touched)
            .map(|method| {
                let missing = method.fields().into_iter().filter(|&field| !given(field));
                let options: Vec<String> = missing.map(|field| format!("--{}", option(field, Part::Value))).collect();
                format!("{} for the {} distance", enumerated(&options), method.name().to_lowercase())
            })
            .collect();
        format!("No distance can be computed. Add {} (see --help).", ways.join(", or "))
    }

    /// What was typed and plays no part in the answer.
    fn unused(&self, solution: &Solution) -> Vec<Warning> {
        let typed = |field, part| self.typed(field, part).is_some();
        let is_stereo = solution.stereo.distance().is_some() || Method::Stereo.own_fields().iter().any(|&field| typed(field, Part::Value));
        let reason = |field, part| match (field, part) {
            (Field::Doffs, _) if is_stereo => None,
            (Field::Doffs, _) => Some("Not used: it belongs to the stereo distance, which needs --baseline and --disparity.".to_owned()),
            (_, Part::Sigma) if !typed(field, Part::Value) => Some(format!("Not used without --{}.", option(field, Part::Value))),
            _ => None,
        };
        Field::ALL
            .into_iter()
            .flat_map(|field| [(field, Part::Value), (field, Part::Sigma)])
            .filter(|&(field, part)| typed(field, part))
            .filter_map(|(field, part)| {
                Some(Warning {
                    field: option(field, part),
                    message: reason(field, part)?,
                })
            })
            .collect()
    }
}

/// "a", "a and b", "a, b and c"
fn enumerated(words: &[String]) -> String {
    match words {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// Whether `field` belongs only to a method that is not the one that gave an answer.
fn is_beside_the_answer(solution: &Solution, field: Field) -> bool {
    Method::ALL
        .into_iter()
        .filter(|&method| matches!(solution.outcome(method), Outcome::Distance(_)))
        .all(|method| !(method.fields().contains(&field) || (method == Method::Stereo && field == Field::Doffs)))
}
