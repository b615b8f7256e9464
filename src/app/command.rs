//! What a person can want. Screens add [`Command`]s to a list, as one click can be two things (a field is left, a button is
//! pressed); `App::logic` is the one place that carries them out, in order.

use super::dialog::Dialog;
use super::saved::Screen;
use crate::core::problem::Field;
use crate::core::quantity::{LengthUnit, Pixels};
use crate::formats::field::Key;
use crate::formats::inputs::{Entry, Inputs};
use egui::ThemePreference;

/// A dialog of the calculator that knows where a number comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Helper {
    /// Where a focal length comes from.
    FocalLength,
    /// What a program calls a disparity, and doffs.
    Disparity,
}

impl Helper {
    /// The helper that is offered at `field`, and what its link says.
    pub const fn at(field: Field) -> Option<(Self, &'static str)> {
        match field {
            Field::FocalLength => Some((Self::FocalLength, "from lens, FOV or Q…")),
            Field::Disparity => Some((Self::Disparity, "OpenCV ×16, doffs…")),
            _ => None,
        }
    }
}

/// Something a person asked for.
#[derive(Clone, Debug, PartialEq)]
pub enum Command {
    /// Mark every problem and go to the first.
    Calculate,
    /// Clear all fields.
    Reset,
    /// Take back the last change of the inputs.
    Undo,
    /// Make the change again that was taken back.
    Redo,
    /// Put the results on the clipboard.
    CopyResults,
    /// Replace what was typed, show the calculator, and say this.
    Open(Box<Inputs>, &'static str),
    /// Fill in what the part of a link behind `#` names, and nothing else.
    Follow(String),
    /// Replace what was typed into a field by what a note offered.
    Fix(Key, Entry),
    /// The pointer moved the point on the curve to this disparity, px; all moves until [`Command::Settle`] are one undo step.
    DragDisparity(f64),
    /// An edit is complete: a drag ended, a field was left.
    Settle,
    /// Show a dialog over the screen, or take away the one that is there.
    ShowDialog(Option<Dialog>),
    /// Open a helper, or close the one that is open.
    Help(Option<Helper>),
    /// The principal point became known, cx and cy.
    PrincipalPoint(Pixels, Pixels),
    /// Show or hide range, tilt and ground plane.
    ShowGeometry(bool),
    /// Show a screen.
    Show(Screen),
    /// Show results in this unit.
    ShowResultsIn(LengthUnit),
    /// Light, dark, or as the system has it.
    Theme(ThemePreference),
    /// Take the notice away.
    Dismiss,
}
