//! Requests and reports.

use crate::calibration::Calibration;
use serde::{Deserialize, Serialize};

/// The version of this protocol. Page and worker of one build have the same.
pub const PROTOCOL: u32 = 1;

/// Bytes of the largest calibration file that is read, and of all of them together.
pub const LARGEST_FILE: usize = 16 << 20;

/// Whether a file that begins so is a photograph (JPEG): what it says of its camera stands before its picture, so that of one larger than
/// [`LARGEST_FILE`] the beginning is enough.
///
/// ```
/// assert!(depth_jobs::is_photograph(&[0xff, 0xd8, 0xff, 0xe1]));
/// assert!(!depth_jobs::is_photograph(b"%YAML:1.0"));
/// ```
///
/// Source: ITU-T T.81, B.1.1.3: the markers SOI, and the first byte of the next.
pub fn is_photograph(begin: &[u8]) -> bool {
    begin.starts_with(&[0xff, 0xd8, 0xff])
}

/// No calibration has more files.
pub const MOST_FILES: usize = 16;

/// The number of a piece of work, which its reports bear. No two have the same.
pub type Run = u32;

/// Bulk bytes beside a header.
pub type Attachment = Vec<u8>;

/// Work to be done.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Job {
    /// Read calibration files: an attachment each, in the order of their names.
    ReadCalibration {
        /// What they are called, for what is said of them.
        names: Vec<String>,
    },
}

/// What is asked of whoever does the work.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Request {
    /// Start this.
    Start {
        /// Its number.
        run: Run,
        /// What is to be done.
        job: Job,
    },
    /// Give it up.
    Cancel {
        /// Its number.
        run: Run,
    },
}

/// What whoever does the work answers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Report {
    /// It is there, and speaks this [`PROTOCOL`].
    Ready {
        /// The version.
        protocol: u32,
    },
    /// It has done so much.
    Progress {
        /// Of which work.
        run: Run,
        /// So many pieces
        done: u32,
        /// of so many.
        of: u32,
    },
    /// It has ended.
    Ended {
        /// Which work.
        run: Run,
        /// How.
        end: End,
    },
}

/// How work ends.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum End {
    /// With this.
    Done(Outcome),
    /// It was given up, as asked.
    Cancelled,
    /// It could not be done.
    Failed(Failure),
}

/// What comes of a [`Job`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub enum Outcome {
    /// Of [`Job::ReadCalibration`].
    Calibration(Box<Calibration>),
}

/// Why work could not be done. The sentence is its `Display`.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Failure {
    /// What was given cannot be used: a sentence that says why, and what to do.
    Refused(String),
    /// Whoever does the work could not be loaded.
    NotLoaded {
        /// What the browser says.
        reason: String,
    },
    /// Whoever does the work is of another version than whoever asks.
    OtherBuild,
    /// Whoever does the work has stopped: an error in the program, or no more memory.
    Stopped {
        /// What is known of it.
        reason: String,
    },
}
