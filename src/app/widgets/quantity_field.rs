//! A field for one quantity: name, text, unit, hint, and what is wrong with it.

use crate::app::command::Command;
use crate::app::theme;
use crate::core::problem::Field;
use crate::core::quantity::LengthUnit;
use crate::formats::inputs::{Inputs, Note, Severity, example_text, hint};
use egui::accesskit::{Invalid, Role};
use egui::text::{CCursor, CCursorRange};
use egui::{Align, Button, ComboBox, Id, Key, Modifiers, Rect, Response, RichText, Sense, Stroke, TextEdit, Ui, vec2};

const UNIT_WIDTH: f32 = 76.0;

/// The id of the text field of `field`, for moving the focus to it.
pub fn id(field: Field) -> Id {
    Id::unique(("quantity field", field))
}

/// Draws the field. Edits go straight into `inputs`; what else the person wants is added to `commands`.
pub fn show(ui: &mut Ui, inputs: &mut Inputs, field: Field, note: Option<&Note>, height: f32, commands: &mut Vec<Command>) {
    let palette = theme::palette(ui);
    let name = ui.label(
        RichText::new(field.name())
            .font(theme::strong(theme::BODY_SIZE))
            .color(palette.text),
    );
    let text_response = ui
        .horizontal(|ui| {
            ui.spacing_mut().item_spacing.x = 6.0;
            ui.spacing_mut().interact_size.y = height;
            let width = ui.available_width() - UNIT_WIDTH - 6.0;
            let response = text_field(ui, inputs, field, note, vec2(width, height), &name, commands);
            unit_choice(ui, inputs, field, vec2(UNIT_WIDTH, height), commands);
            response
        })
        .inner;
    super::text::caption(ui, hint(field));
    if let Some(note) = note {
        let said = note_below(ui, note, height, commands);
        ui.accesskit_node_builder(text_response.id, |node| {
            node.set_described_by(vec![said.id.accesskit_id()]);
            if note.severity == Severity::Error {
                node.set_invalid(Invalid::True);
            }
        });
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
        node.set_description(format!("{} Arrow up and down step the value.", hint(field)));
        if let Some(value) = inputs.number(field) {
            node.set_numeric_value(value);
        }
    });
    if response.gained_focus() {
        response.scroll_to_me(None);
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

fn unit_choice(ui: &mut Ui, inputs: &mut Inputs, field: Field, size: egui::Vec2, commands: &mut Vec<Command>) {
    let palette = theme::palette(ui);
    let Some(mut unit) = inputs.unit(field) else {
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        let inside = Rect::from_min_max(rect.min + vec2(11.0, 0.0), rect.max);
        ui.painter().rect_stroke(
            rect,
            theme::CONTROL_RADIUS,
            Stroke::new(1.0, palette.line),
            egui::StrokeKind::Inside,
        );
        ui.put(inside, |ui: &mut Ui| {
            ui.with_layout(egui::Layout::left_to_right(Align::Center), |ui| {
                ui.label(RichText::new("px").color(palette.muted))
            })
            .response
        });
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
                ui.selectable_value(unit, choice, format!("{}  ({})", choice.symbol(), choice.name()));
            }
        })
        .response
        .accessible_name(name);
}

fn note_below(ui: &mut Ui, note: &Note, height: f32, commands: &mut Vec<Command>) -> Response {
    let palette = theme::palette(ui);
    let color = match note.severity {
        Severity::Error => palette.red,
        Severity::Warning => palette.amber,
    };
    let said = ui.label(RichText::new(format!("⚠ {}", note.message)).size(theme::SMALL_SIZE).color(color));
    super::text::announce(ui, &said);
    if !note.fixes.is_empty() {
        ui.horizontal_wrapped(|ui| {
            for fix in &note.fixes {
                if ui.add(Button::new(&fix.label).min_size(vec2(0.0, height))).clicked() {
                    commands.push(Command::Fix(note.field, fix.entry.clone()));
                }
            }
        });
    }
    said
}
