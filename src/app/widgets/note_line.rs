//! The line below a field: its hint, or what is wrong with it. It has the same height in any case, so that nothing moves while
//! somebody types. What does not fit into it is shown on a card over what follows, while the field is used or pointed at.

use super::{symbols, text};
use crate::app::command::Command;
use crate::app::theme;
use depth_text::note::{Fix, Note, Part, Severity};
use egui::{
    Align, Area, Button, Color32, Galley, Id, Label, Layout, Order, Rect, Response, RichText, Sense, Shape, Stroke, Ui, UiBuilder, Vec2,
    vec2,
};
use std::sync::Arc;
use std::time::Duration;

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

/// What the card had in the last frame, while it is open.
#[derive(Clone, Copy)]
struct Open {
    /// The time at which it opened, s.
    since: f64,
    card: Rect,
    /// The focus is on a correction: on the card or in the line.
    fix_has_focus: bool,
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
                let said = self.label_ui(ui, "note", text_rect, Arc::clone(&words));
                // Whoever does not see it gets all of it.
                ui.accesskit_node_builder(said.id, |node| node.set_value(note.message()));
                said
            } else {
                self.unseen_ui(ui, line, note)
            };
            text::describe_by_note(ui, &said, note.severity, *about);
        }
        let mut fix_has_focus = false;
        if let Some((fix, _)) = &inline {
            let response = self.inline_fix_ui(ui, fix_rect, fix);
            fix_has_focus |= response.has_focus();
            if response.clicked() {
                commands.push(command(first, fix));
            }
        }
        let card = Card {
            texts: if is_cut || self.notes.len() > 1 {
                self.notes.iter().map(|(note, _)| *note).collect()
            } else {
                Vec::new()
            },
            fixes: if inline.is_some() { Vec::new() } else { self.fixes() },
            color: text::note_color(ui, first.severity),
            is_of_sigma: first.part == Part::Sigma,
            field: self.field,
            line: self.line,
        };
        if !card.is_empty() && ui.rect_contains_pointer(text_rect) && ui.input(|input| input.pointer.primary_clicked()) {
            // As a click on a label does on a page.
            ui.data_mut(|data| data.insert_temp(clicked_key(self.id), true));
            ui.ctx().request_repaint();
        }
        let is_open = !card.is_empty() && ui.clip_rect().contains(line.center()) && self.is_wanted(ui, text_rect, before);
        let now = is_open.then(|| {
            let mut open = card.ui(ui, self.key(), before, commands);
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
    fn label_ui(&self, ui: &mut Ui, what: &str, rect: Rect, words: Arc<Galley>) -> Response {
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

    fn inline_fix_ui(&self, ui: &mut Ui, rect: Rect, fix: &Fix) -> Response {
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
        ui.add(Button::new(name).frame(false).min_size(vec2(0.0, rect.height())))
    }
}

/// What is shown over what follows the line.
struct Card<'a> {
    /// What is said on it.
    texts: Vec<&'a Note>,
    fixes: Vec<(&'a Note, &'a Fix)>,
    /// The color of its border.
    color: Color32,
    /// Whether it is about the σ.
    is_of_sigma: bool,
    /// The field that it is about, and the line below that.
    field: Rect,
    line: Rect,
}

/// The measures of a card.
struct Measures {
    texts: Vec<Arc<Galley>>,
    texts_height: f32,
    /// The card.
    card: Rect,
}

impl Card<'_> {
    fn is_empty(&self) -> bool {
        self.texts.is_empty() && self.fixes.is_empty()
    }

    /// Draws the card.
    fn ui(&self, ui: &Ui, id: Id, before: Option<Open>, commands: &mut Vec<Command>) -> Open {
        let now = ui.input(|input| input.time);
        let since = before.map_or(now, |open| open.since);
        let measures = self.measures(ui);
        // Who clicks into a field while the card opens over it means the field.
        let remaining = since + theme::NOTE_CARD_DELAY - now;
        if remaining > 0.0 {
            ui.ctx().request_repaint_after(Duration::from_secs_f64(remaining));
        }
        let content = measures.card - theme::NOTE_CARD_MARGIN;
        // As large as the corrections: all around them the pointer meets what is below the card.
        let area = Area::new(id)
            .order(Order::Foreground)
            .fixed_pos(content.min + vec2(0.0, measures.texts_height))
            .constrain(false)
            .interactable(remaining <= 0.0 && !self.fixes.is_empty())
            .sense(Sense::hover())
            .fade_in(false)
            .accessibility_parent(ui.unique_id());
        let height = fix_height(ui);
        let fix_has_focus = area
            .show(ui.ctx(), |ui| {
                self.paint(ui, &measures);
                ui.spacing_mut().interact_size = Vec2::ZERO;
                ui.set_max_width(content.width() + theme::STEP);
                ui.horizontal_wrapped(|ui| self.fixes_ui(ui, height, commands)).inner
            })
            .inner;
        Open {
            since,
            card: measures.card,
            fix_has_focus,
        }
    }

    fn fixes_ui(&self, ui: &mut Ui, height: f32, commands: &mut Vec<Command>) -> bool {
        let mut has_focus = false;
        for (note, fix) in &self.fixes {
            let name = RichText::new(fix.label()).size(theme::SMALL_SIZE);
            let response = ui.add(Button::new(name).min_size(vec2(0.0, height)));
            has_focus |= response.has_focus();
            if response.clicked() {
                commands.push(command(note, fix));
            }
        }
        has_focus
    }

    /// Where everything is: below the line, or above the field where there is no room below.
    fn measures(&self, ui: &Ui) -> Measures {
        let line = self.line;
        let width = line.width() - theme::NOTE_CARD_MARGIN.sum().x;
        let color = theme::palette(ui).text;
        let font = || theme::regular(theme::SMALL_SIZE);
        let texts: Vec<Arc<Galley>> = self
            .texts
            .iter()
            .map(|note| ui.painter().layout(note.message(), font(), color, width))
            .collect();
        let gap = theme::NOTE_CARD_GAP;
        let texts_height: f32 = texts.iter().map(|text| text.size().y + gap).sum();
        let spacing = ui.spacing().item_spacing;
        let padding = 2.0 * ui.spacing().button_padding.x;
        let (mut rows, mut x, mut widest) = (0.0, f32::INFINITY, 0.0_f32);
        for (_, fix) in &self.fixes {
            let button = ui.painter().layout_no_wrap(fix.label(), font(), color).size().x.ceil() + padding;
            if x + button > width {
                rows += 1.0;
                x = 0.0;
            }
            widest = widest.max(x + button);
            x += button + spacing.x;
        }
        let fixes_height = if rows > 0.0 {
            rows * (fix_height(ui) + spacing.y) - spacing.y
        } else {
            -gap
        };
        let height = theme::NOTE_CARD_MARGIN.sum().y + texts_height + fixes_height;
        // Texts go from one side of the field to the other.
        let width = if texts.is_empty() { widest } else { width } + theme::NOTE_CARD_MARGIN.sum().x;
        let room = ui.clip_rect().intersect(ui.ctx().content_rect());
        let below = Rect::from_min_size(line.left_bottom(), vec2(width, height));
        let above = Rect::from_min_size(self.field.left_top() - vec2(0.0, height + theme::STEP), below.size());
        let card = if below.bottom() > room.bottom() && above.top() >= room.top() {
            above
        } else {
            below
        };
        Measures { texts, texts_height, card }
    }

    /// The corner of the card that points at the field.
    fn tail_ui(&self, ui: &Ui, card: Rect, border: Stroke) {
        let is_below = card.top() >= self.line.center().y;
        let (edge, up) = if is_below { (card.top(), -1.0) } else { (card.bottom(), 1.0) };
        // Below the number that is wrong, or its σ.
        let at = if self.is_of_sigma {
            card.right() - theme::NOTE_TAIL_INSET
        } else {
            self.field.left() + theme::NOTE_TAIL_AT * self.field.width()
        };
        let tip = egui::pos2(at, edge + up * theme::NOTE_TAIL);
        let feet = [-theme::NOTE_TAIL, theme::NOTE_TAIL].map(|x| egui::pos2(tip.x + x, edge - up * border.width));
        let surface = theme::palette(ui).surface;
        let [left, right] = feet;
        ui.painter()
            .add(Shape::convex_polygon(vec![left, tip, right], surface, Stroke::NONE));
        let raised = vec2(0.0, up * border.width / 2.0);
        ui.painter().line(vec![left + raised, tip, right + raised], border);
    }

    fn paint(&self, ui: &Ui, measures: &Measures) {
        let palette = theme::palette(ui);
        let shadow = ui.visuals().popup_shadow.as_shape(measures.card, theme::CONTROL_RADIUS);
        let border = Stroke::new(theme::STRONG_LINE, self.color);
        ui.painter().add(shadow);
        ui.painter().rect(
            measures.card,
            theme::CONTROL_RADIUS,
            palette.surface,
            border,
            egui::StrokeKind::Inside,
        );
        self.tail_ui(ui, measures.card, border);
        let mut at = (measures.card - theme::NOTE_CARD_MARGIN).min;
        for text in &measures.texts {
            ui.painter().galley(at, Arc::clone(text), palette.text);
            at.y += text.size().y + theme::NOTE_CARD_GAP;
        }
    }
}

/// What a click on the correction `fix` of `note` asks for.
fn command(note: &Note, fix: &Fix) -> Command {
    match fix.way {
        Some(way) => Command::AskForWidth(way, fix.entry.clone()),
        None => Command::Fix(note.key, fix.entry.clone()),
    }
}

/// Focuses the field `id` if its line was clicked in the last frame, before it is drawn. In that frame egui would have taken the focus
/// from it again: the click was outside of it.
pub fn follow_click(ui: &Ui, id: Id) {
    if ui.data_mut(|data| data.remove_temp::<bool>(clicked_key(id))).is_some() {
        ui.memory_mut(|memory| memory.request_focus(id));
    }
}

fn clicked_key(id: Id) -> Id {
    id.with("line was clicked")
}

fn is_for_fingers(ui: &Ui) -> bool {
    ui.spacing().interact_size.y >= theme::CONTROL_HEIGHT_TOUCH
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

/// The height of a correction on the card.
fn fix_height(ui: &Ui) -> f32 {
    if is_for_fingers(ui) {
        theme::CONTROL_HEIGHT_TOUCH
    } else {
        theme::NOTE_FIX_HEIGHT
    }
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
