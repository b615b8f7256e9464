//! Why a file cannot be read.

use crate::format::Format;
use crate::place::Place;

/// Why a file cannot be read. The sentence is its `Display`. Lines are counted from 1.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "the fields are what the sentences say, by name")]
pub enum Refusal {
    /// There is nothing in it.
    Empty,
    /// More than so many megabytes.
    TooLarge { megabytes: usize },
    /// Bytes that are no text, what they are if that can be told, and what to do.
    Binary { what: Option<&'static str>, todo: &'static str },
    /// Something that is known, and no calibration: what, and what to do.
    Other { what: &'static str, todo: &'static str },
    /// An archive or array that ends early or contradicts itself: what, and why.
    Damaged { what: &'static str, reason: String },
    /// It ends early, or is not what it begins as.
    Syntax { what: &'static str, place: Place, reason: String },
    /// Brackets within brackets.
    TooDeep,
    /// More numbers, also by aliases of YAML, than any calibration holds.
    TooMuch,
    /// A word or nothing where a number belongs.
    NotANumber {
        format: Format,
        name: String,
        place: Place,
        text: String,
    },
    /// So many numbers, where it should be others.
    Count {
        format: Format,
        name: String,
        place: Place,
        count: usize,
        expected: String,
    },
    /// A photograph that says no focal length in pixels: its size, who made its camera, whether it has EXIF, and the lens in millimeters where
    /// only that is known.
    Photo {
        size: [u32; 2],
        maker: Option<String>,
        has_exif: bool,
        lens_mm: Option<f64>,
    },
    /// Something without which there is no camera.
    Missing { format: Format, what: &'static str },
    /// A model whose first number is no focal length.
    NotPinhole { format: Format, model: String, place: Place },
    /// A number that no Q matrix has there.
    NotQ {
        format: Format,
        name: String,
        place: Place,
        entry: [usize; 2],
        found: f64,
    },
    /// A focal length that none is.
    FocalLength { format: Format, fx: f64, place: Place },
    /// Files that do not go together.
    Mixed { formats: [Format; 2] },
    /// More cameras than anybody chooses among.
    ManyCameras { format: Format },
    /// A second file beside one of a format that has all cameras in one.
    OneFile { format: Format },
    /// A name that is not that of one camera.
    NoSuchCamera { name: String, cameras: Vec<String> },
    /// More than two cameras, or one of them twice.
    TwoCameras,
    /// Nothing that is known here.
    Unknown,
    /// One of the files, counted from 0, cannot be read, and no line of it says why.
    InFile { file: usize, refusal: Box<Self> },
}

impl Refusal {
    /// The same of the `file`th, where it does not say that itself.
    pub(crate) fn in_file(self, file: usize) -> Self {
        match self {
            Self::Syntax { .. } | Self::NotANumber { .. } => self,
            refusal => Self::InFile {
                file,
                refusal: Box::new(refusal),
            },
        }
    }
}

impl std::error::Error for Refusal {}

impl Refusal {
    /// The same of a file of another format, whose meaning was read as that of this one.
    pub(crate) fn of(mut self, other: Format) -> Self {
        match &mut self {
            Self::NotANumber { format, .. }
            | Self::Count { format, .. }
            | Self::Missing { format, .. }
            | Self::NotPinhole { format, .. }
            | Self::NotQ { format, .. }
            | Self::FocalLength { format, .. } => *format = other,
            _ => {}
        }
        self
    }
}
