//! A field for one quantity: name, text, unit, hint, and what is wrong with it.

use crate::app::command::{Command, Helper};
use crate::app::theme::{self, SIGMA_WIDTH, UNIT_WIDTH};
use crate::core::disparity::MATCHING_ERRORS;
use crate::core::problem::Field;
use crate::core::quantity::LengthUnit;
use crate::formats::inputs::{Inputs, Note, Severity, Unknown, example_text, hint};
use crate::formats::number::plain;
use crate::formats::report;
use egui::accesskit::Role;
use egui::text::{CCursor, CCursorRange};
use egui::{Align, Button, ComboBox, Id, Key, Modifiers, Response, RichText, Sense, Stroke, TextEdit, Ui, vec2};

/// What stands around a field.
#[derive(Clone, Copy, Debug, Default)]
pub struct Around<'a> {
    /// What is to be said about its value.
    pub value_note: Option<&'a Note>,
    /// What is to be said about its σ.
    pub sigma_note: Option<&'a Note>,
    /// The helper that knows where such numbers come from, and what its link says.
    pub helper: Option<(Helper, &'static str)>,
    /// Set where the field is what is solved for: it shows the solution and takes no text.
    pub computed: Option<&'a Unknown>,
}

/// The id of the text field of `field`, for moving the focus to it.
pub fn id(field: Field) -> Id {
    Id::unique(("quantity field", field))
}

/// The id of the field for the σ of `field`.
pub fn sigma_id(field: Field) -> Id {
    Id::unique(("uncertainty field", field))
}

/// Draws the field. Edits go straight into `inputs`; what else the person wants is added to `commands`.
pub fn show(ui: &mut Ui, inputs: &mut Inputs, field: Field, around: Around<'_>, height: f32, commands: &mut Vec<Command>) {
    let palette = theme::palette(ui);
    let line = vec2(
        ui.available_width(),
        if height >= theme::CONTROL_HEIGHT_TOUCH && around.helper.is_some() {
            height
        } else {
            20.0
        },
    );
    let name = ui
        .allocate_ui_with_layout(line, egui::Layout::left_to_right(Align::Center), |ui| {
            ui.spacing_mut().interact_size.y = line.y;
            let name = ui.label(
                RichText::new(field.name())
                    .font(theme::strong(theme::BODY_SIZE))
                    .color(palette.text),
            );
            if let Some((helper, link)) = around.helper {
                ui.with_layout(egui::Layout::right_to_left(Align::Center), |ui| {
                    let link = Button::new(RichText::new(link).size(theme::SMALL_SIZE).color(palette.blue)).frame(false);
                    if ui.add(link.min_size(vec2(0.0, line.y))).clicked() {
                        commands.push(Command::Help(Some(helper)));
                    }
                });
            }
            name
        })
        .inner;
    if let Some(unknown) = around.computed {
        computed(ui, inputs, unknown, height);
        return;
    }
    let text_response = ui
        .horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.spacing_mut().interact_size.y = height;
            let sigma_width = if inputs.with_uncertainty { SIGMA_WIDTH + 6.0 } else { 0.0 };
            let width = ui.available_width() - UNIT_WIDTH - 6.0 - sigma_width;
            let response = text_field(ui, inputs, field, around.value_note, vec2(width, height), &name, commands);
            unit_choice(ui, inputs, field, vec2(UNIT_WIDTH, height), commands);
            if inputs.with_uncertainty {
                sigma_field(ui, inputs, field, around.sigma_note, vec2(SIGMA_WIDTH, height), commands);
            }
            response
        })
        .inner;
    super::text::caption(ui, hint(field));
    if inputs.with_uncertainty && field == Field::Disparity {
        typical_errors(ui, inputs, field, height, commands);
    }
    for (note, id) in [(around.value_note, text_response.id), (around.sigma_note, sigma_id(field))] {
        let Some(note) = note else { continue };
        note_below(ui, note, id, height, commands);
    }
}

fn text_field(
    ui: &mut Ui,
    inputs: &mut Inputs,
    field: Field,
    note: Option<&Note>,
    size: egui::Vec2,
    name: &Response,
    commands: &mut Vec<Command>,
) -> Response {
    let id = id(field);
    if ui.memory(|memory| memory.has_focus(id)) {
        let steps = ui.input_mut(|input| {
            let mut steps = 0;
            // Shift first: a key without modifiers also matches when Shift is held.
            for (modifiers, size) in [(Modifiers::SHIFT, 10), (Modifiers::NONE, 1)] {
                steps += size * i32::try_from(input.count_and_consume_key(modifiers, Key::ArrowUp)).unwrap_or(0);
                steps -= size * i32::try_from(input.count_and_consume_key(modifiers, Key::ArrowDown)).unwrap_or(0);
            }
            steps
        });
        if steps != 0 {
            inputs.step(field, steps);
        }
        if ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter)) {
            inputs.tidy(field);
            commands.push(Command::Calculate);
        }
    }
    let output = ui
        .scope(|ui| {
            mark(ui, note);
            let palette = theme::palette(ui);
            TextEdit::singleline(&mut inputs.entry_mut(field).text)
                .id(id)
                .hint_text(RichText::new(format!("e.g. {}", example_text(field))).color(palette.muted))
                .align(egui::Align2::RIGHT_CENTER)
                .margin(egui::Margin::symmetric(10, 4))
                .desired_width(size.x)
                .min_size(size)
                .return_key(None)
                .show(ui)
        })
        .inner;
    let response = output.response.response.labelled_by(name.id);
    ui.accesskit_node_builder(id, |node| {
        // A number with a unit is typed as text, but assistive technology and phones should know that it is a number.
        node.set_role(Role::NumberInput);
        let unit = if inputs.unit(field).is_none() { " In pixels." } else { "" };
        node.set_description(format!("{}{unit} Arrow up and down step the value.", hint(field)));
        if let Some(value) = inputs.number(field) {
            node.set_numeric_value(value);
        }
    });
    if response.gained_focus() {
        // As in a form of the browser: arriving by keyboard selects, so that typing replaces.
        if ui.input(|input| input.key_pressed(Key::Tab)) {
            let mut state = output.state;
            let all = CCursorRange::two(CCursor::default(), CCursor::new(inputs.entry(field).text.chars().count()));
            state.cursor.set_char_range(Some(all));
            state.store(ui.ctx(), id);
        }
    }
    if response.lost_focus() {
        inputs.tidy(field);
        commands.push(Command::Settle);
    }
    response
}

/// The solution in place of the field.
fn computed(ui: &mut Ui, inputs: &Inputs, unknown: &Unknown, height: f32) {
    let palette = theme::palette(ui);
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    ui.painter().rect_filled(rect, theme::CONTROL_RADIUS, palette.highlight);
    let words = report::unknown(unknown, inputs.unit(unknown.field));
    // Not live: the result card says the same.
    ui.put(
        rect.shrink2(vec2(10.0, 0.0)),
        egui::Label::new(RichText::new(words).font(theme::strong(theme::BODY_SIZE))),
    );
    super::text::caption(ui, "Computed from the distance and the other quantities.");
}

fn sigma_field(ui: &mut Ui, inputs: &mut Inputs, field: Field, note: Option<&Note>, size: egui::Vec2, commands: &mut Vec<Command>) {
    let palette = theme::palette(ui);
    let id = sigma_id(field);
    if ui.memory(|memory| memory.has_focus(id)) && ui.input_mut(|input| input.consume_key(Modifiers::NONE, Key::Enter)) {
        commands.push(Command::Calculate);
    }
    let mut text = inputs.sigma(field).to_owned();
    let response = ui
        .scope(|ui| {
            mark(ui, note);
            // Not a number to phones: on most, the number keyboard has no "%".
            TextEdit::singleline(&mut text)
                .id(id)
                .prefix(RichText::new("±").color(palette.muted))
                .hint_text(RichText::new("none").color(palette.muted))
                .align(egui::Align2::RIGHT_CENTER)
                .margin(egui::Margin::symmetric(8, 4))
                .desired_width(size.x)
                .min_size(size)
                .return_key(None)
                .show(ui)
        })
        .inner
        .response
        .response
        .accessible_name(format!("Uncertainty of {}", field.name()));
    ui.accesskit_node_builder(id, |node| {
        node.set_description("One standard deviation, in the unit of the value, with a unit of its own, or in percent. Empty: none.");
    });
    if response.changed() {
        inputs.set_sigma(field, text);
    }
    if response.lost_focus() {
        commands.push(Command::Settle);
    }
}

/// A choice among the matching errors that people state.
fn typical_errors(ui: &mut Ui, inputs: &mut Inputs, field: Field, height: f32, commands: &mut Vec<Command>) {
    ui.spacing_mut().interact_size.y = height;
    ComboBox::from_id_salt("typical matching errors")
        .width(ui.available_width())
        .selected_text("Typical matching errors…")
        .show_ui(ui, |ui| {
            for error in MATCHING_ERRORS {
                let sigma = plain(error.sigma.px());
                if ui
                    .selectable_label(inputs.sigma(field) == sigma, format!("± {sigma} px: {}", error.source))
                    .clicked()
                {
                    inputs.set_sigma(field, sigma);
                    commands.push(Command::Settle);
                    ui.close();
                }
            }
        })
        .response
        .accessible_name("Typical matching errors");
}

/// Gives the next field in `ui` the border of what is wrong with it.
fn mark(ui: &mut Ui, note: Option<&Note>) {
    if let Some(note) = note {
        let palette = theme::palette(ui);
        let color = match note.severity {
            Severity::Error => palette.red,
            Severity::Warning => palette.amber,
        };
        let widgets = &mut ui.visuals_mut().widgets;
        widgets.inactive.bg_stroke = Stroke::new(1.5, color);
        widgets.hovered.bg_stroke = Stroke::new(1.5, color);
    }
}

fn unit_choice(ui: &mut Ui, inputs: &mut Inputs, field: Field, size: egui::Vec2, commands: &mut Vec<Command>) {
    let palette = theme::palette(ui);
    let Some(mut unit) = inputs.unit(field) else {
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        let stroke = Stroke::new(1.0, palette.line);
        ui.painter()
            .rect_stroke(rect, theme::CONTROL_RADIUS, stroke, egui::StrokeKind::Inside);
        let at = rect.left_center() + vec2(11.0, 0.0);
        let font = theme::regular(theme::BODY_SIZE);
        ui.painter().text(at, egui::Align2::LEFT_CENTER, "px", font, palette.muted);
        return;
    };
    let before = unit;
    length_unit_choice(ui, (field, "unit"), &format!("Unit of {}", field.name()), &mut unit, size.x);
    if unit != before {
        inputs.choose_unit(field, unit);
        commands.push(Command::Settle);
    }
}

/// A choice among the units of length, named `name`.
pub fn length_unit_choice(ui: &mut Ui, id: impl std::hash::Hash + std::fmt::Debug, name: &str, unit: &mut LengthUnit, width: f32) {
    ComboBox::from_id_salt(id)
        .width(width)
        .selected_text(unit.symbol())
        .show_ui(ui, |ui| {
            for choice in LengthUnit::ALL {
                let name = format!("{}  ({})", choice.symbol(), choice.name());
                // Closing is said, as egui closes by itself only for a pointer.
                if ui.selectable_value(unit, choice, name).clicked() {
                    ui.close();
                }
            }
        })
        .response
        .accessible_name(name);
}

fn note_below(ui: &mut Ui, note: &Note, about: Id, height: f32, commands: &mut Vec<Command>) {
    super::text::note(ui, note.severity, &note.message, Some(about));
    if !note.fixes.is_empty() {
        ui.horizontal_wrapped(|ui| {
            for fix in &note.fixes {
                if ui.add(Button::new(&fix.label).min_size(vec2(0.0, height))).clicked() {
                    commands.push(Command::Fix(note.field, fix.entry.clone()));
                }
            }
        });
    }
}
