//! Floor 4: the command line. The same `Inputs -> Problem -> Solution` as the screens, answered as text or JSON.

use crate::core::problem::{Field, Method, Outcome, Solution};
use crate::core::quantity::{Length, LengthUnit, Pixels};
use crate::formats::inputs::{Assessment, Entry, Inputs, Note, Severity, default_unit};
use crate::formats::report;
use clap::{Args, Parser, Subcommand};
use serde::Serialize;
use std::ffi::OsString;
use std::io::Write;
use std::process::ExitCode;

/// How far away is it, and how sure can I be?
///
/// Without arguments the program opens its window. With `calculate` it answers here and needs no display.
#[derive(Debug, Parser)]
#[command(name = "depth-calculator", version, about, long_about, arg_required_else_help = true)]
struct Cli {
    #[command(subcommand)]
    command: Task,
}

#[derive(Debug, Subcommand)]
enum Task {
    /// Compute the distance from a disparity (two cameras), from a known size (one camera), or both
    #[command(after_long_help = EXAMPLES)]
    Calculate(Box<Calculate>),
}

const EXAMPLES: &str = "\
Formulas:
  stereo      D = fx · b / (d + doffs)    needs --fx, --baseline, --disparity
  monocular   D = w_real · fx / w_img     needs --fx, --w-img, --w-real

Units:
  A length may carry mm, cm, m, in or ft (100mm, 0.1m). Bare, --baseline is in mm and --w-real in m.
  An uncertainty is one standard deviation: with a unit, in percent (1%), or bare in the unit of its value.
  A value that starts with a minus sign goes behind an equals sign: --doffs=-2.5

Examples:
  depth-calculator calculate --fx 700 --baseline 100mm --disparity 50
      a coffee mug, 1.400 m away
  depth-calculator calculate --fx 950 --w-img 200 --w-real 0.9m
      a doorway, 4.275 m away
  depth-calculator calculate --fx 700 --baseline 100 --disparity 50 \\
      --sigma-fx 2 --sigma-baseline 0.5mm --sigma-disparity 0.5 --json
      how sure one can be of the mug, for a program to read

A raw value of OpenCV's StereoBM or StereoSGBM is 16 times the disparity: divide it first.

Exit status: 0 with an answer, 2 with a one-line reason on stderr.";

#[derive(Debug, Args)]
struct Calculate {
    /// Focal length in pixels of the image that the other pixels are counted in
    #[arg(long, value_name = "PX")]
    fx: Option<String>,
    /// Distance between the two cameras; bare: in mm
    #[arg(long, value_name = "LENGTH")]
    baseline: Option<String>,
    /// Horizontal shift of the object between the rectified images, left x minus right x
    #[arg(long, value_name = "PX")]
    disparity: Option<String>,
    /// cx of the right camera minus cx of the left one, added to the disparity
    #[arg(long, value_name = "PX")]
    doffs: Option<String>,
    /// Width of the object in the image
    #[arg(long, value_name = "PX")]
    w_img: Option<String>,
    /// Width of the object itself; bare: in m
    #[arg(long, value_name = "LENGTH")]
    w_real: Option<String>,
    /// 1 σ of the focal length, such as 2 or 0.3%
    #[arg(long, value_name = "PX|%")]
    sigma_fx: Option<String>,
    /// 1 σ of the baseline, such as 0.5mm or 0.5%
    #[arg(long, value_name = "LENGTH|%")]
    sigma_baseline: Option<String>,
    /// 1 σ of the disparity, such as 0.25
    #[arg(long, value_name = "PX|%")]
    sigma_disparity: Option<String>,
    /// 1 σ of doffs
    #[arg(long, value_name = "PX|%")]
    sigma_doffs: Option<String>,
    /// 1 σ of the width in the image
    #[arg(long, value_name = "PX|%")]
    sigma_w_img: Option<String>,
    /// 1 σ of the real width, such as 1cm or 3%
    #[arg(long, value_name = "LENGTH|%")]
    sigma_w_real: Option<String>,
    /// Answer in JSON: lengths in metres, null for what is unknown or unbounded
    #[arg(long)]
    json: bool,
}

/// Reads the arguments of the process and answers on its standard output.
pub fn main() -> ExitCode {
    run(std::env::args_os(), &mut std::io::stdout().lock(), &mut std::io::stderr().lock())
}

/// Answers `arguments` (the program's name first) on `out`, or says on `err` in one line why not.
///
/// Status 0 with an answer, also when one method is complete and the other is not; 2 otherwise.
pub fn run(arguments: impl IntoIterator<Item = OsString>, out: &mut dyn Write, err: &mut dyn Write) -> ExitCode {
    const REFUSED: u8 = 2;
    let Task::Calculate(calculate) = match Cli::try_parse_from(arguments) {
        Ok(cli) => cli.command,
        Err(error) if !error.use_stderr() => return written(write!(out, "{}", error.render())),
        Err(error) => {
            let text = error.render().to_string();
            let reason = text.lines().next().unwrap_or_default().trim_start_matches("error: ");
            let _ = writeln!(err, "depth-calculator: {reason} (see --help)");
            return ExitCode::from(REFUSED);
        }
    };
    match answer(&calculate) {
        Ok(text) => written(writeln!(out, "{text}")),
        Err(reason) => {
            let _ = writeln!(err, "depth-calculator: {}", reason.replace('\n', " "));
            ExitCode::from(REFUSED)
        }
    }
}

/// A reader that went away (a closed pipe) wanted no more; nothing is wrong.
fn written(outcome: std::io::Result<()>) -> ExitCode {
    match outcome {
        Err(error) if error.kind() != std::io::ErrorKind::BrokenPipe => ExitCode::FAILURE,
        _ => ExitCode::SUCCESS,
    }
}

impl Calculate {
    fn inputs(&self) -> Inputs {
        let mut inputs = Inputs::default();
        inputs.with_uncertainty = true;
        for (field, value, sigma) in [
            (Field::FocalLength, &self.fx, &self.sigma_fx),
            (Field::Baseline, &self.baseline, &self.sigma_baseline),
            (Field::Disparity, &self.disparity, &self.sigma_disparity),
            (Field::Doffs, &self.doffs, &self.sigma_doffs),
            (Field::ImageWidth, &self.w_img, &self.sigma_w_img),
            (Field::RealWidth, &self.w_real, &self.sigma_w_real),
        ] {
            if let Some(text) = value {
                *inputs.entry_mut(field) = Entry::new(text, default_unit(field));
            }
            if let Some(text) = sigma {
                inputs.set_sigma(field, text);
            }
        }
        inputs
    }
}

/// The option that sets `field`, without its dashes.
const fn option(field: Field) -> &'static str {
    match field {
        Field::FocalLength => "fx",
        Field::Baseline => "baseline",
        Field::Disparity => "disparity",
        Field::Doffs => "doffs",
        Field::ImageWidth => "w-img",
        Field::RealWidth => "w-real",
    }
}

fn answer(calculate: &Calculate) -> Result<String, String> {
    let inputs = calculate.inputs();
    // An empty value is a variable of a script that was not set, not an input that was left out.
    for field in Field::ALL {
        let given = match field {
            Field::FocalLength => &calculate.fx,
            Field::Baseline => &calculate.baseline,
            Field::Disparity => &calculate.disparity,
            Field::Doffs => &calculate.doffs,
            Field::ImageWidth => &calculate.w_img,
            Field::RealWidth => &calculate.w_real,
        };
        if given.as_ref().is_some_and(|text| text.trim().is_empty()) {
            return Err(format!("--{} is empty: give it a value or leave it out.", option(field)));
        }
    }
    let assessment = inputs.assess();
    let mut warnings: Vec<Note> = assessment.notes.clone();
    let solution = &assessment.solution;
    let answered = Method::ALL.iter().any(|&method| solution.outcome(method).distance().is_some());
    let error = assessment.notes.iter().find(|note| note.severity == Severity::Error);
    if let Some(note) = error
        && !(answered && is_beside_the_answer(solution, note.field))
    {
        return Err(format!("--{}: {}", option(note.field), note.message));
    }
    if !answered {
        let missing: Vec<String> = inputs.missing().into_iter().map(|note| note.message).collect();
        return Err(format!("No distance can be computed. {}", missing.join(" ")));
    }
    // Half of the other method was given: that is worth a warning, an untouched one is not.
    warnings.extend(inputs.missing().into_iter().filter(|note| assessment.note(note.field).is_none()));
    Ok(if calculate.json {
        json(&assessment, &warnings)?
    } else {
        text(&assessment, &warnings)
    })
}

/// Whether `field` belongs only to a method that is not the one that gave an answer.
fn is_beside_the_answer(solution: &Solution, field: Field) -> bool {
    Method::ALL
        .into_iter()
        .filter(|&method| matches!(solution.outcome(method), Outcome::Distance(_)))
        .all(|method| !(method.fields().contains(&field) || (method == Method::Stereo && field == Field::Doffs)))
}

/// The answer as JSON. Lengths in metres; null for what is unknown or unbounded.
#[derive(Serialize)]
struct Answer {
    stereo: Option<Distance>,
    monocular: Option<Distance>,
    combined: Option<Combined>,
    estimated_width_px: Option<f64>,
    estimated_width_m: Option<f64>,
    warnings: Vec<Warning>,
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
struct Warning {
    field: &'static str,
    message: String,
}

fn json(assessment: &Assessment, warnings: &[Note]) -> Result<String, String> {
    let solution = &assessment.solution;
    let distance = |method: Method| {
        let known = solution.known(method);
        Some(Distance {
            distance_m: solution.outcome(method).distance()?.m(),
            sigma_m: known.map(|known| known.sigma.m()),
            near_m: known.map(|known| known.interval.near.m()),
            far_m: known.and_then(|known| known.interval.far).map(Length::m),
        })
    };
    let answer = Answer {
        stereo: distance(Method::Stereo),
        monocular: distance(Method::Monocular),
        combined: solution
            .together
            .as_ref()
            .and_then(|together| together.combined)
            .map(|combined| Combined {
                distance_m: combined.value,
                sigma_m: combined.sigma,
            }),
        estimated_width_px: solution.estimated_width_px.map(Pixels::px),
        estimated_width_m: solution.estimated_width.map(Length::m),
        warnings: warnings
            .iter()
            .map(|note| Warning {
                field: option(note.field),
                message: note.message.clone(),
            })
            .collect(),
    };
    serde_json::to_string_pretty(&answer).map_err(|error| error.to_string())
}

fn text(assessment: &Assessment, warnings: &[Note]) -> String {
    let mut lines = report::results(assessment, LengthUnit::Metre);
    for note in warnings {
        lines.push(format!("Warning, --{}: {}", option(note.field), note.message));
    }
    lines.join("\n")
}
