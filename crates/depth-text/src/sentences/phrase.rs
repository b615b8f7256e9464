//! What stands in the cells of the answer: short enough for half a column.

use super::words::{percent, sigmas};
use crate::names::Named as _;
use crate::number::{Notation, plain};
use depth_core::problem::Method;
use depth_core::quantity::LengthUnit;
use std::fmt::{self, Display, Formatter};

/// A few words in a cell of the answer. Fields stand there by their symbols.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "the facts of a sentence have the names of what they are")]
pub enum Phrase {
    /// The title of what both distances are together.
    Combined,
    /// What stands in place of it while there are not two.
    NeedsBoth,
    /// The last value while an input cannot be used.
    Was { text: String },
    /// In front of an example.
    Example,
    /// What the combined distance is good for.
    WhatCombinedIs,
    /// The input with most of the variance, and its share.
    From { share: String, of: &'static str },
    /// What one pixel of disparity changes.
    WithOnePixel { range: String },
    /// No input of a distance has a σ.
    TakenToBeExact,
    /// How far both are apart, and which weight the stereo distance has.
    Apart { z: f64, of_stereo: f64 },
    /// The focal length is in both.
    SharedFocalLength,
    /// Why the combined σ is not smaller than both.
    Widened { z: f64 },
    /// They hardly agree.
    OneInTwenty,
    /// Stereo over monocular.
    Times { ratio: Option<f64> },
    /// Without σ they cannot be combined.
    NeedsSigmas,
    /// When agreement can be judged.
    HowToJudge,
    /// One of two distances is missing.
    OneIsMissing { missing: Method },
    /// The other one is there.
    StandsAlone { method: Method },
    /// The other one is there, and nothing was typed for this one.
    AloneSoFar { method: Method },
    /// What is still needed for it.
    ToCheckIt { needs: String },

    /// In front of why there is no distance.
    NoDistance,
    /// The same where something else is solved for.
    NoAnswer,
    /// No distance: zero or below.
    MustBePositive { symbol: &'static str, zero: String },
    /// No distance: the sum of disparity and offset.
    SumMustBePositive,
    /// No distance: what was typed is no number.
    CannotBeRead { symbol: &'static str },
    /// No distance: what was typed is a number that does not help.
    CannotBeUsed { symbol: &'static str },
    /// Why a disparity must be positive.
    BehindTheCameras { typed: String },
    /// Why it cannot be zero.
    InfinitelyFar { zero: String },
    /// What to look at with an offset.
    SignOfDoffs,
    /// Why a baseline is positive.
    NoSign,

    /// The disparity may be a stored fixed-point number.
    NotDivided { scale: f64 },
    /// A length may be in another unit.
    ReallyIn {
        symbol: &'static str,
        taken: LengthUnit,
        meant: LengthUnit,
    },
    /// Pixels may have been counted in a resized image.
    OtherSize { symbol: &'static str, times: f64 },
    /// An input without σ.
    HowWellKnown { symbol: &'static str },
    /// The input with the largest σ.
    MeasureAgain { symbol: &'static str },

    /// The distance with one pixel less.
    OneLess { disparity: String, distance: String },
    /// The distance with one pixel more.
    OneMore { disparity: String, distance: String },
    /// Who stores sixteenths of a pixel.
    AsOpenCvReturns,
    /// How far the matcher must search.
    NumDisparities { number: u32 },
    /// What one pixel of disparity means at a distance.
    OnePixel,
    /// The disparity as OpenCV has it.
    ForOpenCv,
    /// Disparity and offset together.
    EffectiveDisparity,
    /// What that is for.
    WhatDistanceCounts,
    /// When an offset is zero.
    ZeroForRectified,
    /// What one pixel covers.
    OnePixelOnObject,
    /// How that is measured.
    SidewaysAtDistance,
    /// The angle between two lines of sight.
    BetweenRays,
    /// What it is good for.
    WiderIsBetter,
    /// The angle that an object takes.
    ObjectSpans,
    /// What it is good for.
    LargerIsBetter,
    /// The σ of two photographs, where none was typed.
    OnePixelEach,
    /// How far the point in space is from the lens.
    PointIs { range: String },
    /// The mean of many such distances is too far by this.
    MeanIsTooFar { bias: String },
    /// What the budget of the ground plane is of.
    DistanceAlongFloor,
    /// Nothing is solved for yet.
    ChooseQuantity,
    /// From the lens, not along the floor.
    SlantIs { length: String },
}

impl Display for Phrase {
    #[expect(clippy::too_many_lines, reason = "an arm is a sentence, and the compiler asks for each")]
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Combined => f.write_str("Combined"),
            Self::NeedsBoth => f.write_str("needs both distances"),
            Self::Was { text } => write!(f, "was {text}"),
            Self::Example => f.write_str("Example: "),
            Self::WhatCombinedIs => f.write_str("One number, and whether the two agree"),
            Self::From { share, of } => write!(f, "{share} from {of}"),
            Self::WithOnePixel { range } => write!(f, "{range} with d ± 1 px"),
            Self::TakenToBeExact => f.write_str("Type ± to see how sure it is"),
            Self::Apart { z, of_stereo } => write!(f, "{} σ apart; stereo weighs {}", sigmas(*z), percent(*of_stereo)),
            Self::SharedFocalLength => f.write_str("The shared fx is counted once"),
            Self::Widened { z } => write!(f, "{0} σ apart, so ± is {0} times as wide", sigmas(*z)),
            Self::OneInTwenty => f.write_str("One case in twenty, if each ± is right"),
            Self::Times { ratio: None } => f.write_str("The two have nothing to do with each other"),
            Self::Times { ratio: Some(ratio) } => {
                let larger = if *ratio >= 1.0 { "Stereo" } else { "Monocular" };
                match times(ratio.max(1.0 / ratio)).as_str() {
                    "1" => f.write_str("Both distances are equal"),
                    times => write!(f, "{larger} is {times} times as far"),
                }
            }
            Self::NeedsSigmas => f.write_str("needs ± in both"),
            Self::HowToJudge => f.write_str("Add ± to both to see if they agree"),
            Self::OneIsMissing { missing } => write!(f, "Needs both distances; {} is missing.", missing.name().to_ascii_lowercase()),
            Self::StandsAlone { method } => write!(f, "Until then {} stands alone.", method.name().to_ascii_lowercase()),

            Self::AloneSoFar { method } => write!(f, "{} stands alone so far", method.name()),
            Self::ToCheckIt { needs } => write!(f, "To check it, enter {}", needs.trim_start_matches("needs ")),
            Self::NoDistance => f.write_str("No distance"),
            Self::NoAnswer => f.write_str("No answer"),
            Self::MustBePositive { symbol, zero } => write!(f, "{}: {symbol} must be above {zero}.", Self::NoDistance),
            Self::SumMustBePositive => write!(f, "{}: d + doffs must be above 0 px.", Self::NoDistance),
            Self::CannotBeRead { symbol } => write!(f, "{}: {symbol} cannot be read.", Self::NoDistance),
            Self::CannotBeUsed { symbol } => write!(f, "{}: {symbol} cannot be used.", Self::NoDistance),
            Self::BehindTheCameras { typed } => write!(f, "{typed} would lie behind the cameras."),
            Self::InfinitelyFar { zero } => write!(f, "At {zero} the object is infinitely far away."),
            Self::SignOfDoffs => f.write_str("Is the sign of doffs right?"),
            Self::NoSign => f.write_str("A baseline is a distance and has no sign."),

            Self::NotDivided { scale } => write!(f, "Was d divided by {}?", plain(*scale)),
            Self::ReallyIn { symbol, taken, meant } => {
                write!(
                    f,
                    "Is {symbol} really in {}? In {} they would agree.",
                    taken.symbol(),
                    meant.symbol()
                )
            }
            Self::OtherSize { symbol, times } => write!(f, "Is {symbol} of an image {} times as large?", plain(*times)),
            Self::HowWellKnown { symbol } => write!(f, "How well is {symbol} known? It has no ±."),
            Self::MeasureAgain { symbol } => write!(f, "{symbol} is the least certain: measure it again."),

            Self::OneLess { disparity, distance } => write!(f, "One less, {disparity}: {distance}"),
            Self::OneMore { disparity, distance } => write!(f, "One more, {disparity}: {distance}"),
            Self::AsOpenCvReturns => f.write_str("As StereoBM returns it"),
            Self::NumDisparities { number } => write!(f, "numDisparities: {number} or more"),
            Self::OnePixel => f.write_str("One pixel at this distance"),
            Self::ForOpenCv => f.write_str("For OpenCV"),
            Self::EffectiveDisparity => f.write_str("Effective disparity"),
            Self::WhatDistanceCounts => f.write_str("What the distance is computed from"),
            Self::ZeroForRectified => f.write_str("doffs is 0 px for most rectified pairs"),
            Self::OnePixelOnObject => f.write_str("One pixel on the object"),
            Self::SidewaysAtDistance => f.write_str("What a pixel covers at this distance"),
            Self::BetweenRays => f.write_str("Angle between the rays"),
            Self::WiderIsBetter => f.write_str("The wider, the surer the distance"),
            Self::ObjectSpans => f.write_str("The object spans"),
            Self::LargerIsBetter => f.write_str("The larger, the surer the distance"),
            Self::PointIs { range } => write!(f, "Range from the lens: {range}"),
            Self::MeanIsTooFar { bias } => write!(f, "The mean of many such distances is {bias} too far: average the pixels instead."),
            Self::OnePixelEach => f.write_str("± is for 1 px in each width"),
            Self::DistanceAlongFloor => f.write_str("Distance along the floor"),
            Self::ChooseQuantity => f.write_str("Choose what to solve for"),
            Self::SlantIs { length } => write!(f, "Slant, from the lens: {length}"),
        }
    }
}

/// How many times: to two digits, and to three where that would hide the difference.
fn times(ratio: f64) -> String {
    Notation::SHORT.readable(ratio, if ratio < 1.995 { 3 } else { 2 })
}
