//! Calibration files that are named on the command line, and what they fill in.

use super::ascii::in_sentence;
use super::file;
use crate::core::quantity::{Length, LengthUnit};
use clap::Args;
use depth_files::{Baseline, Found};
use std::path::PathBuf;

/// What is asked of a file by every command that answers with what is in it.
#[derive(Clone, Copy, Debug, Args)]
pub(super) struct FileOptions {
    /// What one unit is of a file that does not say its unit: 1mm, or 25mm where the board had squares of 25 mm
    #[arg(long, value_name = "LENGTH", value_parser = file_unit)]
    pub(super) file_unit: Option<Length>,
    /// Answer in JSON: lengths in meters, null for what is unknown
    #[arg(long)]
    pub(super) json: bool,
}

/// Files of one calibration.
#[derive(Clone, Debug)]
pub(super) struct Calibration {
    /// One file, or two where a format keeps the cameras apart.
    pub(super) files: Vec<PathBuf>,
    /// What one unit is of a file that does not say it.
    pub(super) file_unit: Option<Length>,
    /// The camera of them, or the pair, that is meant: none for the one that is taken first.
    pub(super) cameras: Vec<String>,
}

/// What `1mm`, `25 mm` or `mm` is, the unit of a file.
pub(super) fn file_unit(text: &str) -> Result<Length, String> {
    let at = text.find(char::is_alphabetic).unwrap_or(text.len());
    let (number, symbol) = text.split_at(at);
    let unit = LengthUnit::ALL.into_iter().find(|unit| unit.symbol() == symbol.trim());
    let number = if number.trim().is_empty() {
        Ok(1.0)
    } else {
        number.trim().parse::<f64>()
    };
    match (number, unit) {
        (Ok(number), Some(unit)) if number > 0.0 && number.is_finite() => Ok(Length::new(number, unit)),
        _ => Err("a length is needed, such as 1mm, or 25mm for squares of the board".to_owned()),
    }
}

impl Calibration {
    /// What the files say, or one sentence that says why they say nothing.
    pub(super) fn found(&self) -> Result<Found, String> {
        let files = self.files.iter().map(|path| file::bytes(path)).collect::<Result<Vec<_>, _>>()?;
        let files: Vec<&[u8]> = files.iter().map(Vec::as_slice).collect();
        let mut found = depth_files::read(&files).map_err(|refusal| self.sentence(|names| refusal.sentence(names)))?;
        if !self.cameras.is_empty() {
            let cameras: Vec<&str> = self.cameras.iter().map(String::as_str).collect();
            found = found
                .choose_named(&cameras)
                .map_err(|refusal| self.sentence(|names| refusal.sentence(names)))?;
        }
        Ok(match self.file_unit {
            Some(unit) => found.in_unit(unit),
            None => found,
        })
    }

    /// That `--file-unit` is not used, where the file or its format says the unit.
    pub(super) fn unused_unit(&self, found: &Found) -> Option<String> {
        let is_known = matches!(found.baseline, Some(Baseline::Known(_)));
        (self.file_unit.is_some() && is_known).then(|| {
            format!(
                "--file-unit is not used: {} has its baseline in a unit that is known.",
                found.format.title()
            )
        })
    }

    /// A sentence in which the files have their names.
    pub(super) fn sentence(&self, of: impl Fn(&[&str]) -> String) -> String {
        let names: Vec<String> = self.files.iter().map(|path| path.display().to_string()).collect();
        let names: Vec<&str> = names.iter().map(String::as_str).collect();
        in_sentence(&of(&names))
    }
}

#[cfg(test)]
mod tests {
    use super::file_unit;
    use crate::core::quantity::Length;

    #[test]
    fn the_unit_of_a_file_is_a_length() {
        for (text, meters) in [("1mm", 0.001), ("25 mm", 0.025), ("cm", 0.01), ("1 m", 1.0), ("0.5in", 0.0127)] {
            assert_eq!(file_unit(text), Ok(Length::from_m(meters)), "{text}");
        }
        for text in ["", "25", "0mm", "-1mm", "1 parsec", "mm mm"] {
            assert!(file_unit(text).is_err(), "{text}");
        }
    }
}
