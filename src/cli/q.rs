//! `q`: what a Q matrix holds.

use super::ascii::in_sentence;
use super::options::unit_parser;
use super::reply::Reply;
use crate::core::q_matrix::StereoGeometry;
use crate::core::quantity::{Length, LengthUnit};
use clap::{Args, ValueHint};
use depth_text::note::Issue;
use depth_text::number::{Notation, TYPED_DIGITS};
use depth_text::q_matrix;
use depth_text::sentences::CommandLine;
use serde::Serialize;
use std::io::Read as _;
use std::path::{Path, PathBuf};

/// The largest file that is read: one with hundreds of cameras is smaller.
const LARGEST: u64 = 16 << 20;

/// What was given to `q`.
#[derive(Debug, Args)]
pub(super) struct Q {
    /// The file that the matrix is in; - for standard input
    #[arg(value_hint = ValueHint::FilePath)]
    file: PathBuf,
    /// Unit in which the calibration measured, which a Q matrix does not say
    #[arg(long, value_name = "UNIT", value_parser = unit_parser())]
    file_unit: Option<LengthUnit>,
    /// Answer in JSON: the baseline as the matrix has it, and in meters where --file-unit is given
    #[arg(long)]
    json: bool,
}

#[derive(Serialize)]
struct Answer {
    fx: f64,
    baseline: f64,
    baseline_m: Option<f64>,
    doffs_px: f64,
    cx: f64,
    cy: f64,
    warnings: Vec<String>,
}

impl Q {
    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        let geometry = q_matrix::read(&self.text()?).map_err(|issue| in_sentence(&issue.to_string()))?;
        let swapped = geometry.swapped.then(|| in_sentence(&Issue::QMatrixSwapped.to_string()));
        let warnings: Vec<String> = swapped.into_iter().collect();
        let baseline_m = self.file_unit.map(|unit| Length::new(geometry.baseline, unit).m());
        if self.json {
            let answer = Answer {
                fx: geometry.focal_length.px(),
                baseline: geometry.baseline,
                baseline_m,
                doffs_px: geometry.doffs.px(),
                cx: geometry.cx.px(),
                cy: geometry.cy.px(),
                warnings,
            };
            let text = serde_json::to_string_pretty(&answer).map_err(|error| error.to_string())?;
            return Ok(Reply::without_warnings(text + "\n"));
        }
        let text = self.lines(&geometry);
        Ok(Reply { text, warnings })
    }

    fn lines(&self, geometry: &StereoGeometry) -> String {
        let number = |value: f64| Notation::LONG.plain(value, TYPED_DIGITS);
        let unit = self.file_unit.map_or("(in the unit of the calibration)", LengthUnit::symbol);
        format!(
            "fx {} px\nbaseline {} {unit}\ndoffs {} px\ncx {} px\ncy {} px\n",
            number(geometry.focal_length.px()),
            number(geometry.baseline),
            number(geometry.doffs.px()),
            number(geometry.cx.px()),
            number(geometry.cy.px()),
        )
    }

    fn name(&self) -> String {
        self.file.display().to_string()
    }

    fn text(&self) -> Result<String, String> {
        let unreadable = |error: &dyn ToString| {
            let reason = error.to_string();
            let reason = reason.split(" (os error").next().unwrap_or_default().to_owned();
            CommandLine::UnreadableFile { file: self.name(), reason }.to_string()
        };
        let mut bytes = Vec::new();
        let read = if self.file == Path::new("-") {
            std::io::stdin().lock().take(LARGEST + 1).read_to_end(&mut bytes)
        } else {
            std::fs::File::open(&self.file).and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes))
        };
        let length = read.map_err(|error| unreadable(&error))?;
        if u64::try_from(length).is_ok_and(|length| length > LARGEST) {
            return Err(CommandLine::FileTooLarge { file: self.name() }.to_string());
        }
        String::from_utf8(bytes).map_err(|_| CommandLine::FileNotText { file: self.name() }.to_string())
    }
}
