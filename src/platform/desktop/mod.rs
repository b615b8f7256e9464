//! The desktop program: a window, its icon, and a file for what was entered.

#[cfg(all(windows, not(debug_assertions)))]
mod console;
mod date;
mod failure;
mod files;
mod placement;
mod sentences;
mod state;
mod thread;

use crate::app::{App, Event, FileContents, Licenses, Place, Platform, PlatformError};
use depth_jobs::{Attachment, Job, Run};
use egui::DroppedFileHandle;
use placement::{Kept, PlacedApp};
use state::State;
use std::process::ExitCode;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::mpsc::{self, Receiver, Sender};
use std::time::Instant;

const NAME: &str = "Depth Calculator";
/// What a Linux desktop knows the window by: the class on X11, the application's id on Wayland.
const ID: &str = "depth-calculator";

/// With arguments answers on the terminal; without any opens the window and runs until it is closed.
pub fn main() -> ExitCode {
    if crate::cli::is_asked() {
        return crate::cli::main();
    }
    #[cfg(all(windows, not(debug_assertions)))]
    if console::leave() {
        return ExitCode::SUCCESS;
    }
    let state = State::within(state::folder());
    let file = state.file_named(placement::NAME);
    let placement = placement::load(file.as_deref());
    let window = egui::ViewportBuilder::default()
        .with_title(NAME)
        .with_app_id(ID)
        .with_min_inner_size(placement::MIN_SIZE)
        .with_icon(icon().unwrap_or_default());
    let options = eframe::NativeOptions {
        viewport: placement.apply(window),
        ..Default::default()
    };
    let is_open = Arc::new(AtomicBool::new(false));
    let opened = Arc::clone(&is_open);
    let run = move || {
        let open = |cc: &eframe::CreationContext<'_>| -> Box<dyn eframe::App> {
            let app = App::new(cc, Box::new(Desktop::new(state)));
            if let Some(window) = cc.winit_window() {
                placement.restore_position(window);
            }
            opened.store(true, Ordering::Relaxed);
            Box::new(PlacedApp::new(app, &cc.egui_ctx, Kept { placement, file }))
        };
        eframe::run_native(NAME, options, Box::new(move |cc| Ok(open(cc))))
    };
    match failure::report_failures(run, move || is_open.load(Ordering::Relaxed)) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            failure::show(&failure, NAME);
            ExitCode::FAILURE
        }
    }
}

fn icon() -> Option<egui::IconData> {
    let mut reader = png::Decoder::new(std::io::Cursor::new(include_bytes!("../../../assets/icons/icon-256.png")))
        .read_info()
        .ok()?;
    let mut rgba = vec![0; reader.output_buffer_size()?];
    let info = reader.next_frame(&mut rgba).ok()?;
    (info.color_type == png::ColorType::Rgba && info.bit_depth == png::BitDepth::Eight).then_some(egui::IconData {
        rgba,
        width: info.width,
        height: info.height,
    })
}

/// Keeps the state in its file, and copies through egui.
struct Desktop {
    state: State,
    events: Vec<Event>,
    /// What comes from threads.
    inbox: (Sender<Event>, Receiver<Event>),
    worker: thread::Worker,
    started: Instant,
}

impl Desktop {
    fn new(state: State) -> Self {
        Self {
            state,
            events: Vec::new(),
            inbox: mpsc::channel(),
            worker: thread::Worker::default(),
            started: Instant::now(),
        }
    }
}

impl Platform for Desktop {
    fn load(&self) -> Result<Option<String>, PlatformError> {
        self.state.load()
    }

    fn save(&mut self, text: &str) -> Result<(), PlatformError> {
        self.state.save(text)
    }

    fn set_aside(&mut self) -> Result<Option<Place>, PlatformError> {
        self.state.set_aside()
    }

    fn copy(&mut self, ctx: &egui::Context, text: String) {
        ctx.copy_text(text);
        self.events.push(Event::Copied(Ok(())));
        ctx.request_repaint();
    }

    fn save_file(&mut self, ctx: &egui::Context, name: &str, contents: FileContents) {
        let saved = files::folder().and_then(|folder| files::save(&folder, name, &contents));
        self.events.push(Event::Saved(saved.map(Place::File)));
        ctx.request_repaint();
    }

    fn open_files(&mut self, ctx: &egui::Context) {
        let (events, ctx) = (self.inbox.0.clone(), ctx.clone());
        let choose = move || {
            let chosen = rfd::FileDialog::new().set_title("Calibration files").pick_files();
            if let Some(paths) = chosen {
                events.send(Event::Opened(files::read(&paths))).ok();
                ctx.request_repaint();
            }
        };
        // The dialog holds up whoever opens it; only a Mac wants that to be the window.
        if cfg!(target_os = "macos") {
            choose();
        } else {
            std::thread::spawn(choose);
        }
    }

    fn read_dropped(&mut self, ctx: &egui::Context, dropped: Vec<DroppedFileHandle>) {
        let paths: Vec<_> = dropped.iter().map(|file| file.path().to_owned()).collect();
        let (events, ctx) = (self.inbox.0.clone(), ctx.clone());
        // A slow drive does not hold up the window.
        std::thread::spawn(move || {
            events.send(Event::Dropped(files::read(&paths))).ok();
            ctx.request_repaint();
        });
    }

    fn start(&mut self, ctx: &egui::Context, run: Run, job: Job, attachments: Vec<Attachment>) {
        self.worker.start(ctx, &self.inbox.0, (run, job, attachments));
    }

    fn cancel(&mut self, _ctx: &egui::Context, run: Run) {
        self.worker.cancel(run);
    }

    fn print(&mut self) -> bool {
        // A window has no paper of its own: what it saves, a browser prints.
        false
    }

    fn today(&self) -> String {
        date::today()
    }

    fn address(&self) -> String {
        env!("CARGO_PKG_HOMEPAGE").to_owned()
    }

    fn events(&mut self) -> Vec<Event> {
        let mut events = std::mem::take(&mut self.events);
        events.extend(self.inbox.1.try_iter());
        events
    }

    fn seconds(&self) -> f64 {
        self.started.elapsed().as_secs_f64()
    }

    fn commit(&self) -> Option<String> {
        // Set by the build of a release.
        option_env!("DEPTH_CALCULATOR_COMMIT")
            .filter(|commit| !commit.is_empty())
            .map(str::to_owned)
    }

    fn licenses(&self) -> Licenses {
        // `cargo xtask licenses` writes it.
        Licenses::Text(include_str!("../../../assets/licenses.txt"))
    }
}

#[cfg(test)]
mod tests {
    use super::{ID, NAME, icon};

    #[test]
    fn the_entry_of_a_linux_desktop_is_of_this_window() {
        let entry = include_str!("../../../assets/linux/depth-calculator.desktop");
        for line in [
            format!("StartupWMClass={ID}"),
            format!("Icon={ID}"),
            format!("Exec={ID}"),
            format!("Name={NAME}"),
            "Terminal=false".to_owned(),
        ] {
            assert!(entry.lines().any(|known| known == line), "{line}");
        }
    }

    #[test]
    fn the_window_has_an_icon() {
        assert!(icon().is_some_and(|icon| (icon.width, icon.height) == (256, 256)));
    }
}
