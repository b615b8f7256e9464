//! What calibration files say, in a form that travels: plain numbers, and sentences as text, so that whoever asks needs no parser.

use depth_core::quantity::{Length, LengthUnit};
use serde::{Deserialize, Serialize};

/// What calibration files say. Focal lengths and principal points are in pixels, counted from the upper left.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Calibration {
    /// The format, to be shown.
    pub format: String,
    /// What can be taken of it, what is meant most likely first: a pair, another pair, one camera alone.
    pub choices: Vec<Choice>,
    /// What else is in the files, which was not read, each with why not.
    pub ignored: Vec<String>,
}

/// A camera alone, or a pair of which it is the left one, or the upper one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Choice {
    /// The cameras by their names in the file: "P2 and P3", "P2 alone".
    pub name: String,
    /// The camera.
    pub camera: Camera,
    /// Whether the other one stands below it.
    pub is_vertical: bool,
    /// The distance of their lenses.
    pub baseline: Option<Baseline>,
    /// How it was derived, and where it stands.
    pub baseline_origin: String,
    /// doffs in pixels.
    pub doffs_px: Option<f64>,
    /// How it was derived, and where it stands.
    pub doffs_origin: String,
    /// What somebody has to know before they use it, a sentence each.
    pub warnings: Vec<String>,
}

/// One camera.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Camera {
    /// What the file calls it.
    pub name: String,
    /// Width and height of the images that the numbers are of, in pixels.
    pub size: Option<[u32; 2]>,
    /// fx, fy, cx, cy in pixels.
    pub intrinsics_px: [f64; 4],
    /// 1 σ of these, where the file says it.
    pub sigma_px: Option<[f64; 4]>,
    /// Whether they are of rectified images, or of raw ones.
    pub is_rectified: bool,
    /// The model of the lens, where the file names one.
    pub model: Option<String>,
    /// The coefficients of the distortion as the file lists them.
    pub distortion: Vec<f64>,
    /// How the numbers were derived, and where they stand.
    pub origin: String,
}

/// How far the lenses are apart.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Baseline {
    /// In meters.
    Meters(f64),
    /// In a unit that the file does not say.
    InFileUnits {
        /// How many.
        value: f64,
        /// What the unit may be.
        guess: Guess,
    },
}

/// What the unit of a file may be that does not say it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub enum Guess {
    /// This one, by the number.
    Unit(LengthUnit),
    /// Squares of the board, whose size stands beside it in an unknown unit.
    Squares {
        /// That size.
        size: f64,
    },
}

impl Baseline {
    /// The length, where its unit is known or one unit of the file is `file_unit`.
    pub fn length(self, file_unit: Option<Length>) -> Option<Length> {
        match self {
            Self::Meters(m) => Some(Length::from_m(m)),
            Self::InFileUnits { value, .. } => file_unit.map(|unit| Length::from_m(unit.m() * value)),
        }
    }
}
