//! What a person can ask for. Screens add [`Command`]s to a list, as one click can be two of them (a field is left, a button is
//! pressed); `logic.rs` is the one place that carries them out, in order.

use super::copyable::Copyable;
use super::dialog::{Destination, Dialog};
use super::rigs::Rig;
use super::saved::Screen;
use super::sentences::NoticeText;
use crate::core::problem::Field;
use crate::core::quantity::LengthUnit;
use depth_presets::Size;
use depth_text::entry::Entry;
use depth_text::field::Key as FieldKey;
use depth_text::form::Inputs;
use depth_text::report::strip::Mode;
use egui::{Event, InputState, Key, KeyboardShortcut, ModifierNames, Modifiers, ThemePreference};

/// A dialog of the calculator that knows where a number comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Helper {
    /// Where a focal length comes from.
    FocalLength,
    /// Which part of a baseline counts.
    Baseline,
    /// What a program calls a disparity, and doffs.
    Disparity,
    /// How large known things are.
    Size,
}

impl Helper {
    /// Whether its link comes behind all fields in the order of the focus: whoever types five numbers in a row needs it least.
    pub const fn comes_last(self) -> bool {
        matches!(self, Self::Baseline | Self::Size)
    }

    /// The helper that is offered at `field`.
    pub const fn at(field: Field) -> Option<Self> {
        match field {
            Field::FocalLength => Some(Self::FocalLength),
            Field::Baseline => Some(Self::Baseline),
            Field::Disparity => Some(Self::Disparity),
            Field::RealWidth => Some(Self::Size),
            _ => None,
        }
    }

    /// The heading of its dialog.
    pub const fn title(self) -> &'static str {
        match self {
            Self::FocalLength => "Where does the focal length come from?",
            Self::Baseline => "How do the cameras stand to the line of sight?",
            Self::Disparity => "Where does the disparity come from?",
            Self::Size => "Known sizes",
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
    /// Go back to the inputs before the last edit.
    Undo,
    /// Go forward again after [`Command::Undo`].
    Redo,
    /// Put this on the clipboard.
    Copy(Copyable),
    /// Replace what was typed, show the calculator, and say this.
    Open(Box<Inputs>, NoticeText),
    /// Fill in what the part of a link behind `#` names, and nothing else.
    Follow(String),
    /// Replace what was typed into a field by what a note offered.
    Fix(FieldKey, Entry),
    /// Replace what was typed into several fields of the form by what a helper computed, as one edit.
    FillIn(Vec<(FieldKey, Entry)>),
    /// Fill in the size of a known object.
    UseSize(&'static Size),
    /// Open the helper for the focal length at this way, with this multiple of the image's width.
    AskForWidth(&'static str, Entry),
    /// Move what a picture has of this field to this number, in the unit that it was typed in; all moves until [`Command::Settle`] are
    /// one undo step.
    Drag(FieldKey, f64),
    /// Save the chart that is this widget as a picture with this name.
    SavePicture(&'static str, egui::Id),
    /// Give out the report of the session: on paper in a browser, as a file on a desktop.
    SaveReport,
    /// An edit is complete: a drag ended, a field was left.
    Settle,
    /// Show a dialog over the screen, or close the one that is open.
    ShowDialog(Option<Dialog>),
    /// Open a helper, or close the one that is open.
    Help(Option<Helper>),
    /// Ask for this.
    Ask(Mode),
    /// Show or hide range, tilt and zero point.
    ShowRefinements(bool),
    /// Move the focus to this field, and show it.
    GoTo(FieldKey),
    /// Put what the machine holds to paste into the field that has the focus.
    Paste,
    /// Open the dialog that opens calibration files, or ask again in it.
    ShowImport,
    /// Close it.
    CloseImport,
    /// Have the person choose calibration files.
    OpenFiles,
    /// Have the person choose files that belong to those that are open.
    AddFiles,
    /// Read the text of a calibration file.
    ReadText(String),
    /// Keep this rig, and show it.
    AddRig(Box<Rig>),
    /// Keep this rig, which was read from files, and fill it into the calculator.
    UseCalibration(Box<Rig>),
    /// Show the rig at this place.
    ShowRig(usize),
    /// Fill the rig at this place into the calculator.
    UseRig(usize),
    /// Remove the rig at this place.
    RemoveRig(usize),
    /// Put this rig at the place of another.
    ChangeRig(usize, Box<Rig>),
    /// Put a rig that was removed back at its place.
    PutBackRig(usize, Box<Rig>),
    /// Save all rigs as a file.
    ExportRigs,
    /// Show a screen.
    Show(Screen),
    /// Show results in this unit.
    ShowResultsIn(LengthUnit),
    /// Light, dark, or as the system has it.
    Theme(ThemePreference),
    /// Close the notice bar.
    Dismiss,
}

impl Command {
    /// The text of its button or menu entry; empty where that has the name of what the command acts on, such as an example.
    pub const fn text(&self) -> &'static str {
        match self {
            Self::Calculate => "Calculate Distance",
            Self::Reset => "Reset",
            Self::Undo => "Undo",
            Self::Redo => "Redo",
            Self::Copy(Copyable::Results) => "Copy Results",
            Self::Copy(Copyable::QMatrix) => "Copy Q matrix",
            Self::Copy(Copyable::Value(_)) => "Copy value",
            Self::SavePicture(..) => "Save as PNG",
            Self::SaveReport if cfg!(target_arch = "wasm32") => "Print",
            Self::SaveReport => "Save report (HTML)",
            Self::ShowDialog(Some(Dialog::Keys)) => "Keys",
            Self::ShowDialog(Some(Dialog::About)) => "About Depth Calculator",
            Self::ShowDialog(Some(Dialog::Presets(Destination::Calculator))) => "Known cameras…",
            Self::ShowDialog(Some(Dialog::Presets(Destination::Rig))) => "Add a known camera…",
            Self::ShowDialog(Some(Dialog::CameraFacts(_))) => "Camera facts…",
            Self::ShowDialog(Some(Dialog::SensorMode)) => "Another mode…",
            Self::Help(Some(Helper::FocalLength)) => "From lens, FOV or Q…",
            Self::Help(Some(Helper::Baseline)) => "Not square…",
            Self::Help(Some(Helper::Disparity)) => "OpenCV × 16, doffs…",
            Self::Help(Some(Helper::Size)) => "Known sizes…",
            Self::Help(None) => "Cancel",
            Self::Ask(mode) => mode.name(),
            Self::ShowRefinements(_) => "Range, tilt, zero point",
            Self::Paste => "Paste",
            Self::ShowImport => "Calibration file…",
            Self::OpenFiles => "Open files…",
            Self::AddFiles => "Add another file…",
            Self::AddRig(_) => "New rig",
            Self::UseCalibration(_) | Self::UseRig(_) => "Use in calculator",
            Self::RemoveRig(_) => "Remove",
            Self::PutBackRig(..) | Self::ChangeRig(..) => "Undo",
            Self::ExportRigs => "Save as JSON",
            Self::CloseImport => "Cancel",
            Self::Show(screen) => screen.name(),
            Self::ShowResultsIn(unit) => unit.symbol(),
            Self::Theme(ThemePreference::System) => "As the system",
            Self::Theme(ThemePreference::Light) => "Light",
            Self::Theme(ThemePreference::Dark) => "Dark",
            Self::ShowDialog(None) | Self::Dismiss => "Close",
            Self::Open(..)
            | Self::Follow(_)
            | Self::Fix(..)
            | Self::FillIn(_)
            | Self::UseSize(_)
            | Self::AskForWidth(..)
            | Self::GoTo(_)
            | Self::Drag(..)
            | Self::ShowRig(_)
            | Self::ReadText(_)
            | Self::Settle => "",
        }
    }

    /// What it does, for the list of keys.
    pub const fn explanation(&self) -> &'static str {
        match self {
            Self::Calculate => "Calculate: marks what is missing and goes there",
            Self::Undo => "Undo (⌘ Z on a Mac)",
            Self::OpenFiles => "Open calibration files",
            Self::ShowDialog(Some(Dialog::Keys)) => "This list",
            other => other.text(),
        }
    }

    /// The keys that give it; the list of keys shows the first.
    pub const fn shortcuts(&self) -> &'static [Shortcut] {
        match self {
            Self::Calculate => const { &[Shortcut::new(Modifiers::NONE, Key::Enter, Scope::Field)] },
            Self::Undo => const { &[Shortcut::new(Modifiers::COMMAND, Key::Z, Scope::OutsideText)] },
            Self::Redo => {
                const {
                    &[
                        Shortcut::new(Modifiers::COMMAND.plus(Modifiers::SHIFT), Key::Z, Scope::OutsideText),
                        Shortcut::new(Modifiers::COMMAND, Key::Y, Scope::OutsideText),
                    ]
                }
            }
            Self::Show(Screen::Calculator) => const { &[Shortcut::new(Modifiers::ALT, Key::Num1, Scope::Everywhere)] },
            Self::Show(Screen::Rigs) => const { &[Shortcut::new(Modifiers::ALT, Key::Num2, Scope::Everywhere)] },
            Self::Show(Screen::Learn) => const { &[Shortcut::new(Modifiers::ALT, Key::Num3, Scope::Everywhere)] },
            // A browser has that key for itself.
            #[cfg(not(target_arch = "wasm32"))]
            Self::OpenFiles => const { &[Shortcut::new(Modifiers::COMMAND, Key::O, Scope::Everywhere)] },
            // In a browser that is its own key for printing, which never comes here.
            Self::SaveReport => const { &[Shortcut::new(Modifiers::COMMAND, Key::P, Scope::Everywhere)] },
            Self::ShowDialog(Some(Dialog::Keys)) => {
                const {
                    &[Shortcut {
                        keys: Keys::Character("?"),
                        scope: Scope::OutsideText,
                    }]
                }
            }
            _ => &[],
        }
    }

    /// Whether its keys were pressed that work in one of `scopes`. Takes them out of the input.
    pub fn take_keys(&self, input: &mut InputState, scopes: &[Scope]) -> bool {
        let mut shortcuts = self.shortcuts().iter().filter(|shortcut| scopes.contains(&shortcut.scope));
        shortcuts.any(|shortcut| shortcut.keys.take(input))
    }

    /// Whether the inputs as they are before it are added to the history for undo. Not before commands that only show something, nor
    /// before a move of a drag, which is part of a longer edit.
    pub const fn is_edit(&self) -> bool {
        match self {
            Self::Calculate
            | Self::Reset
            | Self::Undo
            | Self::Redo
            | Self::Open(..)
            | Self::Follow(_)
            | Self::Fix(..)
            | Self::FillIn(_)
            | Self::UseSize(_)
            | Self::AskForWidth(..)
            | Self::Ask(_)
            | Self::UseCalibration(_)
            | Self::UseRig(_)
            | Self::Settle => true,
            Self::Drag(..)
            | Self::SavePicture(..)
            | Self::SaveReport
            | Self::Copy(_)
            | Self::ShowImport
            | Self::CloseImport
            | Self::OpenFiles
            | Self::AddFiles
            | Self::ReadText(_)
            | Self::AddRig(_)
            | Self::ShowRig(_)
            | Self::RemoveRig(_)
            | Self::PutBackRig(..)
            | Self::ChangeRig(..)
            | Self::ExportRigs
            | Self::Show(_)
            | Self::ShowDialog(_)
            | Self::Help(_)
            | Self::ShowRefinements(_)
            | Self::GoTo(_)
            | Self::Paste
            | Self::ShowResultsIn(_)
            | Self::Dismiss
            | Self::Theme(_) => false,
        }
    }

    /// Whether the notice bar stays open. A link that names no field must not close it; one that does opens another.
    pub const fn keeps_notice(&self) -> bool {
        matches!(
            self,
            Self::Settle | Self::Theme(_) | Self::Follow(_) | Self::GoTo(_) | Self::ShowRig(_)
        )
    }
}

/// Keys, and where they work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Shortcut {
    keys: Keys,
    scope: Scope,
}

/// Where keys work.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scope {
    /// Wherever the focus is.
    Everywhere,
    /// Wherever no text is edited: in a text field, undo belongs to the text, and a question mark is text.
    OutsideText,
    /// In a field of the form, which asks for them.
    Field,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Keys {
    Combination(KeyboardShortcut),
    /// A character, on whichever key the keyboard has it.
    Character(&'static str),
}

impl Shortcut {
    const fn new(modifiers: Modifiers, key: Key, scope: Scope) -> Self {
        Self {
            keys: Keys::Combination(KeyboardShortcut::new(modifiers, key)),
            scope,
        }
    }

    /// How the list of keys writes it, with the names that the keys have on most keyboards.
    pub fn name(&self) -> String {
        const NAMES: ModifierNames<'_> = ModifierNames {
            concat: " + ",
            ..ModifierNames::NAMES
        };
        match self.keys {
            Keys::Combination(combination) => combination.format(&NAMES, false),
            Keys::Character(character) => character.to_owned(),
        }
    }
}

impl Keys {
    fn take(self, input: &mut InputState) -> bool {
        match self {
            Self::Combination(combination) => input.consume_shortcut(&combination),
            Self::Character(character) => input
                .events
                .iter()
                .any(|event| matches!(event, Event::Text(text) if text == character)),
        }
    }
}
