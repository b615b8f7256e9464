//! A field for one quantity: name, text, unit, hint, and what is wrong with it.

use crate::app::command::{Command, Helper, Scope};
use crate::app::theme::{self, SIGMA_WIDTH, UNIT_WIDTH};
use crate::core::disparity::MATCHING_ERRORS;
use crate::core::problem::Field;
use crate::core::quantity::LengthUnit;
use crate::formats::field::Key as FieldKey;
use crate::formats::inputs::{Inputs, Note, Severity, Unknown};
use crate::formats::number::plain;
use crate::formats::report;
use egui::accesskit::Role;
use egui::text::{CCursor, CCursorRange};
use egui::{Align, Button, ComboBox, Id, Key, Modifiers, Response, RichText, Sense, Stroke, TextEdit, Ui, vec2};

/// A field for `field`, with what was typed into it and what is to be said about that.
pub struct QuantityField<'a> {
    /// The quantity.
    pub field: Field,
    /// What is typed. Edits go straight into it.
    pub inputs: &'a mut Inputs,
    /// What is shown with the field.
    pub annotations: Annotations<'a>,
    /// What else the person asks for.
    pub commands: &'a mut Vec<Command>,
}

/// What a field shows beside what was typed into it.
#[derive(Clone, Copy, Debug, Default)]
pub struct Annotations<'a> {
    /// What is to be said about its value.
    pub value_note: Option<&'a Note>,
    /// What is to be said about its σ.
    pub sigma_note: Option<&'a Note>,
    /// The helper that knows where such numbers come from.
    pub helper: Option<Helper>,
    /// Set where the field is what is solved for: it shows the solution and takes no text.
    pub computed: Option<&'a Unknown>,
}

/// The id of the text field of `field`, for moving the focus to it.
pub fn id(key: impl Into<FieldKey>) -> Id {
    Id::unique(("quantity field", key.into().as_str()))
}

/// The id of the field for the σ of `field`.
pub fn sigma_id(key: impl Into<FieldKey>) -> Id {
    Id::unique(("uncertainty field", key.into().as_str()))
}

impl QuantityField<'_> {
    /// Draws the field, as high as the controls of `ui`.
    pub fn ui(mut self, ui: &mut Ui) {
        let name = self.name_ui(ui);
        if let Some(unknown) = self.annotations.computed {
            computed_ui(ui, self.inputs, unknown);
            return;
        }
        let text_response = ui
            .horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = 6.0;
                let response = self.text_ui(ui, &name);
                self.unit_ui(ui);
                if self.inputs.with_uncertainty {
                    self.sigma_ui(ui);
                }
                response
            })
            .inner;
        super::text::caption(ui, FieldKey::from(self.field).hint);
        if self.inputs.with_uncertainty && self.field == Field::Disparity {
            self.typical_errors_ui(ui);
        }
        for (note, id) in [
            (self.annotations.value_note, text_response.id),
            (self.annotations.sigma_note, sigma_id(self.field)),
        ] {
            if let Some(note) = note {
                note_ui(ui, note, id, self.commands);
            }
        }
    }

    /// The name, and at the other end of its line the link to a helper.
    fn name_ui(&mut self, ui: &mut Ui) -> Response {
        let palette = theme::palette(ui);
        let height = ui.spacing().interact_size.y;
        let line_height = if height >= theme::CONTROL_HEIGHT_TOUCH && self.annotations.helper.is_some() {
            height
        } else {
            20.0
        };
        let line = vec2(ui.available_width(), line_height);
        ui.allocate_ui_with_layout(line, egui::Layout::left_to_right(Align::Center), |ui| {
            ui.spacing_mut().interact_size.y = line_height;
            let name = ui.label(
                RichText::new(self.field.name())
                    .font(theme::strong(theme::BODY_SIZE))
                    .color(palette.text),
            );
            if let Some(helper) = self.annotations.helper {
                let open = Command::Help(Some(helper));
                ui.with_layout(egui::Layout::right_to_left(Align::Center), |ui| {
                    let link = Button::new(RichText::new(open.text()).size(theme::SMALL_SIZE).color(palette.blue)).frame(false);
                    if ui.add(link.min_size(vec2(0.0, line_height))).clicked() {
                        self.commands.push(open);
                    }
                });
            }
            name
        })
        .inner
    }

    fn text_ui(&mut self, ui: &mut Ui, name: &Response) -> Response {
        let id = id(self.field);
        if ui.memory(|memory| memory.has_focus(id)) {
            self.take_keys(ui);
        }
        let sigma_width = if self.inputs.with_uncertainty { SIGMA_WIDTH + 6.0 } else { 0.0 };
        let width = ui.available_width() - UNIT_WIDTH - 6.0 - sigma_width;
        let size = vec2(width, ui.spacing().interact_size.y);
        let output = ui
            .scope(|ui| {
                mark(ui, self.annotations.value_note);
                let palette = theme::palette(ui);
                TextEdit::singleline(&mut self.inputs.entry_mut(self.field).text)
                    .id(id)
                    .hint_text(RichText::new(format!("e.g. {}", FieldKey::from(self.field).example())).color(palette.muted))
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
            // A text field to egui, as a unit may be typed; a number to assistive technology and to the keyboards of phones.
            node.set_role(Role::NumberInput);
            let unit = if self.inputs.unit(self.field).is_none() {
                " In pixels."
            } else {
                ""
            };
            node.set_description(format!(
                "{}{unit} Arrow up and down step the value.",
                FieldKey::from(self.field).hint
            ));
            if let Some(value) = self.inputs.number(self.field) {
                node.set_numeric_value(value);
            }
        });
        // As in a browser's form: Tab selects the text, so that typing replaces it.
        if response.gained_focus() && ui.input(|input| input.key_pressed(Key::Tab)) {
            let mut state = output.state;
            let characters = self.inputs.entry(self.field).text.chars().count();
            let all = CCursorRange::two(CCursor::default(), CCursor::new(characters));
            state.cursor.set_char_range(Some(all));
            state.store(ui.ctx(), id);
        }
        if response.lost_focus() {
            self.inputs.tidy(self.field);
            self.commands.push(Command::Settle);
        }
        response
    }

    /// The keys that a field takes while it has the focus: arrows step it, Enter calculates.
    fn take_keys(&mut self, ui: &Ui) {
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
            self.inputs.step(self.field, steps);
        }
        if ui.input_mut(|input| Command::Calculate.take_keys(input, &[Scope::Field])) {
            self.inputs.tidy(self.field);
            self.commands.push(Command::Calculate);
        }
    }

    fn unit_ui(&mut self, ui: &mut Ui) {
        let palette = theme::palette(ui);
        let Some(mut unit) = self.inputs.unit(self.field) else {
            let size = vec2(UNIT_WIDTH, ui.spacing().interact_size.y);
            let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
            let stroke = Stroke::new(theme::THIN_LINE, palette.line);
            ui.painter()
                .rect_stroke(rect, theme::CONTROL_RADIUS, stroke, egui::StrokeKind::Inside);
            let at = rect.left_center() + vec2(11.0, 0.0);
            let font = theme::regular(theme::BODY_SIZE);
            ui.painter().text(at, egui::Align2::LEFT_CENTER, "px", font, palette.muted);
            return;
        };
        let before = unit;
        let name = format!("Unit of {}", self.field.name());
        length_unit_choice(ui, (self.field, "unit"), &name, &mut unit, UNIT_WIDTH);
        if unit != before {
            self.inputs.choose_unit(self.field, unit);
            self.commands.push(Command::Settle);
        }
    }

    fn sigma_ui(&mut self, ui: &mut Ui) {
        let palette = theme::palette(ui);
        let size = vec2(SIGMA_WIDTH, ui.spacing().interact_size.y);
        let id = sigma_id(self.field);
        if ui.memory(|memory| memory.has_focus(id)) && ui.input_mut(|input| Command::Calculate.take_keys(input, &[Scope::Field])) {
            self.commands.push(Command::Calculate);
        }
        let mut text = self.inputs.sigma(self.field).to_owned();
        let response = ui
            .scope(|ui| {
                mark(ui, self.annotations.sigma_note);
                // Not `Role::NumberInput`: the number keyboard of most phones has no "%".
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
            .accessible_name(format!("Uncertainty of {}", self.field.name()));
        ui.accesskit_node_builder(id, |node| {
            node.set_description("One standard deviation, in the unit of the value, with a unit of its own, or in percent. Empty: none.");
        });
        if response.changed() {
            self.inputs.set_sigma(self.field, text);
        }
        if response.lost_focus() {
            self.commands.push(Command::Settle);
        }
    }

    /// A choice among the matching errors that people state.
    fn typical_errors_ui(&mut self, ui: &mut Ui) {
        ComboBox::from_id_salt("typical matching errors")
            .width(ui.available_width())
            .selected_text("Typical matching errors…")
            .show_ui(ui, |ui| {
                for error in MATCHING_ERRORS {
                    let sigma = plain(error.sigma.px());
                    if ui
                        .selectable_label(self.inputs.sigma(self.field) == sigma, format!("± {sigma} px: {}", error.source))
                        .clicked()
                    {
                        self.inputs.set_sigma(self.field, sigma);
                        self.commands.push(Command::Settle);
                        ui.close();
                    }
                }
            })
            .response
            .accessible_name("Typical matching errors");
    }
}

/// The solution in place of the field.
fn computed_ui(ui: &mut Ui, inputs: &Inputs, unknown: &Unknown) {
    let height = ui.spacing().interact_size.y;
    let palette = theme::palette(ui);
    let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), height), Sense::hover());
    ui.painter().rect_filled(rect, theme::CONTROL_RADIUS, palette.highlight);
    let words = report::unknown(unknown, inputs.unit(unknown.field));
    // Not a live region: the result card says the same.
    ui.put(
        rect.shrink2(vec2(10.0, 0.0)),
        egui::Label::new(RichText::new(words).font(theme::strong(theme::BODY_SIZE))),
    );
    super::text::caption(ui, "Computed from the distance and the other quantities.");
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
        widgets.inactive.bg_stroke = Stroke::new(theme::STRONG_LINE, color);
        widgets.hovered.bg_stroke = Stroke::new(theme::STRONG_LINE, color);
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
                // Closed explicitly: egui does so only for a click of the pointer.
                if ui.selectable_value(unit, choice, name).clicked() {
                    ui.close();
                }
            }
        })
        .response
        .accessible_name(name);
}

fn note_ui(ui: &mut Ui, note: &Note, about: Id, commands: &mut Vec<Command>) {
    super::text::note(ui, note.severity, &note.message(), Some(about));
    if !note.fixes.is_empty() {
        ui.horizontal_wrapped(|ui| {
            let height = ui.spacing().interact_size.y;
            for fix in &note.fixes {
                if ui.add(Button::new(fix.label()).min_size(vec2(0.0, height))).clicked() {
                    commands.push(Command::Fix(note.key, fix.entry.clone()));
                }
            }
        });
    }
}
