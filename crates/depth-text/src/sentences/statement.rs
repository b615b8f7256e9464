//! What follows from the numbers: whether two distances agree, what to look at if not, and how good a description is.

use super::words::{capital, percent, short_name, sigmas, sizes};
use crate::assess::Assessment;
use crate::field::Key;
use crate::names::Named as _;
use crate::number::{plain, significant};
use crate::style::Style;
use crate::variants::variants;
use depth_core::agreement::{Agreement, Suspect, Verdict};
use depth_core::problem::{Field, Method, Uncertainty};
use depth_core::quantity::{Length, LengthUnit};
use depth_core::setup::Object;
use std::fmt::{self, Display, Formatter};

variants! {
    /// A sentence about results.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub enum Statement {
        /// The stated uncertainties explain the difference of so many σ.
        Agree { z: f64, pair: Pair },
        /// The difference is large.
        HardlyAgree { z: f64, pair: Pair },
        /// The difference is too large.
        Disagree { z: f64, pair: Pair },
        /// Nothing says how well they agree: not each has a σ of its own.
        CannotJudge { ratio: Option<f64>, pair: Pair },
        /// So too, and one is so much larger that not both can be right.
        Contradict { ratio: Option<f64>, pair: Pair },

        /// The lens stands in the distance.
        LensAdded { lens: Length, unit: LengthUnit },
        /// Which mil it is.
        NatoMil,
        /// The σ of two photographs is that of one pixel, as none was typed.
        OnePixelEach,
        /// What the combined distance is.
        Combined,
        /// The input behind most of the variance, and its share.
        MainCause { key: Key, share: f64 },
        /// Why there is no distance is said at this field.
        SeeNote { key: Key },

        /// The disparity may be a stored fixed-point number.
        RawDisparity { scale: f64 },
        /// A length may be in another unit.
        UnitSlip { key: Key, taken: LengthUnit, meant: LengthUnit },
        /// Pixels may have been counted in a resized image.
        OtherSize { key: Key, times: f64 },
        /// An input without σ.
        NoSigma { key: Key },
        /// The input with the largest σ.
        LargestSigma { key: Key },

        /// The widths are what the stereo distance predicts.
        WidthsAgree { is_given: bool, object: Object },
        /// The widths are off by this fraction.
        WidthsDiffer { off: f64, is_given: bool, object: Object },
        /// A width is missing.
        WidthsNeeded { is_given: bool, object: Object },
        /// Without a stereo distance there is nothing to check.
        WidthsRepeat,
        /// Neither distance is there.
        WidthsCheck { object: Object },

        /// σ alone would mislead; the interval does not, nor does the simulation where there is one.
        FirstOrderIsPoor { has_simulation: bool },
    }
}

impl Statement {
    /// Whether both distances agree; `None` where there are not two, or nobody asked how sure they are and they are near enough.
    pub fn comparison(assessment: &Assessment) -> Option<Self> {
        let solution = &assessment.solution;
        let comparison = solution.comparison?;
        let (ratio, pair) = (comparison.ratio, Pair::of(assessment));
        let has_sigma = Method::ALL.into_iter().any(|method| solution.uncertainty(method).is_some());
        match comparison.agreement {
            Some(Agreement { z, verdict }) => Some(match verdict {
                Verdict::Agree => Self::Agree { z, pair },
                Verdict::Doubtful => Self::HardlyAgree { z, pair },
                Verdict::Disagree => Self::Disagree { z, pair },
            }),
            None if comparison.contradict() => Some(Self::Contradict { ratio, pair }),
            None => has_sigma.then_some(Self::CannotJudge { ratio, pair }),
        }
    }

    /// Whether both agree, in a word or two; `None` for another sentence.
    pub const fn verdict(&self) -> Option<&'static str> {
        match self {
            Self::Agree { .. } => Some("They agree"),
            Self::HardlyAgree { .. } => Some("They hardly agree"),
            Self::Disagree { .. } | Self::Contradict { .. } => Some("They disagree"),
            _ => None,
        }
    }

    /// The input behind most of the variance.
    pub fn main_cause(assessment: &Assessment, uncertainty: &Uncertainty) -> Option<Self> {
        let cause = uncertainty.main_cause()?;
        Some(Self::MainCause {
            key: assessment.worded(cause.source),
            share: cause.share,
        })
    }

    /// What a suspect is suspected of.
    pub fn suspect(assessment: &Assessment, suspect: &Suspect) -> Self {
        let worded = |source: Field| assessment.worded(source);
        match *suspect {
            Suspect::RawDisparity { scale } => Self::RawDisparity { scale },
            Suspect::Unit { source, taken, meant } => Self::UnitSlip {
                key: worded(source),
                taken,
                meant,
            },
            Suspect::Resized { source, times } => Self::OtherSize {
                key: worded(source),
                times,
            },
            Suspect::NoSigma(source) => Self::NoSigma { key: worded(source) },
            Suspect::LargestSigma(source) => Self::LargestSigma { key: worded(source) },
        }
    }

    /// How far the entered widths are off what the stereo distance predicts, or what would be needed to know.
    pub fn widths(assessment: &Assessment) -> Self {
        let solution = &assessment.solution;
        let object = solution.problem.object;
        let has = |method| solution.outcome(method).distance().is_some();
        let is_given = has(Method::Stereo) && assessment.distance(Method::Stereo).is_none();
        match solution.width_discrepancy() {
            Some(off) if off.abs() < 0.0005 => Self::WidthsAgree { is_given, object },
            Some(off) => Self::WidthsDiffer { off, is_given, object },
            None if has(Method::Stereo) => Self::WidthsNeeded { is_given, object },
            None if has(Method::Monocular) => Self::WidthsRepeat,
            None => Self::WidthsCheck { object },
        }
    }
}

/// The two distances that are compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Pair {
    /// Both were computed.
    StereoAndMonocular,
    /// The first one was given, to solve the stereo equation for something else.
    GivenAndMonocular,
    /// The second one was given.
    StereoAndGiven,
}

impl Pair {
    fn of(assessment: &Assessment) -> Self {
        match assessment.unknown.as_ref().map(|unknown| unknown.method) {
            None => Self::StereoAndMonocular,
            Some(Method::Stereo) => Self::GivenAndMonocular,
            Some(Method::Monocular) => Self::StereoAndGiven,
        }
    }

    const fn names(self) -> [&'static str; 2] {
        match self {
            Self::StereoAndMonocular => ["stereo", "monocular"],
            Self::GivenAndMonocular => ["the given distance", "monocular"],
            Self::StereoAndGiven => ["stereo", "the given distance"],
        }
    }

    /// "Stereo and monocular"
    fn both(self) -> String {
        let [first, second] = self.names();
        format!("{} and {second}", capital(first))
    }

    /// "monocular is 10.00 times stereo", with the ratio of the first to the second.
    fn times(self, ratio: Option<f64>) -> Option<String> {
        let (ratio, [first, second]) = (ratio?, self.names());
        Some(if ratio >= 1.0 {
            format!("{first} is {} times {second}", significant(ratio, 3))
        } else {
            format!("{second} is {} times {first}", significant(1.0 / ratio, 3))
        })
    }
}

/// Where the estimated widths are from.
const fn from(is_given: bool) -> &'static str {
    if is_given { "given" } else { "stereo" }
}

impl Display for Statement {
    #[expect(clippy::too_many_lines, reason = "an arm is a sentence, and the compiler asks for each")]
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match *self {
            Self::Agree { z, pair } => write!(f, "{} agree within their uncertainties{}.", pair.both(), apart(z)),
            Self::HardlyAgree { z, pair } => write!(
                f,
                "{} hardly agree{}: one case in twenty, if the uncertainties are right.",
                pair.both(),
                apart(z)
            ),
            Self::Disagree { z, pair } => write!(f, "{} disagree{}: an input or its uncertainty is wrong.", pair.both(), apart(z)),
            Self::CannotJudge { ratio, pair } => write!(
                f,
                "Agreement can be judged only where both distances have an uncertainty of their own{}.",
                pair.times(ratio).map_or_else(String::new, |times| format!("; {times}"))
            ),
            Self::Contradict { ratio, pair } => match pair.times(ratio) {
                Some(times) => write!(f, "{}: an input is wrong.", capital(&times)),
                None => write!(f, "{} have nothing to do with each other: an input is wrong.", pair.both()),
            },
            Self::LensAdded { lens, unit } => write!(
                f,
                "with the {} of the lens, which so near are more than 1 % of the distance: a focused lens has its image at f·D/(D − f), not at f",
                Style::WINDOW.length(Some(lens), unit)
            ),
            Self::NatoMil => f.write_str("A mil is 1/6400 of the circle here (NATO), 0.98175 mrad; that of many rifle scopes is the mrad"),
            Self::OnePixelEach => f.write_str("± is for 1 px in each width, as no uncertainty was typed"),
            Self::Combined => f.write_str("combined, the shared focal length accounted for"),
            Self::MainCause { key, share } => {
                let how = if share >= 0.5 { "mostly" } else { "most of it" };
                write!(f, "{how} from {} ({})", short_name(key), percent(share))
            }
            Self::SeeNote { key } => write!(f, "none; see the note on {}", key.noun),
            Self::RawDisparity { scale } => write!(
                f,
                "Was the disparity divided by {}? {}",
                plain(scale),
                if scale == 16.0 {
                    "StereoBM and StereoSGBM store sixteenths of a pixel."
                } else {
                    "Some files store fixed-point numbers."
                }
            ),
            Self::UnitSlip { key, taken, meant } => write!(
                f,
                "Is {} really in {}? In {} the two would agree.",
                key.noun,
                taken.name(),
                meant.name()
            ),
            Self::OtherSize { key, times } => write!(
                f,
                "Was {} counted in an image of another size ({} times) than the focal length belongs to?",
                key.noun,
                plain(times)
            ),
            Self::NoSigma { key } => write!(f, "{} is taken to be exact. How well is it known?", capital(key.noun)),
            Self::LargestSigma { key } => write!(f, "{} is the least certain: measure it again.", capital(key.noun)),
            Self::WidthsAgree { is_given, object } => write!(
                f,
                "Computed from the {} distance, as a check: both {} agree with what you entered to within 0.1 %.",
                from(is_given),
                both(object)
            ),
            Self::WidthsDiffer { off, is_given, object } => write!(
                f,
                "Computed from the {} distance, as a check. {} is {} % {} than {} predicts: one of the two, or the distance, is off.",
                from(is_given),
                capital(sizes(object)[0]),
                significant(off.abs() * 100.0, 2),
                if off > 0.0 { "larger" } else { "smaller" },
                sizes(object)[1]
            ),
            Self::WidthsNeeded { is_given, object } => write!(
                f,
                "Computed from the {} distance. Enter both {} to check one method against the other.",
                from(is_given),
                both(object)
            ),
            Self::WidthsRepeat => f.write_str(
                "Without a stereo distance these only repeat what you entered. Enter a baseline and a disparity to make them a check.",
            ),
            Self::WidthsCheck { object } => write!(
                f,
                "Computed from the stereo distance, as a check on the {} you entered.",
                both(object)
            ),
            Self::FirstOrderIsPoor { has_simulation: true } => f.write_str(
                "What is measured in the image is uncertain by more than 10 %: ± σ describes this poorly. Rely on the interval or the simulation.",
            ),
            Self::FirstOrderIsPoor { has_simulation: false } => {
                f.write_str("What is measured in the image is uncertain by more than 10 %: plus or minus σ describes this poorly, the interval does not.")
            }
        }
    }
}

/// What is compared with what the distance predicts: "widths".
const fn both(object: Object) -> &'static str {
    match object {
        Object::Width => "widths",
        Object::Height => "heights",
        Object::Ball => "sizes",
    }
}

/// " (1.6 σ apart)"
fn apart(z: f64) -> String {
    format!(" ({} σ apart)", sigmas(z))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn distances_that_only_rounding_tells_apart_are_not_apart() {
        for (z, expected) in [(5e-15, "(0 σ apart)"), (1.56, "(1.6 σ apart)"), (12.3, "(over 10 σ apart)")] {
            let sentence = Statement::Agree {
                z,
                pair: Pair::StereoAndMonocular,
            }
            .to_string();
            assert!(sentence.contains(expected), "{sentence}");
        }
    }
}
