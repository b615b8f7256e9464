//! Something to say at a field ([`Note`]): what is wrong or looks wrong ([`Issue`]), how bad it is, and which corrections one
//! click makes ([`Fix`]).
//! The sentences are in [`sentences`](crate::sentences).

use crate::entry::Entry;
use crate::field::Key;
use crate::number::with_minus;
use crate::unit::Unit;
use crate::variants::variants;
use depth_core::angle::Angle;
use depth_core::disparity::NoDisparity;
use depth_core::problem::Method;
use depth_core::q_matrix::Expected;
use depth_core::quantity::LengthUnit;

/// How bad a note is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// Used, but looks like a slip.
    Warning,
    /// Cannot be used.
    Error,
}

/// What of a field a note is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// The value.
    Value,
    /// Its uncertainty.
    Sigma,
}

/// Something to say at a field.
#[derive(Clone, Debug, PartialEq)]
pub struct Note {
    /// Where.
    pub key: Key,
    /// At the value or at its σ.
    pub part: Part,
    /// How bad.
    pub severity: Severity,
    /// What is wrong; its `Display` is the sentence.
    pub issue: Issue,
    /// Corrections that one click makes.
    pub fixes: Vec<Fix>,
}

impl Note {
    const fn new(key: Key, part: Part, severity: Severity, issue: Issue) -> Self {
        Self {
            key,
            part,
            severity,
            issue,
            fixes: Vec::new(),
        }
    }

    /// An error at the value of the field `key`.
    pub const fn error(key: Key, issue: Issue) -> Self {
        Self::new(key, Part::Value, Severity::Error, issue)
    }

    /// An error at the σ of the field `key`.
    pub const fn of_sigma(key: Key, issue: Issue) -> Self {
        Self::new(key, Part::Sigma, Severity::Error, issue)
    }

    /// A warning at the value of the field `key`.
    pub const fn warning(key: Key, issue: Issue) -> Self {
        Self::new(key, Part::Value, Severity::Warning, issue)
    }

    /// The same with the corrections `fixes`.
    #[must_use]
    pub fn with_fixes(self, fixes: Vec<Fix>) -> Self {
        Self { fixes, ..self }
    }

    /// The sentence.
    pub fn message(&self) -> String {
        self.issue.to_string()
    }
}

impl Issue {
    /// Whether it asks for the size of the squares of a board.
    pub const fn is_size_of_squares(&self) -> bool {
        matches!(self, Self::SizeOfSquares { .. })
    }

    /// Whether it is about a field in which nothing was typed.
    pub const fn is_missing(&self) -> bool {
        matches!(
            self,
            Self::Missing { .. } | Self::MissingFocalLength | Self::MissingMethod | Self::MissingForUnknown { .. }
        )
    }
}

/// A correction offered beside a note.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Fix {
    /// What to write on its button behind "Use": the number with its unit; of a way, all of it.
    pub value: String,
    /// What the field becomes; its σ stays.
    pub entry: Entry,
    /// The key of the way to a focal length that asks for the rest, where the number alone is not enough.
    pub way: Option<&'static str>,
}

impl Fix {
    /// The correction that makes `entry` of the field, offered as `value`.
    pub const fn new(value: String, entry: Entry) -> Self {
        Self { value, entry, way: None }
    }

    /// The text of its button.
    pub fn label(&self) -> String {
        match self.way {
            Some(_) => self.value.clone(),
            None => format!("Use {}", with_minus(&self.value)),
        }
    }
}

variants! {
    /// What is wrong with what was typed.
    #[derive(Clone, Debug, PartialEq)]
    pub enum Issue {
        /// There is no number in the text.
        NotANumber { key: Key, text: String },
        /// What follows the number is no unit, or none of this field.
        UnknownUnit { key: Key, unit: String },
        /// A unit that exists, of another kind than the field.
        UnitDoesNotFit { key: Key, unit: String },
        /// It has several separators, and no way to read them.
        SeveralSeparators { text: String },
        /// It has separators that some countries read in another way.
        UnusualSeparators { text: String, reading: String },
        /// It can be read in two ways.
        TwoReadings { text: String, many: String, few: String },
        /// A length where pixels are counted.
        LengthForPixels { key: Key, text: String, unit: Unit },
        /// A value with the name of another field in front of it.
        OtherName { key: Key, other: Key },
        /// Pixels beside a focal length or extents that are lengths on the sensor.
        PixelsBesideLengths { key: Key },
        /// doffs, which is in pixels, beside a disparity that is not.
        DoffsInPixels,
        /// An object that subtends 180° or more.
        ExtentTooWide { key: Key },
        /// Distances are counted from a place that is as far away as the object.
        BehindZero,
        /// A distance that was given and ends at the lens, inside the object, or before it begins.
        TooNear { key: Key },
        /// A ball that is not in the middle of the image.
        BallOffAxis,
        /// A focal length solved for, which an angle does not need.
        AngleHasNoFocalLength,
        /// A tilt of a ball.
        BallHasNoTilt,
        /// Pixels where a length belongs.
        PixelsForLength { key: Key },
        /// A number with decimals where things are counted.
        NotWhole { key: Key, text: String },
        /// Zero, where that means nothing.
        Zero { key: Key },
        /// Below zero, where that means nothing.
        Negative { key: Key },
        /// A number that is too large or too small, by itself or in what would follow from it.
        TooExtreme { key: Key, text: String },
        /// A disparity of zero.
        ZeroDisparity,
        /// A disparity below zero.
        NegativeDisparity,
        /// A disparity that is not above zero together with doffs.
        DisparityWithDoffs,
        /// A disparity that says that a matcher found none.
        NoMatch { text: String },
        /// The same number, where doffs makes it possible.
        NoMatchUsed { text: String },
        /// A baseline below zero.
        NegativeBaseline,
        /// Outside the usual range.
        Unusual { key: Key },
        /// Outside the usual range, but not with another unit.
        UnusualUnit { key: Key, number: String, unit: LengthUnit, better: LengthUnit },
        /// A baseline outside the usual range, which may be in another unit or in squares of the board.
        UnusualUnitOrSquares { number: String, unit: LengthUnit, better: LengthUnit },
        /// Squares of a board whose size was not typed.
        SizeOfSquares { text: String },
        /// A focal length that may be a multiple of the image's width or of half of it, with the fields of view of both.
        MultipleOfWidth { number: String, of_width: Angle, of_half: Angle },
        /// An angle in degrees whose number looks like one in radians.
        AngleInRadians { key: Key, number: String },
        /// The type of a sensor where its size is asked for, and its diagonal in millimeters.
        SensorType { text: String, diagonal_mm: f64 },
        /// A field of view in degrees that would be usual in radians.
        DegreesOrRadians { number: String },

        /// A σ where the value is taken to be exact.
        NoSigma { key: Key },
        /// A σ that could mean more than one number.
        SigmaTwoReadings { key: Key, text: String },
        /// A σ with a unit that does not exist.
        SigmaUnknownUnit { key: Key, text: String },
        /// A σ with a unit that the field does not have.
        SigmaWrongUnit { key: Key, text: String },
        /// A σ with a unit and a percent sign.
        SigmaUnitAndPercent { key: Key, text: String },
        /// A σ in percent of zero.
        SigmaPercentOfZero { key: Key, text: String },
        /// A σ that is no number.
        SigmaNotANumber { key: Key, text: String },
        /// A σ below zero.
        SigmaNegative { key: Key, text: String },
        /// A σ that cannot be represented.
        SigmaTooLarge { key: Key, text: String },
        /// A σ that is out of all proportion to its value.
        SigmaOutOfProportion { key: Key },

        /// What a method that was begun still needs.
        Missing { key: Key, method: Method },
        /// Nothing was typed yet.
        MissingFocalLength,
        /// There is only a focal length.
        MissingMethod,
        /// What the equation to be solved needs.
        MissingForUnknown { key: Key },
        /// The equation has no solution that can be represented.
        NoSolution,

        /// A target that is turned so far that it shows no width.
        TiltTooLarge,
        /// A ray that never meets the floor, or the plane of the target.
        MissesPlane,
        /// A pitch far beyond straight up or down.
        PitchTooLarge,
        /// It would with the opposite pitch.
        PitchCountsDownwards,
        /// A target above a camera that looks down: it would meet its plane with the opposite pitch.
        LooksDownAtHigherTarget,
        /// A target as high as the camera.
        TargetAtCameraHeight,
        /// An angle below the axis of 90° or more.
        AngleTooLarge,
        /// A row and an angle instead of it.
        RowAndAngle,
        /// A distance along the floor that cannot be represented.
        GroundTooExtreme,

        /// Numbers that give no focal length.
        NoFocalLength,
        /// An angle at which nothing is left of a baseline.
        NoBaseline,
        /// A minDisparity that is not a small whole number.
        MinDisparityNotWhole,
        /// A second photograph that shows the object no larger than the first.
        NotNearer,
        /// A range by tape that contradicts the distance that was computed.
        RangeContradicts { times: f64, is_given: bool },
        /// A ground distance, or the depth of a range, that is known to worse than 30 %, mostly because of this field.
        Vague { of: &'static str },
        /// A number of sub-pixel bits that does not exist.
        WrongSubpixelBits,
        /// A stored value that stands for no disparity.
        NotADisparity { reason: NoDisparity },
        /// A stored value that stands for no depth.
        NoDepth,
        /// A stored value that is small for the 16 bits of its encoding.
        EightBits { number: String },
        /// A channel of a picture that is none.
        NotAChannel,
        /// A far plane that is not farther away than the near one.
        FarPlaneNotFarther,

        /// A text without a Q matrix among what else it has.
        NoQMatrix,
        /// A Q matrix with too few or too many numbers.
        QMatrixCount { found: usize },
        /// A word in a Q matrix that is no finite number.
        QMatrixNumber { text: String },
        /// A matrix whose entry for the baseline has too few digits, because of a common factor.
        QMatrixRounded,
        /// A matrix that is no Q matrix, counted from row and column 1.
        QMatrixEntry { row: usize, column: usize, expected: Expected, found: f64 },
        /// A Q matrix of swapped images.
        QMatrixSwapped,
    }
}
