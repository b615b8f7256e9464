//! What was found, and what the person says that the files do not.

use crate::app::rigs::Rig;
use crate::core::quantity::LengthUnit;
use depth_jobs::{Baseline, Calibration, Choice, Guess};
use depth_text::entry::Entry;
use depth_text::fields;
use depth_text::reading;

/// A calibration as it is shown.
#[derive(Debug)]
pub struct Shown {
    /// What the files say.
    pub found: Calibration,
    /// The place of the camera or pair that was chosen.
    pub choice: usize,
    /// The unit of the baseline, by its place among [`Self::units`], where the files do not say it and the person has.
    pub unit: Option<usize>,
    /// The size of a square of the board.
    pub square: Entry,
}

/// In what a baseline may be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FileUnit {
    /// In this unit.
    Length(LengthUnit),
    /// In squares of the board, whose size is typed beside it.
    Squares,
}

impl FileUnit {
    /// How it is offered, for a baseline of `value`.
    pub fn offer(self, value: &str) -> String {
        match self {
            Self::Length(unit) => format!("{value} {}", unit.symbol()),
            Self::Squares => format!("{value} squares of the board"),
        }
    }
}

impl Shown {
    /// `found` with nothing said yet.
    pub fn new(found: Calibration) -> Self {
        let mut shown = Self {
            choice: 0,
            unit: None,
            square: Entry::default(),
            found,
        };
        shown.choose(0);
        shown
    }

    /// Chooses the camera or pair at this place: what was said of another does not hold for it.
    pub fn choose(&mut self, choice: usize) {
        self.choice = choice;
        self.unit = None;
        self.square = match self.baseline() {
            // A size of 1 says nothing: the board was measured in its own squares.
            Some(Baseline::InFileUnits {
                guess: Guess::Squares { size },
                ..
            }) if size != 1.0 => {
                // Nobody prints squares of a meter, nor of a thousandth of a millimeter.
                let unit = if size < 1.0 { LengthUnit::Meter } else { LengthUnit::Millimeter };
                Entry::new(crate::app::rigs::number(size), Some(unit))
            }
            _ => Entry::new("", fields::SQUARE_SIZE.kind.length_unit()),
        };
    }

    /// What was chosen of it.
    pub fn chosen(&self) -> Option<&Choice> {
        self.found.choices.get(self.choice)
    }

    /// The baseline of what was chosen.
    pub fn baseline(&self) -> Option<Baseline> {
        self.chosen()?.baseline
    }

    /// The number of a baseline whose unit has to be asked for.
    pub fn asks_unit_of(&self) -> Option<f64> {
        match self.baseline() {
            Some(Baseline::InFileUnits { value, .. }) => Some(value),
            _ => None,
        }
    }

    /// The units that are offered, the plausible one first.
    pub fn units(&self) -> Vec<FileUnit> {
        let first = match self.baseline() {
            Some(Baseline::InFileUnits {
                guess: Guess::Unit(unit), ..
            }) => FileUnit::Length(unit),
            _ => FileUnit::Squares,
        };
        let lengths = [LengthUnit::Millimeter, LengthUnit::Centimeter, LengthUnit::Meter, LengthUnit::Inch];
        let all = lengths.map(FileUnit::Length).into_iter().chain([FileUnit::Squares]);
        std::iter::once(first).chain(all.filter(|unit| *unit != first)).collect()
    }

    /// The unit that was chosen.
    pub fn chosen_unit(&self) -> Option<FileUnit> {
        self.unit.and_then(|at| self.units().get(at).copied())
    }

    /// The unit as it is typed behind the number; `None` where it is not known yet.
    fn unit_text(&self) -> Option<String> {
        match self.chosen_unit()? {
            FileUnit::Length(unit) => Some(unit.symbol().to_owned()),
            FileUnit::Squares => {
                let size = reading::read(fields::SQUARE_SIZE, &self.square).ok()??;
                Some(format!("squares of {} {}", size.number_text, size.unit?.symbol()))
            }
        }
    }

    /// The rig that comes of it, which files with these `names` say; `None` where the unit of its baseline is still to be said.
    pub fn rig(&self, names: &[String]) -> Option<Rig> {
        let unit = self.unit_text();
        if self.asks_unit_of().is_some() && unit.is_none() {
            return None;
        }
        Some(Rig::of_calibration(self.chosen()?, &self.found.format, names, unit.as_deref()))
    }
}

#[cfg(test)]
#[allow(clippy::unwrap_used, reason = "tests")]
mod tests {
    use super::{FileUnit, Shown};
    use crate::core::quantity::LengthUnit;
    use depth_jobs::{Baseline, Calibration, Camera, Choice, Guess};
    use depth_text::fields;
    use depth_text::reading;

    fn found(baseline: Baseline) -> Calibration {
        let choice = |name: &str, baseline| Choice {
            name: name.to_owned(),
            camera: Camera {
                name: name.to_owned(),
                size: Some([640, 480]),
                intrinsics_px: [700.0, 701.0, 320.0, 240.0],
                sigma_px: Some([2.0, 2.0, 1.0, 1.0]),
                is_rectified: true,
                model: None,
                distortion: vec![-0.25, 0.5],
                origin: String::new(),
            },
            is_vertical: false,
            baseline,
            baseline_origin: String::new(),
            doffs_px: baseline.map(|_| 3.0),
            doffs_origin: String::new(),
            warnings: Vec::new(),
        };
        Calibration {
            format: "OpenCV FileStorage".into(),
            choices: vec![choice("left and right", Some(baseline)), choice("left alone", None)],
            ignored: Vec::new(),
        }
    }

    fn meters(shown: &Shown) -> Option<f64> {
        let rig = shown.rig(&["calib.yml".to_owned()])?;
        Some(reading::read(fields::BASELINE, rig.inputs.entry(fields::BASELINE)).unwrap()?.value)
    }

    #[test]
    fn nothing_comes_of_a_baseline_before_its_unit_is_said() {
        let guess = Guess::Unit(LengthUnit::Millimeter);
        let mut shown = Shown::new(found(Baseline::InFileUnits { value: 120.0, guess }));
        assert_eq!(shown.rig(&[]), None);
        assert_eq!(shown.units().first(), Some(&FileUnit::Length(LengthUnit::Millimeter)));
        shown.unit = Some(0);
        assert!((meters(&shown).unwrap() - 0.12).abs() < 1e-12);
    }

    #[test]
    fn squares_are_of_the_size_that_stands_beside_them() {
        let guess = Guess::Squares { size: 25.0 };
        let mut shown = Shown::new(found(Baseline::InFileUnits { value: 3.2, guess }));
        assert_eq!(shown.units().first(), Some(&FileUnit::Squares));
        shown.unit = Some(0);
        assert!((meters(&shown).unwrap() - 0.08).abs() < 1e-12);
        shown.square.text.clear();
        assert_eq!(shown.rig(&[]), None, "the size is asked for");
        let guess = Guess::Squares { size: 1.0 };
        let mut shown = Shown::new(found(Baseline::InFileUnits { value: 3.2, guess }));
        shown.unit = Some(0);
        assert_eq!(shown.rig(&[]), None, "so many squares, of a size that is not said");
        let guess = Guess::Squares { size: 0.025 };
        let mut shown = Shown::new(found(Baseline::InFileUnits { value: 3.2, guess }));
        shown.unit = Some(0);
        assert!((meters(&shown).unwrap() - 0.08).abs() < 1e-12, "squares of 25 mm, in meters");
    }

    #[test]
    fn a_baseline_belongs_to_its_pair_and_the_numbers_to_what_was_chosen() {
        let mut shown = Shown::new(found(Baseline::Meters(0.083_206_4)));
        assert!((meters(&shown).unwrap() - 0.083_206_4).abs() < 1e-12);
        let rig = shown.rig(&["calib.yml".to_owned()]).unwrap();
        assert_eq!(rig.name, "calib");
        assert_eq!(rig.inputs.entry(fields::FOCAL_LENGTH).sigma, "2");
        assert_eq!(rig.inputs.entry(fields::DOFFS).text, "3");
        assert_eq!(rig.inputs.entry(fields::FRAME_WIDTH).text, "640");
        assert_eq!(rig.distortion, "-0.25, 0.5");
        shown.choose(1);
        assert_eq!(meters(&shown), None);
    }

    #[test]
    fn what_is_used_takes_the_place_of_what_another_rig_left() {
        use crate::core::problem::{Field, Method};
        use depth_text::entry::Entry;
        use depth_text::form::Example;
        let shown = Shown::new(found(Baseline::Meters(0.12)));
        let mut before = Example::CoffeeMug.inputs();
        *before.entry_mut(fields::DOFFS) = Entry::new("131.1", None);
        *before.entry_mut(fields::ZERO) = Entry::new("4.2", None);
        let now = shown.rig(&[]).unwrap().used_in(&before);
        assert_eq!(now.entry(fields::FOCAL_LENGTH).text, "700");
        assert_eq!(now.entry(fields::BASELINE).text, "120");
        assert_eq!(now.entry(fields::DOFFS).text, "3");
        assert!(now.entry(fields::ZERO).is_blank());
        for (solved_for, stays) in [(Field::Baseline, false), (Field::Disparity, true)] {
            before.unknown = Some((Method::Stereo, solved_for));
            assert_eq!(shown.rig(&[]).unwrap().used_in(&before).unknown.is_some(), stays, "{solved_for:?}");
        }
        assert_eq!(now.entry(fields::DISPARITY).text, "50");
    }
}
