//! The dialog that makes another rig of one: the same camera in another mode of its sensor.

use super::command::Command;
use super::context::AppContext;
use super::dialog::{DialogFrame, close_button_ui};
use super::rigs::{MODE_KEYS, OtherMode, Rig, number, other_mode};
use super::theme;
use super::widgets::field::{self, Field};
use super::widgets::{main_button, pairs, scroll, text};
use depth_text::entry::Entries;
use depth_text::field::Key;
use egui::{Ui, vec2};

const LEAD: &str = "Resizing and binning scale fx, fy, cx, cy and doffs: 2 × 2 binning is half of the width. Cropping moves cx and cy, and changes no \
                    focal length. Neither changes the baseline. Some modes do both: first one, then the other.";

/// Draws the dialog for the rig that is shown.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, typed: &mut Entries) {
    let Some(rig) = cx.settings.rigs.shown() else {
        cx.commands.push(Command::ShowDialog(None));
        return;
    };
    let frame = DialogFrame {
        id: "sensor mode",
        title: "Another mode of the sensor",
        max_width: theme::PRESETS_WIDTH,
    };
    let before = rig.clone();
    let other = other_mode(&before, typed);
    let response = frame.ui(ui, |ui| {
        ui.spacing_mut().interact_size.y = cx.layout.control_height();
        let height = ui.ctx().content_rect().height() - theme::HELPER_FRAME_HEIGHT;
        scroll::up_to_ui(ui, height, |ui| {
            text::paragraph_ui(ui, LEAD);
            ui.add_space(theme::STEP);
            pairs::ui(ui, &MODE_KEYS, |ui, key| field_ui(ui, cx, typed, (&other, key)));
            let words = match &other.rig {
                Ok(after) => changes(&before, after),
                Err(problem) => problem.sentence().to_owned(),
            };
            let said = text::caption_ui(ui, words);
            text::announce(ui, &said);
        });
        ui.add_space(2.0 * theme::STEP);
        ui.horizontal_wrapped(|ui| {
            ui.spacing_mut().item_spacing = vec2(2.0 * theme::STEP, 2.0 * theme::STEP);
            let has_room = cx.settings.rigs.has_room();
            if main_button::ui(ui, "Add as another rig", other.rig.is_ok() && has_room)
                && let Ok(rig) = other.rig
            {
                cx.commands.push(Command::AddRig(Box::new(rig)));
                cx.commands.push(Command::ShowDialog(None));
            }
            close_button_ui(ui, "Cancel", cx.layout)
        })
        .inner
    });
    if response.inner || response.should_close() {
        cx.commands.push(Command::ShowDialog(None));
    }
}

fn field_ui(ui: &mut Ui, cx: &mut AppContext<'_>, typed: &mut Entries, (other, key): (&OtherMode, Key)) {
    let field = Field {
        key,
        reading: other.readings.iter().find(|reading| reading.key == key),
        notes: other.notes.iter().filter(|note| note.key == key).collect(),
        with_sigma: false,
        helper: None,
        id: field::id(key),
        submits: false,
        following: None,
        entry: typed.entry_mut(key),
    };
    let mut commands = Vec::new();
    field.ui(ui, &mut commands);
    for command in commands {
        match command {
            // What a note offers is of this dialog.
            Command::Fix(key, entry) => {
                typed.fill(key, entry);
                typed.entry_mut(key).tidy(key);
                ui.memory_mut(|memory| memory.request_focus(field::id(key)));
            }
            Command::Settle => {}
            other => cx.commands.push(other),
        }
    }
}

/// "fx: 631.343 → 378.806 px; cx: …"
fn changes(before: &Rig, after: &Rig) -> String {
    let short = |text: &str| {
        text.parse()
            .map_or_else(|_| text.to_owned(), |value: f64| number((value * 1000.0).round() / 1000.0))
    };
    let of = |key: Key| {
        let [from, to] = [before, after].map(|rig| rig.inputs.entry(key).text.as_str());
        let name = if key.symbol.is_empty() { key.label } else { key.symbol };
        (from != to).then(|| format!("{name}: {} → {} px", short(from), short(to)))
    };
    let all: Vec<String> = Rig::KEYS.into_iter().filter_map(of).collect();
    if all.is_empty() {
        "Nothing would change.".to_owned()
    } else {
        format!("{}.", all.join("; "))
    }
}
