//! The form: the fields, the buttons, the examples, and links to optional parts.

use super::unknown;
use crate::app::command::{Command, Helper};
use crate::app::context::AppContext;
use crate::app::copyable::Copyable;
use crate::app::sentences::NoticeText;
use crate::app::theme;
use crate::app::widgets::field::{self, Field};
use crate::app::widgets::{choice, text};
use crate::core::setup::{Object, Pair};
use depth_text::choices::MATCHING_ERRORS;
use depth_text::entry::Entry;
use depth_text::field::{Key, Section};
use depth_text::fields;
use depth_text::form::Example;
use depth_text::number::plain;
use depth_text::reading;
use egui::accesskit::Role;
use egui::{Button, ComboBox, Rect, RichText, Stroke, Ui, UiBuilder, vec2};

/// Draws the form. With `marked`, what is missing is said at the fields too.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, marked: bool) {
    let builder = UiBuilder::new().accessibility_role(Role::Form).accessibility_label("Inputs");
    ui.scope_builder(builder, |ui| {
        theme::card(theme::palette(ui)).show(ui, |ui| {
            ui.set_width(ui.available_width());
            ui.spacing_mut().item_spacing.y = theme::STEP;
            unknown::ui(ui, cx, marked);
            fields_ui(ui, cx, marked);
            part_ui(ui, Part::Buttons, |ui| {
                buttons_ui(ui, cx);
                ui.add_space(theme::STEP);
                examples_ui(ui, cx);
                more_ui(ui, cx);
            });
        });
    });
}

/// What a person needs who does not type five numbers in a row: drawn, and so in the order of the focus, behind the fields, each in the
/// line that was left for it.
enum Late {
    /// How the cameras stand, or what of the object is measured.
    Setup(Section),
    Helper(Helper),
}

fn fields_ui(ui: &mut Ui, cx: &mut AppContext<'_>, marked: bool) {
    let mut late = Vec::new();
    for section in Section::FORM {
        part_ui(ui, Part::Section(section), |ui| {
            late.push((Late::Setup(section), heading_ui(ui, cx, section)));
            let mut space = theme::FIRST_FIELD_SPACE;
            for key in section.keys() {
                // Most rigs have no doffs, so the field is hidden until there is one. fy belongs to a point in space, too.
                let is_of_point = key == fields::FY && cx.settings.shows_geometry;
                if !cx.session.inputs.shows(key) && !is_of_point {
                    continue;
                }
                ui.add_space(space);
                part_ui(ui, Part::Field(key.as_str()), |ui| {
                    let line = field_ui(ui, cx, key, marked);
                    let helper = key.input.and_then(Helper::at).filter(|helper| helper.comes_last());
                    late.extend(helper.map(|helper| (Late::Helper(helper), line)));
                });
                space = theme::STEP;
            }
        });
        ui.add_space(2.0 * theme::STEP);
    }
    part_ui(ui, Part::Late, |ui| {
        for (what, line) in late {
            match what {
                Late::Setup(section) => setup_ui(ui, cx, section, line),
                Late::Helper(helper) => field::helper_ui(ui, line, helper, cx.commands),
            }
        }
    });
}

/// The heading of a section. Returns what is left of its line.
fn heading_ui(ui: &mut Ui, cx: &AppContext<'_>, section: Section) -> Rect {
    let has_choice = matches!(section, Section::Stereo | Section::Monocular);
    let is_for_fingers = cx.layout.control_height() >= theme::CONTROL_HEIGHT_TOUCH;
    let height = if has_choice && is_for_fingers {
        theme::CONTROL_HEIGHT_TOUCH
    } else {
        theme::HEADING_HEIGHT
    };
    let line = vec2(ui.available_width(), height);
    let layout = egui::Layout::left_to_right(egui::Align::Center);
    let response = ui.allocate_ui_with_layout(line, layout, |ui| {
        ui.set_min_height(height);
        text::card_heading_ui(ui, section.name());
        ui.available_rect_before_wrap()
    });
    response.inner.shrink2(vec2(theme::STEP, 0.0))
}

/// What is chosen in a section, how the cameras stand or what of the object is measured, in the `line` of its heading.
fn setup_ui(ui: &mut Ui, cx: &mut AppContext<'_>, section: Section, line: Rect) {
    let inputs = &mut cx.session.inputs;
    let changed = match section {
        Section::Stereo => choice::ui(ui, line, "Cameras", &Pair::ALL, &mut inputs.pair),
        Section::Monocular => choice::ui(ui, line, "Measured", &Object::ALL, &mut inputs.object),
        _ => false,
    };
    if changed {
        cx.commands.push(Command::Settle);
    }
}

/// Draws a field. Returns the line of its label.
fn field_ui(ui: &mut Ui, cx: &mut AppContext<'_>, key: Key, marked: bool) -> Rect {
    let helper = key.input.and_then(Helper::at);
    let unit = cx.unit();
    let (inputs, assessment) = cx.session.parts();
    if let Some(unknown) = assessment.unknown.as_ref().filter(|unknown| key == unknown.field) {
        let line = ui.available_rect_before_wrap();
        let label = field::label_ui(ui, inputs.worded(key), helper, cx.commands);
        unknown::solution_ui(ui, unknown, unit);
        return line.with_max_y(label.rect.bottom());
    }
    let missing = assessment.missing.iter().find(|note| marked && note.key == key);
    let value_note = assessment.note(key).or(missing);
    let before = inputs.entry(key).clone();
    let field = Field {
        key: inputs.worded(key),
        reading: assessment.reading(key),
        notes: value_note.into_iter().chain(assessment.sigma_note(key)).collect(),
        with_sigma: inputs.with_uncertainty,
        helper,
        id: field::id(key),
        submits: true,
        entry: inputs.entry_mut(key),
    };
    let line = field.ui(ui, cx.commands);
    // One that was typed behind the value is shown in its own field.
    inputs.with_uncertainty |= inputs.sigma(key) != before.sigma;
    let value = |entry: &Entry| Some(reading::read(key, entry).ok()??.value);
    let now = inputs.entry(key);
    // Not where only a space or a σ was added, nor while it cannot be read.
    if now.text != before.text && value(now).is_some() && value(now) != value(&before) {
        inputs.edited(key);
    }
    if key == fields::DISPARITY && inputs.with_uncertainty {
        typical_errors_ui(ui, &mut inputs.entry_mut(key).sigma, cx.commands);
    }
    line
}

/// A choice among the matching errors that people state.
fn typical_errors_ui(ui: &mut Ui, sigma: &mut String, commands: &mut Vec<Command>) {
    ComboBox::from_id_salt("typical matching errors")
        .width(ui.available_width())
        .selected_text("Typical matching errors…")
        .show_ui(ui, |ui| {
            for (sigma_px, source) in MATCHING_ERRORS {
                let typical = plain(sigma_px);
                let choice = format!("± {typical} px: {source}");
                if ui.selectable_label(*sigma == typical, choice).clicked() {
                    *sigma = typical;
                    commands.push(Command::Settle);
                    ui.close();
                }
            }
        })
        .response
        .accessible_name("Typical matching errors");
}

/// A part of the form.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
enum Part {
    Section(Section),
    /// A field, by its key.
    Field(&'static str),
    Late,
    Buttons,
}

/// Draws a part of the form in a scope with an id of its own. Otherwise an error that appears would change the ids of all widgets
/// after it, and with them the nodes that a screen reader knows.
fn part_ui(ui: &mut Ui, part: Part, add_contents: impl FnOnce(&mut Ui)) {
    let builder = UiBuilder::new().scope_id(egui::Id::unique(("part of the form", part)));
    ui.scope_builder(builder, add_contents);
}

fn buttons_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let height = cx.layout.control_height();
    let palette = theme::palette(ui);
    let calculate = Button::new(
        RichText::new(Command::Calculate.text())
            .font(theme::strong(theme::BODY_SIZE))
            .color(palette.on_blue),
    )
    .fill(palette.blue)
    .stroke(Stroke::new(theme::THIN_LINE, palette.blue));
    if ui.add_sized(vec2(ui.available_width(), height), calculate).clicked() {
        cx.commands.push(Command::Calculate);
    }
    ui.add_space(theme::STEP);
    ui.horizontal(|ui| {
        ui.spacing_mut().item_spacing.x = 2.0 * theme::STEP;
        let width = (ui.available_width() - 2.0 * theme::STEP) / 2.0;
        for command in [Command::Reset, Command::Copy(Copyable::Results)] {
            let button = ui.add_sized(vec2(width, height), Button::new(command.text()));
            if let Command::Copy(what) = command {
                ui.accesskit_node_builder(button.id, |node| node.set_author_id(what.author_id()));
            }
            if button.clicked() {
                cx.commands.push(command);
            }
        }
    });
}

fn examples_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    ui.horizontal_wrapped(|ui| {
        text::caption_ui(ui, "Examples:");
        for example in Example::ALL {
            if text::link_button_ui(ui, example.name(), cx.layout).clicked() {
                cx.commands
                    .push(Command::Open(Box::new(example.inputs()), NoticeText::FilledByExample));
            }
        }
    });
}

/// Links that show or hide the optional parts.
fn more_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let inputs = &mut cx.session.inputs;
    ui.horizontal_wrapped(|ui| {
        text::caption_ui(ui, "More:");
        let name = if inputs.with_uncertainty {
            "Hide uncertainty"
        } else {
            "Add uncertainty"
        };
        if text::link_button_ui(ui, name, cx.layout).clicked() {
            inputs.with_uncertainty = !inputs.with_uncertainty;
            cx.commands.push(Command::Settle);
        }
        if inputs.unknown.is_none() && text::link_button_ui(ui, "Solve for another quantity", cx.layout).clicked() {
            inputs.unknown = Some(unknown::FIRST);
            cx.commands.push(Command::Settle);
        }
        let geometry = Command::ShowGeometry(!cx.settings.shows_geometry);
        let is_filled = !cx.settings.shows_geometry && inputs.has_geometry();
        let name = if is_filled {
            // What is hidden counts all the same.
            format!("{} (filled in)", geometry.text())
        } else {
            geometry.text().to_owned()
        };
        if text::link_button_ui(ui, &name, cx.layout).clicked() {
            cx.commands.push(geometry);
        }
        let two = Command::ShowTwo(!cx.settings.shows_two);
        let name = if !cx.settings.shows_two && inputs.has_two() {
            format!("{} (filled in)", two.text())
        } else {
            two.text().to_owned()
        };
        if text::link_button_ui(ui, &name, cx.layout).clicked() {
            cx.commands.push(two);
        }
    });
}
