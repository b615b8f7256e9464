//! The answer: a strip of three cells, as high whatever is known.

use super::value::{value_job, was_job};
use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::copyable::Copyable;
use crate::app::theme::{self, Palette};
use crate::app::widgets::unit_choice::length_unit_choice_ui;
use crate::app::widgets::{menu, symbols, text};
use depth_text::field::Key;
use depth_text::report::Tone;
use depth_text::report::strip::{Badge, Cell, Line, Part, Quality, Value};
use depth_text::sentences::lower;
use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Color32, Label, Layout, Rect, Response, Sense, Stroke, Ui, UiBuilder, accesskit::Role, pos2, vec2};
use std::fmt::Debug;
use std::hash::Hash;

/// Draws the strip. Distances are said aloud when they change, and when `asked`, how often *Calculate Distance* was pressed, does.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, asked: u32) {
    let strip = cx.strip();
    let width = ui.available_width();
    let is_row = width >= theme::STRIP_WIDTH;
    let height = if is_row {
        theme::STRIP_HEIGHT
    } else {
        3.0 * theme::STRIP_CELL_HEIGHT
    };
    let (whole, _) = ui.allocate_exact_size(vec2(width, height), Sense::hover());
    let palette = theme::palette(ui);
    let frame = theme::card(palette);
    ui.painter()
        .rect(whole, frame.corner_radius, frame.fill, frame.stroke, egui::StrokeKind::Inside);
    let rects = cells(whole, is_row);
    let line = Stroke::new(theme::THIN_LINE, palette.line);
    for rect in rects.iter().skip(1) {
        if is_row {
            ui.painter().vline(rect.left(), whole.shrink(theme::THIN_LINE).y_range(), line);
        } else {
            ui.painter().hline(whole.shrink(theme::THIN_LINE).x_range(), rect.top(), line);
        }
    }
    let mut lit = None;
    let last = strip.cells.len() - 1;
    let headline = cx.mode().headline();
    for (index, (cell, &rect)) in strip.cells.iter().zip(&rects).enumerate() {
        let builder = UiBuilder::new()
            .scope_id(egui::Id::unique(("answer", index)))
            .accessibility_role(Role::Region)
            .accessibility_label(cell.title.as_str())
            .max_rect(rect.shrink(f32::from(theme::CARD_PADDING)));
        let mut inside = ui.new_child(builder);
        let is_headline = headline == index;
        CellView { cell, is_headline, asked }.ui(&mut inside, cx, index == last, &mut lit);
    }
    symbols::light_up(ui.ctx(), lit);
}

/// The places of the cells. The last has the widest number.
fn cells(whole: Rect, is_row: bool) -> [Rect; 3] {
    if is_row {
        let (first, second) = (whole.left() + 0.3185 * whole.width(), whole.left() + 0.6365 * whole.width());
        let between = |left: f32, right: f32| Rect::from_min_max(pos2(left.round(), whole.top()), pos2(right.round(), whole.bottom()));
        return [between(whole.left(), first), between(first, second), between(second, whole.right())];
    }
    [0.0, 1.0, 2.0].map(|index| {
        let height = whole.height() / 3.0;
        Rect::from_min_size(pos2(whole.left(), whole.top() + index * height), vec2(whole.width(), height))
    })
}

/// The color of what belongs to `tone`: of its dot, and of its name.
pub const fn colors(palette: &Palette, tone: Tone) -> [Color32; 2] {
    match tone {
        Tone::Stereo => [palette.blue, palette.blue],
        Tone::Monocular => [palette.orange, palette.orange_text],
        Tone::Combined => [palette.text, palette.text],
        Tone::Neutral => [palette.stale, palette.text],
    }
}

/// The colors of a badge: of its text, and behind it.
pub const fn badge_colors(palette: &Palette, badge: Badge) -> [Color32; 2] {
    match badge.quality {
        Quality::Good => [palette.green, palette.green_tint],
        // Orange is monocular, so what is neither good nor bad is gray.
        Quality::Fair => [palette.text, palette.highlight],
        Quality::Bad => [palette.red, palette.red_tint],
    }
}

struct CellView<'a> {
    cell: &'a Cell,
    is_headline: bool,
    /// How often the distances were asked for.
    asked: u32,
}

/// A line inside a cell: its middle, from the upper edge of the cell's contents.
fn line_of(ui: &Ui, middle: f32, height: f32) -> Rect {
    let all = ui.max_rect();
    Rect::from_center_size(pos2(all.center().x, all.top() + middle), vec2(all.width(), height))
}

fn inside(ui: &mut Ui, id: impl Hash + Debug, rect: Rect) -> Ui {
    let layout = Layout::left_to_right(Align::Center);
    let mut ui = ui.new_child(UiBuilder::new().id_salt(id).max_rect(rect).layout(layout));
    ui.spacing_mut().item_spacing.x = 0.0;
    ui.set_clip_rect(ui.clip_rect().intersect(rect.expand(theme::STRIP_BLEED)));
    ui
}

impl CellView<'_> {
    fn ui(&self, ui: &mut Ui, cx: &mut AppContext<'_>, has_unit: bool, lit: &mut Option<Key>) {
        self.title_ui(ui, cx, has_unit);
        self.value_ui(ui, cx);
        for (index, (line, middle)) in self.cell.lines.iter().zip(theme::STRIP_LINES).enumerate() {
            let rect = line_of(ui, middle, theme::STRIP_LINE_HEIGHT);
            let mut row = inside(ui, if index == 0 { "first line" } else { "second line" }, rect);
            // What an example is made of is not there to be changed.
            let plain = Line {
                parts: vec![Part::Text(line.text())],
                is_refusal: line.is_refusal,
            };
            let is_example = matches!(self.cell.value, Value::Needs(_));
            let line = if is_example { &plain } else { line };
            let is_urgent = line.is_refusal || self.cell.badge.is_some_and(|badge| badge.quality == Quality::Bad);
            line_ui(&mut row, (line, is_urgent), cx, lit);
        }
    }

    fn title_ui(&self, ui: &mut Ui, cx: &mut AppContext<'_>, has_unit: bool) {
        let palette = theme::palette(ui);
        let [dot, name] = colors(palette, self.cell.tone);
        let line = line_of(ui, theme::STRIP_TITLE, theme::STRIP_UNIT_HEIGHT);
        ui.painter()
            .circle_filled(line.left_center() + vec2(theme::DOT_RADIUS, 0.0), theme::DOT_RADIUS, dot);
        let left = line.with_min_x(line.left() + theme::AFTER_DOT);
        let mut row = inside(ui, "title", left);
        let title = text::heading_ui(&mut row, &self.cell.title, 2, theme::strong(theme::STRIP_TITLE_SIZE), name);
        let mut taken = title.rect.right();
        if let Some(badge) = self.cell.badge {
            row.add_space(2.0 * theme::STEP);
            let [front, back] = badge_colors(palette, badge);
            taken = text::badge_ui(&mut row, badge.text, front, back).rect.right() + theme::STEP;
        }
        let rest = line.with_min_x(taken + theme::STEP);
        let layout = Layout::right_to_left(Align::Center);
        let mut end = ui.new_child(UiBuilder::new().id_salt("end").max_rect(rest).layout(layout));
        if has_unit && has_result_unit(cx) {
            unit_ui(&mut end, cx);
        } else {
            let format = TextFormat::simple(theme::regular(theme::SMALL_SIZE), palette.muted);
            let formula = ui.painter().layout_job(symbols::job(palette, &self.cell.formula, &format, false));
            // A part of a formula is none.
            if formula.size().x <= rest.width() {
                let formula = end.add(Label::new(formula));
                symbols::say(ui, &formula, &self.cell.formula);
            }
        }
    }

    fn value_ui(&self, ui: &mut Ui, cx: &mut AppContext<'_>) {
        let palette = theme::palette(ui);
        let size = if self.is_headline {
            theme::HEADLINE_SIZE
        } else {
            theme::RESULT_SIZE
        };
        let line = line_of(ui, theme::STRIP_VALUE, theme::STRIP_VALUE_HEIGHT);
        // Asked for again, a number is said again: to the page it is a new one.
        let asked = matches!(self.cell.value, Value::Number { .. }).then_some(self.asked);
        let mut row = inside(ui, ("value", asked), line);
        let response = match &self.cell.value {
            value @ Value::Number { .. } => {
                let job = value_job(palette, value, size, line.width());
                row.add(Label::new(job).selectable(false).sense(Sense::CLICK))
            }
            Value::Was(was) => row.add(Label::new(was_job(palette, was))),
            Value::Needs(keys) => needs_ui(&mut row, cx, keys),
            Value::Sentence(sentence) => {
                let color = self.cell.badge.map_or(palette.muted, |badge| badge_colors(palette, badge)[0]);
                let format = TextFormat::simple(theme::strong(theme::SENTENCE_SIZE), color);
                let said = row.add(Label::new(symbols::job(palette, sentence, &format, false)).truncate());
                symbols::say(ui, &said, sentence);
                said
            }
            quiet @ (Value::NeedsBoth | Value::Nothing) => {
                let format = TextFormat::simple(theme::regular(theme::SENTENCE_SIZE), palette.muted);
                let words = quiet.text();
                let is_nothing = matches!(quiet, Value::Nothing);
                let drawn = if is_nothing { NONE } else { words.as_str() };
                let response = row.add(Label::new(symbols::job(palette, drawn, &format, false)).truncate());
                if is_nothing {
                    symbols::say(ui, &response, NONE_IN_WORDS);
                }
                response
            }
        };
        // What was is no news, nor what is missing: the fields say that.
        if matches!(self.cell.value, Value::Number { .. } | Value::Sentence(_)) {
            text::announce(ui, &response);
        }
        // What is said aloud when it changes: "Stereo: 1.400 m", "Combined, agree: 1.400 m".
        let badge = self.cell.badge.map(|badge| format!(", {}", lower(badge.text))).unwrap_or_default();
        ui.accesskit_node_builder(response.id, |node| node.set_description(format!("{}{badge}", self.cell.title)));
        if let Value::Number { number, .. } = &self.cell.value {
            result_menu_ui(&response, number, &self.cell.value.text(), cx);
        }
    }
}

/// The menu of a result: to copy it.
fn result_menu_ui(response: &Response, number: &str, whole: &str, cx: &mut AppContext<'_>) {
    menu::context_ui(response, |items| {
        if items.item_ui("Copy value", true) {
            cx.commands.push(Command::Copy(Copyable::Value(number.to_owned())));
        }
        if items.item_ui("Copy with unit", true) {
            cx.commands.push(Command::Copy(Copyable::Value(whole.to_owned())));
        }
        if items.item_ui("Copy all", true) {
            cx.commands.push(Command::Copy(Copyable::Results));
        }
    });
}

/// "needs fx, b and d", each a link to its field.
fn needs_ui(ui: &mut Ui, cx: &mut AppContext<'_>, keys: &[Key]) -> Response {
    let palette = theme::palette(ui);
    let plain = TextFormat::simple(theme::regular(theme::SENTENCE_SIZE), palette.text);
    let word = |words: &str| {
        let mut job = LayoutJob::default();
        job.append(words, 0.0, plain.clone());
        job
    };
    let mut response = ui.label(word("needs "));
    // A long list is not read; what comes first is filled in first.
    let shown = if keys.len() > MOST_NEEDED { MOST_NEEDED - 1 } else { keys.len() };
    for (index, &key) in keys.iter().take(shown).enumerate() {
        if index > 0 {
            let between = if index + 1 == keys.len() { " and " } else { ", " };
            response |= ui.label(word(between));
        }
        if symbol_link_ui(ui, key).clicked() {
            cx.commands.push(Command::GoTo(key));
        }
    }
    if shown < keys.len() {
        response |= ui.label(word(&format!(" and {} more", keys.len() - shown)));
    }
    response
}

/// So many fields are named that are needed.
const MOST_NEEDED: usize = 4;

/// The symbol of `key` as a link to its field.
fn symbol_link_ui(ui: &mut Ui, key: Key) -> Response {
    let palette = theme::palette(ui);
    let format = TextFormat::simple(theme::regular(theme::SENTENCE_SIZE), palette.blue);
    let mut job = LayoutJob::default();
    symbols::append(&mut job, if key.symbol.is_empty() { key.label } else { key.symbol }, &format);
    let response = ui.add(Label::new(job).selectable(false).sense(Sense::click()));
    let line = Stroke::new(theme::THIN_LINE, palette.blue);
    ui.painter()
        .hline(response.rect.x_range(), response.rect.bottom() + theme::THIN_LINE, line);
    ui.accesskit_node_builder(response.id, |node| {
        node.set_role(Role::Link);
        node.set_label(format!("{}: go to the field", key.name));
        node.clear_value();
    });
    response.on_hover_cursor(egui::CursorIcon::PointingHand)
}

/// A small line of a cell. A number in it is in the color of its field, which it lights up under the pointer and goes to on a click.
fn line_ui(ui: &mut Ui, (line, is_urgent): (&Line, bool), cx: &mut AppContext<'_>, lit: &mut Option<Key>) {
    let palette = theme::palette(ui);
    let font = if line.is_refusal {
        theme::strong(theme::SMALL_SIZE)
    } else {
        theme::regular(theme::SMALL_SIZE)
    };
    let color = if line.is_refusal { palette.red } else { palette.muted };
    let format = TextFormat::simple(font, color);
    let whole = symbols::job(palette, &line.text(), &format, !line.is_refusal);
    let is_link = |part: &Part| matches!(part, Part::Field(..));
    let width = ui.painter().layout_job(whole.clone()).size().x;
    if !line.parts.iter().any(is_link) || width > ui.available_width() {
        // Too long to be taken apart: all of it is shown under the pointer.
        let said = ui.add(Label::new(whole).truncate());
        symbols::say(ui, &said, &line.text());
        return;
    }
    for part in &line.parts {
        match part {
            Part::Text(words) => _ = ui.label(symbols::job(palette, words, &format, true)),
            Part::Field(key, words) => {
                let own = symbols::color(palette, *key);
                let is_lit = symbols::lit(ui.ctx()) == Some(*key);
                let format = TextFormat {
                    background: if is_lit { palette.blue_tint } else { Color32::TRANSPARENT },
                    ..TextFormat::simple(format.font_id.clone(), if line.is_refusal { color } else { own })
                };
                let mut job = LayoutJob::default();
                if words == key.symbol {
                    symbols::append(&mut job, words, &format);
                } else {
                    job.append(words, 0.0, format);
                }
                let response = ui.add(Label::new(job).selectable(false).sense(Sense::CLICK));
                if words != key.symbol || is_urgent {
                    dotted(ui, response.rect, own);
                }
                if response.hovered() {
                    *lit = Some(*key);
                }
                if response.clicked() {
                    cx.commands.push(Command::GoTo(*key));
                }
                response.on_hover_cursor(egui::CursorIcon::PointingHand);
            }
        }
    }
}

/// A dotted line below a number that leads to its field.
fn dotted(ui: &Ui, rect: Rect, color: Color32) {
    let y = rect.bottom();
    let ends = [pos2(rect.left(), y), pos2(rect.right(), y)];
    ui.painter().extend(egui::Shape::dashed_line(
        &ends,
        Stroke::new(theme::THIN_LINE, color),
        theme::DOT_LINE,
        theme::DOT_LINE,
    ));
}

/// What stands where there is no number.
const NONE: &str = "–";
/// The same, said aloud.
const NONE_IN_WORDS: &str = "no distance yet";

/// Whether the answer is a length, so that its unit can be chosen.
fn has_result_unit(cx: &AppContext<'_>) -> bool {
    cx.session
        .inputs
        .unknown
        .is_none_or(|(_, field)| depth_text::field::Key::from(field).is_length())
}

/// The choice of the unit of all results.
fn unit_ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let mut chosen = cx.unit();
    ui.spacing_mut().interact_size.y = if cx.layout.is_narrow() {
        theme::ICON_BUTTON_TOUCH
    } else {
        theme::STRIP_UNIT_HEIGHT
    };
    ui.spacing_mut().button_padding = vec2(2.0 * theme::STEP, theme::LABEL_GAP);
    ui.spacing_mut().icon_width = theme::ARROW_WIDTH;
    ui.style_mut()
        .text_styles
        .insert(egui::TextStyle::Button, theme::regular(theme::SMALL_SIZE));
    length_unit_choice_ui(
        ui,
        "unit of the results",
        "Unit of the results",
        &mut chosen,
        theme::STRIP_UNIT_WIDTH,
    );
    if chosen != cx.unit() {
        cx.commands.push(Command::ShowResultsIn(chosen));
    }
}
