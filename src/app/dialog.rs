//! Dialogs: which there are, and the frame that they have in common.

use super::theme::{self, Layout};
use super::widgets::{scroll, text};
use egui::{Button, Id, Modal, ModalResponse, Ui, vec2};

/// A dialog that any screen can open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dialog {
    /// The list of keys.
    Keys,
    /// What the program is, and its licenses.
    About,
    /// The cameras that everybody knows.
    Presets(Destination),
    /// What is stated of a camera, and what follows.
    CameraFacts(Destination),
    /// Another mode of the sensor of the rig that is shown.
    SensorMode,
}

/// Where what a dialog gives goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Destination {
    /// Into the form of the calculator.
    Calculator,
    /// Into the rigs.
    Rig,
}

/// The frame of a dialog: a card over the screen, with a heading.
#[derive(Clone, Copy, Debug)]
pub struct DialogFrame {
    /// Its egui id.
    pub id: &'static str,
    /// Its heading.
    pub title: &'static str,
    /// Its width in points, where the window is wide enough.
    pub max_width: f32,
}

impl DialogFrame {
    /// Draws the dialog.
    pub fn ui<R>(&self, ui: &Ui, add_contents: impl FnOnce(&mut Ui) -> R) -> ModalResponse<R> {
        let palette = theme::palette(ui);
        let modal = Modal::new(Id::unique(self.id)).frame(theme::card(palette));
        modal.show(ui.ctx(), |ui| {
            let room = ui.ctx().content_rect().size() - egui::Vec2::splat(theme::DIALOG_MARGINS);
            ui.set_width(room.x.min(self.max_width));
            let contents = |ui: &mut Ui| {
                let heading = text::heading_ui(ui, self.title, 2, theme::strong(theme::TITLE_SIZE), palette.text);
                // Orca does not say the name of a dialog that the focus comes into.
                text::announce(ui, &heading);
                add_contents(ui)
            };
            if ui.ctx().content_rect().height() < theme::DIALOG_WHOLE_HEIGHT {
                scroll::up_to_ui(ui, room.y, contents)
            } else {
                contents(ui)
            }
        })
    }
}

/// The button that closes a dialog, as high as controls are in `layout`. Returns whether it was clicked.
pub fn close_button_ui(ui: &mut Ui, name: &str, layout: Layout) -> bool {
    let size = vec2(theme::DIALOG_BUTTON_WIDTH, layout.control_height());
    ui.add_sized(size, Button::new(name)).clicked()
}
