//! The field of the program: one joined control of value, unit and σ, with its label above, and a line below that reads it back or says
//! what is wrong with it. One widget for every field of the table.

use super::joined::{self, Cells};
use super::note_line::{self, NoteLine};
use super::symbols;
use super::text;
use super::text_menu;
use super::unit_choice::{TypedUnit, typed_unit_choice_ui};
use crate::app::command::{Command, Helper, Scope};
use crate::app::sentences::Hint;
use crate::app::theme;
use crate::core::quantity::LengthUnit;
use depth_text::entry::Entry;
use depth_text::field::Key as FieldKey;
use depth_text::note::{Note, Part};
use depth_text::number::is_half_typed;
use depth_text::reading::Reading;
use depth_text::report;
use depth_text::unit::Unit;
use egui::accesskit::Role;
use egui::text::{CCursor, CCursorRange};
use egui::text_edit::TextEditOutput;
use egui::{Align, Id, Key, Modifiers, Rect, Response, Sense, Ui, UiBuilder, vec2};

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
    /// What it would be, which is shown while it is empty; `None` where that is an example.
    pub following: Option<&'a str>,
}

/// The id of the text of the field `key`, for moving the focus to it.
pub fn id(key: impl Into<FieldKey>) -> Id {
    Id::unique(("field", key.into().as_str()))
}

/// The label of a field alone, with the link to its helper at the other end of the line. For the link to one that
/// [comes last](Helper::comes_last) it leaves room.
pub fn label_ui(ui: &mut Ui, line: Rect, key: FieldKey, helper: Option<Helper>, commands: &mut Vec<Command>) -> Response {
    let place = UiBuilder::new()
        .id_salt("label")
        .max_rect(line)
        .layout(egui::Layout::left_to_right(Align::Center));
    let mut ui = ui.new_child(place);
    ui.spacing_mut().item_spacing.x = theme::STEP;
    let label = symbols::label_ui(&mut ui, key);
    if let Some(helper) = helper.filter(|helper| !helper.comes_last()) {
        let left = line.with_min_x(label.rect.right() + theme::STEP);
        helper_ui(&mut ui, left, helper, commands);
    }
    label
}

/// The link to a helper, at the end of `line`.
pub fn helper_ui(ui: &mut Ui, line: Rect, helper: Helper, commands: &mut Vec<Command>) {
    let layout = egui::Layout::right_to_left(Align::Center);
    let place = UiBuilder::new().id_salt("helper").max_rect(line).layout(layout);
    let mut ui = ui.new_child(place);
    let open = Command::Help(Some(helper));
    if text::quiet_link_ui(&mut ui, open.text(), line.height()).clicked() {
        commands.push(open);
    }
}

/// The height of a joined control.
pub fn height(ui: &Ui) -> f32 {
    if ui.spacing().interact_size.y >= theme::CONTROL_HEIGHT_TOUCH {
        theme::CONTROL_HEIGHT_TOUCH
    } else {
        theme::FIELD_HEIGHT
    }
}

/// The lines of a field: its label, its control, and what stands below.
#[derive(Clone, Copy, Debug)]
pub struct Lines {
    /// The line of the label.
    pub label: Rect,
    /// The joined control.
    pub control: Rect,
    /// The line below.
    pub note: Rect,
}

impl Lines {
    /// Takes the room of a field over the width of `ui`. It is the same whatever is to be said.
    pub fn allocate(ui: &mut Ui) -> Self {
        let height = height(ui);
        // What can be pressed in the line of the label or in the line below is for a finger there.
        let (above, below) = if height >= theme::CONTROL_HEIGHT_TOUCH {
            (theme::LINE_HEIGHT_TOUCH, theme::LINE_HEIGHT_TOUCH)
        } else {
            (theme::LABEL_HEIGHT, theme::NOTE_LINE_HEIGHT)
        };
        let whole = above + theme::LABEL_GAP + height + below;
        let (rect, _) = ui.allocate_exact_size(vec2(ui.available_width(), whole), Sense::hover());
        let (label, rest) = rect.split_top_bottom_at_y(rect.top() + above);
        let (control, note) = rest.split_top_bottom_at_y(rest.top() + theme::LABEL_GAP + height);
        Self {
            label,
            control: control.with_min_y(control.top() + theme::LABEL_GAP),
            note,
        }
    }
}

impl Field<'_> {
    /// Draws the field. Returns the line of its label.
    pub fn ui(mut self, ui: &mut Ui, commands: &mut Vec<Command>) -> Rect {
        note_line::follow_click(ui, self.id);
        self.with_sigma &= self.key.has_sigma;
        self.leave_in_peace(ui);
        // Also in the frame in which Tab leads out of it: only what is drawn then can get the focus.
        let was_in_use = self.has_focus(ui);
        let lines = Lines::allocate(ui);
        let label = label_ui(ui, lines.label, self.key, self.helper, commands);
        let cells = Cells::of(lines.control, self.has_unit(), self.with_sigma);
        joined::ground_ui(ui, &cells, self.is_lit(ui));
        self.text_ui(ui, &cells, &label, commands);
        let unit = self.unit_ui(ui, &cells, commands);
        if let Some(sigma) = cells.sigma {
            self.sigma_ui(ui, sigma, commands);
        }
        let is_in_unit = unit.as_ref().is_some_and(Response::has_focus);
        let color = self.notes.first().map(|note| text::note_color(ui, note.severity));
        joined::border_ui(ui, &cells, color, self.has_focus(ui) || is_in_unit);
        let is_narrow = lines.note.width() < theme::NARROW_FIELD_WIDTH;
        let hint = if is_narrow {
            report::field_line_in_pair(self.key, self.reading)
        } else {
            report::field_line(self.key, self.reading)
        };
        NoteLine {
            id: self.id,
            hint: &hint,
            notes: self.notes(),
            line: lines.note,
            field: lines.control.with_min_y(lines.label.top()),
            is_in_use: was_in_use || unit.is_some_and(|unit| unit.has_focus() || unit.lost_focus()) || self.has_focus(ui),
        }
        .ui(ui, commands);
        lines.label
    }

    /// Says nothing of a number that is still being typed.
    fn leave_in_peace(&mut self, ui: &Ui) {
        let is_typed = |id, text: &str| ui.memory(|memory| memory.has_focus(id)) && is_half_typed(text);
        let (value, sigma) = (is_typed(self.id, &self.entry.text), is_typed(self.sigma_id(), &self.entry.sigma));
        self.notes.retain(|note| match note.part {
            Part::Value => !value,
            Part::Sigma => !sigma,
        });
    }

    /// Whether one of its texts has the focus.
    fn has_focus(&self, ui: &Ui) -> bool {
        ui.memory(|memory| memory.has_focus(self.id) || memory.has_focus(self.sigma_id()))
    }

    /// Whether its number is pointed at in a formula.
    fn is_lit(&self, ui: &Ui) -> bool {
        symbols::lit(ui.ctx()) == Some(self.key)
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

    fn text_ui(&mut self, ui: &mut Ui, cells: &Cells, label: &Response, commands: &mut Vec<Command>) {
        if ui.memory(|memory| memory.has_focus(self.id)) {
            self.take_keys(ui, commands);
        }
        // What is missing looks empty.
        let is_missing = self.note(Part::Value).is_some_and(|note| note.issue.is_missing());
        let example = match self.following {
            _ if is_missing => String::new(),
            Some(following) => self.key.in_unit(following, self.length_unit()),
            None => self.key.in_unit(self.key.example(), self.length_unit()),
        };
        let output = joined::text_ui(ui, cells.value, &mut self.entry.text, (self.id, &example));
        let response = output.response.response.clone().labelled_by(label.id);
        ui.accesskit_node_builder(self.id, |node| {
            // egui has only text fields, and a unit may be typed. The role tells assistive technology that it is a number, and opens the
            // number keyboard of a phone; some of these have no minus.
            if !self.key.signed {
                node.set_role(Role::NumberInput);
            }
            node.set_description(
                Hint::Field {
                    key: self.key,
                    unit: self.length_unit(),
                }
                .to_string(),
            );
            if let Some(reading) = self.reading {
                node.set_numeric_value(reading.number);
            }
        });
        // As in a browser's form: Tab selects the text, so that typing replaces it. A field holds one number: two clicks take all of it.
        let is_tabbed = response.gained_focus() && ui.input(|input| input.key_pressed(Key::Tab));
        if is_tabbed || response.double_clicked() {
            select_all(ui, self.id, output, &self.entry.text);
        }
        text_menu::ui(&response, &mut self.entry.text, commands);
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

    fn has_unit(&self) -> bool {
        self.key.kind.length_unit().is_some() || !self.key.unit_symbol().is_empty()
    }

    /// Returns the choice of the unit, where there is one.
    fn unit_ui(&mut self, ui: &mut Ui, cells: &Cells, commands: &mut Vec<Command>) -> Option<Response> {
        let cell = cells.unit?;
        let Some(mut unit) = self.typed_unit() else {
            self.fixed_unit_ui(ui, cell);
            return None;
        };
        let before = unit;
        let name = format!("Unit of {}", self.key.name);
        let mut inside = joined::choice_cell(ui, cell);
        let choice = typed_unit_choice_ui(&mut inside, (self.id, "unit"), &name, &mut unit, cell.width());
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

    /// The unit of length that holds; `None` where there is none, and for squares.
    fn length_unit(&self) -> Option<LengthUnit> {
        match self.typed_unit()? {
            TypedUnit::Length(unit) => Some(unit),
            TypedUnit::Squares => None,
        }
    }

    /// The unit of a field without a choice: no more than a word.
    fn fixed_unit_ui(&self, ui: &Ui, cell: Rect) {
        // Another unit stands behind the number.
        let is_another = self.reading.is_some_and(|reading| reading.unit != self.key.kind.default_unit());
        if is_another {
            return;
        }
        let at = cell.left_center() + vec2(joined::indent(cell), 0.0);
        let font = theme::regular(theme::BODY_SIZE);
        let color = theme::palette(ui).muted;
        ui.painter()
            .text(at, egui::Align2::LEFT_CENTER, self.key.unit_symbol(), font, color);
    }

    fn sigma_ui(&mut self, ui: &mut Ui, cell: Rect, commands: &mut Vec<Command>) {
        let id = self.sigma_id();
        let takes_enter = self.submits && ui.memory(|memory| memory.has_focus(id));
        if takes_enter && ui.input_mut(|input| Command::Calculate.take_keys(input, &[Scope::Field])) {
            commands.push(Command::Calculate);
        }
        joined::plus_minus_ui(ui, cell);
        // Not `Role::NumberInput`: the number keyboard of most phones has no "%".
        // Beside a number that was typed, an example would pass for a σ that was.
        let is_missing = self.note(Part::Value).is_some_and(|note| note.issue.is_missing());
        let example = if self.entry.text.trim().is_empty() && !is_missing {
            self.key.in_unit(self.key.sigma_example, self.length_unit())
        } else {
            NO_SIGMA.to_owned()
        };
        let output = joined::text_ui(ui, cell, &mut self.entry.sigma, (id, &example));
        let response = output
            .response
            .response
            .clone()
            .accessible_name(format!("Uncertainty of {}", self.key.name));
        ui.accesskit_node_builder(id, |node| {
            node.set_description(Hint::Sigma.to_string());
        });
        if response.double_clicked() {
            select_all(ui, id, output, &self.entry.sigma);
        }
        text_menu::ui(&response, &mut self.entry.sigma, commands);
        if response.lost_focus() {
            commands.push(Command::Settle);
        }
    }
}

/// What stands in an empty σ beside a value.
const NO_SIGMA: &str = "none";

fn select_all(ui: &Ui, id: Id, output: TextEditOutput, text: &str) {
    let mut state = output.state;
    let all = CCursorRange::two(CCursor::default(), CCursor::new(text.chars().count()));
    state.cursor.set_char_range(Some(all));
    state.store(ui.ctx(), id);
}
