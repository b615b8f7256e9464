//! What is wrong with what was typed.

use super::words::{capital, quoted};
use crate::field::{Key, Kind};
use crate::fields;
use crate::names::Named as _;
use crate::note::Issue;
use crate::number::{Notation, TYPED_DIGITS, plain, significant, with_minus};
use crate::unit::Unit;
use depth_core::angle::Angle;
use depth_core::disparity::NoDisparity;
use depth_core::q_matrix::Expected;
use depth_core::quantity::LengthUnit;
use std::fmt::{self, Display, Formatter};

const NO_MATCH: &str = "is how OpenCV’s matchers mark a pixel without a match: (minDisparity − 1) · 16, or that divided by 16.";

impl Display for Issue {
    #[expect(clippy::too_many_lines, reason = "an arm is a sentence, and the compiler asks for each")]
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            // The value of a field.
            Self::NotANumber { key, text } => write!(f, "{} is not a number. {}", quoted(text), what_to_type(*key)),
            Self::UnknownUnit { key, unit } => write!(f, "{} is not a unit known here. {}", quoted(unit), units(key.kind)),
            Self::UnitDoesNotFit { key, unit } => write!(f, "{} does not fit {}. {}", quoted(unit), key.noun, units(key.kind)),
            Self::SeveralSeparators { text } => write!(
                f,
                "{} has several separators and could mean different things. Type it with one decimal point, such as 1000.5.",
                quoted(text)
            ),
            Self::UnusualSeparators { text, reading } => write!(
                f,
                "{} has separators that mean different things in different countries. Is it {}?",
                quoted(text),
                with_minus(reading)
            ),
            Self::TwoReadings { text, many, few } => {
                // A field that takes no minus has corrections without it.
                let is_without = text.starts_with(['-', '−']) && !many.starts_with(['-', '−']);
                let without = if is_without { ", without the minus" } else { "" };
                write!(f, "{} could mean {} or {}. Which one is it{without}?", quoted(text), with_minus(many), with_minus(few))
            }
            Self::LengthForPixels { key, text, unit } => write!(
                f,
                "{} is a length, but {} is counted in pixels. {}",
                quoted(text),
                key.noun,
                pixels_instead(*key, *unit)
            ),
            Self::OtherName { key, other } => write!(f, "This is {}, but {} is asked for here. Type it without the name if it is right.", other.noun, key.noun),
            Self::TooNear { key } => write!(
                f,
                "{} is too short: it would end at the lens or inside the object. Check it, the lens and the zero point.",
                capital(key.noun)
            ),
            Self::BallOffAxis => f.write_str("The outline of a ball away from the middle of the image is an ellipse, and its center is not where it seems: the distance is too short."),
            Self::PixelsBesideLengths { key } => write!(
                f,
                "Lengths on the sensor and pixels do not go together: type {} as a length too, or the others in pixels.",
                key.noun
            ),
            Self::DoffsInPixels => f.write_str("doffs is in pixels, and so must the disparity be. Leave doffs out, or type the disparity in pixels."),
            Self::ExtentTooWide { key } => write!(f, "Nothing in a picture spans 180° or more. Type a smaller angle for {}.", key.noun),
            Self::BehindZero => f.write_str("The tape would start beyond the object: no distance is left. Check the zero point, and its sign."),
            Self::AngleHasNoFocalLength => f.write_str("An angle needs no focal length, so none follows from it. Type it in pixels instead."),
            Self::BallHasNoTilt => f.write_str("A ball looks the same from every side: the tilt is not used."),
            Self::NotNearer => f.write_str("The second photograph must show the object larger than the first. Are the two swapped?"),
            Self::NoBaseline => f.write_str("At this angle nothing of the baseline is left. Type one above 0° and below 180°."),
            Self::PixelsForLength { key } => write!(f, "{} is a length, not a number of pixels. {}", capital(key.noun), units(key.kind)),
            Self::NotWhole { key, text } => write!(f, "{} is not a whole number. {}", quoted(text), what_to_type(*key)),
            Self::Zero { key } => write!(f, "{} cannot be zero. {}", capital(key.noun), what_to_type(*key)),
            Self::Negative { key } => write!(f, "{} cannot be negative. {}", capital(key.noun), what_to_type(*key)),
            Self::TooExtreme { key, text } => write!(
                f,
                "With {} there is no distance that a computer can represent. {}",
                quoted(text),
                what_to_type(*key)
            ),
            Self::ZeroDisparity => f.write_str(
                "A disparity of zero means that the object is infinitely far away. Type a disparity above 0 px.",
            ),
            Self::NegativeDisparity => f.write_str(
                "A negative disparity usually means that the left and the right image are swapped, or the upper and the lower one. Swap them, or type it without the minus.",
            ),
            Self::DisparityWithDoffs => f.write_str(
                "Disparity and doffs together must be above zero: at zero the object is infinitely far away, below zero left and right may be swapped. Check the sign of doffs.",
            ),
            // A value that may be something else than it was taken for.
            Self::NoMatch { text } => write!(f, "{} {NO_MATCH} There is no distance here.", quoted(text)),
            Self::NoMatchUsed { text } => write!(f, "{} {NO_MATCH} Used all the same, as doffs makes it possible.", quoted(text)),
            Self::NegativeBaseline => f.write_str(
                "A baseline is a distance and has no sign. OpenCV’s T[0], ROS and DepthAI write it negative because the second camera stands to the right. Type it without the minus.",
            ),
            Self::SizeOfSquares { text } => write!(
                f,
                "How large is a square of the board? Type it behind {}, such as 1.695 squares of 25 mm.",
                quoted(text)
            ),
            Self::MultipleOfWidth { number, of_width, of_half } => {
                let view = |angle: &Angle| significant(angle.degrees(), 3);
                write!(
                    f,
                    "{number} px is hardly a focal length. Is it a multiple of the width of the image (a view of {}°), or of half of it as OpenGL and Unity have it (a view of {}°)? Multiply it by that.",
                    view(of_width),
                    view(of_half)
                )
        }
            Self::AngleInRadians { key, number } => write!(f, "Is {number} in radians? As degrees it is almost nothing for {}.", key.noun),
            Self::SensorType { text, diagonal_mm } => write!(
                f,
                "{} is the type of a sensor, not a length: its diagonal is about {} mm. Type a size from the data sheet.",
                quoted(text),
                significant(*diagonal_mm, 3)
            ),
            Self::DegreesOrRadians { number } => write!(f, "Is {number} in radians? A field of view of {number}° is a telescope’s."),
            Self::UnusualUnitOrSquares { number, unit, better } => write!(
                f,
                "{number} {} is unusual for the baseline: {}. Did you mean {number} {}, or {number} squares of the calibration board?",
                unit.symbol(),
                usual(fields::BASELINE),
                better.symbol()
            ),
            Self::Unusual { key } => write!(f, "Unusual for {}: {}. Is it right?", key.noun, usual(*key)),
            Self::UnusualUnit { key, number, unit, better } => write!(
                f,
                "{number} {} is unusual for {}: {}. Did you mean {number} {}?",
                unit.symbol(),
                key.noun,
                usual(*key),
                better.symbol()
            ),
            // The σ of a field.
            Self::NoSigma { key } => write!(f, "There is no uncertainty of {} here: it is taken to be exact. Type it without ±.", key.noun),
            Self::SigmaTwoReadings { key, text } => sigma(f, *key, text, "could mean more than one number."),
            Self::SigmaUnknownUnit { key, text } => sigma(f, *key, text, "has a unit that is not known here."),
            Self::SigmaWrongUnit { key, text } => sigma(f, *key, text, "has the wrong kind of unit."),
            Self::SigmaUnitAndPercent { key, text } => sigma(f, *key, text, "has a unit and a percent sign."),
            Self::SigmaPercentOfZero { key, text } => {
                let example = match key.kind {
                    Kind::Length(_) => "0.5 mm",
                    Kind::Angle => "0.5°",
                    _ => "0.5",
                };
                write!(f, "{} of zero is nothing. Type one standard deviation, such as {example}.", quoted(text))
            }
            Self::SigmaNotANumber { key, text } => sigma(f, *key, text, "is not an uncertainty."),
            Self::SigmaNegative { key, text } => sigma(f, *key, text, "is negative, which an uncertainty cannot be."),
            Self::SigmaTooLarge { key, text } => sigma(f, *key, text, "is too large."),
            Self::SigmaOutOfProportion { key } => write!(
                f,
                "The uncertainty of {} is out of all proportion to its value, so nothing can be said. Type a smaller one.",
                key.noun
            ),
            // What was not typed yet, and the equation that is solved for something else than the distance.
            Self::Missing { key, method } => write!(
                f,
                "{} is missing for the {} distance. {}",
                capital(key.noun),
                method.name().to_ascii_lowercase(),
                what_to_type(*key)
            ),
            Self::RangeContradicts { times, is_given } => write!(
                f,
                "The depth that this range gives is {} times the distance that was {}: one of them is wrong.",
                significant(*times, 3),
                if *is_given { "given" } else { "computed" }
            ),
            Self::MissingFocalLength => f.write_str("Start with the focal length in pixels, such as 700."),
            Self::MissingMethod => f.write_str("Add a baseline and a disparity for two cameras, or the two widths for one camera."),
            Self::MissingForUnknown { key } => write!(f, "{} is missing. {}", capital(key.noun), what_to_type(*key)),
            Self::NoSolution => f.write_str("With these numbers there is no answer that a computer can represent."),
            // Range, tilt and ground plane, and the ways to a focal length and a disparity.
            Self::TiltTooLarge => f.write_str("A target tilted by 90° or more shows no width. Type an angle below 90°."),
            Self::MissesPlane => f.write_str("This ray is at the horizon or on the other side of it: it never meets the plane of the target. Check row, pitch and heights."),
            Self::PitchTooLarge => f.write_str("This is no pitch: 0° is level, 90° straight down, −90° straight up. Type an angle between."),
            Self::PitchCountsDownwards => f.write_str("Pitch is counted downwards here: with this sign the ray never meets the plane of the target."),
            Self::LooksDownAtHigherTarget => f.write_str("The camera looks down and the target is above it: this ray never meets the plane of the target. A camera that looks up has a negative pitch."),
            Self::TargetAtCameraHeight => f.write_str("The target is as high as the lens: its plane is seen from the edge, and every distance looks the same."),
            Self::AngleTooLarge => f.write_str("A point 90° or more off the optical axis is not in the picture. Type an angle below 90°."),
            Self::RowAndAngle => f.write_str("Give the row of the point or its angle below the axis, not both."),
            Self::NoQMatrix => f.write_str("There is no Q in it. Q is the 4 × 4 matrix that stereoRectify makes; paste it, or the file that has it."),
            Self::GroundTooExtreme => f.write_str("With these numbers there is no distance that a computer can represent."),
            Self::Vague { of } => write!(f, "Most of the uncertainty of the {of} comes from here, and it is so large that ± σ is a poor description."),
            Self::NoFocalLength => f.write_str("These numbers give no focal length: all must be above zero, and a field of view below 180°."),
            Self::MinDisparityNotWhole => f.write_str("minDisparity is a whole number, such as 0."),
            Self::WrongSubpixelBits => f.write_str("DepthAI has 3, 4 or 5 sub-pixel bits."),
            Self::NotADisparity {
                reason: NoDisparity::Invalid,
            } => f.write_str("The matcher found nothing at this pixel."),
            Self::NotADisparity {
                reason: NoDisparity::NotWhole,
            } => f.write_str("This encoding stores whole numbers: the value may have been divided already."),
            Self::NotADisparity {
                reason: NoDisparity::OutOfRange,
            } => f.write_str("This encoding cannot hold such a value."),
            Self::NoDepth => f.write_str("There is no depth at this pixel."),
            Self::EightBits { number } => write!(
                f,
                "Were 16 bits read as 8? {number} is small for 16: if no pixel has more than 255, read the file again, in OpenCV with IMREAD_UNCHANGED."
            ),
            Self::NotAChannel => f.write_str("A channel is a whole number from 0 to 255."),
            Self::FarPlaneNotFarther => f.write_str("The far plane must be the larger of both distances."),
            Self::QMatrixRounded => f.write_str("MATLAB printed this matrix with a common factor, which leaves one over the baseline too few digits. Print it with format long g."),
            Self::QMatrixSwapped => f.write_str("The sign of this Q means that left and right are swapped, or that T has the wrong sign: depths come out negative."),
            // A Q matrix.
            Self::QMatrixCount { found } => write!(f, "A Q matrix has 16 numbers; this text has {found}."),
            Self::QMatrixNumber { text } => write!(f, "{} is not a number that can stand in a Q matrix.", quoted(text)),
            Self::QMatrixEntry {
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
                    with_minus(&plain(*found))
                )
            }
        }
    }
}

/// A sentence about a σ, which ends with what to type.
fn sigma(f: &mut Formatter<'_>, key: Key, text: &str, what: &str) -> fmt::Result {
    let example = match key.kind {
        Kind::Length(_) => "0.5 mm or 1 %",
        Kind::Pitch => "0.05 µm or 1 %",
        Kind::Angle => "0.5° or 1 %",
        Kind::Pixels | Kind::FocalLength | Kind::Extent | Kind::Count | Kind::Plain | Kind::Text => "0.5 or 1 %",
    };
    write!(f, "{} {what} Type one standard deviation, such as {example}.", quoted(text))
}

/// "Type a number above zero, such as 700 px."
fn what_to_type(key: Key) -> String {
    let examples = key.examples.join(" or ");
    let unit = key.kind.default_unit().map_or_else(String::new, |unit| unit.behind(""));
    match key.kind {
        Kind::Pixels | Kind::Extent if key.signed => format!("Type a number of pixels, such as {examples}."),
        Kind::Count => format!("Type a whole number, such as {examples}."),
        _ if key.signed => format!("Type a number, such as {examples}{unit}."),
        _ => format!("Type a number above zero, such as {examples}{unit}."),
    }
}

/// Which units can be typed.
const fn units(kind: Kind) -> &'static str {
    match kind {
        Kind::Pixels | Kind::FocalLength => "Type only a number of pixels.",
        Kind::Extent => "Type a number of pixels, or an angle in °, ′, ″, rad, mrad, MOA or mil.",
        Kind::Length(_) => "Use mm, cm, m, km, in, ft, yd or mi.",
        Kind::Pitch => "Use µm, nm, mm, cm, m or in.",
        Kind::Angle => "Use °, ′, ″, rad, mrad, MOA or mil.",
        Kind::Count => "Type only a whole number.",
        Kind::Plain | Kind::Text => "Type only a number.",
    }
}

fn pixels_instead(key: Key, unit: Unit) -> String {
    match key.kind {
        Kind::FocalLength => format!(
            "Divide the focal length in {0} by the width of one pixel in {0}. Or type the disparity or the width in the image as a length on the sensor too.",
            if unit == Unit::Length(LengthUnit::Inch) {
                "inches"
            } else {
                unit.symbol()
            }
        ),
        Kind::Extent => "Type how many pixels it is in the image, or the focal length as a length too.".to_owned(),
        _ => "Type how many pixels it is in the image.".to_owned(),
    }
}

/// "most lie between 5 mm and 5 m"
fn usual(key: Key) -> String {
    let Some((low, high)) = key.usual_range() else {
        return "few are like this".to_owned();
    };
    let number = |value: f64| with_minus(&Notation::LONG.plain(value, TYPED_DIGITS));
    if !key.is_length() {
        let unit = key.unit_symbol();
        return format!("most lie between {} and {} {unit}", number(low), number(high))
            .trim_end()
            .to_owned();
    }
    let length = |meters: f64| {
        let unit = match meters.abs() {
            ..0.01 => LengthUnit::Millimeter,
            ..1.0 => LengthUnit::Centimeter,
            _ => LengthUnit::Meter,
        };
        format!("{} {}", number(Unit::Length(unit).from_base(meters)), unit.symbol())
    };
    format!("most lie between {} and {}", length(low), length(high))
}
