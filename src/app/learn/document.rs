//! The Learn text as blocks, drawn in the program's own fonts and with accessible roles. `build.rs` makes the blocks from
//! `assets/learn.md`.

use crate::app::theme;
use crate::app::widgets::table::{self, Cell};
use crate::app::widgets::text;
use egui::accesskit::Role;
use egui::text::{LayoutJob, TextFormat};
use egui::{Button, FontId, RichText, Stroke, Ui, UiBuilder, vec2};

/// The text.
pub const DOCUMENT: &[Block] = include!(concat!(env!("OUT_DIR"), "/learn.rs"));

/// A block element of Markdown.
#[derive(Debug)]
pub enum Block {
    /// The level, 1 for the title, and the words.
    Heading(usize, &'static str),
    Paragraph(&'static [Span]),
    /// `first` is the number of the first item, where items are numbered.
    List {
        first: Option<u64>,
        items: &'static [&'static [Self]],
    },
    Quote(&'static [Self]),
    /// One formula a line.
    Formula(&'static [&'static str]),
    Table {
        header: &'static [&'static [Span]],
        rows: &'static [&'static [&'static [Span]]],
    },
}

/// Text of one style and with one link target.
#[derive(Debug)]
pub struct Span {
    pub text: &'static str,
    pub style: Style,
    pub link: Option<&'static str>,
}

#[derive(Clone, Copy, Debug)]
pub struct Style {
    pub strong: bool,
    pub emphasis: bool,
    pub code: bool,
}

/// Draws `blocks`. Returns the target of a clicked link that stays within the program (`#…`); other links are opened by egui.
pub fn ui(ui: &mut Ui, blocks: &[Block], target_height: f32) -> Option<&'static str> {
    let mut followed = None;
    blocks_ui(ui, blocks, target_height, &mut followed);
    followed
}

fn plain(spans: &[Span]) -> String {
    spans.iter().map(|span| span.text).collect()
}

fn blocks_ui(ui: &mut Ui, blocks: &[Block], target_height: f32, followed: &mut Option<&'static str>) {
    let palette = theme::palette(ui);
    for (number, block) in blocks.iter().enumerate() {
        match block {
            Block::Heading(level, title) => {
                let [first, second, third] = theme::READING_HEADINGS;
                let (size, before) = match level {
                    1 => first,
                    2 => second,
                    _ => third,
                };
                if number > 0 {
                    ui.add_space(before);
                }
                let heading = text::heading_ui(ui, title, *level, theme::strong(size), palette.text);
                if *level == 1 {
                    // Whoever comes to the text hears where they are.
                    text::announce(ui, &heading);
                }
                ui.add_space(theme::STEP);
            }
            Block::Paragraph(spans) => {
                paragraph_ui(ui, spans, target_height, followed);
                ui.add_space(theme::READING_BLOCK_GAP);
            }
            Block::Quote(inside) => {
                quote_ui(ui, inside, target_height, followed);
                ui.add_space(theme::READING_BLOCK_GAP);
            }
            Block::Formula(lines) => {
                formula_ui(ui, lines);
                ui.add_space(theme::READING_BLOCK_GAP);
            }
            Block::List { first, items } => list_ui(ui, *first, items, target_height, followed),
            Block::Table { header, rows } => {
                table_ui(ui, header, rows);
                ui.add_space(theme::READING_BLOCK_GAP);
            }
        }
    }
}

fn quote_ui(ui: &mut Ui, inside: &[Block], target_height: f32, followed: &mut Option<&'static str>) {
    let palette = theme::palette(ui);
    let frame = egui::Frame::new().inner_margin(theme::QUOTE_MARGIN);
    let response = frame
        .fill(palette.highlight)
        .corner_radius(theme::CONTROL_RADIUS)
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            blocks_ui(ui, inside, target_height, followed);
        })
        .response;
    let bar = egui::Rect::from_min_size(response.rect.min, vec2(theme::QUOTE_BAR_WIDTH, response.rect.height()));
    ui.painter().rect_filled(bar, theme::QUOTE_BAR_RADIUS, palette.orange);
}

fn formula_ui(ui: &mut Ui, lines: &[&str]) {
    let palette = theme::palette(ui);
    egui::Frame::new()
        .fill(palette.highlight)
        .corner_radius(theme::CONTROL_RADIUS)
        .inner_margin(theme::FORMULA_MARGIN)
        .show(ui, |ui| {
            ui.set_width(ui.available_width());
            for line in lines {
                ui.label(
                    RichText::new(*line)
                        .font(theme::strong(theme::READING_FORMULA_SIZE))
                        .color(palette.text),
                );
            }
        });
}

fn list_ui(ui: &mut Ui, first: Option<u64>, items: &[&[Block]], target_height: f32, followed: &mut Option<&'static str>) {
    ui.scope_builder(UiBuilder::new().accessibility_role(Role::List), |ui| {
        for (item, number) in items.iter().zip(first.unwrap_or(0)..) {
            ui.scope_builder(UiBuilder::new().accessibility_role(Role::ListItem), |ui| {
                ui.horizontal_top(|ui| {
                    ui.spacing_mut().item_spacing.x = 0.0;
                    let mark = if first.is_some() { format!("{number}.") } else { "•".to_owned() };
                    ui.allocate_ui_with_layout(vec2(theme::LIST_INDENT, 0.0), egui::Layout::left_to_right(egui::Align::Min), |ui| {
                        ui.set_min_width(theme::LIST_INDENT);
                        ui.label(RichText::new(mark).size(theme::READING_SIZE));
                    });
                    ui.vertical(|ui| {
                        ui.set_width(ui.available_width());
                        blocks_ui(ui, item, target_height, followed);
                    });
                });
            });
        }
    });
}

fn paragraph_ui(ui: &mut Ui, spans: &[Span], target_height: f32, followed: &mut Option<&'static str>) {
    let palette = theme::palette(ui);
    if let [
        Span {
            text, link: Some(target), ..
        },
    ] = spans
    {
        // A paragraph that is a link only is drawn as a button.
        let button = Button::new(RichText::new(*text).color(palette.on_blue))
            .fill(palette.blue)
            .stroke(Stroke::NONE);
        if ui.add(button.min_size(vec2(0.0, target_height))).clicked() {
            follow(ui, target, followed);
        }
        return;
    }
    if spans.iter().all(|span| span.link.is_none()) {
        ui.label(job(ui, spans, theme::READING_SIZE));
        return;
    }
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        for span in spans {
            match &span.link {
                Some(target) => {
                    if ui.link(RichText::new(span.text).size(theme::READING_SIZE)).clicked() {
                        follow(ui, target, followed);
                    }
                }
                None => {
                    ui.label(job(ui, std::slice::from_ref(span), theme::READING_SIZE));
                }
            }
        }
    });
}

fn follow(ui: &Ui, target: &'static str, followed: &mut Option<&'static str>) {
    if target.starts_with('#') {
        *followed = Some(target);
    } else {
        ui.ctx().open_url(egui::OpenUrl::new_tab(target));
    }
}

fn job(ui: &Ui, spans: &[Span], size: f32) -> LayoutJob {
    let palette = theme::palette(ui);
    let mut job = LayoutJob::default();
    for span in spans {
        let font: FontId = if span.style.strong || span.style.code {
            theme::strong(size)
        } else {
            theme::regular(size)
        };
        let mut format = TextFormat::simple(font, palette.text);
        format.italics = span.style.emphasis;
        format.line_height = Some(size * 1.5);
        job.append(span.text, 0.0, format);
    }
    job
}

fn table_ui(ui: &mut Ui, header: &[&[Span]], rows: &[&[&[Span]]]) {
    let palette = theme::palette(ui);
    let shares: Vec<f32> = (0..header.len())
        .map(|column| {
            let lengths = std::iter::once(header).chain(rows.iter().copied());
            let longest = lengths.filter_map(|row| Some(plain(row.get(column)?).chars().count())).max();
            // Columns are as wide as their longest text, within limits.
            f32::from(u8::try_from(longest.unwrap_or(1).clamp(8, 44)).unwrap_or(u8::MAX))
        })
        .collect();
    table::table_ui(ui, &header.iter().map(|cell| plain(cell)).collect::<Vec<_>>().join(", "), |ui| {
        let headers = header.iter().map(|cell| Cell {
            text: LayoutJob::simple(plain(cell), theme::strong(theme::SMALL_SIZE), palette.muted, 0.0),
            role: Role::ColumnHeader,
            align_right: false,
        });
        table::row_ui(ui, headers.collect(), &shares);
        for cells in rows {
            let cells = cells.iter().enumerate().map(|(column, cell)| Cell {
                text: job(ui, cell, theme::BODY_SIZE),
                role: if column == 0 { Role::RowHeader } else { Role::Cell },
                align_right: false,
            });
            let cells = cells.collect();
            table::row_ui(ui, cells, &shares);
        }
    });
}
