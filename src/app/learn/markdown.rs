//! Markdown, taken apart once and drawn with the program's own type and roles.

use crate::app::theme;
use crate::app::widgets::table::{Cell, row, table};
use crate::app::widgets::text;
use egui::accesskit::Role;
use egui::text::{LayoutJob, TextFormat};
use egui::{Button, FontId, RichText, Stroke, Ui, UiBuilder, vec2};
use pulldown_cmark::{CodeBlockKind, Event, HeadingLevel, Options, Parser, Tag, TagEnd};

/// A text as a list of blocks.
#[derive(Debug, Default, PartialEq)]
pub struct Document {
    blocks: Vec<Block>,
}

#[derive(Debug, PartialEq)]
enum Block {
    Heading(usize, String),
    Paragraph(Vec<Span>),
    List { first: Option<u64>, items: Vec<Vec<Block>> },
    Quote(Vec<Block>),
    Formula(Vec<String>),
    Table { header: Vec<Vec<Span>>, rows: Vec<Vec<Vec<Span>>> },
}

#[derive(Clone, Debug, PartialEq)]
struct Span {
    text: String,
    style: Style,
    link: Option<String>,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Style {
    strong: bool,
    emphasis: bool,
    code: bool,
}

impl Document {
    /// Takes `markdown` apart. Anything that [`Block`] does not know is shown as the text it contains.
    pub fn parse(markdown: &str) -> Self {
        let mut events = Parser::new_ext(markdown, Options::ENABLE_TABLES);
        Self {
            blocks: blocks(&mut events),
        }
    }

    /// Draws the text. Returns the target of a link that was followed to within the program (`#…`); links to elsewhere are
    /// opened by egui.
    pub fn show(&self, ui: &mut Ui, target_height: f32) -> Option<String> {
        let mut followed = None;
        show_blocks(ui, &self.blocks, target_height, &mut followed);
        followed
    }
}

/// The blocks up to the end of the element that `events` is inside of.
fn blocks(events: &mut Parser<'_>) -> Vec<Block> {
    let mut blocks = Vec::new();
    // Text that stands in a list item without a paragraph of its own.
    let mut loose: Vec<Span> = Vec::new();
    let mut inline = Inline::default();
    while let Some(event) = events.next() {
        let is_block = matches!(
            event,
            Event::Start(Tag::Paragraph | Tag::Heading { .. } | Tag::List(_) | Tag::BlockQuote(_) | Tag::CodeBlock(_) | Tag::Table(_))
        );
        if is_block && !loose.is_empty() {
            blocks.push(Block::Paragraph(std::mem::take(&mut loose)));
        }
        match event {
            Event::Start(Tag::Paragraph) => blocks.push(Block::Paragraph(spans(events))),
            Event::Start(Tag::Heading { level, .. }) => {
                blocks.push(Block::Heading(level_number(level), plain(&spans(events))));
            }
            Event::Start(Tag::List(first)) => blocks.push(Block::List {
                first,
                items: items(events),
            }),
            Event::Start(Tag::BlockQuote(_)) => blocks.push(Block::Quote(self::blocks(events))),
            Event::Start(Tag::CodeBlock(CodeBlockKind::Fenced(_) | CodeBlockKind::Indented)) => {
                let text = plain(&spans(events));
                blocks.push(Block::Formula(text.lines().map(str::to_owned).collect()));
            }
            Event::Start(Tag::Table(_)) => blocks.push(table_block(events)),
            Event::End(
                TagEnd::Item | TagEnd::BlockQuote(_) | TagEnd::FootnoteDefinition | TagEnd::HtmlBlock | TagEnd::MetadataBlock(_),
            ) => break,
            other => inline.take(other, &mut loose),
        }
    }
    if !loose.is_empty() {
        blocks.push(Block::Paragraph(loose));
    }
    blocks
}

fn items(events: &mut Parser<'_>) -> Vec<Vec<Block>> {
    let mut items = Vec::new();
    while let Some(event) = events.next() {
        match event {
            Event::Start(Tag::Item) => items.push(blocks(events)),
            Event::End(TagEnd::List(_)) => break,
            _ => {}
        }
    }
    items
}

fn table_block(events: &mut Parser<'_>) -> Block {
    let mut header = Vec::new();
    let mut rows: Vec<Vec<Vec<Span>>> = Vec::new();
    while let Some(event) = events.next() {
        match event {
            Event::Start(Tag::TableRow) => rows.push(Vec::new()),
            Event::Start(Tag::TableCell) => {
                let cell = spans(events);
                match rows.last_mut() {
                    Some(row) => row.push(cell),
                    None => header.push(cell),
                }
            }
            Event::End(TagEnd::Table) => break,
            _ => {}
        }
    }
    Block::Table { header, rows }
}

/// The inline text up to the end of the block that `events` is inside of.
fn spans(events: &mut Parser<'_>) -> Vec<Span> {
    let mut spans = Vec::new();
    let mut inline = Inline::default();
    for event in events {
        match event {
            Event::End(TagEnd::Paragraph | TagEnd::Heading(_) | TagEnd::CodeBlock | TagEnd::TableCell) => break,
            other => inline.take(other, &mut spans),
        }
    }
    spans
}

/// What is open around the text being read.
#[derive(Default)]
struct Inline {
    style: Style,
    link: Option<String>,
}

impl Inline {
    fn take(&mut self, event: Event<'_>, spans: &mut Vec<Span>) {
        let mut push = |text: &str, style: Style| {
            spans.push(Span {
                text: text.to_owned(),
                style,
                link: self.link.clone(),
            });
        };
        match event {
            Event::Text(text) | Event::Html(text) | Event::InlineHtml(text) => push(&text, self.style),
            Event::Code(text) => push(&text, Style { code: true, ..self.style }),
            Event::SoftBreak | Event::HardBreak => push(" ", self.style),
            Event::Start(Tag::Strong) => self.style.strong = true,
            Event::End(TagEnd::Strong) => self.style.strong = false,
            Event::Start(Tag::Emphasis) => self.style.emphasis = true,
            Event::End(TagEnd::Emphasis) => self.style.emphasis = false,
            Event::Start(Tag::Link { dest_url, .. }) => self.link = Some(dest_url.to_string()),
            Event::End(TagEnd::Link) => self.link = None,
            _ => {}
        }
    }
}

fn plain(spans: &[Span]) -> String {
    spans.iter().map(|span| span.text.as_str()).collect()
}

const fn level_number(level: HeadingLevel) -> usize {
    match level {
        HeadingLevel::H1 => 1,
        HeadingLevel::H2 => 2,
        HeadingLevel::H3 => 3,
        HeadingLevel::H4 => 4,
        HeadingLevel::H5 => 5,
        HeadingLevel::H6 => 6,
    }
}

const READING_SIZE: f32 = 15.5;
const BETWEEN_BLOCKS: f32 = 10.0;

fn show_blocks(ui: &mut Ui, blocks: &[Block], target_height: f32, followed: &mut Option<String>) {
    let palette = theme::palette(ui);
    for (number, block) in blocks.iter().enumerate() {
        match block {
            Block::Heading(level, title) => {
                let (size, before) = match level {
                    1 => (26.0, 0.0),
                    2 => (20.0, 20.0),
                    _ => (16.5, 10.0),
                };
                if number > 0 {
                    ui.add_space(before);
                }
                text::heading(ui, title, *level, theme::strong(size), palette.text);
                ui.add_space(theme::STEP);
            }
            Block::Paragraph(spans) => {
                paragraph(ui, spans, target_height, followed);
                ui.add_space(BETWEEN_BLOCKS);
            }
            Block::Quote(inside) => {
                let frame = egui::Frame::new().inner_margin(egui::Margin {
                    left: 14,
                    right: 10,
                    top: 10,
                    bottom: 2,
                });
                let response = frame
                    .fill(palette.highlight)
                    .corner_radius(theme::CONTROL_RADIUS)
                    .show(ui, |ui| {
                        ui.set_width(ui.available_width());
                        show_blocks(ui, inside, target_height, followed);
                    })
                    .response;
                let bar = egui::Rect::from_min_size(response.rect.min, vec2(3.0, response.rect.height()));
                ui.painter().rect_filled(bar, 1.5, palette.orange);
                ui.add_space(BETWEEN_BLOCKS);
            }
            Block::Formula(lines) => {
                egui::Frame::new()
                    .fill(palette.highlight)
                    .corner_radius(theme::CONTROL_RADIUS)
                    .inner_margin(egui::Margin::symmetric(16, 12))
                    .show(ui, |ui| {
                        ui.set_width(ui.available_width());
                        for line in lines {
                            ui.label(RichText::new(line).font(theme::strong(16.0)).color(palette.text));
                        }
                    });
                ui.add_space(BETWEEN_BLOCKS);
            }
            Block::List { first, items } => list(ui, *first, items, target_height, followed),
            Block::Table { header, rows } => {
                show_table(ui, header, rows);
                ui.add_space(BETWEEN_BLOCKS);
            }
        }
    }
}

fn list(ui: &mut Ui, first: Option<u64>, items: &[Vec<Block>], target_height: f32, followed: &mut Option<String>) {
    const INDENT: f32 = 24.0;
    ui.scope_builder(UiBuilder::new().accessibility_role(Role::List), |ui| {
        for (item, number) in items.iter().zip(first.unwrap_or(0)..) {
            ui.scope_builder(UiBuilder::new().accessibility_role(Role::ListItem), |ui| {
                ui.horizontal_top(|ui| {
                    ui.spacing_mut().item_spacing.x = 0.0;
                    let mark = if first.is_some() { format!("{number}.") } else { "•".to_owned() };
                    ui.allocate_ui_with_layout(vec2(INDENT, 0.0), egui::Layout::left_to_right(egui::Align::Min), |ui| {
                        ui.set_min_width(INDENT);
                        ui.label(RichText::new(mark).size(READING_SIZE));
                    });
                    ui.vertical(|ui| {
                        ui.set_width(ui.available_width());
                        show_blocks(ui, item, target_height, followed);
                    });
                });
            });
        }
    });
}

fn paragraph(ui: &mut Ui, spans: &[Span], target_height: f32, followed: &mut Option<String>) {
    let palette = theme::palette(ui);
    if let [
        Span {
            text, link: Some(target), ..
        },
    ] = spans
    {
        // A paragraph that is nothing but a link asks to be pressed.
        let button = Button::new(RichText::new(text).color(palette.on_blue))
            .fill(palette.blue)
            .stroke(Stroke::NONE);
        if ui.add(button.min_size(vec2(0.0, target_height))).clicked() {
            follow(ui, target, followed);
        }
        return;
    }
    if spans.iter().all(|span| span.link.is_none()) {
        ui.label(job(ui, spans, READING_SIZE));
        return;
    }
    ui.horizontal_wrapped(|ui| {
        ui.spacing_mut().item_spacing.x = 0.0;
        for span in spans {
            match &span.link {
                Some(target) => {
                    if ui.link(RichText::new(&span.text).size(READING_SIZE)).clicked() {
                        follow(ui, target, followed);
                    }
                }
                None => {
                    ui.label(job(ui, std::slice::from_ref(span), READING_SIZE));
                }
            }
        }
    });
}

fn follow(ui: &Ui, target: &str, followed: &mut Option<String>) {
    if target.starts_with('#') {
        *followed = Some(target.to_owned());
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
        job.append(&span.text, 0.0, format);
    }
    job
}

fn show_table(ui: &mut Ui, header: &[Vec<Span>], rows: &[Vec<Vec<Span>>]) {
    let palette = theme::palette(ui);
    let shares: Vec<f32> = (0..header.len())
        .map(|column| {
            let lengths = std::iter::once(header).chain(rows.iter().map(Vec::as_slice));
            let longest = lengths.filter_map(|row| Some(plain(row.get(column)?).chars().count())).max();
            // A column gets room by what it holds, but neither all nor nothing.
            f32::from(u8::try_from(longest.unwrap_or(1).clamp(8, 44)).unwrap_or(u8::MAX))
        })
        .collect();
    table(ui, &header.iter().map(|cell| plain(cell)).collect::<Vec<_>>().join(", "), |ui| {
        let headers = header.iter().map(|cell| Cell {
            text: LayoutJob::simple(plain(cell), theme::strong(theme::SMALL_SIZE), palette.muted, 0.0),
            role: Role::ColumnHeader,
            align_right: false,
        });
        row(ui, headers.collect(), &shares);
        for cells in rows {
            let cells = cells.iter().enumerate().map(|(column, cell)| Cell {
                text: job(ui, cell, theme::BODY_SIZE),
                role: if column == 0 { Role::RowHeader } else { Role::Cell },
                align_right: false,
            });
            let cells = cells.collect();
            row(ui, cells, &shares);
        }
    });
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn blocks_keep_their_order_and_their_text() {
        let document = Document::parse(
            "# A\n\ntext **bold** `code`\n\n1. one\n   - deep\n2. two\n\n> quote\n\n```math\nD = f\n```\n\n| h | i |\n|---|---|\n| a | b |\n",
        );
        let kinds: Vec<&str> = document
            .blocks
            .iter()
            .map(|block| match block {
                Block::Heading(..) => "heading",
                Block::Paragraph(_) => "paragraph",
                Block::List { .. } => "list",
                Block::Quote(_) => "quote",
                Block::Formula(_) => "formula",
                Block::Table { .. } => "table",
            })
            .collect();
        assert_eq!(kinds, ["heading", "paragraph", "list", "quote", "formula", "table"]);
        assert!(matches!(document.blocks.get(2), Some(Block::List { first: Some(1), items }) if items.len() == 2));
        assert!(matches!(document.blocks.get(4), Some(Block::Formula(lines)) if lines == &["D = f"]));
    }

    #[test]
    fn a_link_alone_keeps_its_target() {
        let document = Document::parse("[Load it](#fx=700&b=100mm&d=50)");
        assert!(
            matches!(document.blocks.first(), Some(Block::Paragraph(spans)) if matches!(spans.as_slice(), [Span { link: Some(target), .. }] if target == "#fx=700&b=100mm&d=50"))
        );
    }
}
