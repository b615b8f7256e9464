//! The port to the platform: storage, clipboard, files, paper, events, and what the program says about itself.

use super::sentences::{Place, PlatformError};
use super::theme::Colors;
use depth_jobs::{Attachment, Job, Report, Run};
use egui::DroppedFileHandle;

/// What the program needs from the machine it runs on.
pub trait Platform {
    /// What this tab or window has stored, else what was stored last by any, if there is anything.
    ///
    /// # Errors
    /// Why storage cannot be read.
    fn load(&self) -> Result<Option<String>, PlatformError>;

    /// Stores `text` over what this tab or window has stored, and as what a new one starts with.
    ///
    /// # Errors
    /// Why storage cannot be written.
    fn save(&mut self, text: &str) -> Result<(), PlatformError>;

    /// Moves what is stored, which cannot be read, to where nothing is overwritten, now or later: it may be of a newer version.
    /// Returns where a person finds it, or nothing where nothing is stored.
    ///
    /// # Errors
    /// Why it cannot be moved. What is stored is then still in its place.
    fn set_aside(&mut self) -> Result<Option<Place>, PlatformError>;

    /// Starts putting `text` on the clipboard; the outcome comes later as [`Event::Copied`].
    fn copy(&mut self, ctx: &egui::Context, text: String);

    /// Asks for the text on the clipboard, to paste it into the field that has the focus. In a browser it comes later as
    /// [`Event::Pasted`], or why the browser refuses it. A desktop has egui read it, which pastes it by itself and says nothing: there
    /// nobody refuses.
    fn paste(&self, ctx: &egui::Context) {
        ctx.send_viewport_cmd(egui::ViewportCommand::RequestPaste);
    }

    /// Starts giving the person a file with this name, or one like it where that is taken; the outcome comes later as [`Event::Saved`].
    fn save_file(&mut self, ctx: &egui::Context, name: &str, contents: FileContents);

    /// Has the person choose files; what they hold comes later as [`Event::Opened`], nothing where the person chooses none.
    fn open_files(&mut self, ctx: &egui::Context);

    /// Reads files that were dropped on the window; what they hold comes later as [`Event::Dropped`]. A browser hands them to the page
    /// and not to egui, which is told of those alone that are dropped on its canvas.
    fn read_dropped(&mut self, _ctx: &egui::Context, _files: Vec<DroppedFileHandle>) {}

    /// Starts work beside the window, which reports as [`Event::Job`].
    fn start(&mut self, ctx: &egui::Context, run: Run, job: Job, attachments: Vec<Attachment>);

    /// Gives work up. It ends within a second, which is reported too.
    fn cancel(&mut self, ctx: &egui::Context, run: Run);

    /// Opens the dialog that prints the report of the session, for which the platform asks the application. Returns whether there is
    /// one: where there is none, a report is a file.
    fn print(&mut self) -> bool;

    /// Another screen is shown now, or the first one, which the platform may name its window after. In a browser *Back* leads to the one
    /// before, as [`Event::Screen`] with its `name`.
    fn screen_shown(&mut self, _name: &str, _title: &str) {}

    /// Whether the person points with fingers: then a field that gets the focus opens a keyboard over half the screen.
    fn has_touch(&self) -> bool {
        false
    }

    /// The events since the last call, in order. The implementation requests a repaint for each.
    fn events(&mut self) -> Vec<Event>;

    /// A clock, in seconds from some moment on.
    fn seconds(&self) -> f64;

    /// Today's date, "November 25, 2026", followed by the time zone where that is not the person's own.
    fn today(&self) -> String;

    /// The address at which the program opens, to be followed by `#` and what a link fills in.
    fn address(&self) -> String;

    /// The commit that the program was built from, where that is known.
    fn commit(&self) -> Option<String>;

    /// The licenses of the program and of everything in it.
    fn licenses(&self) -> Licenses;
}

/// Something that has happened outside the program.
#[derive(Clone, Debug, PartialEq)]
pub enum Event {
    /// The outcome of a [`Platform::copy`].
    Copied(Result<(), PlatformError>),
    /// The outcome of a [`Platform::paste`].
    Pasted(Result<String, PlatformError>),
    /// The outcome of a [`Platform::save_file`]: where the file is.
    Saved(Result<Place, PlatformError>),
    /// What the person wants of the colors from now on.
    Colors(Colors),
    /// A link to the program was followed: the part behind its `#`.
    Link(String),
    /// The person went back or forward to the screen with this name.
    Screen(String),
    /// What files hold that were chosen.
    Opened(Result<Vec<OpenedFile>, PlatformError>),
    /// What files hold that were dropped.
    Dropped(Result<Vec<OpenedFile>, PlatformError>),
    /// What work beside the window reports.
    Job(Report),
}

/// A file that was opened.
#[derive(Clone, PartialEq, Eq)]
pub struct OpenedFile {
    /// Its name, without its folder.
    pub name: String,
    /// What it holds.
    pub bytes: Vec<u8>,
}

impl std::fmt::Debug for OpenedFile {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{} ({} bytes)", self.name, self.bytes.len())
    }
}

/// What a file holds that the program gives out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FileContents {
    /// A picture, which the platform writes as PNG: a browser has that built in, and need not load it.
    Picture(egui::ColorImage),
    /// A page, as HTML.
    Page(String),
    /// Data, as JSON.
    Data(String),
}

/// Where the licenses of everything in the program are.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Licenses {
    /// Here, as lines of text.
    #[cfg(not(target_arch = "wasm32"))]
    Text(&'static str),
    /// On a page with this address.
    Page(&'static str),
}
