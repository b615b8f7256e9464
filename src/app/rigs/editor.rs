//! The editor of one rig.

use super::list::letter;
use super::rig::{Basis, Rig};
use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::dialog::{Destination, Dialog};
use crate::app::theme;
use crate::app::widgets::field::Field;
use crate::app::widgets::joined::{self, Cells};
use crate::app::widgets::{choice, main_button, pairs, text, text_menu};
use crate::core::setup::Pair;
use depth_text::assess::Assessment;
use depth_text::field::Key;
use depth_text::fields;
use depth_text::reading;
use egui::{Button, Id, RichText, Sense, Ui, UiBuilder, vec2};

/// The fields that stand side by side, and under which heading.
const GROUPS: [(&str, &[Key]); 3] = [
    ("Image", &[fields::FRAME_WIDTH, fields::FRAME_HEIGHT]),
    ("Camera", &[fields::FOCAL_LENGTH, fields::FY, fields::CX, fields::CY]),
    ("Pair", &[fields::BASELINE, fields::DOFFS, fields::ZERO]),
];

/// The place of a rig in the list, and how often rigs have moved in it.
type Place = (usize, u32);

/// Draws the editor of the rig that is shown.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, assessment: Option<&Assessment>) {
    let at = cx.settings.rigs.shown;
    let place = (at, cx.settings.rigs.moves);
    let mut commands = Vec::new();
    let height = cx.layout.control_height();
    let Some(rig) = cx.settings.rigs.shown_mut() else { return };
    let title = format!("Rig {}", letter(at));
    let palette = theme::palette(ui);
    text::heading_ui(ui, &title, 2, theme::strong(theme::CARD_HEADING_SIZE), palette.text);
    ui.scope_builder(UiBuilder::new().scope_id(Id::unique(("editor of a rig", place))), |ui| {
        ui.spacing_mut().item_spacing.y = 0.0;
        ui.add_space(theme::STEP);
        text_field_ui(ui, (place, "Name"), (&mut rig.name, "Robot, front"), &mut commands);
        for (heading, keys) in GROUPS {
            group_heading_ui(ui, heading, rig);
            pairs::ui(ui, keys, |ui, key| field_ui(ui, (place, key), rig, assessment, &mut commands));
        }
        text_field_ui(
            ui,
            (place, "Distortion"),
            (&mut rig.distortion, "plumb bob: −0.28, 0.07, 0, 0"),
            &mut commands,
        );
        text_field_ui(ui, (place, "Source"), (&mut rig.source, "Calibration of November"), &mut commands);
    });
    ui.add_space(2.0 * theme::STEP);
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing = vec2(2.0 * theme::STEP, 2.0 * theme::STEP);
        let use_it = Command::UseRig(at);
        if main_button::ui(ui, use_it.text(), !rig.is_blank()) {
            commands.push(use_it);
        }
        let dialogs = [Dialog::CameraFacts(Destination::Rig), Dialog::SensorMode].map(|dialog| Command::ShowDialog(Some(dialog)));
        for command in dialogs.into_iter().chain([Command::RemoveRig(at)]) {
            if ui.add(Button::new(command.text()).min_size(vec2(0.0, height))).clicked() {
                commands.push(command);
            }
        }
    });
    for command in commands {
        match command {
            // What a note offers is of the rig.
            Command::Fix(key, entry) => cx.settings.rigs.fix(key, entry),
            Command::Calculate | Command::Settle => {}
            other => cx.commands.push(other),
        }
    }
}

/// A heading, with the choice that belongs to its fields at the end of its line.
fn group_heading_ui(ui: &mut Ui, heading: &str, rig: &mut Rig) {
    let height = ui.spacing().interact_size.y.max(theme::CHOICE_HEIGHT);
    let (line, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    let mut left = ui.new_child(UiBuilder::new().id_salt(heading).max_rect(line).layout(layout));
    let color = theme::palette(ui).muted;
    text::heading_ui(&mut left, heading, 3, theme::strong(theme::SMALL_SIZE), color);
    match heading {
        "Camera" => _ = choice::ui(ui, line, "Images", &Basis::ALL, &mut rig.basis),
        "Pair" => _ = choice::ui(ui, line, "Cameras", &Pair::ALL, &mut rig.inputs.pair),
        _ => {}
    }
}

fn field_ui(ui: &mut Ui, (place, key): (Place, Key), rig: &mut Rig, assessment: Option<&Assessment>, commands: &mut Vec<Command>) {
    // What is of the calculator too, the assessment has read.
    let own = reading::read(key, rig.inputs.entry(key));
    let is_of_form = key.section.is_some();
    let assessment = assessment.filter(|_| is_of_form);
    let notes = assessment
        .into_iter()
        .flat_map(|all| all.note(key).into_iter().chain(all.sigma_note(key)));
    let own_note = own.as_ref().err().filter(|_| !is_of_form);
    let field = Field {
        key: rig.inputs.worded(key),
        reading: own.as_ref().ok().and_then(Option::as_ref),
        notes: notes.chain(own_note).collect(),
        with_sigma: true,
        helper: None,
        id: Id::unique(("field of a rig", place, key.as_str())),
        submits: false,
        following: None,
        entry: rig.inputs.entry_mut(key),
    };
    field.ui(ui, commands);
}

/// A field for a text that is no number.
fn text_field_ui(ui: &mut Ui, (place, name): (Place, &str), (typed, example): (&mut String, &str), commands: &mut Vec<Command>) {
    let palette = theme::palette(ui);
    let label = ui.label(RichText::new(name).font(theme::strong(theme::BODY_SIZE)).color(palette.text));
    ui.add_space(theme::LABEL_GAP);
    let height = crate::app::widgets::field::height(ui);
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    let cells = Cells::of(rect, false, false);
    joined::ground_ui(ui, &cells, false);
    let id = Id::unique(("text of a rig", place, name));
    let output = joined::words_ui(ui, cells.value, typed, (id, example));
    let response = output.response.response.labelled_by(label.id);
    text_menu::ui(&response, typed, commands);
    joined::border_ui(ui, &cells, None, response.has_focus());
    ui.add_space(2.0 * theme::STEP);
}
