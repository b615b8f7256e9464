//! What everybody knows: cameras by their names, and objects by their sizes. Each is found by typing.

use super::command::{Command, Helper};
use super::context::AppContext;
use super::dialog::{Destination, DialogFrame, close_button_ui};
use super::rigs::{Rig, number};
use super::theme;
use super::widgets::search::{Row, Search};
use crate::core::quantity::Length;
use depth_presets::{Mode, PRESETS, Preset, SIZES, Size};
use depth_text::sentences::capital;
use egui::Ui;

/// Draws the dialog with the known cameras. One that is chosen goes to `destination`.
pub fn cameras_ui(ui: &mut Ui, cx: &mut AppContext<'_>, destination: Destination) {
    let all: Vec<(&Preset, &Mode)> = PRESETS
        .iter()
        .flat_map(|preset| preset.modes.iter().map(move |mode| (preset, mode)))
        .collect();
    let rows: Vec<Row> = all.iter().map(|(preset, mode)| camera(preset, mode)).collect();
    let list = List {
        title: "Known cameras",
        name: "Search the known cameras",
        example: "d435i, zed 1280, kitti",
        id: "known cameras",
        close: Command::ShowDialog(None),
    };
    let chosen = list.ui(ui, cx, &rows).and_then(|at| all.get(at));
    if let Some((preset, mode)) = chosen {
        let rig = Box::new(Rig::of_preset(preset, mode));
        cx.commands.push(match destination {
            Destination::Calculator => Command::UseCalibration(rig),
            Destination::Rig => Command::AddRig(rig),
        });
    }
}

/// Draws the dialog with the known sizes.
pub fn sizes_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let rows: Vec<Row> = SIZES.iter().map(size).collect();
    let list = List {
        title: Helper::Size.title(),
        name: "Search the known sizes",
        example: "card, door, tag",
        id: "known sizes",
        close: Command::Help(None),
    };
    if let Some(size) = list.ui(ui, cx, &rows).and_then(|at| SIZES.get(at)) {
        cx.commands.push(Command::UseSize(size));
    }
}

/// A dialog with a list in which something is found.
struct List {
    title: &'static str,
    name: &'static str,
    example: &'static str,
    id: &'static str,
    /// What closes it.
    close: Command,
}

impl List {
    /// Draws it. Returns the place of the row that was chosen, with which it closes.
    fn ui(self, ui: &mut Ui, cx: &mut AppContext<'_>, rows: &[Row]) -> Option<usize> {
        let frame = DialogFrame {
            id: self.id,
            title: self.title,
            max_width: theme::PRESETS_WIDTH,
        };
        let search = Search {
            id: self.id,
            name: self.name,
            example: self.example,
            height: ui.ctx().content_rect().height() - theme::PRESETS_FRAME_HEIGHT,
            takes_focus: !cx.platform.has_touch(),
        };
        let response = frame.ui(ui, |ui| {
            ui.spacing_mut().interact_size.y = cx.layout.control_height();
            ui.add_space(2.0 * theme::STEP);
            let chosen = search.ui(ui, rows, cx.commands);
            ui.add_space(2.0 * theme::STEP);
            (chosen, close_button_ui(ui, "Cancel", cx.layout))
        });
        let (chosen, is_cancelled) = response.inner;
        if chosen.is_some() || is_cancelled || response.should_close() {
            cx.commands.push(self.close);
        }
        chosen
    }
}

/// A camera with images of one size.
fn camera(preset: &Preset, mode: &Mode) -> Row {
    let title = match (mode.width, mode.height) {
        (Some(width), Some(height)) => format!("{}, {width} × {height} px", preset.label),
        (Some(width), None) => format!("{}, {width} px wide", preset.label),
        _ => preset.label.to_owned(),
    };
    let baseline = preset
        .baseline
        .map_or_else(|| "no stereo pair".to_owned(), |baseline| format!("b {}", millimeters(baseline)));
    let zero = preset
        .zero
        .map_or_else(String::new, |zero| format!(", front glass {} in front of zero", millimeters(zero)));
    Row {
        title,
        detail: format!(
            "fx {} px, {baseline}{zero}. {}: {}",
            number(mode.focal_length.px()),
            capital(preset.basis.name()),
            preset.source
        ),
        words: preset.name,
    }
}

/// An object.
fn size(size: &Size) -> Row {
    let value = match size.sigma {
        Some(sigma) => format!("({} ± {}) mm", number(size.size.m() * 1000.0), number(sigma.m() * 1000.0)),
        None => format!("{}, how exact is not known", millimeters(size.size)),
    };
    Row {
        title: size.label.to_owned(),
        detail: format!("{value}. {}", size.source),
        words: size.name,
    }
}

fn millimeters(length: Length) -> String {
    format!("{} mm", number(length.m() * 1000.0))
}
