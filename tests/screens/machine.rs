//! A machine for the program to run on.

use depth_calculator::app::{Event, FileContents, Licenses, OpenedFile, Place, Platform, PlatformError};
use depth_jobs::engine::Engine;
use depth_jobs::{Attachment, Job, Request, Run};
use std::cell::{Cell, RefCell};
use std::rc::Rc;

/// What comes of opening files.
type Opened = Result<Vec<OpenedFile>, PlatformError>;

/// A machine whose storage and clipboard can be looked at.
#[derive(Clone, Default)]
pub struct Machine {
    pub stored: Rc<RefCell<Option<String>>>,
    /// What has been set aside, and whether there is room for more.
    pub set_aside: Rc<RefCell<Vec<String>>>,
    pub is_full: Rc<Cell<bool>>,
    pub clipboard: Rc<RefCell<Option<String>>>,
    pub copied: Rc<RefCell<Option<Result<(), PlatformError>>>>,
    /// The files that were saved, with their names.
    pub files: Rc<RefCell<Vec<(String, FileContents)>>>,
    pub saved: Rc<RefCell<Option<Result<Place, PlatformError>>>>,
    /// What the person chooses when they are asked for files, or what was dropped.
    pub chosen: Rc<RefCell<Option<Opened>>>,
    /// Whether they have been asked, or have dropped something.
    pub is_asked: Rc<Cell<bool>>,
    /// Whoever works beside the window, and whether work lies there undone.
    pub engine: Rc<RefCell<Engine>>,
    pub is_slow: Rc<Cell<bool>>,
    /// Whether it has a dialog for printing, and how often that was opened.
    pub has_paper: bool,
    pub printed: Rc<Cell<u32>>,
    pub link: Rc<RefCell<Option<String>>>,
    /// The clock goes on by so many seconds whenever it is looked at; it stands still otherwise.
    pub tick: f64,
    pub now: Rc<Cell<f64>>,
    pub broken: bool,
    pub commit: Option<&'static str>,
    pub licenses: Option<Licenses>,
}

impl Platform for Machine {
    fn load(&self) -> Result<Option<String>, PlatformError> {
        if self.broken {
            Err(PlatformError::NoStorage)
        } else {
            Ok(self.stored.borrow().clone())
        }
    }
    fn save(&mut self, text: &str) -> Result<(), PlatformError> {
        if self.broken {
            return Err(PlatformError::NoStorage);
        }
        *self.stored.borrow_mut() = Some(text.to_owned());
        Ok(())
    }
    fn set_aside(&mut self) -> Result<Option<Place>, PlatformError> {
        if self.broken {
            return Err(PlatformError::NoStorage);
        }
        if self.is_full.get() {
            return Err(PlatformError::NotSetAside {
                reason: "Storage is full.".into(),
            });
        }
        self.set_aside.borrow_mut().extend(self.stored.take());
        Ok(Some(Place::File("shelf.json".into())))
    }
    fn copy(&mut self, ctx: &egui::Context, text: String) {
        *self.clipboard.borrow_mut() = Some(text);
        *self.copied.borrow_mut() = Some(if self.broken { Err(PlatformError::NoClipboard) } else { Ok(()) });
        ctx.request_repaint();
    }
    fn save_file(&mut self, ctx: &egui::Context, name: &str, contents: FileContents) {
        let outcome = if self.broken {
            Err(PlatformError::NoHomeFolder)
        } else {
            self.files.borrow_mut().push((name.to_owned(), contents));
            Ok(Place::File(name.into()))
        };
        *self.saved.borrow_mut() = Some(outcome);
        ctx.request_repaint();
    }
    fn open_files(&mut self, ctx: &egui::Context) {
        self.is_asked.set(true);
        ctx.request_repaint();
    }
    fn read_dropped(&mut self, ctx: &egui::Context, _files: Vec<egui::DroppedFileHandle>) {
        self.is_asked.set(true);
        ctx.request_repaint();
    }
    fn start(&mut self, ctx: &egui::Context, run: Run, job: Job, attachments: Vec<Attachment>) {
        self.engine.borrow_mut().receive(Request::Start { run, job }, attachments);
        ctx.request_repaint();
    }
    fn cancel(&mut self, ctx: &egui::Context, run: Run) {
        self.engine.borrow_mut().receive(Request::Cancel { run }, Vec::new());
        ctx.request_repaint();
    }
    fn print(&mut self) -> bool {
        self.printed.set(self.printed.get() + u32::from(self.has_paper));
        self.has_paper
    }
    fn today(&self) -> String {
        "November 25, 2026".to_owned()
    }
    fn address(&self) -> String {
        "https://example.org/".to_owned()
    }
    fn seconds(&self) -> f64 {
        self.now.replace(self.now.get() + self.tick)
    }
    fn commit(&self) -> Option<String> {
        self.commit.map(str::to_owned)
    }
    fn licenses(&self) -> Licenses {
        self.licenses.unwrap_or(Licenses::Page("licenses.html"))
    }
    fn events(&mut self) -> Vec<Event> {
        let link = self.link.borrow_mut().take().map(Event::Link);
        let copied = self.copied.borrow_mut().take().map(Event::Copied);
        let saved = self.saved.borrow_mut().take().map(Event::Saved);
        let opened = if self.is_asked.take() {
            self.chosen.borrow_mut().take().map(Event::Opened)
        } else {
            None
        };
        let mut engine = self.engine.borrow_mut();
        while !self.is_slow.get() && engine.step() {}
        let reports = std::iter::from_fn(|| engine.report().map(Event::Job));
        link.into_iter().chain(copied).chain(saved).chain(opened).chain(reports).collect()
    }
}
