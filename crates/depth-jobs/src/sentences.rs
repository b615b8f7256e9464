//! What is said of work that could not be done.

use crate::protocol::Failure;
use std::fmt::{self, Display, Formatter};

impl Display for Failure {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        match self {
            Self::Refused(why) => f.write_str(why),
            Self::NotLoaded { reason } => write!(
                f,
                "The part of the program that reads files could not be loaded ({}). Check the connection and try again; if a new version \
                 has just been published, reload the page.",
                reason.trim_end_matches('.')
            ),
            Self::OtherBuild => f.write_str(
                "The part of the program that reads files is of another version: a new one has just been published. Reload the page and \
                 try again.",
            ),
            Self::Stopped { reason } => write!(
                f,
                "Reading stopped because of an error in the program ({}). Try again; if it stops again, this file is one that it cannot \
                 read.",
                reason.trim_end_matches('.')
            ),
        }
    }
}

impl std::error::Error for Failure {}
