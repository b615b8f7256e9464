//! The field of the program: label, text, unit, σ, hint, and what is wrong with it. One widget for every field of the table.

use super::note_line::{self, NoteLine};
use super::text;
use super::unit_choice::{TypedUnit, typed_unit_choice_ui};
use crate::app::command::{Command, Helper, Scope};
use crate::app::sentences::Hint;
use crate::app::theme::{self, FIELD_PARTS_GAP, SIGMA_WIDTH, UNIT_WIDTH};
use depth_text::entry::Entry;
use depth_text::field::Key as FieldKey;
use depth_text::note::{Note, Part};
use depth_text::reading::Reading;
use depth_text::report;
use depth_text::unit::Unit;
use egui::accesskit::Role;
use egui::text::{CCursor, CCursorRange};
use egui::{Align, Button, Id, Key, Modifiers, Rect, Response, RichText, Sense, Stroke, TextEdit, Ui, UiBuilder, vec2};

/// A field of the table, with what was typed into it and what is to be said about that.
pub struct Field<'a> {
    /// Which field.
    pub key: FieldKey,
    /// What is typed. Edits go straight into it.
    pub entry: &'a mut Entry,
    /// What it means, where it could be read.
    pub reading: Option<&'a Reading>,
    /// What is to be said about its value and its σ: at most one note each.
    pub notes: Vec<&'a Note>,
    /// Whether its σ is asked for.
    pub with_sigma: bool,
    /// The helper that knows where such numbers come from.
    pub helper: Option<Helper>,
    /// The id of its text: [`id`], but where the same field is on the screen twice.
    pub id: Id,
    /// Whether Enter calculates, as in the form.
    pub submits: bool,
}

/// The id of the text of the field `key`, for moving the focus to it.
pub fn id(key: impl Into<FieldKey>) -> Id {
    Id::unique(("field", key.into().as_str()))
}

/// The label of a field alone, with the link to its helper at the other end of the line. For the link to one that
/// [comes last](Helper::comes_last) it leaves room.
pub fn label_ui(ui: &mut Ui, key: FieldKey, helper: Option<Helper>, commands: &mut Vec<Command>) -> Response {
    let palette = theme::palette(ui);
    let height = ui.spacing().interact_size.y;
    let line_height = if height >= theme::CONTROL_HEIGHT_TOUCH && helper.is_some() {
        height
    } else {
        theme::LABEL_HEIGHT
    };
    let line = vec2(ui.available_width(), line_height);
    ui.allocate_ui_with_layout(line, egui::Layout::left_to_right(Align::Center), |ui| {
        ui.spacing_mut().interact_size.y = line_height;
        let label = ui.label(RichText::new(key.name).font(theme::strong(theme::BODY_SIZE)).color(palette.text));
        if let Some(helper) = helper.filter(|helper| !helper.comes_last()) {
            let line = ui.available_rect_before_wrap();
            helper_ui(ui, line, helper, commands);
        }
        label
    })
    .inner
}

/// The link to a helper, at the end of `line`.
pub fn helper_ui(ui: &mut Ui, line: Rect, helper: Helper, commands: &mut Vec<Command>) {
    let layout = egui::Layout::right_to_left(Align::Center);
    let place = UiBuilder::new().id_salt("helper").max_rect(line).layout(layout);
    let mut ui = ui.new_child(place);
    ui.spacing_mut().interact_size.y = line.height();
    let open = Command::Help(Some(helper));
    let color = theme::palette(&ui).blue;
    let link = Button::new(RichText::new(open.text()).size(theme::SMALL_SIZE).color(color)).frame(false);
    if ui.add(link.min_size(vec2(0.0, line.height()))).clicked() {
        commands.push(open);
    }
}

impl Field<'_> {
    /// Draws the field, as high as the controls of `ui`. Returns the line of its label.
    pub fn ui(mut self, ui: &mut Ui, commands: &mut Vec<Command>) -> Rect {
        note_line::follow_click(ui, self.id);
        // Nor is there room kept for a σ that the field does not have.
        self.with_sigma &= self.key.has_sigma;
        // Also in the frame in which Tab leads out of it: only what is drawn then can get the focus.
        let was_in_use = self.has_focus(ui);
        ui.vertical(|ui| {
            ui.spacing_mut().item_spacing.y = 0.0;
            let label_line = ui.available_rect_before_wrap();
            let label = label_ui(ui, self.key, self.helper, commands);
            let label_line = label_line.with_max_y(ui.min_rect().bottom());
            ui.add_space(theme::STEP);
            let texts = ui.horizontal(|ui| {
                ui.spacing_mut().item_spacing.x = FIELD_PARTS_GAP;
                self.text_ui(ui, &label, commands);
                let unit = self.unit_ui(ui, commands);
                if self.with_sigma {
                    self.sigma_ui(ui, commands);
                }
                unit.is_some_and(|unit| unit.has_focus() || unit.lost_focus())
            });
            let read_as = self.reading.and_then(report::read_as);
            NoteLine {
                id: self.id,
                hint: read_as.as_deref().unwrap_or(self.key.hint),
                notes: self.notes(),
                field: texts.response.rect.with_min_y(label.rect.top()),
                is_in_use: was_in_use || texts.inner || self.has_focus(ui),
            }
            .ui(ui, commands);
            label_line
        })
        .inner
    }

    /// Whether one of its texts has the focus.
    fn has_focus(&self, ui: &Ui) -> bool {
        ui.memory(|memory| memory.has_focus(self.id) || memory.has_focus(self.sigma_id()))
    }

    /// What is to be said, the value first, each with the id of the text that it is about.
    fn notes(&self) -> Vec<(&Note, Id)> {
        let of = |part, id| self.note(part).map(|note| (note, id));
        let sigma = of(Part::Sigma, self.sigma_id());
        of(Part::Value, self.id).into_iter().chain(sigma).collect()
    }

    fn sigma_id(&self) -> Id {
        self.id.with("uncertainty")
    }

    fn note(&self, part: Part) -> Option<&Note> {
        self.notes.iter().copied().find(|note| note.part == part)
    }

    fn text_ui(&mut self, ui: &mut Ui, label: &Response, commands: &mut Vec<Command>) {
        if ui.memory(|memory| memory.has_focus(self.id)) {
            self.take_keys(ui, commands);
        }
        let sigma_width = if self.with_sigma { SIGMA_WIDTH + FIELD_PARTS_GAP } else { 0.0 };
        let width = ui.available_width() - UNIT_WIDTH - FIELD_PARTS_GAP - sigma_width;
        let size = vec2(width, ui.spacing().interact_size.y);
        let color = self.note(Part::Value).map(|note| text::note_color(ui, note.severity));
        let output = ui
            .scope(|ui| {
                border_ui(ui, color);
                let palette = theme::palette(ui);
                TextEdit::singleline(&mut self.entry.text)
                    .id(self.id)
                    .hint_text(RichText::new(Hint::Example { key: self.key }.to_string()).color(palette.muted))
                    .align(egui::Align2::RIGHT_CENTER)
                    .margin(theme::FIELD_MARGIN)
                    .desired_width(size.x)
                    .min_size(size)
                    .return_key(None)
                    .show(ui)
            })
            .inner;
        let response = output.response.response.labelled_by(label.id);
        ui.accesskit_node_builder(self.id, |node| {
            // egui has only text fields, and a unit may be typed. The role tells assistive technology that it is a number, and opens the
            // number keyboard of a phone; some of these have no minus.
            if !self.key.signed {
                node.set_role(Role::NumberInput);
            }
            node.set_description(Hint::Field { key: self.key }.to_string());
            if let Some(reading) = self.reading {
                node.set_numeric_value(reading.number);
            }
        });
        // As in a browser's form: Tab selects the text, so that typing replaces it.
        if response.gained_focus() && ui.input(|input| input.key_pressed(Key::Tab)) {
            let mut state = output.state;
            let all = CCursorRange::two(CCursor::default(), CCursor::new(self.entry.text.chars().count()));
            state.cursor.set_char_range(Some(all));
            state.store(ui.ctx(), self.id);
        }
        if response.lost_focus() {
            self.entry.tidy(self.key);
            commands.push(Command::Settle);
        }
    }

    /// The keys that a field takes while it has the focus: arrows step it, Enter calculates.
    fn take_keys(&mut self, ui: &Ui, commands: &mut Vec<Command>) {
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
            self.entry.step(self.key, steps);
        }
        if self.submits && ui.input_mut(|input| Command::Calculate.take_keys(input, &[Scope::Field])) {
            self.entry.tidy(self.key);
            commands.push(Command::Calculate);
        }
    }

    /// Returns the choice of the unit, where there is one.
    fn unit_ui(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) -> Option<Response> {
        let Some(mut unit) = self.typed_unit() else {
            self.fixed_unit_ui(ui);
            return None;
        };
        let before = unit;
        let name = format!("Unit of {}", self.key.name);
        let choice = typed_unit_choice_ui(ui, (self.id, "unit"), &name, &mut unit, UNIT_WIDTH);
        if unit != before {
            match unit {
                TypedUnit::Length(unit) => self.entry.choose_unit(self.key, unit),
                TypedUnit::Squares => {
                    self.entry.choose_squares(self.key);
                    // Their size is still to be typed.
                    ui.memory_mut(|memory| memory.request_focus(self.id));
                }
            }
            commands.push(Command::Settle);
        }
        Some(choice)
    }

    /// The unit that holds; `None` where there is no choice.
    fn typed_unit(&self) -> Option<TypedUnit> {
        let default = self.key.kind.length_unit()?;
        let read = self.reading.and_then(|reading| reading.unit);
        let is_in_squares = matches!(read, Some(Unit::Square(_))) || self.notes.iter().any(|note| note.issue.is_size_of_squares());
        if is_in_squares {
            return Some(TypedUnit::Squares);
        }
        let length = read.and_then(Unit::length).or(self.entry.unit);
        Some(TypedUnit::Length(length.unwrap_or(default)))
    }

    /// The unit of a field without a choice, where it has one.
    fn fixed_unit_ui(&self, ui: &mut Ui) {
        let palette = theme::palette(ui);
        let size = vec2(UNIT_WIDTH, ui.spacing().interact_size.y);
        let (rect, _) = ui.allocate_exact_size(size, Sense::hover());
        let symbol = self.key.unit_symbol();
        // Another unit stands behind the number.
        let is_another = self.reading.is_some_and(|reading| reading.unit != self.key.kind.default_unit());
        if symbol.is_empty() || is_another {
            return;
        }
        let stroke = Stroke::new(theme::THIN_LINE, palette.line);
        ui.painter()
            .rect_stroke(rect, theme::CONTROL_RADIUS, stroke, egui::StrokeKind::Inside);
        let at = rect.left_center() + vec2(theme::UNIT_INDENT, 0.0);
        let font = theme::regular(theme::BODY_SIZE);
        ui.painter().text(at, egui::Align2::LEFT_CENTER, symbol, font, palette.muted);
    }

    fn sigma_ui(&mut self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let palette = theme::palette(ui);
        let size = vec2(SIGMA_WIDTH, ui.spacing().interact_size.y);
        let id = self.sigma_id();
        let takes_enter = self.submits && ui.memory(|memory| memory.has_focus(id));
        if takes_enter && ui.input_mut(|input| Command::Calculate.take_keys(input, &[Scope::Field])) {
            commands.push(Command::Calculate);
        }
        let color = self.note(Part::Sigma).map(|note| text::note_color(ui, note.severity));
        let response = ui
            .scope(|ui| {
                border_ui(ui, color);
                // Not `Role::NumberInput`: the number keyboard of most phones has no "%".
                TextEdit::singleline(&mut self.entry.sigma)
                    .id(id)
                    .prefix(RichText::new("±").color(palette.muted))
                    .hint_text(RichText::new("none").color(palette.muted))
                    .align(egui::Align2::RIGHT_CENTER)
                    .margin(theme::SIGMA_MARGIN)
                    .desired_width(size.x)
                    .min_size(size)
                    .return_key(None)
                    .show(ui)
            })
            .inner
            .response
            .response
            .accessible_name(format!("Uncertainty of {}", self.key.name));
        ui.accesskit_node_builder(id, |node| {
            node.set_description(Hint::Sigma.to_string());
        });
        if response.lost_focus() {
            commands.push(Command::Settle);
        }
    }
}

/// Gives the next field in `ui` the border of what is wrong with it.
fn border_ui(ui: &mut Ui, color: Option<egui::Color32>) {
    if let Some(color) = color {
        let widgets = &mut ui.visuals_mut().widgets;
        widgets.inactive.bg_stroke = Stroke::new(theme::STRONG_LINE, color);
        widgets.hovered.bg_stroke = Stroke::new(theme::STRONG_LINE, color);
    }
}
