//! The egui application, the same in a browser, in a window and under test.
//!
//! [`App`] holds the state. `ui.rs` draws a frame, and collects commands; `logic.rs` carries them out before the next frame, handles
//! the events of the platform, and saves what changed.

mod about;
mod batches;
mod calculator;
mod camera_facts;
mod chart_picture;
mod command;
mod context;
mod copyable;
mod dialog;
mod import;
mod learn;
mod logic;
mod menu_key;
mod navigation;
mod notice;
mod opening;
mod platform;
mod presets;
mod report;
mod rigs;
mod saved;
mod sensor_mode;
mod sentences;
mod session;
mod shortcuts;
mod theme;
mod touch;
mod ui;
mod widgets;

use crate::core::problem::Field;
use calculator::Calculator;
use camera_facts::CameraFacts;
use chart_picture::ChartPicture;
use command::Command;
pub use copyable::Copyable;
use depth_jobs::Run;
use depth_text::entry::Entries;
use dialog::Dialog;
use egui::Ui;
use import::Import;
use notice::Notice;
pub use platform::{Event, FileContents, Licenses, OpenedFile, Platform};
use rigs::Rigs;
use saved::{Saved, Screen, Settings};
use sentences::FreshStart;
#[cfg(target_arch = "wasm32")]
pub use sentences::PageFailure;
#[cfg(test)]
pub(crate) use sentences::snapshot;
pub use sentences::{Place, PlatformError};
use session::Session;
use theme::Layout;
pub use theme::{Colors, INTER, SystemColors};
use widgets::field;

/// The application.
pub struct App {
    platform: Box<dyn Platform>,
    session: Session,
    settings: Settings,
    /// What was saved last, to save only what changed.
    stored: Saved,
    /// Storage holds a state that could not be read; it must not be overwritten.
    holds_unreadable: bool,
    calculator: Calculator,
    rigs: Rigs,
    camera_facts: CameraFacts,
    /// What is typed of another mode of a sensor.
    mode: Entries,
    /// The dialog that opens calibration files, where it is open.
    import: Option<Import>,
    /// The number of the last work beside the window.
    last_run: Run,
    notice: Option<Notice>,
    /// The dialog over the screen.
    dialog: Option<Dialog>,
    /// What was put on the clipboard last.
    copied: Copyable,
    colors: Colors,
    /// The chart that is being saved.
    chart_picture: Option<ChartPicture>,
    /// The commands of the last frame, in order.
    pending: Vec<Command>,
    /// Whether there has been a frame.
    has_started: bool,
    /// The screen that the platform knows of.
    told_screen: Option<Screen>,
}

impl App {
    /// The application with the state that `platform` has stored.
    pub fn new(cc: &eframe::CreationContext<'_>, platform: Box<dyn Platform>) -> Self {
        let ctx = &cc.egui_ctx;
        theme::install(ctx);
        ctx.add_plugin(touch::Touches::default());
        ctx.add_plugin(batches::Batches::default());
        ctx.add_plugin(menu_key::MenuKey);
        let (saved, unread) = match platform.load() {
            Ok(None) => (Saved::default(), None),
            Ok(Some(text)) => match Saved::from_text(&text) {
                Some(saved) => (saved, None),
                None => (Saved::default(), Some(FreshStart::NotParsed)),
            },
            Err(error) => (Saved::default(), Some(FreshStart::NotLoaded(error))),
        };
        ctx.set_theme(saved.settings.theme);
        let mut app = Self {
            platform,
            session: Session::new(saved.inputs.clone()),
            settings: saved.settings.clone(),
            stored: saved,
            holds_unreadable: unread.is_some(),
            calculator: Calculator::default(),
            rigs: Rigs::default(),
            camera_facts: CameraFacts::default(),
            mode: Entries::default(),
            import: None,
            last_run: 0,
            notice: None,
            dialog: None,
            copied: Copyable::Results,
            colors: Colors::Usual,
            chart_picture: None,
            pending: Vec::new(),
            has_started: false,
            told_screen: None,
        };
        if let Some(cause) = unread {
            app.start_fresh(cause);
        }
        app
    }

    /// Tells the platform which screen is shown, when that is another.
    fn tell_screen(&mut self) {
        let screen = self.settings.screen;
        if self.told_screen != Some(screen) {
            self.told_screen = Some(screen);
            self.platform.screen_shown(screen.name(), &screen.title());
        }
    }

    /// Focuses the first field on an empty form, before the first frame; not on a phone, where that would open the keyboard. Earlier
    /// the size of the window is not known.
    fn focus_first_field(&mut self, ctx: &egui::Context) {
        if !std::mem::replace(&mut self.has_started, true)
            && self.session.inputs.is_blank()
            && self.settings.screen == Screen::Calculator
            && !self.platform.has_touch()
            && Layout::of(ctx.content_rect().size()) != Layout::Phone
        {
            ctx.memory_mut(|memory| memory.request_focus(field::id(Field::FocalLength)));
        }
    }

    /// Puts `what` on the clipboard now, for a platform that allows it only while a click is being handled.
    pub fn copy(&mut self, ctx: &egui::Context, what: Copyable) {
        self.carry_out(ctx, Command::Copy(what));
    }
}

impl eframe::App for App {
    fn logic(&mut self, ctx: &egui::Context, _frame: &mut eframe::Frame) {
        self.update(ctx);
    }

    fn ui(&mut self, ui: &mut Ui, _frame: &mut eframe::Frame) {
        self.frame_ui(ui);
    }
}
