//! What is wrong with what was typed.

use super::words::{capital, quoted};
use crate::field::{Key, Kind};
use crate::fields;
use crate::names::Named as _;
use crate::note::Issue;
use crate::number::{Notation, TYPED_DIGITS, plain, significant};
use crate::unit::Unit;
use depth_core::angle::Angle;
use depth_core::disparity::NoDisparity;
use depth_core::q_matrix::Expected;
use depth_core::quantity::LengthUnit;
use std::fmt::{self, Display, Formatter};

const NO_MATCH: &str = "is how OpenCV’s matchers mark a pixel without a match: (minDisparity − 1) · 16, or that divided by 16.";

const DISTANCE_EXAMPLE: &str = "Type a distance above zero, such as 1.4 m.";

impl Display for Issue {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        value(self, f)
            .or_else(|| doubtful(self, f))
            .or_else(|| sigma(self, f))
            .or_else(|| missing(self, f))
            .or_else(|| other_ways(self, f))
            .unwrap_or(Ok(()))
    }
}

/// About the value of a field.
fn value(issue: &Issue, f: &mut Formatter<'_>) -> Option<fmt::Result> {
    Some(match issue {
        Issue::NotANumber { key, text } => write!(f, "{} is not a number. {}", quoted(text), what_to_type(*key)),
        Issue::UnknownUnit { key, unit } => write!(f, "{} is not a unit known here. {}", quoted(unit), units(key.kind)),
        Issue::SeveralSeparators { text } => write!(
            f,
            "{} has several separators and could mean different things. Type it with one decimal point, such as 1000.5.",
            quoted(text)
        ),
        Issue::UnusualSeparators { text, reading } => write!(
            f,
            "{} has separators that mean different things in different countries. Is it {reading}?",
            quoted(text)
        ),
        Issue::TwoReadings { text, many, few } => write!(f, "{} could mean {many} or {few}. Which one is it?", quoted(text)),
        Issue::LengthForPixels { key, text, unit } => write!(
            f,
            "{} is a length, but {} is counted in pixels. {}",
            quoted(text),
            key.noun,
            pixels_instead(*key, *unit)
        ),
        Issue::PixelsForLength { key } => write!(f, "{} is a length, not a number of pixels. {}", capital(key.noun), units(key.kind)),
        Issue::NotWhole { key, text } => write!(f, "{} is not a whole number. {}", quoted(text), what_to_type(*key)),
        Issue::Zero { key } => write!(f, "{} cannot be zero. {}", capital(key.noun), what_to_type(*key)),
        Issue::Negative { key } => write!(f, "{} cannot be negative. {}", capital(key.noun), what_to_type(*key)),
        Issue::TooExtreme { key, text } => write!(
            f,
            "With {} there is no distance that a computer can represent. {}",
            quoted(text),
            what_to_type(*key)
        ),
        Issue::ZeroDisparity => f.write_str(
            "A disparity of zero means that the object is infinitely far away. Type a disparity above 0 px.",
        ),
        Issue::NegativeDisparity => f.write_str(
            "A negative disparity usually means that the left and the right image are swapped. Swap them, or type it without the minus.",
        ),
        Issue::DisparityWithDoffs => f.write_str(
            "Disparity and doffs together must be above zero: at zero the object is infinitely far away, below zero left and right may be swapped. Check the sign of doffs.",
        ),
        _ => return None,
    })
}

/// About the value of a field that may be something else than it was taken for.
fn doubtful(issue: &Issue, f: &mut Formatter<'_>) -> Option<fmt::Result> {
    Some(match issue {
        Issue::NoMatch { text } => write!(f, "{} {NO_MATCH} There is no distance here.", quoted(text)),
        Issue::NoMatchUsed { text } => write!(f, "{} {NO_MATCH} Used all the same, as doffs makes it possible.", quoted(text)),
        Issue::NegativeBaseline => f.write_str(
            "A baseline is a distance and has no sign. OpenCV’s T[0], ROS and DepthAI write it negative because the second camera stands to the right. Type it without the minus.",
        ),
        Issue::SizeOfSquares { text } => write!(
            f,
            "How large is a square of the board? Type it behind {}, such as 1.695 squares of 25 mm.",
            quoted(text)
        ),
        Issue::MultipleOfWidth { number, of_width, of_half } => {
            let view = |angle: &Angle| significant(angle.degrees(), 3);
            write!(
                f,
                "{number} px is hardly a focal length. Is it a multiple of the width of the image (a view of {}°), or of half of it as OpenGL and Unity have it (a view of {}°)? Multiply it by that.",
                view(of_width),
                view(of_half)
            )
        }
        Issue::DegreesOrRadians { number } => write!(f, "Is {number} in radians? A field of view of {number}° is a telescope’s."),
        Issue::UnusualUnitOrSquares { number, unit, better } => write!(
            f,
            "{number} {} is unusual for the baseline: {}. Did you mean {number} {}, or {number} squares of the calibration board?",
            unit.symbol(),
            usual(fields::BASELINE),
            better.symbol()
        ),
        Issue::Unusual { key } => write!(f, "Unusual for {}: {}. Is it right?", key.noun, usual(*key)),
        Issue::UnusualUnit { key, number, unit, better } => write!(
            f,
            "{number} {} is unusual for {}: {}. Did you mean {number} {}?",
            unit.symbol(),
            key.noun,
            usual(*key),
            better.symbol()
        ),
        _ => return None,
    })
}

/// About the σ of a field.
fn sigma(issue: &Issue, f: &mut Formatter<'_>) -> Option<fmt::Result> {
    let (key, text, what) = match issue {
        Issue::SigmaTwoReadings { key, text } => (key, text, "could mean more than one number."),
        Issue::SigmaUnknownUnit { key, text } => (key, text, "has a unit that is not known here."),
        Issue::SigmaWrongUnit { key, text } => (key, text, "has the wrong kind of unit."),
        Issue::SigmaUnitAndPercent { key, text } => (key, text, "has a unit and a percent sign."),
        Issue::SigmaPercentOfZero { key, text } => (key, text, "of zero is nothing."),
        Issue::SigmaNotANumber { key, text } => (key, text, "is not an uncertainty."),
        Issue::SigmaNegative { key, text } => (key, text, "is negative, which an uncertainty cannot be."),
        Issue::SigmaTooLarge { key, text } => (key, text, "is too large."),
        Issue::SigmaOutOfProportion => {
            return Some(
                f.write_str("This uncertainty is out of all proportion to the value, so nothing can be said. Type a smaller one."),
            );
        }
        _ => return None,
    };
    let example = match key.kind {
        _ if matches!(issue, Issue::SigmaPercentOfZero { .. }) => match key.kind {
            Kind::Length(_) => "0.5 mm",
            Kind::Angle => "0.5°",
            _ => "0.5",
        },
        Kind::Length(_) => "0.5 mm or 1 %",
        Kind::Pitch => "0.05 µm or 1 %",
        Kind::Angle => "0.5° or 1 %",
        Kind::Pixels | Kind::Count | Kind::Plain | Kind::Text => "0.5 or 1 %",
    };
    Some(write!(f, "{} {what} Type one standard deviation, such as {example}.", quoted(text)))
}

/// About what was not typed yet, and the equation that is solved for something else than the distance.
fn missing(issue: &Issue, f: &mut Formatter<'_>) -> Option<fmt::Result> {
    Some(match issue {
        Issue::Missing { key, method } => write!(
            f,
            "{} is missing for the {} distance. {}",
            capital(key.noun),
            method.name().to_lowercase(),
            what_to_type(*key)
        ),
        Issue::RangeContradicts { times } => write!(
            f,
            "The depth that this range gives is {} times the distance that was computed: one of them is wrong.",
            significant(*times, 3)
        ),
        Issue::MissingFocalLength => f.write_str("Start with the focal length in pixels, such as 700."),
        Issue::MissingMethod => f.write_str("Add a baseline and a disparity for two cameras, or the two widths for one camera."),
        Issue::MissingForUnknown { key } => write!(f, "{} is missing.", capital(key.noun)),
        Issue::MissingDistance => write!(f, "The distance (D) is missing. {DISTANCE_EXAMPLE}"),
        Issue::NotADistance { text } => write!(f, "{} is not a distance. {DISTANCE_EXAMPLE}", quoted(text)),
        Issue::DistanceInPixels => write!(f, "A distance is not a number of pixels. {DISTANCE_EXAMPLE}"),
        Issue::NoSolution => f.write_str("With these numbers there is no answer that a computer can represent."),
        _ => return None,
    })
}

/// About range, tilt and ground plane, and the ways to a focal length and a disparity.
fn other_ways(issue: &Issue, f: &mut Formatter<'_>) -> Option<fmt::Result> {
    Some(match issue {
        Issue::QMatrixCount { found } => write!(f, "A Q matrix has 16 numbers; this text has {found}."),
        Issue::QMatrixNumber { text } => write!(f, "{} is not a number that can stand in a Q matrix.", quoted(text)),
        Issue::QMatrixEntry {
            row,
            column,
            expected,
            found,
        } => {
            let expected = match expected {
                Expected::Exactly(number) => format!("is {number} in a Q matrix"),
                Expected::Positive => "is the focal length and must be above zero".to_owned(),
                Expected::NotZero => "is one over the baseline and cannot be zero".to_owned(),
                Expected::Finite => "must be a finite number".to_owned(),
            };
            write!(
                f,
                "This is not a Q matrix of stereoRectify: row {row}, column {column} {expected}, here it is {}.",
                plain(*found)
            )
        }
        _ => f.write_str(fixed(issue)?),
    })
}

/// The sentences of [`other_ways`] without a fact.
const fn fixed(issue: &Issue) -> Option<&'static str> {
    Some(match issue {
        Issue::TiltTooLarge => "A target tilted by 90° or more shows no width. Type an angle below 90°.",
        Issue::MissesPlane => {
            "This ray is at the horizon or on the other side of it: it never meets the plane of the target. Check row, pitch and heights."
        }
        Issue::PitchCountsDownwards => "Pitch is counted downwards here: with this sign the ray never meets the plane of the target.",
        Issue::TargetAtCameraHeight => {
            "The target is as high as the lens: its plane is seen from the edge, and every distance looks the same."
        }
        Issue::AngleTooLarge => "A point 90° or more off the optical axis is not in the picture. Type an angle below 90°.",
        Issue::RowAndAngle => "Give the row of the point or its angle below the axis, not both.",
        Issue::NoQMatrix => "There is no Q in it. Q is the 4 × 4 matrix that stereoRectify makes; paste it, or the file that has it.",
        Issue::GroundTooExtreme => "With these numbers there is no distance that a computer can represent.",
        Issue::VagueGround => "With this uncertainty ± σ is a poor description of the distance: the far side is longer.",
        Issue::NoFocalLength => "These numbers give no focal length: all must be above zero, and a field of view below 180°.",
        Issue::MinDisparityNotWhole => "minDisparity is a whole number, such as 0.",
        Issue::WrongSubpixelBits => "DepthAI has 3, 4 or 5 sub-pixel bits.",
        Issue::NotADisparity {
            reason: NoDisparity::Invalid,
        } => "This value means that the matcher found nothing at this pixel.",
        Issue::NotADisparity {
            reason: NoDisparity::NotWhole,
        } => "This encoding stores whole numbers: the value may have been divided already.",
        Issue::NotADisparity {
            reason: NoDisparity::OutOfRange,
        } => "This encoding cannot hold such a value.",
        Issue::QMatrixRounded => {
            "MATLAB printed this matrix with a common factor, which leaves one over the baseline too few digits. Print it with format long g."
        }
        Issue::QMatrixSwapped => {
            "The sign of this Q means that left and right are swapped, or that T has the wrong sign: depths come out negative."
        }
        _ => return None,
    })
}

/// "Type a number above zero, such as 700 px."
fn what_to_type(key: Key) -> String {
    let examples = key.examples.join(" or ");
    let unit = match key.unit_symbol() {
        "" => String::new(),
        "°" => "°".to_owned(),
        symbol => format!(" {symbol}"),
    };
    match key.kind {
        Kind::Pixels if key.signed => format!("Type a number of pixels, such as {examples}."),
        Kind::Count => format!("Type a whole number, such as {examples}."),
        _ if key.signed => format!("Type a number, such as {examples}{unit}."),
        _ => format!("Type a number above zero, such as {examples}{unit}."),
    }
}

/// Which units can be typed.
const fn units(kind: Kind) -> &'static str {
    match kind {
        Kind::Pixels => "Type only a number of pixels.",
        Kind::Length(_) => "Use mm, cm, m, in or ft.",
        Kind::Pitch => "Use µm, mm, cm, m, in or ft.",
        Kind::Angle => "Use ° or rad.",
        Kind::Count => "Type only a whole number.",
        Kind::Plain | Kind::Text => "Type only a number.",
    }
}

fn pixels_instead(key: Key, unit: Unit) -> String {
    if key == fields::FOCAL_LENGTH {
        format!("Divide the focal length in {0} by the width of one pixel in {0}.", unit.symbol())
    } else {
        "Type how many pixels it is in the image.".to_owned()
    }
}

/// "most lie between 5 mm and 5 m"
fn usual(key: Key) -> String {
    let Some((low, high)) = key.usual_range() else {
        return "few are like this".to_owned();
    };
    let number = |value: f64| Notation::LONG.plain(value, TYPED_DIGITS).replace('-', "−");
    if !key.is_length() {
        let unit = key.unit_symbol();
        return format!("most lie between {} and {} {unit}", number(low), number(high))
            .trim_end()
            .to_owned();
    }
    let length = |meters: f64| {
        let unit = match meters {
            ..0.01 => LengthUnit::Millimeter,
            ..1.0 => LengthUnit::Centimeter,
            _ => LengthUnit::Meter,
        };
        format!("{} {}", number(Unit::Length(unit).from_base(meters)), unit.symbol())
    };
    format!("most lie between {} and {}", length(low), length(high))
}
