//! What the logic does about files and rigs: opens them, reads them beside the window, keeps what came of them.

use super::App;
use super::command::Command;
use super::import::Import;
use super::platform::{FileContents, OpenedFile};
use super::rigs::{self, Rig, RigsInFile};
use super::saved::Screen;
use super::sentences::{NoticeText, PlatformError};

impl App {
    /// Carries out a command about files and rigs.
    pub(super) fn carry_out_on_rigs(&mut self, ctx: &egui::Context, command: Command) {
        match command {
            Command::ShowImport => {
                self.close_import(ctx);
                self.import = Some(Import::default());
            }
            Command::CloseImport => self.close_import(ctx),
            Command::OpenFiles | Command::AddFiles => {
                if let Some(import) = &mut self.import {
                    import.add_to_these(command == Command::AddFiles);
                }
                self.platform.open_files(ctx);
            }
            Command::ReadText(text) => self.take_dropped_files(ctx, Ok(Import::of_text(text))),
            Command::AddRig(rig) => {
                self.close_import(ctx);
                self.settings.rigs.add(*rig);
                self.settings.screen = Screen::Rigs;
            }
            Command::UseCalibration(rig) => {
                self.settings.rigs.add((*rig).clone());
                self.use_rig(ctx, &rig);
            }
            Command::ShowRig(at) => self.settings.rigs.shown = at,
            Command::UseRig(at) => {
                if let Some(rig) = self.settings.rigs.all.get(at).cloned() {
                    self.use_rig(ctx, &rig);
                }
            }
            Command::RemoveRig(at) => {
                if let Some(rig) = self.settings.rigs.remove(at) {
                    let name = rig.shown_name().to_owned();
                    self.say(NoticeText::RigRemoved(name), Some(Command::PutBackRig(at, Box::new(rig))));
                }
            }
            Command::ChangeRig(at, rig) => {
                let name = rig.shown_name().to_owned();
                let before = self.settings.rigs.replace(at, *rig);
                let undo = before.map(|before| Command::ChangeRig(at, Box::new(before)));
                self.say(NoticeText::RigChanged(name), undo);
            }
            Command::PutBackRig(at, rig) => self.settings.rigs.put_back(at, *rig),
            Command::ExportRigs => match self.settings.rigs.to_file() {
                Ok(json) => self.platform.save_file(ctx, rigs::FILE_NAME, FileContents::Data(json)),
                Err(error) => self.say(NoticeText::RigsNotSaved { reason: error.to_string() }, None),
            },
            _ => {}
        }
    }

    /// Takes what was dropped or pasted, in the place of what was opened before.
    pub(super) fn take_dropped_files(&mut self, ctx: &egui::Context, opened: Result<Vec<OpenedFile>, PlatformError>) {
        if let Some(import) = &mut self.import {
            import.add_to_these(false);
        }
        self.take_opened(ctx, opened);
    }

    /// Takes what was opened: rigs that this program saved, and calibration files.
    pub(super) fn take_opened(&mut self, ctx: &egui::Context, opened: Result<Vec<OpenedFile>, PlatformError>) {
        let files = match (opened, &mut self.import) {
            (Ok(files), _) => files,
            (Err(error), Some(import)) => return import.fail(error.to_string()),
            (Err(error), None) => return self.say(NoticeText::NotOpened(error), None),
        };
        let (mut found, mut others) = (None, Vec::new());
        for file in files {
            match rigs::from_file(&file.bytes) {
                RigsInFile::None => others.push(file),
                RigsInFile::Some(rigs) => found.get_or_insert_with(Vec::new).extend(rigs),
                RigsInFile::Unreadable => return self.say(NoticeText::RigsNotRead { file: file.name }, None),
            }
        }
        if let Some(rigs) = found {
            self.add_rigs(ctx, rigs);
        }
        if !others.is_empty() {
            self.read(ctx, others);
        }
    }

    /// Has files that were dropped on the window read.
    pub(super) fn take_dropped(&mut self, ctx: &egui::Context) {
        let dropped = ctx.input_mut(|input| std::mem::take(&mut input.raw.dropped_files));
        if !dropped.is_empty() {
            self.platform.read_dropped(ctx, dropped);
        }
    }

    fn read(&mut self, ctx: &egui::Context, files: Vec<OpenedFile>) {
        self.last_run += 1;
        // One dialog at a time.
        self.dialog = None;
        self.calculator.helper = None;
        let import = self.import.get_or_insert_default();
        import.read(ctx, &mut *self.platform, (self.last_run, files));
    }

    fn close_import(&mut self, ctx: &egui::Context) {
        if let Some(mut import) = self.import.take() {
            import.give_up(ctx, &mut *self.platform);
        }
    }

    fn add_rigs(&mut self, ctx: &egui::Context, rigs: Vec<Rig>) {
        self.close_import(ctx);
        let before = self.settings.rigs.all.len();
        let count = rigs.len();
        for rig in rigs {
            self.settings.rigs.add(rig);
        }
        let added = self.settings.rigs.all.len() - before;
        self.settings.screen = Screen::Rigs;
        let left_out = count - added;
        self.say(NoticeText::RigsAdded { added, left_out }, None);
    }

    fn use_rig(&mut self, ctx: &egui::Context, rig: &Rig) {
        self.close_import(ctx);
        let name = rig.shown_name().to_owned();
        self.open(ctx, rig.used_in(&self.session.inputs), NoticeText::FilledByRig(name));
    }
}
