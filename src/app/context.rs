//! What every screen and dialog is given to draw with.

use super::command::Command;
use super::platform::Platform;
use super::saved::Settings;
use super::session::Session;
use super::theme::{self, Layout};
use crate::core::quantity::LengthUnit;

/// What a screen or a dialog is given: `ui(&mut self, ui: &mut Ui, cx: &mut AppContext)` draws it and adds commands,
/// `logic(&mut self, cx: &mut AppContext)` does what takes longer than a frame.
pub struct AppContext<'a> {
    /// egui's own context, to ask for another frame.
    pub egui: &'a egui::Context,
    /// What the width of the window leaves room for.
    pub layout: Layout,
    /// The inputs and their assessment.
    pub session: &'a mut Session,
    /// The settings of the program.
    pub settings: &'a mut Settings,
    /// The platform, to read from; `logic.rs` alone calls what changes something there.
    pub platform: &'a dyn Platform,
    /// The commands to carry out before the next frame.
    pub commands: &'a mut Vec<Command>,
}

impl AppContext<'_> {
    /// What is asked for.
    pub fn mode(&self) -> Mode {
        self.settings.mode(&self.session.inputs)
    }

    /// Whether the window is so low that everything scrolls as one piece.
    pub fn is_low(&self) -> bool {
        theme::is_low(self.egui.content_rect().height())
    }

    /// The unit of the results.
    pub const fn unit(&self) -> LengthUnit {
        self.settings.result_unit
    }
}
use depth_text::report::strip::Mode;
