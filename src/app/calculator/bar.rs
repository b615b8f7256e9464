//! The bar at the foot of a phone: it keeps the answer in sight, or says what is missing and goes there.

use super::strip::{badge_colors, colors};
use super::value::value_job;
use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::sentences::Hint;
use crate::app::theme;
use crate::app::widgets::{symbols, text};
use depth_text::field::Key;
use depth_text::report::strip::{Cell, Line, Part, Value};
use egui::text::{LayoutJob, TextFormat};
use egui::{Align, Galley, Label, Layout, Rect, Sense, Stroke, Ui, UiBuilder, vec2};
use std::fmt::Debug;
use std::hash::Hash;
use std::sync::Arc;

/// The contents of the bar that keeps the answer in sight on a phone: the answer, or what is missing and a button that goes there.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>) {
    let strip = cx.strip();
    let headline = cx.mode().headline();
    let numbers = strip.cells.iter().filter(|cell| matches!(cell.value, Value::Number { .. })).count();
    // Each line has its place, whatever else is in the bar.
    let (whole, _) = ui.allocate_exact_size(vec2(ui.available_width(), theme::BAR_HEIGHT), Sense::hover());
    if let Some((words, key)) = next_refused(&strip.cells, headline) {
        go_bar_ui(ui, cx, (&words, key, NextStep::Fix), whole);
        return;
    }
    if numbers == 0
        && let Some((title, key, count)) = next_missing(&strip.cells)
    {
        let title = title.to_owned();
        let words = Hint::StillNeeds { title, count }.to_string();
        go_bar_ui(ui, cx, (&words, key, NextStep::Enter), whole);
        return;
    }
    let main = strip
        .cells
        .get(headline)
        .filter(|cell| !matches!(cell.value, Value::Nothing | Value::NeedsBoth));
    let main = main.or_else(|| strip.cells.iter().find(|cell| matches!(cell.value, Value::Number { .. })));
    let Some(main) = main.or(strip.cells.first()) else { return };
    bar_answer_ui(ui, main, whole.with_max_x(whole.left() + theme::BAR_ANSWER_WIDTH));
    let others = strip
        .cells
        .iter()
        .filter(|cell| cell.title != main.title && matches!(cell.value, Value::Number { .. }));
    let right = whole.with_min_x(whole.left() + theme::BAR_ANSWER_WIDTH + 2.0 * theme::STEP);
    let rows: Vec<(&Cell, Rect)> = others.zip(lines(right, right.center().y)).collect();
    // Where one has no room for it, none has its σ: it would pass for exact beside the other.
    let has_room = rows.iter().all(|(cell, line)| bar_row(ui, cell, &cell.value, *line).fits(*line));
    for (index, (cell, line)) in rows.into_iter().enumerate() {
        let value = if has_room { cell.value.clone() } else { cell.value.without_sigma() };
        bar_row(ui, cell, &value, line).ui(ui, line, index);
    }
}

/// The upper and the lower line of `rect`, divided at `y`.
fn lines(rect: Rect, y: f32) -> [Rect; 2] {
    let (upper, lower) = rect.split_top_bottom_at_y(y);
    [upper, lower]
}

/// What is drawn in `line`, from its left edge.
fn line_ui(ui: &mut Ui, id: impl Hash + Debug, line: Rect) -> Ui {
    let layout = Layout::left_to_right(Align::Center);
    let mut ui = ui.new_child(UiBuilder::new().id_salt(id).max_rect(line).layout(layout));
    ui.spacing_mut().item_spacing.x = 2.0 * theme::STEP;
    ui.spacing_mut().interact_size.y = 0.0;
    ui
}

/// The field that is to be filled in next: that of the method which lacks the fewest.
fn next_missing(cells: &[Cell]) -> Option<(&str, Key, usize)> {
    let lacking = cells.iter().filter_map(|cell| match &cell.value {
        Value::Needs(keys) => Some((cell.title.as_str(), *keys.first()?, keys.len())),
        _ => None,
    });
    lacking.min_by_key(|(_, _, count)| *count)
}

/// The field that an answer is refused for, and what is said of it, where no answer is left, or that at `headline` is one of before.
fn next_refused(cells: &[Cell], headline: usize) -> Option<(String, Key)> {
    let is_of_before = matches!(cells.get(headline), Some(Cell { value: Value::Was(_), .. }));
    if !is_of_before && cells.iter().any(|cell| matches!(cell.value, Value::Number { .. })) {
        return None;
    }
    let refusals = cells.iter().flat_map(|cell| &cell.lines).filter(|line| line.is_refusal);
    let field = |line: &Line| {
        line.parts.iter().find_map(|part| match part {
            Part::Field(key, _) => Some(*key),
            Part::Text(_) => None,
        })
    };
    refusals.filter_map(|line| Some((line.text(), field(line)?))).next()
}

/// What a field is to be visited for.
#[derive(Clone, Copy)]
enum NextStep {
    /// What is in it is refused.
    Fix,
    /// Nothing is in it yet.
    Enter,
}

/// What keeps the answer away, the field that it is about, and a button that goes there.
fn go_bar_ui(ui: &mut Ui, cx: &mut AppContext<'_>, (words, key, step): (&str, Key, NextStep), whole: Rect) {
    let palette = theme::palette(ui);
    let (verb, color) = match step {
        NextStep::Fix => ("Fix", palette.red),
        NextStep::Enter => ("Enter", palette.blue),
    };
    let [upper, lower] = lines(whole, whole.top() + theme::BAR_TITLE_HEIGHT);
    let format = TextFormat::simple(theme::regular(theme::SMALL_SIZE), color);
    let said = line_ui(ui, "title", upper).label(symbols::job(palette, words, &format, false));
    symbols::say(ui, &said, words);
    let format = TextFormat::simple(theme::strong(theme::SENTENCE_SIZE), palette.text);
    let mut job = LayoutJob::default();
    job.append(key.label, 0.0, format.clone());
    if key.shows_symbol() {
        job.append(" ", 0.0, format.clone());
        symbols::append(&mut job, key.symbol, &format);
    }
    line_ui(ui, "value", lower).label(job);
    let end = Layout::right_to_left(Align::Center);
    ui.scope_builder(UiBuilder::new().id_salt("end").max_rect(whole).layout(end), |ui| {
        let format = TextFormat::simple(theme::strong(theme::BODY_SIZE), palette.on_blue);
        let mut job = LayoutJob::default();
        job.append(&format!("{verb} "), 0.0, format.clone());
        symbols::append(&mut job, if key.shows_symbol() { key.symbol } else { key.label }, &format);
        let button = egui::Button::new(job).fill(palette.blue).stroke(Stroke::NONE);
        let response = ui.add(button.min_size(vec2(theme::BAR_BUTTON_WIDTH, cx.layout.control_height())));
        if response.accessible_name(format!("{verb} {}", key.name)).clicked() {
            cx.commands.push(Command::GoTo(key));
        }
    });
}

/// The name and the number of the answer, one above the other.
fn bar_answer_ui(ui: &mut Ui, cell: &Cell, whole: Rect) {
    let palette = theme::palette(ui);
    let [upper, lower] = lines(whole, whole.top() + theme::BAR_TITLE_HEIGHT);
    let mut title = line_ui(ui, "title", upper);
    title.label(egui::RichText::new(&cell.title).size(theme::SMALL_SIZE).color(palette.muted));
    if let Some(badge) = cell.badge {
        let [front, back] = badge_colors(palette, badge);
        text::badge_ui(&mut title, badge.text, front, back);
    }
    let mut below = line_ui(ui, "value", lower);
    match &cell.value {
        value @ Value::Number { .. } => _ = below.label(value_job(palette, value, theme::BAR_RESULT_SIZE, lower.width())),
        other => {
            let color = cell.badge.map_or(palette.muted, |badge| badge_colors(palette, badge)[0]);
            let job = |size| symbols::job(palette, &other.text(), &TextFormat::simple(theme::strong(size), color), false);
            if let Some(words) = text::fitted(&below, theme::BODY_SIZE, lower.width(), job) {
                below.add(Label::new(words));
            }
        }
    }
}

/// One of the other answers: its name, and at the end of its line its number.
struct BarRow {
    name: Arc<Galley>,
    number: Arc<Galley>,
}

fn bar_row(ui: &Ui, cell: &Cell, value: &Value, line: Rect) -> BarRow {
    let palette = theme::palette(ui);
    let [_, color] = colors(palette, cell.tone);
    let name = LayoutJob::simple_singleline(cell.title.clone(), theme::regular(theme::SMALL_SIZE), color);
    BarRow {
        name: ui.painter().layout_job(name),
        number: ui.painter().layout_job(value_job(palette, value, theme::SMALL_SIZE, line.width())),
    }
}

impl BarRow {
    fn fits(&self, line: Rect) -> bool {
        self.name.size().x + theme::STEP + self.number.size().x <= line.width()
    }

    fn ui(self, ui: &mut Ui, line: Rect, index: usize) {
        let left = line.with_max_x(line.right() - self.number.size().x - theme::STEP);
        line_ui(ui, ("name", index), left).add(Label::new(self.name));
        let place = UiBuilder::new()
            .id_salt(("number", index))
            .max_rect(line)
            .layout(Layout::right_to_left(Align::Center));
        ui.new_child(place).label(self.number);
    }
}
