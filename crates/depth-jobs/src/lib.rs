//! Long work beside the window: what it is asked for ([`Job`]), and what it answers ([`Report`]).
//!
//! Requests and reports are headers of JSON; bulk bytes travel beside them as attachments, moved and not copied. On a desktop a thread
//! does the work, in a browser a Worker with a WebAssembly module of its own, which is loaded when there is the first work for it.
//!
//! With the feature `engine` the work itself is here: [`engine::Engine`].

mod calibration;
#[cfg(feature = "engine")]
pub mod engine;
#[cfg(feature = "engine")]
mod found;
mod protocol;
mod sentences;

pub use calibration::{Baseline, Calibration, Camera, Choice, Guess};
pub use protocol::{Attachment, End, Failure, Job, LARGEST_FILE, MOST_FILES, Outcome, PROTOCOL, Report, Request, Run, is_photograph};
