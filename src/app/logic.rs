//! The logic, run before each frame: carries out commands, handles the events of the platform, runs the simulations, and stores what
//! changed.

use super::App;
use super::calculator;
use super::chart_picture::ChartPicture;
use super::command::Command;
use super::context::AppContext;
use super::copyable::Copyable;
use super::dialog::{Destination, Dialog};
use super::notice::Notice;
use super::platform::{Event, FileContents};
#[cfg(not(target_arch = "wasm32"))]
use super::report;
use super::saved::{Saved, Screen};
use super::sentences::{FreshStart, NoticeText, Place, PlatformError};
use super::theme::{self, Layout};
use super::widgets::field;
use crate::core::quantity::{Length, LengthUnit};
use depth_presets::Size;
use depth_text::entry::{Entries, Entry};
use depth_text::export::{Exporter as _, Text};
use depth_text::field::Key;
use depth_text::form::Inputs;
use depth_text::report::strip::Mode;
use depth_text::{fields, link, number, q_matrix};

impl App {
    /// Runs the logic.
    pub(super) fn update(&mut self, ctx: &egui::Context) {
        self.focus_first_field(ctx);
        for command in std::mem::take(&mut self.pending) {
            self.carry_out(ctx, command);
        }
        self.take_dropped(ctx);
        for event in self.platform.events() {
            self.handle(ctx, event);
        }
        self.go_on_with_picture(ctx);
        self.tell_screen();
        self.calculator.logic(&mut AppContext {
            egui: ctx,
            layout: Layout::of(ctx.content_rect().size()),
            session: &mut self.session,
            settings: &mut self.settings,
            platform: &*self.platform,
            commands: &mut self.pending,
        });
        self.store();
    }

    fn handle(&mut self, ctx: &egui::Context, event: Event) {
        match event {
            Event::Copied(Ok(())) => self.say(NoticeText::Copied(self.copied.clone()), None),
            Event::Copied(Err(error)) => self.say(NoticeText::NotCopied(error), None),
            // The field that has the focus takes it in this frame, as if it had been pasted by a key.
            Event::Pasted(Ok(text)) => ctx.input_mut(|input| input.events.push(egui::Event::Paste(text))),
            Event::Pasted(Err(error)) => self.say(NoticeText::NotPasted(error), None),
            Event::Saved(Ok(place)) => self.say(NoticeText::Saved(place), None),
            Event::Saved(Err(error)) => self.say(NoticeText::NotSaved(error), None),
            Event::Colors(colors) => {
                if colors != self.colors {
                    self.colors = colors;
                    theme::color(ctx, colors);
                }
            }
            Event::Opened(opened) => self.take_opened(ctx, opened),
            Event::Dropped(dropped) => self.take_dropped_files(ctx, dropped),
            Event::Job(report) => {
                if let Some(import) = &mut self.import {
                    import.hear(report);
                }
            }
            Event::Link(fragment) => self.carry_out(ctx, Command::Follow(fragment)),
            Event::Screen(name) => {
                if let Some(screen) = Screen::ALL.into_iter().find(|screen| screen.name() == name) {
                    self.carry_out(ctx, Command::Show(screen));
                }
            }
        }
    }

    /// The one place where commands take effect.
    pub(super) fn carry_out(&mut self, ctx: &egui::Context, command: Command) {
        if command.is_edit() {
            self.session.settle();
        }
        if !command.keeps_notice() {
            self.notice = None;
        }
        match command {
            Command::Settle | Command::Dismiss => {}
            Command::Calculate => self.calculator.calculate(ctx, &self.session, &mut self.settings),
            Command::Reset => self.reset(),
            Command::Open(inputs, said) => self.open(ctx, *inputs, said),
            Command::Follow(fragment) => self.follow(ctx, &fragment),
            Command::Undo => self.undo(),
            Command::Redo => self.redo(),
            Command::Copy(what) => {
                self.copied = what.clone();
                if let Some(text) = self.text_of(what) {
                    self.platform.copy(ctx, text);
                }
            }
            Command::Fix(key, entry) => self.fix(ctx, vec![(key, entry)]),
            Command::FillIn(fields) => self.fix(ctx, fields),
            Command::UseSize(size) => self.use_size(ctx, size),
            Command::AskForWidth(way, multiple) => {
                self.settings.entries.fill(fields::MULTIPLE, multiple);
                self.calculator.open_way(&mut self.settings.ways, way);
                ctx.memory_mut(|memory| memory.request_focus(field::id(fields::FRAME_WIDTH)));
            }
            Command::Drag(key, number) => self.session.inputs.entry_mut(key).text = number::plain(number),
            Command::SavePicture(title, chart) => self.chart_picture = Some(ChartPicture::new(title, chart)),
            Command::SaveReport => self.save_report(ctx),
            Command::ShowDialog(dialog) => self.show_dialog(dialog),
            Command::Help(helper) => self.calculator.helper = helper,
            Command::Ask(mode) => self.ask(mode),
            Command::ShowRefinements(shown) => self.calculator.show_refinements(&mut self.settings, shown),
            Command::GoTo(key) => self.calculator.go_to(ctx, key, &self.session, &mut self.settings),
            Command::Paste => self.platform.paste(ctx),
            Command::Show(screen) => self.settings.screen = screen,
            command @ (Command::ShowImport
            | Command::CloseImport
            | Command::OpenFiles
            | Command::AddFiles
            | Command::ReadText(_)
            | Command::AddRig(_)
            | Command::UseCalibration(_)
            | Command::ShowRig(_)
            | Command::UseRig(_)
            | Command::RemoveRig(_)
            | Command::PutBackRig(..)
            | Command::ChangeRig(..)
            | Command::ExportRigs) => self.carry_out_on_rigs(ctx, command),
            Command::ShowResultsIn(unit) => self.settings.result_unit = unit,
            Command::Theme(theme) => {
                self.settings.theme = theme;
                ctx.set_theme(theme);
            }
        }
        self.session.refresh();
        ctx.request_repaint();
    }

    /// Saves the chart that was asked for, as soon as there is a picture of it.
    fn go_on_with_picture(&mut self, ctx: &egui::Context) {
        let Some(chart) = &mut self.chart_picture else { return };
        let Some(outcome) = chart.advance(ctx) else { return };
        let name = chart.file_name();
        self.chart_picture = None;
        match outcome {
            Ok(picture) => self.platform.save_file(ctx, &name, FileContents::Picture(picture)),
            Err(error) => self.say(NoticeText::NotSaved(error), None),
        }
    }

    /// Gives the report out: on paper where there is a dialog for that, else as a file.
    fn save_report(&mut self, ctx: &egui::Context) {
        if self.platform.print() {
            return;
        }
        // A browser always has the dialog: what makes the file is no part of what it loads.
        #[cfg(not(target_arch = "wasm32"))]
        self.platform
            .save_file(ctx, report::FILE_NAME, FileContents::Page(self.report_page()));
        ctx.request_repaint();
    }

    fn text_of(&self, what: Copyable) -> Option<String> {
        match what {
            Copyable::Results => Some(self.with_results(|results| {
                let Ok(text) = Text.export(results);
                text
            })),
            Copyable::Value(text) => Some(text),
            Copyable::QMatrix => q_matrix::written(&q_matrix::of_form(self.session.assessment())?),
        }
    }

    fn ask(&mut self, mode: Mode) {
        self.settings.chosen_mode = mode;
        let inputs = &mut self.session.inputs;
        // Who comes back finds what was asked for before.
        let before = inputs.unknown.or(self.calculator.asked_before);
        inputs.unknown = (mode == Mode::Quantity).then(|| before.unwrap_or(calculator::FIRST_UNKNOWN));
        self.calculator.asked_before = before;
        self.calculator.marked = false;
    }

    fn reset(&mut self) {
        if self.session.inputs.is_blank() {
            self.say(NoticeText::NothingToClear, None);
        } else {
            self.say(NoticeText::Cleared, Some(Command::Undo));
        }
        self.session.inputs = Inputs::default();
        self.session.forget();
        self.calculator.marked = false;
    }

    pub(super) fn open(&mut self, ctx: &egui::Context, inputs: Inputs, said: NoticeText) {
        let replaced = !self.session.inputs.is_blank();
        self.session.inputs = inputs;
        self.session.forget();
        self.settings.screen = Screen::Calculator;
        self.calculator.reveal_results(ctx);
        self.calculator.helper = None;
        self.say(said, replaced.then_some(Command::Undo));
    }

    /// Fills in what the part of a link behind `#` names. One that names nothing changes nothing.
    fn follow(&mut self, ctx: &egui::Context, fragment: &str) {
        let mut inputs = self.session.inputs.clone();
        if link::apply(fragment, &mut inputs) {
            self.open(ctx, inputs, NoticeText::FilledByLink);
        }
    }

    fn undo(&mut self) {
        if self.session.undo() {
            self.say(NoticeText::Undone, Some(Command::Redo));
        } else {
            self.say(NoticeText::NothingToUndo, None);
        }
    }

    fn redo(&mut self) {
        if self.session.redo() {
            self.say(NoticeText::Redone, Some(Command::Undo));
        } else {
            self.say(NoticeText::NothingToRedo, None);
        }
    }

    /// Fills in fields, and moves the focus to the first.
    fn fix(&mut self, ctx: &egui::Context, filled: Vec<(Key, Entry)>) {
        if let Some((first, _)) = filled.first() {
            ctx.memory_mut(|memory| memory.request_focus(field::id(*first)));
        }
        for (key, entry) in filled {
            // Fields outside the form stay where they are typed into.
            if key.section.is_some() || key == fields::DISTANCE {
                self.calculator.helper = None;
                self.session.inputs.fill(key, entry);
                self.session.inputs.entry_mut(key).tidy(key);
            } else {
                self.settings.entries.fill(key, entry);
                self.settings.entries.entry_mut(key).tidy(key);
            }
        }
    }

    /// Fills in a known size, what of the object that is, and how exact it is; what it is, and from where, is said.
    fn use_size(&mut self, ctx: &egui::Context, size: &'static Size) {
        let millimeters = |length: Length| number::plain(length.m() * 1000.0);
        let inputs = &mut self.session.inputs;
        inputs.object = size.object;
        *inputs.entry_mut(fields::REAL_WIDTH) = Entry {
            sigma: size.sigma.map(millimeters).unwrap_or_default(),
            ..Entry::new(millimeters(size.size), Some(LengthUnit::Millimeter))
        };
        self.calculator.helper = None;
        let key = fields::REAL_WIDTH;
        ctx.memory_mut(|memory| memory.request_focus(field::id(key)));
        let (label, source) = (size.label, size.source);
        self.say(NoticeText::FilledBySize { label, source }, Some(Command::Undo));
    }

    /// Opens a dialog, or closes the one that is open.
    fn show_dialog(&mut self, dialog: Option<Dialog>) {
        match dialog {
            Some(Dialog::CameraFacts(Destination::Rig)) => {
                self.camera_facts.open_for_rig(self.settings.rigs.shown().map(|rig| &rig.inputs));
            }
            Some(Dialog::SensorMode) => self.mode = Entries::default(),
            _ => {}
        }
        self.dialog = dialog;
    }

    pub(super) fn say(&mut self, text: NoticeText, action: Option<Command>) {
        self.notice = Some(Notice { text, action });
    }

    /// Whether the state is saved.
    pub(super) fn is_stored(&self) -> bool {
        self.stored.inputs == self.session.inputs && self.stored.settings == self.settings
    }

    /// Starts with empty inputs: because of `cause`, what is stored cannot be used.
    pub(super) fn start_fresh(&mut self, cause: FreshStart) {
        let same = cause.clone();
        let Err(error) = self.set_aside_unreadable(|place| NoticeText::SetAside { cause: same, place }) else {
            return;
        };
        // Both are the same where storage does not work at all.
        let obstacle = (cause != FreshStart::NotLoaded(error.clone())).then_some(error);
        self.say(NoticeText::Forgetful { cause, obstacle }, None);
    }

    /// Moves what could not be read to another place in storage, and shows the notice about that place.
    fn set_aside_unreadable(&mut self, notice: impl FnOnce(Place) -> NoticeText) -> Result<(), PlatformError> {
        if self.holds_unreadable {
            let kept = self.platform.set_aside()?;
            self.holds_unreadable = false;
            if let Some(place) = kept {
                self.say(notice(place), None);
            }
        }
        Ok(())
    }

    /// Carries out what is left to do, and saves: the page or the window may be closed now.
    pub fn finish(&mut self, ctx: &egui::Context) {
        for command in std::mem::take(&mut self.pending) {
            self.carry_out(ctx, command);
        }
        self.store();
    }

    /// Saves the state if it changed. A failure is shown once for each change.
    fn store(&mut self) {
        if self.is_stored() {
            return;
        }
        self.stored = Saved {
            inputs: self.session.inputs.clone(),
            settings: self.settings.clone(),
        };
        let outcome = self
            .set_aside_unreadable(NoticeText::SetAsideLater)
            .and_then(|()| self.stored.to_text())
            .and_then(|text| self.platform.save(&text));
        if let Err(error) = outcome {
            self.say(NoticeText::NotStored(error), None);
        }
    }
}

#[cfg(test)]
mod tests;
