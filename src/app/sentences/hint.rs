//! What helps to enter something, or to understand what is shown.

use crate::core::angle::Angle;
use crate::core::q_matrix::StereoGeometry;
use crate::core::quantity::LengthUnit;
use depth_text::field::Key;
use depth_text::fields;
use depth_text::form::Inputs;
use depth_text::names::Named as _;
use depth_text::number::{plain, significant};
use depth_text::report;
use depth_text::sentences::needs;
use std::fmt::{self, Display, Formatter};

/// A hint, with its facts.
#[derive(Clone, Debug, PartialEq)]
#[allow(missing_docs, reason = "the facts of a sentence have the names of what they are")]
pub enum Hint {
    /// What a screen reader adds to the name and the value of a field.
    Field { key: Key, unit: Option<LengthUnit> },
    /// What a screen reader adds to the name and the value of the σ of a field.
    Sigma,
    /// How a Q matrix can be typed.
    QMatrixForms,
    /// What a Q matrix contains.
    QMatrixContents { geometry: StereoGeometry },
    /// The question for the unit of the baseline in a Q matrix.
    QMatrixUnit { baseline: f64 },
    /// How many numbers an answer still needs.
    StillNeeds { title: String, count: usize },
    /// The field of view that a focal length means.
    View { view: Angle },
    /// The distance that a disparity means to the cameras of the form, or to the only ones that store so.
    SeenAt {
        disparity: String,
        distance: String,
        has_own_camera: bool,
    },
    /// A depth that was stored, and the disparity that it would be, or what is missing for that.
    StoredDepth {
        depth: String,
        disparity: Option<String>,
        missing: Vec<Key>,
    },
    /// What is missing for a depth.
    NoDepthWithout { missing: Vec<Key> },
    /// That a baseline may be in squares.
    SquaresOfBoard,
    /// What the button for a Q matrix copies, or what is missing for it.
    QMatrixCopy { missing: Vec<Key> },
    /// The gains, while there is no answer with σ.
    NoGains,
    /// The curve of the disparity, while no distance is given.
    NoInverseCurve,
    /// What the σ of a disparity is.
    MatchingErrors,
    /// The ground plane, while there is no point on it.
    NoSideView,
    /// What can be done with the pictures of the ground plane.
    RingsCanBeDragged,
    /// What stands in gray in empty fields.
    ExampleInGray,
    /// The curve, while there is no pair of cameras.
    NoCurve,
    /// The curve, where a disparity is not in pixels.
    NoPixelsForCurve,
    /// The top view, while no distance is known.
    NoTopView,
    /// The top view of cameras one above the other, or of a height.
    FromTheSide,
    /// What two photographs are good for.
    TwoShots,
    /// What two points are good for.
    TwoPoints,
    /// Where the top view draws the object of two cameras.
    ObjectMidway,
    /// Where the top view draws the object of one camera.
    ObjectAhead,
    /// The difference between depth and range.
    DepthOrRange,
    /// What a tilted target does to the monocular distance.
    TiltedTarget,
    /// The formula of the ground plane.
    GroundPlane,
    /// How much of the simulation is done.
    Simulating { total: u32, percent: u16 },
    /// What the simulation has done.
    Simulated { draws: u32 },
}

impl Display for Hint {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Field { key, unit } => write_field(f, *key, *unit),
            Self::QMatrixContents { geometry } => write!(
                f,
                "fx {} px, baseline {}, doffs {} px, principal point ({}, {}) px",
                plain(geometry.focal_length.px()),
                plain(geometry.baseline),
                plain(geometry.doffs.px()),
                plain(geometry.cx.px()),
                plain(geometry.cy.px())
            ),
            Self::QMatrixUnit { baseline } => write!(f, "A Q matrix carries no unit. In which unit is the baseline {}?", plain(*baseline)),
            Self::StillNeeds { title, count: 1 } => write!(f, "{title} needs one more number"),
            Self::StillNeeds { title, count } => write!(f, "{title} needs {count} more numbers"),
            Self::View { view } => write!(f, "A horizontal field of view of {}°.", significant(view.degrees(), 3)),
            Self::SeenAt { disparity, distance, has_own_camera } => {
                let whose = if *has_own_camera { "its own fx and b" } else { "fx and b of the form" };
                write!(f, "{disparity}; with {whose} that is {distance}.")
            }
            Self::StoredDepth { depth, disparity: Some(disparity), .. } => {
                write!(f, "Z = {depth}; with fx and b of the form that would be {disparity}.")
            }
            Self::StoredDepth { depth, missing, .. } if missing.is_empty() => write!(f, "Z = {depth}."),
            Self::StoredDepth { depth, missing, .. } => {
                write!(f, "Z = {depth}. Fill in {} to get the disparity that this would be.", nouns(missing))
            }
            Self::NoDepthWithout { missing } => write!(f, "Fill in {} to get the depth.", nouns(missing)),
            Self::Simulating { total, percent } => {
                write!(f, "Drawing {} times: {percent} %", grouped(*total))
            }
            Self::Simulated { draws } => write!(
                f,
                "{} draws of all inputs, the same ones every time. A draw whose pixels are zero or less counts as infinitely far.",
                grouped(*draws)
            ),
            Self::QMatrixForms => f.write_str("As numpy or MATLAB prints it, as OpenCV’s YAML, XML or JSON has it, or as sixteen numbers."),
            Self::SquaresOfBoard => f.write_str("Or in squares of the calibration board, if the calibration was not told their size:"),
            Self::QMatrixCopy { missing } if missing.is_empty() => {
                f.write_str("The matrix of the numbers in the form as OpenCV’s YAML, with the baseline in meters:")
            }
            Self::QMatrixCopy { missing } => write!(f, "To copy a Q matrix out of the form: it {}.", needs(missing)),
            Self::NoGains => f.write_str("How much surer the answer gets when one of the inputs is known exactly, once they have ± σ."),
            Self::NoInverseCurve => f.write_str("The disparity at every distance, once focal length, baseline and distance are known."),
            Self::MatchingErrors => f.write_str("How well the matcher finds the same point, one σ:"),
            Self::NoSideView => f.write_str("The camera, its ray and the floor, once a focal length, the height, the pitch and a row are known."),
            Self::RingsCanBeDragged => f.write_str("Both rings can be dragged."),
            Self::ExampleInGray => write_example(f),
            Self::ObjectAhead => f.write_str("The object is drawn straight ahead of the camera, facing it."),
            Self::DepthOrRange => f.write_str("Distances here are depths, Z along the optical axis. A tape held at the lens measures the range R, which is longer than Z away from the middle of the image."),
            Self::TiltedTarget => f.write_str("A target turned away by an angle looks narrower by its cosine, so the monocular method puts it too far away. The distance is that to the plane of the target’s middle, along the optical axis."),
            Self::GroundPlane => f.write_str("Where the ray of a pixel meets a level floor, or the level plane that the target reaches up to: straight ahead (H − h) / tan(θ + atan((v − cy) / fy)). Needs neither a second camera nor a known size. The camera has no roll."),
            Self::Sigma => f.write_str("One standard deviation, in the unit of the value, with a unit of its own, or in percent. Empty: none."),
            Self::NoCurve => f.write_str("How fast the distance grows as the disparity shrinks, once focal length and baseline are known."),
            Self::NoPixelsForCurve => f.write_str("This curve counts the disparity in pixels."),
            Self::FromTheSide => f.write_str("Seen from the side: up is to the left."),
            Self::TwoShots => f.write_str("For an object whose size is not known: w_1 and w_2 are its widths in two photographs, the second a step s nearer. The first place is s · w_2 / (w_2 − w_1) away. An error of a pixel counts D / s times as much as with a known size, so take a large step."),
            Self::TwoPoints => f.write_str("The straight line between two points that both cameras see, each with its pixel in the left image (or the upper one) and its disparity."),
            Self::NoTopView => f.write_str("The cameras, their lines of sight and the object from above, as soon as a distance is known."),
            Self::ObjectMidway => f.write_str("The object is drawn midway between the cameras; where it stands sideways needs more than a disparity."),
        }
    }
}

/// A count with its thousands apart, so that no line breaks between them: "100 000".
pub(super) fn grouped(count: u32) -> String {
    if count < 10_000 {
        return count.to_string();
    }
    format!("{}\u{a0}{:03}", count / 1000, count % 1000)
}

/// "the focal length and the baseline"
fn nouns(keys: &[Key]) -> String {
    let nouns: Vec<&str> = keys.iter().map(|key| key.noun).collect();
    nouns.join(" and ")
}

/// What the gray numbers are of, whatever is typed beside them.
fn write_example(f: &mut Formatter<'_>) -> fmt::Result {
    let assessment = Inputs::default().with_examples().assess();
    let typed = |key: Key| assessment.reading(key).map_or_else(String::new, |reading| reading.text());
    write!(
        f,
        "The gray numbers are of a parcel {} wide, {} in front of two cameras that stand {} apart. Each is replaced by what you type.",
        typed(fields::REAL_WIDTH),
        report::length(assessment.solution.best().map(|best| best.distance.value), LengthUnit::Meter),
        typed(fields::BASELINE),
    )
}

/// The hint of the field, and its unit: the chosen one where there is a choice.
fn write_field(f: &mut Formatter<'_>, key: Key, unit: Option<LengthUnit>) -> fmt::Result {
    let unit = unit.map_or(spoken_unit(key.unit_symbol()), |unit| unit.name());
    let in_unit = format!("In {unit}.");
    let hint = if key.hint.is_empty() {
        String::new()
    } else {
        format!("{}.", key.hint)
    };
    let is_said = unit.is_empty() || hint.to_ascii_lowercase().contains(&in_unit.to_ascii_lowercase());
    match (hint.is_empty(), is_said) {
        (_, true) => f.write_str(&hint),
        (true, false) => f.write_str(&in_unit),
        (false, false) => write!(f, "{hint} {in_unit}"),
    }
}

/// The word that a screen reader should say for the symbol of a unit.
fn spoken_unit(symbol: &str) -> &str {
    match symbol {
        "px" => "pixels",
        "mm" => "millimeters",
        "µm" => "micrometers",
        "m" => "meters",
        "°" => "degrees",
        other => other,
    }
}

#[cfg(test)]
mod tests {
    use super::Hint;
    use crate::app::sentences::snapshot::{assert_shown, every};
    use crate::core::angle::Angle;
    use crate::core::q_matrix::StereoGeometry;
    use crate::core::quantity::Pixels;
    use depth_text::fields;

    #[test]
    fn every_hint_is_as_it_was_written() {
        let geometry = || StereoGeometry {
            focal_length: Pixels::new(700.0),
            baseline: 100.0,
            doffs: Pixels::new(40.0),
            cx: Pixels::new(610.0),
            cy: Pixels::new(350.5),
            swapped: false,
        };
        let disparity = || "d = 48.2227 px".to_owned();
        let mut hints = every![Hint;
            Hint::Field { .. } => Hint::Field { key: fields::FOCAL_LENGTH, unit: None },
            Hint::Sigma => Hint::Sigma,
            Hint::QMatrixForms => Hint::QMatrixForms,
            Hint::QMatrixContents { .. } => Hint::QMatrixContents { geometry: geometry() },
            Hint::QMatrixUnit { .. } => Hint::QMatrixUnit { baseline: 100.0 },
            Hint::StillNeeds { .. } => Hint::StillNeeds { title: "Stereo".into(), count: 1 },
            Hint::View { .. } => Hint::View { view: Angle::from_degrees(54.317) },
            Hint::SeenAt { .. } => Hint::SeenAt { disparity: disparity(), distance: "1.234 m".into(), has_own_camera: false },
            Hint::StoredDepth { .. } => Hint::StoredDepth { depth: "1.400 m".into(), disparity: Some(disparity()), missing: Vec::new() },
            Hint::NoDepthWithout { .. } => Hint::NoDepthWithout { missing: vec![fields::FOCAL_LENGTH] },
            Hint::SquaresOfBoard => Hint::SquaresOfBoard,
            Hint::QMatrixCopy { .. } => Hint::QMatrixCopy { missing: Vec::new() },
            Hint::NoGains => Hint::NoGains,
            Hint::NoInverseCurve => Hint::NoInverseCurve,
            Hint::MatchingErrors => Hint::MatchingErrors,
            Hint::NoSideView => Hint::NoSideView,
            Hint::RingsCanBeDragged => Hint::RingsCanBeDragged,
            Hint::ExampleInGray => Hint::ExampleInGray,
            Hint::NoCurve => Hint::NoCurve,
            Hint::NoPixelsForCurve => Hint::NoPixelsForCurve,
            Hint::NoTopView => Hint::NoTopView,
            Hint::FromTheSide => Hint::FromTheSide,
            Hint::TwoShots => Hint::TwoShots,
            Hint::TwoPoints => Hint::TwoPoints,
            Hint::ObjectMidway => Hint::ObjectMidway,
            Hint::ObjectAhead => Hint::ObjectAhead,
            Hint::DepthOrRange => Hint::DepthOrRange,
            Hint::TiltedTarget => Hint::TiltedTarget,
            Hint::GroundPlane => Hint::GroundPlane,
            Hint::Simulating { .. } => Hint::Simulating { total: 100_000, percent: 40 },
            Hint::Simulated { .. } => Hint::Simulated { draws: 100_000 },
        ];
        hints.extend(with_other_facts());
        for key in [fields::BASELINE, fields::DOFFS, fields::CAMERA_PITCH, fields::PIXEL_PITCH] {
            hints.push(Hint::Field {
                key,
                unit: key.kind.length_unit(),
            });
        }
        assert_shown("hints", &hints);
    }

    /// Hints that other facts make another sentence of.
    fn with_other_facts() -> [Hint; 5] {
        let stored = |missing| Hint::StoredDepth {
            depth: "1.400 m".into(),
            disparity: None,
            missing,
        };
        [
            Hint::SeenAt {
                disparity: "d = 48.2227 px".into(),
                distance: "1.234 m".into(),
                has_own_camera: true,
            },
            stored(vec![fields::FOCAL_LENGTH, fields::BASELINE]),
            stored(Vec::new()),
            Hint::StillNeeds {
                title: "Monocular".into(),
                count: 3,
            },
            Hint::QMatrixCopy {
                missing: vec![fields::CX, fields::CY],
            },
        ]
    }
}
