//! The line below a field: its hint, or what is wrong with it. It has the same height in any case, so that nothing moves while
//! somebody types. What does not fit into it is shown on a card over what follows, while the field is used or pointed at.

use super::note_card::{self, Card, Open, command};
use super::{symbols, text};
use crate::app::command::Command;
use crate::app::theme;
use depth_text::note::{Fix, Note, Part, Severity};
use egui::{Align, Button, Color32, Galley, Id, Label, Layout, Rect, Response, RichText, Sense, Shape, Stroke, Ui, UiBuilder, Vec2, vec2};
use std::fmt::Debug;
use std::hash::Hash;
use std::sync::Arc;

/// The line below a field.
pub struct NoteLine<'a> {
    /// The id of the field.
    pub id: Id,
    /// What stands in it while there is no note; may be empty.
    pub hint: &'a str,
    /// What is to be said, each with the id of the text that it is about. The first stands in the line.
    pub notes: Vec<(&'a Note, Id)>,
    /// The line.
    pub line: Rect,
    /// Where the label and the texts of the field are.
    pub field: Rect,
    /// Whether one of its texts or its unit has the focus.
    pub is_in_use: bool,
}

impl NoteLine<'_> {
    /// Draws the line, and the card if it is open.
    pub fn ui(&self, ui: &mut Ui, commands: &mut Vec<Command>) {
        let line = self.line;
        match self.notes.first() {
            Some(&(note, _)) => self.notes_ui(ui, line, note, commands),
            None if self.hint.is_empty() => {}
            None => {
                let hint = one_line(ui, self.hint, theme::palette(ui).muted, line.width());
                let hint = self.label_ui(ui, "hint", line, hint);
                symbols::say(ui, &hint, self.hint);
            }
        }
        if self.notes.is_empty() {
            ui.data_mut(|data| data.remove::<Open>(self.key()));
        }
    }

    fn key(&self) -> Id {
        self.id.with("whole note")
    }

    fn notes_ui(&self, ui: &mut Ui, line: Rect, first: &Note, commands: &mut Vec<Command>) {
        let before: Option<Open> = ui.data(|data| data.get_temp(self.key()));
        let inline = inline_fix(ui, first, line);
        mark_ui(ui, line, first);
        let line = line.with_min_x(line.left() + theme::NOTE_MARK_WIDTH);
        let (text_rect, fix_rect) = line.split_left_right_at_x(line.right() - inline.as_ref().map_or(0.0, |(_, width)| *width));
        let words = one_line(ui, &first.headline(), text::note_color(ui, first.severity), text_rect.width());
        let is_cut = words.elided || first.headline() != first.message();
        for (index, (note, about)) in self.notes.iter().enumerate() {
            let said = if index == 0 {
                let asked = ui.data(|data| data.get_temp::<u32>(asked_key(self.id)));
                let said = self.label_ui(ui, ("note", asked), text_rect, Arc::clone(&words));
                // Whoever does not see it gets all of it.
                ui.accesskit_node_builder(said.id, |node| node.set_value(note.message()));
                said
            } else {
                self.unseen_ui(ui, line, note)
            };
            text::describe_by_note(ui, &said, note.severity, *about);
        }
        let fixes = self.fixes();
        let mut card = Card {
            texts: if is_cut || self.notes.len() > 1 {
                self.notes.iter().map(|(note, _)| *note).collect()
            } else {
                Vec::new()
            },
            fixes: if inline.is_some() { Vec::new() } else { fixes.clone() },
            color: text::note_color(ui, first.severity),
            is_of_sigma: first.part == Part::Sigma,
            field: self.field,
            line: self.line,
            sense: Sense::CLICK,
        };
        if !card.is_empty() && ui.rect_contains_pointer(text_rect) && ui.input(|input| input.pointer.primary_clicked()) {
            // As a click on a label does on a page.
            ui.data_mut(|data| data.insert_temp(clicked_key(self.id), true));
            ui.ctx().request_repaint();
        }
        let is_open = !card.is_empty() && ui.clip_rect().contains(line.center()) && self.is_wanted(ui, text_rect, before);
        let are_drawn = is_open || inline.is_some();
        card.sense = note_card::sense_of(ui, self.id, if are_drawn { &fixes } else { &[] });
        let mut fix_has_focus = false;
        if let Some((fix, _)) = &inline {
            let response = self.inline_fix_ui(ui, fix_rect, fix, card.sense);
            fix_has_focus |= response.has_focus();
            if response.clicked() {
                commands.push(command(first, fix));
            }
        }
        let now = is_open.then(|| {
            let mut open = card.ui(ui, self.key(), commands);
            open.fix_has_focus |= fix_has_focus;
            open
        });
        ui.data_mut(|data| match now {
            Some(open) => _ = data.insert_temp(self.key(), open),
            None => data.remove::<Open>(self.key()),
        });
    }

    /// Whether somebody wants to see all of it.
    fn is_wanted(&self, ui: &Ui, text: Rect, before: Option<Open>) -> bool {
        let pointer = ui.input(|input| input.pointer.hover_pos());
        let is_on_card = |open: Open| pointer.is_some_and(|pointer| open.card.expand(theme::STEP).contains(pointer));
        self.is_in_use || ui.rect_contains_pointer(text) || before.is_some_and(|open| open.fix_has_focus || is_on_card(open))
    }

    /// The corrections of all notes.
    fn fixes(&self) -> Vec<(&Note, &Fix)> {
        let notes = self.notes.iter();
        notes.flat_map(|(note, _)| note.fixes.iter().map(move |fix| (*note, fix))).collect()
    }

    /// A label in a scope with an id of its own: a hint and a note are different things to a screen reader.
    fn label_ui(&self, ui: &mut Ui, what: impl Hash + Debug, rect: Rect, words: Arc<Galley>) -> Response {
        let place = UiBuilder::new()
            .scope_id(self.id.with(what))
            .max_rect(rect)
            .layout(Layout::left_to_right(Align::Center));
        let label = Label::new(words).selectable(false).show_tooltip_when_elided(self.notes.is_empty());
        ui.new_child(place).add(label)
    }

    /// A note that the line has no room for, where only assistive technology finds it.
    fn unseen_ui(&self, ui: &mut Ui, line: Rect, note: &Note) -> Response {
        let words = one_line(ui, &note.message(), theme::palette(ui).text, line.width());
        let place = UiBuilder::new().scope_id(self.id.with("unseen note")).max_rect(line);
        let mut ui = ui.new_child(place);
        ui.set_clip_rect(Rect::NOTHING);
        ui.add(Label::new(words).selectable(false).show_tooltip_when_elided(false))
    }

    fn inline_fix_ui(&self, ui: &mut Ui, rect: Rect, fix: &Fix, sense: Sense) -> Response {
        let place = UiBuilder::new()
            .scope_id(self.id.with("correction"))
            .max_rect(rect)
            .layout(Layout::right_to_left(Align::Center));
        let mut ui = ui.new_child(place);
        ui.spacing_mut().button_padding = Vec2::ZERO;
        ui.spacing_mut().interact_size = Vec2::ZERO;
        let name = RichText::new(fix.label())
            .size(theme::SMALL_SIZE)
            .underline()
            .color(theme::palette(&ui).blue);
        ui.add(Button::new(name).frame(false).sense(sense).min_size(vec2(0.0, rect.height())))
    }
}

/// Focuses the field `id` if its line was clicked in the last frame, before it is drawn. In that frame egui would have taken the focus
/// from it again: the click was outside of it.
pub fn follow_click(ui: &Ui, id: Id) {
    if ui.data_mut(|data| data.remove_temp::<bool>(clicked_key(id))).is_some() {
        ui.memory_mut(|memory| memory.request_focus(id));
    }
}

/// Has the note of the field `id` said once more: to whoever listens it is a new one.
pub fn say_again(ctx: &egui::Context, id: Id) {
    ctx.data_mut(|data| *data.get_temp_mut_or_default::<u32>(asked_key(id)) += 1);
}

fn asked_key(id: Id) -> Id {
    id.with("was asked for again")
}

fn clicked_key(id: Id) -> Id {
    id.with("line was clicked")
}

/// The mark before a note: a disk for an error, a triangle for a warning, so that not the color alone tells them apart.
fn mark_ui(ui: &Ui, line: Rect, note: &Note) {
    let color = text::note_color(ui, note.severity);
    let center = line.left_center() + vec2(theme::NOTE_MARK_RADIUS, 0.0);
    let radius = theme::NOTE_MARK_RADIUS;
    match note.severity {
        Severity::Error => _ = ui.painter().circle_filled(center, radius, color),
        Severity::Warning => {
            let corners = [vec2(0.0, -radius), vec2(radius, radius * 0.8), vec2(-radius, radius * 0.8)];
            let triangle = corners.map(|corner| center + corner).to_vec();
            ui.painter().add(Shape::convex_polygon(triangle, color, Stroke::NONE));
        }
    }
    let font = theme::strong(theme::NOTE_MARK_SIZE);
    let at = center + vec2(0.0, if note.severity == Severity::Warning { 1.0 } else { 0.0 });
    ui.painter()
        .text(at, egui::Align2::CENTER_CENTER, "!", font, theme::palette(ui).surface);
}

/// The correction that stands in the line, and the width that it takes: the only one, where enough is left for the note.
fn inline_fix<'a>(ui: &Ui, note: &'a Note, line: Rect) -> Option<(&'a Fix, f32)> {
    let [fix] = note.fixes.as_slice() else { return None };
    let font = theme::regular(theme::SMALL_SIZE);
    let name = ui.painter().layout_no_wrap(fix.label(), font, Color32::PLACEHOLDER);
    let width = name.size().x.ceil() + theme::NOTE_FIX_GAP;
    (line.width() - width >= theme::NOTE_TEXT_MIN_WIDTH).then_some((fix, width))
}

/// `words` in a line at most `width` wide, which ends with "…" if they do not fit.
fn one_line(ui: &Ui, words: &str, color: Color32, width: f32) -> Arc<Galley> {
    let format = egui::text::TextFormat::simple(theme::regular(theme::SMALL_SIZE), color);
    let mut job = symbols::job(theme::palette(ui), words, &format, false);
    job.wrap = egui::text::TextWrapping::truncate_at_width(width);
    ui.painter().layout_job(job)
}
