//! What only the command line says.

use super::words::capital;
use crate::field::Key;
use crate::variants::variants;
use depth_core::problem::Method;
use std::fmt::{self, Display, Formatter};

variants! {
    /// A sentence of the command line. Options are named without their dashes.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub enum CommandLine {
        /// An option was given with nothing in it.
        EmptyOption { option: String },
        /// Nothing stands behind the ± of an option.
        EmptySigma { option: String },
        /// Neither method is complete. For each way: the options that it lacks, and the name of its method.
        NoDistance { ways: Vec<(Vec<String>, &'static str)> },
        /// A program without a window was called without a command.
        NoCommand,
        /// The answer could not be written.
        NotWritten { reason: String },
        /// doffs was given, but no stereo distance was asked for.
        UnusedDoffs,
        /// A tilt was given, but no monocular distance was asked for.
        UnusedTilt,
        /// An option of the point in space was given, without these that it needs.
        UnusedPoint { options: Vec<String> },
        /// A range was given, without these options that give the depth from it.
        NoPoint { options: Vec<String> },
        /// A distance was given, and nothing else is solved for.
        UnusedDistance,
        /// A value was given for what is solved for.
        UnusedUnknown,
        /// What belongs to a row was given beside an angle instead of it.
        UnusedWithAngle,
        /// fx was given, and nothing that is asked for depends on it.
        UnusedFocalLength,
        /// Something else than the distance is solved for, and no distance was given.
        NoKnownDistance,
        /// A choice that belongs to a method of which nothing was given.
        UnusedChoice { method: Method },
        /// A focal length beside angles.
        UnusedBesideAngle,
        /// fy where nothing is counted in rows.
        UnusedFy,
        /// The lens of an fx that is a length.
        UnusedLens,
        /// A pixel beside lengths on the sensor.
        UnusedBesideLengths,
        /// A point that is not three numbers.
        NotAPoint,
        /// The focal length is solved for, and both equations have it.
        WhichEquation,
        /// A way of its own, such as the ground plane, without these options.
        NoWay { options: Vec<String> },
        /// A file cannot be read.
        UnreadableFile { file: String, reason: String },
        /// What is solved for needs more options.
        NotSolved { unknown: Key, options: Vec<String> },
        /// A file is larger than 16 MB.
        FileTooLarge { file: String },
        /// A file is not text.
        FileNotText { file: String },
        /// A σ was given without its value.
        UnusedSigma { option: String },
    }
}

impl Display for CommandLine {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::EmptyOption { option } => write!(f, "--{option} is empty: give it a value or leave it out."),
            Self::EmptySigma { option } => write!(
                f,
                "--{option}: Nothing stands behind ±. Type the uncertainty, or leave the sign out."
            ),
            Self::NoDistance { ways } => {
                let ways: Vec<String> = ways
                    .iter()
                    .map(|(options, method)| format!("{} for the {} distance", enumerated(options), method.to_ascii_lowercase()))
                    .collect();
                incomplete(f, "No distance can be computed.", &ways.join(", or "))
            }
            Self::NoCommand => f.write_str(
                "Without a window a command is needed, such as: depth-calculator calculate --fx 700 --baseline 100mm --disparity 50",
            ),
            Self::NotWritten { reason } => write!(f, "The answer could not be written: {reason}."),
            Self::UnusedDoffs => f.write_str("Not used: it belongs to the stereo distance, which needs --baseline and --disparity."),
            Self::UnusedTilt => f.write_str("Not used: it belongs to the monocular distance, which needs --w-img and --w-real."),
            Self::UnusedPoint { options } if options.is_empty() => f.write_str("Not used: there is no distance to put the point at."),
            Self::UnusedPoint { options } => write!(f, "Not used without {}.", enumerated(options)),
            Self::NoPoint { options } => incomplete(f, "No depth can be computed from the range.", &enumerated(options)),
            Self::UnusedDistance => f.write_str("Not used without --solve-for, which says what to solve for instead."),
            Self::UnusedUnknown => f.write_str("Not used: it is what --solve-for solves for."),
            Self::UnusedWithAngle => f.write_str("Not used with --angle, which takes the place of a row."),
            Self::UnusedFocalLength => f.write_str("Not used: --fy takes its place for the row, and no column is given."),
            Self::UnusedChoice { method: Method::Stereo } => {
                f.write_str("Not used: it belongs to the stereo distance, which needs --baseline and --disparity.")
            }
            Self::UnusedChoice { method: Method::Monocular } => {
                f.write_str("Not used: it belongs to the monocular distance, which needs --w-img and --w-real.")
            }
            Self::UnusedBesideAngle => f.write_str("Not used: an angle needs no focal length."),
            Self::UnusedLens => f.write_str("Not used: as a length --fx is the principal distance, which has the focus in it."),
            Self::UnusedBesideLengths => f.write_str("Not used: a point in space needs --fx in pixels."),
            Self::UnusedFy => f.write_str("Not used: it belongs to rows, those of --object height, of --pair vertical or of a point."),
            Self::NotAPoint => f.write_str("a point is its column, its row and its disparity with commas between, such as 138,219,36"),
            Self::NoKnownDistance => f.write_str("With --solve-for the distance is an input: give it with --distance."),
            Self::WhichEquation => {
                f.write_str("Both methods have an fx: to solve for it leave out either --baseline and --disparity or --w-img and --w-real.")
            }
            Self::NoWay { options } => incomplete(f, "No distance can be computed.", &enumerated(options)),
            Self::UnreadableFile { file, reason } => write!(f, "{file} cannot be read: {reason}."),
            Self::NotSolved { unknown, options } => {
                let what = format!("{} cannot be computed.", capital(unknown.noun));
                incomplete(f, &what, &enumerated(options))
            }
            Self::FileTooLarge { file } => write!(f, "{file} cannot be read: it is larger than 16 MB."),
            Self::FileNotText { file } => write!(f, "{file} cannot be read: it is not text."),
            Self::UnusedSigma { option } => write!(f, "Not used without --{option}."),
        }
    }
}

/// What is to be added, where something is missing.
fn incomplete(f: &mut Formatter<'_>, what: &str, options: &str) -> fmt::Result {
    write!(f, "{what} Add {options} (see --help).")
}

/// "--a", "--a and --b", "--a, --b and --c"
fn enumerated(options: &[String]) -> String {
    let options: Vec<String> = options.iter().map(|option| format!("--{option}")).collect();
    match options.as_slice() {
        [] => String::new(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}
