//! Opening calibration files: from the question which, over what is found in them, to the rig that comes of it.

mod drop;
mod found;
mod ui;

pub use drop::hint_ui as drop_hint_ui;
pub use found::Shown;
pub use ui::ui;

use super::platform::{OpenedFile, Platform};
use super::rigs::Rig;
use depth_jobs::{End, Job, Outcome, Report, Run};

/// The dialog that opens calibration files.
#[derive(Debug, Default)]
pub struct Import {
    /// The files that are read, or were.
    files: Vec<OpenedFile>,
    /// Whether the next files come beside these.
    adds: bool,
    /// What is pasted.
    pub text: String,
    /// Why files could not be opened, while what is there stays.
    obstacle: Option<String>,
    state: State,
    /// Whether the answer has just come, and the focus is still on what stood there before.
    is_new: bool,
}

/// How far it is.
#[derive(Debug, Default)]
enum State {
    /// The person is asked for files.
    #[default]
    Asking,
    /// They are being read.
    Reading(Run),
    /// They could not be read: why, and what to do.
    Failed(String),
    /// This is in them.
    Found(Box<Shown>),
}

impl Import {
    /// What is in a text that was pasted.
    pub fn of_text(text: String) -> Vec<OpenedFile> {
        vec![OpenedFile {
            name: PASTED.to_owned(),
            bytes: text.into_bytes(),
        }]
    }

    /// Reads `files`, beside those that are there where that was asked for.
    pub fn read(&mut self, ctx: &egui::Context, platform: &mut dyn Platform, (run, files): (Run, Vec<OpenedFile>)) {
        self.give_up(ctx, platform);
        self.obstacle = None;
        if !std::mem::take(&mut self.adds) {
            self.files.clear();
        }
        self.files.extend(files);
        let names = self.names();
        let attachments = self.files.iter().map(|file| file.bytes.clone()).collect();
        self.state = State::Reading(run);
        platform.start(ctx, run, Job::ReadCalibration { names }, attachments);
    }

    /// Whether the next files come beside those that are there, or in their place.
    pub const fn add_to_these(&mut self, adds: bool) {
        self.adds = adds;
    }

    /// Ends what is being read.
    pub fn give_up(&mut self, ctx: &egui::Context, platform: &mut dyn Platform) {
        if let State::Reading(run) = self.state {
            platform.cancel(ctx, run);
            self.state = State::Asking;
        }
    }

    /// Takes a report of the work. That of other work is none of its business.
    pub fn hear(&mut self, report: Report) {
        let Report::Ended { run, end } = report else { return };
        if !matches!(self.state, State::Reading(own) if own == run) {
            return;
        }
        self.state = match end {
            End::Done(Outcome::Calibration(found)) => State::Found(Box::new(Shown::new(*found))),
            End::Failed(failure) => State::Failed(failure.to_string()),
            End::Cancelled => State::Asking,
        };
        self.is_new = true;
    }

    /// Says why files could not be opened. What is there stays.
    pub fn fail(&mut self, why: String) {
        self.adds = false;
        self.obstacle = Some(why);
    }

    /// What came of them as a rig, where all that has to be known is known.
    pub fn rig(&self) -> Option<Rig> {
        let State::Found(shown) = &self.state else { return None };
        shown.rig(&self.names())
    }

    fn names(&self) -> Vec<String> {
        self.files.iter().map(|file| file.name.clone()).collect()
    }
}

/// What a pasted text is called.
const PASTED: &str = "pasted text";

/// Whether a text that was pasted outside of a field is a calibration more likely than a slip: it has lines, and numbers.
pub fn is_file(text: &str) -> bool {
    text.trim().lines().count() > 1 && text.bytes().filter(u8::is_ascii_digit).count() > 4
}

#[cfg(test)]
mod tests {
    use super::is_file;

    #[test]
    fn a_file_is_told_from_a_slip_of_the_clipboard() {
        assert!(is_file("cam0=[700 0 320; 0 700 240; 0 0 1]\nbaseline=100\n"));
        for slip in ["", "700", "700\n", "https://example.org/#fx=700", "a\nb\nc"] {
            assert!(!is_file(slip), "{slip}");
        }
    }
}
