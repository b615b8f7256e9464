//! What every screen and dialog is given to draw with.

use super::command::Command;
use super::platform::Platform;
use super::saved::Settings;
use super::session::Session;
use super::theme::Layout;
use crate::core::quantity::LengthUnit;

/// What a screen or a dialog is given: `ui(&mut self, ui: &mut Ui, cx: &mut AppContext)` draws it and adds commands,
/// `logic(&mut self, cx: &mut AppContext)` does what takes longer than a frame.
pub struct AppContext<'a> {
    /// egui's own context, to ask for another frame.
    pub egui: &'a egui::Context,
    /// What the width of the window leaves room for.
    pub layout: Layout,
    /// What is typed, and what follows from it.
    pub session: &'a mut Session,
    /// What was chosen.
    pub settings: &'a mut Settings,
    /// The machine, for what it knows; `logic.rs` alone acts on it.
    pub platform: &'a dyn Platform,
    /// What the person asks for, carried out before the next frame.
    pub commands: &'a mut Vec<Command>,
}

impl AppContext<'_> {
    /// The unit of the results.
    pub const fn unit(&self) -> LengthUnit {
        self.settings.result_unit
    }
}
