//! `q`: what a Q matrix holds.

use super::ascii::in_sentence;
use super::calibration::FileOptions;
use super::file;
use super::reply::Reply;
use crate::core::q_matrix::StereoGeometry;
use clap::{Args, ValueHint};
use depth_text::note::Issue;
use depth_text::number::{Notation, TYPED_DIGITS};
use depth_text::q_matrix;
use depth_text::sentences::CommandLine;
use serde::Serialize;
use std::path::PathBuf;

/// What was given to `q`.
#[derive(Debug, Args)]
pub(super) struct Q {
    /// The file that the matrix is in; - for standard input
    #[arg(value_hint = ValueHint::FilePath)]
    file: PathBuf,
    #[command(flatten)]
    options: FileOptions,
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
        let baseline_m = self.options.file_unit.map(|unit| unit.m() * geometry.baseline);
        if self.options.json {
            let answer = Answer {
                fx: geometry.focal_length.px(),
                baseline: geometry.baseline,
                baseline_m,
                doffs_px: geometry.doffs.px(),
                cx: geometry.cx.px(),
                cy: geometry.cy.px(),
                warnings,
            };
            return Reply::json(&answer);
        }
        let text = self.lines(&geometry);
        Ok(Reply { text, warnings })
    }

    fn lines(&self, geometry: &StereoGeometry) -> String {
        let number = |value: f64| Notation::LONG.plain(value, TYPED_DIGITS);
        let (baseline, unit) = match self.options.file_unit {
            Some(unit) => (unit.m() * geometry.baseline * 1000.0, "mm"),
            None => (geometry.baseline, "(in the unit of the calibration)"),
        };
        format!(
            "fx {} px\nbaseline {} {unit}\ndoffs {} px\ncx {} px\ncy {} px\n",
            number(geometry.focal_length.px()),
            number(baseline),
            number(geometry.doffs.px()),
            number(geometry.cx.px()),
            number(geometry.cy.px()),
        )
    }

    fn name(&self) -> String {
        self.file.display().to_string()
    }

    fn text(&self) -> Result<String, String> {
        let not_text = |_| CommandLine::FileNotText { file: self.name() }.to_string();
        String::from_utf8(file::bytes(&self.file)?).map_err(not_text)
    }
}
