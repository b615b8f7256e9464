//! The rows of inputs and outputs, numbers below each other at their decimal points; and pairs of a name and a value.

use super::card::Card;
use crate::app::command::Command;
use crate::app::context::AppContext;
use crate::app::theme::{self, Palette};
use crate::app::widgets::table::{Cell, Placed, placed_row_ui, row_ui, table_ui};
use crate::app::widgets::{cards, symbols, text};
use depth_text::field::Key;
use depth_text::note::Part;
use depth_text::number;
use depth_text::report::{NONE, Row, Tone};
use depth_text::sentences::capital;
use egui::accesskit::Role;
use egui::text::{LayoutJob, TextFormat};
use egui::{Color32, FontId, Rect, Ui, UiBuilder, vec2};

/// The table "Key input parameters and outputs", in a card `height` high at least.
pub fn ui(ui: &mut Ui, cx: &mut AppContext<'_>, height: f32) {
    let rows = cx.table();
    let count = rows.len() + rows.iter().filter(|row| row.heading.is_some()).count();
    let lines = f32::from(u16::try_from(count + 1).unwrap_or(u16::MAX));
    let pitch = (cards::figure_height(height) / lines).clamp(theme::ROW_HEIGHT, theme::ROW_HEIGHT_MAX);
    let frame = cards::Frame {
        title: Card::Table.title(),
        caption: "",
        // As high as the card beside it, if the rows fit.
        height: (pitch * lines <= cards::figure_height(height)).then_some(height),
    };
    let place = ui.available_rect_before_wrap();
    frame.ui(ui, Card::Table, |ui| {
        let notes = cx.session.assessment().notes.iter().filter(|note| note.part == Part::Value);
        let view = View {
            wrong: notes.map(|note| (note.key, text::note_color(ui, note.severity))).collect(),
            palette: theme::palette(ui),
            is_narrow: ui.available_width() < theme::PAIR_WIDTH,
            columns: Columns::of(ui, &rows),
            pitch,
        };
        table_ui(ui, Card::Table.title(), |ui| {
            let columns = ["Parameter", "Value", "± 1 σ", "Unit", "Description"];
            view.titles_ui(ui, pitch, columns, [Role::ColumnHeader; 2]);
            for (row, next) in rows.iter().zip(rows.iter().skip(1).map(Some).chain([None])) {
                if let Some(heading) = row.heading {
                    let roles = [Role::RowHeader, Role::Cell];
                    view.titles_ui(ui, pitch - theme::LABEL_GAP, [heading, "", "", "", ""], roles);
                }
                view.row_ui(
                    ui,
                    row,
                    next.is_some_and(|next| next.heading.is_some() || next.tone == Tone::Combined),
                );
            }
        });
    });
    report_link_ui(ui, cx, place);
}

/// The link to the report, at the end of the heading of the card at `place`.
fn report_link_ui(ui: &mut Ui, cx: &mut AppContext<'_>, place: Rect) {
    let inset = f32::from(theme::CARD_PADDING) + theme::THIN_LINE;
    let line = Rect::from_min_size(place.min, vec2(place.width() - inset, theme::CARD_HEADING_HEIGHT));
    let layout = egui::Layout::right_to_left(egui::Align::Center);
    let builder = UiBuilder::new().id_salt("report").max_rect(line.translate(vec2(0.0, inset)));
    let mut end = ui.new_child(builder.layout(layout));
    let report = Command::SaveReport;
    // Beside the heading there is room for all of it, but on a phone.
    let name = match report.text().split_once(" (") {
        Some((short, _)) if place.width() < theme::PAIR_WIDTH + 2.0 * inset => short,
        _ => report.text(),
    };
    let link = text::quiet_link_ui(&mut end, name, theme::LINE_HEIGHT_TOUCH);
    if link.accessible_name(report.text()).clicked() {
        cx.commands.push(report);
    }
}

/// Where the columns are, from the left edge.
struct Columns {
    /// The decimal points of the values, and of their σ.
    points: [f32; 2],
    unit: f32,
    /// `None` where there is no room: they are tooltips then.
    description: Option<f32>,
}

impl Columns {
    /// The columns for `rows` in the width of `ui`.
    fn of(ui: &Ui, rows: &[Row]) -> Self {
        let width = ui.available_width();
        let widest = |texts: &mut dyn Iterator<Item = &str>| texts.map(|text| width_of(ui, text, true)).fold(0.0, f32::max);
        let numbers = || rows.iter().map(|row| row.value.as_str()).filter(|value| !is_unusable(value));
        // Room for what most numbers need, so that a longer one moves nothing; for a very long one the columns give way.
        let whole = widest(&mut numbers().map(|number| split(number).0)).max(theme::WHOLE_WIDTH);
        let part = widest(&mut numbers().map(|number| split(number).1)).max(theme::PART_WIDTH);
        let sigmas = || rows.iter().filter_map(|row| row.sigma.as_deref());
        let sigma_whole = widest(&mut sigmas().map(|sigma| split(sigma).0)).max(theme::SIGMA_WHOLE_WIDTH);
        let sigma_part = widest(&mut sigmas().map(|sigma| split(sigma).1)).max(theme::PART_WIDTH);
        let unit = theme::UNIT_COLUMN_WIDTH;
        let all = whole + part + sigma_whole + sigma_part + 2.0 * theme::NUMBER_GAP;
        let description = (width >= theme::DESCRIBED_TABLE_WIDTH).then_some(width - theme::DESCRIPTION_WIDTH);
        let end = description.unwrap_or(width);
        let before_description = if description.is_some() { theme::NUMBER_GAP / 2.0 } else { 0.0 };
        let left = end - unit - before_description - theme::NUMBER_GAP / 2.0 - all + theme::NUMBER_GAP;
        let value = left + whole;
        let sigma = value + part + theme::NUMBER_GAP + sigma_whole;
        Self {
            points: [value, sigma],
            unit: end - unit - before_description,
            description,
        }
    }
}

/// Whether it is no number: what was typed and cannot be used, in quotes.
fn is_unusable(value: &str) -> bool {
    value.starts_with('“')
}

/// A number before its decimal point, and from there on.
fn split(number: &str) -> (&str, &str) {
    let at = number.find(['.', ',']).unwrap_or_else(|| {
        // A whole number ends where its power of ten begins.
        number.find(" ×").unwrap_or(number.len())
    });
    number.split_at(at)
}

fn width_of(ui: &Ui, text: &str, is_strong: bool) -> f32 {
    let font = if is_strong {
        theme::strong(theme::TABLE_SIZE)
    } else {
        theme::regular(theme::TABLE_SIZE)
    };
    ui.painter().layout_no_wrap(text.to_owned(), font, Color32::PLACEHOLDER).size().x
}

/// A name where there is little room.
fn short(label: &str) -> String {
    let shorter = [
        ("(pixels)", "(px)"),
        ("object ", ""),
        ("Object distance", "Distance"),
        (" (OpenCV)", ""),
        ("in first photo", "in 1st photo"),
        ("in second photo", "in 2nd photo"),
    ];
    let label = shorter
        .into_iter()
        .fold(label.to_owned(), |label, (long, short)| label.replace(long, short));
    let label = label.replace(" (meters)", " (m)");
    match label.strip_prefix("Object ") {
        Some(rest) => capital(rest),
        None => label,
    }
}

struct View<'a> {
    is_narrow: bool,
    /// The inputs that something is wrong with, and the color of that.
    wrong: Vec<(Key, Color32)>,
    palette: &'a Palette,
    columns: Columns,
    pitch: f32,
}

impl View<'_> {
    /// Titles over what they are of: of columns, or of a part of the table, whose other cells are empty. A screen reader that goes down a
    /// column stops where there is no cell, and browsers know none over several columns that lies where it is painted.
    fn titles_ui(&self, ui: &mut Ui, height: f32, titles: [&str; 5], [first, others]: [Role; 2]) {
        let title = |text: &str, left: f32, role: Role| Placed {
            text: LayoutJob::simple_singleline(text.to_owned(), theme::strong(theme::SMALL_SIZE), self.palette.muted),
            role,
            left,
            tooltip: String::new(),
            said: None,
        };
        // Over the middle of the numbers.
        let over = |text: &str, [from, to]: [f32; 2]| {
            let cell = title(text, 0.0, others);
            let width = ui.painter().layout_job(cell.text.clone()).size().x;
            Placed {
                left: f32::midpoint(from, to) - width / 2.0,
                ..cell
            }
        };
        let [parameter, of_value, of_sigma, unit, description] = titles;
        let [value, sigma] = self.columns.points;
        let values = [value - theme::WHOLE_WIDTH, value + theme::PART_WIDTH];
        let sigmas = [sigma - theme::SIGMA_WHOLE_WIDTH, sigma + theme::PART_WIDTH];
        let mut cells = vec![
            title(parameter, 0.0, first),
            over(of_value, values),
            over(of_sigma, sigmas),
            title(unit, self.columns.unit, others),
        ];
        cells.extend(self.columns.description.map(|left| title(description, left, others)));
        placed_row_ui(ui, height, cells, self.palette.line);
    }

    /// A row, over a heavier line where a part of the table ends.
    fn row_ui(&self, ui: &mut Ui, row: &Row, ends_part: bool) {
        let palette = self.palette;
        let tooltip = if self.columns.description.is_none() {
            row.description.clone()
        } else {
            String::new()
        };
        let [value, sigma] = self.columns.points;
        let mut number = self.number(ui, &number::with_minus(&row.value), value, true);
        if let Some(color) = self.wrong.iter().find(|(key, _)| row.key == Some(*key)).map(|(_, color)| *color) {
            for section in &mut number.text.sections {
                section.format.color = color;
            }
        }
        let name = Placed {
            text: self.name(row, number.left - theme::NUMBER_GAP / 2.0),
            role: Role::RowHeader,
            left: 0.0,
            tooltip,
            said: Some(row.parameter.clone()),
        };
        let quiet = |text: &str, left: f32| Placed {
            text: symbols::job(
                palette,
                text,
                &TextFormat::simple(theme::regular(theme::TABLE_SIZE), palette.muted),
                false,
            ),
            role: Role::Cell,
            left,
            tooltip: row.unit.clone(),
            said: None,
        };
        // Empty cells too: else those behind them would be read out under the headers of others.
        let sigma = self.number(ui, row.sigma.as_deref().unwrap_or_default(), sigma, false);
        let mut cells = vec![name, number, sigma, quiet(&row.symbol, self.columns.unit)];
        if let Some(left) = self.columns.description {
            let mut cell = quiet(&row.description, left);
            cell.text.wrap = egui::text::TextWrapping::truncate_at_width(ui.available_width() - left);
            cell.tooltip = String::new();
            cells.push(cell);
        }
        placed_row_ui(ui, self.pitch, cells, if ends_part { palette.border } else { palette.line });
    }

    /// The name of a row, not longer than `room`.
    fn name(&self, row: &Row, room: f32) -> LayoutJob {
        let font = theme::regular(theme::TABLE_SIZE);
        let format = TextFormat::simple(font, self.palette.text);
        let label = if self.is_narrow { short(&row.label) } else { row.label.clone() };
        let mut job = symbols::job(self.palette, &label, &format, false);
        if let Some(key) = row.key.filter(|key| key.shows_symbol()) {
            job.append(" ", 0.0, format.clone());
            let colored = TextFormat {
                color: symbols::color(self.palette, key),
                ..format
            };
            symbols::append(&mut job, row.parameter_symbol, &colored);
        }
        // Numbers are never covered.
        job.wrap = egui::text::TextWrapping::truncate_at_width(room);
        job
    }

    /// A number with its decimal point at `point`.
    fn number(&self, ui: &Ui, text: &str, point: f32, is_strong: bool) -> Placed {
        let (font, color) = if is_strong {
            (theme::strong(theme::TABLE_SIZE), self.palette.text)
        } else {
            (theme::regular(theme::TABLE_SIZE), self.palette.muted)
        };
        let left = if is_unusable(text) {
            point - theme::WHOLE_WIDTH
        } else {
            point - width_of(ui, split(text).0, is_strong)
        };
        let mut job = LayoutJob::simple_singleline(text.to_owned(), font, color);
        if is_unusable(text) {
            job.wrap = egui::text::TextWrapping::truncate_at_width(self.columns.unit - left);
        }
        Placed {
            text: job,
            role: Role::Cell,
            left,
            tooltip: String::new(),
            said: (text == NONE).then(|| "none".to_owned()),
        }
    }
}

/// A table of names and values without a header, named `title`.
pub fn pairs_ui(ui: &mut Ui, title: &str, rows: &[(&str, String)]) {
    // A value stays in one line: nobody reads one whose unit is in the next.
    let full = ui.available_width();
    let widest = rows
        .iter()
        .map(|(_, value)| width_of(ui, value, true).ceil())
        .fold(0.0, f32::max)
        .min(full * 0.75);
    table_ui(ui, title, |ui| {
        for (name, value) in rows {
            let cells = vec![
                cell(ui, name, theme::regular(theme::TABLE_SIZE), Role::RowHeader),
                Cell {
                    align_right: true,
                    ..cell(ui, value, theme::strong(theme::TABLE_SIZE), Role::Cell)
                },
            ];
            row_ui(ui, cells, &[full - widest, widest]);
        }
    });
}

fn cell(ui: &Ui, text: &str, font: FontId, role: Role) -> Cell {
    Cell {
        text: LayoutJob::simple(text.to_owned(), font, theme::palette(ui).text, 0.0),
        role,
        align_right: false,
    }
}
