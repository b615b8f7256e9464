//! `import`: what calibration files hold.

use super::calibration::{Calibration, FileOptions};
use super::reply::Reply;
use crate::core::quantity::{Length, Pixels};
use clap::{Args, ValueHint};
use depth_files::{Baseline, Basis, Camera, Found, Origin};
use depth_text::number::{Notation, TYPED_DIGITS};
use serde::Serialize;
use std::fmt::Write as _;
use std::path::PathBuf;

/// What was given to `import`.
#[derive(Debug, Args)]
pub(super) struct Import {
    /// The files of one calibration: one, or two where there is one for each camera; - for standard input
    #[arg(value_hint = ValueHint::FilePath, required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// The camera that is meant where there are several, or the two of a pair: by what `import` calls them, such as “left HD,right HD”
    #[arg(long, value_name = "NAME[,NAME]", value_delimiter = ',')]
    camera: Vec<String>,
    #[command(flatten)]
    options: FileOptions,
}

#[derive(Serialize)]
struct Answer {
    format: &'static str,
    cameras: Vec<AnswerCamera>,
    baseline_m: Option<f64>,
    baseline_file_units: Option<f64>,
    /// The places of the left and the right camera among these, or of the upper and the lower one.
    pair: Option<[usize; 2]>,
    vertical: bool,
    doffs_px: Option<f64>,
    baseline_origin: Option<AnswerOrigin>,
    doffs_origin: Option<AnswerOrigin>,
    rectified: bool,
    warnings: Vec<AnswerWarning>,
    ignored: Vec<String>,
}

#[derive(Serialize)]
struct AnswerCamera {
    name: String,
    width: Option<u32>,
    height: Option<u32>,
    fx: f64,
    fy: f64,
    cx: f64,
    cy: f64,
    /// None in a file that has no lines.
    line: Option<usize>,
    origin: AnswerOrigin,
    /// As the file lists them.
    distortion: Vec<f64>,
    /// Of the distortion, or of the camera.
    model: Option<String>,
    /// 1 σ of fx, fy, cx and cy.
    sigma_px: Option<[f64; 4]>,
}

/// Where a number comes from.
#[derive(Serialize)]
struct AnswerOrigin {
    file: String,
    /// None in a file that has no lines.
    line: Option<usize>,
    how: String,
}

#[derive(Serialize)]
struct AnswerWarning {
    message: String,
}

impl Import {
    /// The answer, or one sentence that says why there is none.
    pub(super) fn reply(&self) -> Result<Reply, String> {
        let calibration = Calibration {
            files: self.files.clone(),
            file_unit: self.options.file_unit,
            cameras: self.camera.clone(),
        };
        let found = calibration.found()?;
        let warnings: Vec<String> = found
            .warnings
            .iter()
            .map(|one| calibration.sentence(|names| one.sentence(names)))
            .chain(calibration.unused_unit(&found))
            .collect();
        if self.options.json {
            return Reply::json(&self.answer(found, warnings));
        }
        Ok(Reply {
            text: self.lines(&found),
            warnings,
        })
    }

    /// The names of the files, as they were given.
    fn names(&self) -> Vec<String> {
        self.files.iter().map(|file| file.display().to_string()).collect()
    }

    fn origin(&self, origin: &Origin) -> AnswerOrigin {
        AnswerOrigin {
            file: self
                .files
                .get(origin.file)
                .map(|file| file.display().to_string())
                .unwrap_or_default(),
            line: line(origin),
            how: origin.how.clone(),
        }
    }

    fn answer(&self, found: Found, warnings: Vec<String>) -> Answer {
        let camera = |camera: &Camera| {
            let [width, height] = camera.size.map_or([None; 2], |size| size.map(Some));
            AnswerCamera {
                name: camera.name.clone(),
                width,
                height,
                fx: camera.fx.px(),
                fy: camera.fy.px(),
                cx: camera.cx.px(),
                cy: camera.cy.px(),
                line: line(&camera.origin),
                origin: self.origin(&camera.origin),
                distortion: camera.distortion.clone(),
                model: camera.model.clone(),
                sigma_px: camera.sigma.map(|sigma| sigma.map(Pixels::px)),
            }
        };
        Answer {
            format: found.format.name(),
            cameras: found.cameras.iter().map(camera).collect(),
            baseline_m: found
                .baseline
                .and_then(|baseline| baseline.length(self.options.file_unit))
                .map(Length::m),
            baseline_file_units: match found.baseline {
                Some(Baseline::InFileUnits { value, .. }) => Some(value),
                _ => None,
            },
            pair: found.pair,
            vertical: found.is_vertical,
            doffs_px: found.doffs.map(|doffs| doffs.px()),
            baseline_origin: found.baseline_origin.as_ref().map(|origin| self.origin(origin)),
            doffs_origin: found.doffs_origin.as_ref().map(|origin| self.origin(origin)),
            rectified: found.is_rectified(),
            warnings: warnings.into_iter().map(|message| AnswerWarning { message }).collect(),
            ignored: found.ignored,
        }
    }

    fn lines(&self, found: &Found) -> String {
        let mut text = format!("{}\n", found.format.title());
        let names = self.names();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        let told = |origin: &Origin| {
            let place = origin.place().words(&names);
            // An archive has no lines.
            if place.is_empty() {
                origin.how.clone()
            } else {
                format!("{}, {place}", origin.how)
            }
        };
        let comes_from = |origin: &Option<Origin>| origin.as_ref().map_or_else(String::new, |origin| format!(", {}", told(origin)));
        for (at, camera) in found.cameras.iter().enumerate() {
            let size = camera
                .size
                .map_or_else(String::new, |[width, height]| format!("{width} x {height} px, "));
            let basis = match camera.basis {
                Basis::Rectified => "rectified",
                Basis::Raw => "raw",
            };
            let [fx, fy, cx, cy] = [camera.fx, camera.fy, camera.cx, camera.cy].map(|one| one.px());
            let (name, origin) = (&camera.name, told(&camera.origin));
            let place = place(found, at);
            let _ = writeln!(
                text,
                "{name}{place}: {size}fx {fx} px, fy {fy} px, cx {cx} px, cy {cy} px ({basis}, {origin})"
            );
        }
        match found.baseline.map(|baseline| (baseline, baseline.length(self.options.file_unit))) {
            Some((_, Some(length))) => {
                let _ = writeln!(
                    text,
                    "baseline {} m{}",
                    Notation::LONG.plain(length.m(), TYPED_DIGITS),
                    comes_from(&found.baseline_origin)
                );
            }
            Some((Baseline::InFileUnits { value, .. }, None)) => {
                let _ = writeln!(
                    text,
                    "baseline {value} (in the unit of the file: say it with --file-unit){}",
                    comes_from(&found.baseline_origin)
                );
            }
            _ => {}
        }
        if let Some(doffs) = found.doffs {
            let _ = writeln!(
                text,
                "doffs {} px{}",
                Notation::LONG.plain(doffs.px(), TYPED_DIGITS),
                comes_from(&found.doffs_origin)
            );
        }
        for line in &found.ignored {
            let _ = writeln!(text, "ignored: {line}");
        }
        text
    }
}

/// The line of a number, in a file that has lines.
const fn line(origin: &Origin) -> Option<usize> {
    match origin.line {
        0 => None,
        line => Some(line),
    }
}

/// Which of the pair the camera at `at` is.
fn place(found: &Found, at: usize) -> &'static str {
    match (found.pair, found.is_vertical) {
        (Some([first, _]), false) if first == at => " (left)",
        (Some([_, second]), false) if second == at => " (right)",
        (Some([first, _]), true) if first == at => " (upper)",
        (Some([_, second]), true) if second == at => " (lower)",
        _ => "",
    }
}
